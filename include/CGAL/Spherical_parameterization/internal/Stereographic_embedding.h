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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STEREOGRAPHIC_EMBEDDING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STEREOGRAPHIC_EMBEDDING_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Laplacian_system.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/center_mass.h>
#include <CGAL/Spherical_parameterization/internal/central_vertex.h>
#include <CGAL/Spherical_parameterization/internal/cotangent_weights.h>
#include <CGAL/Spherical_parameterization/internal/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/vertex_areas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Maps a mesh to the unit sphere through the plane: without one vertex in the middle of the surface, the pole, the mesh
// is a disc and has a Tutte embedding, with the ring of the pole on a circle and every other vertex in the weighted
// mean of its neighbours. The plane goes to the sphere by the inverse of the stereographic projection, the pole to the
// north pole, and a Moebius transformation balances the two sides.
//
// As edges are straight in the plane and great circles on the sphere, large faces may be turned over on the way, as on
// coarse meshes. Then the plane is projected to the southern hemisphere from the centre of the sphere instead, which
// keeps straight what is straight, and the star of the pole covers the rest.
template <class SolverTraits>
class Stereographic_embedding
{
public:
  explicit Stereographic_embedding(const Indexed_mesh& mesh)
    : m_mesh(mesh)
    , m_rings(mesh.rings())
    , m_pole(central_vertex(mesh.rings()))
    , m_areas(vertex_masses(mesh.rings(), mesh.points()))
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

  // Takes the plane to the sphere, whether or not faces are turned over.
  void project(std::vector<Vector_3d>& positions) const
  {
    project_stereographically(positions);
    center_mass(positions, m_areas, [](const std::vector<Vector_3d>&) { return true; });
  }

  // Takes the plane to the sphere; returns false if doubles cannot hold the map.
  bool project_bijectively(std::vector<Vector_3d>& positions) const
  {
    const auto are_positive = [&](const std::vector<Vector_3d>& p) { return are_safely_positive(m_rings, p); };
    project_stereographically(positions);
    if(!are_positive(positions))
      project_centrally(positions);
    if(!are_positive(positions))
      return false;
    center_mass(positions, m_areas, are_positive);
    return true;
  }

private:
  // The angles between neighbours are in proportion to those at the pole, blended with equal ones: no angle is half a
  // turn or more.
  void place_ring_of_pole()
  {
    const double turn = 2. * 3.14159265358979323846;
    const Vertex_rings::Ring ring = m_rings.ring(m_pole);
    std::vector<double> angles(ring.size());
    double sum = 0.;
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      const Vector_3d p = m_mesh.points()[ring[j]] - m_mesh.points()[m_pole];
      const Vector_3d q = m_mesh.points()[ring.around(j + 1)] - m_mesh.points()[m_pole];
      sum += angles[j] = std::atan2(length(cross(p, q)), dot(p, q));
    }
    const double equal_share = 1. / static_cast<double>(ring.size());
    double phi = 0.;
    m_plane.assign(m_rings.number_of_vertices(), {0., 0., 0.});
    m_is_fixed.assign(m_plane.size(), 0);
    m_is_fixed[m_pole] = 1;
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      m_plane[ring[j]] = {std::cos(phi), std::sin(phi), 0.};
      m_is_fixed[ring[j]] = 1;
      const double own_share = sum > 0. ? angles[j] / sum : equal_share;
      phi += turn * (own_blend * (std::min)(own_share, 0.5) + (1. - own_blend) * equal_share);
    }
  }

  // Solves the system twice: once to learn where most of the surface is, and once with that place as the origin, where
  // numbers are finest.
  bool place_other_vertices()
  {
    const std::vector<double> weights = cotangent_weights(m_rings, m_mesh.points(), least_positive_weight);
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
        const Vector_3d center = center_of_mass(m_plane, m_areas);
        for(const std::uint32_t w : m_rings.ring(m_pole))
          m_plane[w] = m_plane[w] - center;
      }
    }
    return true;
  }

  // Scales the plane such that half of the area of the surface is within the unit circle: on the sphere, it would be
  // crowded around the south pole else, where the numbers are coarse for it.
  void scale_plane()
  {
    std::vector<std::pair<double, double>> areas_by_distance;
    double sum = 0.;
    for(std::size_t v = 0; v < m_plane.size(); ++v)
    {
      areas_by_distance.emplace_back(length(m_plane[v]), m_areas[v]);
      sum += m_areas[v];
    }
    std::sort(areas_by_distance.begin(), areas_by_distance.end());
    double inside = 0.;
    double scale = 1.;
    for(const auto& [distance, area] : areas_by_distance)
    {
      inside += area;
      if(inside > 0.5 * sum && distance > 0.)
      {
        scale = 1. / distance;
        break;
      }
    }
    for(Vector_3d& p : m_plane)
      p = scale * p;
  }

  void project_stereographically(std::vector<Vector_3d>& positions) const
  {
    positions.resize(m_plane.size());
    for(std::size_t v = 0; v < m_plane.size(); ++v)
    {
      const Vector_3d& p = m_plane[v];
      positions[v] = normalized({2. * p[0], 2. * p[1], squared_length(p) - 1.});
    }
    positions[m_pole] = {0., 0., 1.};
  }

  void project_centrally(std::vector<Vector_3d>& positions) const
  {
    positions.resize(m_plane.size());
    for(std::size_t v = 0; v < m_plane.size(); ++v)
      positions[v] = normalized({m_plane[v][0], m_plane[v][1], -1.});
    positions[m_pole] = {0., 0., 1.};
  }

  // how much of an angle follows the angle at the pole
  static constexpr double own_blend = 0.6;

  const Indexed_mesh& m_mesh;
  const Vertex_rings& m_rings;
  std::uint32_t m_pole;
  std::vector<double> m_areas; // of the vertices
  std::vector<char> m_is_fixed;
  std::vector<Vector_3d> m_plane;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STEREOGRAPHIC_EMBEDDING_H
