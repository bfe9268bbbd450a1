#include "Input_mesh.h"

#include "write_mesh.h"

#include <CGAL/Spherical_parameterization/Repair/fill_holes.h>
#include <CGAL/Spherical_parameterization/internal/files/build_mesh.h>

#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/container/small_vector.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Program {

namespace {

void set_points(Mesh& mesh, const std::vector<Point_3>& points)
{
  for(const Vertex_index v : mesh.vertices())
    mesh.point(v) = points[v];
}

bool is_finite(const Point_3& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

// Returns whether both polygons are the same triangle, from any of its corners on.
bool is_same(Polygon polygon, const Polygon& triangle)
{
  for(std::size_t k = 0; k < 3 && polygon != triangle; ++k)
    std::rotate(polygon.begin(), polygon.begin() + (polygon.empty() ? 0 : 1), polygon.end());
  return polygon == triangle;
}

} // namespace

SP::Distortion_summary measured_distortion(const Mesh& mesh, const Sphere_map& map, Distortion_map distortions)
{
  SP::Distortion_summary summary;
  const SP::Error_code error = SP::measure_distortion(mesh, map, summary, distortions);
  if(error != SP::OK)
    throw Program_error(SP::get_error_message(error));
  return summary;
}

std::vector<std::vector<Polygon>> parts_of(std::vector<Polygon> polygons)
{
  std::vector<std::pair<std::uint64_t, std::size_t>> sides; // both vertices of an edge, and a face
  for(std::size_t f = 0; f < polygons.size(); ++f)
    SP::internal::for_each_side(polygons[f], [&](std::size_t from, std::size_t to) {
      const auto [v, w] = std::minmax(from, to);
      sides.emplace_back(std::uint64_t(v) << 32 | w, f);
    });
  std::sort(sides.begin(), sides.end());
  boost::disjoint_sets_with_storage<> sets(polygons.size());
  for(std::size_t k = 1; k < sides.size(); ++k)
    if(sides[k].first == sides[k - 1].first)
      sets.union_set(sides[k].second, sides[k - 1].second);
  std::vector<std::vector<Polygon>> parts;
  std::vector<std::size_t> part_of(polygons.size(), polygons.size()); // by the face that stands for it
  for(std::size_t f = 0; f < polygons.size(); ++f)
  {
    std::size_t& part = part_of[sets.find_set(f)];
    if(part == polygons.size())
    {
      part = parts.size();
      parts.emplace_back();
    }
    parts[part].push_back(std::move(polygons[f]));
  }
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return parts;
}

File_content part_of(const File_content& whole, std::vector<Polygon> polygons)
{
  std::vector<std::size_t> vertices;
  for(const Polygon& polygon : polygons)
    vertices.insert(vertices.end(), polygon.begin(), polygon.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for(Polygon& polygon : polygons)
    for(auto& v : polygon)
      v = static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  File_content part;
  for(const std::size_t v : vertices)
    part.points.push_back(whole.points[v]);
  part.polygons = std::move(polygons);
  part.origin = whole.origin;
  part.hemispheres = whole.hemispheres;
  return part;
}

Input_mesh::Input_mesh(const std::string& path, File_content soup)
  : m_name(printable(path))
  , m_is_of_cortical_format(!is_among(file_format(path), input_formats))
  , m_origin(std::move(soup.origin))
  , m_hemispheres(std::move(soup.hemispheres))
  , m_polygons(std::move(soup.polygons))
{
  if(m_polygons.empty())
    throw Program_error(m_name, ": the mesh has no faces.\nPerhaps the file is truncated, or a point cloud, which has "
                                "to be turned into a surface first.");
  if(const auto defect = SP::internal::build_mesh(m_polygons, soup.points.size(), m_mesh))
    throw Program_error(m_name, ": ", defect->message);
  set_points(m_mesh, soup.points);
}

std::string Input_mesh::find_defect(bool advises) const
{
  const auto defect = SP::internal::find_defect_of_mesh(m_mesh);
  if(!defect)
    return "";
  const char* const cure = defect->error == SP::ERROR_NON_CLOSED_MESH ? "\n--fill-holes all fills them."
                           : defect->error == SP::ERROR_SEVERAL_COMPONENTS
                               ? "\nOf SURFACE, --components largest maps the largest one, --components each all of "
                                 "them; of another file, the command repair writes the largest one."
                               : "";
  return m_name + ": " + defect->message + cure +
         (defect->error == SP::ERROR_NO_TOPOLOGICAL_SPHERE ? describe_handles(advises) : "");
}

void Input_mesh::check() const
{
  if(const std::string defect = find_defect(); !defect.empty())
    throw Program_error(defect);
}

std::vector<Input_mesh::Handle> Input_mesh::find_handles(std::size_t max_handles) const
{
  std::vector<Handle> handles;
  if(SP::find_handles(m_mesh, handles, CGAL::parameters::maximum_number(max_handles)) != SP::OK)
    handles.clear();
  return handles;
}

std::string Input_mesh::describe(const Handle& handle)
{
  return joined(handle.path.size(), " edges around a handle, of length ", handle.length, ", at vertex ",
                handle.path.front().idx());
}

void Input_mesh::write_handles(std::ostream& out, const std::vector<Handle>& handles) const
{
  std::size_t n = 0;
  for(const Handle& handle : handles)
    n += handle.path.size();
  out << "ply\nformat ascii 1.0\nelement vertex " << n
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty int vertex\nelement edge " << n
      << "\nproperty int vertex1\nproperty int vertex2\nproperty int handle\nend_header\n";
  out.precision(17);
  for(const Handle& handle : handles)
    for(const Vertex_index v : handle.path)
      out << m_mesh.point(v) << ' ' << v.idx() << '\n';
  std::size_t first = 0;
  for(std::size_t k = 0; k < handles.size(); ++k)
  {
    const std::size_t size = handles[k].path.size();
    for(std::size_t i = 0; i < size; ++i)
      out << first + i << ' ' << first + (i + 1) % size << ' ' << k << '\n';
    first += size;
  }
}

std::vector<Input_mesh::Hole> Input_mesh::fill_holes(std::size_t max_edges)
{
  m_unfilled = m_mesh;
  std::vector<SP::Filled_hole<Mesh>> holes;
  const SP::Error_code error = SP::fill_holes(m_mesh, holes, CGAL::parameters::maximum_number(max_edges));
  if(error == SP::ERROR_NO_SIMPLICIAL_COMPLEX)
    throw Program_error(
        m_name, ": the border touches itself in vertex ", holes.back().vertex.idx(),
        ", so that it is not clear what its holes are.\nSplit the vertex, for example with "
        "CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices(). (Vertices are counted from 0.)");
  if(error == SP::ERROR_NON_FINITE_COORDINATE)
  {
    const auto is_wrong = [&](Vertex_index v) { return !m_mesh.is_isolated(v) && !is_finite(m_mesh.point(v)); };
    const Vertex_index v = *std::find_if(m_mesh.vertices().begin(), m_mesh.vertices().end(), is_wrong);
    throw Program_error(m_name, ": vertex ", v.idx(),
                        " has a coordinate that is infinite or not a number. (Vertices are counted from 0.)");
  }
  std::vector<Hole> result;
  for(const SP::Filled_hole<Mesh>& hole : holes)
    result.push_back({hole.vertex, hole.number_of_edges, hole.faces.size(), hole.perimeter, hole.share});
  return result;
}

void Input_mesh::take_triangles_of_mesh()
{
  m_polygons.resize(m_mesh.number_of_faces());
  for(const Mesh::Face_index f : m_mesh.faces())
  {
    Polygon corners;
    for(const Vertex_index v : CGAL::vertices_around_face(m_mesh.halfedge(f), m_mesh))
      corners.push_back(v);
    if(!is_same(corners, m_polygons[f]))
      m_polygons[f] = corners;
  }
}

std::vector<Point_3> Input_mesh::points_of(const Sphere_map& map)
{
  const auto n = static_cast<std::ptrdiff_t>(mesh_of_file().number_of_vertices());
  return std::vector<Point_3>(map.begin(), map.begin() + n);
}

void Input_mesh::write_filled(std::ostream& out, const std::string& format) const
{
  std::vector<Polygon> triangles = m_polygons;
  for(const Mesh::Face_index f : m_mesh.faces())
    if(is_filler(f))
    {
      triangles.emplace_back();
      for(const Vertex_index v : CGAL::vertices_around_face(m_mesh.halfedge(f), m_mesh))
        triangles.back().push_back(v);
    }
  if(format != ".ply")
  {
    write_mesh(out, format, {m_mesh.points().begin(), m_mesh.points().end()}, triangles, inherited(m_origin, false));
    return;
  }
  Mesh filled;
  SP::internal::build_mesh(triangles, m_mesh.number_of_vertices(), filled);
  set_points(filled, {m_mesh.points().begin(), m_mesh.points().end()});
  const auto label = filled.add_property_map<Mesh::Face_index, std::uint8_t>("f:filler", 1).first;
  for(const Mesh::Face_index f : filled.faces())
    label[f] = is_filler(f) ? 1 : 0;
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, filled, CGAL::parameters::stream_precision(17));
}

Sphere_map Input_mesh::read_images(const std::string& path)
{
  check();
  const File_content soup = read_file_content(path);
  check_faces_of(path, "is no map of this mesh", soup.points.size(), soup.polygons);
  const Sphere_map map = m_mesh.add_property_map<Vertex_index, Point_3>("v:initial").first;
  for(const Vertex_index v : m_mesh.vertices())
  {
    map[v] = soup.points[v];
    if(!m_mesh.is_isolated(v) && !is_finite(map[v]))
      throw error_in(path, "is no map: vertex ", v.idx(),
                     " has a coordinate that is infinite or not a number. (Vertices are counted from 0.)");
  }
  return map;
}

Sphere_map Input_mesh::read_map(const std::string& path)
{
  const Sphere_map map = read_images(path);
  const Distortion_map distortions = m_mesh.add_property_map<Mesh::Face_index, SP::Face_distortion>("f:initial").first;
  const std::size_t n_inverted = measured_distortion(m_mesh, map, distortions).number_of_inverted_faces;
  for(const Mesh::Face_index f : m_mesh.faces())
    if(distortions[f].is_inverted)
      throw error_in(path, "is no one-to-one map: face ", f.idx(),
                     " is not positively oriented as seen from the origin (", n_inverted,
                     " such faces in total).\nTake another start, such as --initial harmonic. (Faces are counted "
                     "from 0.)");
  return map;
}

void Input_mesh::check_faces_of(const std::string& path, const std::string& is, std::size_t n_vertices,
                                const std::vector<Polygon>& polygons) const
{
  const auto compare = [&](const std::string& what, std::size_t count, std::size_t expected) {
    if(count != expected)
      throw error_in(path, is, ": it has ", count, " ", what, ", the mesh has ", expected);
  };
  compare("vertices", n_vertices, (m_unfilled ? *m_unfilled : m_mesh).number_of_vertices());
  compare("faces", polygons.size(), m_polygons.size());
  for(std::size_t f = 0; f < m_polygons.size(); ++f)
    if(!is_same(polygons[f], m_polygons[f]))
      throw error_in(path, is, ": face ", f, " has other corners, or another orientation. (Faces are counted from 0.)");
}

std::string Input_mesh::describe_handles(bool advises) const
{
  constexpr std::size_t max_named = 5; // each takes time
  std::string text;
  for(const Handle& handle : find_handles(max_named))
    text += "\nA path of " + describe(handle) + '.';
  if(advises)
    text +=
        "\nrepair SURFACE --handles FILE writes such a path for each, show SURFACE -o PAGE.html shows where they are.";
  return text + " (Vertices are counted from 0.)";
}

} // namespace Program
