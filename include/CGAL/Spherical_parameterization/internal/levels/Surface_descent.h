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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_SURFACE_DESCENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_SURFACE_DESCENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/levels/Independent_sets.h>
#include <CGAL/Spherical_parameterization/internal/levels/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/levels/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_kernel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_metric.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_star.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Where landmarks of the first surface are to go on the sphere of the second one.
struct Landmark_goals
{
  std::vector<std::uint32_t> vertices;
  std::vector<Vector_3d> directions;
  double weight = 0.; // of the mean of the squared distances, beside the mean energy; 0: they are to be met exactly

  bool is_hard() const { return !(weight > 0.); }
};

// Features of the second surface, and their values at the vertices of the first one, one after the other.
struct Feature_goals
{
  std::optional<Sphere_image> image;
  std::vector<double> values;
  double weight = 0.; // of the mean of their squared differences, beside the mean energy
};

// Lowers the energy of a map from a surface to the sphere of another one, whose metric is given, level by level of a
// hierarchy. Every state is a bijection, as every level is: vertices are removed only where the images of the faces stay
// positive, and are put back where they were in the triangles that they have left, as these have moved.
class Surface_descent
{
public:
  // All but the last one have to last as long as this.
  Surface_descent(const Indexed_mesh& mesh, const Target_metric& metric, const Landmark_goals& goals,
                  const Feature_goals& features, const Execution& execution)
    : m_mesh(mesh)
    , m_metric(metric)
    , m_features(features)
    , m_execution(execution)
    , m_goals(mesh.number_of_vertices(), nullptr)
    , m_is_landmark(mesh.number_of_vertices(), 0)
    , m_is_pinned(mesh.number_of_vertices(), 0)
    , m_is_hard(goals.is_hard())
    , m_stars(execution, Target_star(metric))
    , m_kernels(execution, Star_kernel())
  {
    // The sum over the faces is 8 pi times the mean energy.
    if(!m_is_hard)
      m_weight = 8. * CGAL_PI * goals.weight / static_cast<double>(goals.vertices.size());
    for(std::size_t k = 0; k < goals.vertices.size(); ++k)
    {
      m_goals[goals.vertices[k]] = &goals.directions[k];
      m_is_landmark[goals.vertices[k]] = 1;
    }
  }

  // Lowers the energy of the map with these positions on the unit sphere, on levels from about `min_size` vertices on.
  // Hard landmarks that have been met stay where they are. Asks go_further() before each sweep: after a no, vertices are
  // put back only. Returns false, and leaves the positions as they are, if a vertex could not be put back, where doubles
  // cannot hold it.
  bool run(std::vector<Vector_3d>& positions, std::size_t min_size, const std::function<bool()>& go_further)
  {
    const auto may_sweep = [&] {
      m_is_stopped = m_is_stopped || (go_further && !go_further());
      return !m_is_stopped;
    };
    const Mesh_hierarchy hierarchy =
        Mesh_hierarchy::build_on_sphere(m_mesh.rings(), m_mesh.points(), vertex_areas(m_mesh.rings(), m_mesh.points()),
                                        positions, m_is_landmark, min_size, m_execution);
    std::vector<Vector_3d> result = positions;
    const std::size_t coarsest = hierarchy.number_of_levels() - 1;
    for(std::size_t k = coarsest + 1; k-- > 0;)
    {
      const Mesh_hierarchy::Level& level = hierarchy.level(k);
      std::vector<Vector_3d> local = level.gathered(result);
      if(k < coarsest && !insert_vertices(level, hierarchy.rings(k), level.gathered(positions), local))
        return false;
      relax(level, hierarchy.rings(k), may_sweep, local);
      for(std::size_t v = 0; v < local.size(); ++v)
        result[level.vertices[v]] = local[v];
    }
    positions.swap(result);
    return true;
  }

  bool is_stopped() const { return m_is_stopped; }

private:
  static constexpr std::size_t block_size = 32;

  // the shapes of the faces at each corner; on coarse levels with the areas that they stand for
  std::vector<Rest_triangle> rest_shapes(const Mesh_hierarchy::Level& level, const Vertex_rings& rings) const
  {
    const std::vector<Vector_3d> points = level.gathered(m_mesh.points());
    const std::vector<double> densities = vertex_densities(rings, points, level.areas);
    std::vector<Rest_triangle> result(rings.number_of_corners());
    for_each_block(m_execution, 0, points.size(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
      {
        const Vertex_rings::Ring ring = rings.ring(v);
        for(std::size_t j = 0; j < ring.size(); ++j)
        {
          const std::uint32_t a = ring[j], b = ring.around(j + 1);
          Rest_triangle rest = Rest_triangle::from_points(points[v], points[a], points[b]);
          rest.scale_area((densities[v] + densities[a] + densities[b]) / 3.);
          result[rings.offset(v) + j] = rest;
        }
      }
    });
    return result;
  }

  template <class MaySweep>
  void relax(const Mesh_hierarchy::Level& level, const Vertex_rings& rings, const MaySweep& may_sweep,
             std::vector<Vector_3d>& local)
  {
    constexpr std::size_t n_sweeps = 60;
    const std::vector<Rest_triangle> rests = rest_shapes(level, rings);
    const Independent_sets sets(rings);
    const std::size_t metric_level = m_metric.level_for(local.size());
    std::vector<char> is_settled(local.size(), 0);
    for(std::size_t sweep = 0; sweep < n_sweeps && may_sweep(); ++sweep)
      for(std::size_t set = 0; set < sets.number_of_sets(); ++set)
        for_each_block(
            m_execution, sets.first(set), sets.first(set + 1), block_size, [&](std::size_t begin, std::size_t end) {
              Target_star& star = m_stars.local();
              star.set_level(metric_level);
              for(std::size_t k = begin; k < end; ++k)
              {
                const std::uint32_t v = sets.vertices()[k];
                const Vertex_rings::Ring ring = rings.ring(v);
                if(is_settled[v] && is_settled_around(ring, is_settled))
                  continue;
                const Rest_triangle* const shapes = rests.data() + rings.offset(v);
                star.load(rings, v, local, [&](std::size_t j) { return shapes[j]; });
                if(m_features.image)
                  set_features(star, level.vertices[v], shapes, ring.size());
                const Vector_3d position = local[v];
                const bool may_settle = move(star, level.vertices[v], sweep, sweep + 1 == n_sweeps, local[v]);
                is_settled[v] = may_settle && is_short(local[v] - position, position, ring, local);
              }
            });
  }

