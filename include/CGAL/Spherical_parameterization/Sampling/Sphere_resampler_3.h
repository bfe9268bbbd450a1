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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_SPHERE_RESAMPLER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_SPHERE_RESAMPLER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Interpolation_weights.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
/// \ingroup PkgSphericalParameterizationEnums
///
/// The method by which `Sphere_resampler_3` computes the value of a target vertex from the values of source vertices.
enum class Resampling_method
{
  barycentric, ///< barycentric interpolation in the source triangle that contains its direction
  adaptive,    ///< interpolation where the target is finer, and averages weighted with areas where it is coarser
  nearest,     ///< the value of the source vertex with the largest weight of `barycentric`
  largest      ///< the value of the source vertex with the largest weight of `adaptive`
};

namespace internal {

struct Resampling_settings
{
  Resampling_method method = Resampling_method::barycentric;
  std::vector<double> source_areas, target_areas;
  std::vector<bool> mask;
};

// Checks that points and triangles form a closed surface that is mapped bijectively to the sphere around the origin.
Error_code check_sphere(const std::vector<Vector_3d>& points, const Index_triangles& triangles,
                        const Execution& execution);

// Computes the weights of the source vertices for each target vertex.
Error_code connect_spheres(const Resampling_settings& settings, const std::vector<Vector_3d>& source,
                           const Index_triangles& source_triangles, const std::vector<Vector_3d>& target,
                           const Index_triangles& target_triangles, Interpolation_weights& weights,
                           const Execution& execution);

} // namespace internal

/// \ingroup PkgSphericalParameterizationSampling
///
/// The class `Sphere_resampler_3` resamples values at the vertices of one sphere to the vertices of another sphere that is
/// registered with it. The weights are computed once. It implements the resampling of cortical surfaces as defined by
/// Connectome Workbench \cgalCite{cgal:gswcfawxjp-mpphcp-13}.
///
/// Spheres are given as arrays: points around the origin, at any distance from it, and triangles. They may have been computed
/// by any program, and their coordinates may have been rounded to single precision, but each sphere must be bijective. For
/// properties of meshes, see `transfer()`, which has no settings.
///
/// - `Resampling_method::barycentric`: the weights are the barycentric coordinates of the direction of the target vertex in
///   the source triangle that contains it, see `Sphere_locator_3`.
/// - `Resampling_method::adaptive`: each source vertex distributes its barycentric coordinates in the target triangle that
///   contains it. If a target vertex receives a coordinate from a source vertex that would not be interpolated at the target
///   vertex, its weights are the received coordinates. All other target vertices have the weights of the interpolation. Each
///   weight is multiplied by the area of the target vertex, and the weights of each source vertex are scaled so that their sum
///   is its own area. As a result, no source vertex is ignored, and each one contributes according to its area.
/// - Source vertices that the mask excludes have weight 0. The weights of a target vertex are divided by their sum.
///
/// Values are averaged as in `transfer()`. For labels, the label with the largest sum of weights is selected.
///
/// <b>Complexity.</b> Running time and memory are linear in the size of the spheres, unless triangles are long and narrow.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
///
/// \sa `CGAL::Spherical_parameterization::transfer()`
template <class ConcurrencyTag = Parallel_if_available_tag>
class Sphere_resampler_3
{
public:
  /// Type of an array of points or vectors
  using Points = std::vector<std::array<double, 3>>;
  /// Type of an array of triangles: indices of their vertices, counterclockwise as seen from outside
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// sets the method, `Resampling_method::barycentric` by default, and returns the resampler.
  Sphere_resampler_3& method(Resampling_method method)
  {
    m_settings.method = method;
    return *this;
  }

  /// sets the areas of the vertices, which the adaptive methods require, and returns the resampler.
  ///
  /// \param of_source,of_target an area for each vertex, in any unit
  ///
  /// \sa `vertex_areas()`
  Sphere_resampler_3& areas(std::vector<double> of_source, std::vector<double> of_target)
  {
    m_settings.source_areas = std::move(of_source);
    m_settings.target_areas = std::move(of_target);
    return *this;
  }

  /// sets the mask of the source vertices that are included, and returns the resampler. If the mask is empty, all are included.
  Sphere_resampler_3& mask(std::vector<bool> mask)
  {
    m_settings.mask = std::move(mask);
    return *this;
  }

