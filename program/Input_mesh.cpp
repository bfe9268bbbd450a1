#include "Input_mesh.h"

#include "write_mesh.h"

#include <CGAL/Spherical_parameterization/internal/files/build_mesh.h>

#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/container/small_vector.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
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

// Returns whether two polygons are equal up to a cyclic rotation.
bool is_same(Polygon polygon, const Polygon& other)
{
  for(std::size_t k = 0; k < other.size() && polygon != other; ++k)
    std::rotate(polygon.begin(), polygon.begin() + (polygon.empty() ? 0 : 1), polygon.end());
  return polygon == other;
}

template <class Face_graph>
SP::Distortion_summary distortion_of(const Face_graph& mesh, const Sphere_map& map, Distortion_map distortions)
{
  SP::Distortion_summary summary;
  const SP::Error_code error = SP::measure_distortion(mesh, map, summary, distortions);
  if(error != SP::OK)
    throw Program_error(SP::get_error_message(error));
  return summary;
}

// Replaces functions in the messages of the library by commands.
std::string advice_of_program(std::string message)
{
  for(const auto& [of_library, of_program] :
      {std::pair<std::string, std::string>("\nrepair_surface() ", "\nThe command repair, or --repair, "),
       std::pair<std::string, std::string>("repair_surface() ", "the command repair, or --repair, "),
       std::pair<std::string, std::string>(", and find_handles() finds them", "")})
    if(const std::size_t at = message.find(of_library); at != message.npos)
      message.replace(at, of_library.size(), of_program);
  return message;
}

// Returns numbers of vertices; border vertices at the same point have the same number.
std::vector<std::size_t> joined_borders(const File_content& surface,
                                        const std::vector<std::pair<std::uint64_t, std::size_t>>& sides)
{
  std::vector<std::size_t> number(surface.points.size()), on_border;
  std::iota(number.begin(), number.end(), std::size_t(0));
  for(std::size_t k = 0; k < sides.size(); ++k)
    if((k == 0 || sides[k - 1].first != sides[k].first) &&
       (k + 1 == sides.size() || sides[k + 1].first != sides[k].first))
      for(const std::uint64_t v : {sides[k].first >> 32, sides[k].first & 0xffffffff})
        if(is_finite(surface.points[v]))
          on_border.push_back(v);
  const auto key = [&](std::size_t v) { return std::pair(surface.points[v], v); };
  std::sort(on_border.begin(), on_border.end(), [&](std::size_t v, std::size_t w) { return key(v) < key(w); });
  for(std::size_t k = 1; k < on_border.size(); ++k)
    if(surface.points[on_border[k]] == surface.points[on_border[k - 1]])
      number[on_border[k]] = number[on_border[k - 1]];
  return number;
}

// The sorted sides of all faces: both vertices, by these numbers, and the face.
std::vector<std::pair<std::uint64_t, std::size_t>> sorted_sides(const std::vector<Polygon>& polygons,
                                                                const std::vector<std::size_t>& numbers)
{
  std::vector<std::pair<std::uint64_t, std::size_t>> sides;
  for(std::size_t f = 0; f < polygons.size(); ++f)
    SP::internal::for_each_side(polygons[f], [&](std::size_t from, std::size_t to) {
      const auto [v, w] = std::minmax(numbers.empty() ? from : numbers[from], numbers.empty() ? to : numbers[to]);
      sides.emplace_back(std::uint64_t(v) << 32 | w, f);
    });
  std::sort(sides.begin(), sides.end());
  return sides;
}

} // namespace

SP::Distortion_summary measured_distortion(const Mesh& mesh, const Sphere_map& map, Distortion_map distortions)
{
  return distortion_of(mesh, map, distortions);
}

