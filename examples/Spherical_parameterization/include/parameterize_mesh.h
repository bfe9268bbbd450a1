// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PARAMETERIZE_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PARAMETERIZE_MESH_H

#include "Input_mesh.h"
#include "Interrupt_guard.h"
#include "Program_error.h"
#include "Program_options.h"
#include "Progress_line.h"
#include "Thread_limit.h"

#include <CGAL/spherical_parameterization.h>

#include <functional>
#include <string>

namespace Program {

namespace SP = CGAL::Spherical_parameterization;

/// runs `parameterizer` within the limits of `options`.
template <class Parameterizer>
SP::Parameterization_report run_parameterizer(const Mesh& mesh, Sphere_map sphere, Parameterizer parameterizer,
                                              const Program_options& options)
{
  const Thread_limit threads(options.most_threads);
  const Interrupt_guard guard;
  Progress_line progress(options.is_quiet);
  const SP::Error_code error = SP::parameterize(mesh, parameterizer, sphere,
                                                CGAL::parameters::visitor(std::ref(progress))
                                                    .number_of_iterations(options.most_iterations)
                                                    .maximum_running_time(options.most_seconds));
  if(error != SP::OK)
  {
    const bool is_from_initial = error == SP::ERROR_INVALID_INITIAL_PARAMETERIZATION;
    throw Program_error((is_from_initial ? options.initial : options.input) + ": " + SP::get_error_message(error));
  }
  return parameterizer.report();
}

/// lowers the given energy, from the start and with the policies that `options` name.
template <class Energy>
SP::Parameterization_report lower_energy(Input_mesh& input, Sphere_map sphere, const Program_options& options)
{
  if(options.initial.empty())
  {
    using Parameterizer =
        SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, Energy, Any_sharpness, Any_radius>;
    return run_parameterizer(input.mesh(), sphere, Parameterizer(Energy(), options.sharpness, options.radius), options);
  }
  using Initial = SP::Precomputed_parameterizer_3<Mesh, Sphere_map>;
  using Parameterizer = SP::Bijective_low_distortion_parameterizer_3<Mesh, Initial, Energy, Any_sharpness, Any_radius>;
  const Initial initial(input.read_map(options.initial));
  return run_parameterizer(input.mesh(), sphere, Parameterizer(initial, Energy(), options.sharpness, options.radius),
                           options);
}

/// maps the mesh to a sphere as `options` say.
///
/// \throws Program_error if there is no certified map
inline SP::Parameterization_report parameterize_mesh(Input_mesh& input, Sphere_map sphere,
                                                     const Program_options& options)
{
  switch(options.energy)
  {
  case Energy_choice::ISOMETRIC:
    return lower_energy<SP::Isometric_energy_3>(input, sphere, options);
  case Energy_choice::CONFORMAL:
    return lower_energy<SP::Conformal_energy_3>(input, sphere, options);
  default:
    return lower_energy<SP::Symmetric_Dirichlet_energy_3>(input, sphere, options);
  }
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PARAMETERIZE_MESH_H
