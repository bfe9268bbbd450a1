// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_COMMAND_LINE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_COMMAND_LINE_H

#include "Program_error.h"
#include "Word.h"
#include "choices.h"
#include "file_format.h"

#include <boost/program_options.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace Program {

/// The command line as it was given: which options are there, and the values of each, checked one by one.
class Command_line
{
public:
  /// reads the command line.
  ///
  /// \throws Program_error if an option is unknown or lacks its value
  Command_line(int argc, const char* const* argv)
  {
    try
    {
      read(argc, argv);
    }
    catch(const boost::program_options::error& error)
    {
      fail(error.what());
    }
  }

  /// returns the explanation of all options.
  const std::string& help() const { return m_help; }

  bool has(const std::string& option) const { return m_values.count(option) > 0; }

  /// returns the value of an option, which is empty if it was not given.
  std::string text(const std::string& option) const
  {
    return has(option) ? m_values[option].as<std::string>() : std::string();
  }

  /// returns all meshes and folders that are given, in their order.
  std::vector<std::string> inputs() const
  {
    return has("input") ? m_values["input"].as<std::vector<std::string>>() : std::vector<std::string>();
  }

  /// returns what the value of an option stands for, or `usual` if it was not given.
  ///
  /// \throws Program_error if the value is none of `words`
  template <class Value, std::size_t n>
  Value choice(const std::string& option, const std::array<Word<Value>, n>& words, Value usual) const
  {
    if(!has(option))
      return usual;
    for(const Word<Value>& word : words)
      if(text(option) == word.name)
        return word.value;
    refuse(option, list_of(words));
  }

  /// returns the value of an option as a number in [least, largest], or `usual` if it was not given.
  ///
  /// \throws Program_error if it is no such number; `range` is that in words
  double number(const std::string& option, double least, double largest, const std::string& range, double usual) const
  {
    double x = usual;
    if(has(option) && (!read_number(text(option), x) || !(x >= least && x <= largest)))
      refuse(option, range);
    return x;
  }

  /// returns the value of an option as a whole number, `usual` if it was not given.
  ///
  /// \throws Program_error if it is no whole number from `least` on
  unsigned int whole_number(const std::string& option, unsigned int least, unsigned int usual) const
  {
    constexpr double largest = 1e9;
    const std::string range = "a whole number from " + std::to_string(least) + " to 1e9";
    const double x = number(option, least, largest, range, usual);
    if(x != std::floor(x))
      refuse(option, range);
    return static_cast<unsigned int>(x);
  }

  /// reads a text as a number; returns whether it is one.
  static bool read_number(const std::string& text, double& x)
  {
    char* end = nullptr;
    x = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0';
  }

  [[noreturn]] static void fail(const std::string& what)
  {
    throw Program_error(what + "\nAll options are explained by: spherical_parameterization --help");
  }

