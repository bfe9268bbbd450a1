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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_PROPERTY_CARRIER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_PROPERTY_CARRIER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/sampling/Transfer_mixtures.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Carries property maps from a mesh to another one, of which the elements are given in the order of the mixtures.
template <class SourceMesh, class TargetMesh, class K>
class Property_carrier
{
public:
  template <class Mesh>
  struct Elements
  {
    const std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor>& vertices;
    const std::vector<typename boost::graph_traits<Mesh>::face_descriptor>& faces;
  };

  Property_carrier(const Elements<SourceMesh>& source, const Elements<TargetMesh>& target,
                   const Transfer_mixtures<K>& mixtures, const Execution& execution)
    : m_source(source)
    , m_target(target)
    , m_mixtures(mixtures)
    , m_execution(execution)
  {}

  template <class SourceMap, class TargetMap>
  void carry(const SourceMap& source_map, const TargetMap& target_map)
  {
    using Key = typename boost::property_traits<SourceMap>::key_type;
    using Target_key = typename boost::property_traits<TargetMap>::key_type;
    constexpr bool is_of_faces = std::is_same<Key, typename boost::graph_traits<SourceMesh>::face_descriptor>::value;
    static_assert(is_of_faces ||
                      std::is_convertible<typename boost::graph_traits<SourceMesh>::vertex_descriptor, Key>::value,
                  "A property map of the source has to be one of its vertices or faces.");
    if constexpr(is_of_faces)
    {
      static_assert(std::is_convertible<typename boost::graph_traits<TargetMesh>::face_descriptor, Target_key>::value,
                    "A property of faces has to be carried to a property map of the target's faces.");
      if(!m_face_mixtures)
        m_face_mixtures = m_mixtures.face_mixtures();
      carry(*m_face_mixtures, m_source.faces, source_map, m_target.faces, target_map);
    }
    else
    {
      static_assert(std::is_convertible<typename boost::graph_traits<TargetMesh>::vertex_descriptor, Target_key>::value,
                    "A property of vertices has to be carried to a property map of the target's vertices.");
      if(!m_vertex_mixtures)
        m_vertex_mixtures = m_mixtures.vertex_mixtures();
      carry(*m_vertex_mixtures, m_source.vertices, source_map, m_target.vertices, target_map);
    }
  }

private:
  template <class SourceElement, class SourceMap, class TargetElement, class TargetMap>
  void carry(const Mixtures& mixtures, const std::vector<SourceElement>& source_elements, const SourceMap& source_map,
             const std::vector<TargetElement>& target_elements, const TargetMap& target_map) const
  {
    using Value = typename boost::property_traits<SourceMap>::value_type;
    using Target_value = typename boost::property_traits<TargetMap>::value_type;
    mixtures.mix<Value>(
        source_elements.size(), [&](std::size_t i) -> Value { return get(source_map, source_elements[i]); },
        [&](std::size_t i, const Value& value) {
          put(target_map, target_elements[i], static_cast<Target_value>(value));
        },
        m_execution);
  }

  Elements<SourceMesh> m_source;
  Elements<TargetMesh> m_target;
  const Transfer_mixtures<K>& m_mixtures;
  Execution m_execution;
  std::optional<Mixtures> m_vertex_mixtures, m_face_mixtures; // made when they are needed
};

// Reads both meshes and calls carry(carrier).
template <class ConcurrencyTag, class SourceMesh, class SourceSphereMap, class TargetMesh, class TargetSphereMap,
          class Carry>
