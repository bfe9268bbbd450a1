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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_OVERLAY_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_OVERLAY_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

/// \file Surface_overlay_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// The common refinement of two surfaces that have maps to the same sphere, as `overlay()` makes it: triangles, each of
/// which is a part of one face of the first surface and of one face of the second. It is closed: with `points` of either
/// surface, `triangles` are that surface; and what is between the two points of a vertex is a morph.
///
/// \tparam TriangleMesh1 a model of `FaceListGraph`
/// \tparam TriangleMesh2 a model of `FaceListGraph`
template <class TriangleMesh1, class TriangleMesh2>
struct Surface_overlay_3
{
  /// Type of the points
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

  /// For each vertex, its places on the first surface and on the second one
  std::vector<std::array<Point_3, 2>> points;

  /// The vertices of each triangle, counterclockwise as seen from outside
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// For each triangle, the face of the first surface and that of the second one which it is a part of
  std::vector<std::pair<typename boost::graph_traits<TriangleMesh1>::face_descriptor,
                        typename boost::graph_traits<TriangleMesh2>::face_descriptor>>
      faces;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_OVERLAY_3_H
