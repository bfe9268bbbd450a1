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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_VERTEX_STEP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_VERTEX_STEP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>

#include <array>
#include <cmath>
#include <limits>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The steps of block coordinate descent: how a vertex moves, and how its energy measures an image. A step sets `step`
// to the tangential coordinates of the new position, where the energy of the star is finite and lower, and returns
// whether there is such a position.

// One damped Newton step. The 2 x 2 Hessian in the tangent plane is made positive definite by taking the absolute
// values of its eigenvalues. The step is first tried at `over_relaxation` times its length, which makes block
// coordinate descent propagate changes over the surface many times faster, then at its own length, then at fractions of
// it until the energy decreases sufficiently (Armijo's rule). It needs two evaluations of the star, where the gradient
// step of the paper needs more than ten, and far fewer sweeps.
class Newton_step
{
public:
  template <class FT>
  using Image_measure = Determinant_measure<FT>;

  // Whether several vertices can be moved at once, in lanes.
  static constexpr bool is_lanewise = true;

  // At most `max_lengths` lengths are tried besides the first one: by default, down to 1/2048 of the step.
  explicit Newton_step(double over_relaxation = 1.7, int max_lengths = 12)
    : m_over_relaxation(over_relaxation)
    , m_max_lengths(max_lengths)
  {}

  template <class StarEnergy, class FT>
  auto operator()(const StarEnergy& energy, std::array<FT, 2>& step) const
  {
    std::array<FT, 2> g;
    std::array<FT, 3> h;
    const FT start = energy.derivatives(g, h);
    // The eigenvalues are mean + radius and mean - radius. H = mean * 1 + D with D trace-free and D^2 = radius^2 * 1,
    // so |H|^{-1} follows without eigenvectors.
    const FT mean = 0.5 * (h[0] + h[2]), half = 0.5 * (h[0] - h[2]);
    const FT radius = square_root(half * half + h[1] * h[1]);
    const FT largest = absolute(mean) + radius;
    const FT sign = select(mean < 0., FT(-1.), FT(1.));
    const FT smallest = maximum(absolute(absolute(mean) - radius), min_ratio * largest);
    // The inverse has the eigenvalue 1 / largest in the direction of the eigenvalue of larger modulus, and 1 / smallest
    // orthogonal to it.
    const FT middle = 0.5 * (1. / largest + 1. / smallest);
    const FT spread = select(radius > min_radius, sign * 0.5 * (1. / largest - 1. / smallest) * (1. / radius), FT(0.));
    const FT x = -(middle * g[0] + spread * (half * g[0] + h[1] * g[1]));
    const FT y = -(middle * g[1] + spread * (h[1] * g[0] - half * g[1]));
    const FT slope = g[0] * x + g[1] * y;
    const FT shortest = min_step * energy.shortest_edge();
    auto is_open = largest > 0. && largest < std::numeric_limits<double>::infinity() && slope < 0. &&
                   x * x + y * y > shortest * shortest;
    auto is_moved = is_open && !is_open;
    std::array<FT, 2> accepted = {FT(0.), FT(0.)};
    // Near the minimum, the gain of a step is of second order and may be below rounding error.
    const FT rounding = 1e-14 * absolute(start);
    const auto is_tiny = -slope < rounding;
    const auto try_step = [&](double t, const FT& bound) {
      const FT tx = t * x, ty = t * y;
      const auto is_accepted = is_open && energy(tx, ty) < select(is_tiny, start + rounding, bound);
      accepted = {select(is_accepted, tx, accepted[0]), select(is_accepted, ty, accepted[1])};
      is_moved = is_moved || is_accepted;
      is_open = is_open && !is_accepted;
    };
    if(any(is_open))
      try_step(m_over_relaxation, start);
    double t = 1.;
    for(int k = 0; k < m_max_lengths && any(is_open); ++k, t *= 0.5)
      try_step(t, start + armijo * t * slope);
    if(any(is_moved))
      step = accepted;
    return is_moved;
  }

private:
  static constexpr double min_ratio = 1e-3; // of the eigenvalues: a flat direction lengthens a step at most 1000-fold
  static constexpr double min_radius = (std::numeric_limits<double>::min)(); // whose reciprocal is finite
  static constexpr double min_step = 1e-10; // in units of the shortest edge; shorter steps are not worth an evaluation
  static constexpr double armijo = 1e-4; // the usual constant of sufficient decrease (Nocedal and Wright, section 3.1)

  double m_over_relaxation;
  int m_max_lengths; // after which the vertex waits for the next sweep
};

// The step of the BLD paper, eq. 8: gradient descent on the flat areas. The trial step is as long as the shortest edge
// at the vertex. It is projected to the sphere and multiplied by 0.8 until the energy decreases and no face of the star
// is inverted. If the step becomes shorter than 1e-10 of that edge, the vertex does not move. (The paper does not say
// what its 1e-10 is relative to; an absolute length would freeze all parts that the initial map has shrunk to such a
// size.)
class Gradient_step
{
public:
  template <class FT>
  using Image_measure = Flat_measure<FT>;

  static constexpr bool is_lanewise = false;

  template <class StarEnergy>
  bool operator()(const StarEnergy& energy, std::array<double, 2>& step) const
  {
    std::array<double, 2> g;
    const double start = energy.gradient(g);
    const double size = std::sqrt(g[0] * g[0] + g[1] * g[1]);
    if(!(size > 0.) || !(size < std::numeric_limits<double>::infinity()))
      return false;
    const double edge = energy.shortest_edge();
    for(double t = edge; t >= min_step * edge; t *= shrinking)
    {
      const double scale =
          -t / (size * std::sqrt(1. + t * t)); // the tangential component after the projection to the sphere
      const double x = scale * g[0], y = scale * g[1];
      if(energy(x, y) < start)
      {
        step = {x, y};
        return true;
      }
    }
    return false;
  }

private:
  static constexpr double shrinking = 0.8;
  static constexpr double min_step = 1e-10; // in units of the shortest edge
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_VERTEX_STEP_H
