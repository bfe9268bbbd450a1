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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HIERARCHY_STAR_KERNEL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HIERARCHY_STAR_KERNEL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The vertices around a removed one, starting at its target: the argument of Star_kernel.
struct Ring_hole
{
  const std::vector<Vector_3d>& positions;
  Vertex_rings::Ring ring;
  std::size_t first;

  std::size_t size() const { return ring.size(); }
  const Vector_3d& operator[](std::size_t j) const { return positions[ring.around(first + j)]; }
};

// The kernel of a hole in a triangulation of the sphere: the points that see every edge of the hole in the positive
// sense, where a vertex may be inserted. The hole is given by its vertices in counterclockwise order. Its triangulation
// by a fan from the first vertex, the base, is positively oriented, so the kernel is not empty and touches the base.
//
// The kernel is computed in the gnomonic projection at the base, where great circles are lines: a square around the
// base is clipped by the half-planes of the edges.
class Star_kernel
{
public:
  // Finds a central point of the kernel. Returns whether there is one that can be represented in double precision.
  template <class Hole>
  bool find_point(const Hole& hole, Vector_3d& point)
  {
    const std::size_t d = hole.size();
    const Tangent_frame frame(hole[0]);
    m_offsets.resize(d);
    double squared_reach = 0., squared_width = largest;
    Vector_3d middle = {0., 0., 0.}; // of the closest pair of vertices at distance two along the hole
    for(std::size_t j = 0; j < d; ++j)
    {
      m_offsets[j] = frame.offset_of(hole[j]);
      squared_reach = (std::max)(squared_reach, squared_length(m_offsets[j]));
      if(j < 2)
        continue;
      const double squared_distance = squared_length(m_offsets[j] - m_offsets[j - 2]);
      if(squared_distance < squared_width)
      {
        squared_width = squared_distance;
        middle = 0.5 * (m_offsets[j] + m_offsets[j - 2]);
      }
    }
    const double reach = (std::min)(4. * std::sqrt(squared_reach), 10.); // 4 times as far as the hole, or 84 degrees

    m_polygon = {{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}};
    for(std::size_t j = 0; j < d; ++j)
    {
      const Vector_3d &p = m_offsets[j], &q = m_offsets[j + 1 < d ? j + 1 : 0];
      const Vector_3d n = cross(p, q);
      // The normal of the plane through p, q and the center of the sphere; see Star_energy.
      clip(n[0] + (p[1] - q[1]), n[1] + (q[0] - p[0]), n[2]);
    }
    if(m_polygon.size() < 3)
      return false;

    // The centroid, or else points between it and the base: closer to the base, the angles to the far edges are better.
    Point candidate = centroid(), best = candidate;
    double min_roughness = largest;
    const auto consider = [&](const Point& c) {
      const double value = roughness(c);
      if(value < min_roughness)
      {
        min_roughness = value;
        best = c;
      }
    };
    for(int k = 0; k < max_halvings && !(min_roughness < largest); ++k)
    {
      consider(candidate);
      candidate = {0.5 * candidate[0], 0.5 * candidate[1]};
    }
    // The hole of a vertex between two hubs is a lune, which is unbounded in the projection. Its centroid is then far
    // from the middle, which is between the two vertices that are close to each other.
    consider({middle[0] / (1. + middle[2]), middle[1] / (1. + middle[2])});
    if(!(min_roughness < largest))
      return false;
    // From the tangent plane back to tangential coordinates.
    const double s = 1. / std::sqrt(1. + best[0] * best[0] + best[1] * best[1]);
    point = frame.point_at(s * best[0], s * best[1]);
    return true;
  }

private:
  static constexpr int max_halvings = 4; // down to an eighth of the distance from the base; the middle is tried as well
  static constexpr double largest = (std::numeric_limits<double>::max)();

  using Point = std::array<double, 2>;

  // Keeps the part of the polygon where a x + b y + c >= 0.
  void clip(double a, double b, double c)
  {
    m_clipped.clear();
    const std::size_t n = m_polygon.size();
    for(std::size_t k = 0; k < n; ++k)
    {
      const Point &s = m_polygon[k], &t = m_polygon[k + 1 < n ? k + 1 : 0];
      const double at_s = a * s[0] + b * s[1] + c, at_t = a * t[0] + b * t[1] + c;
      if(at_s >= 0.)
        m_clipped.push_back(s);
      if((at_s > 0. && at_t < 0.) || (at_s < 0. && at_t > 0.))
      {
        const double f = at_s / (at_s - at_t);
        m_clipped.push_back({s[0] + f * (t[0] - s[0]), s[1] + f * (t[1] - s[1])});
      }
    }
    std::swap(m_polygon, m_clipped);
  }

  Point centroid() const
  {
    const Point& o = m_polygon[0];
    double doubled_area = 0., x = 0., y = 0.;
    for(std::size_t k = 1; k + 1 < m_polygon.size(); ++k)
    {
      const Point &s = m_polygon[k], &t = m_polygon[k + 1];
      const double w = (s[0] - o[0]) * (t[1] - o[1]) - (s[1] - o[1]) * (t[0] - o[0]);
      doubled_area += w;
      x += w * ((s[0] - o[0]) + (t[0] - o[0]));
      y += w * ((s[1] - o[1]) + (t[1] - o[1]));
    }
    if(!(doubled_area > 0.))
      return o;
    return {o[0] + x / (3. * doubled_area), o[1] + y / (3. * doubled_area)};
  }

  // The sum of the deviations from equilateral of the faces between the gnomonic point and the edges of the hole;
  // infinite if one of them is not safely positive.
  double roughness(const Point& c) const
  {
    const double s = 1. / std::sqrt(1. + c[0] * c[0] + c[1] * c[1]);
    const double x = s * c[0], y = s * c[1], z = Tangent_frame::height_at(x, y);
    const std::size_t d = m_offsets.size();
    double sum = 0.;
    for(std::size_t j = 0; j < d; ++j)
    {
      const Vector_3d &p = m_offsets[j], &q = m_offsets[j + 1 < d ? j + 1 : 0];
      const Vector_3d to_p = {p[0] - x, p[1] - y, p[2] - z}, to_q = {q[0] - x, q[1] - y, q[2] - z};
      const Vector_3d n = cross(to_p, to_q);
      const double determinant = x * n[0] + y * n[1] + (1. + z) * n[2];
      const double squared_edges = squared_length(to_p) + squared_length(to_q);
      if(!is_safely_positive(determinant, squared_edges))
        return largest;
      sum += squared_edges / determinant;
    }
    return sum;
  }

  std::vector<Vector_3d> m_offsets;
  std::vector<Point> m_polygon, m_clipped;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HIERARCHY_STAR_KERNEL_H
