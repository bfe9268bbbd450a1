// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STAR_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STAR_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/Image_area.h>
#include <CGAL/Spherical_parameterization/internal/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/Tangent_frame.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/is_safely_positive.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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
// it only allocates when it meets a star larger than all before.
template <class Energy, class Barrier = Determinant_barrier_3>
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

  // Takes the star of the vertex at `center`: its ring, the positions on the unit sphere and the rest shapes of its
  // faces; rest[j] belongs to the face (center, ring[j], ring[j + 1]) in this order of corners.
  void load(const Vector_3d& center, const Vertex_rings::Ring& ring, const Vector_3d* positions,
            const Rest_triangle* rest)
  {
    m_frame = Tangent_frame(center);
    m_size = ring.size();
    m_rest = rest;
    if(m_offsets.size() <= m_size)
    {
      m_offsets.resize(2 * m_size + 1);
      m_terms.resize(2 * m_size + 1);
    }
    double shortest = std::numeric_limits<double>::infinity();
    for(std::size_t j = 0; j < m_size; ++j)
    {
      m_offsets[j] = m_frame.offset_of(positions[ring[j]]);
      shortest = (std::min)(shortest, squared_length(m_offsets[j]));
    }
    m_offsets[m_size] = m_offsets[0];
    m_shortest_edge = std::sqrt(shortest);

    m_largest_energy = 0.;
    for(std::size_t j = 0; j < m_size; ++j)
    {
      const Vector_3d &p = m_offsets[j], &q = m_offsets[j + 1];
      const Rest_triangle& r = rest[j];
      Term& t = m_terms[j];
      t.fixed_i = m_scale * r.opposite_0 * squared_length(q - p); // the part of I that does not move
      t.area = Area(p, q);
      const double squared_p = squared_length(p), squared_q = squared_length(q);
      t.i = t.fixed_i + m_scale * (r.opposite_2 * squared_p + r.opposite_1 * squared_q);
      t.d = m_scale * r.inverse_area * t.area.value();
      m_largest_energy = (std::max)(m_largest_energy, m_energy(t.i, t.d));
    }
  }

  // the length of the shortest edge at the vertex, the yardstick of its steps
  double shortest_edge() const { return m_shortest_edge; }

  // the objective at the current position, relative to the largest energy, with its gradient and Hessian
  double derivatives(std::array<double, 2>& gradient, std::array<double, 3>& hessian) const
  {
    return evaluate<true>(gradient, hessian);
  }

  // the same without the Hessian
  double gradient(std::array<double, 2>& gradient) const
  {
    std::array<double, 3> unused;
    return evaluate<false>(gradient, unused);
  }

  // the objective with the vertex at the tangential coordinates (x, y), or infinity if a face is not safely positive
  // there
  double operator()(double x, double y) const
  {
    if(!(x * x + y * y < farthest_squared))
      return std::numeric_limits<double>::infinity();
    const double z = Tangent_frame::height_at(x, y);
    double f = 0.;
    for(std::size_t j = 0; j < m_size; ++j)
    {
      const Vector_3d to_p = {m_offsets[j][0] - x, m_offsets[j][1] - y, m_offsets[j][2] - z};
      const Vector_3d to_q = {m_offsets[j + 1][0] - x, m_offsets[j + 1][1] - y, m_offsets[j + 1][2] - z};
      const Vector_3d n = cross(to_p, to_q);
      const double determinant = x * n[0] + y * n[1] + (1. + z) * n[2];
      const double lp = squared_length(to_p), lq = squared_length(to_q);
      if(!is_safely_positive(determinant, lp + lq))
        return std::numeric_limits<double>::infinity();
      const Rest_triangle& r = m_rest[j];
      const double i = m_terms[j].fixed_i + m_scale * (r.opposite_2 * lp + r.opposite_1 * lq);
      const double e = m_energy(i, m_scale * r.inverse_area * Area::value(determinant, n));
      f += m_sharpness > 0. ? std::exp(m_sharpness * (e - m_largest_energy)) : e;
    }
    return f;
  }

  Vector_3d point_at(double x, double y) const { return m_frame.point_at(x, y); }

private:
  static constexpr double farthest_squared = 0.75; // no step leaves the cap of 60 degrees around the vertex

  using Area = Image_area<Barrier>;

  struct Term
  {
    Area area;
    double fixed_i, i, d;
  };

  template <bool with_hessian>
  double evaluate(std::array<double, 2>& gradient, std::array<double, 3>& hessian) const
  {
    double f = 0., gx = 0., gy = 0., hxx = 0., hxy = 0., hyy = 0.;
    for(std::size_t j = 0; j < m_size; ++j)
    {
      const Vector_3d &p = m_offsets[j], &q = m_offsets[j + 1];
      const Rest_triangle& r = m_rest[j];
      const Term& t = m_terms[j];
      const double to_p = 2. * m_scale * r.opposite_2, to_q = 2. * m_scale * r.opposite_1;
      const double ix = -(to_p * p[0] + to_q * q[0]), iy = -(to_p * p[1] + to_q * q[1]);
      const double to_d = m_scale * r.inverse_area;
      const double dx = to_d * t.area.dx(), dy = to_d * t.area.dy();
      const Energy_derivatives_3 e = m_energy.derivatives(t.i, t.d);
      double ex = e.i * ix + e.d * dx, ey = e.i * iy + e.d * dy;
      double exx = 0., exy = 0., eyy = 0.;
      if constexpr(with_hessian)
      {
        const double i2 = to_p * (1. + p[2]) + to_q * (1. + q[2]);
        exx = e.i * i2 + e.d * (to_d * t.area.dxx()) + e.ii * ix * ix + 2. * e.id * ix * dx + e.dd * dx * dx;
        exy = e.ii * ix * iy + e.id * (ix * dy + iy * dx) + e.dd * dx * dy;
        eyy = e.i * i2 + e.d * (to_d * t.area.dyy()) + e.ii * iy * iy + 2. * e.id * iy * dy + e.dd * dy * dy;
        if constexpr(Area::has_dxy)
          exy += e.d * (to_d * t.area.dxy());
      }
      if(m_sharpness > 0.)
      {
        const double w = std::exp(m_sharpness * (e.value - m_largest_energy));
        const double ws = w * m_sharpness;
        f += w;
        if constexpr(with_hessian)
        {
          exx = ws * (exx + m_sharpness * ex * ex);
          exy = ws * (exy + m_sharpness * ex * ey);
          eyy = ws * (eyy + m_sharpness * ey * ey);
        }
        ex *= ws;
        ey *= ws;
      }
      else
        f += e.value;
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

  Tangent_frame m_frame = Tangent_frame({0., 0., 1.});
  std::size_t m_size = 0;
  const Rest_triangle* m_rest = nullptr;
  std::vector<Vector_3d> m_offsets;
  std::vector<Term> m_terms;
  double m_shortest_edge = 0., m_largest_energy = 0.;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STAR_ENERGY_H
