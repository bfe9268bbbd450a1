#include "write_mesh.h"

#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#include <CGAL/Spherical_parameterization/Cortex/rotate_to_surface.h>
#include <CGAL/Spherical_parameterization/Sampling/compute_texture_coordinates.h>
#include <CGAL/Spherical_parameterization/Sampling/write_OBJ.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>
#ifdef PROGRAM_READS_GIFTI
#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#endif
#ifdef PROGRAM_READS_MGH
#include <CGAL/Spherical_parameterization/Cortex/MGH.h>
#endif

#include <CGAL/IO/GOCAD.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/io.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace Program {

namespace {

// Returns a color for `t` in [0, 1], from dark violet to light yellow, as red, green and blue in [0, 255].
//
// Equal steps of `t` look equal: the lightness increases linearly in Oklab, Ottosson's perceptually uniform space, while the hue changes
// from violet over blue and green to yellow, so that the order is visible in grey and with color blindness.
std::array<int, 3> color_of(double t)
{
  constexpr double first_lightness = 0.3, last_lightness = 0.93;
  constexpr double first_hue = 5.2, last_hue = 1.85;       // in radians
  constexpr double first_chroma = 0.1, last_chroma = 0.16; // the limits of sRGB along this path

  t = (std::min)((std::max)(t, 0.), 1.);
  const double lightness = first_lightness + t * (last_lightness - first_lightness);
  const double hue = first_hue + t * (last_hue - first_hue);
  const double chroma = first_chroma + t * t * t * t * (last_chroma - first_chroma);
  const double a = chroma * SP::internal::cosine(hue), b = chroma * SP::internal::sine(hue);

  // Oklab to linear sRGB
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  const std::array<double, 3> linear = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                                        -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                                        -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  std::array<int, 3> rgb{};
  for(std::size_t i = 0; i < 3; ++i)
  {
    const double x = (std::min)((std::max)(linear[i], 0.), 1.);
    const double root = SP::internal::cube_root(x); // The power is x^(1 / 2.4).
    const double gamma = x <= 0.0031308 ? 12.92 * x : 1.055 * (root * std::sqrt(std::sqrt(root))) - 0.055;
    rgb[i] = static_cast<int>(std::lround(255. * gamma));
  }
  return rgb;
}

// Writes an OFF or OBJ file. Coordinates have the shortest text from which the same number is read again. Numbers are not written by the
// stream, which would take most of the time.
void write_text(std::ostream& out, bool is_off, const std::vector<Point_3>& points,
                const std::vector<Polygon>& polygons)
{
  std::string text;
  const auto add = [&](const char* before, auto number) {
    std::array<char, 32> digits;
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    text += before;
    text.append(static_cast<const char*>(digits.data()), end);
  };
  if(is_off)
  {
    add("OFF\n", points.size());
    add(" ", polygons.size());
    text += " 0\n";
  }
  for(const Point_3& p : points)
  {
    add(is_off ? "" : "v ", p.x());
    add(" ", p.y());
    add(" ", p.z());
    text += '\n';
  }
  for(const Polygon& polygon : polygons)
  {
    if(is_off)
      add("", polygon.size());
    else
      text += 'f';
    for(const std::size_t v : polygon)
      add(" ", is_off ? v : v + 1);
    text += '\n';
  }
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

} // namespace

void write_surface_file(std::ostream& out, const std::string& format, const SP::IO::Surface_file& file,
                        std::size_t n_triangles)
{
  SP::Error_code error = SP::OK;
  std::string message;
  if(format == freesurfer_format)
    error = file.points.empty() ? SP::IO::write_FreeSurfer_curv(out, file.columns.at(0), n_triangles, message)
                                : SP::IO::write_FreeSurfer_surface(out, file, message);
  else if(format == ".annot")
    error = SP::IO::write_FreeSurfer_annotation(out, file, message);
  else if(format == ".mgh" || format == ".mgz")
#ifdef PROGRAM_READS_MGH
    error = SP::IO::write_MGH(out, file, message, format == ".mgz");
#else
    throw Program_error("this program was built without zlib, which MGH files need");
#endif
#ifdef PROGRAM_READS_GIFTI
  else
    error = SP::IO::write_GIFTI(out, file, message, format == ".gii.gz");
#else
  else
    throw Program_error("this program was built without expat and zlib, which GIFTI files need");
#endif
  if(error != SP::OK && error != SP::ERROR_CANNOT_WRITE_FILE) // the stream reports that
    throw Program_error(message);
}

SP::IO::Surface_origin inherited(SP::IO::Surface_origin origin, bool is_sphere)
{
  origin.created_by.clear();
  const auto remove = [](SP::IO::Metadata& metadata, const std::string& name) {
    const auto is_it = [&](const auto& pair) { return pair.first == name; };
    metadata.erase(std::remove_if(metadata.begin(), metadata.end(), is_it), metadata.end());
  };
  const auto set = [&](const std::string& name, const std::string& value) {
    remove(origin.metadata_of_points, name);
    origin.metadata_of_points.emplace_back(name, value);
  };
  for(SP::IO::Metadata* metadata : {&origin.metadata, &origin.metadata_of_points, &origin.metadata_of_triangles})
    remove(*metadata, "UniqueID"); // it identifies the other surface
  set("TopologicalType", "Closed");
  if(is_sphere)
  {
    remove(origin.metadata_of_points, "AnatomicalStructureSecondary"); // the cortical layer
    set("GeometricType", "Spherical");
  }
  return origin;
}

void write_mesh(std::ostream& out, const std::string& format, const std::vector<Point_3>& points,
                const std::vector<Polygon>& polygons, const SP::IO::Surface_origin& origin)
{
  constexpr int digits = 17;
  const auto np = CGAL::parameters::stream_precision(digits);
  out.precision(digits);
  if(format == ".off" || format == ".obj")
    write_text(out, format == ".off", points, polygons);
  else if(format == ".ts")
    CGAL::IO::write_GOCAD(out, points, polygons, np);
  else if(format == ".ply")
  {
    CGAL::IO::set_binary_mode(out);
    CGAL::IO::write_PLY(out, points, polygons, np);
  }
  else
  {
    SP::IO::Surface_file file = surface_file_of(points, polygons);
    file.origin = origin;
    write_surface_file(out, format, file);
  }
}

void rotate_sphere_to_surface(Input_mesh& input, const Sphere_map& sphere)
{
  if(SP::rotate_to_surface(input.mesh(), sphere) == SP::ERROR_INSUFFICIENT_PRECISION)
    throw error_in(input.name(), "the sphere cannot be rotated: rounding would invert its smallest faces.\n"
                                 "--convention none keeps its pose.");
}

std::string write_texture(std::ostream& out, Input_mesh& input, const Sphere_map& sphere)
{
  CGAL::Aff_transformation_3<CGAL::Exact_predicates_inexact_constructions_kernel> rotation(CGAL::IDENTITY);
  // No rotation is determined for a ball, for example.
  [[maybe_unused]] const SP::Error_code ignored = SP::fit_rotation_to_surface(input.mesh(), sphere, rotation);
  const auto axis = [&](int i) { return Point_3(rotation.m(i, 0), rotation.m(i, 1), rotation.m(i, 2)); };
  Mesh textured;
  const auto uv = textured.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const SP::Error_code error = SP::compute_texture_coordinates(input.mesh(), sphere, textured, uv, axis(1), axis(2));
  if(error != SP::ERROR_INVERTED_TEXTURE)
    check(error, input.name());
  check(SP::IO::write_OBJ(out, textured, uv), input.name());
  return error == SP::OK ? "" : printable(input.name()) + ": " + SP::get_error_message(error) + '\n';
}

void write_sphere(std::ostream& out, const std::string& path, const std::string& format, Input_mesh& input,
                  const Sphere_map& map, std::optional<double> radius)
{
  Sphere_map written = map;
  constexpr double least = 1e-30, largest = 1e38; // radii for which even small coordinates have full precision
  double written_radius = 0.;
  if(radius || is_cortical(format))
  {
    Mesh& mesh = input.mesh();
    written = mesh.add_property_map<Vertex_index, Point_3>("v:written", Point_3(0, 0, 0)).first;
    for(const Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v))
      {
        const Point_3& p = map[v];
        const double length = SP::internal::hypotenuse(p.x(), p.y(), p.z()), scale = radius ? *radius / length : 1.;
        written_radius = radius.value_or(length);
        written[v] = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
      }
    const bool is_held =
        is_cortical(format) ? SP::round_to_float(mesh, written, written) == SP::OK : SP::is_bijective(mesh, written);
    if(!is_held && is_cortical(format) && !(written_radius >= least && written_radius <= largest))
      throw error_in(path, "cannot store a sphere of the radius ", written_radius,
                     " in the single precision of this format.\nUse --radius fixed=R with R from ", least, " to ",
                     largest, ", or write a .off or .ply file.");
    if(!is_held && SP::is_bijective(mesh, map))
      throw error_in(path, is_cortical(format)
                               ? "cannot store the map: on the sphere, large parts of the surface are smaller than "
                                 "the resolution of the single precision of this format.\nWrite a .off or .ply file, "
                                 "which have double precision."
                               : "cannot store the map with another radius: rounding would invert its smallest faces.\n"
                                 "--convention none keeps the radius.");
  }
  write_mesh(out, format, {written.begin(), written.end()}, input.triangles(), inherited(input.origin(), true));
}

