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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_DIFFUSION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_DIFFUSION_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/conjugate_gradients.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/vertex_scalars.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Heat diffusion on a surface, in implicit steps: (M + t L) x = M y, with the cotangents of the triangles in L and
// areas in M, solved by conjugate gradients. The cotangents are kept positive and finite, and `min_area` is positive if
// points coincide, so that the matrix is positive definite.
class Surface_diffusion
{
public:
  using Vectors = std::vector<Vector_3d>;

  // The rings must outlive this object.
  Surface_diffusion(const Vertex_rings& rings, const Vectors& points, double min_area, const Execution& execution)
    : m_rings(&rings)
    , m_execution(execution)
    , m_areas(points.size())
    , m_weights(rings.number_of_corners())
    , m_sums(points.size(), 0.)
  {
    // Approximately the cotangents of 89 and 1 degrees. With a larger minimum, obtuse triangles conduct too much. A
    // smaller minimum, or a larger maximum, which needles would have, makes the weights more unequal and increases the
    // number of steps.
    constexpr double min_cotangent = 0.02, max_cotangent = 1. / min_cotangent;
    const auto half_cotangent = [&](const Vector_3d& o, const Vector_3d& p, const Vector_3d& q) {
      const Vector_3d a = p - o, b = q - o;
      return 0.5 * std::clamp(dot(a, b) / (length(cross(a, b)) + min_area), min_cotangent, max_cotangent);
    };
    for_each_vertex([&](std::size_t v) {
      const Vertex_rings::Ring ring = rings.ring(v);
      double area = 0.;
      for(std::size_t j = 0; j < ring.size(); ++j)
      {
        const Vector_3d &p = points[v], &q = points[ring[j]], &next = points[ring.around(j + 1)],
                        &last = points[ring.around(j + ring.size() - 1)];
        area += length(cross(q - p, next - p)) / 6.;
        m_sums[v] += m_weights[rings.offset(v) + j] = half_cotangent(last, p, q) + half_cotangent(next, p, q);
      }
      m_areas[v] = (std::max)(area, min_area);
    });
  }

  const Vertex_scalars& areas() const { return m_areas; }

  // The negative off-diagonal entry of L of a vertex and its j-th neighbor.
  double weight(std::size_t v, std::size_t j) const { return m_weights[m_rings->offset(v) + j]; }

  // The values, or points, after the time t, with an error of about `tolerance` relative to their changes.
  template <class T>
  std::vector<T> after(double t, const std::vector<T>& values, double tolerance) const
  {
    constexpr std::size_t max_steps = 300; // limits the time on surfaces with needles
    using Values = std::vector<T>;
    Values x = values, r(x.size());
    for_each_vertex([&](std::size_t v) { r[v] = -t * flow(x, v); }); // M y - (M + t L) y
    conjugate_gradients(
        x, r,
        [&](const Values& p, Values& q) {
          return sum_over_vertices([&](std::size_t v) {
            q[v] = m_areas[v] * p[v] + t * flow(p, v);
            return product(p[v], q[v]);
          });
        },
        [&](const Values& residual, Values& z) {
          return sum_over_vertices([&](std::size_t v) {
            z[v] = (1. / (m_areas[v] + t * m_sums[v])) * residual[v];
            return product(residual[v], z[v]);
          });
        },
        [&](std::size_t k, double rz, double first, double) {
          return k < max_steps && rz > tolerance * tolerance * first;
        },
        m_execution);
    return x;
  }

  // The signed distances of points from others, along the normals at the first ones; 0 where there is no normal.
  Vertex_scalars outside(const Vectors& points, const Vectors& others) const
  {
    Vertex_scalars result(points.size());
    for_each_vertex([&](std::size_t v) {
      const Vertex_rings::Ring ring = m_rings->ring(v);
      Vector_3d normal = {0., 0., 0.};
      for(std::size_t j = 0; j < ring.size(); ++j)
        normal = normal + cross(points[ring[j]] - points[v], points[ring.around(j + 1)] - points[v]);
      result[v] = length(normal) > 0. ? dot(points[v] - others[v], normalized(normal)) : 0.;
    });
    return result;
  }

private:
  static double product(double a, double b) { return a * b; }
  static double product(const Vector_3d& a, const Vector_3d& b) { return dot(a, b); }

  template <class Function>
  void for_each_vertex(const Function& f) const
  {
    for_each_in_blocks(m_execution, 0, m_areas.size(), usual_block_size, f);
  }

  template <class Function>
  double sum_over_vertices(const Function& f) const
  {
    Vertex_scalars sums((m_areas.size() + usual_block_size - 1) / usual_block_size,
                        0.); // in order, for any number of threads
    for_each_block(m_execution, 0, m_areas.size(), usual_block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t v = begin; v < end; ++v)
        sums[begin / usual_block_size] += f(v);
    });
    return std::accumulate(sums.begin(), sums.end(), 0.);
  }

  // The product of L with values, at a vertex.
  template <class T>
  T flow(const std::vector<T>& values, std::size_t v) const
  {
    const Vertex_rings::Ring ring = m_rings->ring(v);
    const double* weights = &m_weights[m_rings->offset(v)];
    T result = m_sums[v] * values[v];
    for(std::size_t j = 0; j < ring.size(); ++j)
      result = result - weights[j] * values[ring[j]];
    return result;
  }

  const Vertex_rings* m_rings;
  Execution m_execution;
  Vertex_scalars m_areas;
  Vertex_scalars m_weights; // of each vertex and each of its neighbors, and their sums
  Vertex_scalars m_sums;
};

// The displacement of a surface of area 1 relative to the surface after smoothing for the time t, along the normal. For
// short times, it is t times the sum of the principal curvatures.
inline Vertex_scalars mean_curvature(const Vertex_rings& rings, const std::vector<Vector_3d>& points, double t,
                                     double min_area, const Execution& execution = {})
{
  constexpr double tolerance = 1e-5; // required by the alignment of maps between surfaces
  const Surface_diffusion diffusion(rings, points, min_area, execution);
  return diffusion.outside(points, diffusion.after(t, points, tolerance));
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_DIFFUSION_H
