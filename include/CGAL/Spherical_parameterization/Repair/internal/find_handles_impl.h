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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_FIND_HANDLES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_FIND_HANDLES_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Repair/find_handles.h>
#include <CGAL/Spherical_parameterization/Repair/internal/Border_closer.h>
#include <CGAL/Spherical_parameterization/Repair/internal/Handle_cycles.h>

#include <cmath>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE std::vector<Handle_cycle> find_handle_cycles(const Index_triangles& triangles,
                                                                                    std::vector<Vector_3d> points,
                                                                                    std::size_t max_handles)
{
  const int exponent = normalize(points);
  const std::vector<Linked_triangle> linked = link_triangles(triangles, points.size());
  Repaired_triangles mesh(Glued_triangles(triangles, linked), std::move(points));
  Border_closer closer(mesh);
  std::vector<Handle_cycle> result;
  cut_handles(
      mesh, max_handles,
      [&](const Handle_cycles::Cycle& cycle, double length) {
        result.push_back({{}, std::ldexp(length, exponent)});
        for(const Glued_triangles::Index side : cycle)
          result.back().vertices.push_back(mesh.vertices[mesh.surface.source(side)]);
      },
      [&](const std::vector<Glued_triangles::Index>& border) { closer.close(border); });
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_FIND_HANDLES_IMPL_H
