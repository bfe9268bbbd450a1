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

// Where the definitions come from of the functions through which the headers enter what takes long to compile, and of the templates
// on the energies of the package.
//
// By default each header brings them along, as inline functions: nothing has to be built before. With
// CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY they are in a static library, which the CMake target
// CGAL::Spherical_parameterization_library builds and links, and which defines the macro: a program of several files compiles
// them once. A header that declares such functions ends by including the file ..._impl.h that defines them, which may serve several
// headers, unless they are in the library; its sources, in src/, include these files instead. What has no such mark is inline. A
// program that uses the library and has an energy of its own defines CGAL_SPHERICAL_PARAMETERIZATION_OWN_ENERGIES as well, as the
// descent by it is compiled where it is called.
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY
#define CGAL_SPHERICAL_PARAMETERIZATION_INLINE
#else
#define CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#define CGAL_SPHERICAL_PARAMETERIZATION_INLINE inline
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LIBRARY_H
