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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_FLOAT_ROUNDING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_FLOAT_ROUNDING_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Whether floats near the coordinates of a point have full precision and are finite.
inline bool has_normal_floats(const Vector_3d& p)
{
  const double max = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return is_finite(p) && max >= (std::numeric_limits<float>::min)() && max < 0.5 * (std::numeric_limits<float>::max)();
}

// Rounds the points of a bijective map to points with float coordinates that define a bijective map as well.
//
// All points are rounded to nearest. The corners of a face that this inverts get their original points back, until no
// face is inverted; in the worst case, these are all corners, as in the given map. Such vertices are open. From then on
// all faces stay positive. An open vertex is closed if one of the nearest float points lies in the kernel of its star.
// If none does, its faces are smaller than the resolution of floats. Then its neighbors are opened as well, and open
// vertices move to increase the heights of their smallest faces, until there is room. A vertex moves no farther than
// necessary.
class Float_rounding
{
public:
  // `points` are those of a bijective map, in the range of float.
  Float_rounding(const Index_triangles& triangles, std::vector<Vector_3d> points)
    : m_triangles(triangles)
    , m_given(std::move(points))
    , m_points(m_given.size())
    , m_is_open(m_given.size(), false)
  {}

  // Returns whether finally all points have float coordinates and all faces are positive.
  //
  // The running time is linear in the size of the mesh, a few nanoseconds per vertex if no face is inverted, plus at
  // most `max_visits_of_vertex` visits per vertex of about 50 microseconds each if faces are inverted everywhere.
  bool run()
  {
    std::transform(m_given.begin(), m_given.end(), m_points.begin(), [](const Vector_3d& p) { return rounded(p); });
    for(const Triangle& t : m_triangles)
      if(!is_positive(t))
        m_inverted.push_back(t);
    m_number_of_folded_faces = m_inverted.size();
    if(m_inverted.empty())
      return true;
    if(!build_rings(link_triangles(m_triangles, m_points.size()), m_points.size(), m_rings))
      return false;
    open_inverted_faces();
    std::size_t n_visits = max_visits_of_vertex * m_points.size() + max_further_visits;
    for(;;)
    {
      m_open.erase(std::remove_if(m_open.begin(), m_open.end(), [this](std::uint32_t v) { return close(v); }),
                   m_open.end());
      if(m_open.empty())
        return true;
      open_neighbors();
      if(n_visits < n_sweeps * m_open.size())
        return false;
      n_visits -= n_sweeps * m_open.size();
      for(std::size_t k = 0; k < n_sweeps; ++k)
        for(const std::uint32_t v : m_open)
          make_room(v);
    }
  }

  const std::vector<Vector_3d>& points() const { return m_points; }

  // The number of faces that rounding to nearest inverts.
  std::size_t number_of_folded_faces() const { return m_number_of_folded_faces; }

  // The distance between adjacent points with float coordinates near p.
  static double spacing(const Vector_3d& p)
  {
    return std::ldexp(1., exponent_of_unit((std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])})));
  }

