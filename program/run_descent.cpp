#include "run_parameterizer.h"

#include <CGAL/Spherical_parameterization/Bijective_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Target_area_parameterizer_3.h>

#include <algorithm>
#include <cmath>

namespace Program {

namespace {

// Reads the density of each vertex or each face of the mesh from a file.
std::vector<double> read_density(const std::string& name, Input_mesh& input, bool& is_of_vertices)
{
  const File_content soup = input.transferred(read_file_of_values(name));
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
      throw Program_error(
          "is not a density: it has neither exactly one value per vertex or face nor a property density");
    const std::vector<double>& result = density->numbers;
    const std::string kind = is_of_vertices ? " vertices" : " faces";
    const std::size_t n = is_of_vertices ? input.mesh().number_of_vertices() : input.mesh().number_of_faces();
    if(result.size() != n)
      throw Program_error("does not match the mesh: it has the density of ", result.size(), kind, ", the mesh has ", n);
    for(std::size_t k = 0; k < n; ++k)
      if(!(result[k] >= 0. && std::isfinite(result[k])))
        throw Program_error("the density of ", std::string(is_of_vertices ? "vertex " : "face "), k,
                            " is negative, infinite or not a number. (Vertices and faces are counted from 0.)");
    if(std::all_of(result.begin(), result.end(), [](double x) { return x == 0.; }))
      throw Program_error("the density is 0 everywhere: no part of the surface would have an area on the sphere");
    return result;
  });
}

} // namespace

Run_result run_area_descent(const Options& options, Input_mesh& input, const Sphere_map& sphere)
{
  bool is_of_vertices = false;
  const std::vector<double> density =
      options.density_file.empty() ? std::vector<double>() : read_density(options.density_file, input, is_of_vertices);
  return run_with_energy(options, [&](const auto& energy) {
    const auto run = [&](auto method) {
      Run_result result = run_parameterizer(method, options, input, sphere);
      result.areas = std::make_shared<const SP::Area_report>(method.area_report());
      return result;
    };
    const auto method = SP::Target_area_parameterizer_3<>().energy(energy).sharpness(options.sharpness);
    if(density.empty())
      return run(method);
    const auto run_by = [&](auto map) {
      for(std::size_t k = 0; k < density.size(); ++k)
        map[typename decltype(map)::key_type(static_cast<Mesh::size_type>(k))] = density[k];
      return run(method.target_density(map));
    };
    if(is_of_vertices)
      return run_by(input.mesh().add_property_map<Vertex_index, double>().first);
    return run_by(input.mesh().add_property_map<Mesh::Face_index, double>().first);
  });
}

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
