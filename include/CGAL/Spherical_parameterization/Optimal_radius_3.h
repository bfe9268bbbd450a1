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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_OPTIMAL_RADIUS_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_OPTIMAL_RADIUS_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/policy_traits.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <cmath>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationRadius
///
/// The class `Optimal_radius_3` minimizes the sum of the energies of the faces over the radius. Each energy is weighted
/// by the area of its face on the surface if the energy weighs faces by area.
///
/// If the energy has a member function `optimal_scale(faces)`, as most energies of the package do, that function is
/// called. For any other energy, at most 20 damped Newton steps in the logarithm of the radius are made.
///
/// \cgalModels{SphereRadiusPolicy_3}
class Optimal_radius_3
{
public:
  /// returns the initial radius `equal_area_radius`, which gives the sphere the area of the surface.
  double initial_radius(double equal_area_radius) const { return equal_area_radius; }

  /// returns the radius that follows `radius`, in linear time.
  template <class Energy>
  double operator()(const Energy& energy, const Face_range_3& faces, double radius)
  {
    if constexpr(internal::is_detected<internal::Optimal_scale_result, Energy, Face_range_3>)
      return radius * energy.optimal_scale(faces);
    else
      return radius * newton_scale(energy, faces);
  }

private:
  // minimizes sum E(q^2 I, q^2 d) over t = log q
  template <class Energy>
  static double newton_scale(const Energy& energy, const Face_range_3& faces)
  {
    constexpr int max_steps = 20;
    constexpr double longest_step = 0.5, tolerance = 1e-10; // a factor of 1.65; ten digits, as sweeps change it anyway
    double t = 0.;
    for(int k = 0; k < max_steps; ++k)
    {
      const double q2 = internal::exponential(2. * t);
      double first = 0., second = 0., size = 0.;
      for(const auto& face : faces)
      {
        const double i = q2 * face.i, d = q2 * face.d;
        const Energy_derivatives_3<> e = energy.derivatives(i, d);
        const double weight = internal::weighs_faces_by_area<Energy> ? face.area : 1.;
        const double slope = 2. * (e.i * i + e.d * d); // dI/dt = 2 I and dd/dt = 2 d
        first += weight * slope;
        size += weight * 2. * (std::abs(e.i * i) + std::abs(e.d * d));
        second += weight * (2. * slope + 4. * (e.ii * i * i + 2. * e.id * i * d + e.dd * d * d));
      }
      if(!(std::abs(first) > tolerance * size)) // the minimum, or an energy that does not depend on the radius
        break;
      double step = second > 0. ? -first / second : (first > 0. ? -longest_step : longest_step);
      step = (std::min)((std::max)(step, -longest_step), longest_step);
      t += step;
      if(!(std::abs(step) > tolerance))
        break;
    }
    return internal::exponential(t);
  }
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_OPTIMAL_RADIUS_3_H
