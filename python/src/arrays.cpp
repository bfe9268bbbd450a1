#include "arrays.h"

#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <utility>

namespace Module {

namespace {

[[noreturn]] void refuse(const std::string& name, Program::Input_defect defect)
{
  defect.message = name + defect.message;
  throw Error{std::move(defect)};
}

} // namespace

Mesh make_mesh(const std::string& name, const Points& points, const Indices& faces)
{
  const std::size_t n_vertices = number_of_rows(points), n_faces = number_of_rows(faces);
  const double* const coordinates = points.data();
  const std::int64_t* const indices = faces.data();
  std::vector<std::array<Vertex_index, 3>> triangles(n_faces);
  for(std::size_t f = 0; f < n_faces; ++f)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::int64_t v = indices[3 * f + i];
      if(v < 0 || static_cast<std::uint64_t>(v) >= n_vertices)
        refuse(name, {SP::ERROR_WRONG_PARAMETER,
                      "face " + std::to_string(f) + " has the vertex " + std::to_string(v) + ", but there are " +
                          std::to_string(n_vertices) + ".\n(Vertices and faces are counted from 0.)",
                      {},
                      {},
                      f});
      triangles[f][i] = Vertex_index(static_cast<Mesh::size_type>(v));
    }
  if(auto defect = Program::find_defect_of_faces(n_vertices, triangles))
    refuse(name, std::move(*defect));

  using Index = Mesh::size_type;
  Mesh mesh;
  mesh.reserve(static_cast<Index>(n_vertices), static_cast<Index>(n_faces / 2 * 3), static_cast<Index>(n_faces));
  for(std::size_t k = 0; k < 3 * n_vertices; k += 3)
    mesh.add_vertex(Point_3(coordinates[k], coordinates[k + 1], coordinates[k + 2]));
  // All at once: one by one, the faces at a vertex take time that is quadratic in their number.
  CGAL::Euler::add_faces(triangles, mesh);
  return mesh;
}

void check_surface(const std::string& name, const Mesh& mesh)
{
  if(auto defect = Program::find_defect_of_mesh(mesh))
    refuse(name, std::move(*defect));
}

void check_map(const std::string& name, const Mesh& mesh, const std::string& name_of_map, const Points& sphere)
{
  check_surface(name, mesh);
  const Const_row_map map = rows_of(sphere);
  if(SP::is_bijective(mesh, map))
    return;
  for(const Vertex_index v : mesh.vertices())
  {
    const Point_3 p = get(map, v);
    if(!mesh.is_isolated(v) && !(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())))
      refuse(name, {SP::ERROR_NON_FINITE_COORDINATE,
                    name_of_map + ": vertex " + std::to_string(v) +
                        " has a coordinate that is infinite or not a number.\n(Vertices are counted from 0.)",
                    v,
                    {},
                    {}});
  }
  std::vector<SP::Face_distortion> distortions(mesh.number_of_faces());
  const auto distortion_map =
      boost::make_iterator_property_map(distortions.begin(), boost::typed_identity_property_map<std::size_t>());
  const std::size_t n_inverted = SP::measure_distortion(mesh, map, distortion_map).number_of_inverted_faces;
  const auto inverted =
      std::find_if(distortions.begin(), distortions.end(), [](const auto& d) { return d.is_inverted; });
  if(inverted == distortions.end())
    refuse(name, {SP::ERROR_NO_1_TO_1_MAPPING,
                  name_of_map + " is not one-to-one: the faces cover the sphere more than once.",
                  {},
                  {},
                  {}});
  const auto f = static_cast<std::size_t>(inverted - distortions.begin());
  refuse(name, {SP::ERROR_NO_1_TO_1_MAPPING,
                name_of_map + " is not one-to-one: face " + std::to_string(f) +
                    " is not positively oriented as seen from the origin (" + std::to_string(n_inverted) +
                    " such faces in total).\n(Faces are counted from 0.)",
                {},
                {},
                f});
}

} // namespace Module
