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

#include <CGAL/Spherical_parameterization/internal/align/Rotation_search.h>
#include <CGAL/Spherical_parameterization/internal/align/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/sampling/surface_samples.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

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
    for(const Point_3& p : images.points())
      m_images.push_back(direction_of({p.x(), p.y(), p.z()}).value_or(Vector_3d{0., 0., 0.}));
    m_begins.assign(m_images.size() + 1, 0);
    for(const Linked_triangle& t : m_triangles)
      for(const std::uint32_t v : t.vertices)
        ++m_begins[v + 1];
    for(std::size_t v = 0; v < m_images.size(); ++v)
      m_begins[v + 1] += m_begins[v];
    m_corners.resize(3 * m_triangles.size());
    std::vector<std::uint32_t> ends(m_begins.begin(), m_begins.end() - 1);
    for(std::uint32_t t = 0; t < m_triangles.size(); ++t)
      for(std::uint32_t i = 0; i < 3; ++i)
        m_corners[ends[m_triangles[t][i]]++] = {t, i};
  }

  // Returns the directions of the vertices, a bijection if the images are one: nearly where the grid leads to; less bent
  // if that cannot be had, or only turned; or none if even that folds, as rounded coordinates are not turned exactly.
  std::optional<std::vector<Vector_3d>> directions(const Sphere_grid& grid, const std::vector<Vector_3d>& bent_grid,
                                                   const Rotation_matrix& rotation, const Execution& execution) const
  {
    std::vector<Point_3> queries;
    for(const Vector_3d& p : m_images)
      queries.emplace_back(p[0], p[1], p[2]);
    const auto places = grid.triangulation().locate(queries, execution);
    std::vector<Vector_3d> bent(m_images.size()), turned(m_images.size());
    for(std::size_t v = 0; v < m_images.size(); ++v)
    {
      bent[v] = interpolated(bent_grid, grid.triangles(), places[v]);
      turned[v] = rotated(rotation, m_images[v]);
    }
    for(const double share : {1., 0.75, 0.5, 0.25, 0.})
    {
      std::vector<Vector_3d> result(m_images.size());
      for(std::size_t v = 0; v < m_images.size(); ++v)
        result[v] = normalized(share * bent[v] + (1. - share) * turned[v]);
      if(unfold(result))
        return result;
    }
    return std::nullopt;
  }

private:
  struct Corner
  {
    std::uint32_t triangle, corner;
  };

  bool is_positive(const Linked_triangle& t, const std::vector<Vector_3d>& p) const
  {
    const auto point = [&](std::size_t i) { return Point_3(p[t[i]][0], p[t[i]][1], p[t[i]][2]); };
    return m_orientation(point(0), point(1), point(2)) == CGAL::POSITIVE;
  }

  // Moves the vertices of triangles that are not positive, and some rings around them: more around those that stay so.
  // Returns whether all triangles have become positive.
  bool unfold(std::vector<Vector_3d>& p) const
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
      for(const std::uint32_t v : moving)
        ++ages[v];
      for(std::size_t k = 0; k < moving.size(); ++k)
        if(const std::uint32_t v = moving[k]; rings[v] > 0)
          for(std::uint32_t c = m_begins[v]; c < m_begins[v + 1]; ++c)
            for(const std::uint32_t w : m_triangles[m_corners[c].triangle].vertices)
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
    for(std::uint32_t c = m_begins[v]; c < m_begins[v + 1]; ++c)
    {
      const Linked_triangle& t = m_triangles[m_corners[c].triangle];
      const std::uint32_t a = t[(m_corners[c].corner + 1) % 3], b = t[(m_corners[c].corner + 2) % 3];
      const Vector_3d u = m_images[a] - m_images[v], w = m_images[b] - m_images[v];
      const double r = length(u), s = length(w);
      const double tangent = length(cross(u, w)) / (r * s + dot(u, w)); // of half the angle
      sum = sum + (tangent / r) * p[a] + (tangent / s) * p[b];
    }
    const double size = length(sum);
    return size > 0. && is_finite(size) ? (1. / size) * sum : p[v];
  }

  Orientation_about_origin_3<K> m_orientation;
  std::vector<Linked_triangle> m_triangles;
  std::vector<Vector_3d> m_images;
  std::vector<std::uint32_t> m_begins;
  std::vector<Corner> m_corners; // at each vertex
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_BENT_MAP_H
