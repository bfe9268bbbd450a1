// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BLOCK_COORDINATE_DESCENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BLOCK_COORDINATE_DESCENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_invariants_3.h>
#include <CGAL/Spherical_parameterization/internal/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/Image_area.h>
#include <CGAL/Spherical_parameterization/internal/Independent_sets.h>
#include <CGAL/Spherical_parameterization/internal/Per_thread.h>
#include <CGAL/Spherical_parameterization/internal/Rest_limits.h>
#include <CGAL/Spherical_parameterization/internal/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/for_each_block.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Block coordinate descent on the positions of the vertices of one mesh on the unit sphere: each sweep moves every
// vertex once, one independent set after the other, the vertices of a set in parallel. Every face that is positively
// oriented before a sweep is so after it.
//
// The stars are laid out in the order in which a sweep visits them, so that it reads them front to back.
template <class Energy, class VertexUpdate, class ConcurrencyTag, class Barrier = Determinant_barrier_3>
class Block_coordinate_descent
{
public:
  // `points` are those of the surface, scaled such that its area is 4 pi. If `densities` are given, one for each
  // vertex, a face gets the shape that it has on the surface but as many times its area as the mean of the densities of
  // its vertices.
  Block_coordinate_descent(const Vertex_rings& rings, const std::vector<Vector_3d>& points,
                           const std::vector<double>& densities, const Energy& energy, const VertexUpdate& update,
                           const Rest_limits& limits = Rest_limits())
    : m_energy(energy)
    , m_update(update)
    , m_sets(rings)
    , m_stars(Star_energy<Energy, Barrier>(energy))
  {
    const std::size_t n = rings.number_of_vertices();
    const std::vector<std::uint32_t>& order = m_sets.vertices();
    m_rings.reserve(n, rings.number_of_corners());
    m_first_face.reserve(n);
    std::uint32_t n_faces = 0;
    for(std::size_t slot = 0; slot < n; ++slot)
    {
      const std::uint32_t v = order[slot];
      const Vertex_rings::Ring ring = rings.ring(v);
      m_first_face.push_back(n_faces);
      for(const std::uint32_t w : ring)
        m_rings.push_neighbor(w);
      m_rings.end_ring();
      Vertex_rings::for_each_face_of_smallest(v, ring, [&](std::size_t, std::uint32_t, std::uint32_t) { ++n_faces; });
    }
    m_faces.resize(n_faces);
    m_rest.resize(rings.number_of_corners());
    for_each_block<ConcurrencyTag>(0, n, block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t slot = begin; slot < end; ++slot)
      {
        const std::uint32_t v = order[slot];
        const Vertex_rings::Ring ring = m_rings.ring(slot);
        Rest_triangle* rest = m_rest.data() + m_rings.offset(slot);
        for(std::size_t j = 0; j < ring.size(); ++j)
        {
          const std::uint32_t p = ring[j], q = ring[j + 1 < ring.size() ? j + 1 : 0];
          rest[j] = Rest_triangle::from_points(points[v], points[p], points[q], limits);
          if(!densities.empty())
            rest[j].scale_area((densities[v] + densities[p] + densities[q]) / 3.);
        }
      }
    });
  }

  // Moves every vertex once. The energy is that on the sphere of radius `radius`; `sharpness` is the s of exp(s E), or
  // 0.
  void sweep(std::vector<Vector_3d>& positions, double radius, double sharpness)
  {
    for(std::size_t set = 0; set < m_sets.number_of_sets(); ++set)
      move_all(
          m_sets.first(set), m_sets.first(set + 1), [](std::size_t slot) { return slot; }, positions, radius,
          sharpness);
  }

  // Selects the vertices around the faces whose energy was above `bound` when they were last measured, some rings wide.
  // Returns their number.
  std::size_t focus_on_faces_above(double bound)
  {
    const std::size_t n = m_rings.number_of_vertices();
    std::vector<char> is_selected(n, 0);
    std::vector<std::size_t> front, next_front; // slots
    for(std::size_t slot = 0; slot < n; ++slot)
    {
      const std::uint32_t v = m_sets.vertices()[slot];
      const Face_invariants_3* face = m_faces.data() + m_first_face[slot];
      Vertex_rings::for_each_face_of_smallest(v, m_rings.ring(slot),
                                              [&](std::size_t, std::uint32_t p, std::uint32_t q) {
                                                if(m_energy(face->i, face->d) > bound)
                                                  is_selected[v] = is_selected[p] = is_selected[q] = 1;
                                                ++face;
                                              });
    }
    for(std::size_t slot = 0; slot < n; ++slot)
      if(is_selected[m_sets.vertices()[slot]])
        front.push_back(slot);
    for(int k = 0; k < rings_of_focus; ++k, front.swap(next_front))
    {
      next_front.clear();
      for(const std::size_t slot : front)
        for(const std::uint32_t w : m_rings.ring(slot))
          if(!is_selected[w])
          {
            is_selected[w] = 1;
            next_front.push_back(m_sets.slot(w));
          }
    }
    m_focus.clear();
    m_first_in_focus.assign(1, 0);
    for(std::size_t set = 0; set < m_sets.number_of_sets(); ++set)
    {
      for(std::size_t slot = m_sets.first(set); slot < m_sets.first(set + 1); ++slot)
        if(is_selected[m_sets.vertices()[slot]])
          m_focus.push_back(static_cast<std::uint32_t>(slot));
      m_first_in_focus.push_back(m_focus.size());
    }
    return m_focus.size();
  }

  // Moves every selected vertex once, as sweep() does.
  void sweep_focus(std::vector<Vector_3d>& positions, double radius, double sharpness)
  {
    for(std::size_t set = 0; set < m_sets.number_of_sets(); ++set)
      move_all(
          m_first_in_focus[set], m_first_in_focus[set + 1], [&](std::size_t k) { return m_focus[k]; }, positions,
          radius, sharpness);
  }

  // Measures all faces on the sphere of radius `radius`; faces() then returns their invariants.
  Energy_summary measure(const std::vector<Vector_3d>& positions, double radius, double sharpness)
  {
    const std::size_t n = m_rings.number_of_vertices();
    const double scale = radius * radius;
    m_partial.assign((n + block_size - 1) / block_size, Energy_summary(sharpness));
    for_each_block<ConcurrencyTag>(0, n, block_size, [&](std::size_t begin, std::size_t end) {
      Energy_summary& summary = m_partial[begin / block_size];
      for(std::size_t slot = begin; slot < end; ++slot)
      {
        const std::uint32_t v = m_sets.vertices()[slot];
        const Rest_triangle* rest = m_rest.data() + m_rings.offset(slot);
        Face_invariants_3* face = m_faces.data() + m_first_face[slot];
        Vertex_rings::for_each_face_of_smallest(
            v, m_rings.ring(slot), [&](std::size_t j, std::uint32_t p, std::uint32_t q) {
              *face = invariants(positions[v], positions[p], positions[q], rest[j], scale);
              summary.add(m_energy(face->i, face->d));
              ++face;
            });
      }
    });
    Energy_summary total(sharpness);
    for(const Energy_summary& part : m_partial)
      total.add(part);
    return total;
  }

  const std::vector<Face_invariants_3>& faces() const { return m_faces; }

