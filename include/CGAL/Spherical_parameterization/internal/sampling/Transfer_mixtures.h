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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_TRANSFER_MIXTURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_TRANSFER_MIXTURES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/sampling/mixed_value.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

constexpr std::size_t transfer_block_size = 4096;

// From which elements of a source, and with which weights, each element of a target has its value.
class Mixtures
{
public:
  // `counts` are the numbers of terms of the elements.
  explicit Mixtures(const std::vector<std::uint32_t>& counts)
    : m_ends(counts.size())
  {
    std::size_t n = 0;
    for(std::size_t i = 0; i < counts.size(); ++i)
    {
      m_ends[i] = n; // which add() moves on
      n += counts[i];
    }
    m_terms.resize(n);
  }

  void add(std::size_t target, const Mixture_term& term) { m_terms[m_ends[target]++] = term; }

  // Reads the values of the `n` elements of the source with value_of(i), and writes those of all elements of the target
  // with write(i, value), one after the other. In between, values that share nothing are mixed in parallel.
  template <class T, class Values, class Write>
  void mix(std::size_t n, const Values& value_of, const Write& write, const Execution& execution) const
  {
    const std::unique_ptr<T[]> values(new T[n]), result(new T[m_ends.size()]); // no vector: that of bool holds bits
    for(std::size_t i = 0; i < n; ++i)
      values[i] = value_of(i);
    for_each_block(std::is_trivially_copyable<T>::value ? execution : Execution(), 0, m_ends.size(),
                   transfer_block_size, [&](std::size_t begin, std::size_t end) {
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

// Carries values from the vertices and the faces of one mesh to those of another one by a common sphere. `K` is a
// kernel with exact predicates.
template <class K>
class Transfer_mixtures
{
public:
  using Point_3 = typename K::Point_3;
  using Triangulation = Sphere_triangulation<K>;
  using Place = typename Triangulation::Place;

  // The arguments have to live longer. The source has a grid. `source_points` are those of the surface, for areas;
  // `places` are those of the target's vertices in the source.
  Transfer_mixtures(const Triangulation& source, const std::vector<Vector_3d>& source_points,
                    const Triangulation& target, const std::vector<Place>& places, const Execution& execution)
    : m_source(source)
    , m_target(target)
    , m_places(places)
    , m_execution(execution)
  {
    for(const Linked_triangle& t : source.triangles())
      m_source_areas.push_back(
          length(cross(source_points[t[1]] - source_points[t[0]], source_points[t[2]] - source_points[t[0]])));
    locate_source_vertices();
  }

  // A vertex of the target has the interpolated value of its place in the source. Where the target is coarser, that
  // would leave out most values: if all vertices that would be interpolated are inside the star of the vertex, it has
  // the average of all vertices there, weighted with the area around them and with their coordinate for the vertex.
  Mixtures vertex_mixtures() const
  {
    const std::size_t n = m_target.points().size();
    std::vector<double> areas(m_source.points().size(), 0.);
    for(std::size_t t = 0; t < m_source.triangles().size(); ++t)
      for(const std::uint32_t v : m_source.triangles()[t].vertices)
        areas[v] += m_source_areas[t];
    const auto for_each_in_stars = [&](const auto& f) { // calls f(vertex of the target, vertex of the source, weight)
      for(std::uint32_t s = 0; s < m_source_places.size(); ++s)
        for(std::size_t i = 0; i < 3; ++i)
          if(m_source_places[s].coordinates[i] != 0)
            f(m_target.triangles()[m_source_places[s].triangle][i], s,
              areas[s] * CGAL::to_double(m_source_places[s].coordinates[i]));
    };
    std::vector<double> sums(n, 0.);
    for_each_in_stars([&](std::uint32_t v, std::uint32_t, double weight) { sums[v] += weight; });

    std::vector<std::uint32_t> counts(n, 0);
    for_each_block(m_execution, 0, n, transfer_block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
      {
        if(sums[v] > 0. && !has_average(v))
          sums[v] = 0.;
        for(std::size_t i = 0; i < 3 && !(sums[v] > 0.); ++i)
          counts[v] += m_places[v].coordinates[i] != 0;
      }
    });
    for_each_in_stars([&](std::uint32_t v, std::uint32_t, double weight) { counts[v] += sums[v] > 0. && weight > 0.; });
    Mixtures result(counts);
    for_each_block(m_execution, 0, n, transfer_block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        for(std::size_t i = 0; i < 3 && !(sums[v] > 0.); ++i)
          if(m_places[v].coordinates[i] != 0)
            result.add(v, {m_source.triangles()[m_places[v].triangle][i], CGAL::to_double(m_places[v].coordinates[i])});
    });
    for_each_in_stars([&](std::uint32_t v, std::uint32_t s, double weight) {
      if(sums[v] > 0. && weight > 0.)
        result.add(v, {s, weight});
    });
    return result;
  }

  // A face of the target has the value of the face of the source that its centre is in; if the centre of that one is in
  // the face of the target as well, the average of all whose centres are, weighted with their areas.
  Mixtures face_mixtures() const
  {
    const std::size_t n = m_target.triangles().size();
    const std::vector<Place> places = m_source.locate(centers_of(m_target), m_execution);
    const std::vector<Point_3> source_centers = centers_of(m_source);
    std::vector<std::uint32_t> source_places;
    for(std::size_t s = 0; s < source_centers.size(); ++s)
    {
      const std::uint32_t start = m_source_places[m_source.triangles()[s][0]].triangle;
      source_places.push_back(m_target.locate_from(start, source_centers[s]).triangle);
    }
    std::vector<double> sums(n, 0.);
    for(std::size_t s = 0; s < source_places.size(); ++s)
      sums[source_places[s]] += m_source_areas[s];
    std::vector<std::uint32_t> counts(n, 0);
    for(std::size_t f = 0; f < n; ++f)
    {
      if(source_places[places[f].triangle] != f)
        sums[f] = 0.;
      counts[f] += !(sums[f] > 0.);
    }
    for(std::size_t s = 0; s < source_places.size(); ++s)
      counts[source_places[s]] += sums[source_places[s]] > 0. && m_source_areas[s] > 0.;
    Mixtures result(counts);
    for(std::size_t f = 0; f < n; ++f)
      if(!(sums[f] > 0.))
        result.add(f, {places[f].triangle, 1.});
    for(std::uint32_t s = 0; s < source_places.size(); ++s)
      if(sums[source_places[s]] > 0. && m_source_areas[s] > 0.)
        result.add(source_places[s], {s, m_source_areas[s]});
    return result;
  }

private:
  // whether all vertices of the source that would be interpolated are inside the star of a vertex of the target
  bool has_average(std::size_t v) const
  {
    for(std::size_t i = 0; i < 3; ++i)
      if(m_places[v].coordinates[i] != 0)
      {
        const Place& place = m_source_places[m_source.triangles()[m_places[v].triangle][i]];
        const Linked_triangle& t = m_target.triangles()[place.triangle];
        const std::size_t corner = t.corner_of(static_cast<std::uint32_t>(v));
        if(t[corner] != v || place.coordinates[corner] == 0)
          return false;
      }
    return true;
  }

  // Finds the places of the source's vertices in the target, each by a walk from a neighbour's.
  void locate_source_vertices()
  {
    const std::vector<Point_3>& points = m_source.points();
    m_source_places.resize(points.size());
    visit_from_neighbors(m_source.triangles(), points.size(), Triangulation::none,
                         [&](std::uint32_t v, std::uint32_t w) {
                           const std::uint32_t start = w == Triangulation::none ? 0 : m_source_places[w].triangle;
                           m_source_places[v] = m_target.locate_from(start, points[v]);
                         });
  }

  static std::vector<Point_3> centers_of(const Triangulation& triangulation)
  {
    std::vector<Point_3> result;
    result.reserve(triangulation.triangles().size());
    for(const Linked_triangle& t : triangulation.triangles())
    {
      const Vector_3d center =
          triangulation.direction(t[0]) + triangulation.direction(t[1]) + triangulation.direction(t[2]);
      result.emplace_back(center[0], center[1], center[2]);
    }
    return result;
  }

  const Triangulation& m_source;
  const Triangulation& m_target;
  const std::vector<Place>& m_places;
  Execution m_execution;
  std::vector<Place> m_source_places; // of its vertices, in the target
  std::vector<double> m_source_areas; // doubled, of the faces
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_TRANSFER_MIXTURES_H
