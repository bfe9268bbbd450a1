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
/// What a vertex gets from those of another sphere by `Sphere_resampler_3`.
enum class Resampling_method
{
  barycentric, ///< what is interpolated at its direction
  adaptive,    ///< the same where the target is finer, and averages, weighted with areas, where it is coarser
  nearest,     ///< what the vertex has that is interpolated with the largest weight
  largest      ///< what the vertex has whose weight by `adaptive` is largest
};

namespace internal {

struct Resampling_settings
{
  Resampling_method method = Resampling_method::barycentric;
  std::vector<double> source_areas, target_areas;
  std::vector<bool> mask;
};

// Checks that points and triangles are a closed surface around the origin, one-to-one.
Error_code check_sphere(const std::vector<Vector_3d>& points, const Index_triangles& triangles,
                        const Execution& execution);

// Finds the weights of the vertices of the source for those of the target.
Error_code connect_spheres(const Resampling_settings& settings, const std::vector<Vector_3d>& source,
                           const Index_triangles& source_triangles, const std::vector<Vector_3d>& target,
                           const Index_triangles& target_triangles, Interpolation_weights& weights,
                           const Execution& execution);

} // namespace internal

/// \ingroup PkgSphericalParameterizationSampling
///
/// The class `Sphere_resampler_3` carries values from the vertices of one sphere to those of another one that is in register with
/// it, by weights that are computed once: the resampling of cortical surfaces, with the definitions of Connectome Workbench
/// \cgalCite{cgal:gswcfawxjp-mpphcp-13}. Spheres are flat arrays, as files and numpy have them: points around the
/// origin, at any distance from it, and triangles. They may have been made by any program, with coordinates that were
/// rounded to 32 bits, but each has to be one-to-one. `transfer()` is for properties of meshes, and takes no settings.
///
/// - `Resampling_method::barycentric`: the barycentric coordinates of the direction in the triangle of the source that contains
///   it; see `Sphere_locator_3`.
/// - `Resampling_method::adaptive`: each vertex of the source hands out its barycentric coordinates in the triangle of the target that
///   contains it. A vertex of the target that is handed anything by a source which would not be interpolated there has
///   the weights that are handed to it; all others have those of the interpolation. A weight is multiplied by the area of the
///   target, and those of each source are scaled to its own area in all. So no source is left out, and each counts by its area.
/// - Sources that the mask leaves out have no weight. The weights of a vertex of the target are divided by their sum.
///
/// Values are averaged as `transfer()` says; labels get the one with the largest sum of weights.
///
/// Time and memory are linear in the size of the spheres, unless triangles are long and narrow.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
///
/// \sa `CGAL::Spherical_parameterization::transfer()`
template <class ConcurrencyTag = Parallel_if_available_tag>
class Sphere_resampler_3
{
public:
  /// Points or vectors
  using Points = std::vector<std::array<double, 3>>;
  /// Triangles by the numbers of their vertices, counterclockwise as seen from outside
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// sets the method, `Resampling_method::barycentric` by default, and returns the resampler.
  Sphere_resampler_3& method(Resampling_method method)
  {
    m_settings.method = method;
    return *this;
  }

  /// sets the areas around the vertices, which the adaptive methods need, and returns the resampler.
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

  /// sets which vertices of the source count, and returns the resampler; all if the mask is empty.
  Sphere_resampler_3& mask(std::vector<bool> mask)
  {
    m_settings.mask = std::move(mask);
    return *this;
  }

  /// computes the weights. With an error, there are none.
  ///
  /// \param source,target the points of both spheres
  /// \param source_triangles,target_triangles their triangles
  ///
  /// \return `OK`; `ERROR_EMPTY_MESH` if a sphere has no triangle; `ERROR_TOO_LARGE_MESH`; `ERROR_NON_FINITE_COORDINATE`;
  ///         `ERROR_NON_CLOSED_MESH` if there is an edge without two triangles in opposite directions;
  ///         `ERROR_NO_1_TO_1_MAPPING` if a triangle is not positively oriented as seen from the origin, or they
  ///         do not cover the sphere once; `ERROR_WRONG_PARAMETER` if a triangle has a vertex that is none, or there are not as
  ///         many areas or elements of the mask as vertices, or an area is negative or not finite
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

  /// carries over a value of each vertex.
  ///
  /// \tparam T a type of values, as for `transfer()`; `bool`, of which vectors have no elements, excepted
  ///
  /// \param values those of the source
  /// \param result receives those of the target; what gets nothing has `T()`; see `has_value()`
  ///
  /// \return `OK`, or `ERROR_WRONG_PARAMETER` if there are not as many values as the source has vertices, or no weights
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

  /// carries the vertices of the target through a registration: the source is a sphere as it was, and `sphere` the same one as
  /// it has been registered, or the other way round. Each vertex of the target has the same place on both of them.
  ///
  /// \param sphere the points of the other sphere, which has the triangles of the source
  /// \param result receives those of the target, at the distance from the origin that is interpolated
  ///
  /// \return as `resample()`; or `ERROR_NO_1_TO_1_MAPPING` if the result is no one-to-one map, which there is nothing to
  ///         exclude where the triangles of the target are large: it is written nevertheless
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

  /// returns whether each vertex of the target gets something: whether a source that the mask does not leave out has a weight.
  std::vector<bool> has_value() const
  {
    std::vector<bool> result;
    for(std::size_t v = 0; v < m_weights.size(); ++v)
      result.push_back(m_weights.terms(v).begin() != m_weights.terms(v).end());
    return result;
  }

  /// returns the areas around the vertices of a surface: a third of each of its triangles.
  ///
  /// \param points the points of the surface
  /// \param triangles its triangles, each of which has three of these points
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
