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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HIERARCHY_MESH_HIERARCHY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HIERARCHY_MESH_HIERARCHY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Vertex_removal.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A set of edges, each a pair of different vertices in either order: a hash table with linear probing. It is only
// queried for membership, so results do not depend on its order.
class Edge_set
{
public:
  // `expected_size` may be exceeded.
  explicit Edge_set(std::size_t expected_size)
  {
    std::size_t size = min_size;
    while(size < 2 * expected_size)
      size *= 2;
    m_table.resize(size, none);
  }

  bool contains(std::uint32_t a, std::uint32_t b) const { return m_table[place_of(key_of(a, b))] != none; }

  void insert(std::uint32_t a, std::uint32_t b)
  {
    if(2 * (m_size + 1) > m_table.size())
      grow();
    const std::uint64_t key = key_of(a, b);
    std::uint64_t& place = m_table[place_of(key)];
    m_size += place == none;
    place = key;
  }

private:
  static constexpr std::uint64_t none = 0;    // no edge joins vertex 0 to itself
  static constexpr std::size_t min_size = 64; // of the table, whose size doubles when it is half full

  static std::uint64_t key_of(std::uint32_t a, std::uint32_t b)
  {
    return static_cast<std::uint64_t>((std::min)(a, b)) << 32 | (std::max)(a, b);
  }

  // The slot of a key, or the slot where it would be inserted.
  std::size_t place_of(std::uint64_t key) const
  {
    const std::size_t mask = m_table.size() - 1;
    // The upper bits of the product depend on all bits of the key.
    std::size_t place = static_cast<std::size_t>(key * 0x9e3779b97f4a7c15u >> 20) & mask;
    while(m_table[place] != none && m_table[place] != key)
      place = (place + 1) & mask;
    return place;
  }

  void grow()
  {
    std::vector<std::uint64_t> old(2 * m_table.size(), none);
    old.swap(m_table);
    for(const std::uint64_t key : old)
      if(key != none)
        m_table[place_of(key)] = key;
  }

  std::vector<std::uint64_t> m_table; // its size is a power of two
  std::size_t m_size = 0;
};

// A sequence of meshes from a given one to a tetrahedron, each coarser than the previous one. Each level is created by
// removing an independent set of vertices: a removed vertex is collapsed into one of its neighbors, all of which are
// kept. So all vertices that a level adds to the next coarser one can be inserted at once, each into a hole whose
// vertices are all present, and errors do not accumulate from one insertion to the next.
//
// Level 0 is the given mesh, whose rings must outlive the hierarchy. Every level numbers its own vertices, in the order
// of the given mesh.
//
// A coarse mesh has lost area: it may have a spike instead of an extremity. Therefore, every vertex stores the area of
// the surface that it represents, and this is distributed over its ring when the vertex is removed. The map of a coarse
// level can then reserve as much area for an extremity as the surface requires.
class Mesh_hierarchy
{
public:
  // A vertex of a level that is missing in the next coarser level, and the vertex of its ring into which it is
  // collapsed.
  struct Removed_vertex
  {
    std::uint32_t vertex;
    std::uint32_t target; // index into the ring of the vertex
  };

  struct Level
  {
    std::vector<std::uint32_t> vertices; // their indices in the given mesh
    std::vector<double> areas;           // of the surface that the vertices represent
    std::vector<Removed_vertex> removed; // empty at the coarsest level that was built

    // The values of this level's vertices, from an array over the vertices of the given mesh.
    std::vector<Vector_3d> gathered(const std::vector<Vector_3d>& all) const
    {
      std::vector<Vector_3d> result(vertices.size());
      for(std::size_t v = 0; v < result.size(); ++v)
        result[v] = all[vertices[v]];
      return result;
    }
  };

  // `areas` are those that the vertices of the mesh represent. If `images` on the sphere are given, with positively
  // oriented faces, the faces stay positively oriented. Fixed vertices are not removed. The coarsest level has about
  // `min_size` vertices, or more if no further vertex can be removed. `control` is called before each level, so that
  // the caller's visitor may throw; a request to stop is ignored.
  Mesh_hierarchy(const Vertex_rings& rings, const std::vector<Vector_3d>& points, std::vector<double> areas,
                 Run_control& control, Execution execution, const std::vector<Vector_3d>& images = {},
                 const std::vector<char>& is_fixed = {}, std::size_t min_size = 4)
    : m_finest_rings(rings)
    , m_execution(execution)
    , m_levels(1)
  {
    Level& finest = m_levels.back();
    finest.vertices.resize(rings.number_of_vertices());
    std::iota(finest.vertices.begin(), finest.vertices.end(), 0u);
    finest.areas = std::move(areas);
    do
      control.go_further(0, 0.);
    while(m_levels.back().vertices.size() > min_size && coarsen(points, images, is_fixed));
  }