private:
  using Triangle = std::array<std::uint32_t, 3>;
  using K = Exact_predicates_inexact_constructions_kernel;

  static constexpr std::size_t n_sweeps = 8;              // that make room before floats are tried again
  static constexpr std::size_t max_visits_of_vertex = 20; // on average; few meshes need any
  static constexpr std::size_t max_further_visits = 50000;
  static constexpr double enough = 8.; // spacings of floats: the height of a face that rounding cannot invert

  // The exponent of the unit in the last place of the float closest to x.
  static int exponent_of_unit(double x)
  {
    int exponent = 0;
    std::frexp(x, &exponent);
    using Limits = std::numeric_limits<float>;
    return (std::max)(exponent, Limits::min_exponent) - Limits::digits;
  }

  // Rounds to the nearest float, without a conversion to float and back, which GCC 12 removes from vectorized code.
  static double rounded(double x)
  {
    const int exponent = exponent_of_unit(x);
    return std::ldexp(std::nearbyint(std::ldexp(x, -exponent)), exponent);
  }

  static Vector_3d rounded(const Vector_3d& p) { return {rounded(p[0]), rounded(p[1]), rounded(p[2])}; }

  static bool is_positive(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c)
  {
    const auto point = [](const Vector_3d& p) { return K::Point_3(p[0], p[1], p[2]); };
    return Orientation_about_origin_3<K>()(point(a), point(b), point(c)) == POSITIVE;
  }

  bool is_positive(const Triangle& t) const { return is_positive(m_points[t[0]], m_points[t[1]], m_points[t[2]]); }

  // Calls f(p, q) for the edges that are opposite to a vertex, as long as it returns true.
  template <class Function>
  bool for_link(std::uint32_t v, const Function& f) const
  {
    const Vertex_rings::Ring ring = m_rings.ring(v);
    for(std::size_t j = 0; j < ring.size(); ++j)
      if(!f(ring[j], ring.around(j + 1)))
        return false;
    return true;
  }

  bool is_in_kernel(std::uint32_t v, const Vector_3d& x) const
  {
    return for_link(v, [&](std::uint32_t p, std::uint32_t q) { return is_positive(x, m_points[p], m_points[q]); });
  }

  // The smallest height of the faces of a vertex at x, limited to `max`; any value below `min` if it is smaller than
  // `min`.
  double smallest_height(std::uint32_t v, const Vector_3d& x, double min, double max) const
  {
    double result = max;
    const double radius = length(x);
    for_link(v, [&](std::uint32_t p, std::uint32_t q) {
      const Vector_3d a = m_points[p] - x, b = m_points[q] - x;
      const double edge = (std::max)({squared_length(a), squared_length(b), squared_length(b - a)});
      result = (std::min)(result, edge > 0. ? dot(x, cross(a, b)) / (radius * std::sqrt(edge)) : 0.);
      return result >= min;
    });
    return result;
  }

  void open(std::uint32_t v)
  {
    m_is_open[v] = true;
    m_open.push_back(v);
  }

  // Resets vertices to their original points until no face is inverted.
  void open_inverted_faces()
  {
    while(!m_inverted.empty())
    {
      const Triangle t = m_inverted.back();
      m_inverted.pop_back();
      if(is_positive(t))
        continue;
      for(const std::uint32_t v : t)
        if(!m_is_open[v])
        {
          open(v);
          m_points[v] = m_given[v];
          for_link(v, [&](std::uint32_t p, std::uint32_t q) {
            m_inverted.push_back({v, p, q});
            return true;
          });
        }
    }
    std::sort(m_open.begin(), m_open.end());
  }

  void open_neighbors()
  {
    const std::vector<std::uint32_t> open_vertices = m_open;
    for(const std::uint32_t v : open_vertices)
      for(const std::uint32_t w : m_rings.ring(v))
        if(!m_is_open[w])
          open(w);
    std::sort(m_open.begin(), m_open.end());
  }

  // Moves a vertex to a float point nearby: the one with the largest minimum height of its faces, and the nearest one
  // of equals. Returns whether there is one.
  bool close(std::uint32_t v)
  {
    const Vector_3d x = m_points[v];
    const double step = spacing(x);
    double height = 0.;
    for(const Vector_3d& offset : m_offsets)
    {
      const Vector_3d y = rounded(rounded(x) + step * offset);
      const double h = smallest_height(v, y, height, enough * step);
      if(h > height && is_in_kernel(v, y))
      {
        height = h;
        m_points[v] = y;
        m_is_open[v] = false;
      }
    }
    return !m_is_open[v];
  }

  // Moves an open vertex, at constant distance from the origin, to increase the height of its lowest face, unless that
  // is sufficient.
  void make_room(std::uint32_t v)
  {
    constexpr int n_halvings = 24;
    const Vector_3d x = m_points[v];
    const double radius = length(x), max = enough * spacing(x);
    double height = smallest_height(v, x, 0., max), step = 0.;
    if(height >= max)
      return;
    for(const std::uint32_t w : m_rings.ring(v))
      step = (std::max)(step, length(m_points[w] - x));
    step = (std::min)(step, max); // farther away there is room anyway
    const Basic_tangent_frame<double> frame((1. / radius) * x);
    constexpr double root = 0.7071067811865476;
    constexpr std::array<std::array<double, 2>, 8> compass = {
        {{1., 0.}, {root, root}, {0., 1.}, {-root, root}, {-1., 0.}, {-root, -root}, {0., -1.}, {root, -root}}};
    bool is_moved = false;
    for(int n = 0; n < n_halvings && !is_moved; ++n)
    {
      step *= 0.5;
      for(const auto& [c, s] : compass)
      {
        const Vector_3d z = x + frame.vector_of(step * c, step * s), y = (radius / length(z)) * z;
        const double h = smallest_height(v, y, height, max);
        if(h > height && is_in_kernel(v, y))
        {
          height = h;
          m_points[v] = y;
          is_moved = true;
        }
      }
    }
  }

  // The integer points of a cube around 0, the nearest ones first.
  static std::vector<Vector_3d> cube()
  {
    constexpr int size = 2;
    std::vector<Vector_3d> result;
    for(int x = -size; x <= size; ++x)
      for(int y = -size; y <= size; ++y)
        for(int z = -size; z <= size; ++z)
          result.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    std::stable_sort(result.begin(), result.end(),
                     [](const Vector_3d& a, const Vector_3d& b) { return squared_length(a) < squared_length(b); });
    return result;
  }

  const Index_triangles& m_triangles;
  std::vector<Vector_3d> m_given, m_points;
  std::vector<bool> m_is_open;
  Vertex_rings m_rings;
  std::vector<Triangle> m_inverted;
  std::vector<std::uint32_t> m_open; // in ascending order
  std::vector<Vector_3d> m_offsets = cube();
  std::size_t m_number_of_folded_faces = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_FLOAT_ROUNDING_H
