// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_RUN_COMMAND_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_RUN_COMMAND_H

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace benchmarks {

// What a command may use; 0 is no limit.
struct Command_limits
{
  double seconds;
  double bytes; // of address space, for each process of the command
};

// How a command ended.
struct Command_outcome
{
  int exit_status = 0; // if neither of the next two
  int signal = 0;      // that ended it
  bool is_timed_out = false;
  double seconds = 0.;
  double cpu_seconds = 0.; // of all its processes, in user mode and for system calls
  double peak_bytes = 0.;  // the physical memory of its largest process

  // Adds what a process has used, along with those processes that it has waited for.
  void add(const rusage& usage)
  {
    const auto to_seconds = [](const timeval& t) {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    cpu_seconds += to_seconds(usage.ru_utime) + to_seconds(usage.ru_stime);
#ifdef __APPLE__
    const double bytes = static_cast<double>(usage.ru_maxrss);
#else
    const double bytes = 1024. * static_cast<double>(usage.ru_maxrss);
#endif
    peak_bytes = (std::max)(peak_bytes, bytes);
  }
};

// Runs a command line of the shell, with its output going to two files, until it ends or a limit is reached. Nothing
// that it starts survives it, unless it leaves the group of its processes.
inline Command_outcome run_command(const std::string& command, const std::filesystem::path& standard_output,
                                   const std::filesystem::path& error_output, const Command_limits& limits)
{
  using Clock = std::chrono::steady_clock;

#ifdef __linux__
  // Its processes that nobody waits for, above all when it is ended, become ours, so that what they have used is known.
  prctl(PR_SET_CHILD_SUBREAPER, 1L);
#endif
  const Clock::time_point start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const pid_t child = fork();
  if(child < 0)
  {
    throw std::runtime_error("cannot create a process");
  }
  if(child == 0)
  {
    setpgid(0, 0);
    const auto redirect = [](int descriptor, const char* file, int flags) {
      const int opened = open(file, flags, 0600);
      if(opened < 0 || dup2(opened, descriptor) < 0)
      {
        _exit(127);
      }
    };
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, standard_output.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, error_output.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    if(limits.bytes > 0.)
    {
      const rlimit most = {static_cast<rlim_t>(limits.bytes), static_cast<rlim_t>(limits.bytes)};
      setrlimit(RLIMIT_AS, &most);
    }
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  setpgid(child, child); // whoever of the two comes first

  Command_outcome outcome;
  int status = 0;
  rusage usage = {};
  pid_t ended = 0;
  while((ended = wait4(child, &status, WNOHANG, &usage)) == 0 || (ended < 0 && errno == EINTR))
  {
    if(limits.seconds > 0. && seconds() > limits.seconds && !outcome.is_timed_out)
    {
      outcome.is_timed_out = true;
      kill(-child, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  outcome.seconds = seconds();
  kill(-child, SIGKILL); // what is left of the group
  if(ended < 0)
  {
    throw std::runtime_error("cannot wait for a process");
  }
  outcome.add(usage);
  int ignored;
  while((ended = wait4(-child, &ignored, 0, &usage)) > 0 || (ended < 0 && errno == EINTR))
  {
    if(ended > 0)
    {
      outcome.add(usage);
    }
  }
  if(WIFSIGNALED(status))
  {
    outcome.signal = WTERMSIG(status);
  }
  else if(WEXITSTATUS(status) > 128) // how a shell tells that what it ran was ended by a signal
  {
    outcome.signal = WEXITSTATUS(status) - 128;
  }
  else
  {
    outcome.exit_status = WEXITSTATUS(status);
  }
  return outcome;
}

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_RUN_COMMAND_H
