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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_INTERPOLATION_WEIGHTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_INTERPOLATION_WEIGHTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Iterator_range.h>
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
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

struct Weighted_source
{
  std::uint32_t source;
  double weight; // positive
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

// Whether values of a type have a mean. Values of other types are labels.
template <class T>
constexpr bool has_mean =
    std::is_floating_point<T>::value || std::is_same<T, CGAL::IO::Color>::value || cartesian_dimension<T> != 0;
template <class T, std::size_t n>
constexpr bool has_mean<std::array<T, n>> = has_mean<T>;
template <class T>
constexpr bool has_mean<std::vector<T>> = has_mean<T>;

// The mean of the values that value(source) points to, over some terms; a null pointer represents zeros.
template <class T, class Value>
T mean_value(const Weighted_source* begin, const Weighted_source* end, const Value& value)
{
  const auto mean = [&](const auto& number_of) {
    double sum = 0., weight = 0.;
    for(const Weighted_source* term = begin; term != end; ++term)
    {
      if(const T* const x = value(term->source))
        sum += term->weight * number_of(*x);
      weight += term->weight;
    }
    return sum / weight;
  };
  if constexpr(std::is_floating_point<T>::value)
    return static_cast<T>(mean([](const T& x) { return static_cast<double>(x); }));
  else if constexpr(std::is_same<T, CGAL::IO::Color>::value)
  {
    const auto channel = [&](const auto& value_of) {
      return static_cast<unsigned char>(std::lround(mean([&](const T& x) { return double(value_of(x)); })));
    };
    return T(channel([](const T& x) { return x.red(); }), channel([](const T& x) { return x.green(); }),
             channel([](const T& x) { return x.blue(); }), channel([](const T& x) { return x.alpha(); }));
  }
  else if constexpr(cartesian_dimension<T> != 0)
  {
    using FT = typename Kernel_traits<T>::Kernel::FT;
    const auto coordinate = [&](int i) { return FT(mean([&](const T& x) { return CGAL::to_double(x[i]); })); };
    if constexpr(cartesian_dimension<T> == 2)
      return T(coordinate(0), coordinate(1));
    else
      return T(coordinate(0), coordinate(1), coordinate(2));
  }
  else // an array, or a vector, which gets the length of the longest one
  {
    using Component = typename T::value_type;
    T result{};
    if constexpr(std::is_same<T, std::vector<Component>>::value)
      for(const Weighted_source* term = begin; term != end; ++term)
        if(const T* const x = value(term->source))
          result.resize((std::max)(result.size(), x->size()));
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = mean_value<Component>(begin, end, [&](std::size_t source) -> const Component* {
        const T* const x = value(source);
        return x && i < x->size() ? &(*x)[i] : nullptr;
      });
    return result;
  }
}

// A term whose source has the label with the largest sum of weights; the first one in case of ties. Not a template, because
// sorting takes long to compile.
inline const Weighted_source* term_of_largest_label(
    const Weighted_source* begin, const Weighted_source* end,
    const std::function<bool(const Weighted_source*, const Weighted_source*)>& is_less)
{
  std::vector<const Weighted_source*> terms(static_cast<std::size_t>(end - begin));
  std::iota(terms.begin(), terms.end(), begin);
  std::stable_sort(terms.begin(), terms.end(), is_less);
  std::pair<double, const Weighted_source*> best = {-1., nullptr}; // the sum of weights of a label, and its first term
  for(auto term = terms.begin(); term != terms.end();)
  {
    std::pair<double, const Weighted_source*> sum = {0., *term};
    for(; term != terms.end() && !is_less(sum.second, *term); ++term)
      sum.first += (*term)->weight;
    if(sum.first > best.first || (sum.first == best.first && sum.second < best.second))
      best = sum;
  }
  return best.second;
}

// The mean of the values of some terms; for labels, the label with the largest sum of weights. Without terms, the
// value-initialized T.
template <class T>
T weighted_value(const Weighted_source* begin, const Weighted_source* end, const T* values)
{
  if(begin == end)
    return T();
  if(end - begin == 1)
    return values[begin->source];
  if constexpr(has_mean<T>)
    return mean_value<T>(begin, end, [&](std::size_t source) { return values + source; });
  else
    return values[term_of_largest_label(begin, end, [&](const Weighted_source* a, const Weighted_source* b) {
                    return std::less<T>()(values[a->source], values[b->source]);
                  })->source];
}

// The sources, with weights, from which the value of each target element is computed.
class Interpolation_weights
{
public:
  Interpolation_weights() = default; // no elements

  // for_each_term(add) calls add(target, term) for the terms of `n` target elements; each call must yield the same terms.
  template <class For_each_term>
  Interpolation_weights(std::size_t n, const For_each_term& for_each_term)
    : m_ends(n, 0)
  {
    for_each_term([&](std::size_t target, const Weighted_source&) { ++m_ends[target]; });
    std::size_t n_terms = 0;
    for(std::size_t& end : m_ends)
    {
      const std::size_t count = end;
      end = n_terms; // incremented when terms are added
      n_terms += count;
    }
    m_terms.resize(n_terms);
    for_each_term([&](std::size_t target, const Weighted_source& term) { m_terms[m_ends[target]++] = term; });
  }

