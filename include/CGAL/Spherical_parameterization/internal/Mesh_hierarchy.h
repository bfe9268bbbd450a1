// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_HIERARCHY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_HIERARCHY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_removal.h>
#include <CGAL/Spherical_parameterization/internal/vertex_areas.h>
#include <CGAL/Spherical_parameterization/internal/for_each_block.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A sequence of ever coarser meshes from a given one down to a tetrahedron. Each is made from the one before by
// removing an independent set of its vertices: a removed vertex is collapsed into one of its neighbours, which are all
// kept. So all vertices that one level adds to the next coarser one can be inserted at once, each into a hole of
// vertices that are all there, and no error is handed from one insertion to the next.
//
// Level 0 is the given mesh itself. Every level numbers its own vertices, in the order of the given mesh.
//
// A coarse mesh has lost area: where a limb was, there may be a spike. So every vertex carries the area of the surface
// that it stands for, and hands it on to its ring when it is removed. Whoever maps a coarse level can then leave as
// much room for a limb as the surface needs.
class Mesh_hierarchy
{
public:
  // A vertex of a level that the next coarser level lacks, and the vertex of its ring that it is collapsed into there.
  struct Removed_vertex
  {
    std::uint32_t vertex;
    std::uint32_t target; // index into the ring of the vertex
  };

  struct Level
  {
    Vertex_rings rings;
    std::vector<std::uint32_t> vertices; // their numbers in the given mesh
    std::vector<double> areas;           // of the surface that the vertices stand for
    std::vector<Removed_vertex> removed; // empty at the coarsest level
  };

  template <class ConcurrencyTag>
  static Mesh_hierarchy build(const Vertex_rings& rings, const std::vector<Vector_3d>& points)
  {
    Mesh_hierarchy hierarchy;
    hierarchy.m_levels.emplace_back();
    Level& finest = hierarchy.m_levels.back();
    finest.rings = rings;
    finest.vertices.resize(rings.number_of_vertices());
    std::iota(finest.vertices.begin(), finest.vertices.end(), 0u);
    finest.areas = vertex_areas(rings, points);
    while(hierarchy.m_levels.back().vertices.size() > 4)
      hierarchy.coarsen<ConcurrencyTag>(points);
    return hierarchy;
  }

  std::size_t number_of_levels() const { return m_levels.size(); }
  const Level& level(std::size_t k) const { return m_levels[k]; }

private:
  // the share of the vertices that one level removes at most
  static constexpr double largest_share = 0.25;
  static constexpr std::size_t block_size = 512;

  template <class ConcurrencyTag>
  void coarsen(const std::vector<Vector_3d>& points)
  {
    Level& fine = m_levels.back();
    const std::size_t n = fine.vertices.size();
    std::vector<Vector_3d> p(n);
    for(std::size_t v = 0; v < n; ++v)
      p[v] = points[fine.vertices[v]];

    std::vector<Vertex_removal> removals(n);
    for(const bool is_exact : {false, true}) // exact only if the quick search finds nothing
    {
      for_each_block<ConcurrencyTag>(0, n, block_size, [&](std::size_t begin, std::size_t end) {
        for(std::size_t v = begin; v < end; ++v)
          removals[v] = Vertex_removal::best(fine.rings, p, static_cast<std::uint32_t>(v), is_exact);
      });
      select(fine, removals);
      if(!fine.removed.empty())
        break;
    }
    m_levels.push_back(without_removed(fine));
  }

