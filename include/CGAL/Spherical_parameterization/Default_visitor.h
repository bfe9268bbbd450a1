// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_DEFAULT_VISITOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_DEFAULT_VISITOR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cstddef>

/// \file Default_visitor.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationVisitor
///
/// The class `Default_visitor` does nothing and never stops a parameterization. It can be used as a base class if only some
/// of the functions of the concept are of interest. All functions are called from the thread that called
/// `CGAL::Spherical_parameterization::parameterize()`.
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
#else
  /// called once the mesh has been found valid, before an initial map is made.
  ///
  /// \param number_of_vertices the vertices that will be mapped; isolated vertices do not count
  void on_initialization_begin(std::size_t number_of_vertices);

  /// called when a level of the hierarchy has been mapped.
  ///
  /// \param number_of_vertices the vertices of the level; it grows from call to call
  void on_level(std::size_t number_of_vertices);

  /// called when the initial map is there; from now on, stopping leaves a bijection.
  void on_initialization_end();

  /// called after each sweep over the finest mesh.
  ///
  /// \param iteration number of the sweep, from 1
  /// \param energy the mean of the energies of the faces that the sweep has lowered:
  ///        \f$ \log( \frac{1}{n} \sum \exp( s E ) ) / s \f$, or the average for \f$ s = 0 \f$. Where \f$ s \f$ changes from sweep
  ///        to sweep, it may grow.
  /// \param radius the radius of the sphere
  void after_iteration(std::size_t iteration, double energy, double radius);

  /// called after `after_iteration()` and on each level of the hierarchy, there with `iteration` 0 and the energy of the level.
  ///
  /// \return `false` to stop as soon as possible: the map reached by then is certified and returned. On the levels, the rest of
  ///         the hierarchy is mapped in the least time.
  bool go_further(std::size_t iteration, double energy);

  /// called after the last sweep, before the map is certified and written.
  void on_optimization_end();
#endif
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_DEFAULT_VISITOR_H
