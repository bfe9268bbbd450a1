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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_CHECK_ARGUMENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_CHECK_ARGUMENTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/library.h>

#include <CGAL/Default.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
class Symmetric_Dirichlet_energy_3;
class Isometric_energy_3;
class Conformal_energy_3;
class Stretch_energy_3;
} // namespace CGAL::Spherical_parameterization

namespace CGAL::Spherical_parameterization::internal {

// Each incorrect argument of a public function causes one static assertion with a readable message. If the functions
// below return `false`, their callers instantiate nothing else, so that no other error follows.

// `boost::graph_traits` of a type that is not a graph is a compile error.
template <class T>
using Number_of_faces = decltype(num_faces(std::declval<const T&>()));

template <class T>
using Property_map_types =
    std::void_t<typename boost::property_traits<T>::key_type, typename boost::property_traits<T>::value_type,
                typename boost::property_traits<T>::category>;

template <class T>
constexpr bool is_property_map = is_detected<Property_map_types, T>;

template <class T>
using Point_of_kernel = typename Kernel_traits<T>::Kernel::Point_3;

// For a property map.
template <class Map>
constexpr bool holds_points()
{
  using T = typename boost::property_traits<Map>::value_type;
  if constexpr(is_detected<Point_of_kernel, T>)
    return std::is_same<T, Point_of_kernel<T>>::value;
  return false;
}

template <class Map, class TriangleMesh>
constexpr bool is_for_vertices = std::is_convertible<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                                                     typename boost::property_traits<Map>::key_type>::value;

template <class Map, class TriangleMesh>
constexpr bool is_for_faces = std::is_convertible<typename boost::graph_traits<TriangleMesh>::face_descriptor,
                                                  typename boost::property_traits<Map>::key_type>::value;

template <class Parameterizer, class TriangleMesh, class VertexSphereMap, class NamedParameters>
using Parameterize_result = decltype(std::declval<Parameterizer&>().template parameterize<Sequential_tag>(
    std::declval<const TriangleMesh&>(), std::declval<VertexSphereMap>(), std::declval<const NamedParameters&>()));

template <class TriangleMesh>
constexpr bool check_mesh()
{
  constexpr bool is_mesh = is_detected<Number_of_faces, TriangleMesh>;
  static_assert(is_mesh, "The first argument has to be the mesh, a model of FaceListGraph such as CGAL::Surface_mesh.");
  return is_mesh;
}

// For a type that has been checked to be a mesh, and the map of its vertices to the sphere.
template <class TriangleMesh, class VertexSphereMap>
constexpr bool check_images()
{
  static_assert(
      is_property_map<VertexSphereMap>,
      "The argument for the images of the vertices has to be the property map that holds them: of the pair that "
      "add_property_map() returns, it is .first; of an std::map, boost::make_assoc_property_map() makes one.");
  if constexpr(is_property_map<VertexSphereMap>)
  {
    constexpr bool has_points = holds_points<VertexSphereMap>();
    constexpr bool has_vertices = is_for_vertices<VertexSphereMap, TriangleMesh>;
    static_assert(has_points, "The property map for the images has to hold points: Point_3 of a CGAL kernel.");
    static_assert(has_vertices, "The property map for the images has to be one for the vertices of the mesh.");
    return has_points && has_vertices;
  }
  return false;
}

// The same for a map that is written.
template <class TriangleMesh, class VertexSphereMap>
constexpr bool check_map()
{
  if constexpr(check_images<TriangleMesh, VertexSphereMap>())
  {
    constexpr bool is_writable = std::is_convertible<typename boost::property_traits<VertexSphereMap>::category,
                                                     boost::writable_property_map_tag>::value;
    static_assert(is_writable, "The property map for the images has to be writable.");
    return is_writable;
  }
  return false;
}

// For functions that read a map to the sphere.
template <class TriangleMesh, class VertexSphereMap>
constexpr bool check_mesh_and_readable_map()
{
  if constexpr(check_mesh<TriangleMesh>())
    return check_images<TriangleMesh, VertexSphereMap>();
  return false;
}

template <class Energy>
using Energy_results =
    std::void_t<decltype(static_cast<double>(std::declval<const Energy&>()(0., 0.))),
                decltype(static_cast<Energy_derivatives_3<double>>(std::declval<const Energy&>().derivatives(0., 0.)))>;

template <class Energy>
constexpr bool is_energy_of_package =
    std::is_same<Energy, Symmetric_Dirichlet_energy_3>::value || std::is_same<Energy, Isometric_energy_3>::value ||
    std::is_same<Energy, Conformal_energy_3>::value || std::is_same<Energy, Stretch_energy_3>::value;

template <class Energy>
constexpr bool check_energy()
{
  constexpr bool is_energy = is_detected<Energy_results, Energy>;
  static_assert(
      is_energy,
      "The setting energy has to be a model of DistortionEnergy_3, such as Conformal_energy_3; one of your own has "
      "operator() and derivatives() for two numbers, both const.");
#if !defined(CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY) && !defined(CGAL_SPHERICAL_PARAMETERIZATION_OWN_ENERGIES)
  static_assert(!is_energy || is_energy_of_package<Energy>,
                "The library has the descents by the energies of the package. For one of your own, define "
                "CGAL_SPHERICAL_PARAMETERIZATION_OWN_ENERGIES, or use the headers without the library.");
#endif
  return is_energy;
}

template <class Radius, class Energy>
using Radius_results = std::void_t<decltype(static_cast<double>(std::declval<const Radius&>().initial_radius(0.))),
                                   decltype(static_cast<double>(std::declval<Radius&>()(
                                       std::declval<const Energy&>(), std::declval<const Face_range_3&>(), 0.)))>;

template <class Energy, class Radius>
constexpr bool check_settings()
{
  if constexpr(check_energy<Energy>())
  {
    constexpr bool is_policy = std::is_same<Radius, Default>::value || is_detected<Radius_results, Radius, Energy>;
    static_assert(is_policy,
                  "The setting radius has to be a model of SphereRadiusPolicy_3: Fixed_radius_3(r) for the radius r.");
    return is_policy;
  }
  return false;
}

// For the function parameterize(), which accepts any model of `SphericalParameterizer_3`.
template <class TriangleMesh, class Parameterizer, class VertexSphereMap, class NamedParameters>
constexpr bool check_arguments()
{
  if constexpr(check_mesh<TriangleMesh>())
  {
    constexpr bool is_parameterizer = is_detected<Parameterize_result, std::remove_const_t<Parameterizer>, TriangleMesh,
                                                  VertexSphereMap, NamedParameters>;
    static_assert(is_parameterizer,
                  "The second of three arguments has to be the parameterizer, a model of SphericalParameterizer_3 such "
                  "as Bijective_low_distortion_parameterizer_3; the map for the images is the third.");
    if constexpr(is_parameterizer)
    {
      constexpr bool is_const = std::is_const<Parameterizer>::value;
      static_assert(!is_const, "The parameterizer keeps the report of the run: it must not be const.");
      return !is_const && check_map<TriangleMesh, VertexSphereMap>();
    }
  }
  return false;
}

// For a type that has been checked to be a mesh; without the parameter, the mesh must have an internal point map.
template <class TriangleMesh, class NamedParameters>
constexpr bool check_vertex_point_map()
{
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value)
  {
    using Map = std::decay_t<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(),
                                                                internal_np::vertex_point))>;
    static_assert(is_property_map<Map>,
                  "The named parameter vertex_point_map has to be a property map: of the pair that "
                  "add_property_map() returns, it is .first; of an std::map, boost::make_assoc_property_map() makes "
                  "one.");
    if constexpr(is_property_map<Map>)
    {
      constexpr bool has_points_of_vertices = holds_points<Map>() && is_for_vertices<Map, TriangleMesh>;
      static_assert(has_points_of_vertices,
                    "The named parameter vertex_point_map has to be a property map for the vertices of the mesh that "
                    "holds points: Point_3 of a CGAL kernel.");
      return has_points_of_vertices;
    }
    return false;
  }
  return true;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_CHECK_ARGUMENTS_H
