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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_COMPUTE_TEXTURE_COORDINATES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_COMPUTE_TEXTURE_COORDINATES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Geographic_frame.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Seam_cut.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/surface/add_triangles.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSampling
///
/// adds a copy of a surface to a mesh, with texture coordinates computed from its map to the sphere: longitude and latitude, for
/// images in the equirectangular projection.
///
/// The first coordinate increases eastwards from 0 to 1, with the zero meridian at 0.5. The second one increases from 0 at the
/// south pole to 1 at the north pole. Seen from outside, the image is not mirrored.
///
/// The left and right sides of the image meet at the seam, the meridian opposite to the zero meridian. No face crosses the seam:
/// edges that cross it are split there, and the faces on each side have separate coordinates, 0 or 1. For this reason, texture
/// coordinates belong to corners instead of vertices. The result does not depend on whether the image is repeated or clamped. The
/// poles also become vertices. The longitude of a corner at a pole is the mean of the longitudes of the other two corners of its
/// face.
///
/// <b>Guarantee.</b> The new mesh is the same surface: new vertices lie on edges and faces at the points given by the map, up to
/// rounding error. Each edge is split once for both faces, so there are no gaps. The faces that the seam and the poles divide are
/// determined exactly for the given images and directions, even if the seam passes through vertices or along edges. All texture
/// triangles are positively oriented, and cover the image once except for parts of the triangles at the poles, unless
/// `ERROR_INVERTED_TEXTURE` is returned. Texture triangles of faces whose images are narrower than a millionth of their length, or
/// shorter than 1e-9 of the radius, may remain inverted; each covers less than 1e-10 of the image.
///
/// Texture coordinates are interpolated linearly in a face, but edges are mapped to arcs of great circles, which are curved in
/// the image, most of all near the poles. If this inverts the texture triangle of a narrow face, edges are split at their
/// midpoints by longest-edge propagation \cgalCite{cgal:r-nlea-97}. In maps of typical surfaces, this adds 1 to 600 vertices. The
/// process stops with `ERROR_INVERTED_TEXTURE` if the number of added vertices reaches the number of vertices of the mesh plus
/// 1000, which may happen for extremely narrow faces.
///
/// <b>Complexity.</b> The running time is linear in the size of the mesh.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a
///         \cgal kernel; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam TexturedMesh a model of `MutableFaceGraph`
/// \tparam HalfedgeTextureMap a model of `WritablePropertyMap` from the halfedges of `TexturedMesh` to `%Point_2` of a
///         \cgal kernel
/// \tparam NamedParameters1,NamedParameters2 sequences of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface, a closed triangle mesh of genus 0; it is not modified
/// \param vertex_sphere_map its bijective map to the sphere, for example computed by `parameterize()`
/// \param textured_mesh receives the surface in addition to its elements: the vertices of `tmesh` that have faces, in their
///        order, followed by new vertices
/// \param halfedge_texture_map receives the texture coordinates: for a halfedge, those of its target in its face
/// \param north_pole the direction of the north pole, at any distance from the origin
/// \param zero_meridian a direction in the half plane that contains the zero meridian and is bounded by the axis of the poles. It
///        need not be orthogonal to `north_pole`, but must not be parallel to it, not even up to rounding error
/// \param np,np_textured optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices}
///     \cgalParamType{a class model of `ReadablePropertyMap`, for `textured_mesh` of `WritablePropertyMap`, with `%Point_3` values}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`, and of `textured_mesh`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; a defect of the mesh, see `find_defect()`, or of its map: `ERROR_NO_1_TO_1_MAPPING` if it is not bijective; or
///         `ERROR_INVALID_DIRECTION` if the north pole or the zero meridian is zero, infinite or not a number, or if they are
///         parallel. Nothing is added in these cases. `ERROR_INVERTED_TEXTURE` is returned if the mesh and the coordinates are
///         complete, but some texture triangles are inverted.
///
/// <b>Exceptions.</b> Exceptions caused by lack of memory or thrown by property maps of the caller are passed on;
/// `textured_mesh` then has its original vertices, edges and faces.
///
/// \sa `CGAL::Spherical_parameterization::IO::write_OBJ()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          class TexturedMesh, class HalfedgeTextureMap, typename CGAL_NP_TEMPLATE_PARAMETERS_1,
          typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Error_code compute_texture_coordinates(
    const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, TexturedMesh& textured_mesh,
    HalfedgeTextureMap halfedge_texture_map,
    const typename boost::property_traits<VertexSphereMap>::value_type& north_pole = {0, 0, 1},
    const typename boost::property_traits<VertexSphereMap>::value_type& zero_meridian = {1, 0, 0},
    const CGAL_NP_CLASS_1& np = parameters::default_values(),
    const CGAL_NP_CLASS_2& np_textured = parameters::default_values())
{
  using Mesh_arrays = internal::Mesh_on_sphere<TriangleMesh, VertexSphereMap>;
  using Exact_kernel = typename Mesh_arrays::Exact_kernel;

  const internal::Geographic_frame<Exact_kernel> frame(Mesh_arrays::Selection::convert(north_pole),
                                                       Mesh_arrays::Selection::convert(zero_meridian));
  if(!frame.is_valid())
    return ERROR_INVALID_DIRECTION;
  Mesh_arrays mesh;
  if(const Error_code error =
         mesh.read_with_points(tmesh, vertex_sphere_map, np, internal::execution_of<ConcurrencyTag>()))
    return error;

  const auto point_map = internal::vertex_point_map_of(tmesh, np);
  const auto new_point_map = internal::vertex_point_map_of(textured_mesh, np_textured);
  using Point_3 = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  using New_point_3 = typename boost::property_traits<std::decay_t<decltype(new_point_map)>>::value_type;
  const Cartesian_converter<typename Kernel_traits<Point_3>::Kernel, typename Kernel_traits<New_point_3>::Kernel>
      convert;
  using Point_2 = typename boost::property_traits<HalfedgeTextureMap>::value_type;
  using Texture_FT = typename Kernel_traits<Point_2>::Kernel::FT;
  const internal::Seam_cut<Exact_kernel> cut(frame, mesh.images, mesh.triangles, std::move(mesh.points));
  internal::add_triangles(
      cut.triangles(), cut.points().size(), textured_mesh, [&](const auto& new_vertices, const auto& new_faces) {
        internal::write_vectors(new_point_map, new_vertices, [&](std::size_t v) { return cut.points()[v]; });
        for(std::size_t v = 0; v < mesh.vertices_of_mesh.size(); ++v) // whose points may be more exact
          put(new_point_map, new_vertices[v], convert(get(point_map, mesh.vertices_of_mesh[v])));
        for(std::size_t t = 0; t < new_faces.size(); ++t)
        {
          auto h = halfedge(new_faces[t], textured_mesh); // its target is corner 1
          for(const std::size_t i : {1u, 2u, 0u})
          {
            const auto uv = cut.coordinates(t, i);
            put(halfedge_texture_map, h, Point_2(static_cast<Texture_FT>(uv[0]), static_cast<Texture_FT>(uv[1])));
            h = next(h, textured_mesh);
          }
        }
      });
  return cut.is_complete() ? OK : ERROR_INVERTED_TEXTURE;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_COMPUTE_TEXTURE_COORDINATES_H
