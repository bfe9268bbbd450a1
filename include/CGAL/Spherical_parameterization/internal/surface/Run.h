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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_RUN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_RUN_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>

#include <cstddef>
#include <optional>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The data of a method: a surface, the images of its vertices, and the control that may stop it, independent of the
// caller's types.
struct Run
{
  Run(Run_control& control_of_run, const Execution& execution_of_run)
    : control(control_of_run)
    , execution(execution_of_run)
  {}

  Run_control& control;
  Execution execution;
  Surface surface;
  std::vector<Vector_3d> positions; // on the unit sphere, in the order of the surface
  double radius = 1.;               // in the caller's unit of length
  std::optional<std::size_t> number_of_iterations;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_RUN_H
