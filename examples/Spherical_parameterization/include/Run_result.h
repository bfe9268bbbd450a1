// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_RESULT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_RESULT_H

#include <CGAL/Spherical_parameterization/Parameterization_report.h>

#include <array>
#include <vector>

namespace Program {

/// What a method has told of its run.
struct Run_result
{
  CGAL::Spherical_parameterization::Parameterization_report report;
  std::vector<std::array<double, 3>> history; ///< iteration, energy and radius of each sweep or global step
  bool is_one_to_one = false;                 ///< certified
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_RESULT_H
