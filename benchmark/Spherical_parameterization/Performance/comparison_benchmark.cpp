// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

// Compares the package with other programs that map surfaces to the sphere: the same meshes, the same judge.

#include "../include/Command_template.h"
#include "../include/Map_judge.h"
#include "../include/Mapping_program.h"
#include "../include/Table.h"
#include "../include/Temporary_folder.h"
#include "../include/judge_map.h"
#include "../include/median.h"
#include "../include/mesh_files.h"
#include "../include/run_command.h"
#include "../include/run_in_child_process.h"
#include "../include/run_program.h"

#include "../../../examples/Spherical_parameterization/include/file_format.h"
#include "../../../examples/Spherical_parameterization/include/read_soup.h"
#include "../../../examples/Spherical_parameterization/include/write_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
namespace po = boost::program_options;
using namespace benchmarks;

namespace {

// The images may be as far from the sphere, relative, as makes no difference to the distortions that are printed: other
// programs may write few digits.
constexpr double largest_deviation = 1e-4;

// One of the programs that are compared.
class Competitor
{
public:
  Competitor(const std::string& name, const Command_template& command, const Command_limits& limits)
    : m_name(name)
    , m_input_format(command.input_format())
    , m_program(command, limits)
  {
    for(const std::string& format : {command.input_format(), command.output_format()})
    {
      if(!format.empty() && !Program::is_among(format, Program::output_formats))
      {
        throw po::error(name + ": the format " + format + " is none of " + Program::list_of(Program::output_formats));
      }
    }
  }

  const std::string& name() const { return m_name; }
  const std::string& input_format() const { return m_input_format; }
  const Mapping_program& program() const { return m_program; }

private:
  std::string m_name;
  std::string m_input_format;
  Mapping_program m_program;
};

// How a program did on one mesh.
struct Result
{
  using Ending = Mapping_program::Ending;

  Ending ending = Ending::MAPPED;
  std::string reason; // unless it is mapped one-to-one
  Map_judgement judgement;
  std::vector<double> cpu_seconds, seconds;
  double peak_bytes = 0.;

  bool is_certified() const { return ending == Ending::MAPPED && judgement.is_one_to_one(); }
  bool is_folded() const { return ending == Ending::MAPPED && judgement.folded_faces > 0.; }

  const char* verdict() const
  {
    switch(ending)
    {
    case Ending::REFUSED:
      return "refused";
    case Ending::TIMED_OUT:
      return "timed out";
    case Ending::BROKE_DOWN:
      return "broke down";
    case Ending::NOT_RUN:
      return "not run";
    case Ending::NO_MAP:
      return "no map";
    case Ending::MAPPED:
      break;
    }
    return is_certified() ? "certified" : is_folded() ? "folds" : "no map";
  }
};

// A number of a result.
struct Quantity
{
  const char* name;
  double (*value)(const Result&);
  int digits;

