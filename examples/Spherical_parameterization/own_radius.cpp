#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// The radius at which half of the faces shrink and half of them grow. It is robust to outliers.
struct Median_radius
{
  double initial_radius(double equal_area_radius) const { return equal_area_radius; }

  template <class Energy>
  double operator()(const Energy& /* energy */, const SP::Face_range_3& faces, double radius)
  {
    std::vector<double> scales;
    for(const SP::Face_invariants_3& face : faces)
      scales.push_back(face.flat_d);
    const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
    std::nth_element(scales.begin(), middle, scales.end());
    return radius / std::sqrt(*middle);
  }
};

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/homer.off");

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Invalid input file: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  auto parameterizer = SP::Bijective_low_distortion_parameterizer_3().radius(Median_radius());
  const SP::Error_code error = SP::parameterize(mesh, parameterizer, sphere);
  std::cout << SP::get_error_message(error) << std::endl;
  if(error != SP::OK)
    return EXIT_FAILURE;
  std::cout << "radius " << parameterizer.report().radius << std::endl;
  return EXIT_SUCCESS;
}
