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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_DEFAULT_VISITOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_DEFAULT_VISITOR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cstddef>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationVisitor
///
/// The class `Default_visitor` does nothing and never stops a run. It can be used as a base class if only some of the
/// functions of the concept need to be overridden.
///
/// \cgalModels{SphericalParameterizationVisitor}
struct Default_visitor
{
#ifndef DOXYGEN_RUNNING
  void on_initialization_begin(std::size_t /* number_of_vertices */) {}
  void on_level(std::size_t /* number_of_vertices */) {}
  void on_initialization_end() {}
  void after_iteration(std::size_t /* iteration */, double /* energy */, double /* radius */) {}
  bool go_further(std::size_t /* iteration */, double /* energy */)
  {
    return true;
  }
  void on_optimization_end() {}
#endif
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_DEFAULT_VISITOR_H
