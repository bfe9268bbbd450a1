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
#include <CGAL/Spherical_parameterization/Surface_maps/split_blocking_edges.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/overlay_surfaces.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/read_two_surfaces.h>
#include <CGAL/Spherical_parameterization/internal/run/maximum_number.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// splits edges of a surface that `map_surface()` has mapped onto another one, where its faces are too large for what they cover
/// there: the images of edges are straight, and a face can follow the other surface only as well as three corners can. For the
/// faces that add most to the energy of the map, 0.3 of the sum together, it splits that edge whose image is longest. Their new vertices lie on the surface as it was. Call
/// `map_surface()` again, which goes on from the map that there is, while that pays, or a few times:
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
  split_edges.clear();
  const auto run = [&](auto& first, auto& second, internal::Run_control& control,
                       const internal::Execution& execution) -> Error_code {
    std::vector<std::size_t> sides;
    if(const Error_code error =
           internal::find_bent_sides(internal::surface_of(first), internal::surface_of(second),
                                     internal::maximum_number_of(np1), max_edges, sides, control, execution))
      return error;
    std::vector<typename boost::graph_traits<TriangleMesh1>::halfedge_descriptor> chosen;
    for(const std::size_t side : sides) // that is opposite to a vertex, of which the first one is the source of h
    {
      const auto h = halfedge(first.faces_of_mesh[side / 3], tmesh1);
      chosen.push_back(side % 3 == 0 ? next(h, tmesh1) : side % 3 == 1 ? prev(h, tmesh1) : h);
    }
    const auto points = internal::vertex_point_map_of(tmesh1, np1);
    for(const auto h : chosen)
      if(Split_edge<TriangleMesh1> split;
         internal::split_edge_on_sphere(h, tmesh1, points, vertex_direction_map, split))
        split_edges.push_back(split);
    return OK;
  };
  return internal::with_two_surfaces<ConcurrencyTag>(tmesh1, vertex_direction_map, np1, tmesh2, vertex_sphere_map2, np2,
                                                     run);
}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SPLIT_BENT_FACES_H
