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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_BLOCK_COORDINATE_DESCENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_BLOCK_COORDINATE_DESCENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Measured_faces.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The vertices of a mesh grouped by the colors of a greedy coloring: no two vertices of a set are neighbors, so all
// vertices of a set may move at once. Within a set, the vertices are in increasing order.
struct Independent_sets
{
  Independent_sets() = default;
  explicit Independent_sets(const Vertex_rings& rings)
    : vertices(rings.number_of_vertices())
  {
    const std::size_t n = vertices.size();
    std::vector<std::size_t> colors(n), last_neighbor; // for each color: the last vertex that could not use it
    for(std::size_t v = 0; v < n; ++v)
    {
      for(const std::uint32_t w : rings.ring(v))
        if(w < v)
          last_neighbor[colors[w]] = v;
      colors[v] = static_cast<std::size_t>(
          std::find_if(last_neighbor.begin(), last_neighbor.end(), [&](std::size_t u) { return u != v; }) -
          last_neighbor.begin());
      if(colors[v] == last_neighbor.size())
        last_neighbor.push_back(v);
    }
    first.resize(last_neighbor.size() + 1);
    for(const std::size_t color : colors)
      ++first[color + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::size_t> next = first;
    for(std::size_t v = 0; v < n; ++v)
      vertices[next[colors[v]]++] = static_cast<std::uint32_t>(v);
  }

  // Set k is vertices[first[k]], ..., vertices[first[k + 1] - 1].
  std::vector<std::uint32_t> vertices;
  std::vector<std::size_t> first;
};

// Block coordinate descent on the positions of the vertices of a mesh on the unit sphere: each sweep moves every vertex
// once, one independent set after the other, and the vertices of a set in parallel. Every face that is positively
// oriented before a sweep is positively oriented after it.
//
// The minimized energy depends on the space in which the vertices move: the round sphere, see Round_sphere, or that of
// another surface, see Target_sphere. The space moves the vertex of a star, or those of several stars at once in lanes,
// measures the image of a face, and evaluates its energy.
template <class Space, class Step>
class Block_coordinate_descent
{
public:
  Block_coordinate_descent(const Space& space, const Step& step, Execution execution)
    : m_space(space)
    , m_step(step)
    , m_execution(execution)
    , m_scratch(execution, typename Space::Scratch())
  {}

  Space& space() { return m_space; }
  void set_step(const Step& step) { m_step = step; }

  // Sets the mesh, whose rings must be valid until the next call; measurements and the focus are then invalid. `points`
  // are those of the surface, scaled to the area 4 pi. If `densities` are given, one for each vertex, a face keeps its
  // shape on the surface, but its area is multiplied by the mean density of its vertices.
  void assign(const Vertex_rings& rings, const Independent_sets& sets, const std::vector<Vector_3d>& points,
              const std::vector<double>& densities, const Rest_limits& limits)
  {
    m_rings = &rings;
    m_stars.assign(sets.vertices, sets.first, [&](std::uint32_t v) { return rings.degree(v); });
    set_stars(points, densities, limits);
    m_places.resize(rings.number_of_vertices());
    for(std::size_t place = m_stars.number_of_places(); place-- > 0;) // a vertex has the first of its slots
      m_places[m_stars.vertex(place)] = static_cast<std::uint32_t>(place);
    m_faces.assign(m_stars, m_places, rings.number_of_faces(), m_execution);
  }

  std::size_t number_of_vertices() const { return m_rings->number_of_vertices(); }

  // Reserves memory for a mesh with this number of vertices, so that it and the smaller meshes before it use the same
  // memory, except for irregular packets of stars. The memory is not touched before it is used.
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

