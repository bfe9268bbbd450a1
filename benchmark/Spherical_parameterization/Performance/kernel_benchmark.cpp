// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

// Measures the kernels of the default method one by one, the whole of it, and what the machine does at best, with Google
// Benchmark.

#include "machine_rates.h"

#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/sampling.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/descent/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Objective.h>
#include <CGAL/Spherical_parameterization/internal/descent/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/descent/Hierarchical_embedding.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Vertex_removal.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/run/run_parameterization.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Origin.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

namespace SP = CGAL::Spherical_parameterization;
namespace internal = SP::internal;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Sphere_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>;
using Energy = SP::Symmetric_Dirichlet_energy_3;
using internal::Execution;
using internal::Vector_3d;

struct Options
{
  std::string mesh_file, map_file;
  std::size_t number_of_threads = 2; // of the kernels that use several
} options;

Mesh read_off(const std::string& file)
{
  Mesh mesh;
  std::ifstream in(file);
  if(!(in >> mesh))
    throw std::runtime_error(file + ": cannot be read");
  return mesh;
}

void check(SP::Error_code error)
{
  if(error != SP::OK)
    throw std::runtime_error(options.mesh_file + ": " + SP::get_error_message(error));
}

// A run without a visitor and a limit.
struct Unlimited_run
{
  internal::Visitor_control<std::decay_t<decltype(CGAL::parameters::default_values())>> control{
      CGAL::parameters::default_values()};
};

template <class Step>
using Descent = internal::Block_coordinate_descent<internal::Round_sphere<Energy, Step>, Step>;

using Sphere = internal::Round_sphere<Energy, internal::Newton_step>;

template <class Step>
void assign(Descent<Step>& descent, const internal::Surface& mesh)
{
  descent.assign(mesh.rings(), internal::Independent_sets(mesh.rings()), mesh.points(), {}, internal::Rest_limits());
}