  // Chooses the removals in the order of their costs, unless a neighbour has been chosen already or an edge of the new
  // faces is there already.
  static void select(Level& fine, const std::vector<Vertex_removal>& removals)
  {
    const std::size_t n = removals.size();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> candidates; // rank of the cost, vertex
    for(std::size_t v = 0; v < n; ++v)
      if(removals[v].is_possible())
        candidates.emplace_back(removals[v].rank(), static_cast<std::uint32_t>(v));
    std::sort(candidates.begin(), candidates.end());

    const std::size_t most =
        (std::min)(n - 4, (std::max)(static_cast<std::size_t>(largest_share * static_cast<double>(n)), std::size_t(1)));
    std::vector<char> is_locked(n, 0);
    std::unordered_set<std::uint64_t> new_edges;
    std::vector<std::uint64_t> edges;
    for(const auto& candidate : candidates)
    {
      if(fine.removed.size() == most)
        break;
      const std::uint32_t v = candidate.second;
      if(is_locked[v])
        continue;
      const Vertex_rings::Ring ring = fine.rings.ring(v);
      const std::uint32_t d = static_cast<std::uint32_t>(ring.size()), target = removals[v].target();
      edges.clear();
      for(std::uint32_t k = 2; k + 1 < d; ++k)
      {
        const std::uint64_t a = ring[target], b = ring[(target + k) % d];
        edges.push_back((std::min)(a, b) << 32 | (std::max)(a, b));
      }
      if(std::any_of(edges.begin(), edges.end(), [&](std::uint64_t e) { return new_edges.count(e) > 0; }))
        continue;
      new_edges.insert(edges.begin(), edges.end());
      fine.removed.push_back({v, target});
      for(const std::uint32_t w : ring)
        is_locked[w] = 1;
    }
    std::sort(fine.removed.begin(), fine.removed.end(),
              [](const Removed_vertex& a, const Removed_vertex& b) { return a.vertex < b.vertex; });
  }

  static Level without_removed(const Level& fine)
  {
    constexpr std::uint32_t kept = (std::numeric_limits<std::uint32_t>::max)();
    const std::size_t n = fine.vertices.size();
    std::vector<std::uint32_t> target(n, kept); // of the removed vertices, as an index into their rings
    for(const Removed_vertex& r : fine.removed)
      target[r.vertex] = r.target;

    Level coarse;
    std::vector<double> areas = fine.areas;
    for(const Removed_vertex& r : fine.removed)
    {
      const Vertex_rings::Ring ring = fine.rings.ring(r.vertex);
      for(const std::uint32_t w : ring)
        areas[w] += areas[r.vertex] / static_cast<double>(ring.size());
    }
    std::vector<std::uint32_t> number(n, kept);
    for(std::size_t v = 0; v < n; ++v)
      if(target[v] == kept)
      {
        number[v] = static_cast<std::uint32_t>(coarse.vertices.size());
        coarse.vertices.push_back(fine.vertices[v]);
        coarse.areas.push_back(areas[v]);
      }

    coarse.rings.reserve(coarse.vertices.size(), 6 * coarse.vertices.size());
    for(std::uint32_t v = 0; v < n; ++v)
    {
      if(target[v] != kept)
        continue;
      const Vertex_rings::Ring ring = fine.rings.ring(v);
      const std::size_t d = ring.size();
      for(std::size_t j = 0; j < d; ++j)
      {
        const std::uint32_t w = ring[j];
        if(target[w] == kept)
        {
          coarse.rings.push_neighbor(number[w]);
          continue;
        }
        // w gives way to its target t, from which the hole is triangulated: t itself gets the vertices of the hole that
        // are new to it, another vertex gets t unless that is next to w in its ring already.
        const Vertex_rings::Ring hole = fine.rings.ring(w);
        const std::size_t h = hole.size();
        const std::uint32_t t = hole[target[w]];
        if(t == v)
        {
          for(std::size_t k = 2; k + 1 < h; ++k)
            coarse.rings.push_neighbor(number[hole[(target[w] + k) % h]]);
        }
        else if(ring[(j + 1) % d] != t && ring[(j + d - 1) % d] != t)
          coarse.rings.push_neighbor(number[t]);
      }
      coarse.rings.end_ring();
    }
    return coarse;
  }

  std::vector<Level> m_levels;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_HIERARCHY_H
