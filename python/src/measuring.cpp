#include "functions.h"

#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

namespace Module {

namespace {

// Where measure_distortion() leaves the values of each face: in columns.
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

bool is_bijective(const Points& sphere, const Indices& faces)
{
  const py::gil_scoped_release unlock;
  try
  {
    return SP::is_bijective(make_mesh("", sphere, faces), rows_of(sphere));
  }
  catch(const Error& error)
  {
    if(error.defect.error != SP::ERROR_NO_SIMPLICIAL_COMPLEX)
      throw;
    return false; // for what no halfedge data structure can hold
  }
}

py::dict measure_distortion(const Points& vertices, const Indices& faces, const Points& sphere)
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
    const SP::Error_code error =
        SP::measure_distortion(make_mesh("", vertices, faces), rows_of(sphere), summary, columns);
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

} // namespace Module
