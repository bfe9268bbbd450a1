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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_CHECK_RUN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_CHECK_RUN_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Checks of the arguments of functions that can be stopped, see check_arguments.h.

template <class Visitor>
using Visitor_results =
    std::void_t<decltype(std::declval<Visitor&>().on_initialization_begin(std::size_t())),
                decltype(std::declval<Visitor&>().on_level(std::size_t())),
                decltype(std::declval<Visitor&>().on_initialization_end()),
                decltype(std::declval<Visitor&>().after_iteration(std::size_t(), 0., 0.)),
                decltype(std::declval<Visitor&>().on_optimization_end()),
                std::enable_if_t<std::is_convertible<decltype(std::declval<Visitor&>().go_further(std::size_t(), 0.)),
                                                     bool>::value>>;

template <class NamedParameters>
using Visitor_of_call =
    typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Default_visitor>::reference;

// For a type that has been checked to be a mesh: the named parameters of functions that can be stopped.
template <class TriangleMesh, class NamedParameters>
constexpr bool check_run_parameters()
{
  using Time =
      typename internal_np::Lookup_named_param_def<internal_np::maximum_running_time_t, NamedParameters, double>::type;
  constexpr bool is_visitor = is_detected<Visitor_results, std::remove_reference_t<Visitor_of_call<NamedParameters>>>;
  static_assert(is_visitor,
                "The named parameter visitor has to be a model of SphericalParameterizationVisitor, such as a class "
                "derived from Default_visitor, or std::ref() of one.");
  constexpr bool is_time = std::is_convertible<Time, double>::value;
  static_assert(is_time, "The named parameter maximum_running_time has to be a number, the seconds.");
  return is_visitor && is_time && check_vertex_point_map<TriangleMesh, NamedParameters>();
}

// For parameterizers.
template <class TriangleMesh, class VertexSphereMap, class NamedParameters>
constexpr bool check_run()
{
  if constexpr(check_mesh<TriangleMesh>())
    if constexpr(check_map<TriangleMesh, VertexSphereMap>())
      return check_run_parameters<TriangleMesh, NamedParameters>();
  return false;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_CHECK_RUN_H
