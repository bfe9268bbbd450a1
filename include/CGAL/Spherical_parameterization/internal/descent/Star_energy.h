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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_STAR_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_STAR_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The part of the objective that depends on one vertex, as a function of the vertex's two tangential coordinates: the
// sum over the faces of its star of E or, if the sharpness s is positive, of s psi(E), see Face_objective, each times
// the area of the face on the surface, if the energy weighs faces by area. If there is no level R (eq. 7 of the paper),
// the largest energy of the star at its current position is used instead, which changes neither the minimizer nor the
// direction of the steps and cannot overflow there.
//
// One object serves many vertices: it allocates only for a star larger than all previous ones. With a packed number
// type it serves as many stars at once as the type has lanes. It has mutable state, and is used by one thread at a
// time.
//
// Exponentials are long chains of dependent operations and are computed in separate loops: the shorter a loop is, the
// more of its iterations are executed concurrently.
template <class Energy, template <class> class Image_measure, class FT = double>
class Star_energy
{
public:
  explicit Star_energy(const Face_energy<Energy>& energy)
    : m_energy(energy)
  {}

  // Sets the objective of the following stars: E is evaluated on the sphere of squared radius `squared_radius`.
  void set_objective(double squared_radius, const Face_objective& objective)
  {
    m_scale = squared_radius;
    m_objective = objective;
  }

  // Loads a star; the positions are on the unit sphere.
  void load(const Star_view<FT>& star, const Vector_3d* positions)
  {
    m_star = star;
    m_frame = Basic_tangent_frame<FT>(star.center(positions));
    const std::size_t size = star.size();
    if(m_faces.size() <= size)
      m_faces.resize(2 * size + 1);
    FT shortest = std::numeric_limits<double>::infinity();
    for(std::size_t j = 0; j < size; ++j)
    {
      m_faces[j].offset = m_frame.offset_of(star.neighbor(j, positions));
      shortest = minimum(shortest, squared_length(m_faces[j].offset));
    }
    m_faces[size].offset = m_faces[0].offset;
    m_squared_shortest_edge = shortest;

    m_max_energy = FT(0.);
    for(std::size_t j = 0; j < size; ++j)
    {
      Face& face = m_faces[j];
      const FT scale = m_scale;
      const Vector_3<FT>&p = face.offset, &q = m_faces[j + 1].offset;
      face.fixed_i = scale * star.opposite_0(j) * squared_length(q - p); // the part of I that is constant
      face.measure = Measure(p, q);
      const FT inverse_doubled_area = star.inverse_doubled_area(j);
      const FT doubled_area = this->doubled_area(j);
      face.to_d = scale * inverse_doubled_area *
                  m_objective.area_factor(star.opposite_0(j), star.opposite_1(j), star.opposite_2(j), doubled_area);
      const FT i =
          face.fixed_i + scale * (star.opposite_2(j) * squared_length(p) + star.opposite_1(j) * squared_length(q));
      const FT d = unless_padding(j, face.to_d * face.measure.value(), FT(1.));
      face.energy = m_energy.derivatives(i, d);
      m_max_energy = maximum(m_max_energy, face.energy.value);
    }
    if(m_objective.is_average())
      return;
    m_level = m_objective.has_level() ? FT(m_objective.level) : m_max_energy;
    for(std::size_t j = 0; j < size; ++j)
      m_faces[j].weight = weight_of(m_faces[j].energy.value);
  }

  // The length of the shortest edge at the vertex, the unit of its steps.
  FT shortest_edge() const { return square_root(m_squared_shortest_edge); }

  // The objective at the current position, with its gradient and Hessian; relative to the largest energy if there is no
  // level.
  FT derivatives(std::array<FT, 2>& gradient, std::array<FT, 3>& hessian) const
  {
    return evaluate<true>(gradient, hessian);
  }

  FT gradient(std::array<FT, 2>& gradient) const
  {
    std::array<FT, 3> unused;
    return evaluate<false>(gradient, unused);
  }

  // The objective with the vertex at the tangential coordinates (x, y), or infinity if a face is not safely positive
  // there.
  FT operator()(const FT& x, const FT& y) const
  {
    auto is_valid = x * x + y * y < max_squared_step;
    const FT infinite = std::numeric_limits<double>::infinity();
    if(!any(is_valid))
      return infinite;
    const FT z = Basic_tangent_frame<FT>::height_at(x, y);
    FT f = 0.;
    for(std::size_t j = 0; j < m_star.size(); ++j)
    {
      const Vector_3<FT>&p = m_faces[j].offset, &q = m_faces[j + 1].offset;
      const Vector_3<FT> to_p = {p[0] - x, p[1] - y, p[2] - z}, to_q = {q[0] - x, q[1] - y, q[2] - z};
      const Vector_3<FT> n = cross(to_p, to_q);
      const FT determinant = x * n[0] + y * n[1] + (1. + z) * n[2];
      const FT lp = squared_length(to_p), lq = squared_length(to_q);
      is_valid = is_valid && (is_safely_positive(determinant, lp + lq) || is_padding(j));
      if constexpr(std::is_same<FT, double>::value) // in lanes, the test costs more than it saves
        if(!is_valid)
          return infinite;
      const FT i = m_faces[j].fixed_i + FT(m_scale) * (m_star.opposite_2(j) * lp + m_star.opposite_1(j) * lq);
      const FT ratio = m_faces[j].to_d * Measure::value(determinant, n);
      const FT d = select(is_valid, unless_padding(j, ratio, FT(1.)), FT(1.)); // energies require positive arguments
      m_faces[j].new_energy = m_energy(i, d);
    }
    if(!any(is_valid))
      return infinite;
    for(std::size_t j = 0; j < m_star.size(); ++j)
    {
      const FT& energy = m_faces[j].new_energy;
      f += weighted(j, m_objective.is_average() ? unless_padding(j, energy, FT(0.))
                                                : value_of(j, energy, weight_of(energy)));
    }
    return select(is_valid, f, infinite);
  }

