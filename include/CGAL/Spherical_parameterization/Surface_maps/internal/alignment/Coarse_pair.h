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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_COARSE_PAIR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_COARSE_PAIR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Rotation_search.h>

#include <memory>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Two coarse surfaces that are compared, and the goals of maps from the first one to the sphere of the second one: features,
// landmarks, and distances along the surfaces. The control is called between parts of the work. All data are valid if it stops the
// run at any of these points.
class Coarse_pair
{
public:
  using Guides = std::array<std::vector<Vertex_scalars>, 2>; // features of both surfaces

  Coarse_pair(Surface_descriptor first, Surface_descriptor second, Run_control& control, const Execution& execution)
    : Coarse_pair(std::make_shared<Surface_descriptor>(std::move(first)),
                  std::make_shared<Surface_descriptor>(std::move(second)), control, execution)
  {}

  // The same surfaces and landmarks in the opposite order.
  Coarse_pair reversed() const
  {
    Coarse_pair result(m_surfaces[1], m_surfaces[0], m_control, m_execution);
    std::vector<std::pair<Vector_3d, Vector_3d>> landmarks;
    for(const auto& [p, q] : m_landmarks)
      landmarks.emplace_back(q, p);
    result.set_landmarks(landmarks);
    return result;
  }

  // Sets pairs of corresponding directions, which contribute to the choice of the best alignment, and guide all starts.
  void set_landmarks(const std::vector<std::pair<Vector_3d, Vector_3d>>& landmarks)
  {
    if(landmarks.empty())
      return;
    m_landmarks = landmarks;
    in_parallel(2, [&](std::size_t k) { m_surfaces[k]->measure_distances(); });
    Guides distances;
    for(const auto& [p, q] : landmarks)
    {
      distances[0].push_back(first().distances_from(p));
      distances[1].push_back(second().distances_from(q));
    }
    m_landmark_image.emplace(image(distances[1]));
    for(std::size_t surface = 0; surface < 2; ++surface)
      for(const Vertex_scalars& d : distances[surface])
        m_landmark_guides[surface].push_back(scaled(d, factor_of_leading_guides));
  }

  const Surface_descriptor& first() const { return *m_surfaces[0]; }
  const Surface_descriptor& second() const { return *m_surfaces[1]; }

  // The points of the first surface, scaled to area 4 pi.
  const std::vector<Vector_3d>& points() const { return m_points; }

  // The goals given by the features alone.
  const Feature_goals& feature_goals() const { return m_features; }

  // Images of the features of both surfaces that are compared on finer levels as well.
  std::vector<Sphere_image> feature_images() const
  {
    constexpr std::size_t n = Surface_descriptor::number_of_kept_features;
    return {Sphere_image(Sphere_image::locate_nodes(first().sphere(), m_execution), first().sphere().triangles(),
                         at_most(n, first().features())),
            image(at_most(n, second().features()))};
  }

  // The best rotations in the order of decreasing score; at least one.
  std::vector<Scored_rotation> best_rotations(std::size_t n) const
  {
    return Rotation_search(first(), *m_features.image, m_execution).best(n, m_control);
  }

  // The rotation by 20 degrees or more after which the second surface resembles itself most. For a body with two similar sides, it is
  // nearly a half-turn. If there is none, or the run is stopped, another rotation, which is a useless but valid start.
  Rotation_matrix symmetry_of_second() const
  {
    return Rotation_search(second(), *m_features.image, m_execution).best(2, m_control).back().rotation;
  }

  using Extremities = std::vector<Surface_descriptor::Origin>;
  std::array<Extremities, 2> extremities()
  {
    std::array<Extremities, 2> result;
    in_parallel(2, [&](std::size_t k) { result[k] = m_surfaces[k]->extremities(); });
    return result;
  }

  // The distances from corresponding extremities and from landmarks, which guide a descent along with the features.
  Guides distance_guides(const std::array<Extremities, 2>& extremities,
                         const std::vector<std::array<std::uint32_t, 2>>& pairs) const
  {
    Guides result;
    for(std::size_t surface = 0; surface < 2; ++surface)
      for(const auto& pair : pairs)
        result[surface].push_back(scaled(extremities[surface][pair[surface]].distances, factor_of_leading_guides));
    add_landmarks(result);
    return result;
  }

