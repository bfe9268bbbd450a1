// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_ENERGY_H

#include "Copy_constructible.h"

#include <array>

namespace archetypes {

// VertexEnergy_3, which is not even copied: (x - 0.1)^2 + (y + 0.2)^2
class Vertex_energy
{
public:
  explicit Vertex_energy(Copy_constructible::Maker) {}
  Vertex_energy(const Vertex_energy&) = delete;
  Vertex_energy& operator=(const Vertex_energy&) = delete;

  double operator()(double x, double y) const { return (x - 0.1) * (x - 0.1) + (y + 0.2) * (y + 0.2); }

  double derivatives(std::array<double, 2>& first, std::array<double, 3>& second) const
  {
    second = {2., 0., 2.};
    return gradient(first);
  }

  double gradient(std::array<double, 2>& first) const
  {
    first = {-0.2, 0.4};
    return (*this)(0., 0.);
  }

  double shortest_edge() const { return 1.; }
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_ENERGY_H
