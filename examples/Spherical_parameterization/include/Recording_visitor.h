// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RECORDING_VISITOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RECORDING_VISITOR_H

#include "Progress_line.h"

#include <array>
#include <cstddef>
#include <vector>

namespace Program {

/// A visitor that keeps what each sweep over the mesh, or each global step, has reached, beside showing it.
class Recording_visitor : public Progress_line
{
public:
  using Progress_line::Progress_line;

  void after_iteration(std::size_t iteration, double energy, double radius)
  {
    m_history.push_back({static_cast<double>(iteration), energy, radius});
    Progress_line::after_iteration(iteration, energy, radius);
  }

  /// returns iteration, energy and radius of each.
  const std::vector<std::array<double, 3>>& history() const { return m_history; }

private:
  std::vector<std::array<double, 3>> m_history;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RECORDING_VISITOR_H
