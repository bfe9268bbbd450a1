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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_REPAIR_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_REPAIR_SURFACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Kernel_traits.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationRepair
///
/// What `repair_surface()` may do. Lengths are in units of the square root of the area of the surface.
struct Repair_limits
{
  double maximum_hole =
      (std::numeric_limits<double>::infinity)(); ///< the length of the border of a hole that is filled
  double maximum_handle =
      (std::numeric_limits<double>::infinity)(); ///< the length of the cycle that a handle is cut along
  double maximum_added_area = 0.05;              ///< all that is added over the area of the result, from 0 to 1
  bool refines_patches =
      true; ///< whether the triangles of what is added are about as large as their neighbours; or as few as can be
};

/// \ingroup PkgSphericalParameterizationRepair
///
/// How often something was found in a surface, and where first.
struct Repair_count
{
  std::size_t number = 0; ///< how often
  std::size_t first = 0;  ///< the first polygon or vertex, if there is any

  /// counts one more.
  ///
  /// \param where the polygon or vertex
  void add(std::size_t where)
  {
    if(number++ == 0)
      first = where;
  }
};

/// \ingroup PkgSphericalParameterizationRepair
///
/// A part that was added to a surface, to close a hole or one side of a cut through a handle.
struct Repair_patch
{
  bool is_of_handle = false;       ///< or of a hole
  std::size_t vertex = 0;          ///< one of its border, as a vertex of the input
  std::size_t number_of_edges = 0; ///< of its border
  double length = 0.;              ///< of its border, in the unit of the surface
  double share = 0.;               ///< of its triangles in the area of the result, from 0 to 1
};

/// \ingroup PkgSphericalParameterizationRepair
///
/// What `repair_surface()` found and did, in this order.
struct Repair_report
{
  Repair_count triangulated_polygons;   ///< with more than three corners; `first` is a polygon
  Repair_count degenerate_faces;        ///< with less than three different corners, which were removed
  Repair_count repeated_faces;          ///< with the corners of another one, which were removed
  Repair_count merged_vertices;         ///< of borders, at the same point as another one; `first` is a vertex
  Repair_count reversed_faces;          ///< that were oriented against the others
  Repair_count non_manifold_edges;      ///< with more than two faces; `first` is one of its vertices
  Repair_count divided_vertices;        ///< that more than one fan of faces met in, and are several vertices now
  std::size_t number_of_components = 1; ///< of which the largest was kept
  Repair_count removed_faces;           ///< those of the other components
  std::vector<std::vector<std::size_t>> handle_cycles; ///< that handles were cut along, as vertices of the input
  std::vector<Repair_patch> patches;                   ///< what was added
  Repair_count split_edges;                            ///< of several that joined the same two vertices
  double added_area = 0.;                              ///< of the patches over that of the result, from 0 to 1

  /// English sentences: what keeps the surface from being repaired, where, and what to do about it. Vertices and polygons are
  /// counted from 0.
  std::string message;

  /// returns whether the surface needed nothing.
  bool is_empty() const
  {
    return triangulated_polygons.number + degenerate_faces.number + repeated_faces.number + merged_vertices.number +
               reversed_faces.number + non_manifold_edges.number + divided_vertices.number + removed_faces.number +
               patches.size() + split_edges.number ==
           0;
  }
};

/// \ingroup PkgSphericalParameterizationRepair
///
/// A surface that can be parameterized, and where its parts come from.
///
/// \tparam Point a `%Point_3` of a \cgal kernel
template <class Point>
struct Repaired_surface
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)(); ///< no vertex or polygon

  std::vector<Point> points;                         ///< the vertices
  std::vector<std::array<std::size_t, 3>> triangles; ///< the faces, by their vertices
  std::vector<std::size_t> source_vertices;          ///< which vertex of the input each vertex is, or `none`
  std::vector<std::size_t> source_faces; ///< which polygon of the input each triangle is a part of, or `none`
};

namespace internal {

// Polygon f has the corners first[f] to first[f + 1] - 1.
struct Polygon_corners
{
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> first = {0};
};

struct Repaired_arrays
{
  std::vector<Vector_3d> points;
  Index_triangles triangles;
  std::vector<std::uint32_t> source_vertices, source_faces;
};

Error_code repair_arrays(std::vector<Vector_3d> points, const Polygon_corners& polygons, const Repair_limits& limits,
                         Repaired_arrays& result, Repair_report& report);

} // namespace internal

