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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SPHERE_GRID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SPHERE_GRID_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/surface/link_triangles.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Directions that cover the sphere evenly, by which two surfaces are compared: what is computed on them takes the same
// time for all meshes, and does not depend on how these are triangulated.
class Sphere_grid
{
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Triangulation = Sphere_triangulation<Kernel>;

  // by default, 4002 directions, 3 to 4 degrees apart
  explicit Sphere_grid(std::uint32_t n = 20)
  {
    const Sphere_domain_3 domain = Sphere_domain_3::icosahedron(n);
    for(const auto& q : domain.directions())
      m_directions.push_back({q.x(), q.y(), q.z()});
    m_triangulation.assign(domain.directions(), link_triangles(domain.triangles(), domain.directions().size()));
    m_triangulation.make_grid();
    std::vector<std::vector<std::uint32_t>> neighbors(m_directions.size());
    for(const Linked_triangle& t : triangles())
      for(std::size_t i = 0; i < 3; ++i)
        neighbors[t[i]].push_back(t[(i + 1) % 3]); // Each edge is in two triangles, once in each direction.
    m_begins.push_back(0);
    for(const auto& ring : neighbors)
    {
      m_neighbors.insert(m_neighbors.end(), ring.begin(), ring.end());
      m_begins.push_back(static_cast<std::uint32_t>(m_neighbors.size()));
    }
  }

  std::size_t size() const { return m_directions.size(); }
  const std::vector<Vector_3d>& directions() const { return m_directions; }
  const Triangulation& triangulation() const { return m_triangulation; }
  const std::vector<Linked_triangle>& triangles() const { return m_triangulation.triangles(); }

  // Calls f(w) for the vertices w that are joined with v by an edge.
  template <class Function>
  void for_each_neighbor(std::size_t v, const Function& f) const
  {
    for(std::uint32_t k = m_begins[v]; k < m_begins[v + 1]; ++k)
      f(m_neighbors[k]);
  }

private:
  std::vector<Vector_3d> m_directions;
  Triangulation m_triangulation;
  std::vector<std::uint32_t> m_begins, m_neighbors;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SPHERE_GRID_H