Colored_distortion::Colored_distortion(std::size_t number_of_vertices, const std::vector<Polygon>& faces,
                                       const std::vector<double>& distortions, double min)
  : values(number_of_vertices, 0.)
  , range{min, 1.01 * min}
{
  std::vector<int> counts(number_of_vertices, 0);
  for(std::size_t f = 0; f < faces.size(); ++f)
    if(std::isfinite(distortions[f]))
      for(const std::size_t v : faces[f])
      {
        values[v] += distortions[f];
        ++counts[v];
      }
  std::vector<double> known;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    if(counts[v] > 0)
    {
      values[v] /= counts[v];
      known.push_back(values[v]);
    }
  if(known.empty())
    return;
  const std::size_t rank = static_cast<std::size_t>(0.99 * static_cast<double>(known.size() - 1));
  std::nth_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(rank), known.end());
  range[1] = (std::max)(range[1], known[rank]);
}

void write_colored_mesh(std::ostream& out, const std::vector<Point_3>& points, const std::vector<Polygon>& faces,
                        const Colored_distortion& distortion)
{
  constexpr int digits_of_points = 17, digits_of_values = 6;
  constexpr std::array<int, 3> grey = {128, 128, 128}; // of vertices without distortion
  const auto [min, max] = distortion.range;
  out << "ply\nformat ascii 1.0\nelement vertex " << points.size()
      << "\nproperty double x\nproperty double y\nproperty double z"
         "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\nelement face "
      << faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    const std::array<int, 3> color =
        distortion.values[v] > 0. ? color_of((distortion.values[v] - min) / (max - min)) : grey;
    out.precision(digits_of_points);
    out << points[v].x() << ' ' << points[v].y() << ' ' << points[v].z() << ' ';
    out.precision(digits_of_values);
    out << color[0] << ' ' << color[1] << ' ' << color[2] << ' ' << distortion.values[v] << '\n';
  }
  for(const Polygon& t : faces)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

} // namespace Program
