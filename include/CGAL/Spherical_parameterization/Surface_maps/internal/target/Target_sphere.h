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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_SPHERE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_star.h>
#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>

#include <optional>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The goals of vertices of the first surface on the sphere of the second one.
struct Landmark_goals
{
  std::vector<std::optional<Vector_3d>> directions; // the goal of each vertex, if any; empty if there are no landmarks
  double weight = 0.; // of each squared distance, relative to the sum over the faces; 0 if landmarks are hard

  bool is_hard() const { return !(weight > 0.); }
};

// The features of the second surface, and their values at the vertices of the first one, contiguous for each vertex.
struct Feature_goals
{
  std::optional<Sphere_image> image;
  std::vector<double> values; // in rows as in the image
  std::vector<char> mask;     // nonzero at excluded vertices; empty if none is excluded

  // Sets the values of each feature.
  void set_values(const std::vector<std::vector<double>>& channels)
  {
    const std::size_t row = Sphere_image::row_size(channels.size());
    values.assign(channels.empty() ? 0 : row * channels[0].size(), 0.);
    for(std::size_t k = 0; k < channels.size(); ++k)
      for(std::size_t v = 0; v < channels[k].size(); ++v)
        values[v * row + k] = channels[k][v];
  }
  const double* values_of(std::size_t v) const
  {
    return values.data() + v * Sphere_image::row_size(image->number_of_channels());
  }
};

// The sphere of another surface as the space in which vertices move, see Block_coordinate_descent, with its metric, goals of landmarks, and
// features. The level is that of Target_levels.
class Target_sphere
{
public:
  using Energy = Two_way_energy;
  using Scratch = In_lanes<Target_star>; // the memory of a thread

  static constexpr bool is_lanewise = true;

  // All arguments must outlive this object.
  Target_sphere(const Target_metric& metric, const Landmark_goals& goals, const Feature_goals& features,
                double feature_weight, double settled_part)
    : m_settled_part(settled_part)
    , m_metric(&metric)
    , m_goals(&goals)
    , m_features(&features)
    , m_feature_weight(feature_weight)
    , m_is_pinned(goals.directions.size(), 0)
  {}

  const Energy& energy() const { return m_energy; }

  // Starts a level whose vertices have these indices in the mesh.
  void start_level(const std::vector<std::uint32_t>& vertices)
  {
    m_vertices = &vertices;
    m_metric_level = m_metric->level_for(vertices.size());
    m_is_settled.assign(vertices.size(), 0);
  }

  void start_sweep(std::size_t sweep, bool is_last)
  {
    m_sweep = sweep;
    m_is_last_sweep = is_last;
  }

  // Whether a hard landmark of the level has not been met yet.
  bool has_open_landmarks() const
  {
    if(m_goals->directions.empty() || !m_goals->is_hard())
      return false;
    return std::any_of(m_vertices->begin(), m_vertices->end(),
                       [&](std::uint32_t v) { return m_goals->directions[v] && !m_is_pinned[v]; });
  }

  // Moves the center of the star in each lane, for at most `n_vertices` lanes. A vertex is skipped if neither it nor a neighbor has moved
  // by more than a small fraction of its shortest edge.
  template <class FT>
  void move(const Star_view<FT>& view, const std::uint32_t* vertices, std::size_t n_vertices, Vector_3d* positions,
            double, const Face_objective&, const Newton_step& vertex_step, Scratch& scratch)
  {
    constexpr std::size_t width = Lanes<FT>::width;
    std::array<bool, width> is_open{};
    for(std::size_t k = 0; k < width && k < n_vertices; ++k)
      is_open[k] = !has_settled_star(view, vertices[k], k);
    if(std::none_of(is_open.begin(), is_open.end(), [](bool x) { return x; }))
      return;
    Target_star<FT>& star = scratch.template get<FT>(*m_metric);
    star.load(view, positions, m_metric_level);
    if(m_features->image)
      set_features(star, vertices);
    std::array<bool, width> is_placed{}; // moved exactly to its goal
    if(!m_goals->directions.empty())
      set_goals(star, vertices, positions, is_open, is_placed);
    star.set_open(is_open);
    std::array<FT, 2> step = {FT(0.), FT(0.)};
    const auto is_moved = vertex_step(star, step);
    const Vector_3<FT> point = star.point_at(step[0], step[1]);
    for(std::size_t k = 0; k < width; ++k)
      if(is_open[k])
      {
        const std::uint32_t v = vertices[k], number = (*m_vertices)[v];
        const Vector_3d old = positions[v];
        if(is_placed[k])
          positions[v] = *m_goals->directions[number];
        else if(lane(is_moved, k))
          positions[v] = {lane(point[0], k), lane(point[1], k), lane(point[2], k)};
        const bool is_moving_to_goal = has_goal(number) && m_goals->is_hard() && !m_is_pinned[number];
        m_is_settled[v] =
            !is_moving_to_goal && squared_length(positions[v] - old) <=
                                      m_settled_part * m_settled_part * lane(star.squared_shortest_edge(), k);
      }
  }

