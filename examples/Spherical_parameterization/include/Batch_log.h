// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BATCH_LOG_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BATCH_LOG_H

#include "Run_report.h"
#include "Stopwatch.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <mutex>
#include <ostream>
#include <sstream>
#include <string>

namespace Program {

/// What is told of a batch: a line as each mesh ends, and a summary. What notes the end of a mesh may be called from
/// several threads at once; nothing else is printed meanwhile, so that lines stay whole.
class Batch_log
{
public:
  explicit Batch_log(bool is_quiet)
    : m_is_quiet(is_quiet)
  {}

  /// sets how many meshes are to be mapped.
  void begin(std::size_t number_of_meshes) { m_number_of_meshes = number_of_meshes; }

  /// notes that a mesh is left out as it is done.
  void leave_out(const std::string& input, bool is_one_to_one)
  {
    ++m_left_out;
    if(is_one_to_one)
      return;
    ++m_folded_before;
    print_error(input + ": the map of an earlier run is not one-to-one");
  }

  /// notes that a mesh has been mapped, and its files are written.
  void add_map(const Run_report& report)
  {
    std::ostringstream line;
    report.print_short(line);
    const std::lock_guard<std::mutex> lock(m_mutex);
    ++m_mapped;
    print_line(report.input(), line.str());
    if(report.result.is_one_to_one)
      return;
    ++m_folded;
    print_error(report.explain_fault());
  }

  /// notes that a mesh has no map, and why.
  void add_failure(const std::string& input, const std::string& message)
  {
    const bool names_input = message.compare(0, input.size(), input) == 0;
    const std::string text = names_input ? message : input + ": " + message;
    const std::size_t begin = (std::min)(input.size() + 2, text.size());
    const std::lock_guard<std::mutex> lock(m_mutex);
    ++m_failed;
    print_line(input, "failed: " + text.substr(begin, text.find('\n', begin) - begin));
    print_error(text);
  }

  /// prints what has become of all meshes.
  void print_summary()
  {
    const std::size_t n_missed = m_number_of_meshes - m_mapped - m_failed;
    if(n_missed > 0)
      print_error("interrupted: " + std::to_string(n_missed) + " of " + std::to_string(m_number_of_meshes) +
                  " meshes have not been mapped; --resume goes on with them");
    if(m_is_quiet)
      return;
    constexpr double minute = 60.;
    const double seconds = m_stopwatch.seconds();
    std::cout << "Mapped " << m_mapped << ", left out " << m_left_out << ", folded " << m_folded + m_folded_before
              << ", failed " << m_failed;
    if(n_missed > 0)
      std::cout << ", interrupted " << n_missed;
    std::cout << std::fixed << std::setprecision(1) << "; " << seconds << " seconds";
    if(m_mapped > 0 && seconds > 0.)
      std::cout << ", " << minute * static_cast<double>(m_mapped) / seconds << " meshes per minute";
    std::cout << std::endl;
  }

  /// returns the exit status of the program: whether all meshes have a map, and all maps are certified.
  int exit_status() const
  {
    if(m_mapped < m_number_of_meshes)
      return EXIT_FAILURE;
    return m_folded + m_folded_before > 0 ? Run_report::exit_status_folded : EXIT_SUCCESS;
  }

private:
  void print_line(const std::string& input, const std::string& text)
  {
    if(!m_is_quiet)
      std::cout << '[' << m_mapped + m_failed << '/' << m_number_of_meshes << "] " << input << ": " << text
                << std::endl;
  }

  static void print_error(const std::string& message)
  {
    std::cerr << "spherical_parameterization: " + message + "\n" << std::flush;
  }

  bool m_is_quiet;
  Stopwatch m_stopwatch;
  std::mutex m_mutex;
  std::size_t m_number_of_meshes = 0, m_left_out = 0, m_folded_before = 0, m_mapped = 0, m_folded = 0, m_failed = 0;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BATCH_LOG_H
