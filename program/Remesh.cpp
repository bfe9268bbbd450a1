#include "Remesh.h"

#include "add_values.h"
#include "read_file.h"
#include "write_mesh.h"

#ifdef PROGRAM_WRITES_EXR
#include <CGAL/Spherical_parameterization/Sampling/EXR_geometry_image.h>
#endif
#ifdef PROGRAM_WRITES_PNG
#include <CGAL/Spherical_parameterization/Sampling/PNG_geometry_image.h>
#endif

#include <CGAL/IO/PLY.h>
#include <CGAL/IO/io.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sampling/measure_distance.h>
#include <CGAL/Spherical_parameterization/Sampling/remesh_through_sphere.h>
#include <CGAL/Spherical_parameterization/Sampling/transfer.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <variant>

namespace Program {

namespace {

// Returns the domain of this name.
SP::Sphere_domain_3 find_domain(const std::string& solid_or_file, unsigned int n)
{
  if(solid_or_file == "octahedron")
    return SP::Sphere_domain_3::octahedron(n);
  if(solid_or_file == "cube")
    return SP::Sphere_domain_3::cube(n);
  if(solid_or_file == "icosahedron")
    return SP::Sphere_domain_3::icosahedron(n);
  Input_mesh mesh(solid_or_file, read_file_content(solid_or_file));
  SP::Sphere_domain_3 domain;
  const SP::Error_code error = SP::make_sphere_domain(mesh.mesh(), mesh.mesh().points(), domain);
  if(error == SP::ERROR_NO_1_TO_1_MAPPING)
    throw error_in(solid_or_file, "is no mesh of the sphere to sample by: not all of its faces are positively "
                                  "oriented as seen from the origin, or they do not cover the sphere once");
  if(error != SP::OK)
    throw Program_error(mesh.find_defect());
  return domain;
}

template <class Map>
SP::Error_code write_image_of([[maybe_unused]] std::ostream& out, const std::string& format,
                              [[maybe_unused]] const Mesh& mesh, [[maybe_unused]] const Map& map)
{
#ifdef PROGRAM_WRITES_EXR
  if(format == ".exr")
    return SP::IO::write_EXR_geometry_image(out, mesh, map);
#endif
#ifdef PROGRAM_WRITES_PNG
  if(format == ".png")
    return SP::IO::write_PNG_geometry_image(out, mesh, map);
#endif
  throw Program_error("this program was built without the library that writes " + format + " files");
}

} // namespace

Remesh::Remesh(Input_mesh& input, const Sphere_map& sphere, const std::string& domain, unsigned int n)
  : m_origin(inherited(input.origin(), false))
  , m_images(m_mesh.add_property_map<Vertex_index, Point_3>("images of vertices").first) // no name in a PLY file
  , m_normals(m_mesh.add_property_map<Vertex_index, Kernel::Vector_3>("v:normal").first)
{
  const SP::Error_code error =
      SP::remesh_through_sphere(input.mesh(), sphere, find_domain(domain, n), m_mesh, m_images,
                                CGAL::parameters::default_values(), CGAL::parameters::vertex_normal_map(m_normals));
  if(error != SP::OK)
    throw Program_error(input.name() + ": " + SP::get_error_message(error));
}

Run_report::Remesh_figures Remesh::figures(Input_mesh& input) const
{
  SP::Surface_distance distance;
  if(const SP::Error_code error = SP::measure_distance(input.mesh(), m_mesh, distance); error != SP::OK)
    throw error_in(input.name(), SP::get_error_message(error));
  const auto& [from, to] = std::pair(distance.from_first, distance.from_second);
  return {m_mesh.number_of_vertices(),
          m_mesh.number_of_faces(),
          {from.root_mean_square, to.root_mean_square},
          {from.maximum, to.maximum},
          distance.diagonal,
          distance.psnr(),
          m_warnings};
}

void Remesh::write(std::ostream& out, const std::string& format) const
{
  if(format == ".ply")
  {
    CGAL::IO::set_binary_mode(out);
    CGAL::IO::write_PLY(out, m_mesh, CGAL::parameters::stream_precision(17));
    return;
  }
  std::vector<Polygon> triangles;
  triangles.reserve(m_mesh.number_of_faces());
  for(const Mesh::Face_index f : m_mesh.faces())
  {
    const Mesh::Halfedge_index h = m_mesh.halfedge(f);
    triangles.emplace_back();
    for(const Vertex_index v : {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))})
      triangles.back().push_back(v);
  }
  write_mesh(out, format, std::vector<Point_3>(m_mesh.points().begin(), m_mesh.points().end()), triangles, m_origin);
}