  // The same, and then, if few faces are much worse than the others, sweeps over the vertices around them several
  // times. One thread finds these faces, while the others start the sweep. `largest_energy` is that of the last
  // measurement.
  void sweep_with_focus(std::vector<Vector_3d>& positions, double radius, const Face_objective& objective,
                        double largest_energy)
  {
    const std::size_t max_focus =
        static_cast<std::size_t>(focus_fraction * static_cast<double>(m_rings->number_of_corners())) / min_focus_sweeps;
    std::size_t focus = 0; // the number of faces of its stars
    // Another thread, whose allocator may have a heap of its own, should hardly allocate any memory for them.
    m_focus.reserve(max_focus / 6);
    m_selected.reserve(max_focus / 6);
    m_is_selected.reserve(m_rings->number_of_vertices());
    run_both(
        m_execution, [&] { sweep(positions, radius, objective); },
        [&] { focus = focus_on_faces_above(focus_energy * largest_energy, max_focus); });
    if(focus > 0 && focus <= max_focus)
    {
      const std::size_t n_sweeps = (std::min)(min_focus_sweeps * max_focus / focus, max_focus_sweeps);
      for(std::size_t k = 0; k < n_sweeps; ++k)
        sweep_focus(positions, radius, objective);
    }
  }

  // Selects the vertices of the faces whose energy was above `bound` in the last measurement, and their neighbors,
  // unless their stars have more than `max` faces in total, the cost of a sweep over them. Returns this number, or a
  // number above `max`.
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
    m_faces.for_each_above(m_space.energy(), bound, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
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
    for_each_in_blocks(m_execution, 0, m_focus.number_of_packets(), packets_per_block, [&](std::size_t packet) {
      m_focus.fill_with_copies(packet, [&](std::uint32_t v) { return m_stars.star(m_places[v]); });
    });
    return n_faces;
  }

  void sweep_focus(std::vector<Vector_3d>& positions, double radius, const Face_objective& objective)
  {
    move_all(m_focus, positions, radius, objective, m_step);
  }

  // Measures all faces on the sphere of radius `radius`, by the areas of the objective or by flat areas.
  Energy_summary measure(const std::vector<Vector_3d>& positions, double radius, const Face_objective& objective,
                         bool are_flat = false)
  {
    return m_faces.measure(m_space, m_stars, positions, radius, objective, m_execution, are_flat);
  }

  // The same for another radius or objective, without reading the positions.
  Energy_summary summary(double radius, const Face_objective& objective)
  {
    return m_faces.summary(m_space, m_stars, radius, objective, m_execution);
  }

  // The Newton step for the logarithm of the radius, which decreases the sum over all faces; it changes the radius by a
  // factor of at most 1.35. It is 0 if all terms cancel up to rounding error, as for a scale-invariant energy.
  double radius_step(double radius, const Face_objective& objective) const
  {
    constexpr double max_step = 0.3, rounding = 1e-14;
    const auto [first, second, size] = radius_derivatives(radius, objective);
    if(!(std::abs(first) > rounding * size))
      return 0.;
    return std::clamp(-first / std::abs(second), -max_step, max_step);
  }

  std::array<double, 3> radius_derivatives(double radius, const Face_objective& objective) const
  {
    return m_faces.radius_derivatives(m_space, m_stars, radius, objective, m_execution);
  }

  // The stars of the mesh, and its faces as of the last measurement.
  const Star_packets& stars() const { return m_stars; }
  const Measured_faces& measured_faces() const { return m_faces; }

  // Whether all faces are positively oriented at these positions, with the safety margin of sweeps.
  bool are_safely_positive(const std::vector<Vector_3d>& positions) const
  {
    constexpr std::size_t n_parts = 64; // more than the number of threads
    std::atomic<bool> result(true);
    m_faces.template for_each_in_lanes<Space>(
        m_stars, positions, n_parts, m_execution, [&](std::size_t, const auto& faces, std::size_t) {
          const auto& p = faces.corners;
          const auto to_1 = p[1] - p[0], to_2 = p[2] - p[0];
          if(any(!is_safely_positive(dot(p[0], cross(to_1, to_2)), squared_length(to_1) + squared_length(to_2))))
            result = false;
        });
    return result;
  }

