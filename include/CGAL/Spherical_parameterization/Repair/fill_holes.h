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
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/maximum_number.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/utility.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// A hole of a surface, and what `fill_holes()` has filled it with.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`
template <class TriangleMesh>
struct Filled_hole
{
  /// Vertex descriptor type
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// Face descriptor type
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  vertex_descriptor vertex = boost::graph_traits<TriangleMesh>::null_vertex(); ///< one of its border
  std::size_t number_of_edges = 0;                                             ///< of its border
  double perimeter = 0.;              ///< the length of its border, in the unit of the mesh
  double share = 0.;                  ///< of its faces in the area of the closed surface, from 0 to 1
  std::vector<face_descriptor> faces; ///< new ones, none if the hole has been left open
};

namespace internal {

// Fills the holes of a mesh; see fill_holes().
template <class TriangleMesh, class VertexPointMap>
class Hole_filler
{
public:
  using Hole = Filled_hole<TriangleMesh>;

  Hole_filler(TriangleMesh& tmesh, const VertexPointMap& vpm)
    : m_mesh(tmesh)
    , m_points(vpm)
  {}

  Error_code fill(std::vector<Hole>& holes, std::size_t max_edges)
  {
    holes.clear();
    m_unit = 0.;
    for(const vertex_descriptor v : vertices(m_mesh))
      if(halfedge(v, m_mesh) != Traits::null_halfedge())
      {
        const Vector_3d p = point(v);
        if(!is_finite(p))
          return ERROR_NON_FINITE_COORDINATE;
        m_unit = (std::max)({m_unit, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
      }
    const std::vector<halfedge_descriptor> borders = find_borders(holes);
    if(borders.size() < holes.size())
    {
      holes.erase(holes.begin(), holes.end() - 1);
      return ERROR_NO_SIMPLICIAL_COMPLEX;
    }
    double area = total_area(faces(m_mesh));
    for(std::size_t k = 0; k < holes.size(); ++k)
      if(holes[k].number_of_edges <= max_edges)
      {
        fill(borders[k], holes[k].faces);
        holes[k].share = total_area(holes[k].faces);
        area += holes[k].share;
      }
    for(Hole& hole : holes)
      hole.share = area > 0. ? hole.share / area : 0.;
    return OK;
  }

private:
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Exact_point = Exact_predicates_inexact_constructions_kernel::Point_3;

  Vector_3d point(vertex_descriptor v) const { return rounded(get(m_points, v)); }

  // the same in a unit for which squares are in the range of doubles
  Vector_3d scaled_point(vertex_descriptor v) const
  {
    Vector_3d p = point(v);
    if(m_unit > 0.)
      p = {p[0] / m_unit, p[1] / m_unit, p[2] / m_unit}; // the inverse of a subnormal unit is infinite
    return p;
  }

  template <class Faces>
  double total_area(const Faces& range) const
  {
    double result = 0.;
    for(const face_descriptor f : range)
    {
      std::vector<Vector_3d> p;
      for(const vertex_descriptor v : vertices_around_face(halfedge(f, m_mesh), m_mesh))
        p.push_back(scaled_point(v));
      for(std::size_t k = 2; k < p.size(); ++k)
        result += 0.5 * length(cross(p[k - 1] - p[0], p[k] - p[0]));
    }
    return result;
  }

  // Finds all borders, and what is told of them. Returns a halfedge of each; one less if the last one meets itself or another
  // one, in its vertex.
  std::vector<halfedge_descriptor> find_borders(std::vector<Hole>& holes) const
  {
    std::vector<halfedge_descriptor> result;
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
      double perimeter = 0.;
      for(const halfedge_descriptor h : halfedges_around_face(first, m_mesh))
      {
        const vertex_descriptor v = target(h, m_mesh);
        put(is_seen_border, h, true);
        if(get(is_seen, v))
        {
          holes.back().vertex = v;
          return result;
        }
        put(is_seen, v, true);
        ++holes.back().number_of_edges;
        perimeter += length(scaled_point(v) - scaled_point(source(h, m_mesh)));
      }
      holes.back().perimeter = m_unit > 0. ? m_unit * perimeter : perimeter;
      if(holes.back().number_of_edges < 3)
        return result;
      result.push_back(first);
    }
    return result;
  }

  // Fills one hole, by triangles between its vertices, which are refined; or else by a vertex in the middle, which always can
  // be joined to them.
  void fill(halfedge_descriptor border, std::vector<face_descriptor>& new_faces)
  {
    std::vector<vertex_descriptor> corners;
    for(const halfedge_descriptor h : halfedges_around_face(border, m_mesh))
      corners.push_back(target(h, m_mesh));
    const std::vector<Triple<int, int, int>> triangles =
        is_lone_triangle(border) ? std::vector<Triple<int, int, int>>() : triangulation(corners);
    if(triangles.empty())
      fill_with_star(border, corners, new_faces);
    else
      for(const auto& t : triangles)
        new_faces.push_back(
            Euler::add_face(std::array<vertex_descriptor, 3>{corner(corners, t.first), corner(corners, t.second),
                                                             corner(corners, t.third)},
                            m_mesh));
    if(!can_be_squared())
      return;
    std::vector<face_descriptor> more;
    Polygon_mesh_processing::refine(m_mesh, std::vector<face_descriptor>(new_faces), std::back_inserter(more),
                                    Emptyset_iterator(), parameters::vertex_point_map(m_points));
    new_faces.insert(new_faces.end(), more.begin(), more.end());
  }

  // A triangle on its other side would be no surface.
  bool is_lone_triangle(halfedge_descriptor border) const
  {
    const auto other_face = [&](halfedge_descriptor h) { return face(opposite(h, m_mesh), m_mesh); };
    const halfedge_descriptor second = next(border, m_mesh), third = next(second, m_mesh);
    return next(third, m_mesh) == border && other_face(border) == other_face(second) &&
           other_face(border) == other_face(third);
  }

  // Whether products of six lengths are in the range of doubles, as they are computed with on the way.
  bool can_be_squared() const { return m_unit < 1e50 && m_unit > 1e-50; }

  static vertex_descriptor corner(const std::vector<vertex_descriptor>& corners, int k)
  {
    return corners[static_cast<std::size_t>(k)];
  }

  // Triangles between the vertices of a border; none if there are none, or if an edge between them is there already.
  std::vector<Triple<int, int, int>> triangulation(const std::vector<vertex_descriptor>& corners) const
  {
    constexpr std::size_t max_edges_for_search = 200; // beyond Delaunay triangulations, by the third power: 0.1 s
    std::vector<Triple<int, int, int>> result;
    if(!can_be_squared())
      return result;
    std::vector<Exact_point> points;
    for(const vertex_descriptor v : corners)
    {
      const Vector_3d p = scaled_point(v);
      points.emplace_back(p[0], p[1], p[2]);
    }
    if(points.size() == 3)
      result.emplace_back(0, 1, 2);
    else
      Polygon_mesh_processing::triangulate_hole_polyline(
          points, std::back_inserter(result),
          parameters::do_not_use_cubic_algorithm(points.size() > max_edges_for_search));
    const int n = static_cast<int>(corners.size());
    const auto is_taken = [&](int i, int j) {
      const bool is_of_border = j == i + 1 || (i == 0 && j == n - 1);
      return !is_of_border && halfedge(corner(corners, i), corner(corners, j), m_mesh).second;
    };
    if(result.size() + 2 != corners.size() || std::any_of(result.begin(), result.end(), [&](const auto& t) {
         return is_taken(t.first, t.second) || is_taken(t.second, t.third) || is_taken(t.first, t.third);
       }))
      result.clear();
    return result;
  }

  void fill_with_star(halfedge_descriptor border, const std::vector<vertex_descriptor>& corners,
                      std::vector<face_descriptor>& new_faces)
  {
    Vector_3d sum = {0., 0., 0.};
    for(const vertex_descriptor v : corners)
      sum = sum + (1. / static_cast<double>(corners.size())) * point(v);
    Euler::fill_hole(border, m_mesh);
    const halfedge_descriptor spoke = Euler::add_center_vertex(border, m_mesh);
    const vertex_descriptor middle = target(spoke, m_mesh);
    using FT = typename Kernel_traits<Point>::Kernel::FT;
    put(m_points, middle, Point(FT(sum[0]), FT(sum[1]), FT(sum[2])));
    for(const halfedge_descriptor h : halfedges_around_target(spoke, m_mesh))
      new_faces.push_back(face(h, m_mesh));
  }

  TriangleMesh& m_mesh;
  VertexPointMap m_points;
  double m_unit = 0.; // the largest coordinate
};

} // namespace internal

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// fills the holes of a surface, so that it can be mapped to a sphere. Vertices and faces stay what they are, and new ones are
/// added: triangles between the vertices of the border, refined to the edge lengths around the hole, by
/// `CGAL::Polygon_mesh_processing`; or, if these are not possible without an edge that is there already, a vertex in the middle of
/// the border with an edge to each of its vertices. New faces may intersect others, which is of no consequence for a map.
///
/// What the map of the closed surface says of the vertices that were there before is a one-to-one map of the surface with holes.
///
/// It takes time linear in the size of the mesh, and for each hole of \f$ k \f$ edges about that of a Delaunay triangulation of
/// \f$ k \f$ points.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface, a triangle mesh
/// \param holes receives all holes; those with more edges than `maximum_number` have no faces
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the largest number of edges of a hole that is filled}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{any}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`, with room for new ones}
///     \cgalParamType{a class model of `ReadWritePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; `ERROR_NO_SIMPLICIAL_COMPLEX` if a border meets itself or another one in a vertex, which is that of the only
///         hole that is told of then; or `ERROR_NON_FINITE_COORDINATE`. But for `OK`, the mesh is as it was.
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code fill_holes(TriangleMesh& tmesh, std::vector<Filled_hole<TriangleMesh>>& holes,
                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  const std::size_t max_edges = internal::maximum_number_of(np).value_or((std::numeric_limits<std::size_t>::max)());
  const auto vpm = internal::vertex_point_map_of(tmesh, np);
  return internal::Hole_filler<TriangleMesh, std::decay_t<decltype(vpm)>>(tmesh, vpm).fill(holes, max_edges);
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_FILL_HOLES_H