  /// refuses the value of an option; `valid` says which would be accepted.
  [[noreturn]] void refuse(const std::string& option, const std::string& valid) const
  {
    fail("--" + option + " has to be " + valid + ", not '" + text(option) + "'");
  }

private:
  void read(int argc, const char* const* argv)
  {
    namespace po = boost::program_options;
    const po::options_description visible = describe_options();
    po::options_description all;
    all.add(visible).add_options()("input", po::value<std::vector<std::string>>());
    po::positional_options_description positions;
    positions.add("input", -1);
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positions).style(style).run(), m_values);
    m_help = usage(visible);
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
      ("output-folder", word("FOLDER"), "map many meshes: each INPUT is a mesh, or a folder, which stands for the mesh "
                                        "files in it; write each sphere and its report to FOLDER, as NAME.off, say, "
                                        "and NAME.json")
      ("format", word("EXTENSION"), "the format of all spheres there: off, obj, ply or ts; if not given, that of the "
                                    "INPUT, and off for .stl")
      ("resume", "leave out the meshes whose sphere and report are there, made by the same version of the program from "
                 "the same file with the same options")
      ("method", word("METHOD"), "bld: lowest distortion, the default; or one of the methods that it can start from or "
                                 "is compared with, alone: hierarchical, harmonic or stereographic, which are "
                                 "one-to-one; conformal or arap, which may fold")
      ("paper", "the published method with all of its settings: harmonic start, isometric energy, 100 sweeps of its "
                "sum, then s from 0.1 to 10, two-phase radius, gradient update, flat barrier, at most 2000 sweeps. "
                "--initial, --s-first, --s-last, --average-sweeps, --radius and --iterations may change it")
      ("initial", word("START"), "what bld and arap start from: hierarchical, the default; stereographic; harmonic; "
                                 "conformal, which must not fold; or FILE: a map written before for the same mesh")
      ("energy", word("ENERGY"), "symmetric-dirichlet: lengths and areas, the default; isometric: the paper's, default "
                                 "of --method hierarchical; conformal: angles only")
      ("prefer", word("WHAT"), "the lowest average distortion, the lowest worst, or a balance of both, the default: "
                               "average, balance or worst, which is sharpness 0, 13.5 or 50; average also takes the "
                               "radius of the lowest energy in the end, since the average is lowest there; --method "
                               "hierarchical prefers average, if nothing is given")
      ("sharpness", word("B"), "anything between: 0 or more")
      ("s-first", word("S"), "the paper's schedule instead of a sharpness: exp(s E) with s from here, 0.1 ...")
      ("s-last", word("S"), "... to here, 10; the same as --s-first for a fixed s, as in AMIPS")
      ("average-sweeps", word("N"), "exactly so many sweeps of the plain sum of E before them, as in the paper; 0 for "
                                    "none. If not given, as many as help, or none for a fixed s")
      ("radius", word("RADIUS"), "two-phase: equal area at first, then balanced areas, the default; optimal: of the "
                                 "lowest energy; area: equal area; balanced: balanced areas; fixed=R: R, the default "
                                 "of --energy conformal, with R = 1")
      ("update", word("UPDATE"), "how a vertex moves: newton, the default; or gradient, the paper's")
      ("barrier", word("BARRIER"), "how the energy sees the area of an image: determinant, the default, which is 0 "
                                   "where a face turns over; or flat, the paper's, which is not")
      ("iterations", word("N"), "most sweeps over the mesh, if not given 90, 2000 with --paper; or most global steps, if "
                                "not given 100, 500 with --method arap; 0 leaves the initial map")
      ("time-limit", word("SECONDS"), "sweep no longer than this on each mesh; the map reached is written")
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
    text << "Usage: spherical_parameterization INPUT [-o SPHERE] [options]\n"
            "       spherical_parameterization INPUT ... --output-folder FOLDER [options]\n\n"
            "Maps a closed triangle mesh of genus 0 to a sphere, one-to-one and with low distortion. INPUT is a file "
            "of\n"
            "one of the formats "
         << list_of(input_formats)
         << ". The result is certified by exact arithmetic.\n"
            "Without -o nothing but the report is printed. Ctrl-C ends the sweeps; the map reached is written.\n\n"
            "With --output-folder, a mesh that fails does not stop the others. Small meshes are mapped one on each "
            "core,\n"
            "large ones one after the other on all. After Ctrl-C nothing that is incomplete is left; --resume goes "
            "on.\n\n"
         << options
         << "\nExit status: 0, a certified one-to-one map was found and all files were written; 1, an error, of which "
            "a\n"
            "message tells, and no map was written; 2, the map folds, which --method conformal and arap do not "
            "exclude;\n"
            "all files were written nevertheless. With --output-folder: 0, all meshes have a certified map; 1, some "
            "have\n"
            "none; 2, all have one, but some fold.\n";
    return text.str();
  }

  boost::program_options::variables_map m_values;
  std::string m_help;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_COMMAND_LINE_H
