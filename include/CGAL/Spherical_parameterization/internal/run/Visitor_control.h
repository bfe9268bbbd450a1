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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_VISITOR_CONTROL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_VISITOR_CONTROL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>

#include <CGAL/Named_function_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <type_traits>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A Run_control for the visitor and the time limit in the named parameters of a call.
template <class NamedParameters>
class Visitor_control : public Run_control
{
public:
  // `report` is a `Parameterization_report`, if the caller has one.
  template <class... Report>
  explicit Visitor_control(const NamedParameters& np, Report&... report)
    : Run_control(parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_running_time), 0.),
                  report...)
    , m_visitor(parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::visitor),
                                             m_default_visitor))
  {}

  void on_initialization_begin(std::size_t number_of_vertices) override
  {
    m_visitor.on_initialization_begin(number_of_vertices);
  }
  void on_level(std::size_t number_of_vertices) override { m_visitor.on_level(number_of_vertices); }
  void on_initialization_end() override { m_visitor.on_initialization_end(); }
  void after_iteration(std::size_t iteration, double energy, double radius) override
  {
    m_visitor.after_iteration(iteration, energy, radius);
  }
  void on_optimization_end() override { m_visitor.on_optimization_end(); }

private:
  bool visitor_goes_further(std::size_t iteration, double energy) override
  {
    return m_visitor.go_further(iteration, energy);
  }

  Default_visitor m_default_visitor;
  typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Default_visitor>::reference
      m_visitor;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_VISITOR_CONTROL_H
