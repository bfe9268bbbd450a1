// The package as a program: maps a mesh file to a sphere, measures the distortion, writes and reports the result; or
// does so with many. Its options are explained by --help; the parts of the program are in the folder include.

#include "include/Batch.h"
#include "include/Batch_scheduler.h"
#include "include/Components.h"
#include "include/Mesh_run.h"
#include "include/Program_error.h"
#include "include/Program_options.h"
#include "include/Resampling_run.h"
#include "include/Run_report.h"
#include "include/mesh_files.h"
#include "include/read_soup.h"

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

#include <fcntl.h>
#include <unistd.h>

using namespace Program;

// returns the exit status
int map_to_sphere(const Program_options& options, const File_names& names, std::size_t component)
{
  Mesh_run run(options, names, component);
  try
  {
    run.map();
    run.sample();
    run.match();
    run.write();
  }
  catch(const std::bad_alloc& error)
  {
    throw Program_error(options.file_names.input, message_of(error));
  }

  const Run_report& report = run.report();
  if(options.prints_json)
    std::cout << report.json();
  else if(!options.is_quiet)
    report.print(std::cout);
  std::cerr << report.warnings();
  if(!report.result.is_one_to_one)
    std::cerr << "spherical_parameterization: " << report.explain_fault() << '\n';
  if(!std::cout.flush() && !report.files.empty()) // a map may have taken hours: it is not lost with its report
    throw Program_error("the standard output cannot be written. All files have been written nevertheless.");
  return report.result.is_one_to_one ? EXIT_SUCCESS : Run_report::exit_status_folded;
}

// Maps each part of a surface; what fails with one of them does not stop the others. Returns the exit status.
int map_components(const Program_options& options)
{
  const std::size_t n = Components(read_soup(options.file_names.input).polygons).sizes().size();
  int status = EXIT_SUCCESS;
  for(std::size_t k = 0; k < (std::max)(n, std::size_t(1)); ++k)
    try
    {
      const int status_of_part = map_to_sphere(options, options.file_names.of_part(k), k);
      status = status == EXIT_FAILURE ? status : (std::max)(status, status_of_part);
    }
    catch(const std::exception& error)
    {
      std::cerr << "spherical_parameterization: part " << k + 1 << " of " << n << ": " << message_of(error) << '\n';
      status = EXIT_FAILURE;
    }
  return status;
}

// returns the exit status
int run_program(const Program_options& options)
{
  if(options.wants_help || options.wants_version)
  {
    std::cout << (options.wants_help ? options.help() : program_version() + '\n');
    return EXIT_SUCCESS;
  }
#ifdef CGAL_LINKED_WITH_TBB
  // As many threads as are asked for would have memory of their own each.
  const std::size_t n_wanted = options.max_threads, n_cores = Thread_limit::number_of_threads();
  // It is never deleted: TBB makes a thread as a limit ends.
  [[maybe_unused]] static const Thread_limit* const threads = new Thread_limit((std::min)(n_wanted, n_cores));
  if(const std::size_t n = Thread_limit::number_of_threads(); n_wanted > n && !options.is_quiet)
    std::cerr << "spherical_parameterization: --threads " << n_wanted << ": no more than " << n << " can be had here\n";
#endif
  if(options.resamples())
    return Resampling_run(options).run();
  if(options.is_batch())
    return Batch(options).run();
  return options.takes_each_component ? map_components(options) : map_to_sphere(options, options.file_names, 0);
}

// What is written to a standard stream that is closed would go to the file that is opened next. Now it fails.
void occupy_closed_streams()
{
  for(const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if(fcntl(stream, F_GETFD) == -1)
      open("/dev/null", O_RDONLY);
}

int main(int argc, char** argv)
{
  occupy_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows larger than permitted cannot be written: an error as others
  try
  {
    const int status = run_program(Program_options(argc, argv));
    if(!std::cout.flush())
      throw Program_error("the standard output cannot be written");
    return status;
  }
  catch(const std::exception& error)
  {
    std::cerr << "spherical_parameterization: " << message_of(error) << '\n';
    return EXIT_FAILURE;
  }
}
