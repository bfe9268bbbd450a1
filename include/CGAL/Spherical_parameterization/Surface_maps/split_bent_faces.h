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
/// splits edges of a surface that `map_surface()` has mapped onto another one, where its faces are too large to follow the
/// shape of the other surface.
///
/// The images of edges are straight, so a face follows the other surface only as well as three corners can. The function
/// selects the faces with the largest contributions to the integral, over the common refinement, of the logarithm of half the
/// symmetric Dirichlet energy, up to a fraction of 0.3 of the integral. It splits the edge with the longest image of each
/// selected face. New vertices lie on the original surface. Call `map_surface()` afterwards, which continues from the current
/// map, and repeat both as long as the energy decreases, or a fixed number of times:
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
/// <b>Complexity.</b> The running time is that of `overlay()`.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh1 a model of `MutableFaceGraph`
/// \tparam VertexDirectionMap a model of `ReadWritePropertyMap` from the vertices to `%Point_3` of a \cgal kernel
/// \tparam TriangleMesh2 a model of `FaceListGraph`
/// \tparam VertexSphereMap2 a model of `ReadablePropertyMap` with the same values for the second surface
/// \tparam NamedParameters1,NamedParameters2 sequences of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh1 the first surface; pass a copy to keep the original. Its vertices are preserved
/// \param vertex_direction_map the map computed by `map_surface()`. It must accept new vertices, whose images lie on the images
///        of the split edges; it stays bijective, and is an equally good start
/// \param tmesh2,vertex_sphere_map2 the second surface and its map
/// \param max_edges the maximum number of edges that are split
/// \param split_edges receives the edges that have been split; it is empty if all faces are mapped isometrically
/// \param np1,np2 optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh1`, which must accept new vertices, or
///                           `tmesh2`}
///     \cgalParamType{a class model of `ReadWritePropertyMap`, or of `ReadablePropertyMap` for `tmesh2`, with `%Point_3` of a
///                    \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh1)`, or of `tmesh2`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{of `np1`: a visitor whose function `go_further()` may stop the run}
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
///     \cgalParamDefault{the maximum of 4,194,304 and 32 times the number of vertices of both meshes}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, or an error of `overlay()`; both surfaces and maps are not changed if an error is returned
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
    for(const std::size_t side : sides) // opposite to vertex side % 3 of the face; vertex 0 is the source of h
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
