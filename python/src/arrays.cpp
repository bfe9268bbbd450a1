#include "arrays.h"

#include <CGAL/Spherical_parameterization/internal/files/build_mesh.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

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
  std::vector<std::array<std::uint32_t, 3>> triangles(n_faces);
  for(std::size_t k = 0; k < 3 * n_faces; ++k)
  {
    if(indices[k] < 0 || static_cast<std::uint64_t>(indices[k]) >= n_vertices)
      refuse(name, {SP::ERROR_WRONG_PARAMETER,
                    "face " + std::to_string(k / 3) + " has the vertex " + std::to_string(indices[k]) +
                        ", but there are " + std::to_string(n_vertices) + ".\n(Vertices and faces are counted from 0.)",
                    {},
                    {},
                    k / 3});
    triangles[k / 3][k % 3] = static_cast<std::uint32_t>(indices[k]);
  }

  Mesh mesh;
  if(auto defect = SP::internal::build_mesh(triangles, n_vertices, mesh))
    refuse(name, std::move(*defect));
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
  // Sequential, because the caller may have allowed a single thread only.
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
                  name_of_map + " is not bijective: the faces cover the sphere more than once.",
                  {},
                  {},
                  {}});
  const auto f = static_cast<std::size_t>(inverted - distortions.begin());
  refuse(name, {SP::ERROR_NO_1_TO_1_MAPPING,
                name_of_map + " is not bijective: face " + std::to_string(f) +
                    " is not positively oriented as seen from the origin (" +
                    std::to_string(distortion.number_of_inverted_faces) +
                    " such faces in total).\n(Faces are counted from 0.)",
                {},
                {},
                f});
}

} // namespace Module
