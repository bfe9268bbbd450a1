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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_H

/// \file spherical_parameterization.h
/// Convenience header file that includes the core of the package: `parameterize()` with its methods, energies and
/// radius policies, the measures of maps, and the inverse of a map. The methods that solve linear systems need Eigen;
/// their headers are included individually. Each other part of the package has a header of its own, such as
/// `CGAL/Spherical_parameterization/sampling.h`.

#if !defined(DOXYGEN_RUNNING) && __cplusplus < 201703L && !(_MSVC_LANG >= 201703L)
#error "Spherical_parameterization needs C++17: compile with -std=c++17 or newer."
#else

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Area_balancing_radius_3.h>
#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Bijective_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Fixed_radius_3.h>
#include <CGAL/Spherical_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Optimal_radius_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Precomputed_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Schnyder_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/Sphere_locator_3.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/Two_phase_radius_3.h>
#include <CGAL/Spherical_parameterization/find_defect.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/reproducibility.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>

#endif // C++17

#endif // CGAL_SPHERICAL_PARAMETERIZATION_H
