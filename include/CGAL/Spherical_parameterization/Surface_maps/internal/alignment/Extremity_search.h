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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_EXTREMITY_SEARCH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_EXTREMITY_SEARCH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Rotation_search.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Extremities of two surfaces that may correspond, given by their indices, and the rotation that aligns their tips.
struct Extremity_matching : Scored_rotation
{
  std::vector<std::array<std::uint32_t, 2>> pairs;
};

// Searches for extremities of two surfaces that may correspond, by the distances of their tips along the surface, which do not
// depend on the pose. Distances do not distinguish left from right. However, with left and right exchanged, the tips on the spheres
// are mirror images, and no rotation aligns them.
class Extremity_search
{
public:
  using Extremities = std::vector<Surface_descriptor::Origin>;

  Extremity_search(Extremities first, Extremities second)
    : m_extremities{std::move(first), std::move(second)}
  {
    // The extremities with the largest average distance come first. Most animals have seven. There are 130,922 matchings of seven,
    // and ten times as many of eight.
    constexpr std::size_t max_extremities = 7;
    for(Extremities& extremities : m_extremities)
      extremities.resize((std::min)(extremities.size(), max_extremities));
    m_partners.resize(m_extremities[0].size(), none);
    m_is_taken.resize(m_extremities[1].size(), 0);
  }

  // The best matchings whose rotations are at least 30 degrees apart, in the order of decreasing score; possibly none.
  std::vector<Extremity_matching> best(std::size_t n, const std::vector<Vector_3d>& directions1,
                                       const std::vector<Vector_3d>& directions2)
  {
    // Closer rotations lead to the same map.
    constexpr double min_angle = CGAL_PI / 6.;
    // The number of matchings for which rotations are fitted, a microsecond each. The correct ones were among the first 100.
    constexpr std::size_t max_fitted = 2000;
    m_found.clear();
    extend(0, 0., 0);
    std::stable_sort(m_found.begin(), m_found.end(),
                     [](const Extremity_matching& a, const Extremity_matching& b) { return a.score > b.score; });
    m_found.resize((std::min)(m_found.size(), max_fitted));
    for(Extremity_matching& matching : m_found)
    {
      std::vector<std::pair<Vector_3d, Vector_3d>> ends;
      for(const auto& [i, j] : matching.pairs)
        ends.emplace_back(directions1[m_extremities[0][i].vertex], directions2[m_extremities[1][j].vertex]);
      const std::optional<Rotation_matrix> rotation = fitting_rotation(ends);
      double sum_of_cosines = 0.;
      if(rotation)
        for(const auto& [p, q] : ends)
          sum_of_cosines += dot(rotated(*rotation, p), q);
      matching.score *= (std::max)(sum_of_cosines / static_cast<double>(ends.size()), 0.);
      matching.rotation = rotation.value_or(rotation_matrix({1., 0., 0., 0.}));
    }
    m_found.erase(std::remove_if(m_found.begin(), m_found.end(),
                                 [](const Extremity_matching& matching) { return !(matching.score > 0.); }),
                  m_found.end());
    return select_rotations(std::move(m_found), n, min_angle);
  }

private:
  static constexpr std::uint32_t none = 0xffffffff;

  // The compatibility of two pairs of extremities, at most 1: the similarity of their distances.
  double gain(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const
  {
    // Relative to the mean of both. It is 0.27 between the hands of a slim person and a stout one; with a larger value, a hand can
    // be matched with a head.
    constexpr double max_difference = 0.35;
    const double x = m_extremities[0][i].distances[m_extremities[0][k].vertex],
                 y = m_extremities[1][j].distances[m_extremities[1][l].vertex];
    const double difference = (x - y) / (0.5 * (x + y) * max_difference);
    return 1. - difference * difference;
  }

  // Enumerates all possible partners of extremity i of the first surface, including none.
  void extend(std::uint32_t i, double score, std::size_t n_pairs)
  {
    constexpr std::size_t min_pairs = 3; // two determine a rotation, but their only distance is not significant
    if(i == m_extremities[0].size())
    {
      if(n_pairs < min_pairs)
        return;
      m_found.push_back({{{}, score}, {}});
      for(std::uint32_t k = 0; k < i; ++k)
        if(m_partners[k] != none)
          m_found.back().pairs.push_back({k, m_partners[k]});
      return;
    }
    for(std::uint32_t j = 0; j < m_extremities[1].size(); ++j)
    {
      double sum = score;
      bool is_possible = !m_is_taken[j];
      for(std::uint32_t k = 0; k < i && is_possible; ++k)
        if(m_partners[k] != none)
        {
          const double more = gain(i, j, k, m_partners[k]);
          is_possible = more > 0.;
          sum += more;
        }
      if(!is_possible)
        continue;
      m_is_taken[j] = 1;
      m_partners[i] = j;
      extend(i + 1, sum, n_pairs + 1);
      m_is_taken[j] = 0;
      m_partners[i] = none;
    }
    extend(i + 1, score, n_pairs);
  }

  std::array<Extremities, 2> m_extremities;
  std::vector<std::uint32_t> m_partners; // the partners of the extremities of the first surface
  std::vector<char> m_is_taken;
  std::vector<Extremity_matching> m_found;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_EXTREMITY_SEARCH_H
