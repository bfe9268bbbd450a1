// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BATCH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BATCH_H

#include "Batch_log.h"
#include "Batch_plan.h"
#include "Batch_scheduler.h"
#include "Earlier_report.h"
#include "File_names.h"
#include "Interrupt_guard.h"
#include "Mesh_run.h"
#include "Program_options.h"

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>
#include <vector>

namespace Program {

/// Many meshes, each of which is mapped as if it were the only one.
class Batch
{
public:
  /// checks all that can be checked before any work.
  ///
  /// \param options have to live longer
  ///
  /// \throws Program_error if anything stands against a start
  explicit Batch(const Program_options& options)
    : m_options(options)
    , m_log(options.is_quiet)
    , m_meshes(Batch_plan(options).meshes())
  {}

  /// maps all meshes that are not done; what fails with one of them does not stop the others. Returns the exit status.
  int run()
  {
    if(m_options.is_resumed)
      leave_out_what_is_done();
    m_log.begin(m_meshes.size());
    std::vector<std::uintmax_t> sizes;
    for(const File_names& names : m_meshes)
    {
      std::error_code error; // reading fails as well, and says why
      const std::uintmax_t size = std::filesystem::file_size(names.input, error);
      sizes.push_back(error ? 0 : size);
    }
    {
      const Interrupt_guard guard({SIGINT, SIGTERM});
      Batch_scheduler::for_each_mesh(sizes, [&](std::size_t i) { run(m_meshes[i]); });
    }
    m_log.print_summary();
    return m_log.exit_status();
  }

private:
  void leave_out_what_is_done()
  {
    std::vector<File_names> meshes;
    for(const File_names& names : m_meshes)
    {
      const Earlier_report report(names);
      if(report.tells_the_same_run(m_options))
        m_log.leave_out(names.input, report.is_one_to_one());
      else
        meshes.push_back(names);
    }
    m_meshes.swap(meshes);
  }

  // A mesh that is interrupted leaves nothing: whatever is in the output folder has all the sweeps that the options ask
  // for. What an earlier run has left goes first, so that nothing there is of another mesh or of other options.
  void run(const File_names& names)
  {
    if(Interrupt_guard::is_interrupted())
      return;
    try
    {
      Mesh_run run(m_options, names);
      run.remove_earlier_files();
      run.map();
      if(run.report().is_interrupted())
        return;
      run.write();
      m_log.add_map(run.report());
    }
    catch(const std::bad_alloc&)
    {
      m_log.add_failure(names.input, "the memory does not suffice");
    }
    catch(const std::exception& error)
    {
      m_log.add_failure(names.input, error.what());
    }
  }

  const Program_options& m_options;
  Batch_log m_log;
  std::vector<File_names> m_meshes;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BATCH_H
