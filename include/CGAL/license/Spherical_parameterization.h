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
//
// CGAL generates the headers of this folder from its list of packages. This one stands in for the generated one as long
// as the package lives outside of CGAL, so that every header already includes what it will include there.

#ifndef CGAL_LICENSE_SPHERICAL_PARAMETERIZATION_H
#define CGAL_LICENSE_SPHERICAL_PARAMETERIZATION_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#endif // CGAL_LICENSE_SPHERICAL_PARAMETERIZATION_H
