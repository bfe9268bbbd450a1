// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_MIXTURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_MIXTURES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/run/parallel.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Vector_2.h>
#include <CGAL/Vector_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The mean of values that have weights. Types without one are labels.
template <class T, class Enable = void>
struct Mean;

template <class T, class Enable = void>
constexpr bool has_mean = false;
template <class T>
constexpr bool has_mean<T, std::enable_if_t<(sizeof(Mean<T>) > 0)>> = true;

template <class T>
struct Mean<T, std::enable_if_t<std::is_floating_point<T>::value>>
{
  double sum = 0.;

  void add(double weight, const T& value) { sum += weight * static_cast<double>(value); }
  T over(double weight) const { return static_cast<T>(sum / weight); }
};

template <class T, std::size_t n>
struct Mean<std::array<T, n>, std::enable_if_t<has_mean<T>>>
{
  std::array<Mean<T>, n> components;

  void add(double weight, const std::array<T, n>& value)
  {
    for(std::size_t i = 0; i < n; ++i)
      components[i].add(weight, value[i]);
  }
  std::array<T, n> over(double weight) const
  {
    std::array<T, n> result;
    for(std::size_t i = 0; i < n; ++i)
      result[i] = components[i].over(weight);
    return result;
  }
};

template <class T>
struct Mean<std::vector<T>, std::enable_if_t<has_mean<T>>>
{
  std::vector<Mean<T>> components; // as many as the longest vector has

  void add(double weight, const std::vector<T>& value)
  {
    if(components.size() < value.size())
      components.resize(value.size());
    for(std::size_t i = 0; i < value.size(); ++i)
      components[i].add(weight, value[i]);
  }
  std::vector<T> over(double weight) const
  {
    std::vector<T> result;
    for(const Mean<T>& component : components)
      result.push_back(component.over(weight));
    return result;
  }
};

template <class T>
constexpr std::size_t cartesian_dimension = 0;
template <class K>
constexpr std::size_t cartesian_dimension<CGAL::Point_2<K>> = 2;
template <class K>
constexpr std::size_t cartesian_dimension<CGAL::Vector_2<K>> = 2;
template <class K>
constexpr std::size_t cartesian_dimension<CGAL::Point_3<K>> = 3;
template <class K>
constexpr std::size_t cartesian_dimension<CGAL::Vector_3<K>> = 3;

template <class T>
struct Mean<T, std::enable_if_t<(cartesian_dimension<T> > 0)>>
{
  std::array<double, cartesian_dimension<T>> sums = {};

  void add(double weight, const T& value)
  {
    for(std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += weight * CGAL::to_double(value[static_cast<int>(i)]);
  }
  T over(double weight) const
  {
    using FT = typename Kernel_traits<T>::Kernel::FT;
    if constexpr(cartesian_dimension<T> == 2)
      return T(FT(sums[0] / weight), FT(sums[1] / weight));
    else
      return T(FT(sums[0] / weight), FT(sums[1] / weight), FT(sums[2] / weight));
  }
};

template <>
struct Mean<CGAL::IO::Color>
{
  Mean<std::array<double, 4>> channels;

  void add(double weight, const CGAL::IO::Color& value)
  {
    channels.add(weight, {double(value.red()), double(value.green()), double(value.blue()), double(value.alpha())});
  }
  CGAL::IO::Color over(double weight) const
  {
    const std::array<double, 4> mean = channels.over(weight);
    const auto channel = [&](std::size_t i) { return static_cast<unsigned char>(std::lround(mean[i])); };
    return CGAL::IO::Color(channel(0), channel(1), channel(2), channel(3));
  }
};

struct Mixture_term
{
  std::uint32_t source;
  double weight; // positive
};

// The mean of the values of some terms; of labels, the one with the largest sum of weights, the first one if several have.
template <class T>
T mixed_value(const Mixture_term* begin, const Mixture_term* end, const T* values)
{
  if(end - begin == 1)
    return values[begin->source];
  if constexpr(has_mean<T>)
  {
    Mean<T> mean;
    double weight = 0.;
    for(const Mixture_term* term = begin; term != end; ++term)
    {
      mean.add(term->weight, values[term->source]);
      weight += term->weight;
    }
    return mean.over(weight);
  }
  else
  {
    const auto is_less = [&](const Mixture_term* a, const Mixture_term* b) {
      return std::less<T>()(values[a->source], values[b->source]);
    };
    std::vector<const Mixture_term*> terms;
    for(const Mixture_term* term = begin; term != end; ++term)
      terms.push_back(term);
    std::stable_sort(terms.begin(), terms.end(), is_less);
    const Mixture_term* best = nullptr;
    double best_weight = 0.;
    for(std::size_t i = 0; i < terms.size();)
    {
      const Mixture_term* const first = terms[i]; // with its label
      double weight = 0.;
      for(; i < terms.size() && !is_less(first, terms[i]); ++i)
        weight += terms[i]->weight;
      if(!best || weight > best_weight || (weight == best_weight && first < best))
      {
        best = first;
        best_weight = weight;
      }
    }
    return values[best->source];
  }
}

// From which elements of a source, and with which weights, each element of a target has its value.
class Mixtures
{
public:
  // for_each_term(add) calls add(target, term) for the terms of `n` elements, the same ones each time.
  template <class For_each_term>
  Mixtures(std::size_t n, const For_each_term& for_each_term)
    : m_ends(n, 0)
  {
    for_each_term([&](std::size_t target, const Mixture_term&) { ++m_ends[target]; });
    std::size_t n_terms = 0;
    for(std::size_t& end : m_ends)
    {
      const std::size_t count = end;
      end = n_terms; // which adding moves on
      n_terms += count;
    }
    m_terms.resize(n_terms);
    for_each_term([&](std::size_t target, const Mixture_term& term) { m_terms[m_ends[target]++] = term; });
  }

  // Reads the values of the `n` elements of the source with value_of(i), and writes those of all elements of the target
  // with write(i, value), one after the other. In between, values that share nothing are mixed in parallel.
  template <class T, class Values, class Write>
  void mix(std::size_t n, const Values& value_of, const Write& write, const Execution& execution) const
  {
    constexpr std::size_t block_size = 4096;
    const std::unique_ptr<T[]> values(new T[n]), result(new T[m_ends.size()]); // no vector: that of bool holds bits
    for(std::size_t i = 0; i < n; ++i)
      values[i] = value_of(i);
    for_each_block(std::is_trivially_copyable<T>::value ? execution : Execution(), 0, m_ends.size(), block_size,
                   [&](std::size_t begin, std::size_t end) {
                     for(std::size_t i = begin; i < end; ++i)
                       result[i] = mixed_value<T>(m_terms.data() + (i == 0 ? 0 : m_ends[i - 1]),
                                                  m_terms.data() + m_ends[i], values.get());
                   });
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      write(i, result[i]);
  }

private:
  std::vector<std::size_t> m_ends;
  std::vector<Mixture_term> m_terms;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_MIXTURES_H
