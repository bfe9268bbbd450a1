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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/overlay/Sphere_overlay.h>
#include <CGAL/Spherical_parameterization/internal/overlay/crossing_places.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

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
                    const Execution& execution)
  {
    Sphere_overlay<K> cells;
    if(const Error_code error = cells.assign(sphere1, sphere2, execution))
      return error;
    const std::size_t n = cells.number_of_vertices(), n1 = points1.size(), n2 = points2.size();
    points[0].resize(n);
    points[1].resize(n);
    const auto set = [&](std::size_t v, const Vector_3d& p, const Vector_3d& q) {
      points[0][v] = p;
      points[1][v] = q;
    };
    constexpr std::size_t block_size = 1024;
    for_each_block(execution, 0, n1, block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        set(v, points1[v],
            interpolated(points2, sphere2.triangles(),
                         sphere2.locate_from(cells.places_of_first()[v], sphere1.points()[v])));
    });
    for_each_block(execution, 0, n2, block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        set(n1 + v,
            interpolated(points1, sphere1.triangles(),
                         sphere1.locate_from(cells.places_of_second()[v], sphere2.points()[v])),
            points2[v]);
    });
    const Triangle_sides sides1(sphere1.triangles()), sides2(sphere2.triangles());
    for_each_block(execution, 0, cells.crossings().size(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
      {
        const std::size_t e = cells.crossings()[k][0], f = cells.crossings()[k][1];
        const auto [s, t] = crossing_places(
            coordinates_of(sphere1.points()[sides1.source(e)]), coordinates_of(sphere1.points()[sides1.target(e)]),
            coordinates_of(sphere2.points()[sides2.source(f)]), coordinates_of(sphere2.points()[sides2.target(f)]));
        set(n1 + n2 + k, point_on_edge(points1[sides1.source(e)], points1[sides1.target(e)], s),
            point_on_edge(points2[sides2.source(f)], points2[sides2.target(f)], t));
      }
    });
    std::size_t begin = 0;
    for(const auto& cell : cells.cells())
    {
      for(std::size_t k = begin + 2; k < cell.end; ++k)
      {
        triangles.push_back({cells.corners()[begin], cells.corners()[k - 1], cells.corners()[k]});
        parents.push_back({cell.parents[0], cell.parents[1]});
      }
      begin = cell.end;
    }
    return OK;
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H
