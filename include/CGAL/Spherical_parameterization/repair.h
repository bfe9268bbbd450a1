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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_H

/// \file Spherical_parameterization/repair.h
/// Convenience header file that includes the functions that repair surfaces: filling holes, finding handles, and making
/// a surface of genus 0.

#if !defined(DOXYGEN_RUNNING) && __cplusplus < 201703L && !(_MSVC_LANG >= 201703L)
#error "Spherical_parameterization needs C++17: compile with -std=c++17 or newer."
#else

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Repair/fill_holes.h>
#include <CGAL/Spherical_parameterization/Repair/find_handles.h>
#include <CGAL/Spherical_parameterization/Repair/repair_surface.h>

#endif // C++17

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_H
