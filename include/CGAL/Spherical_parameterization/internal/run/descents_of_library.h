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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_DESCENTS_OF_LIBRARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_DESCENTS_OF_LIBRARY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent_impl.h>

#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The descents that are in the library, which src/ defines: those by the energies of the package. Others are compiled where they
// are called.

#define CGAL_SPHERICAL_PARAMETERIZATION_DESCENT(EXTERN, Energy, Step)                                                  \
  EXTERN template void descend<Step>(const Energy&, Radius_chooser*, const Sharpness&, const Descent_settings&,        \
                                     std::size_t, Run&, const std::vector<double>&);

#define CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Energy)                                                    \
  EXTERN template void embed_surface(const Energy&, const Sharpness&, std::size_t, bool, Run&,                         \
                                     const std::vector<double>&);                                                      \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENT(EXTERN, Energy, Newton_step)

#define CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS(EXTERN)                                                               \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Symmetric_Dirichlet_energy_3)                                    \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Isometric_energy_3)                                              \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Conformal_energy_3)                                              \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(EXTERN, Stretch_energy_3)                                                \
  CGAL_SPHERICAL_PARAMETERIZATION_DESCENT(EXTERN, Isometric_energy_3, Gradient_step)

CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS(extern)

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_DESCENTS_OF_LIBRARY_H
