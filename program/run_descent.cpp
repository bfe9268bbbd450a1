#include "run_parameterizer.h"

#include <CGAL/Spherical_parameterization/Bijective_low_distortion_parameterizer_3.h>

namespace Program {

Run_result run_descent(const Options& options, Input_mesh& input, const Sphere_map& sphere)
{
  return run_with_energy(options, [&](const auto& energy) {
    const auto run = [&](auto bld) {
      if(options.start == "hierarchical")
        return run_parameterizer(bld, options, input, sphere);
      return run_parameterizer(bld.initial_parameterizer(chosen_parameterizer(options, input, options.start)), options,
                               input, sphere);
    };
    const auto bld = SP::Bijective_low_distortion_parameterizer_3<>()
                         .energy(energy)
                         .sharpness(options.sharpness)
                         .tolerances(options.energy_tolerance, options.radius_tolerance);
    return options.radius.empty() ? run(bld) : run(bld.radius(chosen_radius(options)));
  });
}

} // namespace Program
