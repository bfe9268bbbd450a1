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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_MIXED_VALUE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_MIXED_VALUE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/IO/Color.h>
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
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A value that a mixture takes from an element of the source, by its number.
struct Mixture_term
{
  std::uint32_t source;
  double weight; // positive
};

// How values of a type are averaged: as sums of their components. Those of other types are labels, which are not.
template <class T, class Enable = void>
struct Value_components
{
  static constexpr bool exist = false;
};

template <class T>
struct Value_components<T, std::enable_if_t<std::is_floating_point<T>::value>>
{
  static constexpr bool exist = true;
  using Sum = double;
  static void add(double weight, const T& value, Sum& sum) { sum += weight * static_cast<double>(value); }
  static T mean(const Sum& sum, double weight) { return static_cast<T>(sum / weight); }
};

template <class T, class Kernel, std::size_t dimension>
struct Cartesian_components
{
  static constexpr bool exist = true;
  using Sum = std::array<double, dimension>;
  static void add(double weight, const T& value, Sum& sum)
  {
    for(std::size_t i = 0; i < dimension; ++i)
      sum[i] += weight * CGAL::to_double(value[static_cast<int>(i)]);
  }
  static T mean(const Sum& sum, double weight)
  {
    using FT = typename Kernel::FT;
    if constexpr(dimension == 2)
      return T(FT(sum[0] / weight), FT(sum[1] / weight));
    else
      return T(FT(sum[0] / weight), FT(sum[1] / weight), FT(sum[2] / weight));
  }
};
template <class K>
struct Value_components<CGAL::Point_2<K>> : Cartesian_components<CGAL::Point_2<K>, K, 2>
{};
template <class K>
struct Value_components<CGAL::Vector_2<K>> : Cartesian_components<CGAL::Vector_2<K>, K, 2>
{};
template <class K>
struct Value_components<CGAL::Point_3<K>> : Cartesian_components<CGAL::Point_3<K>, K, 3>
{};
template <class K>
struct Value_components<CGAL::Vector_3<K>> : Cartesian_components<CGAL::Vector_3<K>, K, 3>
{};

template <>
struct Value_components<CGAL::IO::Color>
{
  static constexpr bool exist = true;
  using Sum = std::array<double, 4>;
  static void add(double weight, const CGAL::IO::Color& value, Sum& sum)
  {
    const std::array<unsigned char, 4> channels = {value.red(), value.green(), value.blue(), value.alpha()};
    for(std::size_t i = 0; i < 4; ++i)
      sum[i] += weight * channels[i];
  }
  static CGAL::IO::Color mean(const Sum& sum, double weight)
  {
    const auto channel = [&](std::size_t i) { return static_cast<unsigned char>(std::lround(sum[i] / weight)); };
    return CGAL::IO::Color(channel(0), channel(1), channel(2), channel(3));
  }
};

template <class T, std::size_t n>
struct Value_components<std::array<T, n>, std::enable_if_t<Value_components<T>::exist>>
{
  static constexpr bool exist = true;
  using Sum = std::array<typename Value_components<T>::Sum, n>;
  static void add(double weight, const std::array<T, n>& value, Sum& sum)
  {
    for(std::size_t i = 0; i < n; ++i)
      Value_components<T>::add(weight, value[i], sum[i]);
  }
  static std::array<T, n> mean(const Sum& sum, double weight)
  {
    std::array<T, n> result;
    for(std::size_t i = 0; i < n; ++i)
      result[i] = Value_components<T>::mean(sum[i], weight);
    return result;
  }
};

template <class T>
struct Value_components<std::vector<T>, std::enable_if_t<Value_components<T>::exist>>
{
  static constexpr bool exist = true;
  using Sum = std::vector<typename Value_components<T>::Sum>;
  static void add(double weight, const std::vector<T>& value, Sum& sum)
  {
    if(sum.size() < value.size())
      sum.resize(value.size());
    for(std::size_t i = 0; i < value.size(); ++i)
      Value_components<T>::add(weight, value[i], sum[i]);
  }
  static std::vector<T> mean(const Sum& sum, double weight)
  {
    std::vector<T> result;
    for(const auto& component : sum)
      result.push_back(Value_components<T>::mean(component, weight));
    return result;
  }
};

// Returns the weighted mean of the values of one term or more; of labels, the one with the largest sum of weights, the
// first of several. What comes from one term only is the same to the bit.
template <class T>
T mixed_value(const Mixture_term* begin, const Mixture_term* end, const T* values)
{
  if(end - begin == 1)
    return values[begin->source];
  if constexpr(Value_components<T>::exist)
  {
    typename Value_components<T>::Sum sum{};
    double weight = 0.;
    for(const Mixture_term* term = begin; term != end; ++term)
    {
      Value_components<T>::add(term->weight, values[term->source], sum);
      weight += term->weight;
    }
    return Value_components<T>::mean(sum, weight);
  }
  else
  {
    std::vector<Mixture_term> labels; // each with its first place and the sum of its weights
    for(const Mixture_term* term = begin; term != end; ++term)
    {
      const auto same = std::find_if(labels.begin(), labels.end(), [&](const Mixture_term& label) {
        return values[label.source] == values[term->source];
      });
      if(same == labels.end())
        labels.push_back(*term);
      else
        same->weight += term->weight;
    }
    const auto best = std::max_element(
        labels.begin(), labels.end(), [](const Mixture_term& a, const Mixture_term& b) { return a.weight < b.weight; });
    return values[best->source];
  }
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_MIXED_VALUE_H
