#include "Surface_match.h"

#include "Progress_visitor.h"
#include "write_mesh.h"

#include <CGAL/Spherical_parameterization/Sphere_locator_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_refinement_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/map_surface.h>
#include <CGAL/Spherical_parameterization/Surface_maps/measure_distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Program {

using Mapper = SP::Surface_mapper_3<Mesh>;
using Refinement = SP::Surface_refinement_3<Mesh>;

namespace {

using SP::internal::Vector_3d;
using SP::internal::operator*;
using SP::internal::operator+;
using SP::internal::operator-; // of vectors

// The points of one surface as origin + unit * points, where the points have the mean 0 and the mean square 1.
struct Normalized_points
{
  Vector_3d origin;
  double unit;
  std::vector<Vector_3d> points;

  // Moves the origin and multiplies the unit; points remain where they are.
  void change_frame(const Vector_3d& by, double factor)
  {
    factor = factor > 0. ? factor : 1.;
    origin = origin + unit * by;
    unit *= factor;
    for(Vector_3d& p : points)
      for(std::size_t i = 0; i < 3; ++i)
        p[i] = (p[i] - by[i]) / factor;
  }
};

// Returns the points of the second surface, aligned to the first one: with the same mean, the same mean square distance from it, and the
// rotation that minimizes the squared distances of corresponding points, weighted by the mean of the fractions of both areas.
// The least-squares scale would shrink a surface that is not similar to the first one.
std::vector<Point_3> aligned_points_of_second(const Overlay& overlay)
{
  const std::size_t n = overlay.points.size();
  std::vector<double> weights(n, 0.);
  std::array<Normalized_points, 2> sides;
  for(std::size_t k = 0; k < 2; ++k)
  {
    CGAL::Bbox_3 box; // of vertices with faces; squared coordinates may overflow
    for(const auto& triangle : overlay.triangles)
      for(const std::uint32_t v : triangle)
        box += overlay.points[v][k].bbox();
    sides[k] = {{0., 0., 0.}, 1., {}};
    for(const auto& pair : overlay.points)
      sides[k].points.push_back({pair[k].x(), pair[k].y(), pair[k].z()});
    const auto half = [&](int i, int sign) { return 0.5 * (box.max)(i) + sign * 0.5 * (box.min)(i); };
    sides[k].change_frame({half(0, 1), half(1, 1), half(2, 1)}, (std::max)({half(0, -1), half(1, -1), half(2, -1)}));
    std::vector<double> areas;
    double total = 0.;
    for(const auto& [a, b, c] : overlay.triangles)
    {
      const std::vector<Vector_3d>& p = sides[k].points;
      areas.push_back(SP::internal::length(SP::internal::cross(p[b] - p[a], p[c] - p[a])));
      total += areas.back();
    }
    for(std::size_t f = 0; f < areas.size(); ++f)
      for(const std::uint32_t v : overlay.triangles[f])
        weights[v] += total > 0. ? areas[f] / (6. * total) : 0.;
  }
  for(Normalized_points& side : sides)
  {
    Vector_3d mean = {0., 0., 0.};
    for(std::size_t v = 0; v < n; ++v)
      mean = mean + weights[v] * side.points[v];
    side.change_frame(mean, 1.);
    double square = 0.;
    for(std::size_t v = 0; v < n; ++v)
      square += weights[v] * SP::internal::squared_length(side.points[v]);
    side.change_frame({0., 0., 0.}, std::sqrt(square));
  }
  std::vector<std::pair<Vector_3d, Vector_3d>> pairs;
  for(std::size_t v = 0; v < n; ++v)
    pairs.emplace_back(static_cast<double>(n) * weights[v] * sides[1].points[v], sides[0].points[v]);
  const std::optional<SP::internal::Rotation_matrix> rotation = SP::internal::fitting_rotation(pairs);
  std::vector<Point_3> result;
  for(const Vector_3d& p : sides[1].points) // without a unique rotation, only position and size are adapted
  {
    const Vector_3d q = rotation ? SP::internal::rotated(*rotation, p) : p;
    const Vector_3d aligned = sides[0].origin + sides[0].unit * q;
    result.emplace_back(aligned[0], aligned[1], aligned[2]);
  }
  return result;
}

} // namespace

Mapped_mesh::Mapped_mesh(const Options& options, const std::string& name)
  : input(name, read_file_content(name), options.is_onto_atlas ? std::nullopt : options.repair)
  , sphere(add_sphere())
{
  if(options.is_onto_atlas)
  {
    take_own_sphere();
    return;
  }
  if(!run_method(options, input, sphere).is_one_to_one)
    throw error_in(name, "the map to the sphere is not bijective.\n--method bld guarantees bijectivity.");
  if(options.follows_convention(options.file_names.sphere)) // before directions on it are computed
    rotate_sphere_to_surface(input, sphere);
}

Mapped_mesh::Mapped_mesh(const Mapped_mesh& other)
  : input(other.input)
  , sphere(add_sphere())
{
  for(const Vertex_index v : input.mesh().vertices())
    sphere[v] = other.sphere[v];
}