  // A copy of the levels from k on. The rings of level k must outlive the copy.
  Mesh_hierarchy from_level(std::size_t k) const
  {
    Mesh_hierarchy result(rings(k), m_execution);
    result.m_levels.assign(m_levels.begin() + static_cast<std::ptrdiff_t>(k), m_levels.end());
    result.m_coarse_rings.assign(m_coarse_rings.begin() + static_cast<std::ptrdiff_t>(k), m_coarse_rings.end());
    return result;
  }

  std::size_t number_of_levels() const { return m_levels.size(); }
  const Level& level(std::size_t k) const { return m_levels[k]; }
  const Vertex_rings& rings(std::size_t k) const { return k == 0 ? m_finest_rings : m_coarse_rings[k - 1]; }

  void drop_coarsest()
  {
    m_levels.pop_back();
    if(!m_coarse_rings.empty())
      m_coarse_rings.pop_back();
  }

private:
  Mesh_hierarchy(const Vertex_rings& rings, const Execution& execution)
    : m_finest_rings(rings)
    , m_execution(execution)
  {}

  // The maximum fraction of the vertices that one level removes.
  static constexpr double max_fraction = 0.25;  // larger steps between levels change the result by 0.3 %
  static constexpr std::size_t block_size = 64; // levels are small: larger blocks leave threads idle

  // Adds a level, if any vertex can be removed.
  bool coarsen(const std::vector<Vector_3d>& points, const std::vector<Vector_3d>& images,
               const std::vector<char>& is_fixed)
  {
    Level& fine = m_levels.back();
    const Vertex_rings& fine_rings = rings(m_levels.size() - 1);
    const std::size_t n = fine.vertices.size();
    const std::vector<Vector_3d> p = fine.gathered(points),
                                 local_images = images.empty() ? images : fine.gathered(images);

    std::vector<Vertex_removal> removals(n);
    std::vector<std::uint32_t> target;
    for(const bool is_exact : {false, true}) // exact only if the quick search finds nothing
    {
      for_each_in_blocks(m_execution, 0, n, block_size, [&](std::size_t v) {
        if(is_fixed.empty() || !is_fixed[fine.vertices[v]])
          removals[v] = Vertex_removal::best(fine_rings, p, static_cast<std::uint32_t>(v), is_exact, local_images);
      });
      target = select(fine, fine_rings, removals);
      if(!fine.removed.empty())
        break;
    }
    if(fine.removed.empty())
      return false;
    Level coarse;
    Vertex_rings coarse_rings = without_removed(fine, fine_rings, target, coarse);
    m_levels.push_back(std::move(coarse));
    m_coarse_rings.push_back(std::move(coarse_rings));
    return true;
  }

  // Selects removals in the order of their costs, unless a neighbor has been selected already or a new edge exists
  // already. Returns the targets of the removed vertices, as indices into their rings, and `kept` for all others.
  static std::vector<std::uint32_t> select(Level& fine, const Vertex_rings& rings,
                                           const std::vector<Vertex_removal>& removals)
  {
    const std::size_t n = removals.size();
    std::vector<std::uint64_t> candidates; // rank of the cost, vertex
    candidates.reserve(n);
    for(std::size_t v = 0; v < n; ++v)
      if(removals[v].is_possible())
        candidates.push_back(static_cast<std::uint64_t>(removals[v].rank) << 32 | v);
    boost::sort::spreadsort::integer_sort(candidates.begin(), candidates.end());

    const std::size_t max_removed =
        (std::min)(n - 4, (std::max)(static_cast<std::size_t>(max_fraction * static_cast<double>(n)), std::size_t(1)));
    std::vector<char> is_locked(n, 0);
    Edge_set new_edges(3 * max_removed); // for holes with six vertices, the mean
    std::vector<std::uint32_t> target(n, kept);
    std::size_t n_removed = 0;
    for(const std::uint64_t candidate : candidates)
    {
      if(n_removed == max_removed)
        break;
      const std::uint32_t v = static_cast<std::uint32_t>(candidate);
      if(is_locked[v])
        continue;
      const Vertex_rings::Ring ring = rings.ring(v);
      const std::uint32_t d = static_cast<std::uint32_t>(ring.size()), t = removals[v].target;
      bool has_new_edge = false;
      for(std::uint32_t k = 2; k + 1 < d; ++k)
        has_new_edge = has_new_edge || new_edges.contains(ring[t], ring.around(t + k));
      if(has_new_edge)
        continue;
      for(std::uint32_t k = 2; k + 1 < d; ++k)
        new_edges.insert(ring[t], ring.around(t + k));
      target[v] = t;
      ++n_removed;
      for(const std::uint32_t w : ring)
        is_locked[w] = 1;
    }
    fine.removed.reserve(n_removed);
    for(std::uint32_t v = 0; v < n; ++v)
      if(target[v] != kept)
        fine.removed.push_back({v, target[v]});
    return target;
  }

