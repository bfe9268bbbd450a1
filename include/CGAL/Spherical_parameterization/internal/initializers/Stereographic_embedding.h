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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_STEREOGRAPHIC_EMBEDDING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_STEREOGRAPHIC_EMBEDDING_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Laplacian_system.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Run.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The number of edges from `source` to each vertex of a connected mesh.
inline std::vector<std::uint32_t> edge_distances(const Vertex_rings& rings, std::uint32_t source)
{
  const std::size_t n = rings.number_of_vertices();
  std::vector<std::uint32_t> distance(n, static_cast<std::uint32_t>(n)), queue = {source};
  queue.reserve(n);
  distance[source] = 0;
  for(std::size_t k = 0; k < queue.size(); ++k)
    for(const std::uint32_t w : rings.ring(queue[k]))
      if(distance[w] == n)
      {
        distance[w] = distance[queue[k]] + 1;
        queue.push_back(w);
      }
  return distance;
}

// A vertex in the middle of the surface: the vertex with the smallest maximum distance from the extremities. These are
// found one after the other, each as far as possible from the previous ones.
inline std::uint32_t central_vertex(const Vertex_rings& rings)
{
  constexpr int number_of_extremities = 8; // a body has five, and a few more
  std::vector<std::uint32_t> nearest = edge_distances(rings, 0), farthest(rings.number_of_vertices(), 0);
  for(int k = 0; k < number_of_extremities; ++k)
  {
    const auto extremity = std::max_element(nearest.begin(), nearest.end()) - nearest.begin();
    const std::vector<std::uint32_t> distance = edge_distances(rings, static_cast<std::uint32_t>(extremity));
    for(std::size_t v = 0; v < distance.size(); ++v)
    {
      nearest[v] = k == 0 ? distance[v] : (std::min)(nearest[v], distance[v]);
      farthest[v] = (std::max)(farthest[v], distance[v]);
    }
  }
  return static_cast<std::uint32_t>(std::min_element(farthest.begin(), farthest.end()) - farthest.begin());
}

// A conformal map of the unit sphere to itself that moves all points towards c / |c|, along the circles through c / |c|
// and -c / |c|, farther the closer |c| < 1 is to 1. Together with the rotations, these maps generate all
// orientation-preserving conformal maps.
struct Moebius_transformation
{
  Vector_3d c;

  Vector_3d operator()(const Vector_3d& u) const
  {
    const Vector_3d s = u + c;
    return normalized(((1. - squared_length(c)) / squared_length(s)) * s + c);
  }
};

