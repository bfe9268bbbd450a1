// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

// Measures a sweep over meshes, and the least time that this machine would need for the bytes and the operations of it.

#include "Counting_update.h"
#include "Machine_rates.h"
#include "Sweep_work.h"

#include "../include/Table.h"
#include "../include/median.h"
#include "../include/mesh_files.h"
#include "../include/run_program.h"

#include <CGAL/spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/read_mesh.h>

#include <CGAL/Real_timer.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>

#include <thread>
#endif

#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace po = boost::program_options;
using namespace benchmarks;

namespace {

// A mesh with a map that is still being improved, as it is amid the default parameterization.
class Situation
{
public:
  explicit Situation(const std::filesystem::path& file)
  {
    Mesh mesh = read_mesh(file);
    const Sphere_map sphere = add_sphere_map(mesh);
    SP::Bijective_low_distortion_parameterizer_3<Mesh> parameterizer;
    parameterizer.set_number_of_iterations(n_sweeps_before);
    const SP::Error_code error = SP::parameterize(mesh, parameterizer, sphere);
    std::vector<Mesh::Vertex_index> vertices;
    SP::Parameterization_report report;
    if(error != SP::OK || Internal::read_mesh(mesh, get(CGAL::vertex_point, mesh), m_mesh, vertices, report) != SP::OK)
    {
      throw std::runtime_error(SP::get_error_message(error));
    }
    for(std::size_t v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      const Kernel::Point_3& p = sphere[vertices[m_mesh.original(v)]];
      m_positions.push_back(Internal::normalized({p.x(), p.y(), p.z()}));
    }
    m_radius = m_mesh.scaled_radius(parameterizer.report().radius);
  }

  const Internal::Vertex_rings& rings() const { return m_mesh.rings(); }

  // The median of the seconds of a sweep, each from the same map.
  template <class ConcurrencyTag, class Update>
  double seconds_for_sweep(const Update& update, std::size_t repetitions) const
  {
    using Energy = SP::Symmetric_Dirichlet_energy_3;
    Internal::Block_coordinate_descent<Energy, Update, ConcurrencyTag> descent(rings(), m_mesh.points(), Energy(),
                                                                               update);
    std::vector<double> seconds;
    for(std::size_t i = 0; i < repetitions; ++i)
    {
      std::vector<Internal::Vector_3d> positions = m_positions;
      const Internal::Energy_summary summary = descent.measure(positions, m_radius, 0.); // as before each sweep
      const double sharpness = SP::Relative_sharpness_3()(n_sweeps_before, summary.average(), summary.largest());
      CGAL::Real_timer timer;
      timer.start();
      descent.sweep(positions, m_radius, sharpness);
      seconds.push_back(timer.time());
    }
    return median(seconds);
  }

private:
  static constexpr unsigned int n_sweeps_before = 10;

  Internal::Indexed_mesh m_mesh;
  std::vector<Internal::Vector_3d> m_positions; // on the unit sphere
  double m_radius;
};

std::vector<std::string> row(const std::string& name, const Situation& situation, std::size_t threads,
                             std::size_t repetitions)
{
  Evaluation_counts counts;
  situation.seconds_for_sweep<CGAL::Sequential_tag>(Counting_update(counts), 1);
  const Sweep_work work(situation.rings(), counts);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#endif
  const double seconds =
      situation.seconds_for_sweep<CGAL::Parallel_if_available_tag>(SP::Newton_update_3(), repetitions);
  const Machine_rates rates(threads, static_cast<std::size_t>(work.bytes));

  const double n = static_cast<double>(situation.rings().number_of_vertices());
  const auto per_vertex = [n](double x, int digits = 1) { return to_text(x / n, digits); };
  const double for_bytes = work.seconds_for_bytes(rates), for_operations = work.seconds_for_operations(rates);
  return {name,
          to_text(n, 0),
          std::to_string(threads),
          per_vertex(1e9 * seconds),
          per_vertex(static_cast<double>(counts.derivatives), 3),
          per_vertex(static_cast<double>(counts.values), 3),
          per_vertex(work.bytes),
          per_vertex(work.sums_and_products),
          per_vertex(work.divisions),
          per_vertex(work.square_roots),
          per_vertex(work.exponentials),
          to_text(1e-9 * rates.bytes, 2),
          to_text(1e-9 * rates.sums_and_products, 3),
          to_text(1e-9 * rates.divisions, 3),
          to_text(1e-9 * rates.square_roots, 3),
          to_text(1e-9 * rates.exponentials, 3),
          per_vertex(1e9 * for_bytes),
          per_vertex(1e9 * for_operations),
          to_text(seconds / for_bytes, 2),
          to_text(seconds / for_operations, 2)};
}

int run_benchmark(const po::variables_map& options)
{
  const std::size_t repetitions = options["repeat"].as<std::size_t>();
  if(repetitions == 0)
  {
    throw po::error("--repeat must be at least 1.");
  }
  std::vector<std::size_t> numbers_of_threads = {1};
#ifdef CGAL_LINKED_WITH_TBB
  std::size_t most_threads = options["threads"].as<std::size_t>();
  if(most_threads == 0)
  {
    most_threads = std::thread::hardware_concurrency();
  }
  if(most_threads > 1)
  {
    numbers_of_threads.push_back(most_threads);
  }
#endif

  Table table(std::cout,
              {"mesh",
               "vertices",
               "threads",
               "sweep ns/vertex",
               "derivatives/vertex",
               "values/vertex",
               "bytes/vertex",
               "sums and products/vertex",
               "divisions/vertex",
               "roots/vertex",
               "exponentials/vertex",
               "GB/s",
               "G sums and products/s",
               "G divisions/s",
               "G roots/s",
               "G exponentials/s",
               "ns for bytes",
               "ns for operations",
               "sweep/bytes",
               "sweep/operations"},
              options["csv"].as<bool>());
  int status = 0;
  for(const std::filesystem::path& file : find_mesh_files(options["inputs"].as<std::vector<std::string>>()))
  {
    try
    {
      const Situation situation(file);
      for(const std::size_t threads : numbers_of_threads)
      {
        table.add_row(row(file.stem().string(), situation, threads, repetitions));
      }
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
  options.add_options()("threads", po::value<std::size_t>()->default_value(0),
                        "threads at most, besides one thread; 0: one for each core");
#endif
  options.add_options()("repeat", po::value<std::size_t>()->default_value(15), "sweeps over each mesh");
  return run_program(
      argc, argv,
      "Prints how long a sweep of the default parameterization takes, the median of many with one thread and\n"
      "with all; what it has to do at least, counted from its data and its formulas; what this machine does\n"
      "at best, measured in simple loops with the same flags; and the ratio of the sweep to the times that\n"
      "follow for the bytes alone and for the operations alone. The rate of memory is that of arrays as\n"
      "large as the data of the sweep, which may fit into a cache.",
      options, run_benchmark);
}
