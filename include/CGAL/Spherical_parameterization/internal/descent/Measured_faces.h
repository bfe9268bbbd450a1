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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_MEASURED_FACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_MEASURED_FACES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/internal/descent/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/execution/Large_array.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Several faces in lanes: their corners on the unit sphere, and their rest shapes, see Rest_triangle.
template <class FT>
struct Faces_in_lanes
{
  std::array<Vector_3<FT>, 3> corners;
  std::array<FT, 3> opposite;
  FT inverse_doubled_area;
};

// All faces of a mesh, each once, for measurements at any state of the map. Several of them are measured at once:
// `width` faces form a packet. The last packet is padded with its first face.
class Measured_faces
{
public:
  void reserve(std::size_t n_faces)
  {
    m_packets.reserve((n_faces + width - 1) / width);
    m_measured.reserve((n_faces + width - 1) / width);
  }

  // Sets the faces of the mesh with these stars, which also contain the rest shapes for the measurements. The star of
  // vertex v has the index places[v]. Rows of faces that are adjacent there are adjacent here, before all others.
  void assign(const Star_packets& stars, const std::vector<std::uint32_t>& places, std::size_t n_faces,
              Execution execution)
  {
    m_number_of_faces = n_faces;
    m_partial.clear(); // nothing has been measured
    const std::size_t n_packets = (n_faces + width - 1) / width, n_star_packets = stars.number_of_packets();
    m_packets.resize(n_packets, boost::container::default_init);
    m_measured.resize(n_packets, boost::container::default_init);
    // The number of faces of each packet of stars, those of rows in first[0], and then their first indices here.
    std::array<std::vector<std::size_t>, 2> first;
    first.fill(std::vector<std::size_t>(n_star_packets + 1, 0));
    for_each_in_blocks(execution, 0, n_star_packets, packets_per_block, [&](std::size_t k) {
      stars.for_each_face(k, places, [&](bool is_of_row, std::size_t, std::uint32_t, std::uint32_t, std::uint32_t) {
        ++first[is_of_row ? 0 : 1][k + 1];
      });
    });
    std::partial_sum(first[0].begin(), first[0].end(), first[0].begin());
    first[1][0] = first[0].back();
    std::partial_sum(first[1].begin(), first[1].end(), first[1].begin());
    CGAL_assertion(first[1].back() == n_faces);
    m_number_of_rows = first[1][0] / width;
    for_each_block(execution, 0, n_star_packets, packets_per_block, [&](std::size_t begin, std::size_t end) {
      std::array<std::size_t, 2> n = {first[0][begin], first[1][begin]};
      for(std::size_t k = begin; k < end; ++k)
        stars.for_each_face(k, places,
                            [&](bool is_of_row, std::size_t corner, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                              const std::size_t face = n[is_of_row ? 0 : 1]++;
                              Packet& packet = m_packets[face / width];
                              packet.corners[face % width] = static_cast<std::uint32_t>(corner);
                              packet.vertices[0][face % width] = a;
                              packet.vertices[1][face % width] = b;
                              packet.vertices[2][face % width] = c;
                            });
    });
    for(std::size_t n = n_faces; n < n_packets * width; ++n)
    {
      Packet& packet = m_packets[n / width];
      packet.corners[n % width] = packet.corners[0];
      for(auto& vertices : packet.vertices)
        vertices[n % width] = vertices[0];
    }
  }

