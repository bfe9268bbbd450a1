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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_BLOCK_COORDINATE_DESCENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_BLOCK_COORDINATE_DESCENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/internal/levels/Independent_sets.h>
#include <CGAL/Spherical_parameterization/internal/levels/Measured_faces.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Block coordinate descent on the positions of the vertices of a mesh on the unit sphere: each sweep moves every
// vertex once, one independent set after the other, the vertices of a set in parallel. Every face that is positively
// oriented before a sweep is so after it.
//
// Vertices are moved several at a time if the step can be made in several lanes, else one by one.
template <class Energy, class Step>
class Block_coordinate_descent
{
public:
  // for meshes that are yet to be assigned
  Block_coordinate_descent(const Face_energy<Energy>& energy, const Step& step, Execution execution)
    : m_energy(energy)
    , m_step(step)
    , m_execution(execution)
    , m_scratch(execution, Scratch(energy))
  {}

  // Changes how the vertices move.
  void set_step(const Step& step) { m_step = step; }

  // Takes over a mesh, whose rings have to last until the next one; measurements and the focus are void then. `points`
  // are those of the surface, scaled such that its area is 4 pi. If `densities` are given, one for each vertex, a face
  // gets the shape that it has on the surface but as many times its area as the mean of the densities of its vertices. If
  // vertices are marked as those of slivers, the faces around them make a group of their own.
  void assign(const Vertex_rings& rings, const Independent_sets& sets, const std::vector<Vector_3d>& points,
              const std::vector<double>& densities, const Rest_limits& limits, const std::vector<char>& slivers = {})
  {
    m_rings = &rings;
    const auto rest_of_face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      Rest_triangle rest = Rest_triangle::from_points(points[a], points[b], points[c], limits);
      if(!densities.empty())
        rest.scale_area((densities[a] + densities[b] + densities[c]) / 3.);
      if(!slivers.empty() && (slivers[a] || slivers[b] || slivers[c]))
        rest.inverse_doubled_area = -rest.inverse_doubled_area;
      return rest;
    };
    m_stars.assign(sets.vertices(), sets.first(), [&](std::uint32_t v) { return rings.degree(v); });
    fill(m_stars, [&](std::uint32_t v) { return Ring_star<decltype(rest_of_face)>{v, rings.ring(v), rest_of_face}; });
    m_faces.assign(m_stars, rings.number_of_faces(), m_execution);
    m_places.resize(rings.number_of_vertices());
    for(std::size_t place = m_stars.number_of_places(); place-- > 0;) // the first place of each is its own
      m_places[m_stars.vertex(place)] = static_cast<std::uint32_t>(place);
  }

  // Makes room for a mesh with so many vertices, so that it and the smaller ones that come before it use the same
  // memory, but for stars that do not fit together well. Nothing of it is touched before it is needed.
  void reserve(std::size_t n_vertices)
  {
    m_stars.reserve(n_vertices);
    m_faces.reserve(2 * n_vertices);
    m_places.reserve(n_vertices);
  }

  // Moves every vertex once. The energies are those on the sphere of radius `radius`.
  void sweep(std::vector<Vector_3d>& positions, double radius, const Face_objective& objective)
  {
    move_all(m_stars, positions, radius, objective, m_step);
  }

  // Makes room for a focus on stars with so many faces, so that another thread, whose allocator may have a heap of its
  // own, hardly allocates when it looks for it.
  void reserve_focus(std::size_t n_faces)
  {
    m_focus.reserve(n_faces / 6);
    m_selected.reserve(n_faces / 6);
    m_is_selected.reserve(m_rings->number_of_vertices());
  }

  // Selects the vertices of the faces whose energy was above `bound` when they were last measured, and their neighbours,
  // unless their stars have more than `max` faces in all, which is what a sweep over them takes. Returns this number,
  // or some number above `max`.
  std::size_t focus_on_faces_above(double bound, std::size_t max)
  {
    m_is_selected.resize(m_rings->number_of_vertices(), 0);
    std::vector<std::uint32_t>& selected = m_selected;
    selected.clear();
    std::size_t n_faces = 0;
    const auto select_vertex = [&](std::uint32_t v) {
      if(!m_is_selected[v] && n_faces <= max)
      {
        selected.push_back(v);
        m_is_selected[v] = 1;
        n_faces += m_rings->degree(v);
      }
      return n_faces <= max;
    };
    m_faces.for_each_above(m_energy, bound, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      return select_vertex(a) && select_vertex(b) && select_vertex(c);
    });
    const std::size_t n_corners = selected.size();
    for(std::size_t k = 0; k < n_corners && n_faces <= max; ++k)
      for(const std::uint32_t w : m_rings->ring(selected[k]))
        select_vertex(w);
    for(const std::uint32_t v : selected)
      m_is_selected[v] = 0;
    if(n_faces > max)
      return n_faces;

    for(std::uint32_t& v : selected)
      v = m_places[v];
    boost::sort::spreadsort::integer_sort(selected.begin(), selected.end());
    std::vector<std::size_t> first_of_set;
    for(std::size_t set = 0; set <= m_stars.number_of_sets(); ++set)
      first_of_set.push_back(static_cast<std::size_t>(
          std::lower_bound(selected.begin(), selected.end(), m_stars.first_place_of_set(set)) - selected.begin()));
    for(std::uint32_t& place : selected)
      place = m_stars.vertex(place);
    m_focus.assign(selected, first_of_set, [&](std::uint32_t v) { return m_rings->degree(v); });
    fill(m_focus, [&](std::uint32_t v) { return m_stars.star(m_places[v]); });
    return n_faces;
  }

  // Moves every selected vertex once, as sweep() does.
  void sweep_focus(std::vector<Vector_3d>& positions, double radius, const Face_objective& objective)
  {
    move_all(m_focus, positions, radius, objective, Step::on_few_vertices());
  }

  // Measures all faces on the sphere of radius `radius`; faces() then returns their invariants.
  Mesh_summary measure(const std::vector<Vector_3d>& positions, double radius, const Face_objective& objective)
  {
    return m_faces.template measure<Step>(m_stars, m_energy, positions, radius, objective, m_execution);
  }

  // The same for another radius or objective, without a look at the positions.
  Mesh_summary summary(double radius, const Face_objective& objective)
  {
    return m_faces.template summary<Step>(m_energy, radius, objective, m_execution);
  }

  std::array<double, 3> radius_derivatives(double radius, const Face_objective& objective,
                                           double Face_invariants_3::*area_ratio) const
  {
    return m_faces.template radius_derivatives<Step>(m_energy, radius, objective, area_ratio, m_execution);
  }

  bool has_slivers() const { return m_faces.has_slivers(); }

  Face_range_3 faces() const { return {m_faces.begin(), m_faces.end(), m_execution}; }

