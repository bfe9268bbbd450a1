#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_SURFACE_MATCH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_SURFACE_MATCH_H

#include "Input_mesh.h"
#include "Interrupt_guard.h"
#include "Match_refinement.h"
#include "Polygon_soup.h"
#include "Program_error.h"
#include "Program_options.h"
#include "Progress_visitor.h"
#include "mesh_files.h"
#include "read_soup.h"
#include "run_method.h"
#include "surface_hints.h"
#include "write_soup.h"
#include "write_sphere.h"

#include <CGAL/Spherical_parameterization/Sphere_locator_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/map_surface.h>
#include <CGAL/Spherical_parameterization/Surface_maps/measure_distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace Program {

/// A mesh and its map to the sphere, one-to-one.
struct Mapped_mesh
{
  /// reads a mesh and maps it as the options say.
  ///
  /// \throws Program_error if there is no map, or it folds
  Mapped_mesh(const Program_options& options, const std::string& name)
    : input(name, read_soup(name))
    , sphere(add_sphere())
  {
    if(options.is_onto_atlas)
    {
      take_own_sphere();
      return;
    }
    if(!run_method(options, input, sphere).is_one_to_one)
      throw Program_error(name, "the map to the sphere is not one-to-one.\n--method bld excludes that.");
    if(options.follows_convention(options.file_names.sphere)) // Directions on it turn along, as they are found on it.
      turn_to_surface(input, sphere, true);
  }

  /// copies the mesh, so that several threads can use it at once.
  Mapped_mesh(const Mapped_mesh& other)
    : input(other.input)
    , sphere(add_sphere())
  {
    for(const Vertex_index v : input.mesh().vertices())
      sphere[v] = other.sphere[v];
  }
  Mapped_mesh& operator=(const Mapped_mesh&) = delete;

  Input_mesh input;
  Sphere_map sphere;
  double radius = 1.; ///< of an atlas

private:
  // The mesh is a sphere itself, of any radius; it gets the radius 1.
  void take_own_sphere()
  {
    constexpr double max_ratio =
        1.01; // Workbench refuses 1.001, and what is no sphere, such as an inflated surface, has 2 and more.
    if(const std::string defect = input.find_defect(); !defect.empty())
      throw Program_error(defect);
    double least = std::numeric_limits<double>::infinity(), largest = 0.;
    for(const Vertex_index v : input.mesh().vertices())
      if(const Point_3& p = input.mesh().point(v); !input.mesh().is_isolated(v))
      {
        const double distance = std::hypot(p.x(), p.y(), p.z());
        least = (std::min)(least, distance);
        largest = (std::max)(largest, distance);
        input.mesh().point(v) = sphere[v] = Point_3(p.x() / distance, p.y() / distance, p.z() / distance);
      }
    if(largest > max_ratio * least)
    {
      std::ostringstream text;
      text << "is no sphere around the origin: its vertices are from " << least << " to " << largest
           << " away from that";
      throw Program_error(input.name(), text.str());
    }
    radius = 0.5 * (least + largest);
    if(!SP::is_bijective(input.mesh(), sphere))
      throw Program_error(input.name(), no_sphere);
  }

  // A vertex without a face stays at the origin.
  Sphere_map add_sphere()
  {
    return input.mesh().add_property_map<Vertex_index, Point_3>("v:target", Point_3(0, 0, 0)).first;
  }
};