  // Measures all faces on the sphere of radius `radius`, several at once or one by one, depending on `Space`. The areas
  // of the images are those of the objective, or those of flat triangles.
  template <class Space>
  Energy_summary measure(const Space& space, const Star_packets& stars, const std::vector<Vector_3d>& positions,
                         double radius, const Face_objective& objective, Execution execution, bool are_flat = false)
  {
    m_radius = radius;
    m_partial.resize(number_of_blocks());
    for_each_block_of_faces<Space>(execution, [&](auto number_type, std::size_t block) {
      using FT = typename decltype(number_type)::FT;
      for_each_of_block<FT>(stars, positions, block, [&](const Faces_in_lanes<FT>& faces, std::size_t face) {
        const auto [i, d, flat_d] = invariants<FT>(space, faces, radius, objective);
        Measured& measured = m_measured[face / width];
        Lanes<FT>::store(i, measured.i.data() + face % width);
        Lanes<FT>::store(are_flat ? flat_d : d, measured.d.data() + face % width);
      });
      summarize<FT>(space.energy(), stars, radius, objective, block);
    });
    return total(objective);
  }

  // Sums up the energies of the last measured map on the sphere of radius `radius`.
  template <class Space>
  Energy_summary summary(const Space& space, const Star_packets& stars, double radius, const Face_objective& objective,
                         Execution execution)
  {
    for_each_block_of_faces<Space>(execution, [&](auto number_type, std::size_t block) {
      summarize<typename decltype(number_type)::FT>(space.energy(), stars, radius, objective, block);
    });
    return total(objective);
  }

  // The invariants of all faces, for a radius policy.
  template <class Space>
  const std::vector<Face_invariants_3>& all_invariants(const Space& space, const Star_packets& stars,
                                                       const std::vector<Vector_3d>& positions, double radius,
                                                       const Face_objective& objective, Execution execution)
  {
    m_invariants.resize(m_packets.size() * width);
    for_each_block_of_faces<Space>(execution, [&](auto number_type, std::size_t block) {
      using FT = typename decltype(number_type)::FT;
      for_each_of_block<FT>(stars, positions, block, [&](const Faces_in_lanes<FT>& faces, std::size_t face) {
        const FT area = 0.5 / faces.inverse_doubled_area;
        const auto [i, d, flat_d] = invariants<FT>(space, faces, radius, objective);
        for(std::size_t k = 0; k < Lanes<FT>::width; ++k)
          m_invariants[face + k] = {lane(area, k), lane(i, k), lane(d, k), lane(flat_d, k)};
      });
    });
    m_invariants.resize(m_number_of_faces); // without the padding of the last packet
    return m_invariants;
  }

  // The first two derivatives of the sum of psi(E) over all faces with respect to the logarithm of the radius, on the
  // sphere of radius `radius`, by the last measured areas; and the sum of the absolute values of the terms of the first
  // one, to estimate rounding errors.
  template <class Space>
  std::array<double, 3> radius_derivatives(const Space& space, const Star_packets& stars, double radius,
                                           const Face_objective& objective, Execution execution) const
  {
    std::vector<std::array<double, 3>> parts(number_of_blocks());
    for_each_block_of_faces<Space>(execution, [&](auto number_type, std::size_t block) {
      using FT = typename decltype(number_type)::FT;
      std::array<std::array<double, faces_per_block>, 3> terms;
      const std::size_t begin = first_face(block), n = first_face(block + 1) - begin;
      const FT scale = (radius / m_radius) * (radius / m_radius), sharpness = objective.sharpness,
               level = objective.level;
      for(std::size_t k = 0; k < n; k += Lanes<FT>::width)
      {
        const FT i = scale * measured<FT>(begin + k, &Measured::i), d = scale * measured<FT>(begin + k, &Measured::d);
        const Energy_derivatives_3<FT> e = space.energy().derivatives(i, d);
        // With t = log(radius), dI/dt = 2 I and dd/dt = 2 d.
        const FT et = 2. * (e.i * i + e.d * d);
        const FT ett = 2. * et + 4. * (e.ii * i * i + 2. * e.id * i * d + e.dd * d * d);
        FT first = 1., second = 0.;
        if(!objective.is_average())
        {
          const FT weight = objective.share * clamped_exponential(sharpness * (e.value - level));
          first = (1. - objective.share) + weight;
          second = sharpness * weight;
        }
        if constexpr(Space::Energy::weighs_faces_by_area)
        {
          const FT area = Lanes<FT>::generate([&](std::size_t lane) { return area_of(stars, begin + k + lane); });
          first *= area;
          second *= area;
        }
        Lanes<FT>::store(first * et, terms[0].data() + k);
        Lanes<FT>::store(first * ett + second * et * et, terms[1].data() + k);
        Lanes<FT>::store(first * (absolute(e.i * i) + absolute(e.d * d)), terms[2].data() + k);
      }
      for(std::size_t j = 0; j < 3; ++j)
      {
        std::array<double, width> columns = {};
        for(std::size_t k = 0; k < n; ++k)
          columns[k % width] += terms[j][k];
        parts[block][j] = std::accumulate(columns.begin(), columns.end(), 0.);
      }
    });
    std::array<double, 3> result = {};
    for(const std::array<double, 3>& part : parts)
      for(std::size_t j = 0; j < 3; ++j)
        result[j] += part[j];
    return result;
  }