  /// computes the weights. There are no weights if an error is returned.
  ///
  /// \param source,target the points of both spheres
  /// \param source_triangles,target_triangles the triangles of both spheres
  ///
  /// \return `OK`; `ERROR_EMPTY_MESH` if a sphere has no triangle; `ERROR_TOO_LARGE_MESH`; `ERROR_NON_FINITE_COORDINATE`;
  ///         `ERROR_NON_CLOSED_MESH` if an edge does not have two triangles in opposite directions;
  ///         `ERROR_NO_1_TO_1_MAPPING` if a triangle is not positively oriented as seen from the origin, or the triangles do
  ///         not cover the sphere once; or `ERROR_WRONG_PARAMETER` if an index of a triangle is out of range, if the number of
  ///         areas or of elements of the mask differs from the number of vertices, or if an area is negative or not finite
  Error_code connect(const Points& source, const Triangles& source_triangles, const Points& target,
                     const Triangles& target_triangles)
  {
    m_weights = internal::Interpolation_weights();
    m_target_triangles.clear();
    m_n_source = source.size();
    if(const Error_code error =
           internal::connect_spheres(m_settings, source, source_triangles, target, target_triangles, m_weights,
                                     internal::execution_of<ConcurrencyTag>()))
      return error;
    m_target_triangles = target_triangles;
    return OK;
  }

  /// resamples values from the source vertices to the target vertices.
  ///
  /// \tparam T a value type as for `transfer()`, except `bool`, because `std::vector<bool>` has no elements of type `bool`
  ///
  /// \param values the values at the source vertices
  /// \param result receives the values at the target vertices; a vertex without a value receives `T()`, see `has_value()`
  ///
  /// \return `OK`; or `ERROR_WRONG_PARAMETER` if the number of values differs from the number of source vertices, or if there
  ///         are no weights
  template <class T>
  Error_code resample(const std::vector<T>& values, std::vector<T>& result) const
  {
    if(m_weights.size() == 0 || values.size() != m_n_source)
      return ERROR_WRONG_PARAMETER;
    std::vector<T> resampled(m_weights.size());
    m_weights.template mix<T>(
        values.size(), [&](std::size_t i) -> const T& { return values[i]; },
        [&](std::size_t i, const T& value) { resampled[i] = value; }, internal::execution_of<ConcurrencyTag>());
    result = std::move(resampled);
    return OK;
  }

  /// maps the vertices of the target through a registration: the source is a sphere before the registration, and `sphere` is the
  /// same sphere after it, or vice versa. Each target vertex has the same face and barycentric coordinates on both spheres.
  ///
  /// \param sphere the points of the other sphere, which has the triangles of the source
  /// \param result receives the points of the target vertices, at the interpolated distance from the origin
  ///
  /// \return the result of `resample()`; or `ERROR_NO_1_TO_1_MAPPING` if the result is not bijective, which may happen if the
  ///         target triangles are large; the result is written nevertheless
  Error_code resample_sphere(const Points& sphere, Points& result) const
  {
    using internal::operator*;
    Points resampled;
    std::vector<double> lengths, radii;
    for(const internal::Vector_3d& p : sphere)
      lengths.push_back(internal::length(p));
    if(const Error_code error = resample(sphere, resampled))
      return error;
    if(const Error_code error = resample(lengths, radii))
      return error;
    for(std::size_t v = 0; v < resampled.size(); ++v)
      if(const double length = internal::length(resampled[v]); length > 0.)
        resampled[v] = (radii[v] / length) * resampled[v];
    result = std::move(resampled);
    return internal::check_sphere(result, m_target_triangles, internal::execution_of<ConcurrencyTag>());
  }

  /// returns for each target vertex whether it has a value: whether a source vertex that is included has a positive weight.
  std::vector<bool> has_value() const
  {
    std::vector<bool> result;
    for(std::size_t v = 0; v < m_weights.size(); ++v)
      result.push_back(m_weights.terms(v).begin() != m_weights.terms(v).end());
    return result;
  }

  /// returns the areas of the vertices of a surface: one third of the area of each incident triangle.
  ///
  /// \param points the points of the surface
  /// \param triangles its triangles, whose indices must be valid
  static std::vector<double> vertex_areas(const Points& points, const Triangles& triangles)
  {
    return internal::vertex_areas(triangles, points);
  }

private:
  internal::Resampling_settings m_settings;
  std::size_t m_n_source = 0;
  Triangles m_target_triangles;
  internal::Interpolation_weights m_weights;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Sampling/internal/sampling_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_SPHERE_RESAMPLER_3_H
