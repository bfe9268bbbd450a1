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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_MAPPER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_MAPPER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/find_surface_map.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/read_two_surfaces.h>
#include <CGAL/Spherical_parameterization/internal/run/write_map.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <functional>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// The class `Surface_mapper_3` implements the method of `map_surface()`, and holds its settings: landmarks, features, masks
/// and weights. All settings are optional.
///
/// The map is represented by the images of the vertices of the first surface on the sphere of the second one
/// \cgalCite{cgal:scbk-ismccm-20}. Its symmetric Dirichlet energy \cgalCite{cgal:ss-bpfb-15} is minimized from coarse to fine
/// levels \cgalCite{cgal:saph-ism-04}. See \ref PkgSphericalParameterizationHowItWorks for details.
///
/// \tparam TriangleMesh1,TriangleMesh2 the types of the surfaces
template <class TriangleMesh1, class TriangleMesh2 = TriangleMesh1>
class Surface_mapper_3
{
public:
  /// Type of a vertex of the first surface
  using Vertex_1 = typename boost::graph_traits<TriangleMesh1>::vertex_descriptor;
  /// Type of a vertex of the second surface
  using Vertex_2 = typename boost::graph_traits<TriangleMesh2>::vertex_descriptor;
  /// Type of a landmark: a vertex of the first surface and the corresponding vertex of the second surface
  using Landmark = std::pair<Vertex_1, Vertex_2>;
  /// Type of a feature: its values at the vertices of both surfaces
  using Feature = std::pair<std::function<double(Vertex_1)>, std::function<double(Vertex_2)>>;
  /// Type of masks: functions that return whether a vertex of the first or of the second surface is included. If a function
  /// is empty, all vertices are included.
  using Masks = std::pair<std::function<bool(Vertex_1)>, std::function<bool(Vertex_2)>>;

  /// \name Settings
  /// Each function returns a copy of the mapper with one setting changed, so that calls can be chained.
  /// @{