  // The invariants of all faces, for a radius policy.
  Face_range_3 faces(const std::vector<Vector_3d>& positions, double radius, const Face_objective& objective)
  {
    const std::vector<Face_invariants_3>& all =
        m_faces.all_invariants(m_space, m_stars, positions, radius, objective, m_execution);
    return {all.data(), all.data() + all.size(), m_execution};
  }

private:
  // The vertices around faces above a fraction of the largest energy are swept several times more, because they
  // converge slowest and determine the largest distortion. The sweeps take at most a fraction of the time of a sweep
  // over all vertices, and are omitted if they would be too few.
  static constexpr double focus_energy = 0.8, focus_fraction = 0.65;
  static constexpr std::size_t min_focus_sweeps = 2, max_focus_sweeps = 500;

  static constexpr std::size_t packets_per_block = 4; // of parallel work: about two microseconds

  void set_stars(const std::vector<Vector_3d>& points, const std::vector<double>& densities, const Rest_limits& limits)
  {
    const auto shape_of = [&](auto number_type, const std::uint32_t* v, const std::uint32_t* a,
                              const std::uint32_t* b) {
      using FT = typename decltype(number_type)::FT;
      const auto points_of = [&](const std::uint32_t* vertices) {
        return points_in_lanes<FT>(vertices, points.data());
      };
      const auto density_of = [&](const std::uint32_t* vertices) {
        return Lanes<FT>::generate([&](std::size_t lane) { return densities[vertices[lane]]; });
      };
      Basic_rest_triangle<FT> result =
          Basic_rest_triangle<FT>::from_points(points_of(v), points_of(a), points_of(b), limits);
      if(!densities.empty())
        result.scale_area((density_of(v) + density_of(a) + density_of(b)) / 3.);
      return result;
    };
    const auto ring_of = [&](std::uint32_t v) { return m_rings->ring(v); };
    for_each_block(m_execution, 0, m_stars.number_of_packets(), packets_per_block,
                   [&](std::size_t begin, std::size_t end) {
                     run_in_lanes([&](auto number_type) {
                       for(std::size_t packet = begin; packet < end; ++packet)
                         m_stars.template fill<typename decltype(number_type)::FT>(packet, ring_of, shape_of);
                     });
                   });
  }

  void move_all(const Star_packets& stars, std::vector<Vector_3d>& positions, double radius,
                const Face_objective& objective, const Step& step)
  {
    const auto move_block = [&](std::size_t begin, std::size_t end) {
      auto& scratch = m_scratch.local();
      const auto move_stars = [&](auto number_type, const Star_packets::Packet& packet, std::size_t first) {
        m_space.move(stars.view<typename decltype(number_type)::FT>(packet, first), stars.vertices(packet) + first,
                     packet.number_of_stars - first, positions.data(), radius, objective, step, scratch);
      };
      const auto move_packets = [&](auto number_type) {
        constexpr std::size_t width = Lanes<typename decltype(number_type)::FT>::width;
        for(std::size_t k = begin; k < end; ++k)
        {
          const Star_packets::Packet& packet = stars.packet(k);
          if(packet.stride == 1)
            move_stars(Number_type<double>(), packet, 0);
          else
            for(std::size_t first = 0; first < packet.number_of_stars; first += width)
              move_stars(number_type, packet, first);
        }
      };
      if constexpr(Space::is_lanewise)
        run_in_lanes(move_packets);
      else
        run_in_lanes(
            [&](auto) { move_packets(Number_type<double>()); }); // one star at a time, by the same instructions
    };
    for(std::size_t set = 0; set < stars.number_of_sets(); ++set)
      for_each_block(m_execution, stars.first_packet(set), stars.first_packet(set + 1), packets_per_block, move_block);
  }

  Space m_space;
  Step m_step;
  Execution m_execution;
  const Vertex_rings* m_rings = nullptr;
  Star_packets m_stars, m_focus;
  std::vector<std::uint32_t> m_places; // of the vertices in m_stars
  std::vector<std::uint32_t> m_selected;
  std::vector<char> m_is_selected; // 0 outside focus_on_faces_above()
  Measured_faces m_faces;
  Per_thread<typename Space::Scratch> m_scratch;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_BLOCK_COORDINATE_DESCENT_H