  // A vertex is passed over once neither it nor a neighbor has moved by more than a small part of the distance to the
  // nearest neighbor: on average after some 20 sweeps, but the last ones need 60.
  static bool is_settled_around(const Vertex_rings::Ring& ring, const std::vector<char>& is_settled)
  {
    for(std::size_t j = 0; j < ring.size(); ++j)
      if(!is_settled[ring[j]])
        return false;
    return true;
  }

  static bool is_short(const Vector_3d& step, const Vector_3d& position, const Vertex_rings::Ring& ring,
                       const std::vector<Vector_3d>& local)
  {
    constexpr double largest_part = 0.02;
    double squared_distance = 4.;
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      const Vector_3d edge = local[ring[j]] - position;
      squared_distance = (std::min)(squared_distance, dot(edge, edge));
    }
    return dot(step, step) <= largest_part * largest_part * squared_distance;
  }

  // A vertex stands for a third of the area of its faces, as all have it on this level.
  void set_features(Target_star& star, std::uint32_t v, const Rest_triangle* shapes, std::size_t n_faces) const
  {
    const std::size_t n = m_features.image->number_of_channels();
    double area = 0.;
    for(std::size_t j = 0; j < n_faces; ++j)
      area += 0.5 / shapes[j].inverse_doubled_area / 3.;
    const double weight = 2. * m_features.weight * area / static_cast<double>(n); // 8 pi over the area of 4 pi
    star.set_features(&*m_features.image, &m_features.values[v * n], weight);
  }

  // A hard landmark is drawn to its goal ever harder, until it can go there at little cost: the faces around it make
  // way meanwhile. In the last sweep any cost will do. Returns false for one that is on its way.
  bool move(Target_star& star, std::uint32_t v, std::size_t sweep, bool is_last, Vector_3d& position)
  {
    constexpr double max_growth = 2., largest = 1e6, first_weight = 1., max_weight = 1e6;
    if(m_is_pinned[v])
      return true;
    if(const Vector_3d* const goal = m_goals[v])
    {
      if(m_is_hard)
      {
        const double energy = star.at(*goal);
        if(energy < max_growth * star(0., 0.) || (is_last && energy < largest))
        {
          position = *goal;
          m_is_pinned[v] = 1;
          return true;
        }
      }
      star.set_goal(goal,
                    m_is_hard ? (std::min)(std::ldexp(first_weight, static_cast<int>(sweep)), max_weight) : m_weight);
    }
    std::array<double, 2> step;
    if(m_step(star, step))
      position = star.point_at(step[0], step[1]);
    return !(m_goals[v] && m_is_hard);
  }

  // Puts the removed vertices where they were in the triangles of their holes; `old` are the positions before all
  // descent. Where that folds, they go into the kernels of the holes.
  bool insert_vertices(const Mesh_hierarchy::Level& level, const Vertex_rings& rings, const std::vector<Vector_3d>& old,
                       std::vector<Vector_3d>& local)
  {
    std::atomic<bool> is_complete(true);
    for_each_block(m_execution, 0, level.removed.size(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
      {
        const Mesh_hierarchy::Removed_vertex& removed = level.removed[k];
        const Vertex_rings::Ring ring = rings.ring(removed.vertex);
        Vector_3d& position = local[removed.vertex];
        position =
            carried(old[removed.vertex], Ring_hole{old, ring, removed.target}, Ring_hole{local, ring, removed.target});
        bool is_positive = true;
        for(std::size_t j = 0; j < ring.size(); ++j)
          is_positive = is_positive && is_safely_positive(position, local[ring[j]], local[ring.around(j + 1)]);
        if(!is_positive && !m_kernels.local().find_point(Ring_hole{local, ring, removed.target}, position))
          is_complete = false;
      }
    });
    return is_complete;
  }

  // Where a direction is in one of the triangles of a hole, fanned out from its first vertex, and goes to along with it.
  static Vector_3d carried(const Vector_3d& p, const Ring_hole& from, const Ring_hole& to)
  {
    for(std::size_t j = 1; j + 1 < from.size(); ++j)
    {
      const Vector_3d &a = from[0], &b = from[j], &c = from[j + 1];
      const double u = dot(p, cross(b, c)), v = dot(p, cross(c, a)), w = dot(p, cross(a, b));
      if(u >= 0. && v >= 0. && w >= 0.)
        return normalized(u * to[0] + v * to[j] + w * to[j + 1]);
    }
    return p;
  }

  const Indexed_mesh& m_mesh;
  const Target_metric& m_metric;
  const Feature_goals& m_features;
  Execution m_execution;
  std::vector<const Vector_3d*> m_goals; // of the landmarks, null for all other vertices
  std::vector<char> m_is_landmark, m_is_pinned;
  bool m_is_hard, m_is_stopped = false;
  double m_weight = 0.;
  Newton_step m_step;
  Per_thread<Target_star> m_stars;
  Per_thread<Star_kernel> m_kernels;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_SURFACE_DESCENT_H