// A mesh and a map of it that is still some sweeps from its end, as most sweeps of a run find it: every call of a kernel
// does the same work.
class Situation
{
public:
  // Reads the mesh, and the map if there is a file for it; if there is a name but no file, the map is made and written.
  Situation()
    : tmesh(read_off(options.mesh_file))
    , sphere(tmesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:sphere").first)
  {
    internal::Mesh_arrays<Mesh> arrays;
    check(internal::read_surface(tmesh, tmesh.points(), arrays, mesh));
    const Mesh map = std::ifstream(options.map_file) ? read_off(options.map_file) : make_map();
    if(map.number_of_vertices() != tmesh.number_of_vertices())
      throw std::runtime_error(options.map_file + ": the map is not that of the mesh");
    std::vector<Vector_3d> directions = internal::read_points(arrays.vertices_of_mesh, map.points());
    for(std::size_t v = 0; v < directions.size(); ++v)
    {
      const Vector_3d& p = directions[v] = internal::normalized(directions[v]);
      images.emplace_back(p[0], p[1], p[2]);
      sphere[arrays.vertices_of_mesh[v]] = images[v];
    }
    positions = mesh.in_own_order(directions);
    triangles = std::move(arrays.triangles);
    if(!internal::certify_bijectivity<Kernel>(images, triangles, Execution()).is_bijective())
      throw std::runtime_error(options.map_file + ": the map is not one-to-one");

    Descent<internal::Newton_step>& sequential = descent(Execution());
    sequential.measure(positions, radius, objective.of_faces());
    for(int k = 0; k < 10; ++k) // the best radius for the map
      radius *= std::exp(sequential.radius_step(radius, objective.of_faces()));
    const internal::Energy_summary summary = sequential.measure(positions, radius, objective.of_faces());
    max_energy = summary.maximum_energy();
    objective.start_sweep(0, summary);
    for(int k = 0; k < 10; ++k) // the best level
      objective.improve_level(sequential.measure(positions, radius, objective.of_faces()));
  }
  Situation(const Situation&) = delete;
  Situation& operator=(const Situation&) = delete;

  // Made when it is needed first.
  Descent<internal::Newton_step>& descent(Execution execution)
  {
    std::optional<Descent<internal::Newton_step>>& result = m_descents[execution.run != Execution().run];
    if(!result)
      assign(result.emplace(Sphere(internal::Face_energy<Energy>(Energy())), internal::Newton_step(), execution), mesh);
    return *result;
  }

  std::size_t number_of_vertices() const { return mesh.number_of_vertices(); }

  Mesh tmesh;
  Sphere_map sphere; // of its vertices
  internal::Surface mesh;
  std::vector<Vector_3d> positions; // on the unit sphere
  std::vector<Kernel::Point_3> images;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double radius = 1., max_energy = 0.;
  internal::Objective objective{SP::Sharpness(), true};

private:
  static constexpr unsigned int sweeps_of_map = 10;

  Mesh make_map() const
  {
    Mesh result = tmesh;
    check(SP::parameterize(tmesh, result.points(), CGAL::parameters::number_of_iterations(sweeps_of_map)));
    if(!options.map_file.empty())
    {
      std::ofstream out(options.map_file);
      out.precision(std::numeric_limits<double>::max_digits10);
      if(!(out << result))
        throw std::runtime_error(options.map_file + ": cannot be written");
    }
    return result;
  }

  std::array<std::optional<Descent<internal::Newton_step>>, 2> m_descents;
};

Situation& situation()
{
  static Situation result;
  return result;
}

// The kernels. Each returns how many vertices or faces it has worked on; what it computes must not be optimized away.

std::size_t read(Situation& s, Execution, benchmark::State&)
{
  internal::Mesh_arrays<Mesh> arrays;
  internal::Surface mesh;
  benchmark::DoNotOptimize(internal::read_surface(s.tmesh, s.tmesh.points(), arrays, mesh));
  return s.number_of_vertices();
}

std::size_t color(Situation& s, Execution, benchmark::State&)
{
  benchmark::DoNotOptimize(internal::Independent_sets(s.mesh.rings()).first.size());
  return s.number_of_vertices();
}

std::size_t set_descent_up(Situation& s, Execution execution, benchmark::State&)
{
  Descent<internal::Newton_step> descent(Sphere(internal::Face_energy<Energy>(Energy())), internal::Newton_step(),
                                         execution);
  assign(descent, s.mesh);
  benchmark::DoNotOptimize(descent.stars().number_of_packets());
  return s.number_of_vertices();
}

std::size_t sweep(Situation& s, Execution execution, benchmark::State& state)
{
  state.PauseTiming();
  std::vector<Vector_3d> positions = s.positions;
  Descent<internal::Newton_step>& descent = s.descent(execution);
  state.ResumeTiming();
  descent.sweep(positions, s.radius, s.objective.of_faces());
  benchmark::DoNotOptimize(positions.data());
  return s.number_of_vertices();
}

std::size_t measure(Situation& s, Execution execution, benchmark::State&)
{
  benchmark::DoNotOptimize(
      s.objective.value(s.descent(execution).measure(s.positions, s.radius, s.objective.of_faces())));
  return s.triangles.size();
}

std::size_t find_focus(Situation& s, Execution, benchmark::State&)
{
  constexpr double share_of_largest = 0.8; // this and the bound on their number as by default
  const std::size_t max = s.number_of_vertices() / 5;
  Descent<internal::Newton_step>& descent = s.descent(Execution());
  benchmark::DoNotOptimize(descent.focus_on_faces_above(share_of_largest * s.max_energy, max));
  return s.number_of_vertices();
}

std::size_t cost_removals(Situation& s, Execution, benchmark::State&)
{
  for(std::size_t v = 0; v < s.number_of_vertices(); ++v)
    benchmark::DoNotOptimize(
        internal::Vertex_removal::best(s.mesh.rings(), s.mesh.points(), static_cast<std::uint32_t>(v), false).rank);
  return s.number_of_vertices();
}

internal::Mesh_hierarchy build_hierarchy(const internal::Surface& mesh, internal::Run_control& control,
                                         Execution execution)
{
  return internal::Mesh_hierarchy(mesh.rings(), mesh.points(), vertex_areas(mesh.rings(), mesh.points()), control,
                                  execution);
}

std::size_t coarsen(Situation& s, Execution execution, benchmark::State&)
{
  Unlimited_run run;
  benchmark::DoNotOptimize(build_hierarchy(s.mesh, run.control, execution).number_of_levels());
  return s.number_of_vertices();
}

std::size_t embed(Situation& s, Execution execution, benchmark::State& state)
{
  state.PauseTiming();
  Unlimited_run run;
  internal::Mesh_hierarchy hierarchy = build_hierarchy(s.mesh, run.control, execution);
  state.ResumeTiming();
  std::vector<Vector_3d> positions(s.number_of_vertices());
  using Plan = internal::Hierarchical_embedding<Energy>;
  const internal::Level_settings settings = {internal::default_sweeps_per_level, false, SP::Sharpness(), {}};
  const internal::Rest_limits limits;
  Plan plan(internal::Face_energy<Energy>(Energy()), settings, limits, run.control, execution);
  internal::set_tetrahedron(hierarchy, positions);
  internal::Level_descent<Plan>(hierarchy, s.mesh.points(), limits, plan, run.control, execution).run(positions);
  benchmark::DoNotOptimize(positions.data());
  return s.number_of_vertices();
}

std::size_t certify(Situation& s, Execution execution, benchmark::State&)
{
  benchmark::DoNotOptimize(internal::certify_bijectivity<Kernel>(s.images, s.triangles, execution).degree);
  return s.triangles.size();
}

std::vector<Kernel::Point_3> random_directions()
{
  std::mt19937_64 random(1);
  std::vector<Kernel::Point_3> result;
  while(result.size() < 100000)
  {
    const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() >> 11), -52) - 1.; };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    if(x * x + y * y + z * z <= 1.)
      result.emplace_back(x, y, z);
  }
  return result;
}

