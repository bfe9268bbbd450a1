#include "arrays.h"

#include <CGAL/Spherical_parameterization/internal/surface/add_triangles.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace Module {

namespace {

[[noreturn]] void refuse(const std::string& name, SP::internal::Soup_defect defect)
{
  defect.message = name + defect.message;
  throw Error{std::move(defect)};
}

// Above, find_defect_of_faces() refuses a mesh.
constexpr std::size_t max_size = (std::numeric_limits<std::int32_t>::max)();

// Whether no triangle has two sides in common with another one; a closed mesh where one has is no simplicial complex.
bool have_three_neighbors(const std::vector<SP::internal::Linked_triangle>& triangles)
{
  return std::none_of(triangles.begin(), triangles.end(), [](const auto& t) {
    return t.neighbors[0] == t.neighbors[1] || t.neighbors[1] == t.neighbors[2] || t.neighbors[2] == t.neighbors[0];
  });
}

void set_points(const Points& points, Mesh& mesh)
{
  const Const_row_map rows = rows_of(points);
  for(const Vertex_index v : mesh.vertices())
    mesh.point(v) = get(rows, v);
}

} // namespace

Mesh make_mesh(const std::string& name, const Points& points, const Indices& faces)
{
  const std::size_t n_vertices = number_of_rows(points), n_faces = number_of_rows(faces);
  const std::int64_t* const indices = faces.data();
  std::vector<std::array<std::uint32_t, 3>> triangles(n_faces); // from their last corners on
  for(std::size_t k = 0; k < 3 * n_faces; ++k)
  {
    if(indices[k] < 0 || static_cast<std::uint64_t>(indices[k]) >= n_vertices)
      refuse(name, {SP::ERROR_WRONG_PARAMETER,
                    "face " + std::to_string(k / 3) + " has the vertex " + std::to_string(indices[k]) +
                        ", but there are " + std::to_string(n_vertices) + ".\n(Vertices and faces are counted from 0.)",
                    {},
                    {},
                    k / 3});
    triangles[k / 3][(k + 1) % 3] = static_cast<std::uint32_t>(indices[k]);
  }

  Mesh mesh;
  if(n_vertices < max_size && n_faces < max_size / 3)
  {
    const std::vector<SP::internal::Linked_triangle> linked = SP::internal::link_triangles(triangles, n_vertices);
    if(!linked.empty() && have_three_neighbors(linked))
    {
      SP::internal::add_triangles(linked, n_vertices, mesh,
                                  [&](const auto&, const auto&) { set_points(points, mesh); });
      return mesh;
    }
  }
  if(auto defect = SP::internal::find_defect_of_soup(n_vertices, triangles))
    refuse(name, std::move(*defect));
  for(std::size_t v = 0; v < n_vertices; ++v)
    mesh.add_vertex();
  std::vector<std::array<Vertex_index, 3>> corners;
  for(const auto& [u, v, w] : triangles)
    corners.push_back({Vertex_index(u), Vertex_index(v), Vertex_index(w)});
  CGAL::Euler::add_faces(corners, mesh);
  set_points(points, mesh);
  return mesh;
}

void check_surface(const std::string& name, const Mesh& mesh)
{
  if(auto defect = SP::internal::find_defect_of_mesh(mesh))
    refuse(name, std::move(*defect));
}

void check_points(const std::string& name, const Mesh& mesh, const std::string& name_of_points, const Points& points)
{
  for(const Vertex_index v : mesh.vertices())
  {
    const Point_3 p = get(rows_of(points), v);
    if(!mesh.is_isolated(v) && !(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())))
      refuse(name, {SP::ERROR_NON_FINITE_COORDINATE,
                    name_of_points + ": vertex " + std::to_string(v) +
                        " has a coordinate that is infinite or not a number.\n(Vertices are counted from 0.)",
                    v,
                    {},
                    {}});
  }
}

void check_map(const std::string& name, const Mesh& mesh, const std::string& name_of_map, const Points& sphere)
{
  check_surface(name, mesh);
  const Const_row_map map = rows_of(sphere);
  // In this thread alone, as the caller may have allowed for no more.
  if(SP::is_bijective<CGAL::Sequential_tag>(mesh, map))
    return;
  check_points(name, mesh, name_of_map, sphere);
  std::vector<SP::Face_distortion> distortions(mesh.number_of_faces());
  const auto distortion_map =
      boost::make_iterator_property_map(distortions.begin(), boost::typed_identity_property_map<std::size_t>());
  SP::Distortion_summary distortion;
  if(const auto error = SP::measure_distortion<CGAL::Sequential_tag>(mesh, map, distortion, distortion_map);
     error != SP::OK)
    fail(error, SP::get_error_message(error));
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
                    " is not positively oriented as seen from the origin (" +
                    std::to_string(distortion.number_of_inverted_faces) +
                    " such faces in total).\n(Faces are counted from 0.)",
                {},
                {},
                f});
}

} // namespace Module