/// The map of one surface onto another one.
class Surface_match
{
public:
  /// finds the map; `needs_overlay` says whether `overlay()` will be asked for.
  ///
  /// \throws Program_error if there is none, or what the options name is not in order
  Surface_match(const Program_options& options, Input_mesh& first, const Sphere_map& sphere1, Input_mesh& second,
                const Sphere_map& sphere2, bool needs_overlay)
    : m_copy(options.splits ? std::optional<Input_mesh>(first) : std::nullopt)
    , m_input(m_copy ? *m_copy : first)
    , m_first(m_input.mesh())
    , m_second(second.mesh())
    , m_target_origin(second.origin())
    , m_sphere2(sphere2)
    , m_n_written(first.mesh_of_file().number_of_vertices())
    , m_triangles(m_input.triangles())
    , m_directions(Match_refinement::directions_of(m_first))
  {
    add(first.hemispheres());
    add(second.hemispheres());
    Mapper mapper;
    std::vector<Mapper::Landmark> landmarks;
    if(!options.landmark_files.empty())
      mapper = mapper.landmarks(landmarks = read_landmarks(options));
    if(options.landmark_weight > 0.)
      mapper = mapper.landmark_weight(options.landmark_weight);
    const bool is_cortex =
        options.convention == "cortex" ||
        (options.convention.empty() && first.is_of_cortical_format() && second.is_of_cortical_format());
    if(!options.feature_files.empty())
      mapper =
          read_features(options.feature_files, options.feature_weights, mapper.compare_values(options.compares_values));
    else if(is_cortex)
      mapper = read_features({features_of_cortex, features_of_cortex}, {},
                             mapper.compare_values().feature_weight(weight_of_cortex));
    mapper = mapper.masks(read_masks(options));
    Progress_visitor progress(!options.is_quiet && !options.is_batch());
    const auto start = std::chrono::steady_clock::now();
    const auto seconds_left = [&] { // of the limit, which is that of all rounds; 0 if there is none
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
      return options.max_seconds > 0. ? (std::max)(options.max_seconds - passed.count(), 1e-9) : 0.;
    };
    const bool spheres = options.regularizes_spheres;
    const auto map = [&](const Mesh& mesh, const Sphere_map& sphere, const Sphere_map& directions, Mapper& by) {
      const SP::Error_code error =
          SP::map_surface(mesh, sphere, m_second, m_sphere2, by, directions,
                          CGAL::parameters::visitor(std::ref(progress))
                              .maximum_running_time(seconds_left())
                              .vertex_point_map(spheres ? sphere : Sphere_map(mesh.points())),
                          CGAL::parameters::vertex_point_map(spheres ? m_sphere2 : Sphere_map(m_second.points())));
      if(error != SP::OK)
        throw Program_error(first.name() + ": " + SP::get_error_message(error));
    };
    map(m_first, sphere1, m_directions, mapper);
    report = mapper.report();
    if(options.splits)
    {
      m_refinement.run(
          m_first, m_directions, m_second, m_sphere2, mapper, landmarks, report,
          [&](const Mesh& mesh, const Sphere_map& directions, Mapper& by) { map(mesh, directions, directions, by); });
      m_input.take_triangles_of_mesh();
      m_n_written = m_first.number_of_vertices();
    }
    if(!spheres && !needs_overlay && (report.distortion || report.is_energy_sampled))
      distortion = report.distortion;
    else // The report of a run that was stopped has none, and that between spheres is not the one between surfaces.
    {
      SP::Error_code error = SP::overlay(m_first, m_directions, m_second, m_sphere2, m_overlay);
      if(error == SP::OK)
        error = SP::measure_distortion_between(m_overlay, distortion.emplace());
      if(error != SP::OK && error != SP::ERROR_TOO_LARGE_OVERLAY)
        throw Program_error(first.name() + ": " + SP::get_error_message(error));
    }
  }

  SP::Surface_map_report report;
  std::optional<SP::Distortion_between> distortion; ///< There is none if the common refinement is too large to be made.

  /// returns how the first surface has been refined.
  const Match_refinement& refinement() const { return m_refinement; }

  const SP::Surface_overlay_3<Mesh, Mesh>& overlay() const { return m_overlay; }

  /// returns what is to be said of files of different hemispheres, of properties that are no features, of a map that may be wrong,
  /// and of landmarks that are missed, a line each, empty if there is none.
  std::string warnings() const
  {
    std::string text = mixed_hemispheres(m_hemispheres) + m_left_out;
    if(report.is_uncertain)
      text +=
          "it is not clear that the surfaces lie well on each other: look at the map, for example with --page, or give "
          "--landmarks\n";
    if(m_is_soft)
      return text;
    for(std::size_t k = 0; k < report.landmark_distances.size(); ++k)
      if(report.landmark_distances[k] > 0.)
      {
        std::ostringstream line;
        line << "landmark " << k << " (" << m_landmark_names[k] << ") is missed by " << report.landmark_distances[k]
             << '\n';
        text += line.str();
      }
    return text;
  }

  /// writes the faces of the first surface, with its vertices where they are on the second one.
  void write_positions(std::ostream& out, const std::string& format) const
  {
    const SP::Sphere_locator_3 locator(m_second, m_sphere2, true);
    std::vector<Point_3> points(m_n_written, Point_3(0, 0, 0));
    typename decltype(locator)::Hint hint;
    for(const Vertex_index v : m_first.vertices())
      if(!m_first.is_isolated(v) && v.idx() < m_n_written)
      {
        const auto [face, weights] = locator.locate(m_directions[v], hint);
        const Mesh::Halfedge_index h = m_second.halfedge(face);
        const std::array<Point_3, 3> corners = {m_second.point(m_second.source(h)), m_second.point(m_second.target(h)),
                                                m_second.point(m_second.target(m_second.next(h)))};
        points[v] = CGAL::barycenter(corners[0], weights[0], corners[1], weights[1], corners[2], weights[2]);
      }
    write_soup(out, format, points, m_triangles, inherited(m_target_origin, false));
  }

