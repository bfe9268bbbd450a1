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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_DESCENT_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_DESCENT_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/initializers/Schnyder_drawing.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent.h>
#include <CGAL/Spherical_parameterization/internal/surface/Run.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE void draw_surface(Run& run)
{
  run.positions = Schnyder_drawing(run.surface.rings()).positions();
  run.control.report().seconds_for_embedding += run.control.lap();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_RUN_DESCENT_IMPL_H
