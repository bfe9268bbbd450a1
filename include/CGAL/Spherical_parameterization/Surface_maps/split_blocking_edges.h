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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPLIT_BLOCKING_EDGES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPLIT_BLOCKING_EDGES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// The class `Split_edge` describes an edge that `split_blocking_edges()` or `split_bent_faces()` has split at its midpoint.
/// Values at vertices and faces can be updated by processing the split edges in the order in which they are reported.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`
template <class TriangleMesh>
struct Split_edge
{
  /// Type of a vertex
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// Type of a face
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  vertex_descriptor vertex;              ///< The new vertex
  std::array<vertex_descriptor, 2> ends; ///< The ends of the edge
  std::array<face_descriptor, 2> faces;  ///< The new faces
  std::array<face_descriptor, 2>
      halved_faces; ///< For each new face, the face that was halved, which is now the other half
};

namespace internal {

// Returns whether the interiors of two arcs cross: then all four triangles have the same orientation. If one arc crosses the
// antipode of the other one, two of the orientations differ.
inline bool do_arcs_cross(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& d)
{
  const auto side = [](const Vector_3d& p, const Vector_3d& q, const Vector_3d& r) {
    const double determinant = dot(p, cross(q, r));
    return determinant > 0. ? 1 : determinant < 0. ? -1 : 0;
  };
  const int acb = side(a, c, b);
  return acb != 0 && side(c, b, d) == acb && side(b, d, a) == acb && side(d, a, c) == acb;
}

// Splits an edge and its image at their midpoints. The image may be the direction map. Does nothing and returns false if the
// faces that result from the split cannot be represented in double precision.
template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
bool split_edge_on_sphere(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, TriangleMesh& tmesh,
                          const VertexPointMap& points, const VertexSphereMap& vertex_sphere_map,
                          Split_edge<TriangleMesh>& split)
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  const auto middle = [](const auto& p, const auto& q) {
    return std::decay_t<decltype(p)>(p.x() / 2 + q.x() / 2, p.y() / 2 + q.y() / 2, p.z() / 2 + q.z() / 2);
  };
  const auto a = source(h, tmesh), b = target(h, tmesh);
  const auto point = middle(get(points, a), get(points, b));
  const auto image = middle(get(vertex_sphere_map, a), get(vertex_sphere_map, b));
  const Vector_3d m = direction_of(image), p = direction_of(get(vertex_sphere_map, a)),
                  q = direction_of(get(vertex_sphere_map, b));
  const auto holds = [&](const auto v, const Vector_3d& from, const Vector_3d& to) {
    const Vector_3d r = direction_of(get(vertex_sphere_map, v));
    return is_safely_positive(from, m, r) && is_safely_positive(m, to, r);
  };
  if(!holds(target(next(h, tmesh), tmesh), p, q) || !holds(target(next(opposite(h, tmesh), tmesh), tmesh), q, p))
    return false;
  const halfedge_descriptor first_half = CGAL::Euler::split_edge(h, tmesh), other = opposite(first_half, tmesh);
  put(points, target(first_half, tmesh), point);
  put(vertex_sphere_map, target(first_half, tmesh), image);
  const halfedge_descriptor left = CGAL::Euler::split_face(first_half, next(h, tmesh), tmesh),
                            right = CGAL::Euler::split_face(opposite(h, tmesh), next(other, tmesh), tmesh);
  split = {target(first_half, tmesh),
           {a, b},
           {face(opposite(left, tmesh), tmesh), face(opposite(right, tmesh), tmesh)},
           {face(left, tmesh), face(right, tmesh)}};
  return true;
}

} // namespace internal

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// splits the edges of a surface that prevent `map_surface()` from meeting landmarks: the edges that the paths of missed
/// landmarks on the sphere of the second surface cross.
///
/// New vertices lie on the original surface, and allow the edges to bend when `map_surface()` is called again. With few
/// additional vertices, this often meets the missed landmarks. It does not help if landmarks would have to be exchanged. Repeat
/// both functions until all landmarks are met, or a fixed number of times:
///
/// \code{.cpp}
/// std::size_t n = 1; // edges that have been split
/// for(int round = 0; round < 5 && n > 0 && mapper.report().number_of_missed_landmarks > 0; ++round)
///   if(split_blocking_edges(copy, sphere_of_copy, directions, sphere2, landmarks, n) != OK ||
///      map_surface(copy, sphere_of_copy, tmesh2, sphere2, mapper, directions) != OK)
///     break;
/// \endcode
///
/// <b>Complexity.</b> The running time is proportional to the number of edges times the number of missed landmarks.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam VertexSphereMap a model of `ReadWritePropertyMap` from the vertices to `%Point_3` of a \cgal kernel
/// \tparam VertexDirectionMap a model of `ReadablePropertyMap` with the same types
/// \tparam VertexSphereMap2 a model of `ReadablePropertyMap` with the same values for the second surface
/// \tparam LandmarkRange a range of pairs of a vertex of the first surface and a vertex of the second surface
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the first surface; pass a copy to keep the original. Its vertices are preserved
/// \param vertex_sphere_map its map to the sphere, which stays bijective. It must accept new vertices
/// \param vertex_direction_map the map computed by `map_surface()`. It receives no values for new vertices
/// \param vertex_sphere_map2 the map of the second surface to the sphere
/// \param landmarks the landmarks, as for `Surface_mapper_3`
/// \param split_edges receives the edges that have been split. It is empty if no edge is crossed, for example because a path
///        passes exactly through vertices, or if the resulting faces cannot be represented in double precision
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`, which must accept new vertices}
///     \cgalParamType{a class model of `ReadWritePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; `ERROR_NON_CLOSED_MESH` or `ERROR_NON_TRIANGULAR_MESH` if the mesh cannot have been mapped. The mesh is not
///         changed if an error is returned.
template <class TriangleMesh, class VertexSphereMap, class VertexDirectionMap, class VertexSphereMap2,
          class LandmarkRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code split_blocking_edges(TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                VertexDirectionMap vertex_direction_map, VertexSphereMap2 vertex_sphere_map2,
                                const LandmarkRange& landmarks, std::vector<Split_edge<TriangleMesh>>& split_edges,
                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using internal::direction_of;
  std::vector<halfedge_descriptor> blocking;
  std::vector<std::pair<internal::Vector_3d, internal::Vector_3d>> paths;
  constexpr double cosine_of_rounding = 1. - 1e-14; // Landmarks within 1.4e-7 of their goals are met.
  for(const auto& [v, w] : landmarks)
  {
    const internal::Vector_3d p = direction_of(get(vertex_direction_map, v)),
                              q = direction_of(get(vertex_sphere_map2, w));
    if(internal::dot(p, q) < cosine_of_rounding)
      paths.emplace_back(p, q);
  }
  split_edges.clear();
  if(!CGAL::is_closed(tmesh))
    return ERROR_NON_CLOSED_MESH;
  if(!CGAL::is_triangle_mesh(tmesh))
    return ERROR_NON_TRIANGULAR_MESH;
  if(paths.empty())
    return OK;
  for(const auto e : edges(tmesh))
  {
    const halfedge_descriptor h = halfedge(e, tmesh);
    const internal::Vector_3d a = direction_of(get(vertex_direction_map, source(h, tmesh))),
                              b = direction_of(get(vertex_direction_map, target(h, tmesh)));
    if(std::any_of(paths.begin(), paths.end(),
                   [&](const auto& path) { return internal::do_arcs_cross(path.first, path.second, a, b); }))
      blocking.push_back(h);
  }

  const auto points = internal::vertex_point_map_of(tmesh, np);
  for(const halfedge_descriptor h : blocking)
    if(Split_edge<TriangleMesh> split; internal::split_edge_on_sphere(h, tmesh, points, vertex_sphere_map, split))
      split_edges.push_back(split);
  return OK;
}

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// splits edges as the function above does; `number_of_split_edges` receives only their number.
template <class TriangleMesh, class VertexSphereMap, class VertexDirectionMap, class VertexSphereMap2,
          class LandmarkRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code split_blocking_edges(TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                VertexDirectionMap vertex_direction_map, VertexSphereMap2 vertex_sphere_map2,
                                const LandmarkRange& landmarks, std::size_t& number_of_split_edges,
                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::vector<Split_edge<TriangleMesh>> split_edges;
  const Error_code error = Spherical_parameterization::split_blocking_edges(
      tmesh, vertex_sphere_map, vertex_direction_map, vertex_sphere_map2, landmarks, split_edges, np);
  number_of_split_edges = split_edges.size();
  return error;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPLIT_BLOCKING_EDGES_H
