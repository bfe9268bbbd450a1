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
/// Limits for `repair_surface()`. Lengths are in units of the square root of the area of the surface.
struct Repair_limits
{
  double maximum_hole =
      (std::numeric_limits<double>::infinity)(); ///< maximum length of the border of a hole to be filled
  double maximum_handle =
      (std::numeric_limits<double>::infinity)(); ///< maximum length of a cycle along which a handle is cut
  double maximum_added_area = 0.05; ///< maximum ratio of the area of all patches to the area of the result, from 0 to 1
  bool refines_patches =
      true; ///< whether patches are refined to the size of neighboring triangles, or have as few triangles as possible
};

/// \ingroup PkgSphericalParameterizationRepair
///
/// The number of defects of one kind, and the first one.
struct Repair_count
{
  std::size_t number = 0; ///< the number of defects
  std::size_t first = 0;  ///< the first polygon or vertex; 0 if there is none

  /// adds a defect.
  ///
  /// \param where its polygon or vertex
  void add(std::size_t where)
  {
    if(number++ == 0)
      first = where;
  }
};

/// \ingroup PkgSphericalParameterizationRepair
///
/// A patch added to a surface, to fill a hole or one side of a cut through a handle.
struct Repair_patch
{
  bool is_of_handle = false;       ///< whether it fills a cut through a handle, or a hole
  std::size_t vertex = 0;          ///< a vertex of its border, as a vertex of the input
  std::size_t number_of_edges = 0; ///< the number of edges of its border
  double length = 0.;              ///< the length of its border, in the unit of the surface
  double share = 0.;               ///< its fraction of the area of the result, from 0 to 1
};

/// \ingroup PkgSphericalParameterizationRepair
///
/// The defects found and repairs made by `repair_surface()`, in the order of its steps.
struct Repair_report
{
  Repair_count triangulated_polygons; ///< polygons with more than three corners; `first` is a polygon
  Repair_count degenerate_faces;      ///< removed faces with fewer than three distinct corners
  Repair_count repeated_faces;        ///< removed faces with the same corners as another face
  Repair_count merged_vertices;    ///< border vertices merged with another one at the same point; `first` is a vertex
  Repair_count reversed_faces;     ///< faces whose orientation was reversed
  Repair_count non_manifold_edges; ///< edges with more than two faces; `first` is one of its vertices
  Repair_count divided_vertices;   ///< vertices added so that each vertex has one fan of faces
  std::size_t number_of_components = 1;                ///< connected components, of which the largest was kept
  Repair_count removed_faces;                          ///< faces of the removed components
  std::vector<std::vector<std::size_t>> handle_cycles; ///< cycles of the cuts through handles, as vertices of the input
  std::vector<Repair_patch> patches;                   ///< the added patches
  Repair_count split_edges; ///< edges that were split because others connected the same two vertices
  double added_area = 0.;   ///< ratio of the area of the patches to that of the result, from 0 to 1

  /// English sentences that state why the surface cannot be repaired, the location, and a remedy. Vertices and polygons
  /// are counted from 0.
  std::string message;

  /// returns whether no repair was necessary.
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
/// A repaired surface, which can be parameterized, and the source of its vertices and faces.
///
/// \tparam Point a `%Point_3` of a \cgal kernel
template <class Point>
struct Repaired_surface
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)(); ///< for elements without a source

  std::vector<Point> points;                         ///< the vertices
  std::vector<std::array<std::size_t, 3>> triangles; ///< the faces, as indices of vertices
  std::vector<std::size_t> source_vertices;          ///< for each vertex, the vertex of the input, or `none`
  std::vector<std::size_t> source_faces; ///< for each triangle, the polygon of the input that contains it, or `none`
};

namespace internal {

// The corners of polygon f are first[f] to first[f + 1] - 1.
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
/// repairs a surface given by any polygons, so that it can be parameterized. The result is closed, connected, of genus
/// 0, and a simplicial complex.
///
/// Steps that are not needed are skipped:
///
/// 1. Polygons are triangulated. Polygons with fewer than three distinct corners and duplicates are removed.
/// 2. Border vertices at the same point are merged.
/// 3. Faces are reversed so that adjacent faces have consistent orientations. Each component keeps the orientation of
///    most of its area. It is oriented outwards if no orientation has at least two thirds of the area.
/// 4. Edges with more than two faces and vertices with more than one fan of faces are split.
/// 5. The component with the largest area is kept.
/// 6. Holes are filled.
/// 7. Handles are cut along short non-separating cycles of edges, and both sides of each cut are filled. A handle has
///    several such cycles, for example across a thin neck and along the rim of the tunnel under it. Cycles whose
///    filling adds less area are preferred.
/// 8. If several edges connect the same two vertices, all but one of them are split.
///
/// Points of the input are not moved. Triangles may intersect each other, which does not affect the map to the sphere.
/// Kept vertices and faces are in the order of the input, followed by the new ones. A surface without defects is
/// returned unchanged.
///
/// The running time is quasi-linear in the size of the input and the result.
///
/// \tparam PointRange a range of `%Point_3` of a \cgal kernel, with random access
/// \tparam PolygonRange a range of ranges of integers
/// \tparam Point the type of the points
///
/// \param points the vertices
/// \param polygons the vertices of each face, in order around it
/// \param result the repaired surface; empty on an error
/// \param report the defects found and repairs made
/// \param limits limits of the repairs
///
/// \return `OK`, or an error that `report.message` explains: `ERROR_EMPTY_MESH`; `ERROR_NON_FINITE_COORDINATE`;
///         `ERROR_WRONG_PARAMETER` if a corner is not a vertex or a limit is negative; `ERROR_TOO_LARGE_MESH`;
///         `ERROR_NON_CLOSED_MESH` if holes exceed the limits; `ERROR_NO_TOPOLOGICAL_SPHERE` if handles exceed the
///         limits; or `ERROR_TOO_FEW_VERTICES`
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