  // Coordinates on the second sphere, which guide the vertices of the first surface to these images.
  Guides position_guides(const std::vector<Vector_3d>& images) const
  {
    Guides result;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const auto coordinate = [&](const std::vector<Vector_3d>& directions) {
        Vertex_scalars values;
        for(const Vector_3d& p : directions)
          values.push_back(factor_of_leading_guides * p[k]);
        return values;
      };
      result[0].push_back(coordinate(images));
      result[1].push_back(coordinate(second().directions()));
    }
    add_landmarks(result);
    return result;
  }

  // Computes the data for eigenfunction_guides().
  void find_spectra()
  {
    in_parallel(2, [&](std::size_t k) { m_surfaces[k]->find_spectrum(); });
  }

  // The first n eigenfunctions of the first surface, and the closest combinations of those of the second surface under a map. An
  // isometry maps them to each other. Where surfaces differ too much for a function, the combination is nearly 0 and gives no
  // guidance (Ovsjanikov et al., Functional maps, 2012).
  Guides eigenfunction_guides(const std::vector<Vector_3d>& directions, std::size_t n) const
  {
    constexpr double factor_of_functions = 16.; // with 8 or 30, the mean error is the same
    Guides result = {at_most(n, first().spectrum().functions()), {}};
    const std::vector<Vertex_scalars> functions = at_most(n, second().spectrum().functions());
    std::vector<Vertex_scalars> carried(functions.size(), Vertex_scalars(directions.size()));
    const auto locations = second().sphere().locate(points_of(directions), m_execution);
    for(std::size_t k = 0; k < functions.size(); ++k)
      for(std::size_t v = 0; v < directions.size(); ++v)
        carried[k][v] = first().areas()[v] * interpolated(functions[k], second().sphere().triangles(), locations[v]);
    result[1].assign(result[0].size(), Vertex_scalars(second().size(), 0.));
    in_parallel(result[0].size(), [&](std::size_t i) {
      for(std::size_t k = 0; k < functions.size(); ++k)
      {
        const double factor = factor_of_functions * sum_of_products(result[0][i], carried[k]);
        add_multiple(factor, functions[k], result[1][i]);
      }
      result[0][i] = scaled(std::move(result[0][i]), factor_of_functions);
    });
    add_landmarks(result);
    return result;
  }

  // The mean distance of a map from the landmarks, in units of the mean of all distances; 0 without landmarks.
  template <class Function>
  double distance_from_landmarks(const Function& image_of) const
  {
    double sum = 0.;
    std::vector<double> distances(m_landmarks.size());
    for(std::size_t k = 0; k < m_landmarks.size(); ++k)
    {
      m_landmark_image->interpolate(image_of(m_landmarks[k].first), distances.data());
      sum += distances[k];
    }
    return m_landmarks.empty() ? 0. : sum / static_cast<double>(m_landmarks.size());
  }

  // The goals given by the features and by additional ones.
  Feature_goals goals(Guides guides) const
  {
    for(std::size_t surface = 0; surface < 2; ++surface)
      guides[surface].insert(guides[surface].end(), m_surfaces[surface]->features().begin(),
                             m_surfaces[surface]->features().end());
    Feature_goals result;
    result.image = image(guides[1]);
    result.set_values(guides[0]);
    result.mask = first().mask();
    return result;
  }

  bool goes_on() const { return m_control.go_further(0, 0.); }
  Run_control& control() const { return m_control; }
  const Execution& execution() const { return m_execution; }

private:
  Coarse_pair(std::shared_ptr<Surface_descriptor> first, std::shared_ptr<Surface_descriptor> second,
              Run_control& control, const Execution& execution)
    : m_surfaces{std::move(first), std::move(second)}
    , m_control(control)
    , m_execution(execution)
  {
    if(m_surfaces[0]->features().empty())
      for(int feature = 0; feature < Surface_descriptor::number_of_own_features && goes_on(); ++feature)
        in_parallel(2, [&](std::size_t k) { m_surfaces[k]->add_own_feature(feature); });
    for(const Vector_3d& p : m_surfaces[0]->points())
      m_points.push_back(std::sqrt(4. * CGAL_PI) * p);
    m_nodes = Sphere_image::locate_nodes(m_surfaces[1]->sphere(), execution);
    m_features = goals({});
  }

  template <class Function>
  void in_parallel(std::size_t n, const Function& f) const
  {
    for_each_in_blocks(m_execution, 0, n, 1, f);
  }

  void add_landmarks(Guides& guides) const
  {
    for(std::size_t surface = 0; surface < 2; ++surface)
      guides[surface].insert(guides[surface].end(), m_landmark_guides[surface].begin(),
                             m_landmark_guides[surface].end());
  }

  Sphere_image image(const std::vector<Vertex_scalars>& channels) const
  {
    return Sphere_image(m_nodes, second().sphere().triangles(), channels);
  }

  // The first n channels; fewer if a run is stopped before all are computed, or if a surface is small.
  static std::vector<Vertex_scalars> at_most(std::size_t n, std::vector<Vertex_scalars> channels)
  {
    channels.resize((std::min)(n, channels.size()));
    return channels;
  }

  static Vertex_scalars scaled(Vertex_scalars values, double factor)
  {
    for(double& x : values)
      x *= factor;
    return values;
  }

  // Relative to ranks from -1 to 1, for distances with mean 1 and for coordinates. With 2 or 6, people are aligned less accurately.
  static constexpr double factor_of_leading_guides = 4.;

  std::array<std::shared_ptr<Surface_descriptor>, 2> m_surfaces; // shared with the reversed pair
  std::vector<Vector_3d> m_points;
  Run_control& m_control;
  Execution m_execution;
  Sphere_image::Locations m_nodes; // the nodes of images, on the second sphere
  Feature_goals m_features;
  std::vector<std::pair<Vector_3d, Vector_3d>> m_landmarks;
  Guides m_landmark_guides;
  std::optional<Sphere_image> m_landmark_image;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_COARSE_PAIR_H
