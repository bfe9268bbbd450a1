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
#include "Any_update.h"
#include "Command_line.h"
#include "File_names.h"
#include "choices.h"
#include "file_format.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace Program {

/// What the command line asks for.
class Program_options
{
public:
  /// reads the command line.
  ///
  /// \throws Program_error if an option is unknown, out of its range, of no use, or contradicts another one
  Program_options(int argc, const char* const* argv)
    : m_line(argc, argv)
  {
    wants_help = m_line.has("help");
    wants_version = m_line.has("version");
    if(wants_help || wants_version)
      return;
    read_inputs();
    read_method();
    if(knows("initial"))
      read_initial();
    if(knows("energy"))
      read_energy();
    if(knows("sharpness"))
      read_sharpness();
    if(knows("radius"))
      read_radius();
    if(knows("update"))
      read_update();
    if(knows("barrier"))
      read_barrier();
    read_limits();
    read_outputs();
  }

  /// returns the explanation of all options.
  const std::string& help() const { return m_line.help(); }

  /// returns whether the method only cares for angles.
  bool is_conformal() const
  {
    return energy == Energy_choice::CONFORMAL || method == Method_choice::CONFORMAL ||
           method == Method_choice::HARMONIC || method == Method_choice::STEREOGRAPHIC;
  }

  /// returns whether there may be many meshes: the names of their files are made from those of the inputs.
  bool is_batch() const { return !output_folder.empty(); }

  /// returns whether the progress of a run is shown, where there is a terminal.
  bool shows_progress() const { return !is_quiet && !is_batch(); }

  bool wants_help = false, wants_version = false, is_quiet = false;
  std::vector<std::string> inputs; ///< meshes, and folders if there may be many
  File_names file_names;           ///< of the one mesh, if there is only one
  std::string output_folder;       ///< of the many, empty otherwise
  std::string format;              ///< of all maps, empty if each has that of its input
  bool is_resumed = false;         ///< whether meshes that are done are left out
  Method_choice method = Method_choice::BLD;
  bool is_published = false; ///< BLD with the settings of the paper
  Start_choice start = Start_choice::HIERARCHICAL;
  std::string start_file; ///< empty if the start is not precomputed
  Energy_choice energy = Energy_choice::SYMMETRIC_DIRICHLET;
  Any_sharpness sharpness;
  Any_radius radius;
  Any_update update;
  Barrier_choice barrier = Barrier_choice::DETERMINANT;
  bool is_unit_sphere = false; ///< whether the radius is 1 because nothing else has chosen one
  std::string description;     ///< the method with all of its settings in words
  unsigned int most_iterations = 90;
  double most_seconds = 0.;      ///< 0 if there is no limit
  unsigned int most_threads = 0; ///< 0 if there is no limit

private:
  // Which methods an option goes with; options that are not listed go with all.
  struct Scope
  {
    const char* option;
    std::vector<Method_choice> methods;
    bool goes_with_paper;
  };

  static const std::vector<Scope>& scopes()
  {
    using M = Method_choice;
    static const std::vector<Scope> list = {
        {"initial", {M::BLD, M::ARAP}, true},
        {"energy", {M::BLD, M::HIERARCHICAL}, false},
        {"prefer", {M::BLD, M::HIERARCHICAL}, false},
        {"sharpness", {M::BLD, M::HIERARCHICAL}, false},
        {"s-first", {M::BLD}, true},
        {"s-last", {M::BLD}, true},
        {"average-sweeps", {M::BLD}, true},
        {"radius", {M::BLD}, true},
        {"update", {M::BLD, M::HIERARCHICAL}, false},
        {"barrier", {M::BLD}, false},
        {"iterations", {M::BLD, M::HARMONIC, M::CONFORMAL, M::ARAP}, true},
        {"time-limit", {M::BLD, M::HIERARCHICAL, M::HARMONIC, M::CONFORMAL, M::ARAP}, true},
    };
    return list;
  }

  static bool goes_with(const Scope& scope, Method_choice method)
  {
    return std::find(scope.methods.begin(), scope.methods.end(), method) != scope.methods.end();
  }

  // returns whether the method has a setting of the name of `option`
  bool knows(const std::string& option) const
  {
    return std::any_of(scopes().begin(), scopes().end(),
                       [&](const Scope& scope) { return scope.option == option && goes_with(scope, method); });
  }

  template <class Filter>
  static std::vector<std::string> options_where(const Filter& is_wanted)
  {
    std::vector<std::string> names;
    for(const Scope& scope : scopes())
      if(is_wanted(scope))
        names.push_back("--" + std::string(scope.option));
    return names;
  }

  void read_inputs()
  {
    inputs = m_line.inputs();
    if(inputs.empty())
      Command_line::fail("there is no INPUT");
    if(m_line.has("output-folder"))
      return;
    if(inputs.size() > 1)
      Command_line::fail("there is more than one INPUT; a name with blanks has to be quoted, and many meshes need "
                         "--output-folder");
    file_names.input = inputs.front();
  }

