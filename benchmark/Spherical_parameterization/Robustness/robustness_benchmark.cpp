// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

// Runs a program on every mesh of some folders and judges what it writes: how often its map is one-to-one, how often it
// refuses the mesh, and how often it is wrong.

#include "../include/Command_template.h"
#include "../include/Map_judge.h"
#include "../include/Mapping_program.h"
#include "../include/Table.h"
#include "../include/judge_map.h"
#include "../include/mesh_files.h"
#include "../include/run_command.h"
#include "../include/run_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace fs = std::filesystem;
namespace po = boost::program_options;
using namespace benchmarks;

namespace {

enum class Outcome
{
  CERTIFIED, // a map was written, and it is one-to-one
  REFUSED,   // the program said that it has none
  WRONG      // anything else
};

const char* name_of(Outcome outcome)
{
  return outcome == Outcome::CERTIFIED ? "certified" : outcome == Outcome::REFUSED ? "refused" : "wrong";
}

// How the program did on one mesh.
struct Result
{
  fs::path file;
  Outcome outcome = Outcome::WRONG;
  std::string reason; // unless certified
  double seconds = 0.;
  double peak_bytes = 0.;
  double vertices = std::numeric_limits<double>::quiet_NaN(); // the rest only if certified
  Map_distortion isometric = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
};

Result judge(const Mapping_program& program, const fs::path& file)
{
  const Mapping_program::Run run = program.run(file);
  Result result;
  result.file = file;
  result.seconds = run.outcome.seconds;
  result.peak_bytes = run.outcome.peak_bytes;
  result.reason = run.reason;
  if(run.ending == Mapping_program::Ending::REFUSED)
  {
    result.outcome = Outcome::REFUSED;
  }
  else if(run.ending == Mapping_program::Ending::MAPPED)
  {
    const Map_judgement judgement = judge_map([&] { return Map_judge(file, program.map_file()); });
    result.reason = judgement.fault.data();
    if(judgement.is_one_to_one())
    {
      result.outcome = Outcome::CERTIFIED;
      result.vertices = judgement.vertices;
      result.isometric = judgement.isometric;
    }
  }
  return result;
}

// The files that are counted together: those of a folder, and among them those that are hard, or invalid, by their
// names.
std::string class_of(const fs::path& file)
{
  std::string name = (file.parent_path() / "").string();
  for(const std::string prefix : {"hard_", "invalid_"})
  {
    if(file.filename().string().compare(0, prefix.size(), prefix) == 0)
    {
      name += prefix;
    }
  }
  return name + '*';
}

using Results = std::vector<Result>;

std::size_t count(const Results& results, Outcome outcome)
{
  return static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(), [&](const Result& r) { return r.outcome == outcome; }));
}

// The result with the largest value; none if none has one.
template <class Value>
const Result* largest(const Results& results, const Value& value)
{
  const Result* best = nullptr;
  for(const Result& result : results)
  {
    if(!std::isnan(value(result)) && (best == nullptr || value(result) > value(*best)))
    {
      best = &result;
    }
  }
  return best;
}

double seconds(const Result& result)
{
  return result.seconds;
}

double megabytes(const Result& result)
{
  return result.peak_bytes / (1024. * 1024.);
}

double isometric_maximum(const Result& result)
{
  return result.isometric.maximum;
}

double isometric_average(const Result& result)
{
  return result.isometric.average;
}

// A number as it is shown.
struct Column
{
  const char* name;
  double (*value)(const Result&);
  int digits;

  std::string text(const Result* result) const
  {
    return result == nullptr || std::isnan(value(*result)) ? "-" : to_text(value(*result), digits);
  }
};

const std::array<Column, 4> columns = {{{"seconds", seconds, 3},
                                        {"memory [MB]", megabytes, 0},
                                        {"D_iso max", isometric_maximum, 3},
                                        {"D_iso avg", isometric_average, 3}}};

std::vector<std::string> header(std::vector<std::string> names)
{
  for(const Column& column : columns)
  {
    names.push_back(column.name);
  }
  return names;
}

std::vector<std::string> summary(const std::string& name, const Results& results)
{
  std::vector<std::string> cells = {name, std::to_string(results.size())};
  for(const Outcome outcome : {Outcome::CERTIFIED, Outcome::REFUSED, Outcome::WRONG})
  {
    cells.push_back(std::to_string(count(results, outcome)));
  }
  for(const Column& column : columns)
  {
    cells.push_back(column.text(largest(results, column.value)));
  }
  return cells;
}

