// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_OPTIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_OPTIONS_H

#include "Any_radius.h"
#include "Any_sharpness.h"
#include "Program_error.h"
#include "file_format.h"

#include <boost/program_options.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>

namespace Program {

enum class Energy_choice
{
  SYMMETRIC_DIRICHLET,
  ISOMETRIC,
  CONFORMAL
};

/// What the command line asks for.
class Program_options
{
public:
  /// reads the command line.
  ///
  /// \throws Program_error if an option is unknown, out of its range, or contradicts another one
  Program_options(int argc, const char* const* argv)
  {
    try
    {
      read(argc, argv);
    }
    catch(const boost::program_options::too_many_positional_options_error&)
    {
      fail("there is more than one INPUT; a name with blanks has to be quoted");
    }
    catch(const boost::program_options::error& error)
    {
      fail(error.what());
    }
  }

  /// returns the explanation of all options.
  const std::string& help() const { return m_help; }

  bool wants_help = false, wants_version = false, is_quiet = false;
  std::string input;
  std::string initial; ///< a file, or empty for the hierarchy
  Energy_choice energy = Energy_choice::SYMMETRIC_DIRICHLET;
  Any_sharpness sharpness;
  Any_radius radius;
  std::string method; ///< energy, sharpness and radius in words
  unsigned int most_iterations = 100;
  double most_seconds = 0.;          ///< 0 if there is no limit
  unsigned int most_threads = 0;     ///< 0 if there is no limit
  std::string output, json, colored; ///< empty if not wanted

private:
  [[noreturn]] static void fail(const std::string& what)
  {
    throw Program_error(what + "\nAll options are explained by: spherical_parameterization --help");
  }

  [[noreturn]] static void refuse(const std::string& option, const std::string& value, const std::string& valid)
  {
    fail("--" + option + " has to be " + valid + ", not '" + value + "'");
  }

  void read(int argc, const char* const* argv)
  {
    namespace po = boost::program_options;
    const po::options_description visible = describe_options();
    po::options_description all;
    all.add(visible).add_options()("input", po::value<std::string>());
    po::positional_options_description positions;
    positions.add("input", 1);
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positions).style(style).run(), m_values);