  std::string text(const Result& result) const
  {
    const double v = value(result);
    return std::isnan(v) ? "-" : to_text(v, digits);
  }
};

double cpu_seconds(const Result& r)
{
  return median(r.cpu_seconds);
}

double isometric_maximum(const Result& r)
{
  return r.judgement.isometric.maximum;
}

double isometric_average(const Result& r)
{
  return r.judgement.isometric.average;
}

double angle_maximum(const Result& r)
{
  return r.judgement.angle.maximum;
}

double angle_average(const Result& r)
{
  return r.judgement.angle.average;
}

// What depends on the program.
const std::array<Quantity, 8> quantities = {{{"folded", [](const Result& r) { return r.judgement.folded_faces; }, 0},
                                             {"D_iso max", isometric_maximum, 3},
                                             {"D_iso avg", isometric_average, 3},
                                             {"D_angle max", angle_maximum, 3},
                                             {"D_angle avg", angle_average, 3},
                                             {"CPU seconds", cpu_seconds, 3},
                                             {"seconds", [](const Result& r) { return median(r.seconds); }, 3},
                                             {"MB", [](const Result& r) { return r.peak_bytes / 1048576.; }, 0}}};

// What is compared.
const std::array<Quantity, 5> compared_quantities = {{{"CPU ratio", cpu_seconds, 3},
                                                      {"D_iso max ratio", isometric_maximum, 3},
                                                      {"D_iso avg ratio", isometric_average, 3},
                                                      {"D_angle max ratio", angle_maximum, 3},
                                                      {"D_angle avg ratio", angle_average, 3}}};

// The mesh and the map are the same for the judge in whatever order a program writes the faces.
Map_judge::Soup read_sorted(const fs::path& file)
{
  Program::Polygon_soup soup = Program::read_soup(file.string());
  for(std::vector<std::size_t>& polygon : soup.polygons)
  {
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  }
  std::sort(soup.polygons.begin(), soup.polygons.end());
  return {std::move(soup.points), std::move(soup.polygons)};
}

Map_judge make_judge(const fs::path& mesh_file, const fs::path& map_file)
{
  const Map_judge::Soup mesh = read_sorted(mesh_file), map = read_sorted(map_file);
  if(map.points.size() == mesh.points.size() && map.polygons != mesh.polygons)
  {
    throw std::runtime_error("the map has other faces than the mesh");
  }
  return Map_judge(mesh, map);
}

// One mesh, in all formats that the programs ask for.
class Mesh_in_formats
{
public:
  Mesh_in_formats(const fs::path& file, const fs::path& folder)
    : m_file(file)
    , m_folder(folder)
  {}

  // The file in `format`, or as it is for none. Written on the first call.
  // \throws std::runtime_error if it cannot be read or written
  fs::path in_format(const std::string& format) const
  {
    if(format.empty())
    {
      return m_file;
    }
    const fs::path file = (m_folder / m_file.stem()) += format;
    if(!fs::exists(file))
    {
      // In a process of its own: the memory of this one would be counted as that of the programs.
      const auto message = run_in_child_process([&] { return convert(file, format); });
      if(message[0] != 0)
      {
        throw std::runtime_error(message.data());
      }
    }
    return file;
  }

private:
  using Message = std::array<char, 256>;

  // Returns what went wrong; nothing if all went well.
  Message convert(const fs::path& file, const std::string& format) const
  {
    Message message{};
    try
    {
      const Program::Polygon_soup soup = Program::read_soup(m_file.string());
      std::ofstream out(file, std::ios::binary);
      Program::write_soup(out, format, soup.points, soup.polygons);
      out.close();
      if(!out)
      {
        throw std::runtime_error(file.string() + ": cannot be written");
      }
    }
    catch(const std::exception& error)
    {
      std::string(error.what()).copy(message.data(), message.size() - 1);
    }
    return message;
  }