  void read_method()
  {
    method = m_line.choice("method", methods, Method_choice::BLD);
    is_published = m_line.has("paper");
    if(is_published && m_line.has("method"))
      Command_line::fail("--paper is a method of its own: leave out --method");
    for(const Scope& scope : scopes())
      if(m_line.has(scope.option))
        check_scope(scope);
    is_unit_sphere = method != Method_choice::BLD && method != Method_choice::ARAP;
    description = std::string(name_of(methods, method)) + (is_published ? " as published" : "");
  }

  // refuses an option that would be ignored
  void check_scope(const Scope& scope) const
  {
    const std::string option = "--" + std::string(scope.option);
    if(is_published && !scope.goes_with_paper)
      Command_line::fail(option + " is among the settings of --paper, which can be combined with " +
                         list_of(options_where([](const Scope& s) { return s.goes_with_paper; }), " and ") + " only");
    if(goes_with(scope, method))
      return;
    std::vector<std::string> names;
    for(const Method_choice other : scope.methods)
      names.push_back(name_of(methods, other));
    const std::vector<std::string> known = options_where([&](const Scope& s) { return goes_with(s, method); });
    Command_line::fail(option + " goes with --method " + list_of(names) + "; " + name_of(methods, method) +
                       (known.empty() ? " has no settings" : " knows " + list_of(known, " and ") + " only"));
  }

  void refuse_both(const std::string& option, const std::string& other) const
  {
    if(m_line.has(option) && m_line.has(other))
      Command_line::fail("--" + option + " and --" + other + " contradict each other: give one of them");
  }

  void read_initial()
  {
    const std::string value = m_line.text("initial");
    if(!m_line.has("initial") || is_among(value, starts))
    {
      start = m_line.choice("initial", starts, is_published ? Start_choice::HARMONIC : Start_choice::HIERARCHICAL);
      description += std::string(", ") + name_of(starts, start) + " start";
      return;
    }
    if(!std::filesystem::exists(value))
      m_line.refuse("initial", list_of(starts) + ", or the name of a file with a map");
    start = Start_choice::PRECOMPUTED;
    start_file = value;
    description += ", start from " + start_file;
  }

  void read_energy()
  {
    const bool is_usually_isometric = is_published || method == Method_choice::HIERARCHICAL;
    energy = m_line.choice("energy", energies,
                           is_usually_isometric ? Energy_choice::ISOMETRIC : Energy_choice::SYMMETRIC_DIRICHLET);
    description += std::string(", ") + name_of(energies, energy) + " energy";
  }

  void read_sharpness()
  {
    refuse_both("prefer", "sharpness");
    for(const char* schedule : {"s-first", "s-last", "average-sweeps"})
      for(const char* dial : {"prefer", "sharpness"})
        refuse_both(schedule, dial);

    if(is_published || m_line.has("s-first") || m_line.has("s-last"))
      read_schedule();
    else if(m_line.has("average-sweeps"))
      Command_line::fail("--average-sweeps goes with --s-first, --s-last or --paper");
    else
      read_dial();
  }

  void read_schedule()
  {
    using CGAL::Spherical_parameterization::Absolute_sharpness_3;
    const Absolute_sharpness_3 usual;
    const double least = (std::numeric_limits<double>::min)();
    const char* range = "a number greater than 0, at most 1e6";
    const double first = m_line.number("s-first", least, largest_sharpness, range, usual.first());
    const double last = m_line.number("s-last", least, largest_sharpness, range, usual.last());
    if(first > last)
      Command_line::fail("--s-first must not be greater than --s-last, but they are " + short_text(first) + " and " +
                         short_text(last) + "; valid are 0 < s-first <= s-last <= 1e6, by default " +
                         short_text(usual.first()) + " and " + short_text(usual.last()));
    description += ", s " + (first < last ? "from " + short_text(first) + " to " : "= ") + short_text(last);
    if(is_published || m_line.has("average-sweeps"))
    {
      constexpr unsigned int of_paper = 100;
      const unsigned int n = m_line.whole_number("average-sweeps", 0, of_paper);
      sharpness = Any_sharpness(Absolute_sharpness_3(first, last, n));
      description += " after " + std::to_string(n) + " sweeps of the plain sum";
      return;
    }
    sharpness = Any_sharpness(Absolute_sharpness_3(first, last));
    if(first < last)
      description += " after sweeps of the plain sum while they help";
  }

  void read_dial()
  {
    using CGAL::Spherical_parameterization::Relative_sharpness_3;
    const Relative_sharpness_3 usual(method == Method_choice::HIERARCHICAL ? 0. : Relative_sharpness_3().beta());
    const double beta = m_line.number("sharpness", 0., largest_sharpness, "a number from 0 to 1e6",
                                      m_line.choice("prefer", preferences, usual.beta()));
    sharpness = Any_sharpness(Relative_sharpness_3(beta));
    description += ", sharpness " + short_text(beta);
  }