    m_help = usage(visible);
    wants_help = has("help");
    wants_version = has("version");
    if(wants_help || wants_version)
      return;
    if(!has("input"))
      fail("there is no INPUT");
    input = text("input");
    read_energy();
    read_sharpness();
    read_radius();
    read_initial();
    read_limits();
    read_outputs();
  }

  static boost::program_options::options_description describe_options()
  {
    namespace po = boost::program_options;
    constexpr unsigned int line_length = 100;
    po::options_description options("Options", line_length);
    const auto word = [](const char* name) { return po::value<std::string>()->value_name(name); };
    // clang-format off
    options.add_options()
      ("output,o", word("SPHERE"), "write the sphere: the faces of INPUT, with the images of its vertices in the same "
                                   "order (0 0 0 for a vertex without a face) and 17 digits; .off, .obj, .ply or .ts")
      ("energy", word("ENERGY"), "symmetric-dirichlet: lengths and areas, the default; isometric: the paper's; "
                                 "conformal: angles only")
      ("prefer", word("WHAT"), "the lowest average distortion, the lowest worst, or a balance of both, the default: "
                               "average, balance or worst, which is sharpness 0, 12 or 50; average also takes the radius "
                               "of the lowest energy in the end, since the average is lowest there")
      ("sharpness", word("B"), "anything between: 0 or more")
      ("s-first", word("S"), "the paper's schedule instead of a sharpness: exp(s E) with s from here, 0.1 ...")
      ("s-last", word("S"), "... to here, 10")
      ("radius", word("RADIUS"), "two-phase: equal area at first, then balanced areas, the default; optimal: of the lowest "
                                 "energy; area: equal area; fixed=R: R, the default for conformal, with R = 1")
      ("initial", word("START"), "hierarchical, the default; or FILE: a map written before for the same mesh")
      ("iterations", word("N"), "most sweeps over the mesh: 100, if not given; 0 leaves the initial map")
      ("time-limit", word("SECONDS"), "sweep no longer than this; the map reached is written")
      ("threads", word("N"), "use no more threads; the result is always the same")
      ("json", word("FILE"), "write the report and the distortions as JSON")
      ("colored", word("PREFIX"), "write PREFIX_surface.ply and PREFIX_sphere.ply, with the distortion as colour")
      ("quiet", "print nothing but errors")
      ("help,h", "print this")
      ("version", "print the version");
    // clang-format on
    return options;
  }

  static std::string usage(const boost::program_options::options_description& options)
  {
    std::ostringstream text;
    text << "Usage: spherical_parameterization INPUT [-o SPHERE] [options]\n\n"
            "Maps a closed triangle mesh of genus 0 to a sphere, one-to-one and with low distortion. INPUT is a file "
            "of\n"
            "any format that CGAL reads: "
         << list_of(input_formats)
         << ". The result is certified by exact arithmetic.\n"
            "Without -o nothing but the report is printed. Ctrl-C ends the sweeps; the map reached is written.\n\n"
         << options
         << "\nExit status: 0, a certified one-to-one map was found and all files were written; 1, an error, of which "
            "a\n"
            "message tells, and no map was written.\n";
    return text.str();
  }

  bool has(const char* option) const { return m_values.count(option) > 0; }
  const std::string& text(const char* option) const { return m_values[option].as<std::string>(); }

  void refuse_both(const std::string& option, const std::string& other) const
  {
    if(has(option.c_str()) && has(other.c_str()))
      fail("--" + option + " and --" + other + " contradict each other: give one of them");
  }

  // returns a number in [least, largest]; `range` is that in words
  static double number(const std::string& option, const std::string& value, double least, double largest,
                       const std::string& range)
  {
    char* end = nullptr;
    const double x = std::strtod(value.c_str(), &end);
    if(value.empty() || *end != '\0' || !(x >= least && x <= largest))
      refuse(option, value, range);
    return x;
  }

  static double positive_number(const std::string& option, const std::string& value)
  {
    return number(option, value, std::numeric_limits<double>::min(), std::numeric_limits<double>::max(),
                  "a number greater than 0");
  }

  static unsigned int whole_number(const std::string& option, const std::string& value, unsigned int least)
  {
    constexpr double largest = 1e9;
    const std::string range = "a whole number from " + std::to_string(least) + " to 1e9";
    const double x = number(option, value, least, largest, range);
    if(x != std::floor(x))
      refuse(option, value, range);
    return static_cast<unsigned int>(x);
  }

  void read_energy()
  {
    const std::string value = has("energy") ? text("energy") : "symmetric-dirichlet";
    if(value == "symmetric-dirichlet")
      energy = Energy_choice::SYMMETRIC_DIRICHLET;
    else if(value == "isometric")
      energy = Energy_choice::ISOMETRIC;
    else if(value == "conformal")
      energy = Energy_choice::CONFORMAL;
    else
      refuse("energy", value, "symmetric-dirichlet, isometric or conformal");
    method = value + " energy";
  }

  void read_sharpness()
  {
    using CGAL::Spherical_parameterization::Absolute_sharpness_3;
    using CGAL::Spherical_parameterization::Relative_sharpness_3;
    constexpr double largest = 1e6; // of both policies
    constexpr double average = 0., balance = 12., worst = 50.;

    refuse_both("prefer", "sharpness");
    for(const char* schedule : {"s-first", "s-last"})
      for(const char* dial : {"prefer", "sharpness"})
        refuse_both(schedule, dial);

    if(has("s-first") || has("s-last"))
    {
      const Absolute_sharpness_3 usual;
      const char* range = "a number greater than 0, at most 1e6";
      const double least = std::numeric_limits<double>::min();
      const double first = has("s-first") ? number("s-first", text("s-first"), least, largest, range) : usual.first();
      const double last = has("s-last") ? number("s-last", text("s-last"), least, largest, range) : usual.last();
      if(first > last)
        fail("--s-first must not be greater than --s-last, but they are " + short_text(first) + " and " +
             short_text(last));
      sharpness = Any_sharpness(Absolute_sharpness_3(first, last));
      method += ", s " + (first < last ? "from " + short_text(first) + " to " : "= ") + short_text(last);
      return;
    }
    double beta = balance;
    if(has("sharpness"))
      beta = number("sharpness", text("sharpness"), 0., largest, "a number from 0 to 1e6");
    else if(has("prefer"))
    {
      if(text("prefer") == "average")
        beta = average;
      else if(text("prefer") == "worst")
        beta = worst;
      else if(text("prefer") != "balance")
        refuse("prefer", text("prefer"), "average, balance or worst");
    }
    sharpness = Any_sharpness(Relative_sharpness_3(beta));
    method += ", sharpness " + short_text(beta);
  }

  void read_radius()
  {
    const std::string value = has("radius") ? text("radius") : "";
    const std::string fixed = "fixed=";
    if(value == "two-phase")
      radius = Any_radius(Any_radius::Two_phase_radius_3());
    else if(value == "optimal")
      radius = Any_radius(Any_radius::Optimal_radius_3());
    else if(value == "area")
      radius = Any_radius(Any_radius::Area_preserving_radius_3());
    else if(value.compare(0, fixed.size(), fixed) == 0)
      radius = Any_radius(Any_radius::Fixed_radius_3(positive_number("radius fixed=R", value.substr(fixed.size()))));
    else if(has("radius"))
      refuse("radius", value, "two-phase, optimal, area or fixed=R with a number R");
    else if(energy == Energy_choice::CONFORMAL)
      radius = Any_radius(Any_radius::Fixed_radius_3());
    else if(has("prefer") && text("prefer") == "average")
      radius = Any_radius(Any_radius::Two_phase_optimal_radius_3());
  }

  void read_initial()
  {
    initial = has("initial") && text("initial") != "hierarchical" ? text("initial") : "";
    if(!initial.empty() && !std::filesystem::exists(initial))
      refuse("initial", initial, "hierarchical, or the name of a file with a map");
  }

  void read_limits()
  {
    if(has("iterations"))
      most_iterations = whole_number("iterations", text("iterations"), 0);
    if(has("time-limit"))
      most_seconds = positive_number("time-limit", text("time-limit"));
    if(has("threads"))
      most_threads = whole_number("threads", text("threads"), 1);
  }

  void read_outputs()
  {
    is_quiet = has("quiet");
    output = has("output") ? text("output") : "";
    json = has("json") ? text("json") : "";
    colored = has("colored") ? text("colored") : "";
    for(const char* option : {"output", "json", "colored"})
      if(has(option) && text(option).empty())
        fail("--" + std::string(option) + " needs a name");
    if(has("output") && !is_among(file_format(output), output_formats))
      refuse("output", output, "a name that ends with one of " + list_of(output_formats));
  }

  static std::string short_text(double x)
  {
    std::ostringstream text;
    text << x;
    return text.str();
  }

  boost::program_options::variables_map m_values;
  std::string m_help;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_OPTIONS_H
