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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_FACE_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_FACE_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <cstddef>
#include <type_traits>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Whether both functions of an energy accept lanes of numbers. An energy for `double` only is called for each lane in
// turn.
template <class Energy, class FT>
using Energy_in_lanes =
    std::void_t<decltype(std::declval<const Energy&>()(std::declval<const FT&>(), std::declval<const FT&>())),
                decltype(std::declval<const Energy&>().derivatives(std::declval<const FT&>(),
                                                                   std::declval<const FT&>()))>;
template <class Energy, class FT>
constexpr bool is_lanewise = is_detected<Energy_in_lanes, Energy, FT>;

// The energy of a face as evaluated by the descent: in one lane or several. If the weight of the guard is positive,
// this multiple of the area distortion d + 1 / d is added. It keeps faces from shrinking without bound where the energy
// itself does not penalize this.
template <class Energy>
class Face_energy
{
public:
  static constexpr bool weighs_faces_by_area = internal::weighs_faces_by_area<Energy>;

  explicit Face_energy(const Energy& energy, double guard = 0.)
    : m_energy(energy)
    , m_guard(guard)
  {}

  const Energy& energy() const { return m_energy; }
  bool is_guarded() const { return m_guard > 0.; }

  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    FT value;
    if constexpr(is_lanewise<Energy, FT>)
      value = m_energy(i, d);
    else
      value = FT::generate([&](std::size_t k) { return m_energy(lane(i, k), lane(d, k)); });
    if(is_guarded())
      value += m_guard * (d + 1. / d);
    return value;
  }

  template <class FT>
  Energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    Energy_derivatives_3<FT> e = derivatives_in_lanes(i, d);
    if(is_guarded())
    {
      const FT inverse_d = 1. / d;
      e.value += m_guard * (d + inverse_d);
      e.d += m_guard * (1. - inverse_d * inverse_d);
      e.dd += 2. * m_guard * inverse_d * inverse_d * inverse_d;
    }
    return e;
  }

private:
  template <class FT>
  Energy_derivatives_3<FT> derivatives_in_lanes(const FT& i, const FT& d) const
  {
    if constexpr(is_lanewise<Energy, FT>)
      return m_energy.derivatives(i, d);
    else
    {
      using Derivatives = Energy_derivatives_3<double>;
      Derivatives e[FT::width];
      for(std::size_t k = 0; k < FT::width; ++k)
        e[k] = m_energy.derivatives(lane(i, k), lane(d, k));
      const auto all = [&](auto member) { return FT::generate([&](std::size_t k) { return e[k].*member; }); };
      return {all(&Derivatives::value), all(&Derivatives::i),  all(&Derivatives::d),
              all(&Derivatives::ii),    all(&Derivatives::id), all(&Derivatives::dd)};
    }
  }

  Energy m_energy;
  double m_guard;
};

// The doubled area of the image of a face (x, p, q), as measured by the energy, as a function of its corner x. All
// corners are offsets from one point of the unit sphere, in the frame of that point; the center of the sphere is at (0,
// 0, -1).
//
// This measure is the determinant of the corners: the doubled area of the flat triangle times the distance of its plane
// from the center. It agrees with the flat area for small faces, and is 0 exactly where the face becomes inverted.
// There the energy is a barrier, so no face can get stuck across a great circle.
template <class FT>
class Determinant_measure
{
public:
  // The value at x = 0.
  Determinant_measure(const Vector_3<FT>& p, const Vector_3<FT>& q)
  {
    // The normal p x q of the plane through p, q and the center. Since p and q are offsets of the size of the edge,
    // there is no cancellation.
    const Vector_3<FT> n = cross(p, q);
    m_gradient = {n[0] + (p[1] - q[1]), n[1] + (q[0] - p[0]), n[2]};
  }
  Determinant_measure() = default;

  FT value() const { return m_gradient[2]; }
  FT dx() const { return m_gradient[0]; }
  FT dy() const { return m_gradient[1]; }
  // Since x = (x, y, -(x^2 + y^2) / 2), up to higher order, the second derivatives follow from the height.
  FT dxx() const { return -m_gradient[2]; }
  FT dyy() const { return -m_gradient[2]; }

  // The value at x, given the determinant and the normal (p - x) x (q - x) there.
  static FT value(const FT& determinant, const Vector_3<FT>& /* normal */) { return determinant; }

private:
  Vector_3<FT> m_gradient;
};

// The doubled area of the flat triangle, as in eq. 4 and 5 of the paper. It is positive for inverted faces as well, so
// only the test in every step prevents inversions, and faces may get stuck across a great circle. It is used with
// gradient steps, and has no second derivatives.
template <class FT>
class Flat_measure
{
public:
  Flat_measure(const Vector_3<FT>& p, const Vector_3<FT>& q)
  {
    // The normal (p - x) x (q - x) has the derivative dx x (p - q).
    const Vector_3<FT> n = cross(p, q), w = p - q;
    const Vector_3<FT> nx = {FT(0.), -w[2], w[1]}, ny = {w[2], FT(0.), -w[0]};
    m_value = length(n);
    const FT inverse = select(m_value > 0., 1. / m_value, FT(0.)); // the direction is undefined if the area is 0
    m_dx = inverse * dot(n, nx);
    m_dy = inverse * dot(n, ny);
  }
  Flat_measure() = default;

  FT value() const { return m_value; }
  FT dx() const { return m_dx; }
  FT dy() const { return m_dy; }

  static FT value(const FT& /* determinant */, const Vector_3<FT>& normal) { return length(normal); }

private:
  FT m_value, m_dx, m_dy;
};

// The contribution of a face to the objective, as a function of its energy E:
//   psi(E) = (1 - a) E + (a / s) exp(s (E - R)),   psi' = (1 - a) + a exp(s (E - R)),
// or E for s = 0. Eq. 6 of the paper is s = 0. Eq. 7 is a = 1, where R only contributes a constant factor.
struct Face_objective
{
  Face_objective() = default;
  // Eq. 6 or 7; implicit, because a sharpness determines such an objective.
  Face_objective(double s)
    : sharpness(s)
  {}

  bool is_average() const { return !(sharpness > 0.); }
  bool has_level() const { return share < 1.; }

  // The factor of d. The image of a face is measured by the determinant of its corners, which is the doubled area times
  // the distance of its plane from the center. For an isometric image with the circumradius c on the unit sphere, where
  // the surface has the area of the sphere, this distance is 1 - c^2 / 2 + ..., and c^2 is a ninth of the sum of the
  // squared edges of an equilateral face. With this factor, isometric images have d = 1 up to higher order on coarse
  // meshes as well. The factor is bounded, because images of faces are bounded, unlike the faces of coarse and long
  // surfaces.
  template <class FT>
  FT area_factor(const FT& opposite_0, const FT& opposite_1, const FT& opposite_2, const FT& doubled_area) const
  {
    constexpr double max_correction = 4.; // at most five times the determinant
    const FT correction = area_correction * (opposite_0 + opposite_1 + opposite_2) * doubled_area * doubled_area;
    return 1. + minimum(correction, FT(max_correction));
  }

  double share = 1.;     // a
  double sharpness = 0.; // s
  double level = 0.;     // R
  double area_correction = 0.;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_FACE_ENERGY_H
