#include "Remesh.h"

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
#include <variant>

namespace Program {

namespace {

// Returns the domain with this name.
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
    throw error_in(solid_or_file, "is not a mesh of the sphere: not all of its faces are positively oriented as seen "
                                  "from the origin, or they do not cover the sphere exactly once");
  if(error != SP::OK)
    mesh.check();
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
  throw Program_error("this program was built without the library that writes ", format, " files");
}

// Returns 1 to 4 for the bytes red, green, blue and alpha of a color, 0 for other properties.
std::ptrdiff_t channel_of(const Values& values)
{
  const Words channels = {"red", "green", "blue", "alpha"};
  const auto found = std::find(channels.begin(), channels.end(), values.name);
  return found != channels.end() && std::holds_alternative<std::uint8_t>(values.type) ? 1 + (found - channels.begin())
                                                                                      : 0;
}

template <class Index>
void add_values(Mesh& mesh, const std::string& prefix, const std::vector<Values>& all)
{
  for(const Values& values : all)
    std::visit(
        [&](auto number) {
          const auto map = mesh.add_property_map<Index, decltype(number)>(prefix + values.name).first;
          for(std::size_t i = 0; i < values.numbers.size(); ++i)
            map[Index(static_cast<Mesh::size_type>(i))] = static_cast<decltype(number)>(values.numbers[i]);
        },
        values.type);
}

// Adds the surface of values if their file has none.
void add_surface(File_content& values, const Options& options, Input_mesh& input)
{
  if(!values.points.empty())
    return;
  File_content surface;
  if(options.has("values-sphere"))
    surface = read_file_content(options.text("values-sphere"));
  else
  {
    surface.points.assign(input.mesh().points().begin(), input.mesh().points().end());
    surface.polygons = input.triangles();
  }
  if(values.number_of_vertices() != surface.points.size())
    throw error_in(options.text("transfer"), "has values of ", values.number_of_vertices(), " vertices, but ",
                   (!options.has("values-sphere") ? input.name() : printable(options.text("values-sphere"))), " has ",
                   surface.points.size());
  values.hemispheres.insert(values.hemispheres.end(), surface.hemispheres.begin(), surface.hemispheres.end());
  values.points = std::move(surface.points);
  values.polygons = std::move(surface.polygons);
}

} // namespace

Words remove_reserved_names(std::vector<Values>& all, bool are_of_vertices)
{
  const auto number_of = [&](const auto& is_it) { return std::count_if(all.begin(), all.end(), is_it); };
  const auto is_of_normal = [](const Values& values) { return is_among(values.name, {"nx", "ny", "nz"}); };
  const bool has_normals = are_of_vertices && number_of(is_of_normal) == 3;
  const bool has_color = number_of([](const Values& values) { return channel_of(values) % 4 != 0; }) == 3;
  const bool lacks_alpha = has_color && number_of([](const Values& values) { return channel_of(values) == 4; }) == 0;
  Words left_out, taken = are_of_vertices
                              ? Words{"x", "y", "z", "nx", "ny", "nz", "point", "normal", "removed", "connectivity"}
                              : Words{"vertex_indices", "vertex_index", "removed", "connectivity"};
  if(has_color)
    taken.push_back("color");
  if(lacks_alpha)
    taken.push_back("alpha");
  std::vector<Values> kept;
  for(Values& values : all)
    if(!is_among(values.name, taken))
      kept.push_back(std::move(values));
    else if(!has_normals || !is_of_normal(values))
      left_out.push_back(values.name);
  if(lacks_alpha)
    kept.push_back({"alpha", std::uint8_t(), std::vector<double>(kept.front().numbers.size(), 255.)});
  const auto rank = [](const Values& values) { return (channel_of(values) + 4) % 5; }; // colors first
  std::stable_sort(kept.begin(), kept.end(), [&](const Values& a, const Values& b) { return rank(a) < rank(b); });
  all = std::move(kept);
  return left_out;
}

void add_values(Mesh& mesh, const std::vector<Values>& of_vertices, const std::vector<Values>& of_faces)
{
  add_values<Vertex_index>(mesh, "v:", of_vertices);
  add_values<Mesh::Face_index>(mesh, "f:", of_faces);
}

Remesh::Remesh(Input_mesh& input, const Sphere_map& sphere, const std::string& domain, unsigned int n)
  : m_origin(inherited(input.origin(), false))
  , m_images(m_mesh.add_property_map<Vertex_index, Point_3>("images of vertices")
                 .first) // a name that the PLY writer ignores
  , m_normals(m_mesh.add_property_map<Vertex_index, Kernel::Vector_3>("v:normal").first)
{
  check(SP::remesh_through_sphere(input.mesh(), sphere, find_domain(domain, n), m_mesh, m_images,
                                  CGAL::parameters::default_values(), CGAL::parameters::vertex_normal_map(m_normals)),
        input.name());
}

