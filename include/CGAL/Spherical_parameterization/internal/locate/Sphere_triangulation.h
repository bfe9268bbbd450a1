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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_SPHERE_TRIANGULATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_SPHERE_TRIANGULATION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/barycentric_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A grid of n x n cells over the directions: the octahedron |x| + |y| + |z| = 1 with its lower half unfolded, which is
// a square. The areas of cells on the sphere differ by a factor of about 5.
class Octahedral_grid
{
public:
  explicit Octahedral_grid(std::uint32_t n = 1)
    : m_n(n)
  {}

  std::size_t number_of_cells() const { return std::size_t(m_n) * m_n; }

  // The cell of a direction, which need not be finite.
  std::uint32_t cell(const Vector_3d& q) const
  {
    const std::array<double, 2> p = unfolded(q);
    return part_of(p[0], m_n) + m_n * part_of(p[1], m_n);
  }

  // Calls f(cell, center) for all cells, each of them adjacent to the previous one.
  template <class Function>
  void for_each_cell(const Function& f) const
  {
    const double size = 2. / m_n;
    for(std::uint32_t j = 0; j < m_n; ++j)
      for(std::uint32_t k = 0; k < m_n; ++k)
      {
        const std::uint32_t i = j % 2 == 0 ? k : m_n - 1 - k;
        f(i + m_n * j, folded({(i + 0.5) * size - 1., (j + 0.5) * size - 1.}));
      }
  }

  // The position of a direction along the Morton curve through 2^16 x 2^16 cells.
  static std::uint32_t position_on_curve(const Vector_3d& q)
  {
    const std::array<double, 2> p = unfolded(q);
    return spread_bits(part_of(p[0], 1u << 16)) | spread_bits(part_of(p[1], 1u << 16)) << 1;
  }

private:
  // The position of a direction in [-1, 1]^2.
  static std::array<double, 2> unfolded(const Vector_3d& q)
  {
    const double s = std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]);
    const double u = q[0] / s, v = q[1] / s;
    if(q[2] < 0.)
      return {std::copysign(1. - std::abs(v), u), std::copysign(1. - std::abs(u), v)};
    return {u, v};
  }

  static Vector_3d folded(const std::array<double, 2>& p)
  {
    const double z = 1. - std::abs(p[0]) - std::abs(p[1]);
    if(z < 0.)
      return {std::copysign(1. - std::abs(p[1]), p[0]), std::copysign(1. - std::abs(p[0]), p[1]), z};
    return {p[0], p[1], z};
  }

  // The index of the one of n parts of [-1, 1] that contains x; 0 for a number outside, such as NaN.
  static std::uint32_t part_of(double x, std::uint32_t n)
  {
    const double part = 0.5 * (x + 1.) * n;
    return part > 0. && part < 0x1p31 ? (std::min)(static_cast<std::uint32_t>(part), n - 1) : 0;
  }

  // Moves bit k of a 16-bit number to bit 2 k.
  static std::uint32_t spread_bits(std::uint32_t x)
  {
    x = (x | x << 8) & 0x00FF00FFu;
    x = (x | x << 4) & 0x0F0F0F0Fu;
    x = (x | x << 2) & 0x33333333u;
    return (x | x << 1) & 0x55555555u;
  }

  std::uint32_t m_n;
};

// The images of a mesh on the sphere, a bijection, as flat arrays. The triangle of a direction is found by an exact
// walk that starts at a triangle nearby: one that contains the center of a grid cell, or any that the caller knows. All
// triangles contain their boundaries; of those that contain a direction, the first one owns it.
//
// `K` is a kernel with exact predicates.
template <class K>
class Sphere_triangulation
{
public:
  using FT = typename K::FT;
  using Point_3 = typename K::Point_3;

  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  // The location of a direction: no triangle if it is zero or not finite.
  struct Triangle_location
  {
    std::uint32_t triangle = none;
    std::array<FT, 3> coordinates = {FT(0), FT(0), FT(0)};
  };

  // The location at which a query has ended. The next query starts there if it is in the same cell.
  struct Hint
  {
    std::uint32_t cell = none, triangle = 0;
  };

  void assign(std::vector<Point_3> points, std::vector<Linked_triangle> triangles)
  {
    m_points = std::move(points);
    m_triangles = std::move(triangles);
    m_first_triangles.assign(m_points.size(), none);
    for(std::uint32_t t = 0; t < m_triangles.size(); ++t)
      for(const std::uint32_t v : m_triangles[t].vertices)
        m_first_triangles[v] = (std::min)(m_first_triangles[v], t);
  }