// The solution x of sum m (1 - u u^T) x = b. The matrix is symmetric, and positive definite unless all points are on
// one line.
inline Vector_3d solve_tangential(const std::vector<Vector_3d>& points, const std::vector<double>& masses,
                                  const Vector_3d& b)
{
  std::array<Vector_3d, 3> rows = {};
  for(std::size_t v = 0; v < points.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        rows[i][j] += masses[v] * ((i == j ? 1. : 0.) - points[v][i] * points[v][j]);
  // Cramer's rule
  const Vector_3d c0 = cross(rows[1], rows[2]), c1 = cross(rows[2], rows[0]), c2 = cross(rows[0], rows[1]);
  return (1. / dot(rows[0], c0)) * (b[0] * c0 + b[1] * c1 + b[2] * c2);
}

// Moves points of the unit sphere by Moebius transformations until their center of mass is at the center of the sphere.
// Such a transformation exists and is unique up to rotations if no point has half of the mass or more. The mass of a
// vertex, a third of the areas of its faces, is always smaller.
//
// A transformation for which `is_admissible(moved points)` is false is replaced by a weaker one; if those are not
// admissible either, the points stay unchanged. Returns the remaining distance.
template <class IsAdmissible>
double center_mass(std::vector<Vector_3d>& points, const std::vector<double>& masses, const IsAdmissible& is_admissible)
{
  constexpr double tolerance = 1e-12, max_push = 0.5; // of the radius, above rounding error; |c| < 1
  constexpr int max_pushes = 100, max_halvings = 8;   // a few suffice, unless most mass is in one region

  const double mass = std::accumulate(masses.begin(), masses.end(), 0.);
  std::vector<Vector_3d> moved(points.size());
  Vector_3d center = center_of_mass(points, masses);
  for(int k = 0; k < max_pushes && length(center) > tolerance; ++k)
  {
    // Newton's method: to first order, c moves a point u by 2 (c - (c u) u).
    Vector_3d push = solve_tangential(points, masses, (-0.5 * mass) * center);
    const double size = length(push);
    if(!(size > 0.))
      break;
    if(size > max_push)
      push = (max_push / size) * push;
    Vector_3d next_center;
    const auto is_nearer = [&] {
      std::transform(points.begin(), points.end(), moved.begin(), Moebius_transformation{push});
      next_center = center_of_mass(moved, masses);
      return length(next_center) < length(center) && is_admissible(moved);
    };
    int n_halvings = 0;
    for(; n_halvings < max_halvings && !is_nearer(); ++n_halvings)
      push = 0.5 * push;
    if(n_halvings == max_halvings)
      break;
    center = next_center;
    points.swap(moved);
  }
  return length(center);
}

// Maps a mesh to the unit sphere through the plane. Without one vertex in the middle of the surface, the pole, the mesh
// is a disc and has a Tutte embedding, with the ring of the pole on a circle and every other vertex at the weighted
// mean of its neighbors. The inverse stereographic projection maps the plane to the sphere and the pole to the north
// pole, and a Moebius transformation balances both sides.
//
// Edges are straight in the plane and great circles on the sphere, so the projection may invert large faces, as on
// coarse meshes. In this case, the plane is projected to the southern hemisphere from the center of the sphere instead,
// which maps straight lines to great circles, and the star of the pole covers the rest.
template <class SolverTraits>
class Stereographic_embedding
{
public:
  explicit Stereographic_embedding(const Surface& mesh)
    : m_mesh(mesh)
    , m_rings(mesh.rings())
    , m_pole(central_vertex(mesh.rings()))
    , m_masses(vertex_masses(mesh.rings(), mesh.points()))
  {}

  // Embeds the mesh in the plane. Returns false if the linear system could not be solved.
  bool solve()
  {
    place_ring_of_pole();
    if(m_rings.degree(m_pole) + 1 < m_rings.number_of_vertices() && !place_other_vertices())
      return false;
    scale_plane();
    return true;
  }

  // Maps the plane to the sphere; returns whether no face is inverted.
  bool project(std::vector<Vector_3d>& positions) const
  {
    const auto stereographic = [](const Vector_3d& p) {
      return Vector_3d{2. * p[0], 2. * p[1], squared_length(p) - 1.};
    };
    const auto central = [](const Vector_3d& p) { return Vector_3d{p[0], p[1], -1.}; };
    const bool is_bijective = is_positive_by(stereographic, positions) || is_positive_by(central, positions);
    if(!is_bijective)
      is_positive_by(stereographic, positions);
    center_mass(positions, m_masses,
                [&](const std::vector<Vector_3d>& p) { return !is_bijective || are_safely_positive(m_rings, p); });
    return is_bijective;
  }

private:
  // The angles between neighbors are proportional to those at the pole, blended with equal ones, so that no angle is
  // half a turn or more.
  void place_ring_of_pole()
  {
    constexpr double turn = 2. * CGAL_PI, own_blend = 0.6; // the weight of the angle at the pole
    const Vertex_rings::Ring ring = m_rings.ring(m_pole);
    std::vector<double> angles(ring.size());
    double sum = 0.;
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      const Vector_3d p = m_mesh.points()[ring[j]] - m_mesh.points()[m_pole];
      const Vector_3d q = m_mesh.points()[ring.around(j + 1)] - m_mesh.points()[m_pole];
      sum += angles[j] = arc_tangent(length(cross(p, q)), dot(p, q));
    }
    const double equal_share = 1. / static_cast<double>(ring.size());
    double phi = 0.;
    m_plane.assign(m_rings.number_of_vertices(), {0., 0., 0.});
    m_is_fixed.assign(m_plane.size(), 0);
    m_is_fixed[m_pole] = 1;
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      m_plane[ring[j]] = {cosine(phi), sine(phi), 0.};
      m_is_fixed[ring[j]] = 1;
      const double own_share = sum > 0. ? angles[j] / sum : equal_share;
      phi += turn * (own_blend * (std::min)(own_share, 0.5) + (1. - own_blend) * equal_share);
    }
  }

  // Solves the system twice: first to find where most of the surface is mapped, and then with this point as the origin,
  // where floating-point numbers are densest.
  bool place_other_vertices()
  {
    const std::vector<double> weights = cotangent_weights(m_rings, m_mesh.points(), min_positive_weight);
    Laplacian_system<SolverTraits> system;
    if(!system.factor(m_rings, weights, [&](std::uint32_t v) { return m_is_fixed[v] != 0; }))
      return false;
    for(int pass = 0; pass < 2; ++pass)
    {
      std::vector<Vector_3d> x(m_plane.size(), {0., 0., 0.});
      for(const std::uint32_t w : m_rings.ring(m_pole))
        for(std::size_t j = 0; j < m_rings.degree(w); ++j)
        {
          Vector_3d& right = x[m_rings.ring(w)[j]];
          right = right + weights[m_rings.offset(w) + j] * m_plane[w];
        }
      if(!system.solve(x))
        return false;
      for(std::size_t v = 0; v < x.size(); ++v)
        if(!m_is_fixed[v])
          m_plane[v] = x[v];
      if(pass == 0)
      {
        const Vector_3d center = center_of_mass(m_plane, m_masses);
        for(const std::uint32_t w : m_rings.ring(m_pole))
          m_plane[w] = m_plane[w] - center;
      }
    }
    return true;
  }

  // Scales the plane so that half of the area of the surface is within the unit circle. Otherwise it would be
  // concentrated around the south pole, where the resolution of floating-point numbers is insufficient.
  void scale_plane()
  {
    std::vector<std::pair<double, double>> areas_by_distance;
    for(std::size_t v = 0; v < m_plane.size(); ++v)
      areas_by_distance.emplace_back(length(m_plane[v]), m_masses[v]);
    std::sort(areas_by_distance.begin(), areas_by_distance.end());
    const double half = 0.5 * std::accumulate(m_masses.begin(), m_masses.end(), 0.);
    double inside = 0.;
    for(const auto& [distance, area] : areas_by_distance)
    {
      inside += area;
      if(inside > half && distance > 0.)
      {
        for(Vector_3d& p : m_plane)
          p = (1. / distance) * p;
        return;
      }
    }
  }

  // Projects the plane; returns whether no face is inverted.
  template <class Projection>
  bool is_positive_by(const Projection& projection, std::vector<Vector_3d>& positions) const
  {
    positions.resize(m_plane.size());
    for(std::size_t v = 0; v < m_plane.size(); ++v)
      positions[v] = normalized(projection(m_plane[v]));
    positions[m_pole] = {0., 0., 1.};
    return are_safely_positive(m_rings, positions);
  }

  const Surface& m_mesh;
  const Vertex_rings& m_rings;
  std::uint32_t m_pole;
  std::vector<double> m_masses; // of the vertices
  std::vector<char> m_is_fixed;
  std::vector<Vector_3d> m_plane;
};

// Maps a mesh to the unit sphere through the plane, as a result or as an initial map of other methods. If double
// precision cannot represent a bijection, this is an error if `has_to_be_bijective`; otherwise the map is stereographic
// and has inverted faces.
template <class SolverTraits>
Error_code embed_stereographically(Run& run, bool has_to_be_bijective)
{
  run.control.on_initialization_begin(run.surface.number_of_vertices());
  Stereographic_embedding<SolverTraits> embedding(run.surface);
  if(!embedding.solve())
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  const bool is_bijective = embedding.project(run.positions);
  run.control.report().seconds_for_embedding = run.control.lap();
  if(has_to_be_bijective && !is_bijective)
    return ERROR_INSUFFICIENT_PRECISION;
  run.control.on_initialization_end();
  run.control.report().stop_reason = CONVERGED;
  return OK;
}

#if defined(CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY) && defined(CGAL_EIGEN3_ENABLED)
extern template Error_code embed_stereographically<Default>(Run&, bool);
#endif

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_STEREOGRAPHIC_EMBEDDING_H
