// Calls that are mistaken; check.py finds the sentence of each among the errors of the compiler.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Surface_mesh.h>

#include <map>

namespace SP = CGAL::Spherical_parameterization;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

struct Read_only_map
{
  using key_type = Vertex;
  using value_type = Point_3;
  using reference = Point_3;
  using category = boost::readable_property_map_tag;
};

void call(Mesh& mesh, SP::Bijective_low_distortion_parameterizer_3<>& bld)
{
  const auto sphere = mesh.add_property_map<Vertex, Point_3>().first;
  const auto of_faces = mesh.add_property_map<Face, Point_3>().first;
  const auto of_doubles = mesh.add_property_map<Vertex, double>().first;
  const std::map<Vertex, Point_3> std_map;
  const SP::Bijective_low_distortion_parameterizer_3<> const_bld;
  using CGAL::parameters::number_of_iterations;

  SP::parameterize(mesh, of_doubles);                               // error: has to hold points
  SP::parameterize(mesh, of_faces);                                 // error: has to be one for the vertices
  SP::parameterize(mesh, Read_only_map());                          // error: has to be writable
  SP::parameterize(mesh, std_map);                                  // error: of an std::map
  SP::parameterize(mesh, mesh.add_property_map<Vertex, Point_3>()); // error: it is .first
  SP::parameterize(mesh, mesh);                                     // error: has to be the property map
  SP::parameterize(mesh, bld);                                      // error: has to be the property map
  SP::parameterize(sphere, mesh);                                   // error: The first argument has to be the mesh
  SP::parameterize(bld, mesh, sphere);                              // error: The first argument has to be the mesh
  SP::parameterize(mesh, sphere, bld);                              // error: has to be the parameterizer
  SP::parameterize(mesh, const_bld, sphere);                        // error: must not be const
  SP::parameterize(mesh, sphere, number_of_iterations(3.7));        // error: has to be an integer

  // A compiler reports each mistake with the same types once, hence other ones.
  bld.parameterize(mesh, 0); // error: has to be the property map
  bld.parameterize(0, mesh); // error: The first argument has to be the mesh
}
