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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_SURFACE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/locate/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/levels/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_metric.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_star.h>
#include <CGAL/Spherical_parameterization/internal/levels/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Where vertices of the first surface are to go on the sphere of the second one.
struct Landmark_goals
{
  std::vector<std::optional<Vector_3d>> directions; // of the vertices; empty if there are no landmarks
  double weight = 0.; // of each squared distance, beside the sum over the faces; 0: they are to be met exactly

  bool is_hard() const { return !(weight > 0.); }
};

// Features of the second surface, and their values at the vertices of the first one, those of one vertex side by side.
struct Feature_goals
{
  std::optional<Sphere_image> image;
  std::vector<double> values;
  std::vector<char> mask; // of the vertices that have none; empty if all have them
  double weight = 0.;     // of the mean of their squared differences, beside the mean energy
};

// The sphere of another surface as the space that vertices move on, see Block_coordinate_descent: its metric, goals for
// landmarks, and features. The level is the one of Target_levels.
class Target_surface
{
public:
  using Energy = Two_way_energy;
  using Scratch = Target_star;

  static constexpr bool is_lanewise = false; // to look up a metric for each face leaves nothing to gain

  // All have to last as long as this.
  Target_surface(const Target_metric& metric, const Landmark_goals& goals, const Feature_goals& features,
                 double settled_part)
    : m_settled_part(settled_part)
    , m_metric(&metric)
    , m_goals(&goals)
    , m_features(&features)
    , m_is_pinned(goals.directions.size(), 0)
  {}

  const Energy& energy() const { return m_energy; }
  Scratch scratch() const { return Target_star(*m_metric); }

  // Starts with a level, whose vertices have these numbers in the mesh.
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

  // Whether a landmark of the level is still to be met.
  bool has_open_landmarks() const
  {
    if(m_goals->directions.empty() || !m_goals->is_hard())
      return false;
    return std::any_of(m_vertices->begin(), m_vertices->end(),
                       [&](std::uint32_t v) { return m_goals->directions[v] && !m_is_pinned[v]; });
  }

  // A vertex is passed over once neither it nor a neighbor has moved by more than a small part of its shortest edge.
  void move(const Star_view<double>& view, const std::uint32_t* vertices, std::size_t, Vector_3d* positions, double,
            const Face_objective&, const Newton_step& vertex_step, Target_star& star)
  {
    const std::uint32_t v = *vertices;
    bool is_settled = m_is_settled[v];
    for(std::size_t j = 0; j < view.size(); ++j)
      is_settled = is_settled && m_is_settled[view.neighbor(j)];
    if(is_settled)
      return;
    star.load(view, positions, m_metric_level);
    const std::uint32_t number = (*m_vertices)[v];
    if(m_features->image && (m_features->mask.empty() || !m_features->mask[number]))
    {
      // A vertex stands for a third of the area of its faces, as all have it on this level.
      const std::size_t n = m_features->image->number_of_channels();
      const double weight =
          2. * m_features->weight * star.area() / 3. / static_cast<double>(n); // 8 pi over the area of 4 pi
      star.set_features(&*m_features->image, &m_features->values[number * n], weight);
    }
    const Vector_3d old = positions[v];
    const bool may_settle = move(star, number, vertex_step, positions[v]);
    m_is_settled[v] = may_settle && squared_length(positions[v] - old) <=
                                        m_settled_part * m_settled_part * star.squared_shortest_edge();
  }

  // I and d of a face with these corners and rest shape, see Face_invariants_3.
  template <class FT>
  std::array<double, 3> invariants(const std::array<Vector_3d, 3>& p, const std::array<double, 3>& opposite,
                                   double inverse_doubled_area, double, double, const Face_objective&) const
  {
    const Cube_place place = m_metric->place(p[0] + p[1] + p[2], m_metric_level);
    const Metric_sample s = m_metric->mixed(place, m_metric_level, place.weights());
    const auto a0 = place.flattened(p[2] - p[1]), a1 = place.flattened(p[0] - p[2]), a2 = place.flattened(p[1] - p[0]);
    const double d = inverse_doubled_area * dot(p[0], cross(p[1], p[2])) * s.area();
    return {opposite[0] * s.product(a0, a0) + opposite[1] * s.product(a1, a1) + opposite[2] * s.product(a2, a2), d, d};
  }

private:
  // A hard landmark is drawn to its goal ever harder, its weight doubling for 20 sweeps, until its star has less than
  // twice the energy there: the faces around it make way meanwhile. In the last sweep any energy will do that is not
  // next to a face that turns over. Returns false for one that is on its way.
  bool move(Target_star& star, std::uint32_t v, const Newton_step& vertex_step, Vector_3d& position)
  {
    constexpr double max_growth = 2., largest = 1e6, first_weight = 1., max_weight = 1e6;
    const bool is_hard = m_goals->is_hard(),
               has_goal = !m_goals->directions.empty() && m_goals->directions[v].has_value();
    if(has_goal)
    {
      if(m_is_pinned[v])
        return true;
      const Vector_3d& goal = *m_goals->directions[v];
      if(is_hard)
      {
        const double energy = star.at(goal);
        if(energy < max_growth * star(0., 0.) || (m_is_last_sweep && energy < largest))
        {
          position = goal;
          m_is_pinned[v] = 1;
          return true;
        }
      }
      star.set_goal(&goal, is_hard ? (std::min)(std::ldexp(first_weight, static_cast<int>(m_sweep)), max_weight)
                                   : m_goals->weight);
    }
    std::array<double, 2> step;
    if(vertex_step(star, step))
      position = star.point_at(step[0], step[1]);
    return !(has_goal && is_hard);
  }

  double m_settled_part; // of the shortest edge
  const Target_metric* m_metric;
  const Landmark_goals* m_goals;
  const Feature_goals* m_features;
  Energy m_energy;
  const std::vector<std::uint32_t>* m_vertices = nullptr; // of the level
  std::size_t m_metric_level = 0, m_sweep = 0;
  bool m_is_last_sweep = false;
  std::vector<char> m_is_pinned;  // of the mesh
  std::vector<char> m_is_settled; // of the level
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_SURFACE_H
