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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LIBRARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LIBRARY_H

#include <CGAL/license/Spherical_parameterization.h>

// Whether what is compiled once is defined in each file that includes its header, which is the default, or in a library.

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY
#define CGAL_SPHERICAL_PARAMETERIZATION_INLINE
#else
#define CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#define CGAL_SPHERICAL_PARAMETERIZATION_INLINE inline
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LIBRARY_H
