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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CHECK_ARGUMENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CHECK_ARGUMENTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>

#include <CGAL/Default.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

// A mistake in a call of a function of the package is a sentence of the compiler. What calls the functions below does not
// instantiate anything else if they return `false`, so that it is the only one.

template <class T, class = void>
struct Is_mesh : std::false_type
{};

// `boost::graph_traits` of what is no graph is an error.
template <class T>
struct Is_mesh<T, std::void_t<decltype(num_faces(std::declval<const T&>()))>> : std::true_type
{};

template <class T, class = void>
struct Is_property_map : std::false_type
{};

template <class T>
struct Is_property_map<
    T, std::void_t<typename boost::property_traits<T>::key_type, typename boost::property_traits<T>::value_type,
                   typename boost::property_traits<T>::category>> : std::true_type
{};

template <class T, class = void>
struct Is_point_3 : std::false_type
{};

template <class T>
struct Is_point_3<T, std::void_t<typename Kernel_traits<T>::Kernel::Point_3>>
  : std::is_same<T, typename Kernel_traits<T>::Kernel::Point_3>
{};

template <class Parameterizer, class TriangleMesh, class VertexSphereMap, class NamedParameters, class = void>
struct Is_parameterizer : std::false_type
{};

template <class Parameterizer, class TriangleMesh, class VertexSphereMap, class NamedParameters>
struct Is_parameterizer<
    Parameterizer, TriangleMesh, VertexSphereMap, NamedParameters,
    std::void_t<decltype(std::declval<Parameterizer&>().template parameterize<Sequential_tag>(
        std::declval<const TriangleMesh&>(), std::declval<VertexSphereMap>(), std::declval<const NamedParameters&>()))>>
  : std::true_type
{};

template <class TriangleMesh>
constexpr bool check_mesh()
{
  static_assert(Is_mesh<TriangleMesh>::value,
                "The first argument has to be the mesh, a model of FaceListGraph such as CGAL::Surface_mesh.");
  return Is_mesh<TriangleMesh>::value;
}

// for a mesh that is one, and the map of its vertices to the sphere
template <class TriangleMesh, class VertexSphereMap>
constexpr bool check_images()
{
  static_assert(
      Is_property_map<VertexSphereMap>::value,
      "The argument for the images of the vertices has to be the property map that holds them: of the pair that "
      "add_property_map() returns, it is .first; of an std::map, boost::make_assoc_property_map() makes one.");
  if constexpr(Is_property_map<VertexSphereMap>::value)
  {
    using Traits = boost::property_traits<VertexSphereMap>;
    constexpr bool has_points = Is_point_3<typename Traits::value_type>::value;
    constexpr bool has_vertices = std::is_convertible<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                                                      typename Traits::key_type>::value;
    static_assert(has_points, "The property map for the images has to hold points: Point_3 of a CGAL kernel.");
    static_assert(has_vertices, "The property map for the images has to be one for the vertices of the mesh.");
    return has_points && has_vertices;
  }
  return false;
}

// the same for a map that is written
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

// for the functions that read a map to the sphere
template <class TriangleMesh, class VertexSphereMap>
constexpr bool check_mesh_and_readable_map()
{
  if constexpr(check_mesh<TriangleMesh>())
    return check_images<TriangleMesh, VertexSphereMap>();
  return false;
}

template <class Energy, class = void>
struct Is_energy : std::false_type
{};

template <class Energy>
struct Is_energy<
    Energy, std::void_t<decltype(static_cast<double>(std::declval<const Energy&>()(std::declval<const double&>(),
                                                                                   std::declval<const double&>()))),
                        decltype(static_cast<Energy_derivatives_3<double>>(std::declval<const Energy&>().derivatives(
                            std::declval<const double&>(), std::declval<const double&>())))>> : std::true_type
{};

template <class Energy>
constexpr bool check_energy()
{
  static_assert(
      Is_energy<Energy>::value,
      "The setting energy has to be a model of DistortionEnergy_3, such as Conformal_energy_3; one of your own has "
      "operator() and derivatives() for two numbers, both const.");
  return Is_energy<Energy>::value;
}

template <class Radius, class Energy, class = void>
struct Is_radius_policy : std::is_same<Radius, Default>
{};

template <class Radius, class Energy>
struct Is_radius_policy<Radius, Energy,
                        std::void_t<decltype(static_cast<double>(std::declval<const Radius&>().initial_radius(0.))),
                                    decltype(static_cast<double>(std::declval<Radius&>()(
                                        std::declval<const Energy&>(), std::declval<const Face_range_3&>(), 0.)))>>
  : std::true_type
{};

template <class Energy, class Radius>
constexpr bool check_settings()
{
  if constexpr(check_energy<Energy>())
  {
    static_assert(Is_radius_policy<Radius, Energy>::value,
                  "The setting radius has to be a model of SphereRadiusPolicy_3: Fixed_radius_3(r) for the radius r.");
    return Is_radius_policy<Radius, Energy>::value;
  }
  return false;
}

// for the function, which takes any model of `SphericalParameterizer_3`
template <class TriangleMesh, class Parameterizer, class VertexSphereMap, class NamedParameters>
constexpr bool check_arguments()
{
  if constexpr(check_mesh<TriangleMesh>())
  {
    constexpr bool is_parameterizer =
        Is_parameterizer<std::remove_const_t<Parameterizer>, TriangleMesh, VertexSphereMap, NamedParameters>::value;
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

// for a mesh that is one; without the parameter, the mesh has to have points of its own
template <class TriangleMesh, class NamedParameters>
constexpr bool check_vertex_point_map()
{
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value)
  {
    using Map = std::decay_t<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(),
                                                                internal_np::vertex_point))>;
    if constexpr(Is_property_map<Map>::value)
    {
      using Traits = boost::property_traits<Map>;
      constexpr bool has_points = Is_point_3<typename Traits::value_type>::value;
      constexpr bool has_vertices = std::is_convertible<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                                                        typename Traits::key_type>::value;
      static_assert(has_points && has_vertices,
                    "The named parameter vertex_point_map has to be a property map for the vertices of the mesh that "
                    "holds points: Point_3 of a CGAL kernel.");
      return has_points && has_vertices;
    }
    else
    {
      static_assert(Is_property_map<Map>::value,
                    "The named parameter vertex_point_map has to be a property map: of the pair that "
                    "add_property_map() returns, it is .first; of an std::map, boost::make_assoc_property_map() makes "
                    "one.");
      return false;
    }
  }
  return true;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CHECK_ARGUMENTS_H
