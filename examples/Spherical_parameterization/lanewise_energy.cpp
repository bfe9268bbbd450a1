#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/tags.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// Between angles and lengths: w times I/d, the energy of angles, and 1 - w times the symmetric
// Dirichlet energy, I (1 + 1/d^2) / 2. As both functions are templates that need no more than
// arithmetic, several vertices are moved at once.
struct Blended_energy
{
  using Is_lanewise = CGAL::Tag_true;

  double w = 0.5;

  bool is_valid() const { return w >= 0. && w <= 1.; }

  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    return i * (w / d + 0.5 * (1. - w) * (1. + 1. / (d * d)));
  }

  template <class FT>
  SP::Basic_energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    const FT e = 1. / d;
    const FT e_i = w * e + 0.5 * (1. - w) * (1. + e * e);
    const FT e_id = -(w + (1. - w) * e) * e * e;
    return {i * e_i, e_i, i * e_id, FT(0.), e_id, i * (2. * w + 3. * (1. - w) * e) * e * e * e};
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
  for(const double w : {0., 0.5, 0.9})
  {
    SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, Blended_energy> parameterizer(Blended_energy{w});
    const SP::Error_code error = SP::parameterize(mesh, parameterizer, sphere);
    if(error != SP::OK)
    {
      std::cerr << SP::get_error_message(error) << std::endl;
      return EXIT_FAILURE;
    }
    const SP::Distortion_summary distortion = SP::measure_distortion(mesh, sphere);
    std::cout << "weight " << w << ": on average, isometric distortion " << distortion.isometric.average
              << ", angle distortion " << distortion.angle.average << std::endl;
  }
  return EXIT_SUCCESS;
}
