// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_METHOD_RUNNER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_METHOD_RUNNER_H

#include "Any_parameterizer.h"
#include "Any_radius.h"
#include "Any_sharpness.h"
#include "Any_update.h"
#include "Input_mesh.h"
#include "Interrupt_guard.h"
#include "Program_error.h"
#include "Program_options.h"
#include "Recording_visitor.h"
#include "Run_result.h"
#include "choices.h"
#include "explain_failure.h"

#include <CGAL/spherical_parameterization.h>

#include <functional>
#include <type_traits>

namespace Program {

namespace SP = CGAL::Spherical_parameterization;

template <class Energy, class Update>
using Hierarchical_parameterizer = SP::Hierarchical_parameterizer_3<Mesh, Energy, Any_sharpness, Update>;

/// Runs the method that the options name. The energy and the barrier are chosen at compile time, as they belong to the
/// innermost loop, and so is the usual update, which moves several vertices at once; everything else is chosen at run
/// time, so that few parameterizers have to be compiled.
class Method_runner
{
public:
  Method_runner(Input_mesh& input, Sphere_map sphere, const Program_options& options)
    : m_input(input)
    , m_sphere(sphere)
    , m_options(options)
  {}

  /// maps the mesh to a sphere.
  ///
  /// \throws Program_error if no map was written
  Run_result run()
  {
    switch(m_options.method)
    {
    case Method_choice::STEREOGRAPHIC:
      return run(Any_parameterizer(Any_parameterizer::Stereographic()));
    case Method_choice::HARMONIC:
      return run(Any_parameterizer(Any_parameterizer::Harmonic()));
    case Method_choice::CONFORMAL:
      return run(Any_parameterizer(Any_parameterizer::Conformal()));
    case Method_choice::ARAP:
      return improve(usual_hierarchical_parameterizer(), [&](const auto& initial) {
        return run(SP::ARAP_parameterizer_3<Mesh, std::decay_t<decltype(initial)>>(initial));
      });
    default:
      return m_options.is_published ? run_published() : run_with_energy();
    }
  }

private:
  template <class Parameterizer>
  Run_result run(Parameterizer parameterizer)
  {
    const Interrupt_guard guard;
    Recording_visitor visitor(m_options.shows_progress());
    const SP::Error_code error = SP::parameterize(m_input.mesh(), parameterizer, m_sphere,
                                                  CGAL::parameters::visitor(std::ref(visitor))
                                                      .number_of_iterations(m_options.most_iterations)
                                                      .maximum_running_time(m_options.most_seconds));
    if(error != SP::OK && error != SP::ERROR_NO_1_TO_1_MAPPING)
      throw Program_error(explain_failure(error, m_input.path(), m_options));
    return {parameterizer.report(), visitor.history(), error == SP::OK};
  }

  Run_result run_published()
  {
    return improve(usual_hierarchical_parameterizer(), [&](const auto& initial) {
      using Initial = std::decay_t<decltype(initial)>;
      return run(SP::Published_low_distortion_parameterizer_3<Mesh, Initial, Any_sharpness, Any_radius>(
          initial, m_options.sharpness, m_options.radius));
    });
  }

  Run_result run_with_energy()
  {
    switch(m_options.energy)
    {
    case Energy_choice::ISOMETRIC:
      return run_with<SP::Isometric_energy_3>();
    case Energy_choice::CONFORMAL:
      return run_with<SP::Conformal_energy_3>();
    default:
      return run_with<SP::Symmetric_Dirichlet_energy_3>();
    }
  }

  template <class Energy>
  Run_result run_with()
  {
    if(m_options.barrier == Barrier_choice::FLAT)
      return run_with<Energy, SP::Flat_area_barrier_3>(m_options.update);
    if(const SP::Newton_update_3* newton = m_options.update.newton())
      return run_with<Energy, SP::Determinant_barrier_3>(*newton);
    return run_with<Energy, SP::Determinant_barrier_3>(m_options.update);
  }

  template <class Energy, class Barrier, class Update>
  Run_result run_with(const Update& update)
  {
    const Hierarchical_parameterizer<Energy, Update> hierarchical(Energy(), m_options.sharpness, update);
    if(m_options.method == Method_choice::HIERARCHICAL)
      return run(hierarchical);
    return improve(hierarchical, [&](const auto& initial) {
      using Initial = std::decay_t<decltype(initial)>;
      return run(SP::Bijective_low_distortion_parameterizer_3<Mesh, Initial, Energy, Any_sharpness, Any_radius, Update,
                                                              Barrier>(initial, Energy(), m_options.sharpness,
                                                                       m_options.radius, update));
    });
  }

  // the default of the library, for methods that have no energy to pass on to it
  static Hierarchical_parameterizer<SP::Isometric_energy_3, SP::Newton_update_3> usual_hierarchical_parameterizer()
  {
    return Hierarchical_parameterizer<SP::Isometric_energy_3, SP::Newton_update_3>(
        SP::Isometric_energy_3(), Any_sharpness(SP::Relative_sharpness_3(0.)));
  }

  // calls `run_from` with the parameterizer that makes the start
  template <class Hierarchical, class Run_from>
  Run_result improve(const Hierarchical& hierarchical, const Run_from& run_from)
  {
    switch(m_options.start)
    {
    case Start_choice::HIERARCHICAL:
      return run_from(hierarchical);
    case Start_choice::STEREOGRAPHIC:
      return run_from(Any_parameterizer(Any_parameterizer::Stereographic()));
    case Start_choice::HARMONIC:
      return run_from(Any_parameterizer(Any_parameterizer::Harmonic()));
    case Start_choice::CONFORMAL:
      return run_from(Any_parameterizer(Any_parameterizer::Conformal()));
    default:
      return run_from(Any_parameterizer(Any_parameterizer::Precomputed(m_input.read_map(m_options.start_file))));
    }
  }

  Input_mesh& m_input;
  Sphere_map m_sphere;
  const Program_options& m_options;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_METHOD_RUNNER_H