  // The invariants I and d of faces with these corners and rest shapes, see Face_invariants_3.
  template <class FT>
  std::array<FT, 3> invariants(const std::array<Vector_3<FT>, 3>& p, const std::array<FT, 3>& opposite,
                               const FT& inverse_doubled_area, const FT&, double, const Face_objective&) const
  {
    const auto location = m_metric->locate(p[0] + p[1] + p[2], m_metric_level);
    const Metric_sample<FT> s = m_metric->at(location, m_metric_level);
    const auto a0 = location.flattened(p[2] - p[1]), a1 = location.flattened(p[0] - p[2]),
               a2 = location.flattened(p[1] - p[0]);
    const FT d = inverse_doubled_area * dot(p[0], cross(p[1], p[2])) * s.area();
    return {opposite[0] * s.product(a0, a0) + opposite[1] * s.product(a1, a1) + opposite[2] * s.product(a2, a2), d, d};
  }

private:
  bool has_goal(std::uint32_t number) const
  {
    return !m_goals->directions.empty() && m_goals->directions[number].has_value();
  }

  template <class FT>
  bool has_settled_star(const Star_view<FT>& view, std::uint32_t v, std::size_t lane) const
  {
    bool result = m_is_settled[v];
    for(std::size_t j = 0; result && j < view.size(); ++j)
      result = m_is_settled[view.neighbor(j, lane)];
    return result;
  }

  template <class FT>
  void set_features(Target_star<FT>& star, const std::uint32_t* vertices) const
  {
    typename Target_star<FT>::Values values;
    for(std::size_t k = 0; k < values.size(); ++k)
      values[k] = m_features->values_of((*m_vertices)[vertices[k]]);
    // A vertex accounts for a third of the area of its faces on this level. The factor is 8 pi divided by the area, 4 pi.
    const double factor = 2. * m_feature_weight / 3. / static_cast<double>(m_features->image->number_of_channels());
    const FT counts = Lanes<FT>::generate([&](std::size_t k) {
      return m_features->mask.empty() || !m_features->mask[(*m_vertices)[vertices[k]]] ? 1. : 0.;
    });
    star.set_features(&*m_features->image, values, factor * counts * star.area());
  }

  // A hard landmark is attracted to its goal with a weight that doubles in each of 20 sweeps, until the energy of its star at the goal is
  // less than twice the current one; meanwhile, the surrounding faces adapt. In the last sweep, any energy is accepted that is not caused
  // by a nearly degenerate face. The vertex is then fixed at its goal.
  template <class FT>
  void set_goals(Target_star<FT>& star, const std::uint32_t* vertices, const Vector_3d* positions,
                 std::array<bool, Lanes<FT>::width>& is_open, std::array<bool, Lanes<FT>::width>& is_placed)
  {
    constexpr double max_growth = 2., largest = 1e6, first_weight = 1., max_weight = 1e6;
    constexpr std::size_t width = Lanes<FT>::width;
    std::array<double, width> counts{};
    std::array<std::array<double, width>, 3> goals;
    for(std::size_t k = 0; k < width; ++k)
    {
      const std::uint32_t v = vertices[k], number = (*m_vertices)[v];
      if(m_is_pinned[number])
      {
        is_open[k] = false;
        m_is_settled[v] = 1;
      }
      counts[k] = is_open[k] && has_goal(number);
      for(std::size_t i = 0; i < 3; ++i)
        goals[i][k] = counts[k] > 0. ? (*m_goals->directions[number])[i] : positions[v][i];
    }
    if(std::none_of(counts.begin(), counts.end(), [](double x) { return x > 0.; }))
      return;
    const auto in_lanes = [](const std::array<double, width>& values) { return Lanes<FT>::load(values.data()); };
    const Vector_3<FT> goal = {in_lanes(goals[0]), in_lanes(goals[1]), in_lanes(goals[2])};
    if(m_goals->is_hard())
    {
      const FT energy = star.at(goal), limit = max_growth * star(FT(0.), FT(0.));
      for(std::size_t k = 0; k < width; ++k)
        if(counts[k] > 0. && (lane(energy, k) < lane(limit, k) || (m_is_last_sweep && lane(energy, k) < largest)))
        {
          is_placed[k] = true;
          m_is_pinned[(*m_vertices)[vertices[k]]] = 1;
        }
    }
    const double weight = m_goals->is_hard()
                              ? (std::min)(std::ldexp(first_weight, static_cast<int>(m_sweep)), max_weight)
                              : m_goals->weight;
    star.set_goal(goal, weight * in_lanes(counts));
  }

  double m_settled_part; // fraction of the shortest edge
  const Target_metric* m_metric;
  const Landmark_goals* m_goals;
  const Feature_goals* m_features;
  double m_feature_weight;
  Energy m_energy;
  const std::vector<std::uint32_t>* m_vertices = nullptr; // the indices of the vertices of the level
  std::size_t m_metric_level = 0, m_sweep = 0;
  bool m_is_last_sweep = false;
  std::vector<char> m_is_pinned;  // for the vertices of the mesh
  std::vector<char> m_is_settled; // for the vertices of the level
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_SPHERE_H
