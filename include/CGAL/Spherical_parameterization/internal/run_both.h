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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_BOTH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_BOTH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/for_each_block.h>

#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Calls f() and g(), at the same time if `ConcurrencyTag` asks for it, else one after the other. Neither may see what
// the other one does. Loops inside of them are parallel as well; but a thread that has called one of the two does not
// help with the loops of the other, so g() should be the shorter one.
template <class ConcurrencyTag, class Function, class OtherFunction>
void run_both(const Function& f, const OtherFunction& g)
{
  for_each_block<ConcurrencyTag>(0, 2, 1, [&](std::size_t k, std::size_t) {
    if(k == 0)
      f();
    else
      g();
  });
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_BOTH_H