// the pixels of a map of the sphere in rows, all but the poles
std::vector<Kernel::Point_3> coherent_directions()
{
  constexpr int n = 500;
  std::vector<Kernel::Point_3> result;
  for(int i = 1; i < n; ++i)
    for(int j = 0; j < 2 * n; ++j)
    {
      const double latitude = (static_cast<double>(i) / n - 0.5) * CGAL_PI, longitude = j * CGAL_PI / n;
      result.emplace_back(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                          std::sin(latitude));
    }
  return result;
}

using Locator = SP::Sphere_locator_3<Mesh, Sphere_map, CGAL::Sequential_tag>;

std::size_t set_locator_up(Situation& s, Execution, benchmark::State&)
{
  const Locator locator(s.tmesh, s.sphere);
  check(locator.error_code());
  return s.triangles.size();
}

std::size_t locate_random(Situation& s, Execution, benchmark::State&)
{
  static const Locator locator(s.tmesh, s.sphere);
  static const std::vector<Kernel::Point_3> directions = random_directions();
  for(const Kernel::Point_3& q : directions)
    benchmark::DoNotOptimize(locator.locate(q).second);
  return directions.size();
}

std::size_t locate_coherent(Situation& s, Execution, benchmark::State&)
{
  static const Locator locator(s.tmesh, s.sphere);
  static const std::vector<Kernel::Point_3> directions = coherent_directions();
  Locator::Hint hint;
  for(const Kernel::Point_3& q : directions)
    benchmark::DoNotOptimize(locator.locate(q, hint).second);
  return directions.size();
}

template <class ConcurrencyTag>
std::size_t locate_range(Situation& s)
{
  static const SP::Sphere_locator_3<Mesh, Sphere_map, ConcurrencyTag> locator(s.tmesh, s.sphere);
  static const std::vector<Kernel::Point_3> directions = random_directions();
  std::vector<Locator::Face_location> locations(directions.size());
  check(locator.locate(directions, locations.begin()));
  benchmark::DoNotOptimize(locations.data());
  return directions.size();
}

std::size_t locate_range(Situation& s, Execution execution, benchmark::State&)
{
  return execution.run == Execution().run ? locate_range<CGAL::Sequential_tag>(s)
                                          : locate_range<CGAL::Parallel_if_available_tag>(s);
}

// A million samples, to which three values are carried over. The domain is made before.
constexpr std::uint32_t division = 500;
constexpr const char* carried_values[] = {"v:first", "v:second", "v:third"};