  /// writes the faces of the first surface, with the directions of its vertices, to the file `path`; see `write_sphere()`.
  void write_directions(std::ostream& out, const std::string& path, const std::string& format,
                        std::optional<double> radius) const
  {
    write_sphere(out, path, format, m_input, m_directions, radius);
  }

  /// writes the common refinement as a PLY file: with the places on the first surface, and as properties those on the
  /// second one and the numbers of both faces.
  void write_overlay(std::ostream& out) const
  {
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << m_overlay.points.size() << '\n';
    for(const char* name : {"x", "y", "z", "x_on_target", "y_on_target", "z_on_target"})
      out << "property double " << name << '\n';
    out << "element face " << m_overlay.triangles.size()
        << "\nproperty list uchar int vertex_indices\nproperty int face\nproperty int face_of_target\nend_header\n";
    for(const auto& points : m_overlay.points)
      for(const auto& p : points)
        for(int k = 0; k < 3; ++k)
          put(out, p[k]);
    for(std::size_t k = 0; k < m_overlay.triangles.size(); ++k)
    {
      out.put(3);
      for(const std::uint32_t v : m_overlay.triangles[k])
        put(out, v);
      const Mesh::Face_index f = m_overlay.faces[k].first;
      put(out, static_cast<std::uint32_t>(m_refinement.parents().empty() ? f : m_refinement.parents()[f]));
      put(out, static_cast<std::uint32_t>(m_overlay.faces[k].second));
    }
  }

  /// writes the common refinement with vertices on the way from the first surface (0) to the second one (1).
  void write_morph(std::ostream& out, const std::string& format, double t) const
  {
    std::vector<Point_3> points;
    for(const auto& [p, q] : m_overlay.points)
      points.emplace_back((1. - t) * p.x() + t * q.x(), (1. - t) * p.y() + t * q.y(), (1. - t) * p.z() + t * q.z());
    std::vector<Polygon> triangles;
    for(const auto& corners : m_overlay.triangles)
      triangles.emplace_back(corners.begin(), corners.end());
    write_soup(out, format, points, triangles, inherited(m_input.origin(), false));
  }

private:
  using Mapper = SP::Surface_mapper_3<Mesh>;

  void add(const Hemispheres& files) { m_hemispheres.insert(m_hemispheres.end(), files.begin(), files.end()); }

