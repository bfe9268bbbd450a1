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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_MEASURED_FACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_MEASURED_FACES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_invariants_3.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/simd/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/simd/Vector_3.h>

#include <CGAL/assertions.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The energies of many faces in a few figures. Summaries of parts add up to that of the whole.
class Energy_summary
{
public:
  explicit Energy_summary(double sharpness = 0.)
    : m_sharpness(sharpness)
  {}

  // Adds the energies of many faces, in several columns, which do not wait for each other. Which energies a column gets
  // does not depend on the number of lanes.
  template <class FT>
  void add_all(const double* energies, std::size_t n)
  {
    const std::size_t n_in_rows = n - n % n_columns;
    std::array<double, n_columns> sums = {}, largest;
    largest.fill(lowest);
    for(std::size_t column = 0; column < n_columns; column += Lanes<FT>::width)
    {
      FT column_sum = 0., column_largest = lowest;
      for(std::size_t k = column; k < n_in_rows; k += n_columns)
      {
        const FT energy = Lanes<FT>::load(energies + k);
        column_sum += energy;
        column_largest = maximum(column_largest, energy);
      }
      Lanes<FT>::store(column_sum, sums.data() + column);
      Lanes<FT>::store(column_largest, largest.data() + column);
    }
    for(std::size_t k = n_in_rows; k < n; ++k)
    {
      sums[k - n_in_rows] += energies[k];
      largest[k - n_in_rows] = (std::max)(largest[k - n_in_rows], energies[k]);
    }
    Energy_summary part(m_sharpness);
    part.m_size = n;
    part.m_sum = std::accumulate(sums.begin(), sums.end(), 0.);
    part.m_max = *std::max_element(largest.begin(), largest.end());
    if(m_sharpness > 0.)
    {
      const auto exponential_of = [&](const FT& energy) {
        const FT sharpness = m_sharpness, shift = part.m_max;
        return exponential(sharpness * (energy - shift));
      };
      std::array<double, n_columns> last_row;
      last_row.fill(part.m_max);
      std::copy(energies + n_in_rows, energies + n, last_row.begin());
      for(std::size_t column = 0; column < n_columns; column += Lanes<FT>::width)
      {
        FT column_sum = 0.;
        for(std::size_t k = column; k < n_in_rows; k += n_columns)
          column_sum += exponential_of(Lanes<FT>::load(energies + k));
        Lanes<FT>::store(column_sum, sums.data() + column);
        Lanes<FT>::store(exponential_of(Lanes<FT>::load(last_row.data() + column)), last_row.data() + column);
      }
      for(std::size_t k = n_in_rows; k < n; ++k)
        sums[k - n_in_rows] += last_row[k - n_in_rows];
      part.m_sum_of_exponentials = std::accumulate(sums.begin(), sums.end(), 0.);
    }
    add(part);
  }

  void add(const Energy_summary& part)
  {
    if(part.m_size == 0)
      return;
    m_size += part.m_size;
    m_sum += part.m_sum;
    if(m_sharpness > 0.)
    {
      // sums of exp(s (E - maximum)), rescaled to the larger one
      if(part.m_max > m_max)
        m_sum_of_exponentials = part.m_sum_of_exponentials + m_sum_of_exponentials * rescaling(part.m_max);
      else
        m_sum_of_exponentials += part.m_sum_of_exponentials * part.rescaling(m_max);
    }
    m_max = (std::max)(m_max, part.m_max);
  }

  double average() const { return m_sum / static_cast<double>(m_size); }
  double maximum_energy() const { return m_max; }

  // log(mean of exp(s E)) / s, or the average for s = 0: the objective of eq. 7 in the unit of the energy. It lies
  // between the average and the maximum and goes from the one to the other as s grows, so that its values for
  // different s can be compared.
  double objective() const
  {
    if(!(m_sharpness > 0.))
      return average();
    return m_max + std::log(m_sum_of_exponentials / static_cast<double>(m_size)) / m_sharpness;
  }

  // What a change of an energy near `energy` is to be compared with. Where all energies are near their minimum, a
  // small part of them is much of what could still be gained.
  double scale_of_changes(double energy) const
  {
    const double spread = maximum_energy() - average();
    return (std::max)((std::min)(energy, 2. * spread), 1e-6 * energy);
  }

private:
  double rescaling(double new_max) const
  {
    return m_size > 0 && m_max > lowest ? std::exp(m_sharpness * (m_max - new_max)) : 0.;
  }

  static constexpr std::size_t n_columns = packet_width;
  static constexpr double lowest = std::numeric_limits<double>::lowest();

  double m_sharpness;
  std::size_t m_size = 0;
  double m_sum = 0., m_max = lowest, m_sum_of_exponentials = 0.;
};

// All faces of a mesh, each once, to be measured at any state of the map. They are laid out such that several of them
// are measured at once: `width` faces make a packet, which ends with its first face again where there are no more.
class Measured_faces
{
public:
  // Sets memory aside for so many faces.
  void reserve(std::size_t n_faces)
  {
    m_packets.reserve((n_faces + width - 1) / width);
    m_invariants.reserve(n_faces);
  }