std::vector<std::vector<std::size_t>> components_of(const File_content& surface, bool joins_borders)
{
  const std::vector<Polygon>& polygons = surface.polygons;
  std::vector<std::pair<std::uint64_t, std::size_t>> sides = sorted_sides(polygons, {});
  if(joins_borders)
    sides = sorted_sides(polygons, joined_borders(surface, sides));
  boost::disjoint_sets_with_storage<> sets(polygons.size());
  for(std::size_t k = 1; k < sides.size(); ++k)
    if(sides[k].first == sides[k - 1].first)
      sets.union_set(sides[k].second, sides[k - 1].second);
  std::vector<std::vector<std::size_t>> components;
  std::vector<std::size_t> component_of(polygons.size(), polygons.size()); // by its representative face
  for(std::size_t f = 0; f < polygons.size(); ++f)
  {
    std::size_t& component = component_of[sets.find_set(f)];
    if(component == polygons.size())
    {
      component = components.size();
      components.emplace_back();
    }
    components[component].push_back(f);
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return components;
}

File_content part_of(const File_content& whole, const std::vector<std::size_t>& faces)
{
  File_content part;
  for(const std::size_t f : faces)
  {
    part.faces.push_back(static_cast<std::uint32_t>(f));
    part.polygons.push_back(whole.polygons[f]);
    part.vertices.insert(part.vertices.end(), whole.polygons[f].begin(), whole.polygons[f].end());
  }
  std::sort(part.vertices.begin(), part.vertices.end());
  part.vertices.erase(std::unique(part.vertices.begin(), part.vertices.end()), part.vertices.end());
  for(Polygon& polygon : part.polygons)
    for(std::size_t& v : polygon)
      v = static_cast<std::size_t>(std::lower_bound(part.vertices.begin(), part.vertices.end(), v) -
                                   part.vertices.begin());
  for(const std::uint32_t v : part.vertices)
    part.points.push_back(whole.points[v]);
  part.origin = whole.origin;
  part.hemispheres = whole.hemispheres;
  return part;
}

Input_mesh::Input_mesh(const std::string& path, File_content surface, const std::optional<Repair_settings>& repair)
  : m_name(printable(path))
  , m_is_of_cortical_format(!is_among(file_format(path), input_formats))
  , m_origin(std::move(surface.origin))
  , m_hemispheres(std::move(surface.hemispheres))
  , m_vertices(surface.vertices.begin(), surface.vertices.end())
  , m_faces(surface.faces.begin(), surface.faces.end())
{
  if(surface.polygons.empty())
    throw Program_error(m_name,
                        ": the mesh has no faces.\nThe file may be truncated, or contain a point cloud, from which "
                        "a surface must be reconstructed first.");
  const auto build = [&] {
    m_mesh = Mesh();
    const auto defect = SP::internal::build_mesh(surface.polygons, surface.points.size(), m_mesh);
    if(!defect)
      set_points(m_mesh, surface.points);
    return defect;
  };
  const auto defect = build();
  if(defect && !repair)
    throw Program_error(m_name, ": ", advice_of_program(defect->message));
  if(repair)
  {
    m_repair.emplace();
    if(defect || repair->alpha > 0. || SP::internal::find_defect_of_mesh(m_mesh))
    {
      m_repair = read_named(path, [&] { return Repair_step(*repair, surface); });
      build();
    }
  }
  m_polygons = std::move(surface.polygons);
}

std::string Input_mesh::find_defect(bool advises) const
{
  const auto defect = SP::internal::find_defect_of_mesh(m_mesh);
  if(!defect)
    return "";
  return m_name + ": " + advice_of_program(defect->message) +
         (defect->error == SP::ERROR_SEVERAL_COMPONENTS      ? "\n--each-component maps each component of SURFACE."
          : defect->error == SP::ERROR_NO_TOPOLOGICAL_SPHERE ? describe_handles(advises)
                                                             : "");
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

void Input_mesh::write_cycles(std::ostream& out, const std::vector<std::vector<std::size_t>>& cycles) const
{
  std::size_t n = 0;
  for(const auto& cycle : cycles)
    n += cycle.size();
  out << "ply\nformat ascii 1.0\nelement vertex " << n
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty int vertex\nelement edge " << n
      << "\nproperty int vertex1\nproperty int vertex2\nproperty int handle\nend_header\n";
  out.precision(17);
  const bool is_changed = m_repair && m_repair->has_changed_surface();
  for(const auto& cycle : cycles)
    for(const std::size_t v : cycle)
      out << (is_changed ? m_repair->file().points[v] : m_mesh.point(Vertex_index(static_cast<Mesh::size_type>(v))))
          << ' ' << (m_vertices.empty() ? v : m_vertices[v]) << '\n';
  std::size_t first = 0;
  for(std::size_t k = 0; k < cycles.size(); ++k)
  {
    const std::size_t size = cycles[k].size();
    for(std::size_t i = 0; i < size; ++i)
      out << first + i << ' ' << first + (i + 1) % size << ' ' << k << '\n';
    first += size;
  }
}

std::size_t Input_mesh::number_of_vertices_of_file() const
{
  return m_repair && m_repair->has_changed_surface() ? m_repair->file().points.size() : m_mesh.number_of_vertices();
}

Vertex_index Input_mesh::vertex_of(std::size_t vertex_of_file) const
{
  const std::size_t v =
      m_repair && m_repair->has_changed_surface() ? m_repair->vertex_of(vertex_of_file) : vertex_of_file;
  return v == Repair_step::none || m_mesh.is_isolated(Vertex_index(static_cast<Mesh::size_type>(v)))
             ? Mesh::null_vertex()
             : Vertex_index(static_cast<Mesh::size_type>(v));
}

File_content Input_mesh::transferred(File_content values) const
{
  if(!m_repair || !m_repair->has_changed_surface())
    return values;
  m_repair->transfer(values, m_polygons);
  if(values.points.size() == m_repair->file().points.size())
  {
    values.points.assign(m_mesh.points().begin(), m_mesh.points().end());
    values.polygons = m_polygons;
  }
  return values;
}

SP::Distortion_summary Input_mesh::measured(const Sphere_map& map, Distortion_map distortions) const
{
  const SP::Distortion_summary of_all = distortion_of(m_mesh, map, distortions);
  if(!has_patches())
    return of_all;
  std::vector<Mesh::Face_index> kept;
  for(const Mesh::Face_index f : m_mesh.faces())
    if(!is_patch(f))
      kept.push_back(f);
  return distortion_of(CGAL::Face_filtered_graph<Mesh>(m_mesh, kept), map, distortions);
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

Mesh Input_mesh::mesh_without_properties() const
{
  Mesh result;
  SP::internal::build_mesh(m_polygons, m_mesh.number_of_vertices(), result);
  set_points(result, {m_mesh.points().begin(), m_mesh.points().end()});
  return result;
}

void Input_mesh::write_repaired(std::ostream& out, const std::string& format) const
{
  const std::vector<Point_3> points(m_mesh.points().begin(), m_mesh.points().end());
  if(format != ".ply")
  {
    write_mesh(out, format, points, m_polygons, inherited(m_origin, false));
    return;
  }
  Mesh written = mesh_without_properties();
  const auto source_vertices = written.add_property_map<Vertex_index, std::int32_t>("v:source_vertex", -1).first;
  const auto source_faces = written.add_property_map<Mesh::Face_index, std::int32_t>("f:source_face", -1).first;
  const auto patch = written.add_property_map<Mesh::Face_index, std::uint8_t>("f:patch", 0).first;
  const bool is_changed = m_repair && m_repair->has_changed_surface();
  const auto source_of = [&](std::size_t i, const std::vector<std::size_t>& sources,
                             const std::vector<std::size_t>& of_part) {
    const std::size_t source = is_changed ? sources[i] : i;
    return (m_repair && m_repair->is_wrapped()) || source == Repair_step::none
               ? -1
               : static_cast<std::int32_t>(of_part.empty() ? source : of_part[source]);
  };
  const std::vector<std::size_t> none;
  for(const Vertex_index v : written.vertices())
    source_vertices[v] = source_of(v, is_changed ? m_repair->source_vertices() : none, m_vertices);
  for(const Mesh::Face_index f : written.faces())
  {
    source_faces[f] = source_of(f, is_changed ? m_repair->source_faces() : none, m_faces);
    patch[f] = is_patch(f) ? 1 : 0;
  }
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, written, CGAL::parameters::stream_precision(17));
}

Sphere_map Input_mesh::read_images(const std::string& path)
{
  check();
  File_content soup = read_file_content(path);
  check_faces_of(path, "is not a map of this mesh", soup.points.size(), soup.polygons);
  if(is_of_file(soup.points.size(), soup.polygons))
    soup.points = m_repair->transferred(soup.points, m_polygons);
  const Sphere_map map = m_mesh.add_property_map<Vertex_index, Point_3>("v:initial").first;
  for(const Vertex_index v : m_mesh.vertices())
  {
    map[v] = soup.points[v];
    if(!m_mesh.is_isolated(v) && !is_finite(map[v]))
      throw error_in(path, "is not a map: vertex ", v.idx(),
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
      throw error_in(path, "is not a bijective map: face ", f.idx(),
                     " is not positively oriented as seen from the origin (", n_inverted,
                     " such faces in total).\nUse another initial map, such as --initial harmonic. (Faces are counted "
                     "from 0.)");
  return map;
}

bool Input_mesh::is_of_file(std::size_t n_vertices, const std::vector<Polygon>& polygons) const
{
  return m_repair && m_repair->has_changed_surface() && n_vertices == m_repair->file().points.size() &&
         !(n_vertices == m_mesh.number_of_vertices() && polygons.size() == m_polygons.size() &&
           std::equal(polygons.begin(), polygons.end(), m_polygons.begin(), is_same));
}

void Input_mesh::check_faces_of(const std::string& path, const std::string& is, std::size_t n_vertices,
                                const std::vector<Polygon>& polygons) const
{
  const bool is_file = is_of_file(n_vertices, polygons);
  const std::vector<Polygon>& expected = is_file ? m_repair->file().polygons : m_polygons;
  const auto compare = [&](const std::string& what, std::size_t count, std::size_t number) {
    if(count != number)
      throw error_in(path, is, ": it has ", count, " ", what, ", the mesh has ", number);
  };
  compare("vertices", n_vertices, is_file ? n_vertices : m_mesh.number_of_vertices());
  compare("faces", polygons.size(), expected.size());
  for(std::size_t f = 0; f < expected.size(); ++f)
    if(!is_same(polygons[f], expected[f]))
      throw error_in(path, is, ": face ", f, " has other corners, or another orientation. (Faces are counted from 0.)");
}

std::string Input_mesh::describe_handles(bool advises) const
{
  constexpr std::size_t max_named = 5; // finding each takes time
  std::string text;
  for(const Handle& handle : find_handles(max_named))
    text += "\nA cycle of " + describe(handle) + '.';
  if(advises)
    text += "\nrepair SURFACE --handles FILE writes such a cycle for each handle, and show SURFACE -o PAGE.html shows "
            "them.";
  return text + " (Vertices are counted from 0.)";
}

} // namespace Program