  // the bytes of a number, the lowest one first
  template <class T>
  static void put(std::ostream& out, const T& x)
  {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &x, sizeof(T));
    const std::uint16_t one = 1;
    char first;
    std::memcpy(&first, &one, 1);
    if(first == 0)
      std::reverse(std::begin(bytes), std::end(bytes));
    out.write(bytes, sizeof(T));
  }

  std::vector<Mapper::Landmark> read_landmarks(const Program_options& options)
  {
    const auto read = [](const std::string& name, const Mesh& mesh) {
      return read_named(name, [&] { return parse_landmarks(read_file(name), mesh); });
    };
    const std::vector<Landmark> first = read(options.landmark_files[0], m_first),
                                second = read(options.landmark_files[1], m_second);
    if(first.size() != second.size())
      throw Program_error(options.landmark_files[1], "has " + std::to_string(second.size()) + " landmarks, but " +
                                                         printable(options.landmark_files[0]) + " has " +
                                                         std::to_string(first.size()));
    if(first.empty())
      throw Program_error(options.landmark_files[0], "has no landmark");
    m_is_soft = options.landmark_weight > 0.;
    std::vector<Mapper::Landmark> result;
    for(std::size_t k = 0; k < first.size(); ++k)
    {
      result.emplace_back(first[k].vertex, second[k].vertex);
      m_landmark_names.push_back("vertex " + std::to_string(first[k].vertex) + " in line " +
                                 std::to_string(first[k].line) + " of " + printable(options.landmark_files[0]));
    }
    return result;
  }

  // The filler of holes does not count.
  Mapper::Masks read_masks(const Program_options& options)
  {
    const bool has_filler = m_first.number_of_vertices() > m_n_written;
    if(options.mask_files.empty() && !has_filler)
      return {};
    std::array<std::vector<char>, 2> counts = {std::vector<char>(m_n_written, 1),
                                               std::vector<char>(m_second.number_of_vertices(), 1)};
    for(std::size_t k = 0; k < options.mask_files.size(); ++k)
    {
      const std::string& name = options.mask_files[k];
      const Polygon_soup soup = read_soup(name, true);
      add(soup.hemispheres);
      counts[k] = read_named(name, [&] { return mask_of(soup, counts[k].size()); });
    }
    const auto function = [this](std::vector<char>& values) {
      return [this, values = std::move(values)](Vertex_index v) { return m_refinement.counts_at(values, v); };
    };
    return {function(counts[0]), function(counts[1])};
  }

  // Compared by their values and with this weight, they have areas of the cortex agree best by a probabilistic atlas, on two pairs of
  // human hemispheres: half or double the weight, ranks, or curvature beside them are worse there, as is nothing of it. See the manual.
  static constexpr const char* features_of_cortex = "depth,inflated";
  static constexpr double weight_of_cortex = 2.;

  static void check_feature(const std::string& file, const std::string& name, const std::vector<double>& values)
  {
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    if(*least == *largest)
      throw Program_error(file, "the property " + printable(name) +
                                    " is the same for all vertices, so that it tells no places apart");
  }

  // reads the features of both surfaces, and takes those that these have themselves
  Mapper read_features(const Words& lists, std::map<std::string, double> wanted, const Mapper& mapper)
  {
    const std::string &name1 = lists[0], &name2 = lists[1];
    const auto read_list = [](const std::string& list, const Mesh& mesh, std::size_t n_vertices) {
      Own_features own(mesh, n_vertices);
      return read_values(list, [&](const std::string& name) {
        return is_among(name, own_feature_names) ? own(name) : read_soup(name, true);
      });
    };
    Polygon_soup soup1 = read_list(name1, m_first, m_n_written),
                 soup2 = read_list(name2, m_second, m_second.number_of_vertices());
    add(soup1.hemispheres);
    add(soup2.hemispheres);
    // The names that files of cortical surfaces have often tell the subject.
    const std::size_t n = soup1.values_of_vertices.size();
    if(soup1.points.empty() && soup2.points.empty() && soup2.values_of_vertices.size() != n)
      throw Program_error(name2, "has " + std::to_string(soup2.values_of_vertices.size()) + " of the features, but " +
                                     printable(name1) + " has " + std::to_string(n));
    if(soup1.points.empty() && soup2.points.empty())
      for(std::size_t k = 0; k < n; ++k)
        soup2.values_of_vertices[k].name = soup1.values_of_vertices[k].name;
    const auto take = [](const std::string& name, Polygon_soup& soup, std::size_t n_vertices) {
      return read_named(name, [&] { return features_of(std::move(soup), n_vertices); });
    };
    File_features first = take(name1, soup1, m_n_written), second = take(name2, soup2, m_second.number_of_vertices());
    std::vector<Mapper::Feature> result;
    std::vector<double> weights;
    for(auto& [name, values] : first.values)
      if(const auto other = second.values.find(name); other != second.values.end())
      {
        check_feature(name1, name, values);
        check_feature(name2, name, other->second);
        // what holes have been filled with is masked
        result.emplace_back(
            [this, values = std::move(values)](Vertex_index v) { return m_refinement.value_at(values, v); },
            [values = std::move(other->second)](Vertex_index v) { return values[v]; });
        second.values.erase(other);
        const auto weight = wanted.find(name);
        weights.push_back(weight != wanted.end() ? weight->second : 1.);
        if(weight != wanted.end())
          wanted.erase(weight);
      }
      else
        first.left_out.push_back("the property '" + printable(name) + "' of the vertices, which " + printable(name2) +
                                 " has not");
    for(const auto& property : second.values)
      second.left_out.push_back("the property '" + printable(property.first) + "' of the vertices, which " +
                                printable(name1) + " has not");
    if(result.empty())
      throw Program_error(name2, "has no property of vertices, of type float or double, that has the name of one in " +
                                     printable(name1));
    for(const auto& [name, left_out] : {std::pair(name1, first.left_out), std::pair(name2, second.left_out)})
      for(const std::string& what : left_out)
        m_left_out += printable(name) + ": not compared: " + what + '\n';
    if(!wanted.empty())
      throw Program_error(name1, "has no feature of the name '" + printable(wanted.begin()->first) +
                                     "' of --feature-weights that is compared");
    if(std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0.; }))
      throw Program_error(name1, "has no feature left: all of --feature-weights are 0");
    return mapper.features(std::move(result)).feature_weights(std::move(weights));
  }

  std::optional<Input_mesh> m_copy; // of the first surface, if it is refined
  Input_mesh& m_input;              // the first surface
  Mesh& m_first;
  Mesh& m_second;
  SP::IO::Surface_origin m_target_origin;
  Sphere_map m_sphere2;
  std::size_t m_n_written; // vertices of the first surface, but those that holes have been filled with
  const std::vector<Polygon>& m_triangles;
  Sphere_map m_directions;
  Match_refinement m_refinement;
  SP::Surface_overlay_3<Mesh, Mesh> m_overlay;
  std::vector<std::string> m_landmark_names;
  std::string m_left_out; // of the files of features
  Hemispheres m_hemispheres;
  bool m_is_soft = false;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_SURFACE_MATCH_H
