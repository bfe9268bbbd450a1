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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_ALIGNMENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_ALIGNMENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Extremity_search.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Rotation_search.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Sphere_image.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Surface_descriptor.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/map_score.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/polished_rotation.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_levels.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_metric.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_sphere.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// How two coarse surfaces, and their spheres, may lie on each other.
struct Alignment
{
  Rotation_matrix rotation = rotation_matrix({1., 0., 0., 0.});
  std::vector<Vector_3d> directions; // where the vertices of the first coarse surface go; none if they are but turned
  double agreement = 0.;             // the correlation of the features
  double score = 0.;                 // the same, less how much the map stretches, and how far it is from landmarks
  double missed = 0.;                // how far that is, in units of the mean distance
};

// Finds how two surfaces are to be laid on each other. The control is asked between parts of the work; what is there when
// it says no is valid.
//
// Spheres of poses of a body differ by more than a rotation: extremities lean to one side here and to the other one there, as both are
// nearly as good. So many starts are taken to their end on the coarse surfaces, and the outcome decides. A start is a
// rotation by which features agree, or one that brings extremities together that may be the same. The descent from there, of the
// energy of a map between surfaces, is led by features of great weight first, among them the distances from those extremities,
// which no pose changes and which tell from afar where to go. Then it is led by the features of the surfaces alone, with the
// weight that they have in the end.
class Surface_alignment
{
public:
  // How far the score of a start may be below the best one after the first levels. The start that wins in the end was below by 0.14 at
  // most, of 405 maps.
  static constexpr double max_lag = 0.2;

  Surface_alignment(Surface_descriptor first, Surface_descriptor second, Run_control& control,
                    const Execution& execution)
    : m_surfaces{std::move(first), std::move(second)}
    , m_control(control)
    , m_execution(execution)
  {
    if(m_surfaces[0].features().empty())
      for(int feature = 0; feature < Surface_descriptor::number_of_own_features && goes_on(); ++feature)
        in_parallel(2, [&](std::size_t k) { m_surfaces[k].add_own_feature(feature); });
    for(const Vector_3d& p : m_surfaces[0].points())
      m_points.push_back(std::sqrt(4. * CGAL_PI) * p);
    m_nodes = Sphere_image::places_of_nodes(m_surfaces[1].sphere(), execution);
    m_features = goals({}, 0.);
  }

  // Takes directions on both spheres that are the same place, by which the best alignment is chosen, and all starts are led.
  void set_landmarks(const std::vector<std::pair<Vector_3d, Vector_3d>>& landmarks)
  {
    if(landmarks.empty())
      return;
    in_parallel(2, [&](std::size_t k) { m_surfaces[k].measure_distances(); });
    for(const auto& [p, q] : landmarks)
    {
      m_landmarks.push_back(p);
      m_landmark_distances[0].push_back(m_surfaces[0].distances_from(p));
      m_landmark_distances[1].push_back(m_surfaces[1].distances_from(q));
    }
    m_landmark_image.emplace(image(m_landmark_distances[1]));
  }

  // The ranks of the features of a surface, 0 or 1.
  Sphere_image features(std::size_t surface) const
  {
    return surface == 1 ? *m_features.image
                        : Sphere_image(Sphere_image::places_of_nodes(m_surfaces[0].sphere(), m_execution),
                                       m_surfaces[0].sphere().triangles(), m_surfaces[0].features());
  }

  // The best rotations, the best one first; at least one.
  std::vector<Scored_rotation> best_rotations(std::size_t n) const
  {
    return Rotation_search(m_surfaces[0], *m_features.image, m_execution).best(n, m_control);
  }

