// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EXPLAIN_FAILURE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EXPLAIN_FAILURE_H

#include "Program_options.h"
#include "choices.h"

#include <CGAL/Spherical_parameterization/Error_code.h>

#include <string>

namespace Program {

/// says why a run has left no map and what helps, in the words of the command line; `input` is the file of the mesh.
inline std::string explain_failure(CGAL::Spherical_parameterization::Error_code error, const std::string& input,
                                   const Program_options& options)
{
  using namespace CGAL::Spherical_parameterization;

  const std::string library_text = get_error_message(error);
  if(options.start == Start_choice::PRECOMPUTED)
    return (error == ERROR_INVALID_INITIAL_PARAMETERIZATION ? options.start_file : input) + ": " + library_text;

  const bool is_start = options.start != Start_choice::HIERARCHICAL;
  const bool is_alone = options.method == Method_choice::STEREOGRAPHIC || options.method == Method_choice::HARMONIC ||
                        options.method == Method_choice::CONFORMAL;
  if(!is_start && !is_alone)
    return input + ": " + library_text;

  const std::string name = is_start ? name_of(starts, options.start) : name_of(methods, options.method);
  const std::string map = name + (is_start ? " start" : " map");
  const std::string advice =
      is_start ? (options.start == Start_choice::CONFORMAL ? "take --initial harmonic or --initial hierarchical"
                                                           : "take --initial hierarchical")
               : "take --method hierarchical or --method bld";
  switch(error)
  {
  case ERROR_INVALID_INITIAL_PARAMETERIZATION:
    return input + ": the " + map +
           (options.start == Start_choice::CONFORMAL
                ? " folds on this mesh, or nearly so: nothing prevents a conformal map from that, and "
                : " is one-to-one on this mesh only just so, by less than rounding can change, and ") +
           name_of(methods, options.method) + " has to start from one that is one-to-one; " + advice;
  case ERROR_INSUFFICIENT_PRECISION:
    return input + ": no one-to-one " + map +
           " was found that double precision numbers can hold: parts of the surface would have to be smaller than "
           "their resolution; " +
           advice;
  case ERROR_CANNOT_SOLVE_LINEAR_SYSTEM:
    return input + ": the linear system of the " + map + " could not be solved; " + advice;
  default:
    return input + ": " + library_text;
  }
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_EXPLAIN_FAILURE_H
