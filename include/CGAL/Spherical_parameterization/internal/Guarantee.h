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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_GUARANTEE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_GUARANTEE_H

#include <CGAL/license/Spherical_parameterization.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// What a method promises of its maps: that they are one-to-one, or nothing, in which case a map that folds is written
// and reported.
enum class Guarantee
{
  ONE_TO_ONE,
  NONE
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_GUARANTEE_H
