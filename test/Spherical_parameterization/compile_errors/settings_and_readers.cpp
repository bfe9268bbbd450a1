// Named parameters and settings that are mistaken, and calls of what reads a map; check.py finds the sentence of each.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Surface_mesh.h>

#include <map>

namespace SP = CGAL::Spherical_parameterization;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

struct Not_a_visitor
{};

void call(Mesh& mesh, SP::Bijective_low_distortion_parameterizer_3<>& bld)
{
  const auto sphere = mesh.add_property_map<Vertex, Point_3>().first;
  const auto of_faces = mesh.add_property_map<Face, Point_3>().first;
  const auto of_doubles = mesh.add_property_map<Vertex, double>().first;
  const std::map<Vertex, Point_3> std_map;
  using CGAL::parameters::maximum_running_time;
  using CGAL::parameters::vertex_point_map;
  using CGAL::parameters::visitor;

  SP::parameterize(mesh, sphere, maximum_running_time("1"));    // error: has to be a number, the seconds
  SP::parameterize(mesh, sphere, visitor(Not_a_visitor()));     // error: derived from Default_visitor
  SP::parameterize(mesh, sphere, vertex_point_map(of_doubles)); // error: for the vertices of the mesh that holds
  SP::parameterize(mesh, sphere, vertex_point_map(of_faces));   // error: for the vertices of the mesh that holds
  SP::parameterize(mesh, sphere, vertex_point_map(std_map));    // error: vertex_point_map has to be a property map:

  SP::parameterize(mesh, bld.energy(3.), sphere);                          // error: The setting energy has to be
  SP::parameterize(mesh, bld.radius(1.), sphere);                          // error: Fixed_radius_3(r) for the radius r
  SP::parameterize(mesh, bld.initial_parameterizer(sphere), sphere);       // error: Precomputed_parameterizer_3(map)
  SP::parameterize(mesh, SP::Hierarchical_parameterizer_3<int>(), sphere); // error: The setting energy has to be

  SP::is_bijective(mesh, of_faces); // error: has to be one for the vertices
  SP::is_bijective(mesh, std_map);  // error: has to be the property map
  SP::Distortion_summary distortion;
  (void)SP::measure_distortion(mesh, of_doubles, distortion); // error: has to hold points
  (void)SP::measure_distortion(sphere, of_faces, distortion); // error: The first argument has to be the mesh
}
