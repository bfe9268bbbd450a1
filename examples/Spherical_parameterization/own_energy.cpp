#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// An energy that penalizes area distortion, and angle distortion with a small weight w: E = d + 1/d + w I/d.
// I and d are the sum of the squares and the product of the two singular values of the map of a face. The functions
// are templates that use only arithmetic, so that vector registers can process several vertices at once.
struct Area_energy
{
  double w = 0.05;

  bool is_valid() const { return w > 0.; }

  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    return d + (1. + w * i) / d;
  }

  template <class FT>
  SP::Energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    const FT pole = (1. + w * i) / d;
    return {d + pole, w / d, 1. - pole / d, FT(0.), -w / (d * d), 2. * pole / (d * d)};
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
  SP::Distortion_summary distortion;
  SP::Error_code error =
      SP::parameterize(mesh, SP::Bijective_low_distortion_parameterizer_3().energy(Area_energy{0.05}), sphere);
  if(error == SP::OK)
    error = SP::measure_distortion(mesh, sphere, distortion);
  std::cout << SP::get_error_message(error) << std::endl;
  if(error != SP::OK)
    return EXIT_FAILURE;
  std::cout << "area distortion (2 is equiareal) " << distortion.area.average << std::endl;
  return EXIT_SUCCESS;
}