  // Calls f(part, faces, n) for all faces at these positions, several at once, where `faces` are Faces_in_lanes, of
  // which the first `n` are valid. The faces are in `n_parts` parts, each in order, and several parts run concurrently.
  template <class Space, class Function>
  void for_each_in_lanes(const Star_packets& stars, const std::vector<Vector_3d>& positions, std::size_t n_parts,
                         Execution execution, const Function& f) const
  {
    for_each_block(execution, 0, n_parts, 1, [&](std::size_t part, std::size_t) {
      const auto visit = [&](auto number_type) {
        using FT = typename decltype(number_type)::FT;
        for(std::size_t k = part * m_packets.size() / n_parts; k < (part + 1) * m_packets.size() / n_parts; ++k)
          for(std::size_t lane = 0; lane < width && k * width + lane < m_number_of_faces; lane += Lanes<FT>::width)
            f(part, in_lanes<FT>(stars, positions.data(), k, lane),
              (std::min)(Lanes<FT>::width, m_number_of_faces - k * width - lane));
      };
      if constexpr(Space::is_lanewise)
        run_in_lanes(visit);
      else
        visit(Number_type<double>());
    });
  }

  // Calls f(a, b, c) for each face whose energy was above `bound` in the last measurement, as long as f returns true.
  // Blocks whose faces were all below the bound when they were last summed up, on a sphere of nearly the same radius,
  // are skipped.
  template <class Energy, class Function>
  void for_each_above(const Energy& energy, double bound, const Function& f) const
  {
    for(std::size_t block = 0; block < m_partial.size(); ++block)
    {
      if(!(m_partial[block].maximum_energy() > bound))
        continue;
      for(std::size_t face = first_face(block); face < first_face(block + 1); ++face)
        if(energy(m_measured[face / width].i[face % width], m_measured[face / width].d[face % width]) > bound)
        {
          const auto& vertices = m_packets[face / width].vertices;
          if(!f(vertices[0][face % width], vertices[1][face % width], vertices[2][face % width]))
            return;
        }
    }
  }

private:
  static constexpr std::size_t width = packet_width;
  static constexpr std::size_t packets_per_block = 32; // of parallel work: 256 faces, about two microseconds
  static constexpr std::size_t faces_per_block = packets_per_block * width;

  struct Packet
  {
    std::array<std::uint32_t, width> corners; // of the first vertices in their stars
    std::array<std::array<std::uint32_t, width>, 3> vertices;
  };

  // I and d of the faces of a packet.
  struct Measured
  {
    std::array<double, width> i, d;
  };

  std::size_t number_of_blocks() const { return (m_number_of_faces + faces_per_block - 1) / faces_per_block; }
  std::size_t first_face(std::size_t block) const { return (std::min)(block * faces_per_block, m_number_of_faces); }

  template <class Space, class Function>
  void for_each_block_of_faces(Execution execution, const Function& f) const
  {
    for_each_block(execution, 0, number_of_blocks(), 1, [&](std::size_t block, std::size_t) {
      if constexpr(Space::is_lanewise)
        run_in_lanes([&](auto number_type) { f(number_type, block); });
      else
        f(Number_type<double>(), block);
    });
  }

