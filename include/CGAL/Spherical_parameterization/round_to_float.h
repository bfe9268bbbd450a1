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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ROUND_TO_FLOAT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ROUND_TO_FLOAT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Float_rounding.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/run/write_map.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// rounds a bijective map to the sphere to single precision and preserves its injectivity.
///
/// Many file formats store coordinates of type `float`. Where rounding to the nearest values inverts a face, its
/// vertices, and if necessary those around it, are rounded to other values nearby. They move by up to two units in the
/// last place of the largest coordinate if a face is a needle, and further if many vertices lie within a few of these
/// units. The distance of each point from the origin is preserved up to a few units in the last place. Exact predicates
/// certify the result before it is written, as in `is_bijective()`.
///
/// The running time is linear in the number of faces. It is twice that of `is_bijective()` if no face is inverted, and
/// grows with the number of vertices that have to be moved.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a
///         \cgal kernel; coordinates of an exact number type are rounded to type `double` first
/// \tparam VertexFloatMap a model of `WritablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a \cgal
///         kernel, whose coordinates are of type `float`, or of another type that can represent such numbers
///
/// \param tmesh a closed triangle mesh
/// \param vertex_sphere_map the images of its vertices, a bijective map
/// \param vertex_float_map receives the images with rounded coordinates; it may be the same property map
///
/// \return `OK`; `ERROR_NO_1_TO_1_MAPPING` if the given map is not bijective; `ERROR_OUT_OF_FLOAT_RANGE` if the largest
///         coordinate of an image is not between 2<sup>-126</sup> and 2<sup>127</sup>; `ERROR_INSUFFICIENT_PRECISION`
///         if no bijective map with such coordinates was found, for example because the image of a large part of the
///         surface is smaller than their resolution; or an error of the mesh. Nothing is written unless `OK` is
///         returned.
///
/// \sa `CGAL::Spherical_parameterization::is_bijective()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          class VertexFloatMap>
Error_code round_to_float(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, VertexFloatMap vertex_float_map)
{
  if constexpr(internal::check_mesh_and_readable_map<TriangleMesh, VertexSphereMap>() &&
               internal::check_map<TriangleMesh, VertexFloatMap>())
  {
    using Point_3 = typename boost::property_traits<VertexFloatMap>::value_type;
    using FT = typename Kernel_traits<Point_3>::Kernel::FT;

    internal::Mesh_arrays<TriangleMesh> mesh;
    if(const Error_code error = mesh.read(tmesh))
      return error;
    std::vector<internal::Vector_3d> points = internal::read_points(mesh.vertices_of_mesh, vertex_sphere_map);
    const internal::Execution execution = internal::execution_of<ConcurrencyTag>();
    if(!internal::are_bijective(mesh.triangles, points, execution))
      return ERROR_NO_1_TO_1_MAPPING;
    if(!std::all_of(points.begin(), points.end(), internal::has_normal_floats))
      return ERROR_OUT_OF_FLOAT_RANGE;
    internal::Float_rounding rounding(mesh.triangles, std::move(points));
    if(!rounding.run() || !internal::are_bijective(mesh.triangles, rounding.points(), execution))
      return ERROR_INSUFFICIENT_PRECISION;
    for(std::size_t v = 0; v < rounding.points().size(); ++v)
    {
      const internal::Vector_3d& p = rounding.points()[v];
      put(vertex_float_map, mesh.vertices_of_mesh[v],
          Point_3(static_cast<FT>(p[0]), static_cast<FT>(p[1]), static_cast<FT>(p[2])));
    }
    return OK;
  }
  else
    return ERROR_WRONG_PARAMETER;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ROUND_TO_FLOAT_H
