// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

// Measures the distortion of the maps of many meshes, and compares it with bounds.

#include "../include/Table.h"
#include "../include/mesh_files.h"
#include "../include/run_program.h"

#include <CGAL/spherical_parameterization.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Origin.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace po = boost::program_options;
using namespace benchmarks;

namespace {

// What the command line asks for, checked already.
struct Settings
{
  std::string energy;
  std::string preference;
  std::optional<unsigned int> iterations;

  std::string name() const { return energy + '/' + preference; }

  SP::Relative_sharpness_3 sharpness() const
  {
    if(preference == "average")
    {
      return SP::Relative_sharpness_3(0.);
    }
    if(preference == "worst")
    {
      return SP::Relative_sharpness_3(50.);
    }
    return SP::Relative_sharpness_3();
  }
};

// How good a map is.
struct Quality
{
  SP::Parameterization_report report;
  SP::Distortion_summary distortion;           // at the radius of the map
  SP::Distortion_statistics isometric_at_eq11; // at the radius of eq. 11
  bool is_certified;

  const SP::Distortion_statistics& statistics(const std::string& measure) const
  {
    if(measure == "D_iso")
    {
      return distortion.isometric;
    }
    if(measure == "D_iso_eq11")
    {
      return isometric_at_eq11;
    }
    if(measure == "D_angle")
    {
      return distortion.angle;
    }
    throw std::runtime_error("Bounds of " + measure + " are not known; of D_iso, D_iso_eq11 and D_angle they are.");
  }
};

// What the distortion of a map may be at most.
struct Bound
{
  std::string mesh, settings, measure;
  double maximum, average;
};

// Reads lines of a mesh, settings, a measure, its maximum and its average, in which '-' stands for no bound. Lines may be
// empty or comments, after '#'.
std::vector<Bound> read_bounds(const std::string& file)
{
  const auto parse = [](const std::string& word, double& bound) {
    bound = std::numeric_limits<double>::infinity();
    return word == "-" || boost::conversion::try_lexical_convert(word, bound);
  };

  std::ifstream in(file);
  if(!in)
  {
    throw std::runtime_error(file + ": cannot be read");
  }
  std::vector<Bound> bounds;
  for(std::string line; std::getline(in, line);)
  {
    if(line.empty() || line[0] == '#')
    {
      continue;
    }
    Bound bound;
    std::string maximum, average;
    if(!(std::istringstream(line) >> bound.mesh >> bound.settings >> bound.measure >> maximum >> average) ||
       !parse(maximum, bound.maximum) || !parse(average, bound.average))
    {
      throw std::runtime_error(file + ": not three words and two numbers: " + line);
    }
    bounds.push_back(bound);
  }
  return bounds;
}

template <class Energy, class Radius>
SP::Error_code parameterize(const Mesh& mesh, const Settings& settings, Sphere_map sphere,
                            SP::Parameterization_report& report)
{
  SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, Energy, CGAL::Default, Radius> parameterizer(
      Energy(), settings.sharpness());
  const SP::Error_code error =
      settings.iterations
          ? SP::parameterize(mesh, parameterizer, sphere, CGAL::parameters::number_of_iterations(*settings.iterations))
          : SP::parameterize(mesh, parameterizer, sphere);
  report = parameterizer.report();
  return error;
}

// As the command line program does: the lowest average is to be had at the radius that minimises the energy, the lowest
// maximum at that of eq. 11.
template <class Energy>
SP::Error_code parameterize(const Mesh& mesh, const Settings& settings, Sphere_map sphere,
                            SP::Parameterization_report& report)
{
  using Optimal = SP::Two_phase_radius_3<CGAL::Default, SP::Optimal_radius_3>;
  return settings.preference == "average" ? parameterize<Energy, Optimal>(mesh, settings, sphere, report)
                                          : parameterize<Energy, CGAL::Default>(mesh, settings, sphere, report);
}

SP::Error_code parameterize(const Mesh& mesh, const Settings& settings, Sphere_map sphere,
                            SP::Parameterization_report& report)
{
  if(settings.energy == "isometric")
  {
    return parameterize<SP::Isometric_energy_3>(mesh, settings, sphere, report);
  }
  if(settings.energy == "conformal")
  {
    return parameterize<SP::Conformal_energy_3, SP::Fixed_radius_3>(mesh, settings, sphere, report);
  }
  return parameterize<SP::Symmetric_Dirichlet_energy_3>(mesh, settings, sphere, report);
}

// The factor from the radius of the map to that of eq. 11. Computed from the areas here, because the library is what is
// being judged.
template <class FaceDistortionMap>
double scale_to_eq11(const Mesh& mesh, const Sphere_map& sphere, const FaceDistortionMap& distortions)
{
  double sum = 0., sum_of_inverses = 0.;
  for(const Mesh::Face_index f : mesh.faces())
  {
    if(std::isfinite(distortions[f].isometric)) // degenerate faces count nowhere
    {
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      const Mesh::Vertex_index a = mesh.source(h), b = mesh.target(h), c = mesh.target(mesh.next(h));
      const double ratio = std::sqrt(CGAL::squared_area(sphere[a], sphere[b], sphere[c]) /
                                     CGAL::squared_area(mesh.point(a), mesh.point(b), mesh.point(c)));
      sum += ratio;
      sum_of_inverses += 1. / ratio;
    }
  }
  return std::sqrt(std::sqrt(sum_of_inverses / sum));
}

Quality measure(Mesh& mesh, const Sphere_map& sphere, const SP::Parameterization_report& report)
{
  const auto distortions = mesh.add_property_map<Mesh::Face_index, SP::Face_distortion>("f:distortion").first;
  Quality quality;
  quality.report = report;
  quality.distortion = SP::measure_distortion(mesh, sphere, distortions);
  quality.is_certified = SP::is_bijective(mesh, sphere);

  const double scale = scale_to_eq11(mesh, sphere, distortions);
  const auto scaled_sphere = boost::make_function_property_map<Mesh::Vertex_index>(
      [&](Mesh::Vertex_index v) { return CGAL::ORIGIN + scale * (sphere[v] - CGAL::ORIGIN); });
  quality.isometric_at_eq11 = SP::measure_distortion(mesh, scaled_sphere).isometric;
  return quality;
}

std::vector<std::string> row(const std::string& name, const Mesh& mesh, const Quality& quality)
{
  std::vector<std::string> cells = {name, std::to_string(mesh.number_of_vertices())};
  const auto add = [&](double value, int digits) { cells.push_back(to_text(value, digits)); };
  for(const SP::Distortion_statistics* statistics : {&quality.distortion.isometric, &quality.isometric_at_eq11})
  {
    add(statistics->maximum, 3);
    add(statistics->average, 3);
    add(statistics->deviation, 3);
  }
  for(const SP::Distortion_statistics* statistics : {&quality.distortion.area, &quality.distortion.angle})
  {
    add(statistics->maximum, 3);
    add(statistics->average, 4);
  }
  cells.push_back(std::to_string(quality.report.number_of_iterations()));
  cells.push_back(SP::get_stop_message(quality.report.stop_reason));
  cells.push_back(quality.is_certified ? "yes" : "no");
  return cells;
}

int run_benchmark(const po::variables_map& options)
{
  Settings settings{options["energy"].as<std::string>(), options["prefer"].as<std::string>(), std::nullopt};
  if(options.count("iterations") > 0)
  {
    settings.iterations = options["iterations"].as<unsigned int>();
  }
  std::vector<Bound> bounds;
  if(options.count("bounds") > 0)
  {
    bounds = read_bounds(options["bounds"].as<std::string>());
  }
  const std::size_t most_vertices = options["most-vertices"].as<std::size_t>();

  Table table(std::cout,
              {"mesh", "vertices", "D_iso max", "D_iso avg", "D_iso dev", "D_iso_eq11 max", "D_iso_eq11 avg",
               "D_iso_eq11 dev", "D_area max", "D_area avg", "D_angle max", "D_angle avg", "sweeps", "stop reason",
               "certified"},
              options["csv"].as<bool>());
  std::vector<std::string> failures;
  std::size_t number_of_comparisons = 0;
  for(const std::filesystem::path& file : find_mesh_files(options["inputs"].as<std::vector<std::string>>()))
  {
    const std::string name = file.stem().string();
    const auto compare = [&](const std::string& what, double value, double bound) {
      number_of_comparisons += std::isfinite(bound);
      if(!(value <= bound))
      {
        failures.push_back(name + ": " + what + " is " + to_text(value, 4) + ", above " + to_text(bound, 4));
      }
    };
    try
    {
      Mesh mesh = read_mesh(file);
      if(mesh.number_of_vertices() > most_vertices)
      {
        continue;
      }
      const Sphere_map sphere = add_sphere_map(mesh);
      SP::Parameterization_report report;
      const SP::Error_code error = parameterize(mesh, settings, sphere, report);
      if(error != SP::OK)
      {
        throw std::runtime_error(SP::get_error_message(error));
      }
      const Quality quality = measure(mesh, sphere, report);
      table.add_row(row(name, mesh, quality));
      if(!quality.is_certified)
      {
        failures.push_back(name + ": is not certified");
      }
      for(const Bound& bound : bounds)
      {
        if(bound.mesh == name && bound.settings == settings.name())
        {
          const SP::Distortion_statistics& statistics = quality.statistics(bound.measure);
          compare(bound.measure + " max", statistics.maximum, bound.maximum);
          compare(bound.measure + " avg", statistics.average, bound.average);
        }
      }
    }
    catch(const std::exception& error)
    {
      failures.push_back(name + ": " + error.what());
    }
  }
  if(options.count("bounds") > 0)
  {
    std::cerr << number_of_comparisons << " bounds of " << settings.name() << " compared\n";
    if(number_of_comparisons == 0)
    {
      failures.push_back("There is none for these meshes and settings.");
    }
  }
  for(const std::string& failure : failures)
  {
    std::cerr << failure << '\n';
  }
  return failures.empty() ? 0 : 1;
}

// Refuses the values of an option that are not among `known`.
auto one_of(const std::string& option, const std::vector<std::string>& known)
{
  return [=](const std::string& value) {
    if(std::find(known.begin(), known.end(), value) == known.end())
    {
      std::string message = "--" + option + " is one of:";
      for(const std::string& other : known)
      {
        message += ' ' + other;
      }
      throw po::error(message);
    }
  };
}

} // namespace

int main(int argc, char* argv[])
{
  po::options_description options("Options");
  auto add = options.add_options();
  add("energy",
      po::value<std::string>()
          ->default_value("symmetric-dirichlet")
          ->notifier(one_of("energy", {"symmetric-dirichlet", "isometric", "conformal"})),
      "symmetric-dirichlet, isometric or conformal");
  add("prefer",
      po::value<std::string>()->default_value("balance")->notifier(one_of("prefer", {"average", "balance", "worst"})),
      "average, balance or worst");
  add("iterations", po::value<unsigned int>(), "sweeps at the finest level, at most");
  add("most-vertices", po::value<std::size_t>()->default_value((std::numeric_limits<std::size_t>::max)(), "any number"),
      "skip the meshes with more vertices");
  add("bounds", po::value<std::string>(), "bounds that the distortions are compared with");
  return run_program(argc, argv,
                     "Prints the distortion of the map of each mesh, at the radius of the map and at that of eq. 11.\n"
                     "Fails if a map is not certified, or above one of its bounds.",
                     options, run_benchmark);
}
