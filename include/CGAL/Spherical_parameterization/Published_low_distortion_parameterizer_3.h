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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PUBLISHED_LOW_DISTORTION_PARAMETERIZER_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PUBLISHED_LOW_DISTORTION_PARAMETERIZER_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Absolute_sharpness_3.h>
#include <CGAL/Spherical_parameterization/Area_balancing_radius_3.h>
#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Bijective_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Flat_area_barrier_3.h>
#include <CGAL/Spherical_parameterization/Gradient_update_3.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Two_phase_radius_3.h>

#include <CGAL/Default.h>

#include <type_traits>

/// \file Published_low_distortion_parameterizer_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMethods
///
/// The class `Published_low_distortion_parameterizer_3` is BLD as it was published \cgalCite{cgal:whfl-bspld-16},
/// without any of the changes of `Bijective_low_distortion_parameterizer_3`: the yardstick that they are measured with,
/// not a method to prefer.
///
/// It starts from a harmonic map, makes 100 sweeps of eq. 6 with the isometric energy, in which faces count with their
/// flat area, then sweeps of eq. 7 with \f$ s \f$ growing from 0.1 to 10, and 2000 sweeps in all at most. Each vertex
/// makes one step of gradient descent (eq. 8) per sweep. The radius follows eq. 9 until the sum changes by at most 1e-5
/// and the radius by at most 1e-3 in a sweep, both relative, and eq. 11 until they do so again.
///
/// The guarantee is that of `Bijective_low_distortion_parameterizer_3`.
///
/// \cgalModels{SphericalParameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceListGraph`.
/// \tparam InitialParameterizer_ must be a model of `SphericalParameterizer_3`.<br> <b>%Default:</b>
/// \code
///   Harmonic_parameterizer_3<TriangleMesh_>
/// \endcode
/// \tparam Sharpness_ must be a model of `SharpnessPolicy_3`.<br> <b>%Default:</b>
/// \code
///   Absolute_sharpness_3
/// \endcode
/// \tparam Radius_ must be a model of `SphereRadiusPolicy_3`.<br> <b>%Default:</b>
/// \code
///   Two_phase_radius_3<>
/// \endcode
template <class TriangleMesh_, class InitialParameterizer_ = Default, class Sharpness_ = Default,
          class Radius_ = Default>
class Published_low_distortion_parameterizer_3
  : public Bijective_low_distortion_parameterizer_3<
        TriangleMesh_, typename Default::Get<InitialParameterizer_, Harmonic_parameterizer_3<TriangleMesh_>>::type,
        Isometric_energy_3, typename Default::Get<Sharpness_, Absolute_sharpness_3>::type,
        typename Default::Get<Radius_, Two_phase_radius_3<>>::type, Gradient_update_3, Flat_area_barrier_3>
{
  using Base = Bijective_low_distortion_parameterizer_3<
      TriangleMesh_, typename Default::Get<InitialParameterizer_, Harmonic_parameterizer_3<TriangleMesh_>>::type,
      Isometric_energy_3, typename Default::Get<Sharpness_, Absolute_sharpness_3>::type,
      typename Default::Get<Radius_, Two_phase_radius_3<>>::type, Gradient_update_3, Flat_area_barrier_3>;

public:
  /// Initial parameterizer type
  using Initial_parameterizer = typename Base::Initial_parameterizer;
  /// Sharpness type
  using Sharpness = typename Base::Sharpness;
  /// Radius policy type
  using Radius = typename Base::Radius;

  /// constructs the parameterizer with the settings of the paper, or with those given instead.
  ///
  /// \param initial_parameterizer makes the map to start with
  /// \param sharpness the sharpness policy, by default `Absolute_sharpness_3(0.1, 10., 100)`, or what a policy of
  ///        another type is by default
  /// \param radius the radius policy, by default `Two_phase_radius_3<>` with the tolerance 0, or what a policy of
  ///        another type is by default
  explicit Published_low_distortion_parameterizer_3(
      const Initial_parameterizer& initial_parameterizer = Initial_parameterizer(),
      const Sharpness& sharpness = default_sharpness(), const Radius& radius = default_radius())
    : Base(initial_parameterizer, Isometric_energy_3(), sharpness, radius, Gradient_update_3())
  {
    Base::set_number_of_iterations(2000);
    Base::set_tolerances(1e-5, 1e-3);
    Base::set_acceleration(false);
  }

private:
  static Sharpness default_sharpness()
  {
    if constexpr(std::is_same<Sharpness, Absolute_sharpness_3>::value)
      return Absolute_sharpness_3(0.1, 10., 100);
    else
      return Sharpness();
  }

  static Radius default_radius()
  {
    using Written_out = Two_phase_radius_3<Area_preserving_radius_3, Area_balancing_radius_3>;
    if constexpr(std::is_same<Radius, Two_phase_radius_3<>>::value || std::is_same<Radius, Written_out>::value)
      return Radius(Area_preserving_radius_3(), Area_balancing_radius_3(), 0.);
    else
      return Radius();
  }
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PUBLISHED_LOW_DISTORTION_PARAMETERIZER_3_H
