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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_H

/// \file Spherical_parameterization/cortex.h
/// Convenience header file that includes the functions for cortical surfaces: sulcal measures, the pose of a sphere,
/// and the file formats of FreeSurfer. The headers for GIFTI and MGH files each need a library and are included
/// individually.

#if !defined(DOXYGEN_RUNNING) && __cplusplus < 201703L && !(_MSVC_LANG >= 201703L)
#error "Spherical_parameterization needs C++17: compile with -std=c++17 or newer."
#else

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>
#include <CGAL/Spherical_parameterization/Cortex/compute_sulcal_measures.h>
#include <CGAL/Spherical_parameterization/Cortex/fit_rotation_to_surface.h>
#include <CGAL/Spherical_parameterization/Cortex/rotate_to_surface.h>

#endif // C++17

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_H
