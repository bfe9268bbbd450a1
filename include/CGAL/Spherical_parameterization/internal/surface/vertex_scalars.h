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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_SCALARS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_SCALARS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A value for each vertex.
using Vertex_scalars = std::vector<double>;

// The sum of the products, in four sums, because a single one would wait for each addition.
inline double sum_of_products(const Vertex_scalars& a, const Vertex_scalars& b)
{
  using Sums = Lanes<Four_lanes>;
  double result = 0.;
  run_in_lanes<Sums::width>([&](auto) {
    Four_lanes sums = 0.;
    std::size_t v = 0;
    for(; v + Sums::width <= a.size(); v += Sums::width)
      sums += Sums::load(&a[v]) * Sums::load(&b[v]);
    result = sum_of_lanes(sums);
    for(; v < a.size(); ++v)
      result += a[v] * b[v];
  });
  return result;
}

// Adds a multiple of y to x.
inline void add_multiple(double factor, const Vertex_scalars& y, Vertex_scalars& x)
{
  using Numbers = Lanes<Four_lanes>;
  run_in_lanes<Numbers::width>([&](auto) {
    std::size_t v = 0;
    for(; v + Numbers::width <= x.size(); v += Numbers::width)
      Numbers::store(Numbers::load(&x[v]) + factor * Numbers::load(&y[v]), &x[v]);
    for(; v < x.size(); ++v)
      x[v] += factor * y[v];
  });
}

// Marks the vertices of a surface that are ignored; empty if there are none.
using Mask = std::vector<char>;

// The areas, set to 0 at the ignored vertices.
inline Vertex_scalars areas_outside(const Mask& mask, Vertex_scalars areas)
{
  for(std::size_t v = 0; v < mask.size(); ++v)
    if(mask[v])
      areas[v] = 0.;
  return areas;
}

// The ranks of values on a surface, from -1 to 1, which are robust to outliers and independent of scale: vertices are
// weighted by their areas. Equal values get the same rank, their mean rank.
inline Vertex_scalars ranks_by_area(const Vertex_scalars& values, const Vertex_scalars& areas)
{
  const std::size_t n = values.size();
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), std::uint32_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) { return values[v] < values[w]; });
  const double total = std::accumulate(areas.begin(), areas.end(), 0.);
  Vertex_scalars ranks(n, 0.);
  if(!(total > 0.))
    return ranks;
  double below = 0.;
  for(std::size_t i = 0, j; i < n; i = j)
  {
    double area = 0.;
    for(j = i; j < n && values[order[j]] == values[order[i]]; ++j)
      area += areas[order[j]];
    for(std::size_t k = i; k < j; ++k)
      ranks[order[k]] = (2. * below + area) / total - 1.;
    below += area;
  }
  return ranks;
}

// Subtracts the common mean from the values of a feature of two surfaces, and scales them to the variance of ranks.
inline void standardize(std::array<Vertex_scalars*, 2> values, const std::array<Vertex_scalars, 2>& areas)
{
  // Both surfaces have the same weight. The values are divided by the largest one, so that no square overflows; values
  // at ignored vertices do not count.
  double largest = 0., mean = 0., variance = 0.;
  for(std::size_t k = 0; k < 2; ++k)
    for(std::size_t v = 0; v < areas[k].size(); ++v)
      if(areas[k][v] > 0.)
        largest = (std::max)(largest, std::abs((*values[k])[v]));
  const auto mean_of = [&](const auto& f) {
    double result = 0.;
    for(std::size_t k = 0; k < 2; ++k)
    {
      double sum = 0., area = 0.;
      for(std::size_t v = 0; v < areas[k].size(); ++v)
      {
        if(areas[k][v] > 0.)
          sum += areas[k][v] * f((*values[k])[v] / largest);
        area += areas[k][v];
      }
      result += area > 0. ? 0.5 * sum / area : 0.;
    }
    return result;
  };
  if(largest > 0.)
  {
    mean = mean_of([](double x) { return x; });
    variance = mean_of([&](double x) { return (x - mean) * (x - mean); });
  }
  constexpr double least = 1e-24; // the effect of rounding on a constant is identical on all machines
  const double scale = variance > least ? 1. / std::sqrt(3. * variance) : 0.; // the variance of ranks is a third
  for(Vertex_scalars* channel : values)
    for(double& x : *channel)
      x = scale > 0. ? scale * (x / largest - mean) : 0.;
}

// Extends values to the ignored vertices: front by front, each gets the mean of its neighbors with known values. So
// these vertices neither attract nor repel images nearby.
inline void continue_over(const Mask& mask, const Vertex_rings& rings, Vertex_scalars& values)
{
  if(mask.empty())
    return;
  std::vector<char> is_known(mask.size());
  std::vector<std::uint32_t> front;
  const auto is_at_front = [&](std::uint32_t v) {
    const auto ring = rings.ring(v);
    return !is_known[v] && std::any_of(ring.begin(), ring.end(), [&](std::uint32_t w) { return is_known[w] != 0; });
  };
  for(std::uint32_t v = 0; v < mask.size(); ++v)
    is_known[v] = !mask[v];
  for(std::uint32_t v = 0; v < mask.size(); ++v)
    if(is_at_front(v))
      front.push_back(v);
  while(!front.empty())
  {
    std::vector<std::uint32_t> next;
    for(const std::uint32_t v : front)
    {
      double sum = 0.;
      std::size_t n = 0;
      for(const std::uint32_t w : rings.ring(v))
        if(is_known[w])
        {
          sum += values[w];
          ++n;
        }
      values[v] = sum / static_cast<double>(n);
    }
    for(const std::uint32_t v : front)
      is_known[v] = 1;
    for(const std::uint32_t v : front)
      for(const std::uint32_t w : rings.ring(v))
        if(!is_known[w])
          next.push_back(w);
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    front.swap(next);
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_SCALARS_H
