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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_TRANSFER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_TRANSFER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Property_transfer.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/run/Visitor_control.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/tags.h>

#include <tuple>
#include <type_traits>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

// Reads both meshes, computes the weights, and calls carry(carrier).
template <class ConcurrencyTag, class SourceMesh, class SourceSphereMap, class TargetMesh, class TargetSphereMap,
          class NamedParameters, class Carry>
Error_code transfer_properties(const SourceMesh& source, const SourceSphereMap& source_sphere, const TargetMesh& target,
                               const TargetSphereMap& target_sphere, const NamedParameters& np_source,
                               const Carry& carry)
{
  using Source = Mesh_on_sphere<SourceMesh, SourceSphereMap>;
  using Target = Mesh_on_sphere<TargetMesh, TargetSphereMap>;
  using Exact_kernel = typename Source::Exact_kernel;
  static_assert(std::is_same<Exact_kernel, typename Target::Exact_kernel>::value,
                "The coordinates of both maps to the sphere have to be of type double or float, or of the same exact "
                "number type.");

  Visitor_control<NamedParameters> control(np_source);
  const Execution execution = execution_of<ConcurrencyTag>();
  Source source_arrays;
  if(const Error_code error = source_arrays.read_with_points(source, source_sphere, np_source, execution))
    return error;
  Target target_arrays;
  if(const Error_code error = target_arrays.read(target, target_sphere, false, execution))
    return error;
  if(!control.go_further(0, 0.))
    return ERROR_STOPPED;
  Sphere_triangulation<Exact_kernel> source_triangulation, target_triangulation;
  source_triangulation.assign(std::move(source_arrays.images), std::move(source_arrays.triangles));
  target_triangulation.assign(std::move(target_arrays.images), std::move(target_arrays.triangles));
  source_triangulation.make_grid();
  const auto places = source_triangulation.locate(target_triangulation.points(), execution);
  const Transfer_weights<Exact_kernel> weights(source_triangulation, std::move(source_arrays.points),
                                               target_triangulation, places, execution);
  if(!control.go_further(0, 0.))
    return ERROR_STOPPED;
  Property_transfer<SourceMesh, TargetMesh, Exact_kernel> carrier = {
      source_arrays.vertices_of_mesh, source_arrays.faces_of_mesh, target_arrays.vertices_of_mesh,
      target_arrays.faces_of_mesh, weights};
  carry(carrier);
  return OK;
}

} // namespace internal