// The mesh is a sphere of any radius; it is scaled to the radius 1.
void Mapped_mesh::take_own_sphere()
{
  // Workbench rejects 1.001; surfaces that are not spheres, such as inflated ones, have 2 and more.
  constexpr double max_ratio = 1.01;
  input.check();
  double least = std::numeric_limits<double>::infinity(), largest = 0.;
  for(const Vertex_index v : input.mesh().vertices())
    if(const Point_3& p = input.mesh().point(v); !input.mesh().is_isolated(v))
    {
      const double distance = SP::internal::hypotenuse(p.x(), p.y(), p.z());
      least = (std::min)(least, distance);
      largest = (std::max)(largest, distance);
      input.mesh().point(v) = sphere[v] = Point_3(p.x() / distance, p.y() / distance, p.z() / distance);
    }
  if(largest > max_ratio * least)
    throw error_in(input.name(),
                   "is not a sphere around the origin: the distances of its vertices from the origin range from ",
                   least, " to ", largest);
  radius = 0.5 * (least + largest);
  if(!SP::is_bijective(input.mesh(), sphere))
    throw error_in(input.name(), no_sphere);
}

// Isolated vertices remain at the origin.
Sphere_map Mapped_mesh::add_sphere()
{
  return input.mesh().add_property_map<Vertex_index, Point_3>("v:target", Point_3(0, 0, 0)).first;
}

Surface_match::Surface_match(const Options& options, Input_mesh& first, const Sphere_map& sphere1, Input_mesh& second,
                             const Sphere_map& sphere2, bool needs_overlay)
  : m_copy(options.has("split") ? std::optional<Input_mesh>(first) : std::nullopt)
  , m_input(m_copy ? *m_copy : first)
  , m_first(m_input.mesh())
  , m_second(second.mesh())
  , m_target_origin(second.origin())
  , m_sphere2(sphere2)
  , m_directions(Refinement::directions_of(m_first))
  , m_refinement(std::make_unique<Refinement>())
  , m_hints(read_hints(options, m_input, second))
  , m_is_soft(options.landmark_weight > 0.)
  , m_overlay(std::make_unique<Overlay>())
{
  Mapper mapper = Mapper().landmarks(m_hints.landmarks);
  if(m_is_soft)
    mapper = mapper.landmark_weight(options.landmark_weight);
  if(m_hints.is_cortical)
    mapper = mapper.compare_values().feature_weight(2.);
  else if(!m_hints.features.empty())
    mapper = mapper.compare_values(options.text("compare") == "values");
  std::vector<Mapper::Feature> features;
  std::vector<double> weights;
  for(const auto& [values, weight] : m_hints.features)
  {
    features.emplace_back([this, of = std::cref(values[0])](Vertex_index v) { return m_refinement->value_at(of, v); },
                          [of = std::cref(values[1])](Vertex_index v) { return of.get()[v]; });
    weights.push_back(weight);
  }
  mapper = mapper.features(std::move(features)).feature_weights(std::move(weights));
  const auto counts = [this](std::size_t k) -> std::function<bool(Vertex_index)> {
    if(m_hints.masks[k].empty())
      return {};
    return [this, k](Vertex_index v) { return m_refinement->counts_at(m_hints.masks[k], v); };
  };
  mapper = mapper.masks({counts(0), counts(1)});
  Progress_visitor progress(!options.has("quiet") && !options.is_batch());
  const auto start = std::chrono::steady_clock::now();
  const auto seconds_left = [&] { // until the limit, which applies to all rounds; 0: no limit
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return options.max_seconds > 0. ? (std::max)(options.max_seconds - passed.count(), 1e-9) : 0.;
  };
  const bool spheres = options.text("regularize") == "spheres";
  const auto map = [&](const Mesh& mesh, const Sphere_map& sphere, const Sphere_map& directions, Mapper& by) {
    return SP::map_surface(mesh, sphere, m_second, m_sphere2, by, directions,
                           CGAL::parameters::visitor(std::ref(progress))
                               .maximum_running_time(seconds_left())
                               .vertex_point_map(spheres ? sphere : Sphere_map(mesh.points())),
                           CGAL::parameters::vertex_point_map(spheres ? m_sphere2 : Sphere_map(m_second.points())));
  };
  SP::Surface_map_report& report = figures.report;
  std::optional<SP::Distortion_between>& distortion = figures.distortion;
  SP::Error_code error = map(m_first, sphere1, m_directions, mapper);
  report = mapper.report();
  std::vector<double> errors(m_first.number_of_vertices(), 0.);
  const bool has_errors = mapper.get_expected_errors(CGAL::make_property_map(errors));
  if(error == SP::OK && options.has("split"))
  {
    error =
        m_refinement->refine(m_first, m_directions, m_second, m_sphere2, mapper, m_hints.landmarks, report,
                             [&](const Mesh& mesh, const Sphere_map& on, Mapper& by) { return map(mesh, on, on, by); });
    m_input.take_triangles_of_mesh();
    figures.energy_before = m_refinement->energy_before();
    figures.number_of_new_vertices = m_refinement->number_of_new_vertices();
    figures.parents.assign(m_refinement->parents().begin(), m_refinement->parents().end());
  }
  check(error, first.name());
  if(has_errors)
    for(const Vertex_index v : m_first.vertices())
      m_expected_errors.push_back(m_refinement->value_at(errors, v));
  if(!spheres && !needs_overlay && (report.distortion || report.is_energy_sampled))
    distortion = report.distortion;
  else // A stopped run reports no distortion, and the distortion between spheres is not that between surfaces.
  {
    error = SP::overlay(m_first, m_directions, m_second, m_sphere2, *m_overlay);
    if(error == SP::OK)
      error = SP::measure_distortion_between(*m_overlay, distortion.emplace());
    if(error != SP::ERROR_TOO_LARGE_OVERLAY)
      check(error, first.name());
  }
  add_warnings();
}

