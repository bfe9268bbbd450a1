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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_STAR_PACKETS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_STAR_PACKETS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/Large_array.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Eight_lanes.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The number of stars or faces that are stored side by side, a multiple of all numbers of lanes.
constexpr std::size_t packet_width = 8;
static_assert(packet_width % Lanes<Two_lanes>::width == 0 && packet_width % Lanes<Four_lanes>::width == 0 &&
                  packet_width % Lanes<Eight_lanes>::width == 0,
              "A packet is worked on lane by lane without a rest.");

// The index of entry k of the rest shape of a corner: those of packet_width corners are adjacent.
inline std::size_t rest_index(std::size_t corner, std::size_t k)
{
  return 4 * (corner - corner % packet_width) + packet_width * k + corner % packet_width;
}

// The positions of consecutive vertices of an array.
template <class FT>
Vector_3<FT> points_in_lanes(const std::uint32_t* vertices, const Vector_3d* positions)
{
  const auto coordinate = [&](std::size_t i) {
    return Lanes<FT>::generate([&](std::size_t lane) { return positions[vertices[lane]][i]; });
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

// A view of one star, or of several stars lane by lane: the indices of the vertices and their neighbors, and the rest
// shapes of the faces. Corner j of lane k is that of the face (vertex, neighbor j, neighbor j + 1) and has the index
// first + j * stride + k in the arrays of the neighbors and, by rest_index(), of the rest shapes. A star with fewer
// faces than others of its packet, as indicated by its degree, is padded with its first neighbor, and with 0 for the
// rest shapes.
template <class FT>
struct Star_view
{
  const std::uint32_t* vertices = nullptr;
  const std::uint32_t* neighbors = nullptr;
  const double* rests = nullptr;
  std::size_t first = 0, stride = 0, n_rows = 0;
  FT degree = 0.;

  std::size_t size() const { return n_rows; }

  Vector_3<FT> center(const Vector_3d* positions) const { return points_in_lanes<FT>(vertices, positions); }
  Vector_3<FT> neighbor(std::size_t j, const Vector_3d* positions) const
  {
    return points_in_lanes<FT>(neighbors + first + j * stride, positions);
  }

  std::uint32_t neighbor(std::size_t j, std::size_t lane = 0) const { return neighbors[first + j * stride + lane]; }

  // See Rest_triangle.
  FT opposite_0(std::size_t j) const { return rest(j, 0); }
  FT opposite_1(std::size_t j) const { return rest(j, 1); }
  FT opposite_2(std::size_t j) const { return rest(j, 2); }
  FT inverse_doubled_area(std::size_t j) const { return rest(j, 3); }
  Basic_rest_triangle<FT> rest(std::size_t j) const { return {rest(j, 0), rest(j, 1), rest(j, 2), rest(j, 3)}; }

  // Whether row j is beyond the end of the star.
  auto is_padding(std::size_t j) const { return !(FT(static_cast<double>(j)) < degree); }

  FT rest(std::size_t j, std::size_t k) const { return Lanes<FT>::load(rests + rest_index(first + j * stride, k)); }
};

// The stars of many vertices, stored so that several of them can be processed at once: `width` stars of the same
// independent set, and if possible with the same number of faces, form a packet, in which they are interleaved as
// required by Star_view. A star with very many faces is a packet by itself.
//
// Each star has a slot, called its place. The slots of a packet are consecutive, and so are the packets of an
// independent set. The remaining slots of a packet that is not full contain its first star.
//
// Corners and slots are counted by 32-bit indices. There are at most 6 n corners of n vertices, and padding adds less
// than 2 n: within a chunk of 1024 vertices of a set, which are ordered by degree, a packet wastes at most 8 times the
// difference of its largest and smallest degree, which telescopes to less than 8 * 32, and the last packet at most as
// much again; so does the last chunk of each set; a star by itself, of which there are fewer than n / 5, wastes at most
// 7. read_mesh() rejects meshes with 2^31 halfedges, that is, n > 2^31 / 6, so that 8 n is below 2^32.
class Star_packets
{
public:
  static constexpr std::size_t width = packet_width;

  struct Packet
  {
    std::size_t first_corner; // a multiple of packet_width
    std::uint32_t first_place, number_of_stars, number_of_rows, stride;
  };

  // Reserves memory for this number of stars with six faces, the mean of a closed mesh, and some more for padding.
  void reserve(std::size_t n_vertices)
  {
    const std::size_t n_places = n_vertices + n_vertices / 8 + width, n_corners = 6 * n_places;
    m_vertices.reserve(n_places);
    m_degrees.reserve(n_places);
    m_packets.reserve(n_places / width);
    m_neighbors.reserve(n_corners);
    m_rest.reserve(4 * n_corners);
  }

  // Allocates the stars of `vertices`, of which vertices[first_of_set[k]], ..., vertices[first_of_set[k + 1] - 1] are
  // independent. degree_of(v) is the number of neighbors of a vertex.
  template <class DegreeOf>
  void assign(const std::vector<std::uint32_t>& vertices, const std::vector<std::size_t>& first_of_set,
              const DegreeOf& degree_of)
  {
    m_vertices.clear();
    m_degrees.clear();
    m_vertices.reserve(vertices.size() + vertices.size() / 16 + width);
    m_degrees.reserve(m_vertices.capacity());
    m_packets.clear();
    m_packets.reserve(m_vertices.capacity() / width);
    m_first_packet.assign(1, 0);
    std::size_t n_corners = 0;
    std::vector<std::uint32_t> order;
    for(std::size_t set = 0; set + 1 < first_of_set.size(); ++set)
    {
      for(std::size_t begin = first_of_set[set]; begin < first_of_set[set + 1]; begin += chunk_size)
      {
        const std::size_t end = (std::min)(begin + chunk_size, first_of_set[set + 1]);
        order_by_degree(vertices.data() + begin, vertices.data() + end, degree_of, order);
        for(std::size_t k = 0; k < order.size();)
        {
          const bool is_large = degree_of(order[k]) > max_rows;
          const std::size_t stride = is_large ? 1 : width;
          std::size_t last = k + 1;
          while(last < order.size() && last < k + stride && degree_of(order[last]) <= max_rows)
            ++last;
          const auto n_rows = static_cast<std::uint32_t>(degree_of(order[last - 1]));
          m_packets.push_back({n_corners, static_cast<std::uint32_t>(m_vertices.size()),
                               static_cast<std::uint32_t>(last - k), n_rows, static_cast<std::uint32_t>(stride)});
          n_corners += (stride * n_rows + width - 1) / width * width;
          for(std::size_t lane = 0; lane < stride; ++lane)
          {
            const std::uint32_t v = order[k + lane < last ? k + lane : k];
            m_vertices.push_back(v);
            m_degrees.push_back(static_cast<std::uint32_t>(degree_of(v)));
          }
          k = last;
        }
      }
      m_first_packet.push_back(m_packets.size());
    }
    CGAL_assertion(n_corners <= (std::numeric_limits<std::uint32_t>::max)());
    resize(m_neighbors, n_corners);
    resize(m_rest, 4 * n_corners);
  }

  // Fills a packet with stars of a mesh: ring_of(v)[j] is neighbor j of a vertex, and shape_of(v, a, b) is the rest
  // shape of a face in each lane, whose vertices are v[k], a[k] and b[k] in lane k.
  template <class FT, class RingOf, class ShapeOf>
  void fill(std::size_t packet, const RingOf& ring_of, const ShapeOf& shape_of)
  {
    const Packet& p = m_packets[packet];
    for(std::size_t lane = 0; lane < p.stride; ++lane)
    {
      const auto ring = ring_of(m_vertices[p.first_place + lane]);
      for(std::size_t j = 0; j < p.number_of_rows; ++j)
        m_neighbors[p.first_corner + j * p.stride + lane] = ring[j < ring.size() ? j : 0];
    }
    if(p.stride == 1)
      set_rests<double>(p, shape_of);
    else
      set_rests<FT>(p, shape_of);
  }

  // Fills a packet with copies of stars of other packets: star_of(v) is that of a vertex.
  template <class StarOf>
  void fill_with_copies(std::size_t packet, const StarOf& star_of)
  {
    const Packet& p = m_packets[packet];
    for(std::size_t lane = 0; lane < p.stride; ++lane)
    {
      const auto star = star_of(m_vertices[p.first_place + lane]);
      for(std::size_t j = 0; j < p.number_of_rows; ++j)
      {
        const std::size_t corner = p.first_corner + j * p.stride + lane;
        const bool is_face = j < star.size();
        m_neighbors[corner] = star.neighbor(is_face ? j : 0);
        set_rest<double>(corner, is_face ? star.rest(j) : Rest_triangle{0., 0., 0., 0.});
      }
    }
  }

  // A single star, to be copied.
  Star_view<double> star(std::size_t place) const
  {
    const auto next = std::upper_bound(m_packets.begin(), m_packets.end(), place,
                                       [](std::size_t p, const Packet& packet) { return p < packet.first_place; });
    const Packet& packet = *(next - 1);
    return view<double>(packet, place - packet.first_place);
  }

  std::size_t number_of_sets() const { return m_first_packet.size() - 1; }
  std::size_t first_packet(std::size_t set) const { return m_first_packet[set]; }
  std::size_t number_of_packets() const { return m_packets.size(); }
  const Packet& packet(std::size_t k) const { return m_packets[k]; }

  std::size_t number_of_places() const { return m_vertices.size(); }
  std::size_t first_place_of_set(std::size_t set) const
  {
    return m_first_packet[set] < m_packets.size() ? m_packets[m_first_packet[set]].first_place : m_vertices.size();
  }
  std::uint32_t vertex(std::size_t place) const { return m_vertices[place]; }
  const std::uint32_t* vertices(const Packet& p) const { return m_vertices.data() + p.first_place; }

  // The stars of a packet, starting at `lane`. A single star has no padding.
  template <class FT>
  Star_view<FT> view(const Packet& p, std::size_t lane) const
  {
    std::size_t n_rows = p.number_of_rows;
    if constexpr(Lanes<FT>::width == 1)
      n_rows = m_degrees[p.first_place + lane];
    const std::size_t place = p.first_place + lane;
    return {m_vertices.data() + place,
            m_neighbors.data(),
            m_rest.data(),
            p.first_corner + lane,
            p.stride,
            n_rows,
            Lanes<FT>::generate([&](std::size_t k) { return static_cast<double>(m_degrees[place + k]); })};
  }

  // Entry k of the rest shapes of the corners starting at this one, in the lanes of a row.
  template <class FT = double>
  FT rest(std::size_t corner, std::size_t k) const
  {
    return Lanes<FT>::load(m_rest.data() + rest_index(corner, k));
  }

  // Calls f(is_of_row, corner, v, a, b) for the faces (v, a, b) of a packet that belong to their vertex v, in a fixed
  // order. A face belongs to its vertex with the smallest slot. If all faces of a row belong to their vertices, as
  // almost everywhere in the first set, to which most faces of a mesh belong, they are passed consecutively, with
  // `is_of_row`.
  template <class Function>
  void for_each_face(std::size_t packet, const std::vector<std::uint32_t>& places, const Function& f) const
  {
    const Packet& p = m_packets[packet];
    for(std::size_t j = 0; j < p.number_of_rows; ++j)
    {
      const std::size_t corner = p.first_corner + j * p.stride,
                        next = j + 1 < p.number_of_rows ? corner + p.stride : p.first_corner;
      std::array<int, width> belongs = {};
      for(std::size_t lane = 0; lane < p.number_of_stars; ++lane)
      {
        const std::uint32_t place = p.first_place + static_cast<std::uint32_t>(lane), a = m_neighbors[corner + lane],
                            b = m_neighbors[next + lane];
        // A padding row has the first neighbor on both sides. Bit operations avoid mispredicted branches.
        belongs[lane] =
            static_cast<int>(place < places[a]) & static_cast<int>(place < places[b]) & static_cast<int>(a != b);
      }
      const bool is_row = std::accumulate(belongs.begin(), belongs.end(), 0) == width;
      for(std::size_t lane = 0; lane < p.number_of_stars; ++lane)
        if(belongs[lane])
          f(is_row, corner + lane, m_vertices[p.first_place + lane], m_neighbors[corner + lane],
            m_neighbors[next + lane]);
    }
  }

private:
  template <class FT, class ShapeOf>
  void set_rests(const Packet& p, const ShapeOf& shape_of)
  {
    for(std::size_t lane = 0; lane < p.stride; lane += Lanes<FT>::width)
    {
      const Star_view<FT> star = view<FT>(p, lane);
      for(std::size_t j = 0; j < p.number_of_rows; ++j)
      {
        const std::size_t corner = star.first + j * p.stride,
                          next = j + 1 < p.number_of_rows ? corner + p.stride : star.first;
        const Basic_rest_triangle<FT> shape =
            shape_of(Number_type<FT>(), star.vertices, &m_neighbors[corner], &m_neighbors[next]);
        const auto is_padding = star.is_padding(j);
        const auto unless_padding = [&](const FT& number) { return select(is_padding, FT(0.), number); };
        set_rest<FT>(corner, {unless_padding(shape.opposite_0), unless_padding(shape.opposite_1),
                              unless_padding(shape.opposite_2), unless_padding(shape.inverse_doubled_area)});
      }
    }
  }

  // Sets the rest shapes of the corners starting at this one.
  template <class FT>
  void set_rest(std::size_t corner, const Basic_rest_triangle<FT>& shape)
  {
    const auto set = [&](std::size_t k, const FT& number) { Lanes<FT>::store(number, &m_rest[rest_index(corner, k)]); };
    set(0, shape.opposite_0);
    set(1, shape.opposite_1);
    set(2, shape.opposite_2);
    set(3, shape.inverse_doubled_area);
  }

  // Vertices are ordered by degree within chunks: small enough for locality, large enough to fill packets of equal
  // degree.
  static constexpr std::size_t chunk_size = 1024;
  static constexpr std::size_t max_rows = 32; // of a packet of several stars: padding for longer stars wastes memory

  // Orders vertices by degree; vertices of the same degree, or of more than max_rows, keep their order.
  template <class DegreeOf>
  static void order_by_degree(const std::uint32_t* begin, const std::uint32_t* end, const DegreeOf& degree_of,
                              std::vector<std::uint32_t>& order)
  {
    const auto key_of = [&](std::uint32_t v) {
      return (std::min)(static_cast<std::size_t>(degree_of(v)), max_rows + 1);
    };
    std::array<std::size_t, max_rows + 3> next = {};
    for(const std::uint32_t* v = begin; v != end; ++v)
      ++next[key_of(*v) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    order.resize(static_cast<std::size_t>(end - begin));
    for(const std::uint32_t* v = begin; v != end; ++v)
      order[next[key_of(*v)]++] = *v;
  }

  // Growing a vector step by step takes twice the memory and copies contents that are no longer needed. New elements
  // are not initialized here; fill() touches the memory in parallel.
  template <class T>
  static void resize(Large_array<T>& numbers, std::size_t n)
  {
    if(n > numbers.capacity())
    {
      const bool is_first = numbers.empty();
      Large_array<T>().swap(numbers);
      numbers.reserve(is_first ? n : n + n / 16);
    }
    numbers.resize(n, boost::container::default_init);
  }

  std::vector<Packet> m_packets;
  std::vector<std::size_t> m_first_packet;
  std::vector<std::uint32_t> m_vertices, m_degrees; // of the slots
  Large_array<std::uint32_t> m_neighbors;
  Large_array<double> m_rest;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_STAR_PACKETS_H