template <class ConcurrencyTag>
std::size_t remesh(Situation& s)
{
  static const SP::Sphere_domain_3 domain = SP::Sphere_domain_3::octahedron(division);
  for(const char* name : carried_values)
    s.tmesh.add_property_map<Mesh::Vertex_index, double>(name);
  Mesh result;
  const auto sphere = result.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:sphere").first;
  check(SP::remesh_through_sphere<ConcurrencyTag>(s.tmesh, s.sphere, domain, result, sphere));
  for(const char* name : carried_values)
  {
    auto map = s.tmesh.add_property_map<Mesh::Vertex_index, double>(name).first;
    s.tmesh.remove_property_map(map);
  }
  return domain.directions().size();
}

std::size_t remesh(Situation& s, Execution execution, benchmark::State&)
{
  return execution.run == Execution().run ? remesh<CGAL::Sequential_tag>(s)
                                          : remesh<CGAL::Parallel_if_available_tag>(s);
}

// What it takes of that to build the mesh, with its properties.
std::size_t build_remesh(Situation&, Execution, benchmark::State&)
{
  static const SP::Sphere_domain_3 domain = SP::Sphere_domain_3::octahedron(division);
  static const std::vector<internal::Linked_triangle> triangles =
      internal::link_triangles(domain.triangles(), domain.directions().size());
  Mesh result;
  result.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:sphere");
  for(const char* name : carried_values)
    result.add_property_map<Mesh::Vertex_index, double>(name);
  internal::add_triangles(triangles, domain.directions().size(), result, [](const auto&, const auto&) {});
  return result.number_of_vertices();
}

// What the locator is compared with.
std::size_t locate_by_rays(Situation& s, Execution, benchmark::State&)
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh, Sphere_map>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  static const std::vector<Kernel::Point_3> directions = random_directions();
  static const std::unique_ptr<Tree> tree = [&] {
    auto result = std::make_unique<Tree>(faces(s.tmesh).begin(), faces(s.tmesh).end(), s.tmesh, s.sphere);
    result->build();
    return result;
  }();
  for(const Kernel::Point_3& q : directions)
    benchmark::DoNotOptimize(tree->first_intersected_primitive(Kernel::Ray_3(CGAL::ORIGIN, q)));
  return directions.size();
}

// The physical memory that this process has at most, beyond what it has when this object is made. The code of a program,
// which is read when it is first needed and is there once for all processes, does not count. Only Linux reports it.
class Peak_memory
{
public:
  Peak_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0); // what the allocator keeps of released memory would be used again without a trace
#endif
    std::ofstream("/proc/self/clear_refs") << 5; // the peak starts anew
    m_first = read_bytes("VmRSS:") - read_bytes("RssFile:");
  }

  double bytes() const
  {
    return read_bytes("VmHWM:") - read_bytes("RssFile:") - m_first;
  }

private:
  static double read_bytes(const std::string& field)
  {
    std::ifstream status("/proc/self/status");
    double kilobytes;
    for(std::string word; status >> word;)
      if(word == field && status >> kilobytes)
        return 1024. * kilobytes;
    return std::numeric_limits<double>::quiet_NaN();
  }

  double m_first;
};

template <class ConcurrencyTag>
void parameterize(benchmark::State& state)
{
  Mesh mesh = read_off(options.mesh_file);
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:sphere").first;
  const double n = static_cast<double>(mesh.number_of_vertices());
  for(auto _ : state)
  {
    const Peak_memory memory;
    check(SP::parameterize<ConcurrencyTag>(mesh, sphere));
    state.counters["bytes_per_vertex"] = memory.bytes() / n;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(n));
}

// Moves vertices one by one as the default step does, and counts how often it evaluates the energies of their stars.
class Counting_step
{
public:
  struct Counts
  {
    double with_derivatives = 0., without = 0.;
  };

  template <class FT>
  using Image_measure = internal::Newton_step::Image_measure<FT>;
  static constexpr bool is_lanewise = false;

  explicit Counting_step(Counts& counts)
    : m_counts(&counts)
  {}

  template <class StarEnergy>
  bool operator()(const StarEnergy& energy, std::array<double, 2>& step) const
  {
    return internal::Newton_step()(Counted<StarEnergy>{energy, *m_counts}, step);
  }

private:
  template <class StarEnergy>
  struct Counted
  {
    const StarEnergy& energy;
    Counts& counts;

    double derivatives(std::array<double, 2>& gradient, std::array<double, 3>& hessian) const
    {
      ++counts.with_derivatives;
      return energy.derivatives(gradient, hessian);
    }
    double operator()(double x, double y) const
    {
      ++counts.without;
      return energy(x, y);
    }
    double shortest_edge() const { return energy.shortest_edge(); }
  };

