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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_H

/// \file Spherical_parameterization/sampling.h
/// Convenience header file that includes the functions that sample a surface through its sphere: domains, remeshing,
/// transfer and resampling of properties, distances, and texture coordinates. The headers for geometry image files each
/// need a library and are included individually.

#if !defined(DOXYGEN_RUNNING) && __cplusplus < 201703L && !(_MSVC_LANG >= 201703L)
#error "Spherical_parameterization needs C++17: compile with -std=c++17 or newer."
#else

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_resampler_3.h>
#include <CGAL/Spherical_parameterization/Sampling/compute_texture_coordinates.h>
#include <CGAL/Spherical_parameterization/Sampling/measure_distance.h>
#include <CGAL/Spherical_parameterization/Sampling/remesh_through_sphere.h>
#include <CGAL/Spherical_parameterization/Sampling/transfer.h>
#include <CGAL/Spherical_parameterization/Sampling/write_OBJ.h>

#endif // C++17

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_H