  // Creates the next level, and returns its rings.
  Vertex_rings without_removed(const Level& fine, const Vertex_rings& rings, const std::vector<std::uint32_t>& target,
                               Level& coarse) const
  {
    const std::size_t n = fine.vertices.size();
    std::vector<double> areas = fine.areas;
    for(const Removed_vertex& r : fine.removed)
    {
      const Vertex_rings::Ring ring = rings.ring(r.vertex);
      for(const std::uint32_t w : ring)
        areas[w] += areas[r.vertex] / static_cast<double>(ring.size());
    }
    std::vector<std::uint32_t> number(n, kept), sources; // indices of the kept vertices in the next level, and back
    const std::size_t n_coarse = n - fine.removed.size();
    sources.reserve(n_coarse);
    coarse.vertices.reserve(n_coarse);
    coarse.areas.reserve(n_coarse);
    for(std::size_t v = 0; v < n; ++v)
      if(target[v] == kept)
      {
        number[v] = static_cast<std::uint32_t>(sources.size());
        sources.push_back(static_cast<std::uint32_t>(v));
        coarse.vertices.push_back(fine.vertices[v]);
        coarse.areas.push_back(areas[v]);
      }

    std::vector<std::uint32_t> offsets(n_coarse + 1, 0);
    for_each_in_blocks(m_execution, 0, n_coarse, block_size, [&](std::size_t v) {
      for_each_kept_neighbor(rings, target, sources[v], [&](std::uint32_t) { ++offsets[v + 1]; });
    });
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    Vertex_rings result;
    result.assign(std::move(offsets));
    for_each_in_blocks(m_execution, 0, n_coarse, block_size, [&](std::size_t v) {
      std::uint32_t* out = result.ring_to_fill(v);
      for_each_kept_neighbor(rings, target, sources[v], [&](std::uint32_t w) { *out++ = number[w]; });
    });
    return result;
  }

  // Calls f(w) for all neighbors w of vertex v after the removal of all vertices with a target, in order.
  template <class Function>
  static void for_each_kept_neighbor(const Vertex_rings& rings, const std::vector<std::uint32_t>& target,
                                     std::uint32_t v, const Function& f)
  {
    const Vertex_rings::Ring ring = rings.ring(v);
    const std::size_t d = ring.size();
    for(std::size_t j = 0; j < d; ++j)
    {
      const std::uint32_t w = ring[j];
      if(target[w] == kept)
      {
        f(w);
        continue;
      }
      // w is collapsed into its target t, from which the hole is triangulated: t becomes adjacent to the other vertices
      // of the hole, and each other vertex becomes adjacent to t unless t is next to w in its ring already.
      const Vertex_rings::Ring hole = rings.ring(w);
      const std::size_t h = hole.size();
      const std::uint32_t t = hole[target[w]];
      if(t == v)
      {
        for(std::size_t k = 2; k + 1 < h; ++k)
          f(hole.around(target[w] + k));
      }
      else if(ring.around(j + 1) != t && ring.around(j + d - 1) != t)
        f(t);
    }
  }

  static constexpr std::uint32_t kept = (std::numeric_limits<std::uint32_t>::max)();

  const Vertex_rings& m_finest_rings;
  Execution m_execution;
  std::vector<Level> m_levels;
  std::vector<Vertex_rings> m_coarse_rings; // of the levels from 1 on
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HIERARCHY_MESH_HIERARCHY_H
