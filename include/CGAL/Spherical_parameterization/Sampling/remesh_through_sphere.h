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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_REMESH_THROUGH_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_REMESH_THROUGH_SPHERE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Property_transfer.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/run/Visitor_control.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/add_triangles.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

inline std::vector<Vector_3d> vertex_normals(std::vector<Vector_3d> points,
                                             const std::vector<Linked_triangle>& triangles)
{
  normalize(points);
  std::vector<Vector_3d> result(points.size(), Vector_3d{0., 0., 0.});
  for(const Linked_triangle& t : triangles)
  {
    const Vector_3d normal = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    for(const std::uint32_t v : t.vertices)
      result[v] = result[v] + normal;
  }
  for(Vector_3d& normal : result)
    normal = normalized_or_zero(normal);
  return result;
}

} // namespace internal

/// \ingroup PkgSphericalParameterizationSampling
///
/// resamples a surface at the directions of a domain, as in \cgalCite{cgal:ph-spr-03}, and adds a mesh with the triangles of the domain,
/// whose vertices are the surface points in the directions of the domain, see `Sphere_locator_3`.
///
/// The connectivity is regular if the domain is regular, and the domain determines the number of vertices. The new mesh
/// corresponds to the surface one-to-one through the sphere. It is close to the surface where samples are dense: maps computed
/// with `Stretch_energy_3` distribute samples most evenly over the surface. `measure_distance()` measures the distance. There is
/// no guarantee that the new mesh has no self-intersections where it is too coarse.
///
/// If both meshes are of class `Surface_mesh`, the properties of vertices and faces are transferred as well. For other meshes and
/// property maps, see `transfer()`.
///
/// <b>Complexity.</b> The running time is linear in the size of the mesh and of the domain, with the exceptions described for
/// `Sphere_locator_3`.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a
///         \cgal kernel; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam Remesh a model of `MutableFaceGraph`
/// \tparam RemeshSphereMap a model of `WritablePropertyMap` from the vertices of `Remesh` to `%Point_3` of a \cgal kernel
/// \tparam NamedParameters1,NamedParameters2 sequences of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface, a closed triangle mesh of genus 0
/// \param vertex_sphere_map its bijective map to the sphere, for example computed by `parameterize()`
/// \param domain the sampling pattern
/// \param remesh the new mesh is added to it, with vertices and faces in the order of the domain
/// \param remesh_sphere_map receives the directions of the new vertices, which are the map of the new mesh to the sphere
/// \param np,np_remesh optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices}
///     \cgalParamType{a class model of `ReadablePropertyMap`, for `remesh` of `WritablePropertyMap`, with `%Point_3` values}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`, and of `remesh`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_normal_map}
///     \cgalParamDescription{of `remesh` only: a property map that receives the normals of the surface at the new vertices.
///                           They are interpolated between the vertex normals of the surface, which are averages of face
///                           normals weighted with areas. They have length 1, or 0 where there is no area.}
///     \cgalParamType{a class model of `WritablePropertyMap` with `%Vector_3` of a \cgal kernel as value type}
///     \cgalParamDefault{normals are not computed}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{of `np`: a visitor whose function `go_further()` is called between the stages, and may stop the run}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{of `np`: the time in seconds after which the run is stopped}
///     \cgalParamType{double}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; a defect of the mesh, see `find_defect()`, or of its map: `ERROR_NO_1_TO_1_MAPPING` if it is not bijective;
///         `ERROR_INVALID_DOMAIN` if the domain is empty; or `ERROR_STOPPED`. Nothing is added if an error is returned.
///
/// <b>Exceptions.</b> Exceptions caused by lack of memory or thrown by property maps of the caller are passed on; `remesh` then
/// has its original vertices, edges and faces. If it is a `Surface_mesh`, properties may have been added, and it may contain
/// garbage elements.
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap, class Remesh,
          class RemeshSphereMap, typename CGAL_NP_TEMPLATE_PARAMETERS_1, typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Error_code remesh_through_sphere(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                 const Sphere_domain_3& domain, Remesh& remesh, RemeshSphereMap remesh_sphere_map,
                                 const CGAL_NP_CLASS_1& np = parameters::default_values(),
                                 const CGAL_NP_CLASS_2& np_remesh = parameters::default_values())
{
  using Mesh_arrays = internal::Mesh_on_sphere<TriangleMesh, VertexSphereMap>;
  using Exact_kernel = typename Mesh_arrays::Exact_kernel;
  using FT = typename Exact_kernel::FT;

  if(domain.is_empty())
    return ERROR_INVALID_DOMAIN;
  internal::Visitor_control<CGAL_NP_CLASS_1> control(np);
  const internal::Execution execution = internal::execution_of<ConcurrencyTag>();
  Mesh_arrays mesh;
  if(const Error_code error = mesh.read_with_points(tmesh, vertex_sphere_map, np, execution))
    return error;
  if(!control.go_further(0, 0.))
    return ERROR_STOPPED;
  internal::Sphere_triangulation<Exact_kernel> source, target;
  source.assign(std::move(mesh.images), std::move(mesh.triangles));
  source.make_grid();
  std::vector<typename Exact_kernel::Point_3> directions;
  directions.reserve(domain.directions().size());
  for(const auto& q : domain.directions())
    directions.emplace_back(FT(q.x()), FT(q.y()), FT(q.z()));
  target.assign(std::move(directions), internal::link_triangles(domain.triangles(), domain.directions().size()));
  const auto places = source.locate(target.points(), execution);
  if(!control.go_further(0, 0.))
    return ERROR_STOPPED;

  internal::add_triangles(
      target.triangles(), places.size(), remesh, [&](const auto& new_vertices, [[maybe_unused]] const auto& new_faces) {
        const auto sample = [&](const std::vector<internal::Vector_3d>& values, std::size_t k) {
          return internal::interpolated(values, source.triangles(), places[k]);
        };
        internal::write_vectors(internal::vertex_point_map_of(remesh, np_remesh), new_vertices,
                                [&](std::size_t k) { return sample(mesh.points, k); });
        internal::write_vectors(remesh_sphere_map, new_vertices, [&](std::size_t k) { return domain.directions()[k]; });
        if constexpr(!parameters::is_default_parameter<CGAL_NP_CLASS_2, internal_np::vertex_normal_map_t>::value)
        {
          const auto normals = internal::vertex_normals(mesh.points, source.triangles());
          internal::write_vectors(parameters::get_parameter(np_remesh, internal_np::vertex_normal_map), new_vertices,
                                  [&](std::size_t k) { return internal::normalized_or_zero(sample(normals, k)); });
        }
        if constexpr(internal::are_surface_meshes<TriangleMesh, Remesh>)
        {
          const internal::Transfer_weights<Exact_kernel> weights(source, mesh.points, target, places, execution);
          internal::Property_transfer<TriangleMesh, Remesh, Exact_kernel> carrier = {
              mesh.vertices_of_mesh, mesh.faces_of_mesh, new_vertices, new_faces, weights};
          internal::transfer_all_properties(carrier, tmesh, vertex_sphere_map, remesh, remesh_sphere_map);
        }
      });
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_REMESH_THROUGH_SPHERE_H