std::vector<std::string> line(const Result& result)
{
  std::vector<std::string> cells = {result.file.filename().string(), name_of(result.outcome),
                                    std::isnan(result.vertices) ? "-" : to_text(result.vertices, 0)};
  for(const Column& column : columns)
  {
    cells.push_back(column.text(&result));
  }
  return cells;
}

// Which files the largest numbers belong to, and why some have no map.
void print_remarks(std::ostream& out, const Results& results)
{
  out << '\n';
  for(const Column& column : columns)
  {
    if(const Result* const worst = largest(results, column.value))
    {
      out << column.name << " at most " << column.text(worst) << ": " << worst->file.string() << '\n';
    }
  }
  for(const Outcome outcome : {Outcome::REFUSED, Outcome::WRONG})
  {
    for(const Result& result : results)
    {
      if(result.outcome == outcome)
      {
        out << name_of(outcome) << ": " << result.file.string() << ": " << result.reason << '\n';
      }
    }
  }
}

int run_benchmark(const po::variables_map& options)
{
  if(options.count("program") == 0)
  {
    throw po::error("Say with --program what to run.");
  }
  const Command_limits limits = {options["time-limit"].as<double>(),
                                 1024. * 1024. * options["memory-limit"].as<double>()};
  const Command_template command(options["program"].as<std::string>());
  if(!command.input_format().empty() || !command.output_format().empty())
  {
    throw po::error("The meshes are given to the program as they are, and the format of its maps is OFF.");
  }
  const Mapping_program program(command, limits);
  const bool is_csv = options["csv"].as<bool>();
  const std::vector<fs::path> files = find_mesh_files(options["inputs"].as<std::vector<std::string>>());

  std::optional<Table> list;
  if(options["list"].as<bool>())
  {
    list.emplace(std::cout, header({"mesh", "judgement", "vertices"}), is_csv);
  }
  Results results;
  std::map<std::string, Results> classes;
  for(const fs::path& file : files)
  {
    results.push_back(judge(program, file));
    classes[class_of(file)].push_back(results.back());
    if(list)
    {
      list->add_row(line(results.back()));
    }
  }
  if(list)
  {
    std::cout << std::endl;
  }
  Table table(std::cout, header({"meshes", "files", "certified", "refused", "wrong"}), is_csv);
  for(const auto& [name, members] : classes)
  {
    table.add_row(summary(name, members));
  }
  table.add_row(summary("all", results));
  print_remarks(is_csv ? std::cerr : std::cout, results);
  return count(results, Outcome::WRONG) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Refuses negative limits.
void check_limit(double limit)
{
  if(!(limit >= 0.))
  {
    throw po::error("A limit is a positive number, or 0 for none.");
  }
}

} // namespace

int main(int argc, char* argv[])
{
  auto program = po::value<std::string>()->value_name("COMMAND");
  // CGAL's tree builds the examples, the command line program among them, apart from the benchmarks.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM
  program->default_value(quoted(SPHERICAL_PARAMETERIZATION_PROGRAM) + " {input} -o {output} --quiet",
                         "the package's own program");
#endif
  po::options_description options("Options");
  auto add = options.add_options();
  add("program", program,
      "what to run on a mesh; the shell gets it with the names of two files for {input} and {output}");
  add("time-limit", po::value<double>()->default_value(600.)->notifier(check_limit), "seconds for each mesh; 0: any");
  add("memory-limit", po::value<double>()->default_value(8192.)->notifier(check_limit),
      "megabytes of address space for each mesh; 0: any");
  add("list", po::bool_switch(), "print a line for each mesh first");
  return run_program(
      argc, argv,
      "Runs a program on each mesh and counts the results. A map is certified if the exit status is 0 and\n"
      "the file, in the format OFF, holds a one-to-one map of the same faces onto a sphere around the origin,\n"
      "by exact arithmetic. A mesh is refused if the exit status is another one. All else is wrong: a map that\n"
      "folds, no map, a crash, a limit reached. Fails if anything is wrong. D_iso is at the radius of eq. 11.",
      options, run_benchmark);
}
