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

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/sampling/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/sampling/mixed_value.h>
#include <CGAL/Spherical_parameterization/internal/simd/Vector_3.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
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

  // The arguments have to live longer. `source_points` are those of the surface, for areas; `places` are those of the
  // target's vertices in the source, if they are known.
  Transfer_mixtures(const Triangulation& source, const std::vector<Vector_3d>& source_points,
                    const std::vector<Point_3>& target_images, const std::vector<Linked_triangle>& target_triangles,
                    const Execution& execution, std::vector<Place> places = {})
    : m_source(source)
    , m_images(target_images)
    , m_triangles(target_triangles)
    , m_execution(std::is_same<typename K::FT, double>::value ? execution : Execution())
    , m_places(std::move(places))
  {
    for(const Linked_triangle& t : source.triangles())
      m_source_areas.push_back(
          length(cross(source_points[t[1]] - source_points[t[0]], source_points[t[2]] - source_points[t[0]])));
  }

  // A vertex of the target has the interpolated value of its place in the source. Where the target is coarser, that
  // would leave out most values: if all vertices that would be interpolated are inside the star of the vertex, it has
  // the average of all vertices there, weighted with the area around them and with their coordinate for the vertex.
  Mixtures vertex_mixtures()
  {
    if(m_places.empty())
      m_places = m_source.locate(m_images, m_execution);
    const std::vector<Place>& places = m_places;
    std::vector<double> areas(m_source.points().size(), 0.);
    for(std::size_t t = 0; t < m_source.triangles().size(); ++t)
      for(const std::uint32_t v : m_source.triangles()[t].vertices)
        areas[v] += m_source_areas[t];

    std::vector<std::uint32_t> first_triangles(m_images.size());
    for(std::uint32_t t = 0; t < m_triangles.size(); ++t)
      for(const std::uint32_t v : m_triangles[t].vertices)
        first_triangles[v] = t;
    const auto corners_are_in_star = [&](std::size_t v) {
      const Linked_triangle& corners = m_source.triangles()[places[v].triangle];
      for(std::size_t i = 0; i < 3; ++i)
        if(places[v].coordinates[i] != 0 &&
           !is_in_star(static_cast<std::uint32_t>(v), first_triangles[v], m_source.points()[corners[i]]))
          return false;
      return true;
    };
    std::vector<double> sums(m_images.size(), 0.); // of the weights of those that have an average
    std::vector<Place> source_places;
    if(is_true_for_any(m_images.size(), corners_are_in_star))
    {
      source_places = locate_in_target(m_source.points());
      for_each_hat(source_places, areas, [&](std::uint32_t v, const Mixture_term& term) { sums[v] += term.weight; });
      for(std::size_t v = 0; v < m_images.size(); ++v)
        if(sums[v] > 0. && !corners_are_in_star(v))
          sums[v] = 0.;
    }

    std::vector<std::uint32_t> counts(m_images.size(), 0);
    const auto for_each_term = [&](const auto& f) {
      for(std::size_t v = 0; v < m_images.size(); ++v)
        for(std::size_t i = 0; i < 3 && !(sums[v] > 0.); ++i)
          if(places[v].coordinates[i] != 0)
            f(static_cast<std::uint32_t>(v),
              Mixture_term{m_source.triangles()[places[v].triangle][i], CGAL::to_double(places[v].coordinates[i])});
      for_each_hat(source_places, areas, [&](std::uint32_t v, const Mixture_term& term) {
        if(sums[v] > 0.)
          f(v, term);
      });
    };
    for_each_term([&](std::uint32_t v, const Mixture_term&) { ++counts[v]; });
    Mixtures result(counts);
    for_each_term([&](std::uint32_t v, const Mixture_term& term) { result.add(v, term); });
    return result;
  }

  // A face of the target has the value of the face of the source that its centre is in; if the centre of that one is in
  // the face of the target as well, the average of all whose centres are, weighted with their areas.
  Mixtures face_mixtures()
  {
    const std::vector<Point_3> centers = centers_of(m_images, m_triangles),
                               source_centers = centers_of(m_source.points(), m_source.triangles());
    const std::vector<Place> places = m_source.locate(centers, m_execution);
    std::vector<Place> source_places;
    if(is_true_for_any(m_triangles.size(), [&](std::size_t f) {
         const Linked_triangle& t = m_triangles[f];
         const Point_3& q = source_centers[places[f].triangle];
         return side(t, 0, q) != NEGATIVE && side(t, 1, q) != NEGATIVE && side(t, 2, q) != NEGATIVE;
       }))
      source_places = locate_in_target(source_centers);

    std::vector<double> sums(m_triangles.size(), 0.);
    for(std::size_t s = 0; s < source_places.size(); ++s)
      sums[source_places[s].triangle] += m_source_areas[s];
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      if(sums[f] > 0. && source_places[places[f].triangle].triangle != f)
        sums[f] = 0.;

    std::vector<std::uint32_t> counts(m_triangles.size(), 0);
    const auto for_each_term = [&](const auto& function) {
      for(std::uint32_t f = 0; f < m_triangles.size(); ++f)
        if(!(sums[f] > 0.))
          function(f, Mixture_term{places[f].triangle, 1.});
      for(std::uint32_t s = 0; s < source_places.size(); ++s)
        if(sums[source_places[s].triangle] > 0. && m_source_areas[s] > 0.)
          function(source_places[s].triangle, Mixture_term{s, m_source_areas[s]});
    };
    for_each_term([&](std::uint32_t f, const Mixture_term&) { ++counts[f]; });
    Mixtures result(counts);
    for_each_term([&](std::uint32_t f, const Mixture_term& term) { result.add(f, term); });
    return result;
  }