  // Creates the grid. Returns false if a direction is in no triangle, that is, the map is not a bijection.
  bool make_grid()
  {
    const auto n = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(m_triangles.size())));
    m_grid = Octahedral_grid(n);
    m_starts.assign(m_grid.number_of_cells(), none);
    Found found;
    bool is_covered = n > 0;
    m_grid.for_each_cell([&](std::uint32_t cell, const Vector_3d& p) {
      is_covered = is_covered && find(Point_3(FT(p[0]), FT(p[1]), FT(p[2])), found.triangle, found);
      m_starts[cell] = found.triangle;
    });
    return is_covered;
  }

  const std::vector<Point_3>& points() const { return m_points; }
  const std::vector<Linked_triangle>& triangles() const { return m_triangles; }

  // The rounded unit vector of a vertex's image.
  Vector_3d direction(std::size_t v) const { return direction_of(m_points[v]); }

  // The images of a triangle, see scaled_together(). Their lengths matter, as in all functions that locate points.
  std::array<Vector_3d, 3> corners(const Linked_triangle& t) const
  {
    return scaled_together({rounded(m_points[t[0]]), rounded(m_points[t[1]]), rounded(m_points[t[2]])});
  }

  // Locates a direction, starting at a triangle nearby, without a grid.
  Triangle_location locate_from(std::uint32_t start, const Point_3& q) const
  {
    Found found;
    return find(q, start, found) ? owner(q, found) : Triangle_location();
  }

  // The same with another predicate, orientation(a, b, q) for an edge from a to b; returns only the triangle.
  template <class Orientation>
  std::uint32_t triangle_from(std::uint32_t start, const Point_3& q, const Orientation& orientation) const
  {
    Found found;
    return find(q, start, found, orientation) ? found.triangle : none;
  }

  // The following functions require the grid.
  Triangle_location locate(const Point_3& q, Hint& hint) const
  {
    const std::uint32_t cell = m_grid.cell(approximate(q));
    Found found;
    if(!find(q, cell == hint.cell ? hint.triangle : m_starts[cell], found))
      return Triangle_location();
    hint = {cell, found.triangle};
    return owner(q, found);
  }

  // Locates all directions, in parallel if the coordinates are of type double. In a large mesh, the queries follow a
  // curve on the sphere, so that the triangles of a query are in the caches after the previous query.
  std::vector<Triangle_location> locate(const std::vector<Point_3>& directions, const Execution& execution) const
  {
    constexpr std::size_t min_triangles_to_sort = 100000; // Less than 5 MB are in the caches anyway.
    const Execution safe_execution = std::is_same<FT, double>::value ? execution : Execution();
    std::vector<Query> queries;
    if(m_triangles.size() >= min_triangles_to_sort)
      queries = sorted_along_curve(directions, safe_execution);
    std::vector<Triangle_location> result(directions.size());
    for_each_block(safe_execution, 0, result.size(), usual_block_size, [&](std::size_t begin, std::size_t end) {
      Hint hint;
      for(std::size_t k = begin; k < end; ++k)
        if(queries.empty())
          result[k] = locate(directions[k], hint);
        else
          result[queries[k].number] = locate(queries[k].direction, hint);
    });
    return result;
  }

