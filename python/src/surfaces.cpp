#include "Interruption.h"
#include "functions.h"
#include "threads.h"

#include <CGAL/Spherical_parameterization/Surface_maps/align_spheres.h>
#include <CGAL/Spherical_parameterization/Surface_maps/map_surface.h>
#include <CGAL/Spherical_parameterization/Surface_maps/measure_distortion_between.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>

#include <CGAL/property_map.h>

#include <functional>
#include <limits>

namespace Module {

namespace {

// Two surfaces with their maps. check() throws their defects.
struct Two_surfaces
{
  Mesh first, second;
  const Points &sphere1, &sphere2;

  Two_surfaces(const Points& vertices1, const Indices& faces1, const Points& first_sphere, const Points& vertices2,
               const Indices& faces2, const Points& second_sphere)
    : first(make_mesh(name1, vertices1, faces1))
    , second(make_mesh(name2, vertices2, faces2))
    , sphere1(first_sphere)
    , sphere2(second_sphere)
  {}

  void check(SP::Error_code error) const
  {
    if(error == SP::OK)
      return;
    check_map(name1, first, "sphere", sphere1);
    check_map(name2, second, "sphere", sphere2);
    fail(error, SP::get_error_message(error));
  }

  static constexpr const char *name1 = "surface1: ", *name2 = "surface2: ";
};

// Checks during a run whether it has to end.
class Surface_visitor : public SP::Default_visitor
{
public:
  explicit Surface_visitor(Interruption& interruption)
    : m_interruption(interruption)
  {}

  void on_level(std::size_t number_of_vertices) { m_number_of_vertices = number_of_vertices; }