private:
  Sign side(const Linked_triangle& t, std::size_t i, const Point_3& q) const
  {
    return m_orientation(m_images[t[(i + 1) % 3]], m_images[t[(i + 2) % 3]], q);
  }

  // whether a direction is in the inside of the triangles around vertex v, of which one is given
  bool is_in_star(std::uint32_t v, std::uint32_t first_triangle, const Point_3& q) const
  {
    std::uint32_t current = first_triangle;
    do
    {
      const Linked_triangle& t = m_triangles[current];
      const std::size_t i = t[0] == v ? 0 : t[1] == v ? 1 : 2, j = (i + 1) % 3;
      if(side(t, j, q) != NEGATIVE && side(t, (i + 2) % 3, q) != NEGATIVE && side(t, i, q) == POSITIVE)
        return true;
      current = t.neighbors[j];
    } while(current != first_triangle);
    return false;
  }

  template <class Predicate>
  bool is_true_for_any(std::size_t n, const Predicate& predicate) const
  {
    std::atomic<bool> result(false);
    for_each_block(m_execution, 0, n, transfer_block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end && !result.load(std::memory_order_relaxed); ++i)
        if(predicate(i))
          result.store(true, std::memory_order_relaxed);
    });
    return result;
  }

  std::vector<Place> locate_in_target(const std::vector<Point_3>& directions)
  {
    if(m_target.triangles().empty())
      m_target.assign(m_images, m_triangles);
    return m_target.locate(directions, m_execution);
  }

  // Calls f(v, term) for each vertex v of the target and each vertex of the source in its star.
  template <class Function>
  void for_each_hat(const std::vector<Place>& source_places, const std::vector<double>& areas, const Function& f) const
  {
    for(std::uint32_t s = 0; s < source_places.size(); ++s)
      for(std::size_t i = 0; i < 3; ++i)
      {
        const double weight = CGAL::to_double(source_places[s].coordinates[i]) * areas[s];
        if(weight > 0.)
          f(m_triangles[source_places[s].triangle][i], Mixture_term{s, weight});
      }
  }

  static std::vector<Point_3> centers_of(const std::vector<Point_3>& images,
                                         const std::vector<Linked_triangle>& triangles)
  {
    const auto direction = [&](std::uint32_t v) {
      const Point_3& p = images[v];
      return normalized(Vector_3d{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    };
    std::vector<Point_3> result;
    result.reserve(triangles.size());
    for(const Linked_triangle& t : triangles)
    {
      const Vector_3d center = direction(t[0]) + direction(t[1]) + direction(t[2]);
      result.emplace_back(center[0], center[1], center[2]);
    }
    return result;
  }

  const Triangulation& m_source;
  const std::vector<Point_3>& m_images;
  const std::vector<Linked_triangle>& m_triangles;
  Execution m_execution;
  std::vector<Place> m_places;
  std::vector<double> m_source_areas; // doubled, of the faces
  Triangulation m_target;             // made if it is needed
  Orientation_about_origin_3<K> m_orientation;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_TRANSFER_MIXTURES_H
