#include "Interrupt_guard.h"
#include "Mesh_run.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <new>

namespace Program {

namespace {

// Prints the report of a surface that is not mapped.
int report_surface(const Mesh_run& mesh, const Options& options)
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
//
// \param read passes the surface to the run
int run(const Options& options, const File_names& names, const std::function<void(Mesh_run&)>& read)
{
  Mesh_run mesh(options, names);
  try
  {
    read(mesh);
    if(options.is("repair"))
    {
      mesh.repair();
      return report_surface(mesh, options);
    }
    if(options.has("beside"))
    {
      mesh.show_beside();
      return EXIT_SUCCESS;
    }
    if(options.is("show") && options.sphere_file.empty() && mesh.show_handles())
      return report_surface(mesh, options);
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
  if(!std::cout.flush() &&
     !report.files.empty()) // a map may have taken hours: the error of the report must not look like its loss
    throw Program_error("cannot write to the standard output. All files have been written.");
  return report.result.is_one_to_one ? EXIT_SUCCESS : exit_status_folded;
}

// Maps each component of a surface, with its own vertices only. A component that fails does not stop the others. Returns the exit
// status.
int run_components(const Options& options)
{
  const File_content whole = read_file_content(options.file_names.input);
  std::vector<std::vector<std::size_t>> components = components_of(whole, options.repair.has_value());
  if(components.empty())
    components.emplace_back(); // reading it reports the defect
  Run_report::Component component(components);
  const std::size_t n = components.size();
  int status = EXIT_SUCCESS;
  for(std::size_t& k = component.index; k < n; ++k)
    try
    {
      if(Interrupt_guard::is_interrupted())
      {
        std::cerr << "spherical_parameterization: interrupted: " << n - k << " of " << n
                  << " components have not been mapped\n";
        return EXIT_FAILURE;
      }
      const int status_of_component = run(options, options.file_names.of_part(k),
                                          [&](Mesh_run& mesh) { mesh.take(part_of(whole, components[k]), component); });
      status = status == EXIT_FAILURE ? status : (std::max)(status, status_of_component);
    }
    catch(const std::exception& error)
    {
      std::cerr << "spherical_parameterization: component " << k + 1 << " of " << n << ": " << message_of(error)
                << (n > 1 ? "\nVertices and faces are numbered within the component, in the order of the file.\n"
                          : "\n");
      status = EXIT_FAILURE;
    }
  return status;
}

} // namespace

int run_map(const Options& options)
{
  return options.has("each-component") ? run_components(options)
                                       : run(options, options.file_names, [](Mesh_run& mesh) { mesh.read(); });
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
