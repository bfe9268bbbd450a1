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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_DESCENTS_OF_LIBRARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_DESCENTS_OF_LIBRARY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/areas/Area_descent.h>

#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The steps to prescribed areas that are in the library, see descents_of_library.h.

#define CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(EXTERN, Energy)                                                   \
  EXTERN template std::size_t lower_area_differences(const Surface&, const Area_shares&, const Energy&, double,        \
                                                     std::vector<Vector_3d>&, Run_control&);

#define CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENTS(EXTERN)                                                          \
  CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(EXTERN, Symmetric_Dirichlet_energy_3)                                   \
  CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(EXTERN, Isometric_energy_3)                                             \
  CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(EXTERN, Conformal_energy_3)                                             \
  CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(EXTERN, Stretch_energy_3)

CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENTS(extern)

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_DESCENTS_OF_LIBRARY_H