  Counts* m_counts;
};

// The bytes that a sweep has to read or write at least: each array once, the positions twice. That the positions of the
// neighbours are read again and again is left to the caches.
double bytes_of_sweep()
{
  const internal::Vertex_rings& rings = situation().mesh.rings();
  const std::size_t per_corner = sizeof(std::uint32_t) + sizeof(internal::Rest_triangle); // neighbour and rest shape
  const std::size_t per_vertex = 2 * sizeof(std::uint32_t) + 2 * sizeof(Vector_3d);       // its place and its number
  return static_cast<double>(rings.number_of_corners() * per_corner + rings.number_of_vertices() * per_vertex);
}

// What a sweep has to do at least, by vertex: the bytes and operations on doubles that its formulas ask for, of which
// nothing is done twice and none is a factor 0, 1 or -1.
void add_work_of_sweep(benchmark::State& state)
{
  struct Operations
  {
    double sums_and_products, divisions, square_roots, exponentials;
  };
  // Counted in the formulas for the symmetric Dirichlet energy, the determinant and a positive sharpness.
  // the tangent frame, and the length of the shortest edge; from the frame to space (18), and to length 1 (10)
  constexpr Operations star = {37, 1, 1, 0};
  // The offset of the neighbour in the frame (18) and its squared length (5); the part of I that does not move (10),
  // the gradient of the determinant (13), I and d (7), and the energy (4).
  constexpr Operations corner = {57, 1, 0, 0};
  // The derivatives of I and d (14), those of the energy in them (7, 1 / d^2 being known), the chain rule (28), the
  // exponential and its derivatives (16), and the sums (6).
  constexpr Operations corner_of_derivatives = {71, 0, 0, 1};
  // the inverse of the modulus of the Hessian (15), the step (14), its slope and its squared length (7)
  constexpr Operations newton_step = {36, 3, 1, 0};
  // The offset from the new place (3), the determinant (14), the squared length (5), I and d (7), the energy (4),
  // whether the face is safely positive (2), and its share of the objective (3).
  constexpr Operations corner_of_value = {38, 1, 0, 1};
  // the height above the tangent plane
  constexpr Operations value = {6, 1, 1, 0};

  static const Counting_step::Counts counts = [] {
    Situation& s = situation();
    Counting_step::Counts result;
    const internal::Round_sphere<Energy, Counting_step> sphere{internal::Face_energy<Energy>{Energy()}};
    Descent<Counting_step> descent{sphere, Counting_step(result), Execution()};
    assign(descent, s.mesh);
    std::vector<Vector_3d> positions = s.positions;
    descent.sweep(positions, s.radius, s.objective.of_faces());
    return result;
  }();
  const double n = static_cast<double>(situation().number_of_vertices());
  const double degree = static_cast<double>(situation().mesh.rings().number_of_corners()) / n;
  const double derivatives = counts.with_derivatives / n, values = counts.without / n;
  const auto add = [&](const char* name, double Operations::*kind) {
    state.counters[name] = star.*kind + degree * corner.*kind + degree * derivatives * corner_of_derivatives.*kind +
                           derivatives * newton_step.*kind + degree * values * corner_of_value.*kind +
                           values * value.*kind;
  };
  add("sums_and_products", &Operations::sums_and_products);
  add("divisions", &Operations::divisions);
  add("square_roots", &Operations::square_roots);
  add("exponentials", &Operations::exponentials);
  state.counters["derivatives"] = derivatives;
  state.counters["values"] = values;
  state.counters["bytes"] = bytes_of_sweep() / n;
}

// Runs a kernel as often as Google Benchmark wants.
template <class Function>
void run(benchmark::State& state, const Function& kernel, Execution execution)
{
  Situation& s = situation();
  std::size_t items = 0;
  for(auto _ : state)
    items += kernel(s, execution, state);
  state.SetItemsProcessed(static_cast<std::int64_t>(items));
}

// Registers a benchmark that uses one thread. The time of the processor is what counts: others may be using it as well.
template <class Function>
benchmark::internal::Benchmark* add(const std::string& name, const Function& run)
{
  return benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond);
}