  fs::path m_file, m_folder;
};

// Runs the program once more; the first map is judged.
void run_once(const Competitor& competitor, const fs::path& mesh_file, const Mesh_in_formats& mesh, Result& result)
{
  const bool is_first = result.seconds.empty();
  Mapping_program::Run run;
  try
  {
    run = competitor.program().run(mesh.in_format(competitor.input_format()));
  }
  catch(const std::runtime_error& error)
  {
    run.ending = Result::Ending::NOT_RUN;
    run.reason = error.what();
  }
  result.ending = run.ending;
  result.reason = run.reason;
  result.cpu_seconds.push_back(run.outcome.cpu_seconds);
  result.seconds.push_back(run.outcome.seconds);
  result.peak_bytes = (std::max)(result.peak_bytes, run.outcome.peak_bytes);
  if(run.ending != Result::Ending::MAPPED)
  {
    result.judgement = Map_judgement();
    return;
  }
  if(is_first)
  {
    result.judgement =
        judge_map([&] { return make_judge(mesh_file, competitor.program().map_file()); }, largest_deviation);
  }
  result.reason = result.judgement.fault.data();
}

using Competitors = std::deque<Competitor>; // as their folders stay where they are
using Results = std::vector<Result>;        // one for each competitor; the first is what the others are compared with

// Every program in turn, as often as asked for unless it fails: so a drift of the machine is the same for all.
Results run_all(const Competitors& competitors, const fs::path& mesh_file, std::size_t repetitions)
{
  const Temporary_folder folder;
  const Mesh_in_formats mesh(mesh_file, folder.path());
  Results results(competitors.size());
  for(std::size_t i = 0; i < repetitions; ++i)
  {
    for(std::size_t k = 0; k < competitors.size(); ++k)
    {
      if(i == 0 || results[k].is_certified())
      {
        run_once(competitors[k], mesh_file, mesh, results[k]);
      }
    }
  }
  return results;
}

std::vector<std::string> header(std::vector<std::string> names, bool with_quantities)
{
  if(with_quantities)
  {
    for(const Quantity& quantity : quantities)
    {
      names.push_back(quantity.name);
    }
  }
  for(const Quantity& quantity : compared_quantities)
  {
    names.push_back(quantity.name);
  }
  return names;
}

std::vector<std::string> line(const fs::path& mesh_file, const std::string& name, const Result& result,
                              const Result& reference)
{
  std::vector<std::string> cells = {mesh_file.stem().string(), name,
                                    std::isnan(result.judgement.vertices) ? "-" : to_text(result.judgement.vertices, 0),
                                    result.verdict()};
  for(const Quantity& quantity : quantities)
  {
    cells.push_back(quantity.text(result));
  }
  if(result.is_certified() && reference.is_certified())
  {
    for(const Quantity& quantity : compared_quantities)
    {
      cells.push_back(to_text(quantity.value(result) / quantity.value(reference), quantity.digits));
    }
  }
  return cells;
}

// How program `k` did on all meshes: counts, and the geometric means of the ratios over the meshes that both it and the
// first program map one-to-one.
std::vector<std::string> summary(const std::string& name, std::size_t k, const std::vector<Results>& meshes)
{
  std::size_t number_of_certified = 0, number_of_folded = 0, number_in_common = 0;
  std::array<double, compared_quantities.size()> sums_of_logarithms{};
  for(const Results& results : meshes)
  {
    number_of_certified += results[k].is_certified();
    number_of_folded += results[k].is_folded();
    if(!results[k].is_certified() || !results[0].is_certified())
    {
      continue;
    }
    ++number_in_common;
    for(std::size_t i = 0; i < compared_quantities.size(); ++i)
    {
      sums_of_logarithms[i] +=
          std::log(compared_quantities[i].value(results[k]) / compared_quantities[i].value(results[0]));
    }
  }
  std::vector<std::string> cells = {name,
                                    std::to_string(meshes.size()),
                                    std::to_string(number_of_certified),
                                    std::to_string(number_of_folded),
                                    std::to_string(meshes.size() - number_of_certified - number_of_folded),
                                    std::to_string(number_in_common)};
  if(number_in_common > 0)
  {
    for(std::size_t i = 0; i < compared_quantities.size(); ++i)
    {
      cells.push_back(to_text(std::exp(sums_of_logarithms[i] / static_cast<double>(number_in_common)),
                              compared_quantities[i].digits));
    }
  }
  return cells;
}

// The package on one thread, the package on all, and the programs of the caller's.
Competitors make_competitors(const po::variables_map& options)
{
  if(options.count("package") == 0)
  {
    throw po::error("Say with --package where the package's own program is.");
  }
  const std::string package = options["package"].as<std::string>() + " {input} -o {output} --quiet";
  const Command_limits limits = {options["time-limit"].as<double>(),
                                 1024. * 1024. * options["memory-limit"].as<double>()};
  Competitors competitors;
  competitors.emplace_back("package, 1 thread", Command_template(package + " --threads 1"), limits);
  competitors.emplace_back("package", Command_template(package), limits);
  if(options.count("program") > 0)
  {
    for(const std::string& program : options["program"].as<std::vector<std::string>>())
    {
      const std::size_t end = program.find('=');
      if(end == 0 || end == std::string::npos)
      {
        throw po::error("--program needs NAME=COMMAND, not: " + program);
      }
      const std::string name = program.substr(0, end);
      if(std::any_of(competitors.begin(), competitors.end(), [&](const Competitor& c) { return c.name() == name; }))
      {
        throw po::error("Two programs have the name " + name + '.');
      }
      competitors.emplace_back(name, Command_template(program.substr(end + 1)), limits);
    }
  }
  return competitors;
}

int run_benchmark(const po::variables_map& options)
{
  const Competitors competitors = make_competitors(options);
  const std::size_t repetitions = options["repeat"].as<std::size_t>();
  const bool is_csv = options["csv"].as<bool>();
  const std::vector<fs::path> files = find_mesh_files(options["inputs"].as<std::vector<std::string>>());

  std::vector<Results> meshes;
  std::vector<std::string> remarks;
  Table table(std::cout, header({"mesh", "program", "vertices", "judgement"}, true), is_csv, 2);
  for(const fs::path& file : files)
  {
    meshes.push_back(run_all(competitors, file, repetitions));
    const Results& results = meshes.back();
    for(std::size_t k = 0; k < competitors.size(); ++k)
    {
      table.add_row(line(file, competitors[k].name(), results[k], results[0]));
      if(!results[k].is_certified())
      {
        remarks.push_back(file.string() + ": " + competitors[k].name() + ": " + results[k].reason);
      }
    }
  }
  std::cout << std::endl;
  Table means(std::cout, header({"geometric means", "meshes", "certified", "folded", "failed", "in common"}, false),
              is_csv);
  for(std::size_t k = 0; k < competitors.size(); ++k)
  {
    means.add_row(summary(competitors[k].name(), k, meshes));
  }
  std::ostream& out = is_csv ? std::cerr : std::cout;
  out << (remarks.empty() ? "" : "\n");
  for(const std::string& remark : remarks)
  {
    out << remark << '\n';
  }
  const bool is_comparison =
      std::all_of(meshes.begin(), meshes.end(), [](const Results& results) { return results[0].is_certified(); });
  return is_comparison ? EXIT_SUCCESS : EXIT_FAILURE;
}

void check_limit(double limit)
{
  if(!(limit >= 0.))
  {
    throw po::error("A limit is a positive number, or 0 for none.");
  }
}

void check_repetitions(std::size_t repetitions)
{
  if(repetitions == 0)
  {
    throw po::error("--repeat must be at least 1.");
  }
}

} // namespace