  bool go_further(std::size_t, double energy)
  {
    m_interruption.check_now_and_then();
    if(!m_interruption.is_stopped())
      m_interruption.call(m_number_of_vertices, energy);
    return !m_interruption.is_stopped();
  }

private:
  Interruption& m_interruption;
  std::size_t m_number_of_vertices = 0; // of the last level that has been mapped
};

using Feature_functions = SP::Surface_mapper_3<Mesh>::Feature;

// The values of features as functions of vertices.
std::vector<Feature_functions> functions_of(const Features& features)
{
  const auto function = [](const Values& values) { return [data = values.data()](Vertex_index v) { return data[v]; }; };
  std::vector<Feature_functions> result;
  for(const auto& [values1, values2] : features)
    result.emplace_back(function(values1), function(values2));
  return result;
}

std::vector<std::pair<Vertex_index, Vertex_index>> read_landmarks(const Two_surfaces& surfaces,
                                                                  const Indices& landmarks)
{
  std::vector<std::pair<Vertex_index, Vertex_index>> result(number_of_rows(landmarks));
  for(const std::size_t column : {0u, 1u})
  {
    const Mesh& mesh = column == 0 ? surfaces.first : surfaces.second;
    std::vector<std::size_t> rows(mesh.number_of_vertices(), result.size()); // of the landmark at a vertex
    for(std::size_t row = 0; row < result.size(); ++row)
    {
      const std::int64_t v = landmarks.data()[2 * row + column];
      const auto refuse = [&](const std::string& why) {
        SP::internal::Soup_defect defect{SP::ERROR_INVALID_LANDMARK,
                                         "landmarks: row " + std::to_string(row) + " has the vertex " +
                                             std::to_string(v) + (column == 0 ? " of surface1" : " of surface2") + why +
                                             ".\n(Vertices and rows are counted from 0.)",
                                         {},
                                         {},
                                         {}};
        if(v >= 0)
          defect.vertex = static_cast<std::size_t>(v);
        throw Error{defect};
      };
      if(v < 0 || static_cast<std::size_t>(v) >= rows.size())
        refuse(", but there are " + std::to_string(rows.size()));
      const Vertex_index vertex(static_cast<Mesh::size_type>(v));
      if(mesh.is_isolated(vertex))
        refuse(", which has no face");
      if(rows[vertex] != result.size())
        refuse(", as has row " + std::to_string(rows[vertex]));
      rows[vertex] = row;
      (column == 0 ? result[row].first : result[row].second) = vertex;
    }
  }
  return result;
}

using Overlay = SP::Surface_overlay_3<Mesh, Mesh>;

Overlay overlay_of(const Points& vertices1, const Indices& faces1, const Points& sphere1, const Points& vertices2,
                   const Indices& faces2, const Points& sphere2, std::optional<std::size_t> max_vertices,
                   std::size_t threads)
{
  const py::none no_callback;
  const py::gil_scoped_release unlock;
  const Two_surfaces surfaces(vertices1, faces1, sphere1, vertices2, faces2, sphere2);
  Overlay refinement;
  Interruption interruption(no_callback, false);
  Surface_visitor visitor(interruption);
  const auto with_visitor = CGAL::parameters::visitor(std::ref(visitor));
  surfaces.check(run_with_threads(threads, [&] {
    return max_vertices ? SP::overlay(surfaces.first, rows_of(sphere1), surfaces.second, rows_of(sphere2), refinement,
                                      with_visitor.maximum_number(*max_vertices))
                        : SP::overlay(surfaces.first, rows_of(sphere1), surfaces.second, rows_of(sphere2), refinement,
                                      with_visitor);
  }));
  interruption.check();
  return refinement;
}

Values array_of(const std::vector<double>& values)
{
  return Values(static_cast<py::ssize_t>(values.size()), values.data());
}

py::dict to_dict(const SP::Distortion_between& distortion)
{
  using namespace py::literals;
  const auto measure = [](const SP::Distortion_between::Statistics& s) {
    return py::make_tuple(s.maximum, s.average_over_first, s.average_over_second);
  };
  return py::dict("isometric"_a = measure(distortion.isometric), "area"_a = measure(distortion.area),
                  "angle"_a = measure(distortion.angle), "energy"_a = measure(distortion.energy),
                  "number_of_triangles"_a = distortion.number_of_triangles,
                  "number_of_slivers"_a = distortion.number_of_slivers);
}

} // namespace

py::tuple map_surface(const Points& vertices1, const Indices& faces1, const Points& sphere1, const Points& vertices2,
                      const Indices& faces2, const Points& sphere2, const Indices& landmarks,
                      std::optional<double> landmark_weight, const Features& features, double feature_weight,
                      const std::vector<double>& feature_weights, bool compare_values, const Features& masks,
                      std::size_t threads, double time_limit, const py::object& callback, bool returns_on_interrupt)
{
  using namespace py::literals;
  const std::size_t n = number_of_rows(vertices1);
  Points directions = new_points(n);
  double* const rows = directions.mutable_data();
  std::fill_n(rows, 3 * n, std::numeric_limits<double>::quiet_NaN()); // vertices without a face
  SP::Surface_map_report report;
  std::vector<double> errors(n, std::numeric_limits<double>::quiet_NaN());
  bool has_errors = false;
  {
    const py::gil_scoped_release unlock;
    const Two_surfaces surfaces(vertices1, faces1, sphere1, vertices2, faces2, sphere2);
    auto mapper = SP::Surface_mapper_3<Mesh>()
                      .landmarks(read_landmarks(surfaces, landmarks))
                      .features(functions_of(features))
                      .feature_weight(feature_weight)
                      .feature_weights(feature_weights)
                      .compare_values(compare_values);
    for(const Feature_functions& mask : functions_of(masks)) // at most one
      mapper = mapper.masks(mask);
    if(landmark_weight)
      mapper = mapper.landmark_weight(*landmark_weight);
    Interruption interruption(callback, returns_on_interrupt);
    Surface_visitor visitor(interruption);
    surfaces.check(run_with_threads(threads, [&] {
      return SP::map_surface(surfaces.first, rows_of(sphere1), surfaces.second, rows_of(sphere2), mapper,
                             Row_map<double>(rows),
                             CGAL::parameters::visitor(std::ref(visitor)).maximum_running_time(time_limit));
    }));
    report = mapper.report();
    has_errors = mapper.get_expected_errors(CGAL::make_property_map(errors));
    interruption.check(); // handles an interrupt after the last sweep, or if there was no sweep
  }
  return py::make_tuple(
      directions,
      py::dict("energy"_a = report.energy,
               "distortion"_a = report.distortion ? py::object(to_dict(*report.distortion)) : py::none(),
               "is_energy_sampled"_a = report.is_energy_sampled, "agreement"_a = report.agreement,
               "margin"_a = report.margin, "expected_error"_a = report.expected_error,
               "expected_errors"_a = has_errors ? py::object(array_of(errors)) : py::none(),
               "is_uncertain"_a = report.is_uncertain, "landmark_distances"_a = array_of(report.landmark_distances),
               "number_of_missed_landmarks"_a = report.number_of_missed_landmarks,
               "stop_reason"_a = SP::get_stop_message(report.stop_reason),
               "number_of_sweeps"_a = report.number_of_sweeps, "seconds_for_reading"_a = report.seconds_for_reading,
               "seconds_for_alignment"_a = report.seconds_for_alignment,
               "seconds_for_descent"_a = report.seconds_for_descent,
               "seconds_for_overlay"_a = report.seconds_for_overlay));
}

py::tuple align_spheres(const Points& vertices1, const Indices& faces1, const Points& sphere1, const Points& vertices2,
                        const Indices& faces2, const Points& sphere2, const Features& features, std::size_t threads,
                        double time_limit, const py::object& callback, bool returns_on_interrupt)
{
  SP::Sphere_alignment_3 alignment;
  {
    const py::gil_scoped_release unlock;
    const Two_surfaces surfaces(vertices1, faces1, sphere1, vertices2, faces2, sphere2);
    Interruption interruption(callback, returns_on_interrupt);
    Surface_visitor visitor(interruption);
    surfaces.check(run_with_threads(threads, [&] {
      return SP::align_spheres(surfaces.first, rows_of(sphere1), surfaces.second, rows_of(sphere2),
                               functions_of(features), alignment,
                               CGAL::parameters::visitor(std::ref(visitor)).maximum_running_time(time_limit));
    }));
    interruption.check();
  }
  const auto n = static_cast<py::ssize_t>(alignment.candidates.size());
  Values rotations({n, py::ssize_t(3), py::ssize_t(3)}), scores(n);
  double *number = rotations.mutable_data(), *score = scores.mutable_data();
  for(const auto& candidate : alignment.candidates)
  {
    *score++ = candidate.score;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        *number++ = candidate.rotation.m(i, j);
  }
  return py::make_tuple(rotations, scores, alignment.is_stopped);
}

py::tuple overlay(const Points& vertices1, const Indices& faces1, const Points& sphere1, const Points& vertices2,
                  const Indices& faces2, const Points& sphere2, std::optional<std::size_t> max_vertices,
                  std::size_t threads)
{
  const Overlay refinement = overlay_of(vertices1, faces1, sphere1, vertices2, faces2, sphere2, max_vertices, threads);
  Points points1 = new_points(refinement.points.size()), points2 = new_points(refinement.points.size());
  double *row1 = points1.mutable_data(), *row2 = points2.mutable_data();
  for(const auto& [p, q] : refinement.points)
  {
    row1 = std::copy(p.cartesian_begin(), p.cartesian_end(), row1);
    row2 = std::copy(q.cartesian_begin(), q.cartesian_end(), row2);
  }
  const auto n_faces = static_cast<py::ssize_t>(refinement.faces.size());
  Indices parents1(n_faces), parents2(n_faces);
  std::int64_t *parent1 = parents1.mutable_data(), *parent2 = parents2.mutable_data();
  for(const auto& [f, g] : refinement.faces)
  {
    *parent1++ = std::uint32_t(f);
    *parent2++ = std::uint32_t(g);
  }
  return py::make_tuple(points1, points2, to_array(refinement.triangles), parents1, parents2);
}

py::dict measure_distortion_between(const Points& vertices1, const Indices& faces1, const Points& sphere1,
                                    const Points& vertices2, const Indices& faces2, const Points& sphere2,
                                    double smallest_area, std::optional<std::size_t> max_vertices, std::size_t threads)
{
  const Overlay refinement = overlay_of(vertices1, faces1, sphere1, vertices2, faces2, sphere2, max_vertices, threads);
  SP::Distortion_between distortion;
  {
    const py::gil_scoped_release unlock;
    if(const SP::Error_code error = SP::measure_distortion_between(refinement, distortion, smallest_area);
       error != SP::OK)
      fail(error, SP::get_error_message(error));
  }
  return to_dict(distortion);
}

} // namespace Module
