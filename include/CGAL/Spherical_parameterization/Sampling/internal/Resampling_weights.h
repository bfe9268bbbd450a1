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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_RESAMPLING_WEIGHTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_RESAMPLING_WEIGHTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Sampling/internal/Interpolation_weights.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The weights of n elements of which those of the sources are given: what each source hands out.
inline Interpolation_weights reversed(const Interpolation_weights& weights, std::size_t n)
{
  return Interpolation_weights(n, [&](const auto& add) {
    for(std::uint32_t s = 0; s < weights.size(); ++s)
      for(const Weighted_source& term : weights.terms(s))
        add(term.source, Weighted_source{s, term.weight});
  });
}

// Whether all sources of a mixture are among those of another one, which has three at most.
inline bool are_sources_among(const Interpolation_weights::Terms& terms, const Interpolation_weights::Terms& others)
{
  return std::all_of(terms.begin(), terms.end(), [&](const Weighted_source& term) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Weighted_source& other) { return other.source == term.source; });
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

// The adaptive barycentric weights of `n` vertices: what `interpolated` says, unless a source that it leaves out lies
// around the vertex by `handed_out`, the barycentric coordinates of the sources in the triangles of the target; then it is all
// that do. Weights are scaled so that each source gives away its area in all, to each target in proportion to its area.
inline Interpolation_weights adaptive_weights(const Interpolation_weights& interpolated,
                                              const Interpolation_weights& handed_out,
                                              const std::vector<double>& source_areas,
                                              const std::vector<double>& target_areas)
{
  const std::size_t n = interpolated.size();
  const Interpolation_weights gathered = reversed(handed_out, n);
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

// Interpolation_weights of the sources that a mask has, or of all if it is empty; of the one with the largest weight, if only that is
// wanted, which is the first one if several have it.
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_RESAMPLING_WEIGHTS_H
