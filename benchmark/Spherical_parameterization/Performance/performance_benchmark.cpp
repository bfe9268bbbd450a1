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
#include "../include/median.h"
#include "../include/mesh_files.h"
#include "../include/run_in_child_process.h"
#include "../include/run_program.h"

#include <CGAL/spherical_parameterization.h>

#include <CGAL/Real_timer.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
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
  std::array<char, 240> error_message{};
  double vertices = 0.;
  double seconds_for_parsing = 0.;
  double seconds_for_parameterization = 0.;
  SP::Parameterization_report report;
  double peak_bytes = 0.;
  std::uint64_t fingerprint = 0; // of the map
  SP::Distortion_statistics isometric{};

  void fail(const std::string& message) { message.copy(error_message.data(), error_message.size() - 1); }
};

// A number that two maps of the same mesh have in common if, and practically only if, they have the same bits.
std::uint64_t fingerprint(const Mesh& mesh, const Sphere_map& sphere)
{
  std::uint64_t hash = 14695981039346656037u; // FNV-1a, eight bytes at once
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    for(int i = 0; i < 3; ++i)
    {
      const double coordinate = CGAL::to_double(sphere[v][i]);
      std::uint64_t bits;
      static_assert(sizeof(bits) == sizeof(coordinate), "The bits of a double are taken as they are.");
      std::memcpy(&bits, &coordinate, sizeof(bits));
      hash = (hash ^ bits) * 1099511628211u;
      hash ^= hash >> 32; // multiplication carries nothing down
    }
  }
  return hash;
}

Run run(const std::filesystem::path& file, std::optional<unsigned int> iterations)
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
    if(iterations)
    {
      parameterizer.set_number_of_iterations(*iterations);
    }
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
      result.fingerprint = fingerprint(mesh, sphere);
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
double median_of(const std::vector<Run>& runs, const Value& value)
{
  std::vector<double> values;
  for(const Run& run : runs)
  {
    values.push_back(value(run));
  }
  return median(values);
}

std::string to_hexadecimal(std::uint64_t number)
{
  std::ostringstream text;
  text << std::hex << std::setfill('0') << std::setw(16) << number;
  return text.str();
}

// `digits` are those of the seconds.
std::vector<std::string> row(const std::string& name, const std::vector<Run>& runs, int digits)
{
  const auto seconds = [&](const auto& value) { return to_text(median_of(runs, value), digits); };
  const double vertices = runs[0].vertices;
  const double parameterization = median_of(runs, [](const Run& r) { return r.seconds_for_parameterization; });
  const double peak_bytes = median_of(runs, [](const Run& r) { return r.peak_bytes; });
  return {name,
          to_text(vertices, 0),
          seconds([](const Run& r) { return r.seconds_for_parsing; }),
          seconds([](const Run& r) { return r.report.seconds_for_reading; }),
          seconds([](const Run& r) { return r.report.seconds_for_hierarchy; }),
          seconds([](const Run& r) { return r.report.seconds_for_embedding; }),
          seconds([](const Run& r) { return r.report.seconds_for_optimization; }),
          seconds([](const Run& r) { return r.report.seconds_for_certificate; }),
          to_text(parameterization, digits),
          seconds([](const Run& r) { return r.seconds_for_parsing + r.seconds_for_parameterization; }),
          to_text(vertices / parameterization, 0),
          to_text(1e6 * parameterization / vertices, 1),
          std::isnan(peak_bytes) ? "-" : to_text(peak_bytes / vertices, 0),
          std::to_string(runs[0].report.number_of_level_iterations),
          std::to_string(runs[0].report.number_of_iterations()),
          to_text(runs[0].isometric.maximum, digits),
          to_text(runs[0].isometric.average, digits),
          to_hexadecimal(runs[0].fingerprint)};
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
  std::optional<unsigned int> iterations;
  if(options.count("iterations") > 0)
  {
    iterations = options["iterations"].as<unsigned int>();
  }
  const bool is_csv = options["csv"].as<bool>();
  const int digits = is_csv ? 6 : 3; // a program may go on calculating

  Table table(std::cout,
              {"mesh", "vertices", "parsing", "reading", "hierarchy", "embedding", "optimization", "certificate",
               "mesh to map", "file to map", "vertices/s", "us/vertex", "bytes/vertex", "level sweeps", "sweeps",
               "D_iso max", "D_iso avg", "fingerprint"},
              is_csv);
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
          return run(file, iterations);
        }));
        if(runs.back().error_message[0] != 0)
        {
          throw std::runtime_error(runs.back().error_message.data());
        }
        if(runs.back().fingerprint != runs.front().fingerprint)
        {
          throw std::runtime_error("two runs have different results");
        }
      }
      table.add_row(row(name, runs, digits));
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
  options.add_options()("iterations", po::value<unsigned int>(),
                        "sweeps over the mesh at most, as the program's option");
  return run_program(
      argc, argv,
      "Prints the seconds of each stage of the default parameterization, the peak of the memory beside the\n"
      "mesh, the sweeps, the distortion at the radius of the map, and a fingerprint that equal maps have\n"
      "in common. Each run has a process of its own; all numbers are medians. The speeds are those from\n"
      "the mesh in memory to the certified map.",
      options, run_benchmark);
}
