#ifndef PROGRAM_RUN_PARAMETERIZER_H
#define PROGRAM_RUN_PARAMETERIZER_H

#include "Progress_visitor.h"
#include "run_method.h"

#include <CGAL/Spherical_parameterization/Area_balancing_radius_3.h>
#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Conformal_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Fixed_radius_3.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Optimal_radius_3.h>
#include <CGAL/Spherical_parameterization/Precomputed_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Schnyder_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Stereographic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/Two_phase_radius_3.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <stdexcept>
#include <variant>

namespace Program {

/// A radius policy that is chosen at run time, so that methods are compiled once for all policies.
struct Chosen_radius
{
  std::variant<SP::Two_phase_radius_3<>, SP::Optimal_radius_3, SP::Area_balancing_radius_3,
               SP::Area_preserving_radius_3, SP::Fixed_radius_3>
      policy;

  double initial_radius(double equal_area_radius) const
  {
    return std::visit([&](const auto& p) { return p.initial_radius(equal_area_radius); }, policy);
  }
  template <class Energy>
  double operator()(const Energy& energy, const SP::Face_range_3& faces, double radius)
  {
    return std::visit([&](auto& p) { return p(energy, faces, radius); }, policy);
  }
  bool next_phase()
  {
    auto* const two_phase = std::get_if<SP::Two_phase_radius_3<>>(&policy);
    return two_phase != nullptr && two_phase->next_phase();
  }
};

/// A parameterizer without settings that is chosen at run time: a method, or the initial map of another method.
struct Chosen_parameterizer
{
  std::variant<SP::Stereographic_parameterizer_3<>, SP::Harmonic_parameterizer_3<>, SP::Conformal_parameterizer_3<>,
               SP::Schnyder_parameterizer_3, SP::Precomputed_parameterizer_3<Sphere_map>>
      parameterizer;

  template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  SP::Error_code parameterize(const Mesh& mesh, VertexSphereMap map,
                              const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
  {
    return std::visit([&](auto& p) { return p.template parameterize<ConcurrencyTag>(mesh, map, np); }, parameterizer);
  }
  const SP::Parameterization_report& report() const
  {
    return std::visit(
        [](const auto& p) -> const auto& { return p.report(); }, parameterizer);
  }
};

/// returns the radius policy in the options, and the method or initial map with a name.
Chosen_radius chosen_radius(const Options& options);
Chosen_parameterizer chosen_parameterizer(const Options& options, Input_mesh& input, const std::string& name);

/// returns the maximum number of sweeps or global steps.
std::size_t number_of_iterations(const Options& options, const Mesh& mesh);

[[noreturn]] void fail_run(SP::Error_code error, Input_mesh& input, const Options& options);

/// maps the mesh by a parameterizer.
template <class Parameterizer>
Run_result run_parameterizer(Parameterizer&& parameterizer, const Options& options, Input_mesh& input,
                             const Sphere_map& sphere)
{
  std::optional<Interrupt_guard> guard;
  if(!options.is_batch()) // a batch has one for all
    guard.emplace();
  Progress_visitor visitor(!options.has("quiet") && !options.is_batch());
  const SP::Error_code error = SP::parameterize(input.mesh(), parameterizer, sphere,
                                                CGAL::parameters::visitor(std::ref(visitor))
                                                    .maximum_running_time(options.max_seconds)
                                                    .number_of_iterations(number_of_iterations(options, input.mesh())));
  if(error != SP::OK && error != SP::ERROR_NO_1_TO_1_MAPPING)
    fail_run(error, input, options);
  return {parameterizer.report(), visitor.history(), error == SP::OK};
}

/// calls `run()` with the energy in the options.
template <class Run>
Run_result run_with_energy(const Options& options, const Run& run)
{
  if(options.energy == "isometric")
    return run(SP::Isometric_energy_3());
  if(options.energy == "conformal")
    return run(SP::Conformal_energy_3());
  if(options.energy == "stretch")
    return run(SP::Stretch_energy_3());
  if(options.energy != "symmetric-dirichlet")
    throw std::logic_error("no branch for --energy " + options.energy);
  return run(SP::Symmetric_Dirichlet_energy_3());
}

} // namespace Program

#endif // PROGRAM_RUN_PARAMETERIZER_H
