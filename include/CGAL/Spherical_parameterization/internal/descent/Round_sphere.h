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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_ROUND_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_ROUND_SPHERE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The round sphere as the space of Block_coordinate_descent on which vertices move. `Step` determines how the image of
// a face is measured, and whether several vertices move at once, in lanes.
template <class Energy_, class Step>
class Round_sphere
{
public:
  using Energy = Face_energy<Energy_>;
  template <class FT>
  using Star = Star_energy<Energy_, Step::template Image_measure, FT>;

  static constexpr bool is_lanewise = Step::is_lanewise;

  explicit Round_sphere(const Energy& energy)
    : m_energy(energy)
  {}

  const Energy& energy() const { return m_energy; }

  using Scratch = In_lanes<Star>; // the data that a thread needs to move stars

  // Moves the center of the star in each lane, for the first `n_vertices` lanes.
  template <class FT>
  void move(const Star_view<FT>& view, const std::uint32_t* vertices, std::size_t n_vertices, Vector_3d* positions,
            double radius, const Face_objective& objective, const Step& vertex_step, Scratch& scratch) const
  {
    Star<FT>& star = scratch.template get<FT>(m_energy);
    star.set_objective(radius * radius, objective);
    star.load(view, positions);
    std::array<FT, 2> step = {FT(0.), FT(0.)};
    const auto is_moved = vertex_step(star, step);
    if(!any(is_moved))
      return;
    const Vector_3<FT> point = star.point_at(step[0], step[1]);
    for(std::size_t k = 0; k < Lanes<FT>::width && k < n_vertices; ++k)
      if(lane(is_moved, k))
        positions[vertices[k]] = {lane(point[0], k), lane(point[1], k), lane(point[2], k)};
  }

  // I, d and flat_d of faces with these corners and rest shapes, see Face_invariants_3.
  template <class FT>
  std::array<FT, 3> invariants(const std::array<Vector_3<FT>, 3>& p, const std::array<FT, 3>& opposite,
                               const FT& inverse_doubled_area, const FT& doubled_area, double squared_radius,
                               const Face_objective& objective) const
  {
    const Vector_3<FT> to_p = p[1] - p[0], to_q = p[2] - p[0];
    const Vector_3<FT> n = cross(to_p, to_q);
    const auto& [o0, o1, o2] = opposite;
    const FT scale = squared_radius, to_flat_d = scale * inverse_doubled_area;
    return {scale * (o0 * squared_length(p[2] - p[1]) + o1 * squared_length(to_q) + o2 * squared_length(to_p)),
            to_flat_d * objective.area_factor(o0, o1, o2, doubled_area) *
                Step::template Image_measure<FT>::value(dot(p[0], n), n),
            to_flat_d * length(n)};
  }

private:
  Energy m_energy;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_ROUND_SPHERE_H
