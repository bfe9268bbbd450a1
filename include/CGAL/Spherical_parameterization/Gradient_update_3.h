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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_GRADIENT_UPDATE_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_GRADIENT_UPDATE_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <array>
#include <cmath>
#include <limits>

/// \file Gradient_update_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationUpdates
///
/// The class `Gradient_update_3` moves a vertex by one step of gradient descent on the energy of its star, as the BLD
/// paper does.
///
/// The step, eq. 8 of \cgalCite{cgal:whfl-bspld-16}, is as long as the shortest edge at the vertex at first, is
/// projected to the sphere, and is shortened to 0.8 of its length until the energy falls and no face of the star is
/// inverted; a vertex whose step gets shorter than 1e-10 of that edge stays. (The paper does not say what its 1e-10 is
/// relative to; an absolute length would freeze all that the initial map has shrunk to such a size.)
///
/// \cgalModels{VertexUpdate_3}
///
/// \sa `Newton_update_3`
class Gradient_update_3
{
public:
  /// computes the step of one vertex from its tangent plane's origin.
  ///
  /// \tparam VertexEnergy a model of `VertexEnergy_3`
  ///
  /// \param energy the energy of the star as a function of the vertex
  /// \param step the tangential coordinates that the vertex shall move to; untouched if it shall stay
  ///
  /// \return whether the vertex shall move; if so, the energy at `step` is finite and lower than at the origin
  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const
  {
    std::array<double, 2> g;
    const double start = energy.gradient(g);
    const double size = std::sqrt(g[0] * g[0] + g[1] * g[1]);
    if(!(size > 0.) || !(size < std::numeric_limits<double>::infinity()))
      return false;
    const double edge = energy.shortest_edge();
    for(double t = edge; t >= least_step * edge; t *= shrinking)
    {
      const double scale =
          -t / (size * std::sqrt(1. + t * t)); // the tangential part after the projection to the sphere
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
  static constexpr double least_step = 1e-10; // in units of the shortest edge
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_GRADIENT_UPDATE_3_H
