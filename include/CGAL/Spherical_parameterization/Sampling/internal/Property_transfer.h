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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_PROPERTY_TRANSFER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_PROPERTY_TRANSFER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Sampling/internal/Interpolation_weights.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The weights for the transfer of values from the vertices and faces of one mesh to those of another one through a common sphere,
// by the rules of transfer(). `K` is a kernel with exact predicates.
template <class K>
class Transfer_weights
{
public:
  using Point_3 = typename K::Point_3;
  using Triangulation = Sphere_triangulation<K>;
  using Triangle_location = typename Triangulation::Triangle_location;

  // All arguments except `source_points` must outlive this object. The source must have a grid. `source_points` are the points of
  // the surface, used for areas; `places` are the locations of the target vertices in the source.
  Transfer_weights(const Triangulation& source, std::vector<Vector_3d> source_points, const Triangulation& target,
                   const std::vector<Triangle_location>& places, const Execution& execution)
    : m_source(source)
    , m_target(target)
    , m_places(places)
    , m_execution(execution)
    , m_source_places(locations_of_vertices(source, target))
  {
    normalize(source_points);
    for(const Linked_triangle& t : source.triangles())
      m_source_areas.push_back(doubled_area(source_points[t[0]], source_points[t[1]], source_points[t[2]]));
  }

  Interpolation_weights vertex_mixtures() const
  {
    const std::size_t n = m_target.points().size();
    std::vector<double> areas(m_source.points().size(), 0.);
    for(std::size_t t = 0; t < m_source.triangles().size(); ++t)
      for(const std::uint32_t v : m_source.triangles()[t].vertices)
        areas[v] += m_source_areas[t];
    const auto for_each_in_stars = [&](const auto& f) { // calls f(vertex of the target, vertex of the source, weight)
      for(std::uint32_t s = 0; s < m_source_places.size(); ++s)
        for(std::size_t i = 0; i < 3; ++i)
          if(const double weight = areas[s] * CGAL::to_double(m_source_places[s].coordinates[i]); weight > 0.)
            f(m_target.triangles()[m_source_places[s].triangle][i], s, weight);
    };
    std::vector<double> sums(n, 0.); // of the weights for averages; 0 for interpolated vertices
    for_each_in_stars([&](std::uint32_t v, std::uint32_t, double weight) { sums[v] += weight; });
    for(std::size_t v = 0; v < n; ++v)
      if(sums[v] > 0. && !has_average(v))
        sums[v] = 0.;
    return Interpolation_weights(n, [&](const auto& add) {
      for(std::size_t v = 0; v < n; ++v)
        for(std::size_t i = 0; i < 3 && !(sums[v] > 0.); ++i)
          if(m_places[v].coordinates[i] != 0)
            add(v, {m_source.triangles()[m_places[v].triangle][i], CGAL::to_double(m_places[v].coordinates[i])});
      for_each_in_stars([&](std::uint32_t v, std::uint32_t s, double weight) {
        if(sums[v] > 0.)
          add(v, {s, weight / sums[v]});
      });
    });
  }

  Interpolation_weights face_mixtures() const
  {
    const std::size_t n = m_target.triangles().size();
    const std::vector<Triangle_location> places = m_source.locate(centers_of(m_target), m_execution);
    const std::vector<Point_3> source_centers = centers_of(m_source);
    std::vector<std::uint32_t> source_places;
    std::vector<double> sums(n, 0.); // of the areas for averages; 0 for faces that receive the value of one face
    for(std::size_t s = 0; s < source_centers.size(); ++s)
    {
      const std::uint32_t start = m_source_places[m_source.triangles()[s][0]].triangle;
      source_places.push_back(m_target.locate_from(start, source_centers[s]).triangle);
      sums[source_places[s]] += m_source_areas[s];
    }
    for(std::size_t f = 0; f < n; ++f)
      if(source_places[places[f].triangle] != f)
        sums[f] = 0.;
    return Interpolation_weights(n, [&](const auto& add) {
      for(std::size_t f = 0; f < n; ++f)
        if(!(sums[f] > 0.))
          add(f, {places[f].triangle, 1.});
      for(std::uint32_t s = 0; s < source_places.size(); ++s)
        if(const std::uint32_t f = source_places[s]; sums[f] > 0. && m_source_areas[s] > 0.)
          add(f, {s, m_source_areas[s] / sums[f]});
    });
  }

  const Execution& execution() const { return m_execution; }

private:
  // Whether all source vertices that would be interpolated are inside the star of a target vertex.
  bool has_average(std::size_t v) const
  {
    for(std::size_t i = 0; i < 3; ++i)
      if(m_places[v].coordinates[i] != 0)
      {
        const Triangle_location& place = m_source_places[m_source.triangles()[m_places[v].triangle][i]];
        const Linked_triangle& t = m_target.triangles()[place.triangle];
        const std::size_t corner = t.corner_of(static_cast<std::uint32_t>(v));
        if(t[corner] != v || place.coordinates[corner] == 0)
          return false;
      }
    return true;
  }

