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

// Whether the functions through which the headers enter code that takes long to compile, and the templates on the
// energies of the package, are defined in the headers or in a library.
//
// By default, the headers define them as inline functions, and nothing must be built before use. With
// CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY they are in a static library, which the CMake target
// CGAL::Spherical_parameterization_library builds and links, and which defines the macro: a program of several files
// then compiles them once. A header that declares such functions ends by including the file ..._impl.h with their
// definitions, which may serve several headers, unless they are in the library; its sources, in src/, include these
// files instead. All other functions are inline. A program that uses the library with an energy of its own must also
// define CGAL_SPHERICAL_PARAMETERIZATION_OWN_ENERGIES, because its descent is compiled where it is called.
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY
#define CGAL_SPHERICAL_PARAMETERIZATION_INLINE
#else
#define CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#define CGAL_SPHERICAL_PARAMETERIZATION_INLINE inline
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LIBRARY_H
