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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_LEVELS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_LEVELS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_sphere.h>
#include <CGAL/Spherical_parameterization/internal/descent/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/descent/Level_descent.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Star_kernel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// How often the levels are swept.
struct Target_sweeps
{
  std::size_t maximum = 60;     // with 20, errors are larger by a fortieth
  double settled_change = 1e-4; // of the mean energy, from one measurement to the next
  // Of its shortest edge, by which a vertex may move and be passed over then, if its neighbors are. With a half of it, the
  // descent takes 1.5 times as long, for an energy that is lower by 0.4 percent.
  double settled_part = 0.04;
};

// How a map to the sphere of another surface is lowered on the levels of a hierarchy, see Level_descent. Every state is a
// bijection, as every level is: vertices are removed only where the images of the faces stay positive, and are put back where
// they were in the triangles that they have left, as these have moved.
class Target_levels
{
public:
  using Space = Target_sphere;

  // The images are those that the levels have been made by. All have to last as long as this.
  Target_levels(const Target_sphere& space, const Target_sweeps& sweeps, const std::vector<Vector_3d>& images)
    : m_space(space)
    , m_sweeps(sweeps)
    , m_images(images)
  {}

  const Space& space() const { return m_space; }
  Newton_step step() const { return Newton_step(1.9); } // nothing but sweeps carries changes over the surface

  // Of the levels with many vertices, every other one is swept but once, as these differ by a third: to sweep all of them takes 1.5
  // times as long for the same energy. Of the coarser ones, all are needed for extremities to be led to where they belong.
  Level_sweeps start_level(Space& space, const Mesh_hierarchy::Level& level, bool is_last)
  {
    constexpr std::size_t many = 300;
    constexpr double min_growth = 1.7;
    space.start_level(level.vertices);
    m_old = level.gathered(m_images);
    const std::size_t n = level.vertices.size();
    const bool is_swept =
        is_last || n < many || static_cast<double>(n) > min_growth * static_cast<double>(m_last_swept_size);
    m_is_swept = is_swept;
    if(is_swept)
      m_last_swept_size = n;
    return {is_swept ? m_sweeps.maximum : 1, m_sweeps.settled_change};
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

  template <class Descent>
  void choose_radius(const Descent&, double&) const
  {}
  // Landmarks are not placed on a level that is swept but once: they have not been drawn to there yet.
  void start_sweep(Space& space, std::size_t sweep, bool is_last) const
  {
    space.start_sweep(sweep, is_last && m_is_swept);
  }
  bool may_end(const Space& space) const { return !space.has_open_landmarks(); }

private:
  Target_sphere m_space;
  Target_sweeps m_sweeps;
  const std::vector<Vector_3d>& m_images;
  bool m_is_swept = true; // the level
  std::size_t m_last_swept_size = 0;
  std::vector<Vector_3d> m_old; // of the level
};

// What a map to the sphere of another surface is to be like.
struct Target_goals
{
  const Target_metric& metric;
  const Feature_goals& features;
  double feature_weight; // of the mean of their squared differences, beside the mean energy
  Landmark_goals landmarks{};
};

// Lowers the energy of the map to another surface on the levels of a hierarchy, which are used up, from given positions of
// the vertices of the coarsest level on. The other ones are put between their neighbours as in the images that the hierarchy
// was made by. It may end at another level than the finest, and then leaves their positions. The points are those of a
// surface of area 4 pi. Hard landmarks that have been met stay where they are. Returns false if doubles cannot hold a level;
// the positions are of no use then.
inline bool lower_on_levels(Mesh_hierarchy& hierarchy, const std::vector<Vector_3d>& points,
                            const std::vector<Vector_3d>& images, const Target_goals& goals,
                            const Target_sweeps& sweeps, std::vector<Vector_3d>& positions, Run_control& control,
                            const Execution& execution, std::size_t last_level = 0)
{
  Target_levels plan(
      Target_sphere(goals.metric, goals.landmarks, goals.features, goals.feature_weight, sweeps.settled_part), sweeps,
      images);
  return Level_descent(hierarchy, points, Rest_limits(), plan, control, execution).run(positions, last_level);
}

// The same from all positions, which are the images as well, on levels from about `min_size` vertices on. Returns false, and
// leaves them as they are, if doubles cannot hold a level, or the map that it starts from.
inline bool lower_on_target(const Vertex_rings& rings, const std::vector<Vector_3d>& points, const Target_goals& goals,
                            std::size_t min_size, const Target_sweeps& sweeps, std::vector<Vector_3d>& positions,
                            Run_control& control, const Execution& execution)
{
  if(!are_safely_positive(rings, positions))
    return false;
  std::vector<char> is_fixed;
  for(const std::optional<Vector_3d>& goal : goals.landmarks.directions)
    is_fixed.push_back(goal.has_value());
  Mesh_hierarchy hierarchy(rings, points, vertex_areas(rings, points), control, execution, positions, is_fixed,
                           min_size);
  std::vector<Vector_3d> result = positions;
  if(!lower_on_levels(hierarchy, points, positions, goals, sweeps, result, control, execution))
    return false;
  positions.swap(result);
  return true;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_LEVELS_H
