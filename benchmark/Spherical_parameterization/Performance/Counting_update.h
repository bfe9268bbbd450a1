// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_COUNTING_UPDATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_COUNTING_UPDATE_H

#include <CGAL/Spherical_parameterization/Newton_update_3.h>

#include <array>
#include <cstddef>

namespace benchmarks {

// How often the energies of stars have been evaluated.
struct Evaluation_counts
{
  std::size_t derivatives = 0; // with the Hessian
  std::size_t values = 0;
};

// Moves vertices as the default update does and counts, in one thread, what that takes. A model of `VertexUpdate_3`.
class Counting_update
{
public:
  explicit Counting_update(Evaluation_counts& counts)
    : m_counts(&counts)
  {}

  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const
  {
    return m_update(Counted_energy<VertexEnergy>{energy, *m_counts}, step);
  }

private:
  template <class VertexEnergy>
  struct Counted_energy
  {
    const VertexEnergy& energy;
    Evaluation_counts& counts;

    double derivatives(std::array<double, 2>& gradient, std::array<double, 3>& hessian) const
    {
      ++counts.derivatives;
      return energy.derivatives(gradient, hessian);
    }
    double operator()(double x, double y) const
    {
      ++counts.values;
      return energy(x, y);
    }
    double shortest_edge() const { return energy.shortest_edge(); }
  };

  CGAL::Spherical_parameterization::Newton_update_3 m_update;
  Evaluation_counts* m_counts;
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_COUNTING_UPDATE_H
