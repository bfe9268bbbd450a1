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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPLIT_BENT_FACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPLIT_BENT_FACES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>
#include <CGAL/Spherical_parameterization/Surface_maps/split_blocking_edges.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/distortion_between.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// splits edges of a surface that `map_surface()` has mapped onto another one, where its faces are too large for what they cover
/// there: the images of edges are straight, and a face can follow the other surface only as well as three corners can. For the
/// faces that add most to the energy of the map, 0.3 of the sum together, it splits that edge whose image is longest. Their new vertices lie on the surface as it was. Call `map_surface()` again, which goes on from the map that there is,
/// while that pays, or a few times:
///
/// \code{.cpp}
/// std::vector<Split_edge<Mesh>> split_edges;
/// const auto further = mapper.keep_alignment();
/// for(int round = 0; round < 4; ++round)
///   if(split_bent_faces(copy, directions, tmesh2, sphere2, 1000, split_edges) != OK ||
///      map_surface(copy, directions, tmesh2, sphere2, further, directions) != OK)
///     break;
/// \endcode
///
/// What counts is the logarithm of the energy, as it is 0 for an isometry if that is taken as 1, integrated over the common
/// refinement, so that faces next to a landmark do not hide all others. Of a cat, mapped onto a horse with 17 landmarks, half as many
/// vertices again lower the energy from 2.59 to 2.47.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh1 a model of `MutableFaceGraph`
/// \tparam VertexDirectionMap a model of `ReadWritePropertyMap` from the vertices to `%Point_3` of a \cgal kernel
/// \tparam TriangleMesh2 a model of `FaceListGraph`
/// \tparam VertexSphereMap2 a model of `ReadablePropertyMap` with the same values for the second surface
/// \tparam NamedParameters1,NamedParameters2 sequences of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh1 the first surface, or rather a copy of it. Its vertices stay what they are
/// \param vertex_direction_map what `map_surface()` has found for it. Has room for new vertices, which are put on the images of
///        their edges: it stays a bijection, and is as good a start
/// \param tmesh2,vertex_sphere_map2 the second surface and its map
/// \param max_edges the largest number of edges that are split
/// \param split_edges receives the edges that have been split: none if all faces are mapped by isometries
/// \param np1,np2 optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh1`, with room for new ones, or `tmesh2`}
///     \cgalParamType{a class model of `ReadWritePropertyMap`, or of `ReadablePropertyMap` for `tmesh2`, with `%Point_3` of a
///                    \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh1)`, or of `tmesh2`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{of `np1`: a visitor whose `go_further()` may stop the run}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{of `np1`: the time in seconds after which the run is stopped}
///     \cgalParamType{double}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{of `np1`: the largest number of vertices of the refinement, at most 2<sup>32</sup> - 2}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{4,194,304, or 32 times the number of vertices of both meshes, whichever is more}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, or what `overlay()` returns: both surfaces and maps are as they were then
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class VertexDirectionMap,
          class TriangleMesh2, class VertexSphereMap2, typename CGAL_NP_TEMPLATE_PARAMETERS_1,
          typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Error_code split_bent_faces(TriangleMesh1& tmesh1, VertexDirectionMap vertex_direction_map, const TriangleMesh2& tmesh2,
                            VertexSphereMap2 vertex_sphere_map2, std::size_t max_edges,
                            std::vector<Split_edge<TriangleMesh1>>& split_edges,
                            const CGAL_NP_CLASS_1& np1 = parameters::default_values(),
                            const CGAL_NP_CLASS_2& np2 = parameters::default_values())
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh1>::halfedge_descriptor;
  constexpr double part = 0.3; // cat_horse: 2.472 after three rounds

  split_edges.clear();
  const auto points = internal::vertex_point_map_of(tmesh1, np1);
  Surface_overlay_3<TriangleMesh1, TriangleMesh2> refinement;
  if(const Error_code error = Spherical_parameterization::overlay<ConcurrencyTag>(
         tmesh1, vertex_direction_map, tmesh2, vertex_sphere_map2, refinement, np1, np2))
    return error;

  const auto energies = get(CGAL::dynamic_face_property_t<double>(), tmesh1);
  for(const auto f : faces(tmesh1))
    put(energies, f, 0.);
  const auto corners = [&](std::size_t k, std::size_t surface) {
    std::array<internal::Vector_3d, 3> result;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const auto& p = refinement.points[refinement.triangles[k][i]][surface];
      result[i] = {p.x(), p.y(), p.z()};
    }
    return result;
  };
  internal::distortion_between(
      refinement.triangles.size(), internal::default_smallest_area, corners,
      [&](std::size_t k, const std::array<double, 2>& shares, const internal::Triangle_stretch& stretch) {
        const auto f = refinement.faces[k].first;
        const double energy = 0.5 * stretch.angle * stretch.area;
        put(energies, f, get(energies, f) + 0.5 * (shares[0] + shares[1]) * std::log(0.5 * energy));
      },
      internal::Execution());

  struct Bent_face
  {
    double energy;
    halfedge_descriptor longest;
  };
  const auto squared_length_of = [&](halfedge_descriptor h) {
    using internal::operator-;
    return internal::squared_length(internal::direction_of(get(vertex_direction_map, target(h, tmesh1))) -
                                    internal::direction_of(get(vertex_direction_map, source(h, tmesh1))));
  };
  std::vector<Bent_face> bent;
  double left = 0.; // of the sum
  for(const auto f : faces(tmesh1))
    if(const double energy = get(energies, f); energy > 0. && internal::is_finite(energy))
    {
      const halfedge_descriptor h = halfedge(f, tmesh1);
      const std::array<halfedge_descriptor, 3> sides = {h, next(h, tmesh1), prev(h, tmesh1)};
      bent.push_back({energy, *std::max_element(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
                        return squared_length_of(a) < squared_length_of(b);
                      })});
      left += part * energy;
    }
  std::stable_sort(bent.begin(), bent.end(),
                   [](const Bent_face& a, const Bent_face& b) { return a.energy > b.energy; });

  const auto is_chosen = get(CGAL::dynamic_edge_property_t<bool>(), tmesh1);
  for(const auto e : edges(tmesh1))
    put(is_chosen, e, false);
  std::vector<std::pair<double, halfedge_descriptor>> chosen;
  for(std::size_t k = 0; k < bent.size() && left > 0. && chosen.size() < max_edges; ++k)
  {
    left -= bent[k].energy;
    const halfedge_descriptor h = bent[k].longest;
    if(!get(is_chosen, edge(h, tmesh1)))
      chosen.emplace_back(squared_length_of(h), h);
    put(is_chosen, edge(h, tmesh1), true);
  }
  // A face with two of them is halved at the longer one, whose halves are rounder.
  std::stable_sort(chosen.begin(), chosen.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for(const auto& length_and_edge : chosen)
    if(Split_edge<TriangleMesh1> split;
       internal::split_edge_on_sphere(length_and_edge.second, tmesh1, points, vertex_direction_map, split))
      split_edges.push_back(split);
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPLIT_BENT_FACES_H
