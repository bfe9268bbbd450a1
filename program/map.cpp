#include "Mesh_run.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <new>

namespace Program {

namespace {

int report_repair(const Mesh_run& mesh, const Options& options)
{
  if(options.has("quiet"))
    return EXIT_SUCCESS;
  mesh.report().print_surface(std::cout);
  for(const std::string& file : mesh.report().files)
    std::cout << "Written:   " << printable(file) << '\n';
  const std::string defect = mesh.find_defect();
  std::cout << (defect.empty() ? "The surface can be mapped." : "The surface cannot be mapped: " + defect) << '\n';
  return EXIT_SUCCESS;
}

// Maps a surface, or a part of it, and returns the exit status.
int run(const Options& options, const File_names& names, std::size_t component)
{
  Mesh_run mesh(options, names, component);
  try
  {
    mesh.read();
    if(options.is("repair"))
    {
      mesh.repair();
      return report_repair(mesh, options);
    }
    if(options.has("beside"))
    {
      mesh.show_beside();
      return EXIT_SUCCESS;
    }
    mesh.map();
    mesh.sample();
    mesh.match();
    mesh.write();
  }
  catch(const std::bad_alloc& error)
  {
    throw error_in(options.file_names.input, message_of(error));
  }

  const Run_report& report = mesh.report();
  if(options.text("json") == "-")
    std::cout << report.json();
  else if(!options.has("quiet"))
    report.print(std::cout);
  std::cerr << report.warnings();
  if(!report.result.is_one_to_one)
    std::cerr << "spherical_parameterization: " << report.explain_fault() << '\n';
  if(!std::cout.flush() && !report.files.empty()) // a map may have taken hours: it is not lost with its report
    throw Program_error("the standard output cannot be written. All files have been written nevertheless.");
  return report.result.is_one_to_one ? EXIT_SUCCESS : exit_status_folded;
}

// Maps each part of a surface; what fails with one of them does not stop the others. Returns the exit status.
int run_components(const Options& options)
{
  const std::size_t n = parts_of(read_file_content(options.file_names.input).polygons).size();
  int status = EXIT_SUCCESS;
  for(std::size_t k = 0; k < (std::max)(n, std::size_t(1)); ++k)
    try
    {
      const int status_of_part = run(options, options.file_names.of_part(k), k);
      status = status == EXIT_FAILURE ? status : (std::max)(status, status_of_part);
    }
    catch(const std::exception& error)
    {
      std::cerr << "spherical_parameterization: part " << k + 1 << " of " << n << ": " << message_of(error) << '\n';
      status = EXIT_FAILURE;
    }
  return status;
}

} // namespace

int run_map(const Options& options)
{
  return options.text("components") == "each" ? run_components(options) : run(options, options.file_names, 0);
}

int run_check(const Options& options)
{
  if(!options.sphere_file.empty())
    return run_map(options);
  const std::string& name = options.file_names.input;
  Input_mesh mesh(name, read_file_content(name));
  mesh.check();
  if(!options.has("quiet"))
    std::cout << printable(name) << ": " << sizes_of(mesh.mesh().number_of_vertices(), mesh.mesh().number_of_faces())
              << "; the surface can be mapped.\n";
  return EXIT_SUCCESS;
}

} // namespace Program
