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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_FILL_HOLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_FILL_HOLES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/Spherical_parameterization/internal/run/maximum_number.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationRepair
///
/// A hole of a surface and the hole patch that fills it, computed by `fill_holes()`.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`
template <class TriangleMesh>
struct Filled_hole
{
  /// Vertex descriptor type
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// Face descriptor type
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  vertex_descriptor vertex = boost::graph_traits<TriangleMesh>::null_vertex(); ///< a vertex of the border
  std::size_t number_of_edges = 0;                                             ///< the number of edges of the border
  double perimeter = 0.; ///< the length of the border, in the unit of the mesh
  double share = 0.;     ///< the fraction of the area of the closed surface that is covered by the patch, from 0 to 1
  std::vector<face_descriptor> faces; ///< the faces of the patch; empty if the hole is not filled
};

namespace internal {

// Triangles of hole patches. The patch of border k begins at triangle first[k].
struct Border_patches
{
  std::vector<Vector_3d> points; // new vertices, numbered after those of the surface
  Index_triangles triangles;
  std::vector<std::size_t> first;
};

// The sides on a border. Side 3 t + i of triangle t goes from corner i to the next corner.
using Border_sides = std::vector<std::uint32_t>;

// `mates` has the opposite side of each side, or none for a side on a border.
Border_patches close_borders(const Index_triangles& triangles, const std::vector<std::uint32_t>& mates,
                             std::vector<Vector_3d> points, const std::vector<Border_sides>& borders);

// The implementation of fill_holes().
template <class TriangleMesh, class VertexPointMap>
class Hole_closer
{
public:
  using Hole = Filled_hole<TriangleMesh>;

  Hole_closer(TriangleMesh& tmesh, const VertexPointMap& vpm)
    : m_mesh(tmesh)
    , m_points(vpm)
  {}

  Error_code fill(std::vector<Hole>& holes, std::size_t max_edges)
  {
    holes.clear();
    if(faces(m_mesh).begin() == faces(m_mesh).end())
      return OK;
    Mesh_arrays<TriangleMesh> arrays;
    if(const Error_code error = arrays.read(m_mesh, true))
      return error;
    const std::vector<Vector_3d> points = read_points(arrays.vertices_of_mesh, m_points);
    if(!are_finite(points))
      return ERROR_NON_FINITE_COORDINATE;
    number_sides();
    std::vector<Border_sides> borders;
    if(!find_borders(holes, borders))
    {
      holes.erase(holes.begin(), holes.end() - 1);
      return ERROR_NO_SIMPLICIAL_COMPLEX;
    }
    std::vector<Border_sides> to_close;
    for(std::size_t k = 0; k < holes.size(); ++k)
      if(holes[k].number_of_edges <= max_edges)
        to_close.push_back(borders[k]);
    add_faces(arrays, close_borders(arrays.triangles, mates(), points, to_close), max_edges, holes);
    measure(holes);
    return OK;
  }

private:
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Sides = typename boost::property_map<TriangleMesh, CGAL::dynamic_halfedge_property_t<std::uint32_t>>::type;
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  // Numbers the halfedges as sides of triangles, in the numbering of Mesh_arrays.
  void number_sides()
  {
    m_side_of = get(CGAL::dynamic_halfedge_property_t<std::uint32_t>(), m_mesh);
    for(const halfedge_descriptor h : halfedges(m_mesh))
      put(m_side_of, h, none);
    for(const face_descriptor f : faces(m_mesh))
      for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        put(m_side_of, h, m_number_of_sides++);
  }

  std::vector<std::uint32_t> mates() const
  {
    std::vector<std::uint32_t> result(m_number_of_sides);
    for(const halfedge_descriptor h : halfedges(m_mesh))
      if(get(m_side_of, h) != none)
        result[get(m_side_of, h)] = get(m_side_of, opposite(h, m_mesh));
    return result;
  }

  // Finds all borders and their properties. Returns false if a border meets itself or another one; the last hole then
  // has the common vertex.
  bool find_borders(std::vector<Hole>& holes, std::vector<Border_sides>& borders) const
  {
    const auto is_seen = get(CGAL::dynamic_vertex_property_t<bool>(), m_mesh);
    for(const vertex_descriptor v : vertices(m_mesh))
      put(is_seen, v, false);
    const auto is_seen_border = get(CGAL::dynamic_halfedge_property_t<bool>(), m_mesh);
    for(const halfedge_descriptor h : halfedges(m_mesh))
      put(is_seen_border, h, !is_border(h, m_mesh));
    for(const halfedge_descriptor first : halfedges(m_mesh))
    {
      if(get(is_seen_border, first))
        continue;
      holes.emplace_back();
      holes.back().vertex = target(first, m_mesh);
      borders.emplace_back();
      for(const halfedge_descriptor h : halfedges_around_face(first, m_mesh))
      {
        const vertex_descriptor v = target(h, m_mesh);
        put(is_seen_border, h, true);
        if(get(is_seen, v))
        {
          holes.back().vertex = v;
          return false;
        }
        put(is_seen, v, true);
        borders.back().push_back(get(m_side_of, opposite(h, m_mesh)));
        const Vector_3d edge = rounded(get(m_points, v)) - rounded(get(m_points, source(h, m_mesh)));
        holes.back().perimeter += hypotenuse(edge[0], edge[1], edge[2]);
      }
      std::reverse(borders.back().begin(), borders.back().end()); // sides are opposite to the border halfedges
      holes.back().number_of_edges = borders.back().size();
      if(holes.back().number_of_edges < 3)
        return false;
    }
    return true;
  }

