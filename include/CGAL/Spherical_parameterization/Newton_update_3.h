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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_NEWTON_UPDATE_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_NEWTON_UPDATE_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Packed_double.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <limits>

/// \file Newton_update_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationUpdates
///
/// The class `Newton_update_3` moves a vertex by one damped Newton step on the energy of its star. The two by two
/// Hessian in the tangent plane is made positive definite by taking the absolute values of its eigenvalues. The step is
/// first tried at `over_relaxation` times its length, which makes block coordinate descent carry changes over the
/// surface many times faster, then at its own length, then at fractions of it until the energy falls (Armijo's rule).
///
/// Compared to the gradient step of the paper (eq. 8) it needs two evaluations of the star instead of over ten, and far
/// fewer sweeps. Where the compiler and the processor have vector registers, it moves several vertices in one call, with
/// the same result as one after the other.
///
/// \cgalModels{VertexUpdate_3}
class Newton_update_3
{
public:
#ifndef DOXYGEN_RUNNING
  using Is_lanewise = Tag_true;
#endif

  /// constructs the update.
  ///
  /// \param over_relaxation the factor by which a step is prolonged at first, from 1 (not at all) to below 2; see also
  ///        `on_coarse_levels()`
  explicit Newton_update_3(double over_relaxation = 1.9)
    : m_over_relaxation(over_relaxation)
  {}

  /// returns the factor by which a step is prolonged at first.
  double over_relaxation() const
  {
    return m_over_relaxation;
  }

  /// returns whether the factor is in its range.
  bool is_valid() const
  {
    return m_over_relaxation >= 1. && m_over_relaxation < 2.;
  }

  /// returns the update for the levels of a hierarchy that are coarser than the mesh: one that prolongs steps by 1.7 at
  /// most. Where a vertex has many thousands of neighbours, longer ones throw these into a disorder that no later sweep
  /// undoes; and to carry changes far is what the levels themselves are for.
  Newton_update_3 on_coarse_levels() const
  {
    return Newton_update_3((std::min)(m_over_relaxation, largest_factor_on_coarse_levels));
  }

  /// computes the step of one vertex from its tangent plane's origin.
  ///
  /// \tparam VertexEnergy a model of `VertexEnergy_3`
  ///
  /// \param energy the energy of the star as a function of the vertex
  /// \param step the tangential coordinates that the vertex shall move to; untouched if it shall stay
  ///
  /// \return whether the vertex shall move; if so, the energy at `step` is finite and lower than at the origin
#ifdef DOXYGEN_RUNNING
  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const;
#else
  template <class VertexEnergy, class FT>
  auto operator()(const VertexEnergy& energy, std::array<FT, 2>& step) const
  {
    using namespace internal; // what is said of a number, or of several in lanes

    std::array<FT, 2> g;
    std::array<FT, 3> h;
    const FT start = energy.derivatives(g, h);

    // The eigenvalues are mean + radius and mean - radius. H = mean * 1 + D with D trace-free and D^2 = radius^2 * 1,
    // so |H|^{-1} follows without eigenvectors.
    const FT mean = 0.5 * (h[0] + h[2]), half = 0.5 * (h[0] - h[2]);
    const FT radius = square_root(half * half + h[1] * h[1]);
    const FT largest = absolute(mean) + radius;
    const FT sign = select(mean < 0., FT(-1.), FT(1.));
    const FT smallest = larger(absolute(absolute(mean) - radius), least_ratio * largest);
    // In the direction of the eigenvalue of larger modulus the inverse is 1 / largest, across it 1 / smallest.
    const FT middle = 0.5 * (1. / largest + 1. / smallest);
    const FT spread =
        select(radius > least_radius, sign * 0.5 * (1. / largest - 1. / smallest) * (1. / radius), FT(0.));
    const FT x = -(middle * g[0] + spread * (half * g[0] + h[1] * g[1]));
    const FT y = -(middle * g[1] + spread * (h[1] * g[0] - half * g[1]));

    const FT slope = g[0] * x + g[1] * y;
    const FT least = least_step * energy.shortest_edge();
    auto is_open = largest > 0. && largest < std::numeric_limits<double>::infinity() && slope < 0. &&
                   x * x + y * y > least * least;
    auto is_moved = is_open && !is_open;
    std::array<FT, 2> accepted = {FT(0.), FT(0.)};
    const auto try_step = [&](double t, const FT& bound) {
      const FT tx = t * x, ty = t * y;
      const auto is_accepted = is_open && energy(tx, ty) < bound;
      accepted = {select(is_accepted, tx, accepted[0]), select(is_accepted, ty, accepted[1])};
      is_moved = is_moved || is_accepted;
      is_open = is_open && !is_accepted;
    };
    if(m_over_relaxation > 1. && any(is_open))
      try_step(m_over_relaxation, start);
    double t = 1.;
    for(int k = 0; k < most_halvings && any(is_open); ++k, t *= 0.5)
      try_step(t, start + armijo * t * slope);
    if(any(is_moved))
      step = accepted;
    return is_moved;
  }
#endif

private:
  static constexpr double largest_factor_on_coarse_levels = 1.7;
  static constexpr double least_ratio = 1e-3; // of the eigenvalues that a step is computed from
  static constexpr double least_radius = (std::numeric_limits<double>::min)(); // whose reciprocal is finite
  static constexpr double least_step = 1e-9; // in units of the shortest edge; shorter ones are not worth an evaluation
  static constexpr double armijo = 1e-4;
  static constexpr int most_halvings = 12;

  double m_over_relaxation;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_NEWTON_UPDATE_3_H
