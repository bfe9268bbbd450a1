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
/// The method of `map_surface()`, with what is known of two surfaces before. Settings are chained, each returning a copy;
/// what is left out, it finds itself. The map is given by images of vertices on a common sphere
/// \cgalCite{cgal:scbk-ismccm-20}, and its symmetric Dirichlet energy \cgalCite{cgal:ss-bpfb-15} is lowered from coarse to fine
/// \cgalCite{cgal:saph-ism-04}.
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
  /// Type of vertices that correspond
  using Landmark = std::pair<Vertex_1, Vertex_2>;
  /// Type of a feature: its values at the vertices of both surfaces
  using Feature = std::pair<std::function<double(Vertex_1)>, std::function<double(Vertex_2)>>;
  /// Type of masks: whether each surface counts at a vertex; everywhere if a function is empty
  using Masks = std::pair<std::function<bool(Vertex_1)>, std::function<bool(Vertex_2)>>;

  /// \name Settings
  /// Each function returns a mapper with one setting changed, so that they can be chained.
  /// @{

  /// sets vertices that correspond. They lead the alignment of the surfaces together with features, and choose among what is found. If
  /// features agree by less than 0.5 in the end, and there are two or more in different directions, these alone rotate the spheres.
  [[nodiscard]] Surface_mapper_3 landmarks(std::vector<Landmark> landmarks) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_landmarks = std::move(landmarks); });
  }

  /// makes landmarks soft: the mean of their squared distances, on a sphere of radius 1, is added to the mean energy, times
  /// `weight`, which has to be positive; 10 is a strong one. By default they are met exactly, but where straight edges do
  /// not allow for it.
  [[nodiscard]] Surface_mapper_3 landmark_weight(double weight) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.landmark_weight = weight; });
  }

  /// sets features of the surfaces that are to agree. Only the order of their values counts, unless `compare_values()` says
  /// otherwise. By default the package has its own.
  [[nodiscard]] Surface_mapper_3 features(std::vector<Feature> features) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_features = std::move(features); });
  }

  /// sets how much `features()` count beside each other by their `weights`, one for each, at least 0 and not all 0. By default all
  /// count the same.
  [[nodiscard]] Surface_mapper_3 feature_weights(std::vector<double> weights) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.feature_weights = std::move(weights); });
  }

  /// compares the values of `features()` and not their ranks, if `compares_values` is `true`: less the mean over both surfaces,
  /// in units of the root of three times their variance, such that they spread as ranks do. It is for what means the same on
  /// both, such as a thickness; ranks also suit what is on another scale on the other surface, or has outliers.
  [[nodiscard]] Surface_mapper_3 compare_values(bool compares_values = true) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.compares_values = compares_values; });
  }

  /// sets where the surfaces count. At other vertices, such as those that holes have been filled with, or of the medial wall of a
  /// cortex, features are not compared, and tips of extremities are not looked for; what features have there on the second surface
  /// is continued from around it. The map is a bijection there as well, of low distortion.
  [[nodiscard]] Surface_mapper_3 masks(Masks masks) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_masks = std::move(masks); });
  }

  /// sets the weight of features once they have aligned the spheres, 4 by default: the mean of the squared differences of
  /// their ranks, which are from -1 to 1, is added to the mean energy, times this weight; for features of the package, times
  /// the fourth power of their agreement as well. The `weight` is at least 0; with 0, features only align the spheres.
  [[nodiscard]] Surface_mapper_3 feature_weight(double weight) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.feature_weight = weight; });
  }

  /// keeps the rotations of both spheres, if `keeps_alignment` is `true`, and goes on from there: with what `map_surface()`
  /// has found as the map of the first surface, and perhaps after `split_bent_faces()`. Only the finest level is swept, unless
  /// hard landmarks have to be moved. Features of the package, which align the spheres, are left out.
  [[nodiscard]] Surface_mapper_3 keep_alignment(bool keeps_alignment = true) const
  {
    return with([&](Surface_mapper_3& mapper) { mapper.m_settings.keeps_alignment = keeps_alignment; });
  }

  /// @}

  /// maps a surface onto another one: what `CGAL::Spherical_parameterization::map_surface()` calls, which see.
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

  /// returns what the last run has found.
  const Surface_map_report& report() const { return m_report; }

  /// writes how far the image of each vertex of the first surface is expected to be from where it should be, over the
  /// root of the area of the second surface, at most 0.5: see `Surface_map_report::expected_error`.
  ///
  /// \tparam VertexErrorMap a model of `WritablePropertyMap` from the vertices of `TriangleMesh1` to `double`
  /// \param vertex_error_map receives the values; that of a vertex without a face stays as it is
  /// \return `false` if there is no estimate: nothing is written then
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
