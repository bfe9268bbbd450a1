#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/repair.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char** argv)
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/elephant.off");

  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if(!CGAL::IO::read_polygon_soup(filename, points, polygons))
    return EXIT_FAILURE;

  SP::Repaired_surface<Point> repaired;
  SP::Repair_report report;
  if(SP::repair_surface(points, polygons, repaired, report) != SP::OK)
  {
    std::cerr << report.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << report.patches.size() << " patches to cut " << report.handle_cycles.size()
            << " handles and to fill holes are " << 100. * report.added_area << " % of the surface" << std::endl;

  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(repaired.points, repaired.triangles, mesh);
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point>("v:sphere").first;
  return SP::parameterize(mesh, sphere) == SP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
