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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Sphere_overlay.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

inline Vector_3d point_on_edge(const Vector_3d& p, const Vector_3d& q, double place)
{
  return (1. - place) * p + place * q;
}

// Where on the edge from p to q the ray of r is, from 0 to 1, if it is in its plane, or next to it.
inline double place_on_edge(const Vector_3d& p, const Vector_3d& q, const Vector_3d& r)
{
  const Vector_3d n = cross(p, q);
  const double to_p = dot(cross(p, r), n), to_q = dot(cross(r, q), n); // (1 - t) p + t q crosses with t n and (1 - t) n
  const double place = to_p / (to_p + to_q);
  return place > 0. ? (std::min)(place, 1.) : 0.;
}

// Scales an edge by a power of two, which is exact, so that products of its coordinates neither overflow nor underflow.
inline void scale_to_unit(Vector_3d& p, Vector_3d& q)
{
  double size = 0.;
  for(std::size_t k = 0; k < 3; ++k)
    size = (std::max)({size, std::abs(p[k]), std::abs(q[k])});
  const int exponent = std::ilogb(size);
  for(Vector_3d* end : {&p, &q})
    for(double& x : *end)
      x = std::scalbn(x, -exponent);
}

// Where two edges cross, from 0 to 1 on each: the numbers s and t for which (1 - s) a1 + s a2 and (1 - t) b1 + t b2 have one
// direction. Edges that are next to each other over a length have no one place, but one that they share.
inline std::array<double, 2> crossing_places(Vector_3d a1, Vector_3d a2, Vector_3d b1, Vector_3d b2)
{
  scale_to_unit(a1, a2);
  scale_to_unit(b1, b2);
  const Vector_3d n = cross(b1, b2);
  const double d1 = std::abs(dot(n, a1)), d2 = std::abs(dot(n, a2)); // on two sides, but for ties and rounding
  const double s = d1 + d2 > 0. ? d1 / (d1 + d2) : 0.5;
  const double t = place_on_edge(b1, b2, point_on_edge(a1, a2, s));
  return {place_on_edge(a1, a2, point_on_edge(b1, b2, t)), t};
}

// The common refinement of two surfaces, triangulated, with the places of its vertices on both.
struct Overlay_arrays
{
  std::array<std::vector<Vector_3d>, 2> points; // on each surface
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> parents; // of the triangles, on each surface

  // Returns what Sphere_overlay does.
  template <class K>
  Error_code assign(const Sphere_triangulation<K>& sphere1, const std::vector<Vector_3d>& points1,
                    const Sphere_triangulation<K>& sphere2, const std::vector<Vector_3d>& points2,
                    std::size_t max_vertices, Run_control& control, const Execution& execution)
  {
    Sphere_overlay<K> cells(max_vertices);
    if(const Error_code error = cells.assign(sphere1, sphere2, control, execution))
      return error;
    const std::size_t n = cells.number_of_vertices(), n1 = points1.size(), n2 = points2.size();
    points[0] = points1;
    points[0].resize(n);
    points[1].resize(n1);
    points[1].insert(points[1].end(), points2.begin(), points2.end());
    points[1].resize(n);
    constexpr std::size_t block_size = 1024; // of parallel work: enough that handing it out costs nothing
    const auto locate = [&](const auto& of, const auto& places, const auto& in, const auto& values, Vector_3d* out) {
      for_each_block(execution, 0, places.size(), block_size, [&](std::size_t begin, std::size_t end) {
        for(std::size_t v = begin; v < end; ++v)
          out[v] = interpolated(values, in.triangles(), in.locate_from(places[v], of.points()[v]));
      });
    };
    locate(sphere1, cells.places_of_first(), sphere2, points2, points[1].data());
    locate(sphere2, cells.places_of_second(), sphere1, points1, points[0].data() + n1);
    const Triangle_sides sides1(sphere1.triangles()), sides2(sphere2.triangles());
    const auto xyz = [](const typename K::Point_3& p) { return Vector_3d{p.x(), p.y(), p.z()}; };
    for_each_block(execution, 0, cells.crossings().size(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
      {
        const auto [e, f] = cells.crossings()[k];
        const std::size_t v1 = sides1.source(e), w1 = sides1.target(e), v2 = sides2.source(f), w2 = sides2.target(f);
        const auto [s, t] = crossing_places(xyz(sphere1.points()[v1]), xyz(sphere1.points()[w1]),
                                            xyz(sphere2.points()[v2]), xyz(sphere2.points()[w2]));
        points[0][n1 + n2 + k] = point_on_edge(points1[v1], points1[w1], s);
        points[1][n1 + n2 + k] = point_on_edge(points2[v2], points2[w2], t);
      }
    });
    if(!control.go_further(0, 0.))
      return ERROR_STOPPED;
    std::size_t begin = 0;
    for(const auto& cell : cells.cells())
    {
      for(std::size_t k = begin + 2; k < cell.end; ++k)
      {
        triangles.push_back({cells.corners()[begin], cells.corners()[k - 1], cells.corners()[k]});
        parents.push_back(cell.parents);
      }
      begin = cell.end;
    }
    return OK;
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H
