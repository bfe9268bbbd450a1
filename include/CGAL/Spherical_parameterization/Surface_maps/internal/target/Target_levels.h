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

// The stopping criteria of the sweeps over a level.
struct Target_sweeps
{
  std::size_t maximum = 60;            // with 20, errors are larger by 1/40
  double convergence_tolerance = 1e-4; // of the mean energy between two measurements
  // A vertex that moves by less than this fraction of its shortest edge is skipped as long as its neighbors do the same. With half of
  // this value, the descent takes 1.5 times as long, and the energy is lower by 0.4 percent.
  double settled_part = 0.04;
};

// The descent of a map to the sphere of another surface on the levels of a hierarchy, see Level_descent. All intermediate maps are
// bijective, like all levels: vertices are removed only where the images of the faces stay positive, and are inserted at their former
// coordinates in the triangles that have replaced them, which may have moved.
class Target_levels
{
public:
  using Space = Target_sphere;

  // The images are those from which the levels were built. All arguments must outlive this object.
  Target_levels(const Target_sphere& space, const Target_sweeps& sweeps, const std::vector<Vector_3d>& images)
    : m_space(space)
    , m_sweeps(sweeps)
    , m_images(images)
  {}

  const Space& space() const { return m_space; }
  // Changes propagate over the surface by sweeps only, so steps are long. Where the interpolated metric is not smooth, no fraction of a
  // step may be accepted: 12 lengths take 1.6 times as long for the same errors; with one, errors of people are larger.
  Newton_step step() const { return Newton_step(1.9, 2); }

  // On levels with many vertices, whose sizes differ by a third, every other one is swept only once: sweeping all of them fully takes 1.5
  // times as long for the same energy. All coarser levels are needed to guide extremities to their correct positions.
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
    return {is_swept ? m_sweeps.maximum : 1, m_sweeps.convergence_tolerance};
  }

  // Finds the triangle of the hole, triangulated as a fan from its first vertex, that contains the vertex, and its moved position.
  bool find_insertion_point(const Ring_hole& hole, const Mesh_hierarchy::Removed_vertex& removed,
                            Vector_3d& position) const
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
  // Landmarks are not fixed on a level that is swept only once, because they have not been moved to their goals yet.
  void start_sweep(Space& space, std::size_t sweep, bool is_last) const
  {
    space.start_sweep(sweep, is_last && m_is_swept);
  }
  Face_objective objective(std::size_t) const { return Face_objective(); }
  bool has_settled(const Space& space, const Energy_summary& summary, double last_mean, double tolerance) const
  {
    return summary.has_settled(summary.average(), last_mean, tolerance) && !space.has_open_landmarks();
  }
  void finish_level(Block_coordinate_descent<Space, Newton_step>&, const Mesh_hierarchy&, std::size_t,
                    std::vector<Vector_3d>&, double&) const
  {}

private:
  Target_sphere m_space;
  Target_sweeps m_sweeps;
  const std::vector<Vector_3d>& m_images;
  bool m_is_swept = true; // whether the level is swept more than once
  std::size_t m_last_swept_size = 0;
  std::vector<Vector_3d> m_old; // the images of the level
};

// The goals of a map to the sphere of another surface.
struct Target_goals
{
  const Target_metric& metric;
  const Feature_goals& features;
  double feature_weight; // of the mean of their squared differences, relative to the mean energy
  Landmark_goals landmarks{};
};

// Minimizes the energy of the map to another surface on the levels of a hierarchy, which are consumed, starting from given positions of
// the vertices of the coarsest level. Other vertices are inserted between their neighbors as in the images from which the hierarchy was
// built. The descent may end at a level other than the finest, without changing the positions of finer ones. The points belong to a
// surface of area 4 pi. Hard landmarks that have been met stay fixed. Returns false if double precision does not suffice for a level; the
// positions are then invalid.
inline bool minimize_on_levels(Mesh_hierarchy& hierarchy, const std::vector<Vector_3d>& points,
                               const std::vector<Vector_3d>& images, const Target_goals& goals,
                               const Target_sweeps& sweeps, std::vector<Vector_3d>& positions, Run_control& control,
                               const Execution& execution, std::size_t last_level = 0)
{
  Target_levels plan(
      Target_sphere(goals.metric, goals.landmarks, goals.features, goals.feature_weight, sweeps.settled_part), sweeps,
      images);
  return Level_descent(hierarchy, points, Rest_limits(), plan, control, execution).run(positions, last_level);
}

// The same, starting from the positions of all vertices, which are also the images, on levels from about `min_size` vertices on. Returns
// false, without changing the positions, if double precision does not suffice for a level or for the initial map.
inline bool minimize_on_target(const Vertex_rings& rings, const std::vector<Vector_3d>& points,
                               const Target_goals& goals, std::size_t min_size, const Target_sweeps& sweeps,
                               std::vector<Vector_3d>& positions, Run_control& control, const Execution& execution)
{
  if(!are_safely_positive(rings, positions))
    return false;
  std::vector<char> is_fixed;
  for(const std::optional<Vector_3d>& goal : goals.landmarks.directions)
    is_fixed.push_back(goal.has_value());
  Mesh_hierarchy hierarchy(rings, points, vertex_areas(rings, points), control, execution, positions, is_fixed,
                           min_size);
  std::vector<Vector_3d> result = positions;
  if(!minimize_on_levels(hierarchy, points, positions, goals, sweeps, result, control, execution))
    return false;
  positions.swap(result);
  return true;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_LEVELS_H