  // Takes the faces of the mesh with these stars, which hold the rest shapes for the measurements as well.
  void assign(const Star_packets& stars, std::size_t n_faces, Execution execution)
  {
    m_number_of_faces = n_faces;
    m_partial.clear(); // nothing has been measured
    const std::size_t n_packets = (n_faces + width - 1) / width, n_star_packets = stars.number_of_packets();
    m_packets.resize(n_packets, boost::container::default_init);
    m_invariants.resize(n_faces, boost::container::default_init);
    std::vector<std::size_t> first(n_star_packets + 1, 0); // of the faces of each packet of stars
    for_each_block(execution, 0, n_star_packets, packets_per_block, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
        first[k + 1] = stars.number_of_faces(k);
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    CGAL_assertion(first.back() == n_faces);
    for_each_block(execution, 0, n_star_packets, packets_per_block, [&](std::size_t begin, std::size_t end) {
      std::size_t n = first[begin];
      for(std::size_t k = begin; k < end; ++k)
        stars.for_each_face(k, [&](std::size_t corner, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
          Packet& packet = m_packets[n / width];
          packet.corners[n % width] = static_cast<std::uint32_t>(corner);
          packet.vertices[0][n % width] = a;
          packet.vertices[1][n % width] = b;
          packet.vertices[2][n % width] = c;
          ++n;
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

  // Measures all faces on the sphere of radius `radius`, several at once or one by one, as `Step` measures them.
  template <class Step, class Energy>
  Energy_summary measure(const Star_packets& stars, const Face_energy<Energy>& energy,
                         const std::vector<Vector_3d>& positions, double radius, double sharpness, Execution execution)
  {
    m_partial.assign((m_packets.size() + packets_per_block - 1) / packets_per_block, Energy_summary(sharpness));
    for_each_block(execution, 0, m_packets.size(), packets_per_block, [&](std::size_t begin, std::size_t end) {
      const auto measure_packets = [&](auto number_type) {
        using FT = typename decltype(number_type)::FT;
        std::array<double, width * packets_per_block> energies;
        for(std::size_t k = begin; k < end; ++k)
        {
          for(const std::uint32_t corner : m_packets[(std::min)(k + packets_ahead, m_packets.size() - 1)].corners)
            stars.prefetch_rest(corner);
          for(std::size_t lane = 0; lane < width; lane += Lanes<FT>::width)
            measure_lanes<Step, FT>(stars, energy, positions.data(), radius * radius, k, lane,
                                    energies.data() + (k - begin) * width + lane);
        }
        const std::size_t n = (std::min)(end * width, m_number_of_faces) - begin * width;
        m_partial[begin / packets_per_block].template add_all<FT>(energies.data(), n);
      };
      if constexpr(Step::is_lanewise)
        run_in_lanes(measure_packets);
      else
        measure_packets(Number_type<double>());
    });
    Energy_summary total(sharpness);
    for(const Energy_summary& part : m_partial)
      total.add(part);
    return total;
  }

  // what was measured last
  const boost::container::vector<Face_invariants_3>& invariants() const { return m_invariants; }

  // Calls f(a, b, c) for each face whose energy was above `bound` when it was measured last, as long as f returns true.
  template <class Energy, class Function>
  void for_each_above(const Face_energy<Energy>& energy, double bound, const Function& f) const
  {
    for(std::size_t block = 0; block < m_partial.size(); ++block)
    {
      if(!(m_partial[block].maximum_energy() > bound))
        continue;
      const std::size_t begin = block * packets_per_block * width;
      const std::size_t end = (std::min)(begin + packets_per_block * width, m_number_of_faces);
      for(std::size_t face = begin; face < end; ++face)
        if(energy(m_invariants[face].i, m_invariants[face].d) > bound)
        {
          const auto& vertices = m_packets[face / width].vertices;
          if(!f(vertices[0][face % width], vertices[1][face % width], vertices[2][face % width]))
            return;
        }
    }
  }

private:
  static constexpr std::size_t width = packet_width;
  static constexpr std::size_t packets_per_block = 32;
  static constexpr std::size_t packets_ahead = 3; // of which the rest shapes are fetched

  struct Packet
  {
    std::array<std::uint32_t, width> corners; // of the smallest vertices in their stars
    std::array<std::array<std::uint32_t, width>, 3> vertices;
  };

  template <class Step, class FT, class Energy>
  void measure_lanes(const Star_packets& stars, const Face_energy<Energy>& energy, const Vector_3d* positions,
                     double squared_radius, std::size_t k, std::size_t first, double* energies)
  {
    const Packet& packet = m_packets[k];
    const auto point = [&](std::size_t corner) {
      const auto coordinate = [&](std::size_t i) {
        return Lanes<FT>::generate(
            [&](std::size_t lane) { return positions[packet.vertices[corner][first + lane]][i]; });
      };
      return Vector_3<FT>{coordinate(0), coordinate(1), coordinate(2)};
    };
    const auto rest = [&](std::size_t i) {
      return Lanes<FT>::generate([&](std::size_t lane) { return stars.rest(packet.corners[first + lane], i); });
    };
    const Vector_3<FT> u = point(0), p = point(1), q = point(2);
    const Vector_3<FT> to_p = p - u, to_q = q - u;
    const Vector_3<FT> n = cross(to_p, to_q);
    const FT scale = squared_radius, inverse_doubled_area = rest(3), to_d = scale * inverse_doubled_area;
    const FT i =
        scale * (rest(0) * squared_length(q - p) + rest(1) * squared_length(to_q) + rest(2) * squared_length(to_p));
    const FT d = to_d * Step::template Image_measure<FT>::value(dot(u, n), n), flat_d = to_d * length(n),
             area = 0.5 / inverse_doubled_area;
    Lanes<FT>::store(energy(i, d), energies);
    for(std::size_t j = 0; j < Lanes<FT>::width && k * width + first + j < m_number_of_faces; ++j)
      m_invariants[k * width + first + j] = {lane(area, j), lane(i, j), lane(d, j), lane(flat_d, j)};
  }

  std::size_t m_number_of_faces = 0;
  boost::container::vector<Packet> m_packets;
  boost::container::vector<Face_invariants_3> m_invariants;
  std::vector<Energy_summary> m_partial; // of the blocks
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_MEASURED_FACES_H
