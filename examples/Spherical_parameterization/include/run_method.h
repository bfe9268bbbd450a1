#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_METHOD_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_METHOD_H

#include "Input_mesh.h"
#include "Interrupt_guard.h"
#include "Program_error.h"
#include "Program_options.h"
#include "Progress_visitor.h"

#include <CGAL/spherical_parameterization.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace Program {

/// What a method has told of its run.
struct Run_result
{
  SP::Parameterization_report report;
  std::vector<std::array<double, 3>> history; ///< iteration, energy and radius of each sweep or global step
  bool is_one_to_one = false;                 ///< certified
};

/// The radius policy that was chosen at run time, so that methods are compiled once for all of them.
struct Chosen_radius
{
  Radius_choice policy;

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
    return std::visit([](auto& p) { return next_phase_of(p); }, policy);
  }

private:
  template <class Radius>
  static bool next_phase_of(Radius&)
  {
    return false; // there is one phase only
  }
  template <class First, class Second>
  static bool next_phase_of(SP::Two_phase_radius_3<First, Second>& radius)
  {
    return radius.next_phase();
  }
};

/// The parameterizer without settings that was chosen at run time: a method of its own, or the start of another one.
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

/// says why a run has left no map and what helps, in the words of the command line.
inline std::string explain_failure(SP::Error_code error, Input_mesh& input, const Program_options& options)
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
  const std::string map = is_alone ? options.method + " map" : options.start + " start";
  const std::string advice =
      is_alone ? "take --method hierarchical or --method bld"
               : std::string("take ") + (is_conformal ? "--initial harmonic or " : "") + "--initial hierarchical";
  switch(error)
  {
  case SP::ERROR_INVALID_INITIAL_PARAMETERIZATION:
    return input.name() + ": the " + map +
           (is_conformal ? " folds on this mesh, or nearly so: nothing prevents a conformal map from that, and "
                         : " is one-to-one on this mesh only just so, by less than rounding can change, and ") +
           options.method + " has to start from one that is one-to-one; " + advice;
  case SP::ERROR_INSUFFICIENT_PRECISION:
    return input.name() + ": no one-to-one " + map +
           " was found that double precision numbers can hold: parts of the surface would have to be smaller than "
           "their resolution; " +
           advice;
  case SP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM:
    return input.name() + ": the linear system of the " + map + " could not be solved; " + advice;
  default:
    return text;
  }
}

/// maps the mesh to a sphere by the method that the options name.
///
/// \throws Program_error if no map was written
inline Run_result run_method(const Program_options& options, Input_mesh& input, const Sphere_map& sphere)
{
  const auto run = [&](auto parameterizer) -> Run_result {
    std::optional<Interrupt_guard> guard;
    if(!options.is_batch()) // which has one for all
      guard.emplace();
    Progress_visitor visitor(!options.is_quiet && !options.is_batch());
    const auto np = CGAL::parameters::visitor(std::ref(visitor)).maximum_running_time(options.max_seconds);
    const SP::Error_code error =
        options.max_iterations
            ? SP::parameterize(input.mesh(), parameterizer, sphere, np.number_of_iterations(*options.max_iterations))
            : SP::parameterize(input.mesh(), parameterizer, sphere, np);
    if(error != SP::OK && error != SP::ERROR_NO_1_TO_1_MAPPING)
      throw Program_error(explain_failure(error, input, options));
    return {parameterizer.report(), visitor.history(), error == SP::OK};
  };

  const auto choose = [&](const std::string& name) -> Chosen_parameterizer {
    if(name == "stereographic")
      return {SP::Stereographic_parameterizer_3<>()};
    if(name == "harmonic")
      return {SP::Harmonic_parameterizer_3<>()};
    if(name == "conformal")
      return {SP::Conformal_parameterizer_3<>()};
    if(name == "schnyder")
      return {SP::Schnyder_parameterizer_3()};
    return {SP::Precomputed_parameterizer_3<Sphere_map>(input.read_map(options.start_file))};
  };
  const bool starts_hierarchically = options.start == "hierarchical";

  const auto run_with = [&](const auto& energy) {
    if(options.method == "hierarchical")
      return run(SP::Hierarchical_parameterizer_3<>().energy(energy).sharpness(options.sharpness));
    const auto run_from_start = [&](const auto& bld) {
      return starts_hierarchically ? run(bld) : run(bld.initial_parameterizer(choose(options.start)));
    };
    const auto bld = SP::Bijective_low_distortion_parameterizer_3<>()
                         .energy(energy)
                         .sharpness(options.sharpness)
                         .tolerances(options.energy_tolerance, options.radius_tolerance);
    return options.radius ? run_from_start(bld.radius(Chosen_radius{*options.radius})) : run_from_start(bld);
  };

  if(options.is_published)
  {
    const auto published = SP::Published_low_distortion_parameterizer_3<>()
                               .radius(Chosen_radius{options.radius.value()})
                               .sharpness(options.sharpness);
    return starts_hierarchically ? run(published.initial_parameterizer(SP::Hierarchical_parameterizer_3<>()))
                                 : run(published.initial_parameterizer(choose(options.start)));
  }
  if(options.method == "arap")
    return starts_hierarchically ? run(SP::ARAP_parameterizer_3<>())
                                 : run(SP::ARAP_parameterizer_3(choose(options.start)));
  if(options.method != "bld" && options.method != "hierarchical")
    return run(choose(options.method));
  if(options.energy == "isometric")
    return run_with(SP::Isometric_energy_3());
  if(options.energy == "conformal")
    return run_with(SP::Conformal_energy_3());
  if(options.energy == "stretch")
    return run_with(SP::Stretch_energy_3());
  return run_with(SP::Symmetric_Dirichlet_energy_3());
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_METHOD_H