  Vector_3<FT> point_at(const FT& x, const FT& y) const { return m_frame.point_at(x, y); }

private:
  static constexpr double max_squared_step = 0.75; // no step leaves the cap of 60 degrees around the vertex

  using Measure = Image_measure<FT>;

  // The data of face j, whose corners are the vertex and its neighbors j and j + 1.
  struct Face
  {
    Vector_3<FT> offset; // of neighbor j
    Measure measure;
    FT fixed_i, to_d;
    Energy_derivatives_3<FT> energy;
    FT weight;             // a exp(s (E - R))
    mutable FT new_energy; // of the last call of operator()
  };

  auto is_padding(std::size_t j) const
  {
    if constexpr(std::is_same<FT, double>::value)
      return false;
    else
      return m_star.is_padding(j);
  }
  FT unless_padding(std::size_t j, const FT& value, const FT& otherwise) const
  {
    return select(is_padding(j), otherwise, value);
  }

  // The doubled area of the face on the surface, or 1 for a padding row.
  FT doubled_area(std::size_t j) const { return 1. / unless_padding(j, m_star.inverse_doubled_area(j), FT(1.)); }

  FT weighted(std::size_t j, const FT& value) const
  {
    if constexpr(Face_energy<Energy>::weighs_faces_by_area)
      return doubled_area(j) * value;
    else
      return value;
  }

  // a exp(s (E - R)), see Face_objective.
  FT weight_of(const FT& energy) const
  {
    return m_objective.share * clamped_exponential(m_objective.sharpness * (energy - m_level));
  }

  double linear_weight() const { return m_objective.sharpness * (1. - m_objective.share); }

  // s psi(E), given the weight.
  FT value_of(std::size_t j, const FT& energy, const FT& weight) const
  {
    return unless_padding(j, linear_weight() * energy + weight, FT(0.));
  }

  template <bool with_hessian>
  FT evaluate(std::array<FT, 2>& gradient, std::array<FT, 3>& hessian) const
  {
    const FT sharpness = m_objective.sharpness, scale = m_scale;
    FT f = 0., gx = 0., gy = 0., hxx = 0., hxy = 0., hyy = 0.;
    for(std::size_t j = 0; j < m_star.size(); ++j)
    {
      const Vector_3<FT>&p = m_faces[j].offset, &q = m_faces[j + 1].offset;
      const Measure& measure = m_faces[j].measure;
      const Energy_derivatives_3<FT>& e = m_faces[j].energy;
      const FT to_p = 2. * scale * m_star.opposite_2(j), to_q = 2. * scale * m_star.opposite_1(j);
      const FT ix = -(to_p * p[0] + to_q * q[0]), iy = -(to_p * p[1] + to_q * q[1]);
      const FT& to_d = m_faces[j].to_d;
      const FT dx = to_d * measure.dx(), dy = to_d * measure.dy();
      FT ex = e.i * ix + e.d * dx, ey = e.i * iy + e.d * dy;
      FT exx = 0., exy = 0., eyy = 0.;
      if constexpr(with_hessian)
      {
        const FT i2 = to_p * (1. + p[2]) + to_q * (1. + q[2]);
        exx = e.i * i2 + e.d * (to_d * measure.dxx()) + e.ii * ix * ix + 2. * e.id * ix * dx + e.dd * dx * dx;
        exy = e.ii * ix * iy + e.id * (ix * dy + iy * dx) + e.dd * dx * dy;
        eyy = e.i * i2 + e.d * (to_d * measure.dyy()) + e.ii * iy * iy + 2. * e.id * iy * dy + e.dd * dy * dy;
      }
      // The rest shape of a padding row is 0, and so are its derivatives.
      if(m_objective.is_average())
        f += weighted(j, unless_padding(j, e.value, FT(0.)));
      else
      {
        const FT& weight = m_faces[j].weight;
        const FT first = linear_weight() + sharpness * weight, second = sharpness * sharpness * weight;
        f += weighted(j, value_of(j, e.value, weight));
        if constexpr(with_hessian)
        {
          exx = first * exx + second * ex * ex;
          exy = first * exy + second * ex * ey;
          eyy = first * eyy + second * ey * ey;
        }
        ex *= first;
        ey *= first;
      }
      gx += weighted(j, ex);
      gy += weighted(j, ey);
      hxx += weighted(j, exx);
      hxy += weighted(j, exy);
      hyy += weighted(j, eyy);
    }
    gradient = {gx, gy};
    hessian = {hxx, hxy, hyy};
    return f;
  }

  Face_energy<Energy> m_energy;
  double m_scale = 1.;
  Face_objective m_objective;

  Star_view<FT> m_star;
  Basic_tangent_frame<FT> m_frame = Basic_tangent_frame<FT>({FT(0.), FT(0.), FT(1.)});
  std::vector<Face> m_faces;
  FT m_squared_shortest_edge = 0., m_max_energy = 0., m_level = 0.;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_STAR_ENERGY_H
