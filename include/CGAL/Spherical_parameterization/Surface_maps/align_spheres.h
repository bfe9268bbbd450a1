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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_ALIGN_SPHERES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_ALIGN_SPHERES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Sphere_alignment_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/find_surface_map.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/read_two_surfaces.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// finds the rotations of the sphere of one surface for which this surface agrees best with another surface, among all
/// rotations and without an initial guess.
///
/// The function compares features of the surfaces that do not depend on rotations, and little on the pose: the area ratios
/// of the maps; the average geodesic distance of each point from all others \cgalCite{cgal:hskk-tmfase-01}; the signed mean
/// curvature at two scales, which distinguishes front from back where a half-turn would exchange them; and the wave kernel
/// signature. The caller may provide other features instead.
///
/// Both surfaces are simplified to at most 2000 vertices. Only the order of the values of a feature matters, so scales and
/// outliers have no influence. The score of a rotation is the correlation of all features, with uniform weight on the sphere.
/// The best of 12,000 rotations \cgalCite{cgal:a-sfs-22} are refined to about 0.2 degrees.
///
/// <b>Limits.</b> The function is intended for nearly isometric surfaces, such as poses of a body, whose maps were computed
/// with the same method. For bodies of other proportions it is likely to fail: check the margin, and provide landmarks or
/// features.
///
/// Rotations never exchange a surface and its mirror image. To align a surface with a mirror image, mirror one of the meshes:
/// change the sign of one coordinate of its points and of its map, and reverse the orientation of its faces.
///
/// <b>Complexity.</b> The running time is linear in the size of the meshes. Below 100,000 vertices, the comparison of the
/// simplified surfaces dominates.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh1,TriangleMesh2 models of `FaceListGraph`
/// \tparam VertexSphereMap1,VertexSphereMap2 models of `ReadablePropertyMap` from the vertices of the meshes to `%Point_3`
///         of a \cgal kernel; the coordinates are of type `double` or `float`, or of an exact number type
/// \tparam Features a range of `std::pair` of two functions: they return the value, a number, of a feature at a vertex of
///         the first mesh and of the second one. `Surface_mapper_3::Feature` is such a pair.
/// \tparam NamedParameters1,NamedParameters2 sequences of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh1,tmesh2 the first and the second surface
/// \param vertex_sphere_map1,vertex_sphere_map2 the images of their vertices, at any distance from the origin
/// \param features the features to compare; if there are none, the features of the package are compared
/// \param alignment receives the rotations of the first sphere and their scores
/// \param np1,np2 optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones listed below; for
///        `np2`, only `vertex_point_map` is used
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh1`, or `tmesh2`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh1)`, or of `tmesh2`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor whose function `go_further(0, 0)` is called every few milliseconds and may stop the search}
///     \cgalParamType{a class model of `SphericalParameterizationVisitor`, or `std::ref()` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time limit in seconds; none if it is not positive}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; the defect of the first mesh, or of the second one if the first one has none, see `find_defect()`, or the
///         defect of its map: `ERROR_NO_1_TO_1_MAPPING` if it is not bijective, `ERROR_INSUFFICIENT_PRECISION` if it is not
///         bijective after unit vectors have been rounded to double precision; `ERROR_NON_FINITE_COORDINATE` if a point is not
///         finite; or `ERROR_WRONG_PARAMETER` if the value of a feature is not finite. The alignment is not changed if an
///         error is returned.
///
/// \sa `CGAL::Spherical_parameterization::fit_rotation()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class VertexSphereMap1,
          class TriangleMesh2, class VertexSphereMap2, class Features, typename CGAL_NP_TEMPLATE_PARAMETERS_1,
          typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Error_code align_spheres(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1, const TriangleMesh2& tmesh2,
                         VertexSphereMap2 vertex_sphere_map2, const Features& features, Sphere_alignment_3& alignment,
                         const CGAL_NP_CLASS_1& np1 = parameters::default_values(),
                         const CGAL_NP_CLASS_2& np2 = parameters::default_values())
{
  const auto run = [&](auto& arrays1, auto& arrays2, internal::Run_control& control,
                       const internal::Execution& execution) -> Error_code {
    const auto aligned = [](auto& arrays) {
      internal::Surface_to_align result;
      for(const auto& p : arrays.images)
        result.directions.push_back(internal::direction_of(p));
      result.points = std::move(arrays.points);
      result.triangles = std::move(arrays.triangles);
      return result;
    };
    internal::Surface_to_align first = aligned(arrays1), second = aligned(arrays2);
    if(!internal::read_features<0>(features, arrays1.vertices_of_mesh, first.features) ||
       !internal::read_features<1>(features, arrays2.vertices_of_mesh, second.features))
      return ERROR_WRONG_PARAMETER;
    return internal::find_rotations(first, second, alignment, control, execution);
  };
  return internal::with_two_surfaces<ConcurrencyTag, true>(tmesh1, vertex_sphere_map1, np1, tmesh2, vertex_sphere_map2,
                                                           np2, run);
}

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// finds these rotations with the features of the package.
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh1, class VertexSphereMap1,
          class TriangleMesh2, class VertexSphereMap2, typename CGAL_NP_TEMPLATE_PARAMETERS_1,
          typename CGAL_NP_TEMPLATE_PARAMETERS_2>