int main(int argc, char* argv[])
{
  auto package = po::value<std::string>()->value_name("COMMAND");
  // CGAL's tree builds the examples, the command line program among them, apart from the benchmarks.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM
  package->default_value(quoted(SPHERICAL_PARAMETERIZATION_PROGRAM), "as built");
#endif
  po::options_description options("Options");
  auto add = options.add_options();
  add("program", po::value<std::vector<std::string>>()->composing()->value_name("NAME=COMMAND"),
      "a program to compare with; may be given several times");
  add("package", package, "the package's own program, with options for its maps if need be");
  add("repeat", po::value<std::size_t>()->default_value(3)->notifier(check_repetitions),
      "runs of each program on each mesh; times are medians");
  add("time-limit", po::value<double>()->default_value(600.)->notifier(check_limit), "seconds for each run; 0: any");
  add("memory-limit", po::value<double>()->default_value(8192.)->notifier(check_limit),
      "megabytes of address space for each process, of which some programs reserve more than they use; 0: any");
  return run_program(
      argc, argv,
      "Compares programs that map meshes to a sphere with the package, on one thread and on all. A COMMAND is\n"
      "a line for the shell, with {input} for the mesh file and {output} for the map, which the program has to\n"
      "write in the format OFF. For a program with a format of its own write {input.obj}, {input.ply},\n"
      "{output.obj} and the like: the mesh is converted beforehand. The map is a mesh with the vertices in the\n"
      "order of the input, on a sphere around the origin, and the same faces in any order. An example:\n"
      "\n"
      "  --program 'stereographic=spherical_parameterization {input} -o {output.ply} --method stereographic'\n"
      "\n"
      "Each run is a group of processes of its own, whose CPU seconds, in user mode and for system calls, are\n"
      "added up; MB is the physical memory of the largest of them. All maps are judged alike: certified is what\n"
      "is one-to-one by exact arithmetic; D_iso is at the radius of eq. 11, D_angle at any. The ratios are those\n"
      "to the package on one thread: above 1, the package is better. Their geometric means are over the meshes\n"
      "that both map one-to-one. A program may fail; only without a map of the package's is the status 1.",
      options, run_benchmark);
}