// Registers one that uses several.
template <class Function>
benchmark::internal::Benchmark* add_parallel(const std::string& name, const Function& run)
{
  const std::size_t n = options.number_of_threads;
  return add(name + '_' + std::to_string(n) + "_threads",
             [=](benchmark::State& state) {
#ifdef CGAL_LINKED_WITH_TBB
               const tbb::global_control control(tbb::global_control::max_allowed_parallelism, n);
#endif
               run(state);
             })
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}

void add_benchmarks()
{
  using Kernel_function = std::size_t (*)(Situation&, Execution, benchmark::State&);
  constexpr bool has_threads = std::is_convertible<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>::value;
  struct
  {
    const char* name;
    Kernel_function function;
    bool is_parallel;
  } const kernels[] = {{"measurement", measure, true},
                       {"focus", find_focus, false},
                       {"descent_setup", set_descent_up, true},
                       {"coloring", color, false},
                       {"removal_cost", cost_removals, false},
                       {"coarsening", coarsen, true},
                       {"embedding", embed, true},
                       {"reading", read, false},
                       {"certificate", certify, true},
                       {"location_setup", set_locator_up, false},
                       {"location_random", locate_random, false},
                       {"location_coherent", locate_coherent, false},
                       {"location_range", locate_range, true},
                       {"location_by_rays", locate_by_rays, false},
                       {"remesh", remesh, true},
                       {"remesh_building", build_remesh, false}};

  add("sweep", [](benchmark::State& state) {
    run(state, sweep, Execution());
    add_work_of_sweep(state);
  });
  for(const auto& kernel : kernels)
    add(kernel.name, [=](benchmark::State& state) { run(state, kernel.function, Execution()); });
  add("parameterization", parameterize<CGAL::Sequential_tag>)->Iterations(1);
  machine_rates::add(1, bytes_of_sweep);
  if(!has_threads || options.number_of_threads < 2)
    return;
  const Execution parallel = internal::execution_of<CGAL::Parallel_if_available_tag>();
  add_parallel("sweep", [=](benchmark::State& state) { run(state, sweep, parallel); });
  for(const auto& kernel : kernels)
    if(kernel.is_parallel)
      add_parallel(kernel.name, [=](benchmark::State& state) { run(state, kernel.function, parallel); });
  add_parallel("parameterization", parameterize<CGAL::Parallel_if_available_tag>)->Iterations(1);
  machine_rates::add(options.number_of_threads, bytes_of_sweep);
}

void print_usage(const char* program)
{
  std::cout
      << "Usage: " << program
      << " [OPTIONS] [--map=FILE] [--threads=N] [MESH]\n"
         "Measures the kernels of the default method on a mesh in the format OFF, by default CGAL's armadillo, and a\n"
         "map of it that is some sweeps from its end: every call does the same work. If there is a FILE, the map is\n"
         "read from it; if not, it is written, so that another build can be measured by the same work. Items are\n"
         "vertices or faces. The counters of a sweep are what it has to do at least for a vertex; machine_* is what\n"
         "the machine does at best. Kernels that can use several threads are measured with one and with N, 2 by\n"
         "default. What compares two builds is compare_builds.py.\n\n";
}

// Takes the value of an option --NAME=VALUE.
bool read_option(const std::string& argument, const std::string& name, std::string& value)
{
  if(argument.compare(0, name.size(), name) != 0)
    return false;
  value = argument.substr(name.size());
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  if(std::find(argv, argv + argc, std::string("--help")) != argv + argc)
    print_usage(argv[0]);
  benchmark::Initialize(&argc, argv); // takes its options away; --help ends here
  std::string threads = "2";
  for(const std::string& argument : std::vector<std::string>(argv + 1, argv + argc))
    if(read_option(argument, "--map=", options.map_file) || read_option(argument, "--threads=", threads))
      continue;
    else if(argument[0] != '-' && options.mesh_file.empty())
      options.mesh_file = argument;
    else
    {
      print_usage(argv[0]);
      return EXIT_FAILURE;
    }
  if(options.mesh_file.empty())
    options.mesh_file = CGAL::data_file_path("meshes/armadillo.off");
  try
  {
    options.number_of_threads = std::stoul(threads);
    add_benchmarks();
    benchmark::RunSpecifiedBenchmarks();
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