void Remesh::write_values(std::ostream& out, const std::string& format)
{
  SP::IO::Surface_file file;
  file.labels = m_labels;
  for(const auto& pair : m_origin.metadata_of_points)
    if(pair.first == "AnatomicalStructurePrimary")
      file.origin.metadata.push_back(pair);
  for(const Values& values : m_values)
  {
    SP::IO::Vertex_values& column = file.columns.emplace_back();
    column.name = values.name;
    const bool is_label = !m_labels.empty() && std::holds_alternative<std::int32_t>(values.type);
    column.intent = is_label ? "NIFTI_INTENT_LABEL" : "NIFTI_INTENT_SHAPE";
    if(is_label)
      column.type = SP::IO::Vertex_values::Type::int32;
    std::visit(
        [&](auto number) {
          const auto map = m_mesh.add_property_map<Vertex_index, decltype(number)>("v:" + values.name).first;
          for(const Vertex_index v : m_mesh.vertices())
            column.values.push_back(static_cast<double>(map[v]));
        },
        values.type);
  }
  write_surface_file(out, format, file);
}

void Remesh::write_image(std::ostream& out, const std::string& name, bool shows_normals) const
{
  const std::string format = file_format(name);
  const SP::Error_code error = shows_normals ? write_image_of(out, format, m_mesh, m_normals)
                                             : write_image_of(out, format, m_mesh, m_mesh.points());
  if(error != SP::OK)
    throw error_in(name, SP::get_error_message(error));
}

void Remesh::carry_values(const Options& options, Input_mesh& input, const Sphere_map& sphere)
{
  const std::string& name = options.values_file;
  const bool is_of_input = options.values_sphere.empty();
  File_content soup = read_values(name);
  add_surface(soup, options, input);
  Hemispheres files = input.hemispheres();
  files.insert(files.end(), soup.hemispheres.begin(), soup.hemispheres.end());
  m_warnings += mixed_hemispheres(files);
  const std::vector<Values> of_vertices = std::move(soup.values_of_vertices),
                            of_faces = std::move(soup.values_of_faces);
  Words left_out = std::move(soup.left_out);
  if(!options.file_names.values.empty())
    m_labels = std::move(soup.labels);
  else if(!soup.labels.empty())
    left_out.push_back("the names and colours of its labels, which a GIFTI file can hold");
  Input_mesh values(name, std::move(soup));
  if(is_of_input)
    input.check_faces_of(name, "has no values for this mesh", values.mesh().number_of_vertices(), values.triangles());
  for(const std::string& property : add_values_of_vertices(values.mesh(), of_vertices))
    left_out.push_back("the property '" + printable(property) + "' of the vertices, whose name is taken");
  for(const std::string& property : add_values_of_faces(values.mesh(), of_faces))
    left_out.push_back("the property '" + printable(property) + "' of the faces, whose name is taken");
  const auto is_number = [](const Values& all) {
    return !is_among(all.name, {"red", "green", "blue", "alpha", "nx", "ny", "nz"});
  };
  std::copy_if(of_vertices.begin(), of_vertices.end(), std::back_inserter(m_values), is_number);
  for(const std::string& what : left_out)
    m_warnings += printable(name) + ": not carried over: " + what + '\n';

  const Sphere_map values_sphere = is_of_input ? sphere : values.read_map(options.values_sphere);
  const SP::Error_code error = SP::transfer(values.mesh(), values_sphere, m_mesh, m_images);
  if(error != SP::OK)
    throw error_in(name, SP::get_error_message(error));
}

void Remesh::mark_filler(Input_mesh& input, const Sphere_map& sphere)
{
  const auto of_input = input.mesh().add_property_map<Mesh::Face_index, std::uint8_t>("f:filler", 0).first,
             of_remesh = m_mesh.add_property_map<Mesh::Face_index, std::uint8_t>("f:filler", 0).first;
  for(const Mesh::Face_index f : input.mesh().faces())
    of_input[f] = input.is_filler(f) ? 1 : 0;
  const SP::Error_code error = SP::transfer(input.mesh(), sphere, m_mesh, m_images, std::pair(of_input, of_remesh));
  if(error != SP::OK)
    throw Program_error(input.name() + ": " + SP::get_error_message(error));
}

void Remesh::add_surface(File_content& values, const Options& options, Input_mesh& input)
{
  if(!values.points.empty())
    return;
  File_content surface;
  if(!options.values_sphere.empty())
    surface = read_file_content(options.values_sphere);
  else
  {
    surface.points = input.points_of(input.mesh_of_file().points());
    surface.polygons = input.triangles();
  }
  if(values.number_of_vertices() != surface.points.size())
    throw error_in(options.values_file,
                   "has values of " + std::to_string(values.number_of_vertices()) + " vertices, but " +
                       (options.values_sphere.empty() ? input.name() : printable(options.values_sphere)) + " has " +
                       std::to_string(surface.points.size()));
  values.hemispheres.insert(values.hemispheres.end(), surface.hemispheres.begin(), surface.hemispheres.end());
  values.points = std::move(surface.points);
  values.polygons = std::move(surface.polygons);
}
} // namespace Program
