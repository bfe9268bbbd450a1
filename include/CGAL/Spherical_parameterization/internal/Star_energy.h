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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STAR_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STAR_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/Image_area.h>
#include <CGAL/Spherical_parameterization/internal/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/Star_view.h>
#include <CGAL/Spherical_parameterization/internal/Tangent_frame.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/evaluate_energy.h>
#include <CGAL/Spherical_parameterization/internal/is_safely_positive.h>

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The part of the objective that depends on one vertex, as a function of the two tangential coordinates of the vertex:
// the sum over the faces of its star of E or, if the sharpness s is positive, of exp(s E) (eq. 6 and 7 of the paper).
// The exponents are taken relative to the largest energy of the star at its current state, which changes neither the
// minimiser nor the direction of the steps and never overflows there.
//
// This is the model of the concept `VertexEnergy_3` that a vertex update gets to see. One object serves many vertices:
// it only allocates when it meets a star larger than all before. With a packed number type it serves as many stars at
// once as that has lanes. It is used by one thread at a time, as asking it for a value leaves notes in it.
//
// Exponentials, whose operations have to wait for each other, are taken in loops of their own: the shorter a loop is,
// the more of its rounds are under way at once.
template <class Energy, class Barrier = Determinant_barrier_3, class FT = double>
class Star_energy
{
public:
  explicit Star_energy(const Energy& energy)
    : m_energy(energy)
  {}

  // The objective of the stars that come next: E is evaluated on the sphere of squared radius `squared_radius`.
  void set_objective(double squared_radius, double sharpness)
  {
    m_scale = squared_radius;
    m_sharpness = sharpness;
  }

  // Takes a star; the positions are on the unit sphere.
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
      shortest = smaller(shortest, squared_length(m_faces[j].offset));
    }
    m_faces[size].offset = m_faces[0].offset;
    m_squared_shortest_edge = shortest;

    const FT scale = m_scale;
    m_largest_energy = FT(0.);
    for(std::size_t j = 0; j < size; ++j)
    {
      Face& face = m_faces[j];
      const Vector_3<FT>&p = face.offset, &q = m_faces[j + 1].offset;
      face.fixed_i = scale * star.opposite_0(j) * squared_length(q - p); // the part of I that does not move
      face.area = Area(p, q);
      const FT i =
          face.fixed_i + scale * (star.opposite_2(j) * squared_length(p) + star.opposite_1(j) * squared_length(q));
      const FT d = unless_filling(j, scale * star.inverse_area(j) * face.area.value(), FT(1.));
      face.energy = energy_derivatives(m_energy, i, d);
      m_largest_energy = larger(m_largest_energy, face.energy.value);
    }
    if(m_sharpness > 0.)
      for(std::size_t j = 0; j < size; ++j)
        m_faces[j].weight = weight_of(j, m_faces[j].energy.value);
  }

  // the length of the shortest edge at the vertex, the yardstick of its steps
  FT shortest_edge() const { return square_root(m_squared_shortest_edge); }

  // the objective at the current position, relative to the largest energy, with its gradient and Hessian
  FT derivatives(std::array<FT, 2>& gradient, std::array<FT, 3>& hessian) const
  {
    return evaluate<true>(gradient, hessian);
  }

  // the same without the Hessian
  FT gradient(std::array<FT, 2>& gradient) const
  {
    std::array<FT, 3> unused;
    return evaluate<false>(gradient, unused);
  }

  // the objective with the vertex at the tangential coordinates (x, y), or infinity if a face is not safely positive
  // there
  FT operator()(const FT& x, const FT& y) const
  {
    auto is_valid = x * x + y * y < farthest_squared;
    const FT scale = m_scale, infinite = std::numeric_limits<double>::infinity();
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
      is_valid = is_valid && (is_safely_positive(determinant, lp + lq) || is_filling(j));
      if constexpr(std::is_same<FT, double>::value) // in lanes, to look costs more than to go on
        if(!is_valid)
          return infinite;
      const FT i = m_faces[j].fixed_i + scale * (m_star.opposite_2(j) * lp + m_star.opposite_1(j) * lq);
      const FT area = scale * m_star.inverse_area(j) * Area::value(determinant, n);
      const FT d = select(is_valid, unless_filling(j, area, FT(1.)), FT(1.)); // energies are for positive ones
      m_faces[j].new_energy = energy_value(m_energy, i, d);
    }
    if(!any(is_valid))
      return infinite;
    for(std::size_t j = 0; j < m_star.size(); ++j)
      f += m_sharpness > 0. ? weight_of(j, m_faces[j].new_energy) : unless_filling(j, m_faces[j].new_energy, FT(0.));
    return select(is_valid, f, infinite);
  }

  Vector_3<FT> point_at(const FT& x, const FT& y) const { return m_frame.point_at(x, y); }

