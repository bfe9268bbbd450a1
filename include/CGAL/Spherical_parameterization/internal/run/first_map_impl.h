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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_FIRST_MAP_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_FIRST_MAP_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Schnyder_drawing.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/first_map.h>
#include <CGAL/Spherical_parameterization/internal/surface/Run.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE void draw_surface(Run& run)
{
  run.positions = Schnyder_drawing(run.surface.rings()).positions();
  run.control.report().seconds_for_embedding += run.control.lap();
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE bool take_map(std::vector<Vector_3d> images, Run& run)
{
  for(Vector_3d& x : images)
  {
    const double size = (std::max)({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])}); // squares could overflow
    x = normalized({x[0] / size, x[1] / size, x[2] / size});
  }
  const bool is_bijective = are_bijective(run.surface.callers_triangles(), images, run.execution);
  run.positions = run.surface.in_own_order(images);
  return is_bijective;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_FIRST_MAP_IMPL_H
