#include "run_method.h"

#include "run_parameterizer.h"

#include <CGAL/Spherical_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Published_low_distortion_parameterizer_3.h>

#include <algorithm>

namespace Program {

namespace {

// Explains why a run has no map, and which options help.
std::string explain_failure(SP::Error_code error, Input_mesh& input, const Options& options)
{
  const std::string defect = input.find_defect();
  if(!defect.empty())
    return defect;
  const std::string text = input.name() + ": " + SP::get_error_message(error);
  const bool is_alone = is_among(options.method, {"stereographic", "harmonic", "conformal", "schnyder"});
  if(options.start.empty() && error == SP::ERROR_INVALID_INITIAL_PARAMETERIZATION)
    return printable(options.start_file) + ": " + SP::get_error_message(error);
  if(options.start.empty() || (options.start == "hierarchical" && !is_alone))
    return text;

  const bool is_conformal = options.start == "conformal";
  const std::string map = is_alone ? options.method + " map" : options.start + " initial map";
  const std::string advice =
      is_alone ? "use --method hierarchical or --method bld"
               : std::string("use ") + (is_conformal ? "--initial harmonic or " : "") + "--initial hierarchical";
  switch(error)
  {
  case SP::ERROR_INVALID_INITIAL_PARAMETERIZATION:
    return input.name() + ": the " + map +
           (is_conformal ? " has inverted triangles on this mesh, or nearly so, which conformal maps permit; "
                         : " of this mesh is bijective, but not robustly against rounding errors; ") +
           options.method + " needs a bijective initial map; " + advice;
  case SP::ERROR_INSUFFICIENT_PRECISION:
    return input.name() + ": the " + map +
           " is not bijective in double precision: on the sphere, parts of the surface would be smaller than its "
           "resolution; " +
           advice;
  case SP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM:
    return input.name() + ": the linear system of the " + map + " could not be solved; " + advice;
  default:
    return text;
  }
}

} // namespace

Chosen_radius chosen_radius(const Options& options)
{
  if(options.radius == "two-phase") // in the paper, the second phase also depends on the energy
    return {options.has("paper") ? SP::Two_phase_radius_3<>({}, {}, 0.) : SP::Two_phase_radius_3<>()};
  if(options.radius == "optimal")
    return {SP::Optimal_radius_3()};
  if(options.radius == "area")
    return {SP::Area_preserving_radius_3()};
  if(options.radius == "balanced")
    return {SP::Area_balancing_radius_3()};
  return {SP::Fixed_radius_3(options.fixed_radius)};
}

Chosen_parameterizer chosen_parameterizer(const Options& options, Input_mesh& input, const std::string& name)
{
  if(name == "stereographic")
    return {SP::Stereographic_parameterizer_3<>()};
  if(name == "harmonic")
    return {SP::Harmonic_parameterizer_3<>()};
  if(name == "conformal")
    return {SP::Conformal_parameterizer_3<>()};
  if(name == "schnyder")
    return {SP::Schnyder_parameterizer_3()};
  return {SP::Precomputed_parameterizer_3<Sphere_map>(input.read_map(options.start_file))};
}

std::size_t number_of_iterations(const Options& options, const Mesh& mesh)
{
  if(options.max_iterations)
    return *options.max_iterations;
  const auto has_face = [&](Vertex_index v) { return !mesh.is_isolated(v); };
  return SP::internal::default_number_of_sweeps(
      static_cast<std::size_t>(std::count_if(mesh.vertices_begin(), mesh.vertices_end(), has_face)));
}

void fail_run(SP::Error_code error, Input_mesh& input, const Options& options)
{
  throw Program_error(explain_failure(error, input, options));
}

Run_result run_method(const Options& options, Input_mesh& input, const Sphere_map& sphere)
{
  const auto run = [&](auto method) { return run_parameterizer(method, options, input, sphere); };
  const bool starts_hierarchically = options.start == "hierarchical";
  if(options.has("paper"))
  {
    const auto published =
        SP::Published_low_distortion_parameterizer_3<>().radius(chosen_radius(options)).sharpness(options.sharpness);
    return starts_hierarchically
               ? run(published.initial_parameterizer(SP::Hierarchical_parameterizer_3<>()))
               : run(published.initial_parameterizer(chosen_parameterizer(options, input, options.start)));
  }
  if(options.has("density"))
    return run_area_descent(options, input, sphere);
  if(options.method == "bld")
    return run_descent(options, input, sphere);
  if(options.method == "hierarchical")
    return run_with_energy(
        options, [&](const auto& energy) { return run(SP::Hierarchical_parameterizer_3<>().energy(energy)); });
  if(options.method == "arap")
    return starts_hierarchically ? run(SP::ARAP_parameterizer_3<>())
                                 : run(SP::ARAP_parameterizer_3(chosen_parameterizer(options, input, options.start)));
  return run(chosen_parameterizer(options, input, options.method));
}

} // namespace Program
