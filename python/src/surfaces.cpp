#include "Interruption.h"
#include "functions.h"

#include <CGAL/Spherical_parameterization/map_surface.h>
#include <CGAL/Spherical_parameterization/overlay.h>

#include <limits>

namespace Module {

namespace {

// Two surfaces with their maps; what is wrong with them is told by check().
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
    check_map(name1, first, "sphere1", sphere1);
    check_map(name2, second, "sphere2", sphere2);
    fail(error, SP::get_error_message(error));
  }

  static constexpr const char *name1 = "first surface: ", *name2 = "second surface: ";
};

// Asks Python for its signals while surfaces are mapped.
class Signal_visitor : public SP::Default_visitor
{
public:
  explicit Signal_visitor(Interruption& interruption)
    : m_interruption(interruption)
  {}

  bool go_further(std::size_t, double)
  {
    m_interruption.check_now_and_then();
    return !m_interruption.is_stopped();
  }

private:
  Interruption& m_interruption;
};

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
        Program::Input_defect defect{SP::ERROR_INVALID_LANDMARK,
                                     "landmarks: row " + std::to_string(row) + " has the vertex " + std::to_string(v) +
                                         (column == 0 ? " of the first surface" : " of the second surface") + why +
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
        refuse(", and so has row " + std::to_string(rows[vertex]));
      rows[vertex] = row;
      (column == 0 ? result[row].first : result[row].second) = vertex;
    }
  }
  return result;
}

} // namespace

py::tuple map_surface(const Points& vertices1, const Indices& faces1, const Points& sphere1, const Points& vertices2,
                      const Indices& faces2, const Points& sphere2, const Indices& landmarks,
                      std::optional<double> landmark_weight, const std::vector<std::pair<Values, Values>>& features,
                      double feature_weight, bool returns_on_interrupt)
{
  using namespace py::literals;
  const std::size_t n = number_of_rows(vertices1);
  Points directions = new_points(n);
  double* const rows = directions.mutable_data();
  std::fill_n(rows, 3 * n, std::numeric_limits<double>::quiet_NaN()); // for vertices without faces
  SP::Surface_map_report report;
  {
    const py::gil_scoped_release unlock;
    const Two_surfaces surfaces(vertices1, faces1, sphere1, vertices2, faces2, sphere2);
    std::vector<std::pair<std::function<double(Vertex_index)>, std::function<double(Vertex_index)>>> functions;
    const auto feature = [](const Values& values) {
      return [data = values.data()](Vertex_index v) { return data[v]; };
    };
    for(const auto& [values1, values2] : features)
      functions.emplace_back(feature(values1), feature(values2));
    auto mapper = SP::Surface_mapper_3<Mesh>()
                      .landmarks(read_landmarks(surfaces, landmarks))
                      .features(functions)
                      .feature_weight(feature_weight);
    if(landmark_weight)
      mapper = mapper.landmark_weight(*landmark_weight);
    Interruption interruption(returns_on_interrupt);
    Signal_visitor visitor(interruption);
    surfaces.check(SP::map_surface(surfaces.first, rows_of(sphere1), surfaces.second, rows_of(sphere2), mapper,
                                   Row_map<double>(rows), CGAL::parameters::visitor(std::ref(visitor))));
    report = mapper.report();
    interruption.check(); // one that comes after the last sweep, or where none is needed, is answered as well
  }
  return py::make_tuple(
      directions, py::dict("energy"_a = report.energy, "agreement"_a = report.agreement, "margin"_a = report.margin,
                           "landmark_distances"_a = Values(static_cast<py::ssize_t>(report.landmark_distances.size()),
                                                           report.landmark_distances.data()),
                           "number_of_missed_landmarks"_a = report.number_of_missed_landmarks,
                           "stop_reason"_a = SP::get_stop_message(report.stop_reason),
                           "number_of_sweeps"_a = report.number_of_sweeps));
}

py::tuple overlay(const Points& vertices1, const Indices& faces1, const Points& sphere1, const Points& vertices2,
                  const Indices& faces2, const Points& sphere2)
{
  SP::Surface_overlay_3<Mesh, Mesh> refinement;
  {
    const py::gil_scoped_release unlock;
    const Two_surfaces surfaces(vertices1, faces1, sphere1, vertices2, faces2, sphere2);
    surfaces.check(SP::overlay(surfaces.first, rows_of(sphere1), surfaces.second, rows_of(sphere2), refinement));
  }
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

} // namespace Module
