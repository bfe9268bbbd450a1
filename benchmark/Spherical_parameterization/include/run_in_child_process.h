// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_RUN_IN_CHILD_PROCESS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_RUN_IN_CHILD_PROCESS_H

#include <cerrno>
#include <stdexcept>
#include <type_traits>

#include <sys/wait.h>
#include <unistd.h>

namespace benchmarks {

// Returns `compute()`, called in a process of its own, which starts with the memory and the threads of nobody else. The
// calling process must have a single thread. `compute` must not throw.
template <class Compute>
auto run_in_child_process(const Compute& compute)
{
  using Result = decltype(compute());
  static_assert(std::is_trivially_copyable<Result>::value, "The result goes through a pipe.");

  int ends[2];
  if(pipe(ends) != 0)
  {
    throw std::runtime_error("cannot create a pipe");
  }
  const pid_t child = fork();
  if(child < 0)
  {
    throw std::runtime_error("cannot create a process");
  }
  if(child == 0)
  {
    const Result result = compute();
    // Pipes take so few bytes at once.
    static_assert(sizeof(Result) <= 512, "The result goes through a pipe.");
    _exit(write(ends[1], &result, sizeof(Result)) == static_cast<ssize_t>(sizeof(Result)) ? 0 : 1);
  }
  close(ends[1]);
  Result result;
  const ssize_t bytes = read(ends[0], &result, sizeof(Result));
  close(ends[0]);
  while(waitpid(child, nullptr, 0) < 0 && errno == EINTR)
  {}
  if(bytes != static_cast<ssize_t>(sizeof(Result)))
  {
    throw std::runtime_error("the process broke down");
  }
  return result;
}

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_RUN_IN_CHILD_PROCESS_H