  using Terms = Iterator_range<const Weighted_source*>;

  std::size_t size() const { return m_ends.size(); }
  Terms terms(std::size_t i) const
  {
    return {m_terms.data() + (i == 0 ? 0 : m_ends[i - 1]), m_terms.data() + m_ends[i]};
  }

  // Reads the values of the `n` source elements with value_of(i), and writes the values of all target elements with
  // write(i, value), sequentially. In between, values of trivially copyable types are mixed in parallel.
  template <class T, class Values, class Write>
  void mix(std::size_t n, const Values& value_of, const Write& write, const Execution& execution) const
  {
    constexpr std::size_t block_size = 4096;
    const std::unique_ptr<T[]> values(new T[n]), result(new T[m_ends.size()]); // std::vector<bool> stores bits
    for(std::size_t i = 0; i < n; ++i)
      values[i] = value_of(i);
    for_each_in_blocks(
        std::is_trivially_copyable<T>::value ? execution : Execution(), 0, m_ends.size(), block_size,
        [&](std::size_t i) { result[i] = weighted_value<T>(terms(i).begin(), terms(i).end(), values.get()); });
    for(std::size_t i = 0; i < m_ends.size(); ++i)
      write(i, result[i]);
  }

private:
  std::vector<std::size_t> m_ends;
  std::vector<Weighted_source> m_terms;
};

// The weights of n elements that are given by source: the transpose of what each source distributes.
inline Interpolation_weights reversed(const Interpolation_weights& weights, std::size_t n)
{
  return Interpolation_weights(n, [&](const auto& add) {
    for(std::uint32_t s = 0; s < weights.size(); ++s)
      for(const Weighted_source& term : weights.terms(s))
        add(term.source, Weighted_source{s, term.weight});
  });
}

// Whether all sources of `terms` are among those of `others`, which are at most three.
inline bool are_sources_among(const Interpolation_weights::Terms& terms, const Interpolation_weights::Terms& others)
{
  return std::all_of(terms.begin(), terms.end(), [&](const Weighted_source& term) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Weighted_source& other) { return other.source == term.source; });
  });
}

// Areas divided by the largest one, with a positive lower bound, because a vertex of area 0 would receive and contribute nothing.
inline std::vector<double> relative_areas(std::vector<double> areas)
{
  constexpr double min_area = 0x1p-100;
  const double max = *std::max_element(areas.begin(), areas.end());
  for(double& area : areas)
    area = max > 0. ? (std::max)(area / max, min_area) : 1.;
  return areas;
}

// The adaptive barycentric weights of `n` vertices: those of `interpolated`, unless `distributed`, the barycentric coordinates of
// the sources in the triangles of the target, assigns the vertex a source that is not interpolated there. Then all sources that
// `distributed` assigns to it are used. Weights are scaled so that each source distributes its area in total, to each target in
// proportion to its area.
inline Interpolation_weights adaptive_weights(const Interpolation_weights& interpolated,
                                              const Interpolation_weights& distributed,
                                              const std::vector<double>& source_areas,
                                              const std::vector<double>& target_areas)
{
  const std::size_t n = interpolated.size();
  const Interpolation_weights gathered = reversed(distributed, n);
  const auto for_each_term = [&](const auto& f) {
    for(std::size_t v = 0; v < n; ++v)
    {
      const bool is_interpolated = are_sources_among(gathered.terms(v), interpolated.terms(v));
      for(const Weighted_source& term : (is_interpolated ? interpolated : gathered).terms(v))
        f(v, Weighted_source{term.source, term.weight * target_areas[v]});
    }
  };
  std::vector<double> given(source_areas.size(), 0.);
  for_each_term([&](std::size_t, const Weighted_source& term) { given[term.source] += term.weight; });
  return Interpolation_weights(n, [&](const auto& add) {
    for_each_term([&](std::size_t v, const Weighted_source& term) {
      add(v, Weighted_source{term.source, term.weight * (source_areas[term.source] / given[term.source])});
    });
  });
}

// The weights restricted to the sources in a mask; to all sources if the mask is empty. If `is_only_largest` is set, only the
// source with the largest weight is kept, with weight 1; the first one in case of ties.
inline Interpolation_weights selected(const Interpolation_weights& weights, const std::vector<bool>& mask,
                                      bool is_only_largest)
{
  return Interpolation_weights(weights.size(), [&](const auto& add) {
    for(std::size_t v = 0; v < weights.size(); ++v)
    {
      const Weighted_source* largest = nullptr;
      for(const Weighted_source& term : weights.terms(v))
        if(mask.empty() || mask[term.source])
        {
          if(!is_only_largest)
            add(v, term);
          else if(largest == nullptr || term.weight > largest->weight)
            largest = &term;
        }
      if(largest != nullptr)
        add(v, Weighted_source{largest->source, 1.});
    }
  });
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_INTERPOLATION_WEIGHTS_H