/// \ingroup PkgSphericalParameterizationSampling
///
/// transfers properties from one mesh to another one that has a map to the same sphere, for example from a surface to a mesh of
/// the sphere or vice versa.
///
/// - A target vertex receives the value interpolated at the source point in its direction, see `Sphere_locator_3`. If the target
///   is coarser, this would ignore most source values. Therefore, if all interpolated source vertices are inside the star of
///   the target vertex, it receives the average of all source vertices inside the star, weighted with their area on the surface
///   and with their barycentric coordinate for the target vertex. The adaptive barycentric resampling of cortical surfaces
///   \cgalCite{cgal:gswcfawxjp-mpphcp-13} distinguishes the same two cases. It averages if one of the vertices is inside the star,
///   and its weights balance the areas of both surfaces.
/// - A target face receives the value of the source face that contains the direction of its center, the sum of the directions of
///   its vertices. If the center of that source face is inside the target face as well, the target face receives the average of
///   all source faces whose centers are inside it, weighted with their areas.
/// - The transfer from a mesh to itself is exact to the bit. A target vertex whose direction is that of a source vertex receives
///   the exact value of this vertex, unless it receives an average.
///
/// Values of the following types are interpolated and averaged: floating-point numbers, `%Point_2`, `%Vector_2`, `%Point_3` and
/// `%Vector_3` of a \cgal kernel, `CGAL::IO::Color`, and `std::array` and `std::vector` of these types; shorter vectors are
/// extended with 0. All other values, such as `int`, `bool`, enumerations and strings, are labels: the label with the largest
/// sum of weights is transferred. Labels must be comparable by `std::less`.
///
/// <b>Complexity.</b> The running time is linear in the size of the meshes, with the exceptions described for
/// `Sphere_locator_3`, and except for labels, which are sorted where they are averaged. The meshes are copied once for all
/// properties. Only the calling thread reads and writes property maps.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam SourceMesh,TargetMesh models of `FaceListGraph`
/// \tparam SourceSphereMap a model of `ReadablePropertyMap` from the vertices of `SourceMesh` to `%Point_3` of a \cgal
///         kernel; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam TargetSphereMap the same for the target; its coordinates are of type `double` or `float` if those of the source are,
///         and otherwise of the same type as those of the source
/// \tparam SourceMap a model of `ReadablePropertyMap` whose key type is the vertex descriptor or the face descriptor of
///         the source
/// \tparam TargetMap a model of `WritablePropertyMap` whose key type is the vertex descriptor or the face descriptor of the
///         target, accordingly, and whose value type is that of `SourceMap`, or a type to which it can be converted
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param source,target the mesh with the properties, and the mesh that receives them
/// \param source_sphere,target_sphere the images of their vertices, at any distance from the origin
/// \param properties for each property, the property map of the source and the property map of the target
/// \param np_source an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `source`, used for areas}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, source)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{of `np_source`: a visitor whose function `go_further()` is called between the stages, and may stop
///                           the run}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{of `np_source`: the time in seconds after which the run is stopped}
///     \cgalParamType{double}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; a defect of the source, or of the target if the source has none, see `find_defect()`, or of its map to the
///         sphere: `ERROR_NO_1_TO_1_MAPPING` if it is not bijective; or `ERROR_STOPPED`. Nothing is written if an error is
///         returned.
///
/// \sa `CGAL::Spherical_parameterization::remesh_through_sphere()`
template <class ConcurrencyTag = Parallel_if_available_tag, class SourceMesh, class SourceSphereMap, class TargetMesh,
          class TargetSphereMap, class... SourceMap, class... TargetMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code transfer(const SourceMesh& source, SourceSphereMap source_sphere, const TargetMesh& target,
                    TargetSphereMap target_sphere, const std::tuple<std::pair<SourceMap, TargetMap>...>& properties,
                    const CGAL_NP_CLASS& np_source = parameters::default_values())
{
  return internal::transfer_properties<ConcurrencyTag>(
      source, source_sphere, target, target_sphere, np_source, [&](auto& carrier) {
        std::apply([&](const auto&... maps) { (carrier.carry(maps.first, maps.second), ...); }, properties);
      });
}

/// \ingroup PkgSphericalParameterizationSampling
///
/// transfers one property as the function above does.
template <class ConcurrencyTag = Parallel_if_available_tag, class SourceMesh, class SourceSphereMap, class TargetMesh,
          class TargetSphereMap, class SourceMap, class TargetMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code transfer(const SourceMesh& source, SourceSphereMap source_sphere, const TargetMesh& target,
                    TargetSphereMap target_sphere, const std::pair<SourceMap, TargetMap>& properties,
                    const CGAL_NP_CLASS& np_source = parameters::default_values())
{
  return transfer<ConcurrencyTag>(source, source_sphere, target, target_sphere, std::make_tuple(properties), np_source);
}

/// \ingroup PkgSphericalParameterizationSampling
///
/// transfers all properties of the vertices and faces of a `Surface_mesh` whose values are numbers of any type, `bool`,
/// `std::string`, `CGAL::IO::Color`, `%Point_2`, `%Vector_2`, `%Point_3` or `%Vector_3` of the kernel of the points of the
/// mesh, `std::array<double, 2>`, `std::array<double, 3>` or `std::vector<double>`.
///
/// The target receives properties with the same names. Existing properties with the same name and type are overwritten. The
/// points of the meshes are not changed, and neither are `source_sphere` and `target_sphere` if they are property maps of the
/// meshes.
///
/// \tparam SourcePoint,TargetPoint `%Point_3` of a \cgal kernel
template <class ConcurrencyTag = Parallel_if_available_tag, class SourcePoint, class SourceSphereMap, class TargetPoint,
          class TargetSphereMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code transfer(const Surface_mesh<SourcePoint>& source, SourceSphereMap source_sphere,
                    Surface_mesh<TargetPoint>& target, TargetSphereMap target_sphere,
                    const CGAL_NP_CLASS& np_source = parameters::default_values())
{
  return internal::transfer_properties<ConcurrencyTag>(
      source, source_sphere, target, target_sphere, np_source,
      [&](auto& carrier) { internal::transfer_all_properties(carrier, source, source_sphere, target, target_sphere); });
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_TRANSFER_H