Surface_match::~Surface_match() = default;

void Surface_match::add_warnings()
{
  std::ostringstream text;
  text << m_hints.warnings;
  if(figures.report.is_uncertain)
    text << "the alignment of the surfaces is ambiguous: check the map, for example with --page, or give --landmarks\n";
  const std::vector<double>& distances = figures.report.landmark_distances;
  for(std::size_t k = 0; k < distances.size() && !m_is_soft; ++k)
    if(distances[k] > 0.)
      text << "landmark " << k << " (" << m_hints.landmark_names[k] << ") is missed by " << distances[k] << '\n';
  figures.warnings = text.str();
}

void Surface_match::write_positions(std::ostream& out, const std::string& format) const
{
  const SP::Sphere_locator_3 locator(m_second, m_sphere2, true);
  std::vector<Point_3> points(m_first.number_of_vertices(), Point_3(0, 0, 0));
  typename decltype(locator)::Hint hint;
  for(const Vertex_index v : m_first.vertices())
    if(!m_first.is_isolated(v))
    {
      const auto [face, weights] = locator.locate(m_directions[v], hint);
      const Mesh::Halfedge_index h = m_second.halfedge(face);
      const auto corner = [&](Mesh::Halfedge_index to) { return m_second.point(m_second.target(to)); };
      points[v] = CGAL::barycenter(corner(m_second.prev(h)), weights[0], corner(h), weights[1],
                                   corner(m_second.next(h)), weights[2]);
    }
  write_mesh(out, format, points, m_input.triangles(), inherited(m_target_origin, false));
}

void Surface_match::write_expected_errors(std::ostream& out, const std::string& format) const
{
  if(format != ".ply")
  {
    SP::IO::Surface_file file;
    file.columns.push_back(
        {"expected_error", "NIFTI_INTENT_SHAPE", SP::IO::Vertex_values::Type::float32, m_expected_errors, {}});
    write_surface_file(out, format, file, m_first.number_of_faces());
    return;
  }
  Mesh written = m_input.mesh_without_properties();
  const auto errors = written.add_property_map<Vertex_index, float>("v:expected_error", 0.f).first;
  for(const Vertex_index v : written.vertices())
    errors[v] = static_cast<float>(m_expected_errors[v]);
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, written, CGAL::parameters::stream_precision(17));
}

void Surface_match::write_overlay(std::ostream& out) const
{
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << m_overlay->points.size() << '\n';
  for(const char* name : {"x", "y", "z", "x_on_target", "y_on_target", "z_on_target"})
    out << "property double " << name << '\n';
  out << "element face " << m_overlay->triangles.size()
      << "\nproperty list uchar int vertex_indices\nproperty int face\nproperty int face_of_target\nend_header\n";
  SP::internal::Byte_writer bytes(false);
  for(const auto& points : m_overlay->points)
    for(const auto& p : points)
      for(int k = 0; k < 3; ++k)
        bytes.write(double(p[k]));
  for(std::size_t k = 0; k < m_overlay->triangles.size(); ++k)
  {
    bytes.write(char(3));
    for(const std::uint32_t v : m_overlay->triangles[k])
      bytes.write(v);
    const Mesh::Face_index f = m_overlay->faces[k].first;
    bytes.write(static_cast<std::uint32_t>(figures.parents.empty() ? std::size_t(f) : figures.parents[f]));
    bytes.write(static_cast<std::uint32_t>(m_overlay->faces[k].second));
  }
  out << bytes.content;
}

void Surface_match::write_morph(std::ostream& out, const std::string& format, double t) const
{
  const std::vector<Point_3> aligned = aligned_points_of_second(*m_overlay);
  std::vector<Point_3> points;
  for(std::size_t v = 0; v < aligned.size(); ++v)
  {
    const auto& p = m_overlay->points[v][0];
    const Point_3& q = aligned[v];
    points.emplace_back((1. - t) * p.x() + t * q.x(), (1. - t) * p.y() + t * q.y(), (1. - t) * p.z() + t * q.z());
  }
  std::vector<Polygon> triangles;
  for(const auto& corners : m_overlay->triangles)
    triangles.emplace_back(corners.begin(), corners.end());
  write_mesh(out, format, points, triangles, inherited(m_input.origin(), false));
}

} // namespace Program
