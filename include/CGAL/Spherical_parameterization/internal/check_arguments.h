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

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A mistake in a call of `parameterize()` is a sentence of the compiler. What calls the functions below does not
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

// for a mesh that is one
template <class TriangleMesh, class VertexSphereMap>
constexpr bool check_map()
{
  static_assert(Is_property_map<VertexSphereMap>::value,
                "The last argument before named parameters has to be the property map for the images of the vertices: "
                "of the pair that add_property_map() returns, it is .first; of an std::map, "
                "boost::make_assoc_property_map() makes one.");
  if constexpr(Is_property_map<VertexSphereMap>::value)
  {
    using Traits = boost::property_traits<VertexSphereMap>;
    constexpr bool has_points = Is_point_3<typename Traits::value_type>::value;
    constexpr bool has_vertices = std::is_convertible<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                                                      typename Traits::key_type>::value;
    constexpr bool is_writable =
        std::is_convertible<typename Traits::category, boost::writable_property_map_tag>::value;
    static_assert(has_points, "The property map for the images has to hold points: Point_3 of a CGAL kernel.");
    static_assert(has_vertices, "The property map for the images has to be one for the vertices of the mesh.");
    static_assert(is_writable, "The property map for the images has to be writable.");
    return has_points && has_vertices && is_writable;
  }
  return false;
}

// for the parameterizers
template <class TriangleMesh, class VertexSphereMap>
constexpr bool check_mesh_and_map()
{
  if constexpr(check_mesh<TriangleMesh>())
    return check_map<TriangleMesh, VertexSphereMap>();
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

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CHECK_ARGUMENTS_H