  template <class FT>
  Faces_in_lanes<FT> in_lanes(const Star_packets& stars, const Vector_3d* positions, std::size_t k,
                              std::size_t first) const
  {
    const Packet& packet = m_packets[k];
    const auto point = [&](std::size_t corner) {
      return points_in_lanes<FT>(packet.vertices[corner].data() + first, positions);
    };
    const auto rest = [&](std::size_t i) {
      if(k < m_number_of_rows)
        return stars.rest<FT>(packet.corners[first], i);
      return Lanes<FT>::generate([&](std::size_t lane) { return stars.rest(packet.corners[first + lane], i); });
    };
    return {{point(0), point(1), point(2)}, {rest(0), rest(1), rest(2)}, rest(3)};
  }

  // Calls f(faces, face) for all faces of a block, several at once, starting at index `face`.
  template <class FT, class Function>
  void for_each_of_block(const Star_packets& stars, const std::vector<Vector_3d>& positions, std::size_t block,
                         const Function& f) const
  {
    const std::size_t begin = block * packets_per_block, end = (std::min)(begin + packets_per_block, m_packets.size());
    for(std::size_t k = begin; k < end; ++k)
      for(std::size_t lane = 0; lane < width; lane += Lanes<FT>::width)
        f(in_lanes<FT>(stars, positions.data(), k, lane), k * width + lane);
  }

  // I, d and flat_d.
  template <class FT, class Space>
  static std::array<FT, 3> invariants(const Space& space, const Faces_in_lanes<FT>& faces, double radius,
                                      const Face_objective& objective)
  {
    return space.template invariants<FT>(faces.corners, faces.opposite, faces.inverse_doubled_area,
                                         1. / faces.inverse_doubled_area, radius * radius, objective);
  }

  // A member of the faces, starting at index `face`.
  template <class FT>
  FT measured(std::size_t face, std::array<double, width> Measured::*member) const
  {
    return Lanes<FT>::load((m_measured[face / width].*member).data() + face % width);
  }

  double area_of(const Star_packets& stars, std::size_t face) const
  {
    return 0.5 / stars.rest(m_packets[face / width].corners[face % width], 3);
  }

  template <class FT, class Energy>
  void summarize(const Energy& energy, const Star_packets& stars, double radius, const Face_objective& objective,
                 std::size_t block)
  {
    std::array<double, faces_per_block> energies, areas;
    const double* const counts = Energy::weighs_faces_by_area ? areas.data() : nullptr;
    const FT scale = (radius / m_radius) * (radius / m_radius);
    const std::size_t begin = first_face(block), n = first_face(block + 1) - begin;
    for(std::size_t k = 0; k < n; k += Lanes<FT>::width)
    {
      const FT i = scale * measured<FT>(begin + k, &Measured::i), d = scale * measured<FT>(begin + k, &Measured::d);
      Lanes<FT>::store(energy(i, d), energies.data() + k);
    }
    for(std::size_t k = 0; counts && k < n; ++k)
      areas[k] = area_of(stars, begin + k);
    m_partial[block] = Energy_summary(objective.sharpness);
    m_partial[block].add_all<FT>(energies.data(), counts, n);
  }

  Energy_summary total(const Face_objective& objective) const
  {
    Energy_summary result(objective.sharpness);
    for(const Energy_summary& part : m_partial)
      result.add(part);
    return result;
  }

  std::size_t m_number_of_faces = 0, m_number_of_rows = 0; // of rows, which come first
  Large_array<Packet> m_packets;
  Large_array<Measured> m_measured;
  std::vector<Face_invariants_3> m_invariants; // for radius policies
  double m_radius = 1.;
  std::vector<Energy_summary> m_partial; // of the blocks
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_MEASURED_FACES_H