private:
  static constexpr double farthest_squared = 0.75; // no step leaves the cap of 60 degrees around the vertex

  using Area = Image_area<Barrier, FT>;

  // what is known of face j, whose corners are the vertex and its neighbors j and j + 1
  struct Face
  {
    Vector_3<FT> offset; // of neighbor j
    Area area;
    FT fixed_i;
    Basic_energy_derivatives_3<FT> energy;
    FT weight;             // exp(s E), if the objective is that
    mutable FT new_energy; // the last one of operator()
  };

  // whether row j is beyond the end of a star
  auto is_filling(std::size_t j) const
  {
    if constexpr(std::is_same<FT, double>::value)
      return false;
    else
      return !(m_star.inverse_area(j) > 0.);
  }
  FT unless_filling(std::size_t j, const FT& value, const FT& otherwise) const
  {
    if constexpr(std::is_same<FT, double>::value)
      return value;
    else
      return select(is_filling(j), otherwise, value);
  }

  // what a face adds to the sum of exp(s E)
  FT weight_of(std::size_t j, const FT& energy) const
  {
    const FT sharpness = m_sharpness;
    return unless_filling(j, exponential(sharpness * (energy - m_largest_energy)), FT(0.));
  }

  template <bool with_hessian>
  FT evaluate(std::array<FT, 2>& gradient, std::array<FT, 3>& hessian) const
  {
    const FT scale = m_scale, sharpness = m_sharpness;
    FT f = 0., gx = 0., gy = 0., hxx = 0., hxy = 0., hyy = 0.;
    for(std::size_t j = 0; j < m_star.size(); ++j)
    {
      const Vector_3<FT>&p = m_faces[j].offset, &q = m_faces[j + 1].offset;
      const Area& area = m_faces[j].area;
      const Basic_energy_derivatives_3<FT>& e = m_faces[j].energy;
      const FT to_p = 2. * scale * m_star.opposite_2(j), to_q = 2. * scale * m_star.opposite_1(j);
      const FT ix = -(to_p * p[0] + to_q * q[0]), iy = -(to_p * p[1] + to_q * q[1]);
      const FT to_d = scale * m_star.inverse_area(j);
      const FT dx = to_d * area.dx(), dy = to_d * area.dy();
      FT ex = e.i * ix + e.d * dx, ey = e.i * iy + e.d * dy;
      FT exx = 0., exy = 0., eyy = 0.;
      if constexpr(with_hessian)
      {
        const FT i2 = to_p * (1. + p[2]) + to_q * (1. + q[2]);
        exx = e.i * i2 + e.d * (to_d * area.dxx()) + e.ii * ix * ix + 2. * e.id * ix * dx + e.dd * dx * dx;
        exy = e.ii * ix * iy + e.id * (ix * dy + iy * dx) + e.dd * dx * dy;
        eyy = e.i * i2 + e.d * (to_d * area.dyy()) + e.ii * iy * iy + 2. * e.id * iy * dy + e.dd * dy * dy;
        if constexpr(Area::has_dxy)
          exy += e.d * (to_d * area.dxy());
      }
      // The rest shape of a filling row is 0, and so are its derivatives.
      if(m_sharpness > 0.)
      {
        const FT& w = m_faces[j].weight;
        const FT ws = w * sharpness;
        f += w;
        if constexpr(with_hessian)
        {
          exx = ws * (exx + sharpness * ex * ex);
          exy = ws * (exy + sharpness * ex * ey);
          eyy = ws * (eyy + sharpness * ey * ey);
        }
        ex *= ws;
        ey *= ws;
      }
      else
        f += unless_filling(j, e.value, FT(0.));
      gx += ex;
      gy += ey;
      hxx += exx;
      hxy += exy;
      hyy += eyy;
    }
    gradient = {gx, gy};
    hessian = {hxx, hxy, hyy};
    return f;
  }

  Energy m_energy;
  double m_scale = 1., m_sharpness = 0.;

  Star_view<FT> m_star;
  Basic_tangent_frame<FT> m_frame = Basic_tangent_frame<FT>({FT(0.), FT(0.), FT(1.)});
  std::vector<Face> m_faces;
  FT m_squared_shortest_edge = 0., m_largest_energy = 0.;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STAR_ENERGY_H
