// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MAPPING_PROGRAM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MAPPING_PROGRAM_H

#include "Command_template.h"
#include "Table.h"
#include "Temporary_folder.h"
#include "run_command.h"

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace benchmarks {

// Some program that reads a mesh and writes a map of it, given as a command line of the shell.
class Mapping_program
{
public:
  enum class Ending
  {
    MAPPED,     // a map is there, whatever it is worth
    REFUSED,    // the program said that it has none
    NO_MAP,     // the program said nothing of that kind, but wrote none
    TIMED_OUT,  // it was ended after the time that it had
    BROKE_DOWN, // it was ended by another signal
    NOT_RUN     // the shell could not run it
  };

  struct Run
  {
    Ending ending = Ending::MAPPED;
    std::string reason; // unless mapped
    Command_outcome outcome;
  };

  Mapping_program(const Command_template& command_template, const Command_limits& limits)
    : m_template(command_template)
    , m_limits(limits)
  {}

  // Maps the mesh in `file`. `map_file()` is the map then, if there is one, until the next call.
  Run run(const std::filesystem::path& file) const
  {
    std::filesystem::remove(map_file());
    Run run;
    run.outcome = run_command(m_template.command(std::filesystem::absolute(file), map_file()), standard_output(),
                              error_output(), m_limits);
    if(run.outcome.is_timed_out)
    {
      run.ending = Ending::TIMED_OUT;
      run.reason = "did not end within " + to_text(m_limits.seconds, 0) + " seconds";
    }
    else if(run.outcome.signal != 0)
    {
      run.ending = Ending::BROKE_DOWN;
      run.reason = "broke down: " + std::string(strsignal(run.outcome.signal));
    }
    else if(run.outcome.exit_status == 126 || run.outcome.exit_status == 127) // of the shell
    {
      run.ending = Ending::NOT_RUN;
      run.reason = "the command cannot be run: " + message(file);
    }
    else if(run.outcome.exit_status != 0)
    {
      run.ending = Ending::REFUSED;
      run.reason = message(file);
    }
    else if(!std::filesystem::exists(map_file()))
    {
      run.ending = Ending::NO_MAP;
      run.reason = "succeeded, but wrote no map";
    }
    return run;
  }

  std::filesystem::path map_file() const
  {
    return m_folder.path() / ("map" + (m_template.output_format().empty() ? ".off" : m_template.output_format()));
  }

private:
  std::filesystem::path standard_output() const { return m_folder.path() / "stdout.txt"; }
  std::filesystem::path error_output() const { return m_folder.path() / "stderr.txt"; }

  // The first words that the program said about the file, among its errors if there are any, without the name of the
  // file.
  std::string message(const std::filesystem::path& file) const
  {
    constexpr std::size_t longest = 300;
    for(const std::filesystem::path& path : {error_output(), standard_output()})
    {
      std::ifstream in(path);
      std::string text;
      for(std::string word; text.size() < 2 * longest && in >> word;)
      {
        text += (text.empty() ? "" : " ") + word;
      }
      const std::string name = std::filesystem::absolute(file).string() + ": ";
      const std::size_t at = text.find(name);
      text.erase(0, at == std::string::npos ? 0 : at + name.size());
      if(!text.empty())
      {
        return text.size() < longest ? text : text.substr(0, longest) + " ...";
      }
    }
    return "without a word";
  }

  Command_template m_template;
  Command_limits m_limits;
  Temporary_folder m_folder;
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MAPPING_PROGRAM_H