private:
  // Moves the vertices of the slots slot_of(begin), ..., slot_of(end - 1), which belong to one independent set.
  template <class SlotOf>
  void move_all(std::size_t begin, std::size_t end, const SlotOf& slot_of, std::vector<Vector_3d>& positions,
                double radius, double sharpness)
  {
    for_each_block<ConcurrencyTag>(begin, end, block_size, [&](std::size_t first, std::size_t last) {
      Star_energy<Energy, Barrier>& star = m_stars.local();
      star.set_objective(radius * radius, sharpness);
      for(std::size_t k = first; k < last; ++k)
      {
        const std::size_t slot = slot_of(k);
        Vector_3d& position = positions[m_sets.vertices()[slot]];
        star.load(position, m_rings.ring(slot), positions.data(), m_rest.data() + m_rings.offset(slot));
        std::array<double, 2> step;
        if(m_update(star, step))
          position = star.point_at(step[0], step[1]);
      }
    });
  }

  // stars per block of parallel work: some hundred microseconds
  static constexpr std::size_t block_size = 256;
  static constexpr int rings_of_focus = 4;

  static Face_invariants_3 invariants(const Vector_3d& u, const Vector_3d& p, const Vector_3d& q,
                                      const Rest_triangle& rest, double scale)
  {
    const Vector_3d to_p = p - u, to_q = q - u;
    const Vector_3d n = cross(to_p, to_q);
    const double i = rest.opposite_0 * squared_length(q - p) + rest.opposite_1 * squared_length(to_q) +
                     rest.opposite_2 * squared_length(to_p);
    const double to_d = scale * rest.inverse_area;
    return {1. / rest.inverse_area, scale * i, to_d * Image_area<Barrier>::value(dot(u, n), n), to_d * length(n)};
  }

  Energy m_energy;
  VertexUpdate m_update;
  Independent_sets m_sets;
  Vertex_rings m_rings;                    // the ring of the vertex that is m_sets.vertices()[slot] is ring(slot)
  std::vector<Rest_triangle> m_rest;       // of the corners of m_rings
  std::vector<std::uint32_t> m_first_face; // of the faces whose smallest vertex is that of a slot
  std::vector<Face_invariants_3> m_faces;
  std::vector<Energy_summary> m_partial;
  std::vector<std::uint32_t> m_focus; // slots
  std::vector<std::size_t> m_first_in_focus;
  Per_thread<ConcurrencyTag, Star_energy<Energy, Barrier>> m_stars;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BLOCK_COORDINATE_DESCENT_H
