// The package as a program: maps a mesh file to a sphere, measures the distortion, writes and reports the result; or
// does so with many. Its options are explained by --help; the parts of the program are in the folder include.

#include "include/Batch.h"
#include "include/Batch_scheduler.h"
#include "include/Mesh_run.h"
#include "include/Program_options.h"
#include "include/Run_report.h"

#include <cstdlib>
#include <exception>
#include <iostream>

using namespace Program;

// returns the exit status
int map_to_sphere(const Program_options& options)
{
  Mesh_run run(options, options.file_names);
  run.map();
  run.write();

  const Run_report& report = run.report();
  if(!options.is_quiet)
    report.print(std::cout);
  if(report.result.is_one_to_one)
    return EXIT_SUCCESS;
  std::cerr << "spherical_parameterization: " << report.explain_fault() << '\n';
  return Run_report::exit_status_folded;
}

int main(int argc, char** argv)
{
  try
  {
    const Program_options options(argc, argv);
    if(options.wants_help || options.wants_version)
    {
      std::cout << (options.wants_help ? options.help() : program_version() + '\n');
      return EXIT_SUCCESS;
    }
    const Thread_limit threads(options.max_threads);
    return options.is_batch() ? Batch(options).run() : map_to_sphere(options);
  }
  catch(const std::exception& error)
  {
    std::cerr << "spherical_parameterization: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
