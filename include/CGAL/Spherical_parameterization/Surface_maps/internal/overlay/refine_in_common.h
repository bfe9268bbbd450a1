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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_REFINE_IN_COMMON_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_REFINE_IN_COMMON_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/Sphere_overlay.h>

#include <cmath>
#include <optional>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

inline Vector_3d point_on_edge(const Vector_3d& p, const Vector_3d& q, double t)
{
  return (1. - t) * p + t * q;
}

// The parameter from 0 to 1 of the point of the edge from p to q on the ray of r, which lies in or near the plane of the edge.
inline double parameter_on_edge(const Vector_3d& p, const Vector_3d& q, const Vector_3d& r)
{
  const Vector_3d n = cross(p, q);
  // p x r = t n and r x q = (1 - t) n for r = (1 - t) p + t q
  const double to_p = dot(cross(p, r), n), to_q = dot(cross(r, q), n);
  const double t = to_p / (to_p + to_q);
  return t > 0. ? (std::min)(t, 1.) : 0.;
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

// The parameters from 0 to 1 of the crossing of two edges: the numbers s and t for which (1 - s) a1 + s a2 and (1 - t) b1 + t b2 have the
// same direction. Edges that coincide up to rounding along an interval have no unique crossing, but the result is a common direction.
inline std::array<double, 2> crossing_parameters(Vector_3d a1, Vector_3d a2, Vector_3d b1, Vector_3d b2)
{
  scale_to_unit(a1, a2);
  scale_to_unit(b1, b2);
  const Vector_3d n = cross(b1, b2);
  // The signs differ, except for ties and rounding errors.
  const double d1 = std::abs(dot(n, a1)), d2 = std::abs(dot(n, a2));
  const double s = d1 + d2 > 0. ? d1 / (d1 + d2) : 0.5;
  const double t = parameter_on_edge(b1, b2, point_on_edge(a1, a2, s));
  return {parameter_on_edge(a1, a2, point_on_edge(b1, b2, t)), t};
}

// make_overlay() for spheres, which need no grid.
inline Error_code refine_in_common(const Sphere_mesh& sphere1, const std::vector<Vector_3d>& points1,
                                   const Sphere_mesh& sphere2, const std::vector<Vector_3d>& points2,
                                   std::optional<std::size_t> max_vertices, Overlay_arrays& overlay,
                                   Run_control& control, const Execution& execution)
{
  Sphere_overlay cells(max_vertices ? *max_vertices : Sphere_overlay::default_max_vertices(sphere1, sphere2));
  if(const Error_code error = cells.assign(sphere1, sphere2, control, execution))
    return error;
  auto& [on_first, on_second] = overlay.points;
  const std::size_t n = cells.number_of_vertices(), n1 = points1.size(), n2 = points2.size();
  on_first = points1;
  on_first.resize(n);
  on_second.resize(n1);
  on_second.insert(on_second.end(), points2.begin(), points2.end());
  on_second.resize(n);
  const auto locate = [&](const auto& of, const auto& triangles, const auto& in, const auto& values, Vector_3d* out) {
    for_each_in_blocks(execution, 0, triangles.size(), usual_block_size, [&](std::size_t v) {
      out[v] = interpolated(values, in.triangles(), in.locate_from(triangles[v], of.points()[v]));
    });
  };
  locate(sphere1, cells.triangles_of_first(), sphere2, points2, on_second.data());
  locate(sphere2, cells.triangles_of_second(), sphere1, points1, on_first.data() + n1);
  const Triangle_sides sides1(sphere1.triangles()), sides2(sphere2.triangles());
  const auto image = [](const Sphere_mesh& sphere, std::size_t v) {
    const auto& p = sphere.points()[v];
    return Vector_3d{p.x(), p.y(), p.z()};
  };
  for_each_in_blocks(execution, 0, cells.crossings().size(), usual_block_size, [&](std::size_t k) {
    const auto [e, f] = cells.crossings()[k];
    const std::size_t v1 = sides1.source(e), w1 = sides1.target(e), v2 = sides2.source(f), w2 = sides2.target(f);
    const auto [s, t] =
        crossing_parameters(image(sphere1, v1), image(sphere1, w1), image(sphere2, v2), image(sphere2, w2));
    overlay.points[0][n1 + n2 + k] = point_on_edge(points1[v1], points1[w1], s);
    overlay.points[1][n1 + n2 + k] = point_on_edge(points2[v2], points2[w2], t);
  });
  if(!control.go_further(0, 0.))
    return ERROR_STOPPED;
  std::size_t begin = 0;
  for(const auto& cell : cells.cells())
  {
    for(std::size_t k = begin + 2; k < cell.end; ++k)
    {
      overlay.triangles.push_back({cells.corners()[begin], cells.corners()[k - 1], cells.corners()[k]});
      overlay.parents.push_back(cell.parents);
    }
    begin = cell.end;
  }
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_OVERLAY_REFINE_IN_COMMON_H