/// \ingroup PkgSphericalParameterizationRepair
///
/// makes a surface that can be parameterized of any polygons: closed, connected, of genus 0, and a simplicial complex. Each step is
/// taken only where it is needed:
///
/// 1. Polygons are triangulated; those with less than three different corners are removed, and those that are there already.
/// 2. Vertices on borders that are at the same point become one.
/// 3. Faces are reversed such that those with an edge in common are oriented alike, as most of the area of each component is.
/// 4. Where an edge has more than two faces, or a vertex more than one fan of faces, it becomes several.
/// 5. The component of the largest area is kept.
/// 6. Holes are filled.
/// 7. Handles are cut along short non-separating cycles of edges, and both sides of each cut are filled. Of the cycles of a handle,
///    such as across a thin neck and along the rim of the tunnel under it, the one that adds less area is taken.
/// 8. Of several edges between the same two vertices, all but one are divided.
///
/// Points of the input are not moved; triangles may intersect each other, which does not matter to a map. The vertices and faces that
/// are kept are in the order of the input, and those that are new are behind them. A surface that needs nothing is returned as it is.
///
/// The running time is quasi-linear in the size of input and result.
///
/// \tparam PointRange a range of `%Point_3` of a \cgal kernel, with random access
/// \tparam PolygonRange a range of ranges of integers
/// \tparam Point the type of the points
///
/// \param points the vertices
/// \param polygons the vertices of each face, in order around it
/// \param result the repaired surface; empty if there is an error
/// \param report what was found and done
/// \param limits what may be done
///
/// \return `OK` or what keeps the surface from being repaired, which `report.message` explains: `ERROR_EMPTY_MESH`,
///         `ERROR_NON_FINITE_COORDINATE`, `ERROR_WRONG_PARAMETER` if a corner is no vertex or a limit is negative, `ERROR_TOO_LARGE_MESH`,
///         `ERROR_NON_CLOSED_MESH` or `ERROR_NO_TOPOLOGICAL_SPHERE` if holes or handles are beyond the limits, or
///         `ERROR_TOO_FEW_VERTICES`
template <class PointRange, class PolygonRange, class Point>
Error_code repair_surface(const PointRange& points, const PolygonRange& polygons, Repaired_surface<Point>& result,
                          Repair_report& report, const Repair_limits& limits = Repair_limits())
{
  result = Repaired_surface<Point>();
  report = Repair_report();
  constexpr std::size_t max_size = (std::numeric_limits<std::int32_t>::max)() / 8; // of vertices, and of corners
  std::vector<internal::Vector_3d> rounded_points;
  for(const auto& p : points)
    rounded_points.push_back(internal::rounded(p));
  internal::Polygon_corners corners;
  for(const auto& polygon : polygons)
  {
    for(const auto v : polygon)
    {
      if(v < 0 || static_cast<std::size_t>(v) >= rounded_points.size())
      {
        report.message = "face " + std::to_string(corners.first.size() - 1) + " has the vertex " + std::to_string(v) +
                         ", but there are only " + std::to_string(rounded_points.size());
        return ERROR_WRONG_PARAMETER;
      }
      corners.corners.push_back(static_cast<std::uint32_t>(v));
    }
    corners.first.push_back(corners.corners.size());
  }
  if(rounded_points.size() > max_size || corners.corners.size() > max_size)
  {
    report.message = get_error_message(ERROR_TOO_LARGE_MESH);
    return ERROR_TOO_LARGE_MESH;
  }
  internal::Repaired_arrays arrays;
  if(const Error_code error = internal::repair_arrays(std::move(rounded_points), corners, limits, arrays, report))
    return error;
  constexpr std::size_t none = Repaired_surface<Point>::none;
  const auto index_of = [](std::uint32_t i) {
    return i == (std::numeric_limits<std::uint32_t>::max)() ? none : std::size_t(i);
  };
  using FT = typename Kernel_traits<Point>::Kernel::FT;
  for(std::size_t v = 0; v < arrays.points.size(); ++v)
  {
    const internal::Vector_3d& p = arrays.points[v];
    result.source_vertices.push_back(index_of(arrays.source_vertices[v]));
    result.points.push_back(result.source_vertices[v] == none
                                ? Point(FT(p[0]), FT(p[1]), FT(p[2]))
                                : *std::next(points.begin(), static_cast<std::ptrdiff_t>(result.source_vertices[v])));
  }
  for(std::size_t t = 0; t < arrays.triangles.size(); ++t)
  {
    const auto [a, b, c] = arrays.triangles[t];
    result.triangles.push_back({a, b, c});
    result.source_faces.push_back(index_of(arrays.source_faces[t]));
  }
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Repair/internal/repair_surface_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_REPAIR_SURFACE_H
