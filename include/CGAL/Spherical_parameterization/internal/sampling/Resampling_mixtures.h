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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_RESAMPLING_MIXTURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_RESAMPLING_MIXTURES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/sampling/Mixtures.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// What is interpolated at places in triangles: their corners with positive coordinates.
template <class Place>
Mixtures barycentric_mixtures(const std::vector<Linked_triangle>& triangles, const std::vector<Place>& places)
{
  return Mixtures(places.size(), [&](const auto& add) {
    for(std::size_t k = 0; k < places.size(); ++k)
      for(std::size_t i = 0; i < 3; ++i)
        if(const double weight = CGAL::to_double(places[k].coordinates[i]); weight > 0.)
          add(k, Mixture_term{triangles[places[k].triangle][i], weight});
  });
}

// The mixtures of n elements of which those of the sources are given: what each source hands out.
inline Mixtures reversed(const Mixtures& mixtures, std::size_t n)
{
  return Mixtures(n, [&](const auto& add) {
    for(std::uint32_t s = 0; s < mixtures.size(); ++s)
      for(const Mixture_term& term : mixtures.terms(s))
        add(term.source, Mixture_term{s, term.weight});
  });
}

// Whether all sources of a mixture are among those of another one, which has three at most.
inline bool are_sources_among(const Mixtures::Terms& terms, const Mixtures::Terms& others)
{
  return std::all_of(terms.begin(), terms.end(), [&](const Mixture_term& term) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Mixture_term& other) { return other.source == term.source; });
  });
}

// Areas over the largest one. None is 0, as what has no area would get nothing, and give nothing.
inline std::vector<double> relative_areas(std::vector<double> areas)
{
  constexpr double min_area = 0x1p-100;
  const double max = *std::max_element(areas.begin(), areas.end());
  for(double& area : areas)
    area = max > 0. ? (std::max)(area / max, min_area) : 1.;
  return areas;
}

// The adaptive barycentric mixtures of `n` vertices: what `interpolated` says, unless a source that it leaves out lies
// around the vertex by `handed_out`, the barycentric coordinates of the sources in the triangles of the target; then it is all
// that do. Weights are scaled so that each source gives away its area in all, to each target in proportion to its area.
inline Mixtures adaptive_mixtures(const Mixtures& interpolated, const Mixtures& handed_out,
                                  const std::vector<double>& source_areas, const std::vector<double>& target_areas)
{
  const std::size_t n = interpolated.size();
  const Mixtures gathered = reversed(handed_out, n);
  const auto for_each_term = [&](const auto& f) {
    for(std::size_t v = 0; v < n; ++v)
    {
      const bool is_interpolated = are_sources_among(gathered.terms(v), interpolated.terms(v));
      for(const Mixture_term& term : (is_interpolated ? interpolated : gathered).terms(v))
        f(v, Mixture_term{term.source, term.weight * target_areas[v]});
    }
  };
  std::vector<double> given(source_areas.size(), 0.);
  for_each_term([&](std::size_t, const Mixture_term& term) { given[term.source] += term.weight; });
  return Mixtures(n, [&](const auto& add) {
    for_each_term([&](std::size_t v, const Mixture_term& term) {
      add(v, Mixture_term{term.source, term.weight * (source_areas[term.source] / given[term.source])});
    });
  });
}

// Mixtures of the sources that a mask has, or of all if it is empty; of the one with the largest weight, if only that is
// wanted, which is the first one if several have it.
inline Mixtures selected(const Mixtures& mixtures, const std::vector<bool>& mask, bool is_only_largest)
{
  return Mixtures(mixtures.size(), [&](const auto& add) {
    for(std::size_t v = 0; v < mixtures.size(); ++v)
    {
      const Mixture_term* largest = nullptr;
      for(const Mixture_term& term : mixtures.terms(v))
        if(mask.empty() || mask[term.source])
        {
          if(!is_only_largest)
            add(v, term);
          else if(largest == nullptr || term.weight > largest->weight)
            largest = &term;
        }
      if(largest != nullptr)
        add(v, Mixture_term{largest->source, 1.});
    }
  });
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_RESAMPLING_MIXTURES_H
