// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_UPDATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_UPDATE_H

#include "Copy_constructible.h"

#include <array>

namespace archetypes {

// VertexUpdate_3 without the optional members. It makes use of all that it is promised of the energy of a vertex.
class Vertex_update : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const
  {
    std::array<double, 2> gradient, same_gradient;
    std::array<double, 3> hessian;
    const double start = energy.derivatives(gradient, hessian);
    if(energy.gradient(same_gradient) > 2. * start)
      return false;
    const double curvature = hessian[0] + hessian[2];
    const double longest = 0.1 * energy.shortest_edge();
    for(double t = 1. / curvature; t > 1e-3 / curvature; t *= 0.5)
    {
      const double x = -t * gradient[0], y = -t * gradient[1];
      if(x * x + y * y < longest * longest && energy(x, y) < start)
      {
        step = {x, y};
        return true;
      }
    }
    return false;
  }
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_UPDATE_H