  /// sets the landmarks.
  ///
  /// Landmarks guide the alignment together with features, and contribute to the score of the candidates. If the features
  /// agree by less than 0.5 on coarse surfaces, or if fewer hard landmarks are missed, the rotation is determined by landmarks
  /// alone, unless fewer than two landmarks have different directions.
  [[nodiscard]] Surface_mapper_3 landmarks(std::vector<Landmark> landmarks) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_landmarks = std::move(landmarks); });
  }

  /// makes landmarks soft: the mean of their squared distances on the unit sphere, times `weight`, is added to the mean energy.
  ///
  /// By default, landmarks are hard: they are met exactly, unless the straight edges of the first mesh do not allow it.
  ///
  /// \param weight a positive number; 10 is a strong weight
  [[nodiscard]] Surface_mapper_3 landmark_weight(double weight) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.landmark_weight = weight; });
  }

  /// sets the features that are compared. By default, the features of the package are used.
  ///
  /// Only the order of the values of a feature matters, unless `compare_values()` is set.
  [[nodiscard]] Surface_mapper_3 features(std::vector<Feature> features) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_features = std::move(features); });
  }

  /// sets the relative weights of the `features()`. By default, all features have the same weight.
  ///
  /// \param weights one weight for each feature, non-negative and not all 0
  [[nodiscard]] Surface_mapper_3 feature_weights(std::vector<double> weights) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.feature_weights = std::move(weights); });
  }

  /// compares the values of `features()` instead of their ranks, if `compares_values` is `true`.
  ///
  /// The mean over both surfaces is subtracted from the values, and the result is divided by the square root of three times
  /// their variance, so that the values have the variance of ranks. Compare values if they have the same meaning on both
  /// surfaces, for example a thickness. Ranks are also suitable if the scales differ between the surfaces, or if there are
  /// outliers.
  [[nodiscard]] Surface_mapper_3 compare_values(bool compares_values = true) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.compares_values = compares_values; });
  }

  /// sets the vertices that are included in the comparison of the surfaces.
  ///
  /// At excluded vertices, such as those of hole patches or of the medial wall of a cortical surface, features are not
  /// compared, and no tips of extremities are detected. On the second surface, features are extended to excluded vertices from
  /// their surroundings. The map is bijective and has low distortion there as well.
  [[nodiscard]] Surface_mapper_3 masks(Masks masks) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_masks = std::move(masks); });
  }

  /// sets the weight of features in the descent after the first levels of the alignment. The default is 4.
  ///
  /// The mean of the squared differences of their ranks, which range from -1 to 1, times this weight is added to the mean
  /// energy. On levels finer than the coarse surfaces, the weight of features of the package is also multiplied by the fourth
  /// power of their agreement.
  ///
  /// \param weight a non-negative number; with 0, features only propose alignments and compare them on coarse surfaces
  [[nodiscard]] Surface_mapper_3 feature_weight(double weight) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.feature_weight = weight; });
  }

  /// keeps the current rotations of both spheres, if `keeps_alignment` is `true`.
  ///
  /// Use this setting to continue from a map that `map_surface()` has found, for example after `split_bent_faces()`: pass the
  /// map as the map of the first surface. Only the finest level is processed, unless hard landmarks have to be moved. The
  /// features of the package are not used, because they serve the alignment of the spheres.
  [[nodiscard]] Surface_mapper_3 keep_alignment(bool keeps_alignment = true) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.keeps_alignment = keeps_alignment; });
  }

  /// @}

  /// maps a surface onto another one, see `CGAL::Spherical_parameterization::map_surface()`, which calls this function.
  template <class ConcurrencyTag = Parallel_if_available_tag, class VertexSphereMap1, class VertexSphereMap2,
            class VertexDirectionMap, typename CGAL_NP_TEMPLATE_PARAMETERS_1, typename CGAL_NP_TEMPLATE_PARAMETERS_2>
  Error_code map_surface(const TriangleMesh1& tmesh1, VertexSphereMap1 vertex_sphere_map1, const TriangleMesh2& tmesh2,
                         VertexSphereMap2 vertex_sphere_map2, VertexDirectionMap vertex_direction_map,
                         const CGAL_NP_CLASS_1& np1 = parameters::default_values(),
                         const CGAL_NP_CLASS_2& np2 = parameters::default_values())
  {
    m_report = Surface_map_report();
    m_expected_errors.clear();
    if(!m_settings.are_valid(m_features.size()))
      return ERROR_WRONG_PARAMETER;
    const auto run = [&](auto& first, auto& second, internal::Run_control& control,
                         const internal::Execution& execution) -> Error_code {
      const auto& vertices1 = first.vertices_of_mesh;
      const auto& vertices2 = second.vertices_of_mesh;
      internal::Surface_map_settings settings = m_settings;
      if(!internal::read_landmarks<0>(m_landmarks, vertices1, settings.landmarks) ||
         !internal::read_landmarks<1>(m_landmarks, vertices2, settings.landmarks))
        return ERROR_INVALID_LANDMARK;
      if(!internal::read_features<0>(m_features, vertices1, settings.features[0]) ||
         !internal::read_features<1>(m_features, vertices2, settings.features[1]) ||
         !internal::read_mask(m_masks.first, vertices1, settings.masks[0]) ||
         !internal::read_mask(m_masks.second, vertices2, settings.masks[1]))
        return ERROR_WRONG_PARAMETER;
      internal::Index_triangles triangles;
      for(const internal::Linked_triangle& t : first.triangles)
        triangles.push_back(t.vertices);
      std::vector<internal::Vector_3d> directions;
      std::vector<double> errors;
      if(const Error_code error =
             internal::find_surface_map(internal::surface_of(first), internal::surface_of(second), std::move(settings),
                                        directions, errors, m_report, control, execution))
        return error;
      const Error_code error = internal::write_map(vertices1, triangles, directions, 1.,
                                                   internal::Guarantee::ONE_TO_ONE, vertex_direction_map, execution);
      for(std::size_t v = 0; v < errors.size() && error == OK; ++v)
        m_expected_errors.emplace_back(vertices1[v], errors[v]);
      return error;
    };
    return internal::with_two_surfaces<ConcurrencyTag>(tmesh1, vertex_sphere_map1, np1, tmesh2, vertex_sphere_map2, np2,
                                                       run);
  }

  /// returns the report of the last run.
  const Surface_map_report& report() const { return m_report; }

  /// writes the expected error of each vertex of the first surface: the expected distance between its image and the correct
  /// corresponding point, divided by the square root of the area of the second surface, at most 0.5. See
  /// `Surface_map_report::expected_error`.
  ///
  /// \tparam VertexErrorMap a model of `WritablePropertyMap` from the vertices of `TriangleMesh1` to `double`
  /// \param vertex_error_map receives the values; the value of an isolated vertex is not changed
  /// \return `false` if there is no estimate; nothing is written then
  template <class VertexErrorMap>
  bool get_expected_errors(VertexErrorMap vertex_error_map) const
  {
    for(const auto& [v, error] : m_expected_errors)
      put(vertex_error_map, v, error);
    return !m_expected_errors.empty();
  }

private:
  template <class Change>
  Surface_mapper_3 with(const Change& change) const
  {
    Surface_mapper_3 result = *this;
    result.m_report = Surface_map_report();
    result.m_expected_errors.clear();
    change(result);
    return result;
  }

  std::vector<Landmark> m_landmarks;
  std::vector<Feature> m_features;
  Masks m_masks;
  internal::Surface_map_settings m_settings;
  Surface_map_report m_report;
  std::vector<std::pair<Vertex_1, double>> m_expected_errors;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_MAPPER_3_H
