// Expands a surface in spherical harmonics, and prints the power of each degree and the distance of the reconstruction.

#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Bijective_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/spherical_harmonics_files.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/expand_in_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Sampling/measure_distance.h>
#include <CGAL/Spherical_parameterization/Harmonics/move_to_standard_position.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/Harmonics/reconstruct_from_spherical_harmonics.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bull.off");
  Mesh mesh, smooth;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Not a valid input file: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  auto smooth_sphere = smooth.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;

  // Maps of low stretch yield the smallest errors.
  SP::Bijective_low_distortion_parameterizer_3 bld;
  SP::Error_code error = SP::parameterize(mesh,
                                          bld.energy(SP::Stretch_energy_3())
                                              .radius(SP::Area_preserving_radius_3())
                                              .sharpness(SP::Sharpness::relative(3.))
                                              .tolerances(3e-3, 2e-3),
                                          sphere);
  SP::Spherical_harmonics_3 harmonics;
  if(error == SP::OK)
    error = SP::expand_in_spherical_harmonics(mesh, sphere, 30, harmonics);
  if(error == SP::OK)
    error =
        SP::reconstruct_from_spherical_harmonics(harmonics, SP::Sphere_domain_3::octahedron(64), smooth, smooth_sphere);
  SP::Surface_distance distance;
  if(error == SP::OK)
    error = SP::measure_distance(mesh, smooth, distance);
  SP::Standard_position position;
  if(error == SP::OK)
    error = SP::move_to_standard_position(harmonics, position);
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }

  const auto spectrum = harmonics.power_spectrum();
  for(std::size_t degree = 1; degree <= 8; ++degree)
    std::cout << "degree " << degree << ": " << spectrum[degree] << std::endl;
  std::cout << "root mean square error of degree 30 over the surface: " << harmonics.fit.error_over_surface
            << "; distance from the surface: " << distance.from_first.root_mean_square
            << "\nsemi-axes: " << position.semi_axes[0] << ", " << position.semi_axes[1] << ", "
            << position.semi_axes[2]
            << (position.axes_are_determined && position.signs_are_determined ? "" : ": the position is not determined")
            << std::endl;

  // Write a table for R and pandas.
  std::ofstream table("harmonics.csv");
  error = SP::IO::write_harmonics_table(table, harmonics);
  return error == SP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