private:
  template <class FT>
  using Star = Star_energy<Energy, Step::template Image_measure, FT>;

  static constexpr std::size_t packets_per_block = 4; // of parallel work: some two microseconds

  // A star as the rings give it, for Star_packets.
  template <class RestOfFace>
  struct Ring_star
  {
    std::uint32_t vertex;
    Vertex_rings::Ring ring;
    const RestOfFace& rest_of_face;

    std::size_t degree() const { return ring.size(); }
    std::uint32_t neighbor(std::size_t j) const { return ring[j]; }
    Rest_triangle rest(std::size_t j) const { return rest_of_face(vertex, ring[j], ring.around(j + 1)); }
  };

  template <class StarOf>
  void fill(Star_packets& stars, const StarOf& star_of) const
  {
    for_each_block(m_execution, 0, stars.number_of_packets(), packets_per_block,
                   [&](std::size_t begin, std::size_t end) {
                     for(std::size_t packet = begin; packet < end; ++packet)
                       stars.fill(packet, star_of);
                   });
  }

  // What a thread needs to move stars of any number of lanes.
  struct Scratch
  {
    explicit Scratch(const Face_energy<Energy>& energy)
      : in_one_lane(energy)
      , in_two_lanes(energy)
      , in_four_lanes(energy)
    {}

    template <class FT>
    Star<FT>& star()
    {
      if constexpr(Lanes<FT>::width == 1)
        return in_one_lane;
      else if constexpr(Lanes<FT>::width == 2)
        return in_two_lanes;
      else
        return in_four_lanes;
    }

    Star<double> in_one_lane;
    Star<Two_lanes> in_two_lanes;
    Star<Four_lanes> in_four_lanes;
  };

  void move_all(const Star_packets& stars, std::vector<Vector_3d>& positions, double radius,
                const Face_objective& objective, const Step& step)
  {
    for(std::size_t set = 0; set < stars.number_of_sets(); ++set)
      for_each_block(m_execution, stars.first_packet(set), stars.first_packet(set + 1), packets_per_block,
                     [&](std::size_t begin, std::size_t end) {
                       Scratch& scratch = m_scratch.local();
                       const auto move_packets = [&](auto number_type) {
                         using FT = typename decltype(number_type)::FT;
                         for(std::size_t packet = begin; packet < end; ++packet)
                           move_packet<FT>(stars, stars.packet(packet), positions.data(), radius, objective, step,
                                           scratch);
                       };
                       if constexpr(Step::is_lanewise)
                         run_in_lanes(move_packets);
                       else
                         move_packets(Number_type<double>());
                     });
  }

  template <class FT>
  void move_packet(const Star_packets& stars, const Star_packets::Packet& packet, Vector_3d* positions, double radius,
                   const Face_objective& objective, const Step& vertex_step, Scratch& scratch) const
  {
    if(packet.stride == 1)
      move<double>(stars, packet, 0, positions, radius, objective, vertex_step, scratch);
    else
      for(std::size_t lane = 0; lane < packet.number_of_stars; lane += Lanes<FT>::width)
        move<FT>(stars, packet, lane, positions, radius, objective, vertex_step, scratch);
  }

  template <class FT>
  void move(const Star_packets& stars, const Star_packets::Packet& packet, std::size_t first, Vector_3d* positions,
            double radius, const Face_objective& objective, const Step& vertex_step, Scratch& scratch) const
  {
    Star<FT>& star = scratch.template star<FT>();
    star.set_objective(radius * radius, objective);
    star.load(stars.view<FT>(packet, first), positions);
    std::array<FT, 2> step = {FT(0.), FT(0.)};
    const auto is_moved = vertex_step(star, step);
    if(!any(is_moved))
      return;
    const Vector_3<FT> point = star.point_at(step[0], step[1]);
    for(std::size_t k = 0; k < Lanes<FT>::width && first + k < packet.number_of_stars; ++k)
      if(lane(is_moved, k))
        positions[stars.vertex(packet.first_place + first + k)] = {lane(point[0], k), lane(point[1], k),
                                                                   lane(point[2], k)};
  }

  Face_energy<Energy> m_energy;
  Step m_step;
  Execution m_execution;
  const Vertex_rings* m_rings = nullptr;
  Star_packets m_stars, m_focus;
  std::vector<std::uint32_t> m_places; // of the vertices in m_stars
  std::vector<std::uint32_t> m_selected;
  std::vector<char> m_is_selected; // 0 outside of focus_on_faces_above()
  Measured_faces m_faces;
  Per_thread<Scratch> m_scratch;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_BLOCK_COORDINATE_DESCENT_H