Run_report::Remesh_figures Remesh::figures(Input_mesh& input) const
{
  SP::Surface_distance distance;
  check(SP::measure_distance(input.mesh(), m_mesh, distance), input.name());
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

void Remesh::write_values(std::ostream& out, const std::string& format) const
{
  SP::IO::Surface_file file;
  file.labels = m_labels;
  for(const auto& pair : m_origin.metadata_of_points)
    if(pair.first == "AnatomicalStructurePrimary")
      file.origin.metadata.push_back(pair);
  using Type = SP::IO::Vertex_values::Type;
  for(const Values& values : m_values)
    if(!is_among(values.name, {"nx", "ny", "nz"}))
    {
      const bool is_label = m_label_names.count(values.name) > 0;
      const auto is_kept = [](double x) { return x != x || x == static_cast<double>(static_cast<float>(x)); };
      const bool is_long =
          !values.has_fractions() && !std::all_of(values.numbers.begin(), values.numbers.end(), is_kept);
      file.columns.push_back({values.name,
                              is_label ? "NIFTI_INTENT_LABEL" : "NIFTI_INTENT_SHAPE",
                              is_label || is_long ? Type::int32 : Type::float32,
                              values.numbers,
                              {}});
    }
  write_surface_file(out, format, file);
}

void Remesh::write_image(std::ostream& out, const std::string& name, bool shows_normals) const
{
  const std::string format = file_format(name);
  check(shows_normals ? write_image_of(out, format, m_mesh, m_normals)
                      : write_image_of(out, format, m_mesh, m_mesh.points()),
        name);
}

void Remesh::transfer_values(const Options& options, Input_mesh& input, const Sphere_map& sphere)
{
  const std::string& name = options.text("transfer");
  const bool is_of_input = !options.has("values-sphere");
  File_content soup = read_values(name);
  if(is_of_input)
  {
    if(!soup.points.empty())
      input.check_faces_of(name, "does not match this mesh", soup.points.size(), soup.polygons);
    soup = input.transferred(std::move(soup));
    soup.points.clear(); // which equal those of the input
  }
  add_surface(soup, options, input);
  Hemispheres files = input.hemispheres();
  files.insert(files.end(), soup.hemispheres.begin(), soup.hemispheres.end());
  m_warnings += mixed_hemispheres(files);
  std::vector<Values> of_vertices = std::move(soup.values_of_vertices), of_faces = std::move(soup.values_of_faces);
  Words left_out = std::move(soup.left_out);
  if(!options.file_names.values.empty())
  {
    m_labels = std::move(soup.labels);
    m_label_names = std::move(soup.label_names);
  }
  else if(!soup.labels.empty())
    left_out.push_back("the names and colors of its labels, which need a GIFTI file");
  Input_mesh values(name, std::move(soup));
  for(const std::string& property : remove_reserved_names(of_vertices, true))
    left_out.push_back("the vertex property '" + printable(property) + "', whose name is reserved");
  for(const std::string& property : remove_reserved_names(of_faces, false))
    left_out.push_back("the face property '" + printable(property) + "', whose name is reserved");
  constexpr std::size_t max_properties = 4096 - 6; // that the reader of .ply files accepts besides points and normals
  if(options.file_names.values.empty() && of_vertices.size() > max_properties)
    throw error_in(name, "has ", of_vertices.size(), " values per vertex, but a .ply file can have at most ",
                   max_properties, ".\nWrite a .gii file, whose values go to a separate file.");
  for(const std::string& what : left_out)
    m_warnings += printable(name) + ": not transferred: " + what + '\n';
  transfer(values, is_of_input ? sphere : values.read_map(options.text("values-sphere")), std::move(of_vertices),
           std::move(of_faces));
}

void Remesh::mark_patches(Input_mesh& input, const Sphere_map& sphere)
{
  Values patch = {"patch", std::uint8_t(), {}};
  for(const Mesh::Face_index f : input.mesh().faces())
    patch.numbers.push_back(input.is_patch(f) ? 1. : 0.);
  transfer(input, sphere, {}, {patch});
}

// Two types suffice: doubles are averaged, integers are not.
void Remesh::transfer(Input_mesh& source, const Sphere_map& sphere, std::vector<Values> of_vertices,
                      std::vector<Values> of_faces)
{
  const auto transfer_all = [&](auto& carrier, auto index, std::vector<Values>& all) {
    using Index = decltype(index);
    for(Values& values : all)
    {
      const auto transfer_as = [&](auto number) {
        auto from = source.mesh().add_property_map<Index, decltype(number)>().first,
             to = m_mesh.add_property_map<Index, decltype(number)>().first;
        std::copy(values.numbers.begin(), values.numbers.end(), from.begin());
        carrier.carry(from, to);
        values.numbers.assign(to.begin(), to.end());
        source.mesh().remove_property_map(from);
        m_mesh.remove_property_map(to);
      };
      if(std::holds_alternative<float>(values.type))
        for(double& x : values.numbers)
          x = static_cast<float>(x); // text may have more digits
      if(values.has_fractions() || channel_of(values) > 0)
        transfer_as(double());
      else
        transfer_as(std::int64_t());
      if(channel_of(values) > 0)
        for(double& x : values.numbers)
          x = std::round(x);
    }
  };
  check(SP::internal::transfer_properties<CGAL::Parallel_if_available_tag>(
            source.mesh(), sphere, m_mesh, m_images, CGAL::parameters::default_values(),
            [&](auto& carrier) {
              transfer_all(carrier, Vertex_index(), of_vertices);
              transfer_all(carrier, Mesh::Face_index(), of_faces);
            }),
        source.name());
  add_values(m_mesh, of_vertices, of_faces);
  m_values = std::move(of_vertices);
}

} // namespace Program