private:
  // A triangle that contains a direction, and the side of the direction with respect to the edge opposite to each
  // vertex. All three are 0 if the direction is zero or not finite.
  struct Found
  {
    std::uint32_t triangle = 0;
    std::array<Sign, 3> sides;
  };

  static Vector_3d approximate(const Point_3& p)
  {
    // Lazy numbers need not be evaluated, and must not be if they are not finite.
    return {CGAL::to_interval(p.x()).first, CGAL::to_interval(p.y()).first, CGAL::to_interval(p.z()).first};
  }

  static constexpr std::size_t successor(std::size_t i) { return i < 2 ? i + 1 : 0; }

  template <class Orientation>
  Sign side(const Linked_triangle& t, std::size_t i, const Point_3& q, const Orientation& orientation) const
  {
    const std::size_t j = successor(i);
    return orientation(m_points[t[j]], m_points[t[successor(j)]], q);
  }

  bool find(const Point_3& q, std::uint32_t start, Found& found) const { return find(q, start, found, m_orientation); }
  template <class Orientation>
  bool find(const Point_3& q, std::uint32_t start, Found& found, const Orientation& orientation) const
  {
    if(walk(q, start, found, orientation))
      return true;
    for(std::uint32_t k = 0; k < m_triangles.size(); ++k)
    {
      const Linked_triangle& t = m_triangles[k];
      found = {k, {side(t, 0, q, orientation), side(t, 1, q, orientation), side(t, 2, q, orientation)}};
      if(std::count(found.sides.begin(), found.sides.end(), NEGATIVE) == 0)
        return true;
    }
    return false;
  }

  // Walks from triangle to triangle, across any edge that separates the triangle from the direction. A walk that always
  // tests the edges in the same order may cycle; with a random order, it leaves cycles eventually. It gives up after as
  // many steps as there are triangles.
  template <class Orientation>
  bool walk(const Point_3& q, std::uint32_t start, Found& found, const Orientation& orientation) const
  {
    std::uint32_t current = start, previous = none, random = 0;
    for(std::size_t n = 0; n <= m_triangles.size(); ++n)
    {
      const Linked_triangle& t = m_triangles[current];
      random = 1664525u * random + 1013904223u;
      std::size_t i = (3 * (random >> 16)) >> 16, n_tested = 0;
      for(; n_tested < 3; ++n_tested, i = successor(i))
      {
        found.sides[i] = t.neighbors[i] == previous ? POSITIVE : side(t, i, q, orientation);
        if(found.sides[i] == NEGATIVE)
          break;
      }
      if(n_tested == 3)
      {
        found.triangle = current;
        return true;
      }
      previous = current;
      current = t.neighbors[i];
    }
    return false;
  }

  // The triangle that owns a direction, given one that contains it. The direction is in the convex hull of those
  // vertices of the given triangle whose opposite edges have it on their positive side: all three, the two of an edge,
  // or one.
  Triangle_location owner(const Point_3& q, const Found& found) const
  {
    const Linked_triangle& t = m_triangles[found.triangle];
    std::uint32_t result = found.triangle;
    std::size_t n_positive = 0, last_positive = 0;
    for(std::size_t i = 0; i < 3; ++i)
      if(found.sides[i] == POSITIVE)
      {
        ++n_positive;
        last_positive = i;
      }
      else
        result = (std::min)(result, t.neighbors[i]);
    if(n_positive == 0)
      return Triangle_location();
    if(n_positive == 1)
      result = m_first_triangles[t[last_positive]];

    const Linked_triangle& r = m_triangles[result];
    std::array<bool, 3> is_positive = {false, false, false};
    std::array<Vector_3<FT>, 3> corners;
    for(std::size_t i = 0; i < 3; ++i)
    {
      for(std::size_t j = 0; j < 3; ++j)
        is_positive[i] = is_positive[i] || (r[i] == t[j] && found.sides[j] == POSITIVE);
      corners[i] = coordinates(m_points[r[i]]);
    }
    return {result, barycentric_coordinates<FT>(corners, coordinates(q), is_positive)};
  }

  static Vector_3<FT> coordinates(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

  struct Query
  {
    Point_3 direction; // a copy, because reading it from its original location would dominate the time
    std::size_t number;
  };

  // The directions in their order along a curve: sorted into about as many buckets as there are directions, in linear
  // time.
  static std::vector<Query> sorted_along_curve(const std::vector<Point_3>& directions, const Execution& execution)
  {
    constexpr std::size_t block_size = 4096; // of parallel work: large enough to make the overhead negligible
    constexpr unsigned int max_bits = 24;    // of bucket indices; the starts then take 128 MB
    unsigned int n_bits = 0;
    while(n_bits < max_bits && (directions.size() >> n_bits) > 1)
      ++n_bits;
    std::vector<std::uint32_t> buckets(directions.size());
    for_each_in_blocks(execution, 0, directions.size(), block_size, [&](std::size_t k) {
      const std::uint64_t place = Octahedral_grid::position_on_curve(approximate(directions[k]));
      buckets[k] = static_cast<std::uint32_t>(place >> (32 - n_bits));
    });
    std::vector<std::size_t> starts((std::size_t(1) << n_bits) + 1, 0); // of the buckets, and later their ends
    for(const std::uint32_t bucket : buckets)
      ++starts[bucket + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<Query> result(directions.size());
    for(std::size_t k = 0; k < directions.size(); ++k)
      result[starts[buckets[k]]++] = {directions[k], k};
    return result;
  }

  Orientation_about_origin_3<K> m_orientation;
  std::vector<Point_3> m_points;
  std::vector<Linked_triangle> m_triangles;
  std::vector<std::uint32_t> m_first_triangles; // the first one at each vertex
  Octahedral_grid m_grid;
  std::vector<std::uint32_t> m_starts; // for each cell, a triangle that contains its center
};

// Values of vertices, interpolated at a location.
template <class T, class Triangle_location>
T interpolated(const std::vector<T>& values, const std::vector<Linked_triangle>& triangles,
               const Triangle_location& place)
{
  const Linked_triangle& t = triangles[place.triangle];
  const auto& w = place.coordinates;
  return CGAL::to_double(w[0]) * values[t[0]] + CGAL::to_double(w[1]) * values[t[1]] +
         CGAL::to_double(w[2]) * values[t[2]];
}

// The locations of the vertices of a connected triangulation of the sphere in another one, which needs no grid: each is
// found by a walk from the location of a neighbor. Isolated vertices have no location.
template <class K>
std::vector<typename Sphere_triangulation<K>::Triangle_location> locations_of_vertices(
    const Sphere_triangulation<K>& of, const Sphere_triangulation<K>& in)
{
  constexpr std::uint32_t none = Sphere_triangulation<K>::none;
  std::vector<typename Sphere_triangulation<K>::Triangle_location> result(of.points().size());
  visit_from_neighbors(of.triangles(), of.points().size(), none, [&](std::uint32_t v, std::uint32_t w) {
    result[v] = in.locate_from(w == none ? 0 : result[w].triangle, of.points()[v]);
  });
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_SPHERE_TRIANGULATION_H
