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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_H

/// \file Spherical_parameterization/harmonics.h
/// Convenience header file that includes the functions for spherical harmonics of surfaces: expansion, reconstruction,
/// rotation, standard position, and files of coefficients.

#if !defined(DOXYGEN_RUNNING) && __cplusplus < 201703L && !(_MSVC_LANG >= 201703L)
#error "Spherical_parameterization needs C++17: compile with -std=c++17 or newer."
#else

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/evaluate_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/expand_in_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/move_to_standard_position.h>
#include <CGAL/Spherical_parameterization/Harmonics/reconstruct_from_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/rotate_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/spherical_harmonics_files.h>

#endif // C++17

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_H