  void add_faces(const Mesh_arrays<TriangleMesh>& arrays, const Border_patches& patches, std::size_t max_edges,
                 std::vector<Hole>& holes)
  {
    std::vector<vertex_descriptor> all = arrays.vertices_of_mesh;
    using FT = typename Kernel_traits<Point>::Kernel::FT;
    for(const Vector_3d& p : patches.points)
    {
      all.push_back(add_vertex(m_mesh));
      put(m_points, all.back(), Point(FT(p[0]), FT(p[1]), FT(p[2])));
    }
    std::vector<std::array<vertex_descriptor, 3>> corners;
    for(const auto& [a, b, c] : patches.triangles)
      corners.push_back({all[a], all[b], all[c]});
    Euler::add_faces(corners, m_mesh);
    std::size_t patch = 0;
    for(Hole& hole : holes)
      if(hole.number_of_edges <= max_edges)
      {
        for(std::size_t t = patches.first[patch]; t < patches.first[patch + 1]; ++t)
          hole.faces.push_back(face(halfedge(corners[t][0], corners[t][1], m_mesh).first, m_mesh));
        ++patch;
      }
  }

  void measure(std::vector<Hole>& holes) const
  {
    std::vector<Vector_3d> points;
    const auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), m_mesh);
    for(const vertex_descriptor v : vertices(m_mesh))
      if(halfedge(v, m_mesh) != Traits::null_halfedge())
      {
        put(index, v, points.size());
        points.push_back(rounded(get(m_points, v)));
      }
    normalize(points);
    const auto point = [&](vertex_descriptor v) { return points[get(index, v)]; };
    const auto area_of = [&](face_descriptor f) {
      const halfedge_descriptor h = halfedge(f, m_mesh);
      return 0.5 *
             doubled_area(point(source(h, m_mesh)), point(target(h, m_mesh)), point(target(next(h, m_mesh), m_mesh)));
    };
    double area = 0.;
    for(const face_descriptor f : faces(m_mesh))
      area += area_of(f);
    for(Hole& hole : holes)
      for(const face_descriptor f : hole.faces)
        hole.share += area > 0. ? area_of(f) / area : 0.;
  }

  TriangleMesh& m_mesh;
  VertexPointMap m_points;
  Sides m_side_of;
  std::uint32_t m_number_of_sides = 0;
};

} // namespace internal

/// \ingroup PkgSphericalParameterizationRepair
///
/// fills the holes of a surface, so that it can be mapped to a sphere.
///
/// Vertices and faces of the mesh do not change. Each hole receives a hole patch: triangles between the vertices of its
/// border, refined to the edge lengths around the hole. Patch faces may intersect other faces, which does not affect
/// the map to the sphere.
///
/// A bijective map of the closed surface, restricted to the original vertices and faces, is an injective map of the
/// surface with holes.
///
/// The running time is quasi-linear in the size of the closed surface. A patch can have a number of faces that is
/// quadratic in the number of edges of its hole.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface, a triangle mesh
/// \param holes receives all holes; holes with more edges than `maximum_number` are not filled and have no faces
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the maximum number of edges of a hole to be filled}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`, which also accepts new vertices}
///     \cgalParamType{a class model of `ReadWritePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; `ERROR_NO_SIMPLICIAL_COMPLEX` if a border meets itself or another border at a vertex, which is the
///         vertex of the only hole that is then reported; `ERROR_NON_TRIANGULAR_MESH`; `ERROR_TOO_LARGE_MESH`; or
///         `ERROR_NON_FINITE_COORDINATE`. On an error, the mesh is unchanged.
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code fill_holes(TriangleMesh& tmesh, std::vector<Filled_hole<TriangleMesh>>& holes,
                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  const std::size_t max_edges = internal::maximum_number_of(np).value_or((std::numeric_limits<std::size_t>::max)());
  const auto vpm = internal::vertex_point_map_of(tmesh, np);
  return internal::Hole_closer<TriangleMesh, std::decay_t<decltype(vpm)>>(tmesh, vpm).fill(holes, max_edges);
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Repair/internal/fill_holes_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_FILL_HOLES_H
