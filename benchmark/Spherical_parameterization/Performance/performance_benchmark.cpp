// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

// Measures how long the default parameterization takes, stage by stage, and how much memory it needs.

#include "../include/Peak_memory.h"
#include "../include/Table.h"
#include "../include/mesh_files.h"
#include "../include/run_in_child_process.h"
#include "../include/run_program.h"

#include <CGAL/spherical_parameterization.h>

#include <CGAL/Real_timer.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace po = boost::program_options;
using namespace benchmarks;

namespace {

// What one run tells, or why there was none.
struct Run
{
  std::array<char, 256> error_message{};
  double vertices = 0.;
  double seconds_for_parsing = 0.;
  double seconds_for_parameterization = 0.;
  SP::Parameterization_report report;
  double peak_bytes = 0.;
  SP::Distortion_statistics isometric{};

  void fail(const std::string& message) { message.copy(error_message.data(), error_message.size() - 1); }
};

Run run(const std::filesystem::path& file)
{
  Run result;
  try
  {
    CGAL::Real_timer timer;
    timer.start();
    Mesh mesh = read_mesh(file);
    result.seconds_for_parsing = timer.time();
    result.vertices = static_cast<double>(mesh.number_of_vertices());
    const Sphere_map sphere = add_sphere_map(mesh);

    SP::Bijective_low_distortion_parameterizer_3<Mesh> parameterizer;
    const Peak_memory memory;
    timer.reset();
    const SP::Error_code error = SP::parameterize(mesh, parameterizer, sphere);
    result.seconds_for_parameterization = timer.time();
    result.peak_bytes = memory.bytes();
    result.report = parameterizer.report();
    if(error != SP::OK)
    {
      result.fail(SP::get_error_message(error));
    }
    else if(!SP::is_bijective(mesh, sphere))
    {
      result.fail("is not certified by is_bijective()");
    }
    else
    {
      result.isometric = SP::measure_distortion(mesh, sphere).isometric;
    }
  }
  catch(const std::exception& error)
  {
    result.fail(error.what());
  }
  return result;
}

template <class Value>
double median(const std::vector<Run>& runs, const Value& value)
{
  std::vector<double> values;
  for(const Run& run : runs)
  {
    values.push_back(value(run));
  }
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

std::vector<std::string> row(const std::string& name, const std::vector<Run>& runs)
{
  const auto seconds = [&](const auto& value) { return to_text(median(runs, value), 3); };
  const double vertices = runs[0].vertices;
  const double parameterization = median(runs, [](const Run& r) { return r.seconds_for_parameterization; });
  const double peak_bytes = median(runs, [](const Run& r) { return r.peak_bytes; });
  return {name,
          to_text(vertices, 0),
          seconds([](const Run& r) { return r.seconds_for_parsing; }),
          seconds([](const Run& r) { return r.report.seconds_for_reading; }),
          seconds([](const Run& r) { return r.report.seconds_for_hierarchy; }),
          seconds([](const Run& r) { return r.report.seconds_for_embedding; }),
          seconds([](const Run& r) { return r.report.seconds_for_optimization; }),
          seconds([](const Run& r) { return r.report.seconds_for_certificate; }),
          to_text(parameterization, 3),
          seconds([](const Run& r) { return r.seconds_for_parsing + r.seconds_for_parameterization; }),
          to_text(vertices / parameterization, 0),
          to_text(1e6 * parameterization / vertices, 1),
          std::isnan(peak_bytes) ? "-" : to_text(peak_bytes / vertices, 0),
          to_text(runs[0].isometric.maximum, 3),
          to_text(runs[0].isometric.average, 3)};
}

int run_benchmark(const po::variables_map& options)
{
  const std::size_t repetitions = options["repeat"].as<std::size_t>();
  if(repetitions == 0)
  {
    throw po::error("--repeat must be at least 1.");
  }
#ifdef CGAL_LINKED_WITH_TBB
  const std::size_t threads = options["threads"].as<std::size_t>();
#endif

  Table table(std::cout,
              {"mesh", "vertices", "parsing", "reading", "hierarchy", "embedding", "optimization", "certificate",
               "mesh to map", "file to map", "vertices/s", "us/vertex", "bytes/vertex", "D_iso max", "D_iso avg"},
              options["csv"].as<bool>());
  int status = 0;
  for(const std::filesystem::path& file : find_mesh_files(options["inputs"].as<std::vector<std::string>>()))
  {
    const std::string name = file.stem().string();
    try
    {
      std::vector<Run> runs;
      for(std::size_t i = 0; i < repetitions; ++i)
      {
        runs.push_back(run_in_child_process([&] {
#ifdef CGAL_LINKED_WITH_TBB
          std::optional<tbb::global_control> control;
          if(threads > 0)
          {
            control.emplace(tbb::global_control::max_allowed_parallelism, threads);
          }
#endif
          return run(file);
        }));
        if(runs.back().error_message[0] != 0)
        {
          throw std::runtime_error(runs.back().error_message.data());
        }
      }
      table.add_row(row(name, runs));
    }
    catch(const std::exception& error)
    {
      std::cerr << file.string() << ": " << error.what() << std::endl;
      status = 1;
    }
  }
  return status;
}

} // namespace

int main(int argc, char* argv[])
{
  po::options_description options("Options");
#ifdef CGAL_LINKED_WITH_TBB
  options.add_options()("threads", po::value<std::size_t>()->default_value(0), "threads at most; 0: one for each core");
#endif
  options.add_options()("repeat", po::value<std::size_t>()->default_value(5), "runs of each mesh");
  return run_program(
      argc, argv,
      "Prints the seconds of each stage of the default parameterization, the peak of the memory beside the\n"
      "mesh, and the distortion at the radius of the map. Each run has a process of its own; all numbers\n"
      "are medians. The speeds are those from the mesh in memory to the certified map.",
      options, run_benchmark);
}