  static std::vector<Point_3> centers_of(const Triangulation& triangulation)
  {
    std::vector<Point_3> result;
    result.reserve(triangulation.triangles().size());
    for(const Linked_triangle& t : triangulation.triangles())
    {
      const Vector_3d center =
          triangulation.direction(t[0]) + triangulation.direction(t[1]) + triangulation.direction(t[2]);
      result.emplace_back(center[0], center[1], center[2]);
    }
    return result;
  }

  const Triangulation& m_source;
  const Triangulation& m_target;
  const std::vector<Triangle_location>& m_places;
  Execution m_execution;
  std::vector<Triangle_location> m_source_places; // the locations of the source vertices in the target
  std::vector<double> m_source_areas;             // twice the areas of the source faces
};

// Transfers property maps from one mesh to another one. Elements are in the order of the arrays of the meshes.
template <class SourceMesh, class TargetMesh, class K>
struct Property_transfer
{
  using Source = boost::graph_traits<SourceMesh>;
  using Target = boost::graph_traits<TargetMesh>;

  const std::vector<typename Source::vertex_descriptor>& source_vertices;
  const std::vector<typename Source::face_descriptor>& source_faces;
  const std::vector<typename Target::vertex_descriptor>& target_vertices;
  const std::vector<typename Target::face_descriptor>& target_faces;
  const Transfer_weights<K>& weights;
  std::optional<Interpolation_weights> of_vertices = {}, of_faces = {}; // computed on demand

  template <class SourceMap, class TargetMap>
  void carry(const SourceMap& source_map, const TargetMap& target_map)
  {
    using Key = typename boost::property_traits<SourceMap>::key_type;
    using Target_key = typename boost::property_traits<TargetMap>::key_type;
    using Value = typename boost::property_traits<SourceMap>::value_type;
    using Target_value = typename boost::property_traits<TargetMap>::value_type;
    constexpr bool is_of_faces = std::is_same<Key, typename Source::face_descriptor>::value;
    static_assert(is_of_faces || std::is_convertible<typename Source::vertex_descriptor, Key>::value,
                  "A property map of the source has to be one of its vertices or faces.");
    using Target_element =
        std::conditional_t<is_of_faces, typename Target::face_descriptor, typename Target::vertex_descriptor>;
    static_assert(std::is_convertible<Target_element, Target_key>::value,
                  "A property of vertices has to be carried to one of the target's vertices, and one of faces to one "
                  "of its faces.");
    const auto mix = [&](auto& made, auto make, const auto& sources, const auto& targets) {
      if(!made)
        made = (weights.*make)();
      made->template mix<Value>(
          sources.size(), [&](std::size_t i) -> Value { return get(source_map, sources[i]); },
          [&](std::size_t i, const Value& value) { put(target_map, targets[i], static_cast<Target_value>(value)); },
          weights.execution());
    };
    if constexpr(is_of_faces)
      mix(of_faces, &Transfer_weights<K>::face_mixtures, source_faces, target_faces);
    else
      mix(of_vertices, &Transfer_weights<K>::vertex_mixtures, source_vertices, target_vertices);
  }
};

// The result of Surface_mesh::property_map(), which is a pair up to CGAL 5.
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

template <class, class>
constexpr bool are_surface_meshes = false;
template <class SourcePoint, class TargetPoint>
constexpr bool are_surface_meshes<Surface_mesh<SourcePoint>, Surface_mesh<TargetPoint>> = true;

// Transfers all properties of vertices and faces with a type of this list.
template <class Carrier, class SourcePoint, class SourceSphereMap, class TargetPoint, class TargetSphereMap>
void transfer_all_properties(Carrier& carrier, const Surface_mesh<SourcePoint>& source,
                             const SourceSphereMap& source_sphere, Surface_mesh<TargetPoint>& target,
                             const TargetSphereMap& target_sphere)
{
  using Source = Surface_mesh<SourcePoint>;
  using K = typename Kernel_traits<SourcePoint>::Kernel;
  using Types = std::tuple<bool, char, signed char, unsigned char, short, unsigned short, int, unsigned int, long,
                           unsigned long, long long, unsigned long long, float, double, std::string, CGAL::IO::Color,
                           typename K::Point_2, typename K::Vector_2, typename K::Point_3, typename K::Vector_3,
                           std::array<double, 2>, std::array<double, 3>, std::vector<double>>;
  const auto carry = [&](auto index, const std::string& name, const auto& value) {
    using Index = decltype(index);
    using Value = std::decay_t<decltype(value)>;
    const auto source_map = as_optional(source.template property_map<Index, Value>(name));
    if(!source_map || are_the_same(*source_map, source_sphere))
      return;
    const auto target_map = target.template add_property_map<Index, Value>(name).first;
    if(!are_the_same(target_map, target_sphere))
      carrier.carry(*source_map, target_map);
  };
  const auto transfer_all_of = [&](auto index) {
    for(const std::string& name : source.template properties<decltype(index)>())
      if(name != "v:point" && name != "v:removed" && name != "f:removed")
        std::apply([&](const auto&... values) { (carry(index, name, values), ...); }, Types());
  };
  transfer_all_of(typename Source::Vertex_index());
  transfer_all_of(typename Source::Face_index());
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_PROPERTY_TRANSFER_H
