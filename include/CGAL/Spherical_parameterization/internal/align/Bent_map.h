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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_BENT_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_BENT_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>

#include <CGAL/Spherical_parameterization/internal/run/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Carries the images of a mesh along with a grid that is bent, such that no triangle turns over. `K` is a kernel with
// exact predicates on doubles.
//
// Edges of the mesh are straight, where the grid bends them, so that some triangles turn over. The vertices around these
// go to the weighted means of their neighbours, with weights (mean value coordinates) by which the images are such means:
// it turns the bent map into the rigid one, locally, and step by step farther around what remains.
template <class K>
class Bent_map
{
public:
  using Point_3 = typename K::Point_3;

  explicit Bent_map(const Sphere_triangulation<K>& images)
    : m_triangles(images.triangles())
  {
    for(std::size_t v = 0; v < images.points().size(); ++v)
      m_images.push_back(images.direction(v));
    build_rings(m_triangles, m_images.size(), m_rings);
  }

  // Returns the directions of the vertices, a bijection if the images are one: nearly where the grid leads to; or none if
  // that cannot be had, or the control says no meanwhile.
  std::optional<std::vector<Vector_3d>> directions(const Sphere_grid& grid, const std::vector<Vector_3d>& bent_grid,
                                                   Run_control& control, const Execution& execution) const
  {
    std::vector<Point_3> queries;
    for(const Vector_3d& p : m_images)
      queries.emplace_back(p[0], p[1], p[2]);
    std::vector<Vector_3d> result;
    for(const auto& place : grid.triangulation().locate(queries, execution))
      result.push_back(normalized(interpolated(bent_grid, grid.triangles(), place)));
    if(!unfold(result, control))
      return std::nullopt;
    return result;
  }

private:
  bool is_positive(const Linked_triangle& t, const std::vector<Vector_3d>& p) const
  {
    const auto point = [&](std::size_t i) { return Point_3(p[t[i]][0], p[t[i]][1], p[t[i]][2]); };
    return m_orientation(point(0), point(1), point(2)) == CGAL::POSITIVE;
  }

  // Moves the vertices of triangles that are not positive, and some rings around them: more around those that stay so.
  // Returns whether all triangles have become positive.
  bool unfold(std::vector<Vector_3d>& p, Run_control& control) const
  {
    constexpr int n_rounds = 200, n_iterations = 5, rounds_for_each_ring = 4;
    std::vector<int> ages(p.size(), 0), rings(p.size());
    std::vector<std::uint32_t> moving;
    for(int round = 0; round < n_rounds; ++round)
    {
      moving.clear();
      std::fill(rings.begin(), rings.end(), -1);
      const auto add = [&](std::uint32_t v, int n_rings) {
        if(n_rings > rings[v])
        {
          rings[v] = n_rings;
          moving.push_back(v); // perhaps again
        }
      };
      for(const Linked_triangle& t : m_triangles)
        if(!is_positive(t, p))
          for(const std::uint32_t v : t.vertices)
            add(v, ages[v] / rounds_for_each_ring);
      if(moving.empty())
        return true;
      if(!control.go_further(0, 0.))
        return false;
      for(const std::uint32_t v : moving)
        ++ages[v];
      for(std::size_t k = 0; k < moving.size(); ++k)
        if(const std::uint32_t v = moving[k]; rings[v] > 0)
          for(const std::uint32_t w : m_rings.ring(v))
            add(w, rings[v] - 1);
      std::sort(moving.begin(), moving.end());
      moving.erase(std::unique(moving.begin(), moving.end()), moving.end());
      for(int k = 0; k < n_iterations; ++k)
        for(const std::uint32_t v : moving)
          p[v] = mean_of_neighbors(v, p);
    }
    return false;
  }

  Vector_3d mean_of_neighbors(std::uint32_t v, const std::vector<Vector_3d>& p) const
  {
    Vector_3d sum = {0., 0., 0.};
    const Vertex_rings::Ring ring = m_rings.ring(v);
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      const std::uint32_t a = ring[j], b = ring.around(j + 1);
      const Vector_3d u = m_images[a] - m_images[v], w = m_images[b] - m_images[v];
      const double r = length(u), s = length(w);
      const double tangent = length(cross(u, w)) / (r * s + dot(u, w)); // of half the angle
      sum = sum + (tangent / r) * p[a] + (tangent / s) * p[b];
    }
    const double size = length(sum);
    return size > 0. && is_finite(size) ? (1. / size) * sum : p[v];
  }

  Orientation_about_origin_3<K> m_orientation;
  const std::vector<Linked_triangle>& m_triangles;
  std::vector<Vector_3d> m_images;
  Vertex_rings m_rings;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_BENT_MAP_H
