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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_IS_BIJECTIVE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_IS_BIJECTIVE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Origin.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

/// \file is_bijective.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// returns whether a map from the vertices of a mesh to points around the origin is a bijection between the mesh and
/// the sphere: each face is mapped to the triangle of its vertices' images, and this triangle is projected to the
/// sphere along the rays from the origin. The images need not be on a sphere, since nothing but their directions
/// matters.
///
/// The answer is exact for the points as they are in the map, whatever the kernel. It rests on a theorem: if every face
/// (a, b, c) of a closed mesh is positively oriented about the origin, det(a, b, c) > 0, then the map covers each point
/// of the sphere the same number of times, branch points aside. If this number, the degree, is one, the map is a
/// homeomorphism. Positive faces alone do not suffice, because the faces around a vertex may turn around its image
/// twice; so the degree is computed as well, as the number of faces that contain a generic direction.
///
/// A consequence of the theorem is that the answer is `false` for a mesh that is no topological sphere, in particular
/// one that has several connected components or handles. It is also `false` for a mesh that is empty, that has a border
/// or a face that is not a triangle, and if a coordinate is infinite or not a number. Vertices without faces are
/// ignored.
///
/// The running time is linear in the number of faces, and so is the additional memory. The property map is read by the
/// calling thread alone; coordinates of an exact number type are decided about by it as well.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
///         `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
///         value type; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a triangle mesh
/// \param vertex_sphere_map the images of the vertices
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tmesh` a unique index between `0` and
///                           `num_vertices(tmesh) - 1`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value
///                    type}
///     \cgalParamDefault{an index made for the purpose; the mesh is only read}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if and only if the map is a bijection
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
bool is_bijective(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr(internal::check_mesh_and_readable_map<TriangleMesh, VertexSphereMap>())
  {
    using Selection = internal::Exact_predicates_kernel_of_map<VertexSphereMap>;
    using Exact_kernel = typename Selection::type;
    using Point_3 = typename Exact_kernel::Point_3;

    if(!CGAL::is_closed(tmesh) || !CGAL::is_triangle_mesh(tmesh))
      return false;

    // By default not the indices that the mesh may have itself: if they were not valid, they would have to be written.
    const auto index_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_index),
                                                        get(CGAL::dynamic_vertex_property_t<std::size_t>(), tmesh));
    if constexpr(parameters::is_default_parameter<CGAL_NP_CLASS, internal_np::vertex_index_t>::value)
    {
      std::size_t n = 0;
      for(const auto v : vertices(tmesh))
        put(index_map, v, n++);
    }

    std::vector<Point_3> points(num_vertices(tmesh), Point_3(ORIGIN));
    for(const auto v : vertices(tmesh))
    {
      if(halfedge(v, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge())
        points[static_cast<std::size_t>(get(index_map, v))] = Selection::convert(get(vertex_sphere_map, v));
    }

    std::vector<std::array<std::size_t, 3>> triangles;
    triangles.reserve(num_faces(tmesh));
    for(const auto f : faces(tmesh))
    {
      const auto h = halfedge(f, tmesh);
      triangles.push_back({static_cast<std::size_t>(get(index_map, source(h, tmesh))),
                           static_cast<std::size_t>(get(index_map, target(h, tmesh))),
                           static_cast<std::size_t>(get(index_map, target(next(h, tmesh), tmesh)))});
    }

    return internal::certify_bijectivity<Exact_kernel>(points, triangles, internal::execution_of<ConcurrencyTag>())
        .is_bijective();
  }
  else
    return false;
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_IS_BIJECTIVE_H