  // The best maps of the first coarse surface to the sphere of the second surface, which has this metric, the best one first; at
  // least one. They differ from each other, by 20 degrees or more in the mean. The weight of the features is that of
  // the descent to come.
  template <class K>
  std::vector<Alignment> best(const Target_metric& metric, double feature_weight,
                              const Sphere_triangulation<K>& sphere1, const Sphere_triangulation<K>& sphere2)
  {
    // Copies of a surface with turned copies of its sphere have a score of nearly 1, poses of a body less. If it is larger,
    // copies are bent, to 1.3 degrees from each other where the rotation leaves 0.2; if it is smaller, poses are not bent.
    constexpr double min_score_of_same_shape = 0.97;
    // Different ways to lay a body are farther apart, in the mean. On the way, which of two near ones is better is not clear yet, unless
    // they are the same.
    constexpr double min_angle = CGAL_PI / 9., min_angle_on_the_way = CGAL_PI / 36.;
    // With these, one of the ten starts ends off by less than 12 percent on all 138 pairs that were tried. With four that are
    // carried on, a gorilla loses the one that is right.
    constexpr std::size_t n_rotations = 4, n_matchings = 6, n_carried_on = 5;
    std::vector<Alignment> result;
    for(const Scored_rotation& r : best_rotations(n_rotations))
    {
      const double missed = distance_from_landmarks([&](const Vector_3d& p) { return rotated(r.rotation, p); });
      result.push_back({r.rotation, {}, r.score, r.score - missed, missed});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Alignment& a, const Alignment& b) { return a.score > b.score; });
    const bool is_same_shape = result[0].score > min_score_of_same_shape;
    if(is_same_shape)
      result[0].rotation = polished(result[0].rotation, sphere1, sphere2, m_control, m_execution);
    if(is_same_shape || !goes_on())
      return result;
    std::array<Extremity_search::Extremities, 2> extremities;
    in_parallel(2, [&](std::size_t k) { extremities[k] = m_surfaces[k].extremities(); });
    Extremity_search search(std::move(extremities[0]), std::move(extremities[1]));
    const std::vector<Extremity_matching> matchings =
        search.best(n_matchings, m_surfaces[0].directions(), m_surfaces[1].directions());
    std::vector<Start> starts;
    for(const Alignment& alignment : result)
      starts.emplace_back(start_from(alignment.rotation, {}));
    for(const Extremity_matching& matching : matchings)
      starts.emplace_back(start_from(matching.rotation, distances_from_limbs(search, matching)));
    in_batches(starts, [&](Start& start) { lead(metric, true, start); });
    sort_by_score(starts);
    drop_near_ones(starts, min_angle_on_the_way);
    while(starts.size() > n_carried_on ||
          (!starts.empty() && starts.back().alignment.score < starts.front().alignment.score - max_lag))
      starts.pop_back();
    in_batches(starts, [&](Start& start) {
      lead(metric, false, start);
      settle(metric, feature_weight, start);
    });
    sort_by_score(starts);
    drop_near_ones(starts, min_angle);
    if(starts.empty())
      return result;
    result.clear();
    for(Start& start : starts)
      result.push_back(std::move(start.alignment));
    return result;
  }

  // Lowers such a map further, led by the distances from places all over the surface, which poses keep: they tell how far along a
  // extremity or around a body a vertex is, where the energy and features are much the same. It is for the one that has been chosen.
  void keep_distances(const Target_metric& metric, std::vector<Vector_3d>& directions)
  {
    if(!goes_on())
      return;
    in_parallel(2, [&](std::size_t k) { m_surfaces[k].measure_distances(); });
    Silent_control control;
    lower_on_target(m_surfaces[0].rings(), m_points, {metric, goals(distances_by(directions), leading_weight)},
                    min_settled_size, m_sweeps, directions, control, m_execution);
  }

