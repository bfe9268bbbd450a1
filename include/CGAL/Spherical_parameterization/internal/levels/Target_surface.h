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

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/levels/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/levels/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/levels/Level_descent.h>
#include <CGAL/Spherical_parameterization/internal/levels/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_kernel.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_metric.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_star.h>
#include <CGAL/Spherical_parameterization/internal/levels/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

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

// Features of the second surface, and their values at the vertices of the first one, one after the other.
struct Feature_goals
{
  std::optional<Sphere_image> image;
  std::vector<double> values;
  double weight = 0.; // of the mean of their squared differences, beside the mean energy
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
  Target_surface(const Target_metric& metric, const Landmark_goals& goals, const Feature_goals& features)
    : m_metric(&metric)
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

  // A vertex is passed over once neither it nor a neighbor has moved by more than a small part of the distance to the
  // nearest neighbor.
  void move(const Star_view<double>& view, const std::uint32_t* vertices, std::size_t, Vector_3d* positions, double,
            const Face_objective&, const Newton_step& vertex_step, Target_star& star)
  {
    constexpr double settled_part = 0.02;
    const std::uint32_t v = *vertices;
    bool is_settled = m_is_settled[v];
    for(std::size_t j = 0; j < view.size(); ++j)
      is_settled = is_settled && m_is_settled[view.neighbor(j)];
    if(is_settled)
      return;
    star.load(view, positions, m_metric_level);
    const std::uint32_t number = (*m_vertices)[v];
    if(m_features->image)
    {
      // A vertex stands for a third of the area of its faces, as all have it on this level.
      const std::size_t n = m_features->image->number_of_channels();
      const double weight =
          2. * m_features->weight * star.area() / 3. / static_cast<double>(n); // 8 pi over the area of 4 pi
      star.set_features(&*m_features->image, &m_features->values[number * n], weight);
    }
    const Vector_3d old = positions[v];
    const bool may_settle = move(star, number, vertex_step, positions[v]);
    m_is_settled[v] =
        may_settle && squared_length(positions[v] - old) <= settled_part * settled_part * star.squared_shortest_edge();
  }

  // I and d of a face with these corners and rest shape, see Face_invariants_3.
  template <class FT>
  std::array<double, 3> invariants(const std::array<Vector_3d, 3>& p, const std::array<double, 3>& opposite,
                                   double inverse_doubled_area, double, double, const Face_objective&) const
  {
    const Metric_sample s = m_metric->at(p[0] + p[1] + p[2], m_metric_level);
    const double d = inverse_doubled_area * dot(p[0], cross(p[1], p[2])) * s.area();
    return {opposite[0] * s.squared_length(p[2] - p[1]) + opposite[1] * s.squared_length(p[0] - p[2]) +
                opposite[2] * s.squared_length(p[1] - p[0]),
            d, d};
  }

private:
  // A hard landmark is drawn to its goal ever harder, until it can go there at little cost: the faces around it make
  // way meanwhile. In the last sweep any cost will do. Returns false for one that is on its way.
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

// How a map to the sphere of another surface is lowered on the levels of a hierarchy, see Level_descent. Every state is a
// bijection, as every level is: vertices are removed only where the images of the faces stay positive, and are put back where
// they were in the triangles that they have left, as these have moved.
class Target_levels
{
public:
  using Space = Target_surface;

  // The positions are those before all descent. All have to last as long as this.
  Target_levels(const Target_surface& space, const std::vector<Vector_3d>& positions)
    : m_space(space)
    , m_positions(positions)
  {}

  const Space& space() const { return m_space; }

  Level_sweeps start_level(Space& space, const Mesh_hierarchy::Level& level, bool)
  {
    space.start_level(level.vertices);
    m_old = level.gathered(m_positions);
    return {max_sweeps, settled_change, Newton_step()};
  }

  // Where a vertex is in one of the triangles of its hole, fanned out from the first vertex, and goes to along with it.
  bool find_place(const Ring_hole& hole, const Mesh_hierarchy::Removed_vertex& removed, Vector_3d& position) const
  {
    const Ring_hole old = {m_old, hole.ring, hole.first};
    const Vector_3d& p = position = m_old[removed.vertex];
    for(std::size_t j = 1; j + 1 < old.size(); ++j)
    {
      const Vector_3d &a = old[0], &b = old[j], &c = old[j + 1];
      const double u = dot(p, cross(b, c)), v = dot(p, cross(c, a)), w = dot(p, cross(a, b));
      if(u >= 0. && v >= 0. && w >= 0.)
      {
        position = normalized(u * hole[0] + v * hole[j] + w * hole[j + 1]);
        break;
      }
    }
    bool is_positive = true;
    for(std::size_t j = 0; j < hole.size(); ++j)
      is_positive = is_positive && is_safely_positive(position, hole[j], hole[j + 1 < hole.size() ? j + 1 : 0]);
    return is_positive;
  }

  Face_objective choose_objective(std::size_t, std::size_t, const Energy_summary&, const Face_range_3&, double&) const
  {
    return Face_objective();
  }

  void start_sweep(Space& space, std::size_t sweep, bool is_last) const { space.start_sweep(sweep, is_last); }
  bool may_end(const Space& space) const { return !space.has_open_landmarks(); }

private:
  static constexpr std::size_t max_sweeps = 60;
  static constexpr double settled_change = 1e-4;

  Target_surface m_space;
  const std::vector<Vector_3d>& m_positions;
  std::vector<Vector_3d> m_old; // of the level
};

// Lowers the energy of the map with these positions on the unit sphere to another surface, on levels from about `min_size`
// vertices on. Hard landmarks that have been met stay where they are. Returns false, and leaves the positions as they are,
// if a vertex could not be put back, where doubles cannot hold it.
inline bool lower_on_target(const Surface& mesh, const Target_metric& metric, const Landmark_goals& goals,
                            const Feature_goals& features, std::size_t min_size, std::vector<Vector_3d>& positions,
                            Run_control& control, Execution execution)
{
  std::vector<char> is_fixed;
  for(const std::optional<Vector_3d>& goal : goals.directions)
    is_fixed.push_back(goal.has_value());
  Mesh_hierarchy hierarchy(mesh.rings(), mesh.points(), vertex_areas(mesh.rings(), mesh.points()), execution, positions,
                           is_fixed, min_size);
  Target_levels plan(Target_surface(metric, goals, features), positions);
  std::vector<Vector_3d> result = positions;
  if(!Level_descent(hierarchy, mesh.points(), Rest_limits(), plan, control, execution).run(result))
    return false;
  positions.swap(result);
  return true;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_SURFACE_H