Error_code align_spheres(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1, const TriangleMesh2& tmesh2,
                         VertexSphereMap2 vertex_sphere_map2, Sphere_alignment_3& alignment,
                         const CGAL_NP_CLASS_1& np1 = parameters::default_values(),
                         const CGAL_NP_CLASS_2& np2 = parameters::default_values())
{
  using Feature = std::pair<double (*)(typename boost::graph_traits<TriangleMesh1>::vertex_descriptor),
                            double (*)(typename boost::graph_traits<TriangleMesh2>::vertex_descriptor)>;
  return align_spheres<ConcurrencyTag>(tmesh1, vertex_sphere_map1, tmesh2, vertex_sphere_map2, std::array<Feature, 0>(),
                                       alignment, np1, np2);
}

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// finds the rotation of the sphere of one surface that minimizes the sum of the squared distances between the directions of
/// landmarks and of the corresponding landmarks on the sphere of another surface \cgalCite{cgal:h-csaouq-87}. The result is
/// never a reflection.
///
/// <b>Complexity.</b> The running time is linear in the number of landmarks.
///
/// \tparam VertexSphereMap1,VertexSphereMap2 models of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type
/// \tparam Landmarks a range of `std::pair` of a vertex of the first surface and a vertex of the second surface, the keys of
///         the maps
///
/// \param vertex_sphere_map1,vertex_sphere_map2 the images of the vertices, at any distance from the origin
/// \param landmarks the pairs of corresponding vertices
/// \param rotation receives the rotation of the first sphere
///
/// \return `OK`; `ERROR_INVALID_DIRECTION` if an image is zero or not finite; or `ERROR_UNDETERMINED_ROTATION` if several
///         rotations are equally good: there are fewer than two landmarks, or all landmarks lie on one line through the origin.
///         The rotation is not changed if an error is returned.
///
/// \sa `CGAL::Spherical_parameterization::align_spheres()`
template <class VertexSphereMap1, class VertexSphereMap2, class Landmarks>
Error_code fit_rotation(VertexSphereMap1 vertex_sphere_map1, VertexSphereMap2 vertex_sphere_map2,
                        const Landmarks& landmarks, Sphere_alignment_3::Rotation_3& rotation)
{
  std::vector<std::pair<internal::Vector_3d, internal::Vector_3d>> directions;
  for(const auto& [v, w] : landmarks)
  {
    const internal::Vector_3d p = internal::direction_of(get(vertex_sphere_map1, v)),
                              q = internal::direction_of(get(vertex_sphere_map2, w));
    if(!internal::is_finite(p) || !internal::is_finite(q))
      return ERROR_INVALID_DIRECTION;
    directions.emplace_back(p, q);
  }
  const std::optional<internal::Rotation_matrix> matrix = internal::fitting_rotation(directions);
  if(!matrix)
    return ERROR_UNDETERMINED_ROTATION;
  rotation = internal::as_transformation(*matrix);
  return OK;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_ALIGN_SPHERES_H