private:
  using Leads = std::array<std::vector<Vertex_scalars>, 2>; // features of both surfaces

  // A start on its way.
  struct Start
  {
    Alignment alignment;
    Leads leads;
    std::vector<Vector_3d> images; // of the first surface, turned
    std::unique_ptr<Mesh_hierarchy> hierarchy;
    bool is_valid = true; // Doubles hold it.
  };

  // A control for what runs beside others.
  class Silent_control : public Run_control
  {
  public:
    Silent_control()
      : Run_control(0.)
    {}
    void on_initialization_begin(std::size_t) override {}
    void on_level(std::size_t) override {}
    void on_initialization_end() override {}
    void after_iteration(std::size_t, double, double) override {}
    void on_optimization_end() override {}

  private:
    bool visitor_goes_further(std::size_t, double) override { return true; }
  };

  bool goes_on() const { return m_control.go_further(0, 0.); }

  template <class Function>
  void in_parallel(std::size_t n, const Function& f) const
  {
    for_each_block(m_execution, 0, n, 1, [&](std::size_t k, std::size_t) { f(k); });
  }

  Sphere_image image(const std::vector<Vertex_scalars>& channels) const
  {
    return Sphere_image(m_nodes, m_surfaces[1].sphere().triangles(), channels);
  }

  // The distances from the ends of extremities, which lead the descent along with the features.
  Leads distances_from_limbs(const Extremity_search& search, const Extremity_matching& matching) const
  {
    Leads result;
    for(std::size_t surface = 0; surface < 2; ++surface)
      for(const auto& pair : matching.pairs)
      {
        result[surface].push_back(search.extremities(surface)[pair[surface]].distances);
        scale(result[surface].back(), weight_of_leading_distances);
      }
    return result;
  }

  static void scale(Vertex_scalars& values, double factor)
  {
    for(double& x : values)
      x *= factor;
  }

  // The distances from places that are spread over the first surface, and from where a map puts them.
  Leads distances_by(const std::vector<Vector_3d>& directions) const
  {
    // Of 60 pairs of people the error is 2.36 percent without, 2.15 with the weight 2.5 and 2.14 with 4, of 47 pairs of animals and
    // people 2.81, 2.69 and 2.69; twice as many places do the same.
    constexpr std::size_t n_places = 24;
    constexpr double weight = 3.;
    // Distances that do not fit, in the mean, by a fifth of what they are, count half: those from a place that lies wrong, or to extremities
    // that are longer.
    constexpr double squared_misfit = 0.2 * 0.2;
    const Surface_descriptor &first = m_surfaces[0], &second = m_surfaces[1];
    Leads result = {std::vector<Vertex_scalars>(n_places), std::vector<Vertex_scalars>(n_places)};
    in_parallel(n_places, [&](std::size_t k) {
      const Surface_descriptor::Origin& place = first.spread_origins()[k];
      result[0][k] = place.distances;
      result[1][k] = second.distances_from(directions[place.vertex]);
    });
    const Sphere_image there = image(result[1]);
    std::array<double, n_places> values;
    std::array<double, n_places> misfit{};
    for(std::size_t v = 0; v < directions.size(); ++v)
    {
      there.interpolate(directions[v], values.data());
      for(std::size_t k = 0; k < n_places; ++k)
      {
        const double difference = values[k] - result[0][k][v];
        misfit[k] += first.areas()[v] * difference * difference;
      }
    }
    for(std::vector<Vertex_scalars>& distances : result)
      for(std::size_t k = 0; k < n_places; ++k)
        scale(distances[k], weight / (1. + misfit[k] / squared_misfit));
    return result;
  }

  // How far a map is from the landmarks, in the mean, in units of the mean of all distances; 0 without any.
  template <class Function>
  double distance_from_landmarks(const Function& image_of) const
  {
    double sum = 0.;
    std::vector<double> distances(m_landmarks.size());
    for(std::size_t k = 0; k < m_landmarks.size(); ++k)
    {
      m_landmark_image->interpolate(image_of(m_landmarks[k]), distances.data());
      sum += distances[k];
    }
    return m_landmarks.empty() ? 0. : sum / static_cast<double>(m_landmarks.size());
  }

  // The goals by the features, and by others beside them.
  Feature_goals goals(Leads leads, double weight) const
  {
    for(std::size_t surface = 0; surface < 2; ++surface)
      leads[surface].insert(leads[surface].end(), m_surfaces[surface].features().begin(),
                            m_surfaces[surface].features().end());
    Feature_goals result;
    result.image = image(leads[1]);
    result.weight = weight;
    result.set_values(leads[0]);
    result.mask = m_surfaces[0].mask();
    return result;
  }

  Start start_from(const Rotation_matrix& rotation, Leads leads) const
  {
    Start result;
    result.alignment.rotation = rotation;
    for(const Vector_3d& p : m_surfaces[0].directions())
      result.images.push_back(normalized(rotated(rotation, p)));
    result.leads = std::move(leads);
    for(std::size_t surface = 0; surface < 2; ++surface)
      for(const Vertex_scalars& distances : m_landmark_distances[surface])
      {
        result.leads[surface].push_back(distances);
        scale(result.leads[surface].back(), weight_of_leading_distances);
      }
    return result;
  }

  // Calls f for all starts, in parallel; those that the control does not wait for are removed.
  template <class Function>
  void in_batches(std::vector<Start>& starts, const Function& f) const
  {
    constexpr std::size_t batch_size = 4; // between two questions to the control, a fifth of a second
    std::size_t n_done = 0;
    while(n_done < starts.size() && goes_on())
    {
      const std::size_t end = (std::min)(n_done + batch_size, starts.size());
      for_each_block(m_execution, n_done, end, 1, [&](std::size_t k, std::size_t) { f(starts[k]); });
      n_done = end;
    }
    starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(n_done), starts.end());
  }

  // Lowers a map with its features and leads, first on the coarse levels alone, by which most starts can be left.
  void lead(const Target_metric& metric, bool is_first, Start& start) const
  {
    // From 60 vertices on, whole extremities move; from 30 on the surfaces have lost too much, from 120 on they are not led far
    // enough.
    constexpr std::size_t min_size = 60, first_size = 700;
    const Surface_descriptor& first = m_surfaces[0];
    std::size_t last_level = 0;
    if(is_first)
    {
      Silent_control control;
      start.hierarchy =
          std::make_unique<Mesh_hierarchy>(first.rings(), m_points, vertex_areas(first.rings(), m_points), control,
                                           Execution(), start.images, std::vector<char>(), min_size);
      start.alignment.directions = start.images;
      while(last_level + 1 < start.hierarchy->number_of_levels() &&
            start.hierarchy->level(last_level).vertices.size() > first_size)
        ++last_level;
    }
    Silent_control control;
    const Target_goals led = {metric, goals(start.leads, leading_weight)};
    start.is_valid = start.is_valid && lower_on_levels(*start.hierarchy, m_points, start.images, led, m_sweeps,
                                                       start.alignment.directions, control, Execution(), last_level);
    assess(metric, start);
  }

  // Lowers a map with the weight that features have in the end.
  void settle(const Target_metric& metric, double feature_weight, Start& start) const
  {
    Silent_control control;
    const Target_goals left_alone = {metric, goals({}, feature_weight)};
    start.is_valid = start.is_valid && lower_on_target(m_surfaces[0].rings(), m_points, left_alone, min_settled_size,
                                                       m_sweeps, start.alignment.directions, control, Execution());
    assess(metric, start);
  }

  // Finds the score of a map on the level that it has come to.
  void assess(const Target_metric& metric, Start& start) const
  {
    const std::size_t k = start.hierarchy->number_of_levels() - 1;
    const Mesh_hierarchy::Level& level = start.hierarchy->level(k);
    // Of 138 pairs, the best of ten starts by this score is wrong for 1. If all features count the same, it is for 2, with any
    // weight from a quarter to a half, and for 3 with a sixth; without the root in stretching(), and the weight 1, for 5.
    constexpr double weight_of_stretching = 1. / 3.;
    const std::vector<Vector_3d>& directions = start.alignment.directions;
    start.alignment.agreement = feature_agreement(m_features, level, directions);
    start.alignment.missed = distance_from_landmarks([&](const Vector_3d& p) {
      const auto cosine = [&](std::uint32_t v) { return dot(m_surfaces[0].directions()[v], p); };
      return directions[*std::max_element(level.vertices.begin(), level.vertices.end(),
                                          [&](std::uint32_t v, std::uint32_t w) { return cosine(v) < cosine(w); })];
    });
    start.alignment.score =
        feature_agreement(m_features, level, directions, m_surfaces[0].weights_in_choice()) -
        weight_of_stretching * stretching(metric, level, start.hierarchy->rings(k), m_points, directions) -
        start.alignment.missed;
  }

  // Removes the starts that doubles do not hold, and brings the best one to the front.
  static void sort_by_score(std::vector<Start>& starts)
  {
    starts.erase(std::remove_if(starts.begin(), starts.end(), [](const Start& start) { return !start.is_valid; }),
                 starts.end());
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Start& a, const Start& b) { return a.alignment.score > b.alignment.score; });
  }

  // Removes the starts that are nearly a better one.
  void drop_near_ones(std::vector<Start>& starts, double min_angle) const
  {
    const Vertex_scalars& areas = m_surfaces[0].areas();
    std::vector<Start> result;
    for(Start& start : starts)
    {
      const auto is_near = [&](const Start& other) {
        double sum = 0., area = 0.;
        for(std::size_t v = 0; v < areas.size(); ++v)
        {
          sum += areas[v] * dot(start.alignment.directions[v], other.alignment.directions[v]);
          area += areas[v];
        }
        return sum > std::cos(min_angle) * area;
      };
      if(std::none_of(result.begin(), result.end(), is_near))
        result.push_back(std::move(start));
    }
    starts.swap(result);
  }

  // With a weight of 40, extremities stay where they are on the first surface; more than 160 crushes what is between them.
  static constexpr double leading_weight = 80.;
  // Beside ranks from -1 to 1, of distances that have the mean 1. With 2, random pairs of people are off by 3.8 percent after
  // the alignment, with 4 by 3.0 and with 6 by 2.95.
  static constexpr double weight_of_leading_distances = 4.;
  static constexpr std::size_t min_settled_size = 500; // the coarsest level once the large parts lie well
  // Other levels follow. But with 0.04 as the last one, two of 40 random pairs of people are turned: the scores are less exact.
  static constexpr Target_sweeps m_sweeps = {20, 1e-3, 0.02};

  std::array<Surface_descriptor, 2> m_surfaces;
  std::vector<Vector_3d> m_points; // of the first surface, with the area 4 pi
  Run_control& m_control;
  Execution m_execution;
  std::vector<Sphere_triangulation<Surface_descriptor::Kernel>::Triangle_location>
      m_nodes;                        // of images, on the second sphere
  Feature_goals m_features;           // without a weight
  std::vector<Vector_3d> m_landmarks; // on the first sphere
  Leads m_landmark_distances;
  std::optional<Sphere_image> m_landmark_image;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_ALIGNMENT_H
