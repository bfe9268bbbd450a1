// The package as a program: maps a mesh file to a sphere, measures the distortion, writes and reports the result.
// Its options are explained by --help; the parts of the program are in the folder include.

#include "include/Colored_mesh.h"
#include "include/Input_mesh.h"
#include "include/Method_runner.h"
#include "include/Output_files.h"
#include "include/Program_error.h"
#include "include/Program_options.h"
#include "include/Run_report.h"
#include "include/balanced_radius.h"
#include "include/read_soup.h"
#include "include/write_soup.h"

#include <CGAL/Real_timer.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/version_macros.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <ostream>
#include <vector>

using namespace Program;

// Within CGAL, the package has no version of its own.
#ifdef SPHERICAL_PARAMETERIZATION_VERSION
constexpr const char* version = SPHERICAL_PARAMETERIZATION_VERSION;
#else
constexpr const char* version = "of CGAL";
#endif

// returns the seconds since the last call
double lap(CGAL::Real_timer& timer)
{
  const double seconds = timer.time();
  timer.reset();
  return seconds;
}

template <class Map>
std::vector<Point_3> points_of(const Map& map)
{
  return std::vector<Point_3>(map.begin(), map.end());
}

// measures the map, and each face, with the radius of eq. 11; does nothing if no number holds that radius
std::optional<SP::Distortion_summary> measure_balanced(Mesh& mesh, const Sphere_map& sphere, double radius,
                                                       const Distortion_map& distortions)
{
  const double balanced = balanced_radius(mesh, sphere, radius, distortions);
  if(balanced == 0.)
    return std::nullopt;
  const Sphere_map scaled = mesh.add_property_map<Vertex_index, Point_3>("v:balanced", Point_3(0, 0, 0)).first;
  for(const Vertex_index v : mesh.vertices())
    scaled[v] = Point_3(balanced * (sphere[v].x() / radius), balanced * (sphere[v].y() / radius),
                        balanced * (sphere[v].z() / radius));
  return SP::measure_distortion(mesh, scaled, distortions);
}

// returns the exit status
int map_to_sphere(const Program_options& options)
{
  Output_files files(options); // before any work
  Run_report report(options);
  CGAL::Real_timer timer;
  timer.start();

  Input_mesh input(options.input, read_soup(options.input));
  Mesh& mesh = input.mesh();
  report.seconds_for_input = lap(timer);

  // A vertex without a face stays at the origin.
  const Sphere_map sphere = mesh.add_property_map<Vertex_index, Point_3>("v:sphere", Point_3(0, 0, 0)).first;
  report.result = Method_runner(input, sphere, options).run();

  lap(timer);
  const Distortion_map distortions = mesh.add_property_map<Mesh::Face_index, SP::Face_distortion>("f:distortion").first;
  report.distortion = SP::measure_distortion(mesh, sphere, distortions);
  if(options.is_unit_sphere)
    report.balanced = measure_balanced(mesh, sphere, report.distortion.radius, distortions);
  report.seconds_for_measuring = lap(timer);

  if(files.sphere)
    files.sphere->write(
        [&](std::ostream& out) { write_soup(out, file_format(options.output), points_of(sphere), input.triangles()); });
  std::optional<Colored_mesh> colored;
  if(files.colored_surface)
  {
    const bool is_conformal = options.is_conformal();
    std::vector<double> values;
    for(const SP::Face_distortion& distortion : distortions)
      values.push_back(is_conformal ? distortion.angle : distortion.isometric);
    colored.emplace(mesh.number_of_vertices(), input.triangles(), values, is_conformal ? 2. : 1.);
    report.colored = &*colored;
    files.colored_surface->write([&](std::ostream& out) { colored->write(out, points_of(mesh.points())); });
    files.colored_sphere->write([&](std::ostream& out) { colored->write(out, points_of(sphere)); });
  }
  report.seconds_for_output = lap(timer);
  report.files = files.names();
  if(files.json)
    files.json->write([&](std::ostream& out) { out << report.json(); });
  files.commit();

  if(!options.is_quiet)
    report.print(std::cout);
  if(report.result.is_one_to_one)
    return EXIT_SUCCESS;
  constexpr int exit_folded = 2;
  std::cerr << "spherical_parameterization: " << options.input << ": the map is not one-to-one: " << report.fault()
            << "\n--method " << name_of(methods, options.method) << " does not exclude that; --method bld does.\n";
  return exit_folded;
}

int main(int argc, char** argv)
{
  try
  {
    const Program_options options(argc, argv);
    if(options.wants_help)
      std::cout << options.help();
    else if(options.wants_version)
      std::cout << "spherical_parameterization " << version << ", built with CGAL " << CGAL_VERSION_STR << '\n';
    else
      return map_to_sphere(options);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << "spherical_parameterization: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
