// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

// Measures the kernels of the default method one by one, with Google Benchmark.

#include "Kernel_situation.h"

#include <CGAL/tags.h>

#include <benchmark/benchmark.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

using benchmarks::Kernel_situation;
using benchmarks::Work;

namespace {

// Runs a kernel as often as Google Benchmark wants; `restore()` is called before each time and not measured.
template <class Kernel, class Restore>
void run(benchmark::State& state, const Kernel& kernel, const Restore& restore)
{
  std::size_t items = 0;
  for(auto _ : state)
  {
    state.PauseTiming();
    restore();
    state.ResumeTiming();
    Work work = kernel();
    benchmark::DoNotOptimize(work.result);
    items += work.items;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(items));
}

template <class Kernel>
void run(benchmark::State& state, const Kernel& kernel)
{
  std::size_t items = 0;
  for(auto _ : state)
  {
    Work work = kernel();
    benchmark::DoNotOptimize(work.result);
    items += work.items;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(items));
}

// Registers a kernel that uses one thread. The time of the processor is what counts: others may be using it as well.
template <class... Functions>
void add(const std::string& name, const Functions&... functions)
{
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    run(state, functions...);
  })->Unit(benchmark::kMicrosecond);
}

#ifdef CGAL_LINKED_WITH_TBB
// Registers a kernel that uses several threads.
template <class... Functions>
void add_parallel(const std::string& name, const Functions&... functions)
{
  constexpr std::size_t number_of_threads = 2;
  benchmark::RegisterBenchmark((name + '_' + std::to_string(number_of_threads) + "_threads").c_str(),
                               [=](benchmark::State& state) {
                                 const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                                                   number_of_threads);
                                 run(state, functions...);
                               })
      ->Unit(benchmark::kMicrosecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}
#endif

void add_kernels(Kernel_situation& situation)
{
  using Sequential_tag = CGAL::Sequential_tag;

  const auto restore_positions = [&] { situation.restore_positions(); };
  const auto restore_hierarchy = [&] { situation.restore_hierarchy(); };
  add("star_load", [&] { return situation.load_stars(); });
  add("star_value", [&] { return situation.evaluate_stars(); });
  add("star_derivatives", [&] { return situation.differentiate_stars(); });
  add("star_update", [&] { return situation.update_stars(); });
  add(
      "sweep", [&] { return situation.sweep<Sequential_tag>(); }, restore_positions);
  add("measurement", [&] { return situation.measure<Sequential_tag>(); });
  add("focus", [&] { return situation.find_focus(); });
  add("descent_setup", [&] { return situation.prepare_descent<Sequential_tag>(); });
  add("coloring", [&] { return situation.color(); });
  add("removal_cost", [&] { return situation.cost_removals(); });
  add("coarsening", [&] { return situation.coarsen<Sequential_tag>(); });
  add("insertion", [&] { return situation.insert(); });
  add(
      "embedding", [&] { return situation.embed<Sequential_tag>(); }, restore_hierarchy);
  add("reading", [&] { return situation.read(); });
  add("certificate", [&] { return situation.certify<Sequential_tag>(); });
#ifdef CGAL_LINKED_WITH_TBB
  using Parallel_tag = CGAL::Parallel_tag;

  add_parallel(
      "sweep", [&] { return situation.sweep<Parallel_tag>(); }, restore_positions);
  add_parallel("measurement", [&] { return situation.measure<Parallel_tag>(); });
  add_parallel("descent_setup", [&] { return situation.prepare_descent<Parallel_tag>(); });
  add_parallel("coarsening", [&] { return situation.coarsen<Parallel_tag>(); });
  add_parallel(
      "embedding", [&] { return situation.embed<Parallel_tag>(); }, restore_hierarchy);
  add_parallel("certificate", [&] { return situation.certify<Parallel_tag>(); });
#endif
}

void print_usage(const char* program)
{
  std::cout
      << "Usage: " << program
      << " [OPTIONS] [--map=FILE] [MESH]\n"
         "Measures the kernels of the default method on a mesh, by default CGAL's armadillo, and a map of it that\n"
         "is some sweeps from its end: every call does the same work. If there is a FILE, the map is read from it;\n"
         "if not, it is written, so that another build can be measured by the same work. Items are stars, vertices\n"
         "or faces. What compares two builds is compare_builds.py.\n\n";
}

} // namespace

int main(int argc, char* argv[])
{
  if(std::find(argv, argv + argc, std::string("--help")) != argv + argc)
  {
    print_usage(argv[0]);
  }
  benchmark::Initialize(&argc, argv); // takes its options away; --help ends here
  const std::string map_option = "--map=";
  std::string mesh_file, map_file;
  for(const std::string& argument : std::vector<std::string>(argv + 1, argv + argc))
  {
    if(argument.compare(0, map_option.size(), map_option) == 0)
    {
      map_file = argument.substr(map_option.size());
    }
    else if(argument[0] != '-' && mesh_file.empty())
    {
      mesh_file = argument;
    }
    else
    {
      print_usage(argv[0]);
      return EXIT_FAILURE;
    }
  }
  if(mesh_file.empty())
  {
    mesh_file = CGAL::data_file_path("meshes/armadillo.off");
  }
  try
  {
    Kernel_situation situation(mesh_file, map_file);
    add_kernels(situation);
    benchmark::RunSpecifiedBenchmarks();
  }
  catch(const std::exception& error)
  {
    std::cerr << mesh_file << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
