#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_METHOD_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_METHOD_H

#include "Input_mesh.h"
#include "Interrupt_guard.h"
#include "Program_error.h"
#include "Program_options.h"
#include "Progress_visitor.h"
#include "mesh_files.h"
#include "read_soup.h"

#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Conformal_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Published_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Stereographic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Target_area_parameterizer_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace Program {

/// What a method has told of its run.
struct Run_result
{
  SP::Parameterization_report report;
  std::vector<std::array<double, 3>> history; ///< iteration, energy and radius of each sweep or global step
  bool is_one_to_one = false;                 ///< certified
  std::optional<SP::Area_report> areas = {};  ///< if areas were wanted
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

/// reads the density of each vertex or of each face of the mesh from a file.
///
/// \param is_of_vertices is set
///
/// \throws Program_error if the file has none, or they are none
inline std::vector<double> read_density(const std::string& name, Input_mesh& input, bool& is_of_vertices)
{
  const Polygon_soup soup = read_soup(name, true);
  return read_named(name, [&] {
    const Values* density = nullptr;
    for(const std::vector<Values>* all : {&soup.values_of_vertices, &soup.values_of_faces})
      for(const Values& values : *all)
        if(values.name == "density" ||
           (density == nullptr && soup.values_of_vertices.size() + soup.values_of_faces.size() == 1))
        {
          density = &values;
          is_of_vertices = all == &soup.values_of_vertices;
        }
    if(density == nullptr)
      throw Program_error("is no density: it has not one value for each vertex or each face, nor a property density");
    const std::vector<double>& result = density->numbers;
    const std::string kind = is_of_vertices ? " vertices" : " faces";
    const std::size_t n = is_of_vertices ? input.mesh().number_of_vertices() : input.mesh().number_of_faces();
    if(result.size() != n)
      throw Program_error("is no density for the mesh: it is that of " + std::to_string(result.size()) + kind +
                          ", the mesh has " + std::to_string(n));
    for(std::size_t k = 0; k < n; ++k)
      if(!(result[k] >= 0. && std::isfinite(result[k])))
        throw Program_error("the density of " + std::string(is_of_vertices ? "vertex " : "face ") + std::to_string(k) +
                            " is negative, infinite or not a number. (They are counted from 0.)");
    if(std::all_of(result.begin(), result.end(), [](double x) { return x == 0.; }))
      throw Program_error("the density is 0 everywhere: nothing of the surface would have a place on the sphere");
    return result;
  });
}

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

/// whether a parameterizer tells how near it has come to areas that were wanted
template <class Parameterizer, class = void>
constexpr bool has_area_report = false;
template <class Parameterizer>
constexpr bool has_area_report<Parameterizer, std::void_t<decltype(std::declval<Parameterizer&>().area_report())>> =
    true;

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
    Run_result result = {parameterizer.report(), visitor.history(), error == SP::OK};
    if constexpr(has_area_report<decltype(parameterizer)>)
      result.areas = parameterizer.area_report();
    return result;
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

  bool is_of_vertices = false;
  const std::vector<double> density =
      options.density_file.empty() ? std::vector<double>() : read_density(options.density_file, input, is_of_vertices);
  const auto run_for_areas = [&](const auto& method) {
    if(density.empty())
      return run(method);
    const auto copy_to = [&](auto map) {
      for(std::size_t k = 0; k < density.size(); ++k)
        map[typename decltype(map)::key_type(static_cast<Mesh::size_type>(k))] = density[k];
      return map;
    };
    if(is_of_vertices)
      return run(method.target_density(copy_to(input.mesh().add_property_map<Vertex_index, double>().first)));
    return run(method.target_density(copy_to(input.mesh().add_property_map<Mesh::Face_index, double>().first)));
  };

  const auto run_with = [&](const auto& energy) {
    if(options.gives_areas)
      return run_for_areas(SP::Target_area_parameterizer_3<>().energy(energy).sharpness(options.sharpness));
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