Error_code carry_properties(const SourceMesh& source, const SourceSphereMap& source_sphere, const TargetMesh& target,
                            const TargetSphereMap& target_sphere, const Carry& carry)
{
  using Source = Mesh_on_sphere<SourceMesh, SourceSphereMap>;
  using Target = Mesh_on_sphere<TargetMesh, TargetSphereMap>;
  using Exact_kernel = typename Source::Exact_kernel;
  static_assert(std::is_same<Exact_kernel, typename Target::Exact_kernel>::value,
                "The coordinates of both maps to the sphere have to be of type double or float, or of the same exact "
                "number type.");

  const Execution execution = execution_of<ConcurrencyTag>();
  Source source_arrays;
  if(const Error_code error = source_arrays.read(source, source_sphere, false, execution))
    return error;
  if(const Error_code error = source_arrays.read_points(get(vertex_point, source)))
    return error;
  Target target_arrays;
  if(const Error_code error = target_arrays.read(target, target_sphere, false, execution))
    return error;
  Sphere_triangulation<Exact_kernel> source_triangulation, target_triangulation;
  source_triangulation.assign(std::move(source_arrays.images), std::move(source_arrays.triangles));
  target_triangulation.assign(std::move(target_arrays.images), std::move(target_arrays.triangles));
  source_triangulation.make_grid();
  const auto places = source_triangulation.locate(target_triangulation.points(), execution);
  const Transfer_mixtures<Exact_kernel> mixtures(source_triangulation, source_arrays.points, target_triangulation,
                                                 places, execution);
  Property_carrier<SourceMesh, TargetMesh, Exact_kernel> carrier(
      {source_arrays.vertices_of_mesh, source_arrays.faces_of_mesh},
      {target_arrays.vertices_of_mesh, target_arrays.faces_of_mesh}, mixtures, execution);
  carry(carrier);
  return OK;
}

// what Surface_mesh::property_map() returns, which is a pair up to CGAL 5
template <class Map>
std::optional<Map> as_optional(const std::pair<Map, bool>& found)
{
  return found.second ? std::optional<Map>(found.first) : std::nullopt;
}
template <class Map>
const std::optional<Map>& as_optional(const std::optional<Map>& found)
{
  return found;
}

template <class Map, class OtherMap>
bool are_the_same(const Map& map, const OtherMap& other)
{
  if constexpr(std::is_same<Map, OtherMap>::value)
    return map.data() == other.data();
  else
    return false;
}

template <class... Types>
struct Type_list
{};

// Carries all properties of vertices or faces that have one of the types.
template <class Index, class... Values, class Carrier, class Source, class SourceSphereMap, class Target,
          class TargetSphereMap>
void carry_properties_of_types(Type_list<Values...>, Carrier& carrier, const Source& source,
                               const SourceSphereMap& source_sphere, Target& target,
                               const TargetSphereMap& target_sphere)
{
  const auto carry = [&](const std::string& name, const auto& source_map) {
    using Value = typename boost::property_traits<typename std::decay_t<decltype(source_map)>::value_type>::value_type;
    if(!source_map || are_the_same(*source_map, source_sphere))
      return;
    const auto target_map = target.template add_property_map<Index, Value>(name).first;
    if(!are_the_same(target_map, target_sphere))
      carrier.carry(*source_map, target_map);
  };
  for(const std::string& name : source.template properties<Index>())
    if(name != "v:point" && name != "v:removed" && name != "f:removed")
      (carry(name, as_optional(source.template property_map<Index, Values>(name))), ...);
}

template <class, class>
constexpr bool are_surface_meshes = false;
template <class SourcePoint, class TargetPoint>
constexpr bool are_surface_meshes<Surface_mesh<SourcePoint>, Surface_mesh<TargetPoint>> = true;

template <class Carrier, class SourcePoint, class SourceSphereMap, class TargetPoint, class TargetSphereMap>
void carry_all_properties(Carrier& carrier, const Surface_mesh<SourcePoint>& source,
                          const SourceSphereMap& source_sphere, Surface_mesh<TargetPoint>& target,
                          const TargetSphereMap& target_sphere)
{
  using K = typename Kernel_traits<SourcePoint>::Kernel;
  using Types = Type_list<bool, char, signed char, unsigned char, short, unsigned short, int, unsigned int, long,
                          unsigned long, long long, unsigned long long, float, double, std::string, CGAL::IO::Color,
                          typename K::Point_2, typename K::Vector_2, typename K::Point_3, typename K::Vector_3,
                          std::array<double, 2>, std::array<double, 3>, std::vector<double>>;
  using Source = Surface_mesh<SourcePoint>;
  carry_properties_of_types<typename Source::Vertex_index>(Types(), carrier, source, source_sphere, target,
                                                           target_sphere);
  carry_properties_of_types<typename Source::Face_index>(Types(), carrier, source, source_sphere, target,
                                                         target_sphere);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SAMPLING_PROPERTY_CARRIER_H
