#include "Interruption.h"
#include "functions.h"
#include "threads.h"

#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/Sampling/measure_distance.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/Cortex/compute_sulcal_measures.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>

#include <algorithm>
#include <functional>

namespace Module {

namespace {

// Receives the values of each face from measure_distortion(), in columns.
struct Distortion_columns
{
  using key_type = Face_index;
  using value_type = SP::Face_distortion;
  using reference = value_type;
  using category = boost::writable_property_map_tag;

  double *isometric, *area, *angle;
  bool* is_inverted;

  friend void put(const Distortion_columns& columns, Face_index f, const SP::Face_distortion& distortion)
  {
    columns.isometric[f] = distortion.isometric;
    columns.area[f] = distortion.area;
    columns.angle[f] = distortion.angle;
    columns.is_inverted[f] = distortion.is_inverted;
  }
};

} // namespace

void find_defect(const Points& vertices, const Indices& faces)
{
  const py::gil_scoped_release unlock;
  check_surface("", make_mesh("", vertices, faces));
}

bool is_bijective(const Indices& faces, const Points& sphere, std::size_t threads)
{
  const py::gil_scoped_release unlock;
  try
  {
    const Mesh mesh = make_mesh("", sphere, faces);
    return run_with_threads(threads, [&] { return SP::is_bijective(mesh, rows_of(sphere)); });
  }
  catch(const Error& error)
  {
    if(error.defect.error != SP::ERROR_NO_SIMPLICIAL_COMPLEX)
      throw;
    return false; // no halfedge data structure can represent the faces
  }
}

py::array_t<float> round_to_float(const Indices& faces, const Points& sphere, std::size_t threads)
{
  py::array_t<float> result({sphere.shape(0), py::ssize_t(3)});
  float* const images = result.mutable_data();
  {
    const py::gil_scoped_release unlock;
    std::transform(sphere.data(), sphere.data() + sphere.size(), images,
                   [](double x) { return static_cast<float>(x); });
    const Mesh mesh = make_mesh("", sphere, faces);
    const SP::Error_code error =
        run_with_threads(threads, [&] { return SP::round_to_float(mesh, rows_of(sphere), Row_map<float>(images)); });
    if(error != SP::OK)
      fail(error, SP::get_error_message(error));
  }
  return result;
}

py::tuple compute_sulcal_measures(const Points& vertices, const Indices& faces, std::size_t threads)
{
  SP::Sulcal_measures folding;
  {
    const py::gil_scoped_release unlock;
    const Mesh mesh = make_mesh("", vertices, faces);
    check_surface("", mesh);
    const SP::Error_code error = run_with_threads(threads, [&] { return SP::compute_sulcal_measures(mesh, folding); });
    if(error != SP::OK)
      fail(error, SP::get_error_message(error));
  }
  const auto array = [](const std::vector<double>& values) {
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
  };
  return py::make_tuple(array(folding.curvature), array(folding.depth), array(folding.inflated_curvature));
}

py::dict measure_distortion(const Points& vertices, const Indices& faces, const Points& sphere, std::size_t threads)
{
  using namespace py::literals;
  const py::ssize_t n_faces = faces.shape(0);
  py::array_t<double> isometric(n_faces), area(n_faces), angle(n_faces);
  py::array_t<bool> is_inverted(n_faces);
  const Distortion_columns columns{isometric.mutable_data(), area.mutable_data(), angle.mutable_data(),
                                   is_inverted.mutable_data()};
  SP::Distortion_summary summary;
  {
    const py::gil_scoped_release unlock;
    const Mesh mesh = make_mesh("", vertices, faces);
    const SP::Error_code error =
        run_with_threads(threads, [&] { return SP::measure_distortion(mesh, rows_of(sphere), summary, columns); });
    if(error != SP::OK)
      fail(error, SP::get_error_message(error));
  }
  const auto measure = [](const py::array& of_faces, const SP::Distortion_statistics& statistics) {
    return py::make_tuple(of_faces, statistics.maximum, statistics.average, statistics.deviation);
  };
  return py::dict("isometric"_a = measure(isometric, summary.isometric), "area"_a = measure(area, summary.area),
                  "angle"_a = measure(angle, summary.angle), "is_inverted"_a = is_inverted, "radius"_a = summary.radius,
                  "number_of_inverted_faces"_a = summary.number_of_inverted_faces,
                  "number_of_degenerate_faces"_a = summary.number_of_degenerate_faces);
}

py::tuple measure_distance(const Points& vertices1, const Indices& faces1, const Points& vertices2,
                           const Indices& faces2, std::size_t number_of_points, std::size_t threads)
{
  SP::Surface_distance distance;
  Signal_visitor visitor;
  {
    const py::gil_scoped_release unlock;
    const std::string name1 = "surface1: ", name2 = "surface2: ";
    const Mesh first = make_mesh(name1, vertices1, faces1), second = make_mesh(name2, vertices2, faces2);
    const auto n = CGAL::parameters::number_of_points_on_faces(number_of_points);
    const SP::Error_code error = run_with_threads(
        threads, [&] { return SP::measure_distance(first, second, distance, n.visitor(std::ref(visitor)), n); });
    if(error != SP::OK)
    {
      const bool is_first = error != SP::ERROR_EMPTY_MESH || first.number_of_faces() == 0;
      check_points(name1, first, "vertices", vertices1);
      check_points(name2, second, "vertices", vertices2);
      fail(error, (is_first ? name1 : name2) + SP::get_error_message(error));
    }
  }
  const auto one_way = [](const SP::Surface_distance::One_way& d) {
    return py::make_tuple(d.root_mean_square, d.maximum);
  };
  return py::make_tuple(one_way(distance.from_first), one_way(distance.from_second), distance.diagonal);
}

} // namespace Module