  void read_radius()
  {
    const std::string value = m_line.text("radius"), fixed = "fixed=";
    double r = 0.;
    if(!m_line.has("radius"))
    {
      set_usual_radius();
      return;
    }
    if(value == "two-phase")
      radius = two_phase_radius();
    else if(value == "optimal")
      radius = Any_radius(Any_radius::Optimal_radius_3());
    else if(value == "area")
      radius = Any_radius(Any_radius::Area_preserving_radius_3());
    else if(value == "balanced")
      radius = Any_radius(Any_radius::Area_balancing_radius_3());
    else if(value.compare(0, fixed.size(), fixed) == 0 && Command_line::read_number(value.substr(fixed.size()), r) &&
            r >= (std::numeric_limits<double>::min)() && r <= (std::numeric_limits<double>::max)())
      radius = Any_radius(Any_radius::Fixed_radius_3(r));
    else
      m_line.refuse("radius", "two-phase, optimal, area, balanced or fixed=R with a number R greater than 0");
    description += ", radius " + value;
  }

  void set_usual_radius()
  {
    if(energy == Energy_choice::CONFORMAL)
    {
      radius = Any_radius(Any_radius::Fixed_radius_3(1.));
      is_unit_sphere = true;
      description += ", radius fixed=1";
    }
    else if(m_line.text("prefer") == "average")
    {
      radius = Any_radius(Any_radius::Two_phase_optimal_radius_3());
      description += ", radius two-phase, of the lowest energy in the end";
    }
    else
    {
      radius = two_phase_radius();
      description += ", radius two-phase";
    }
  }

  // In the paper the second phase waits for the energy as well.
  Any_radius two_phase_radius() const
  {
    using Radius = Any_radius::Two_phase_radius_3;
    return Any_radius(is_published ? Radius(Radius::First_radius(), Radius::Second_radius(), 0.) : Radius());
  }

  void read_update()
  {
    const Update_choice value =
        m_line.choice("update", updates, is_published ? Update_choice::GRADIENT : Update_choice::NEWTON);
    if(value == Update_choice::GRADIENT)
      update = Any_update(CGAL::Spherical_parameterization::Gradient_update_3());
    description += std::string(", ") + name_of(updates, value) + " update";
  }

  void read_barrier()
  {
    barrier = m_line.choice("barrier", barriers, is_published ? Barrier_choice::FLAT : Barrier_choice::DETERMINANT);
    description += std::string(", ") + name_of(barriers, barrier) + " barrier";
  }

  void read_limits()
  {
    constexpr unsigned int usual_sweeps = 90, usual_sweeps_of_paper = 2000, usual_steps = 100,
                           usual_steps_of_arap = 500;
    const unsigned int usual = method == Method_choice::BLD
                                   ? (is_published ? usual_sweeps_of_paper : usual_sweeps)
                                   : (method == Method_choice::ARAP ? usual_steps_of_arap : usual_steps);
    most_iterations = m_line.whole_number("iterations", 0, usual);
    if(knows("iterations"))
      description +=
          ", at most " + std::to_string(most_iterations) + (method == Method_choice::BLD ? " sweeps" : " global steps");
    most_seconds = m_line.number("time-limit", (std::numeric_limits<double>::min)(),
                                 (std::numeric_limits<double>::max)(), "a number greater than 0", 0.);
    if(most_seconds > 0.)
      description += ", at most " + short_text(most_seconds) + " seconds";
    most_threads = m_line.whole_number("threads", 1, 0);
  }

  void read_outputs()
  {
    is_quiet = m_line.has("quiet");
    for(const char* option : {"output", "json", "colored", "output-folder"})
      if(m_line.has(option) && m_line.text(option).empty())
        Command_line::fail("--" + std::string(option) + " needs a name");
    if(m_line.has("output-folder"))
    {
      read_output_folder();
      return;
    }
    for(const char* option : {"format", "resume"})
      if(m_line.has(option))
        Command_line::fail("--" + std::string(option) + " goes with --output-folder");
    file_names.sphere = m_line.text("output");
    file_names.json = m_line.text("json");
    file_names.colored = m_line.text("colored");
    if(m_line.has("output") && !is_among(file_format(file_names.sphere), output_formats))
      m_line.refuse("output", "a name that ends with one of " + list_of(output_formats));
  }

  void read_output_folder()
  {
    for(const char* option : {"output", "json", "colored"})
      if(m_line.has(option))
        Command_line::fail("--" + std::string(option) + " is for one mesh; with --output-folder, the sphere of each " +
                           "and its report are written there");
    output_folder = m_line.text("output-folder");
    is_resumed = m_line.has("resume");
    if(!m_line.has("format"))
      return;
    const std::string extension = m_line.text("format");
    format = file_format("sphere." + extension.substr(extension.find_first_not_of('.') == 1 ? 1 : 0));
    if(!is_among(format, output_formats))
      m_line.refuse("format", "one of " + list_of(output_formats));
  }

  // as many digits as it takes to read the same number again
  static std::string short_text(double x)
  {
    std::string text;
    double again = 0.;
    for(int digits = 6; digits <= std::numeric_limits<double>::max_digits10 && (text.empty() || again != x); ++digits)
    {
      std::ostringstream out;
      out.precision(digits);
      out << x;
      text = out.str();
      Command_line::read_number(text, again);
    }
    return text;
  }

  static constexpr double largest_sharpness = 1e6; // of both policies

  Command_line m_line;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PROGRAM_OPTIONS_H
