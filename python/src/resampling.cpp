#include "functions.h"
#include "threads.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_resampler_3.h>

#include <limits>

namespace Module {

namespace {

using Resampler = SP::Sphere_resampler_3<>;

// A sphere in the flat arrays that a resampler takes.
struct Sphere
{
  Sphere(const Indices& faces, const Points& sphere)
    : points(number_of_rows(sphere))
    , triangles(number_of_rows(faces))
  {
    constexpr std::int64_t max = (std::numeric_limits<std::uint32_t>::max)(); // not a vertex
    const double* x = sphere.data();
    for(auto& p : points)
      for(double& coordinate : p)
        coordinate = *x++;
    const std::int64_t* v = faces.data();
    for(auto& t : triangles)
      for(std::uint32_t& corner : t)
      {
        corner = static_cast<std::uint32_t>(*v < 0 || *v > max ? max : *v);
        ++v;
      }
  }

  Resampler::Points points;
  Resampler::Triangles triangles;
};

void connect(Resampler& resampler, const Indices& faces, const Points& sphere, const Sphere& source,
             const Indices& target_faces, const Points& target_sphere, const Sphere& target)
{
  const SP::Error_code error = resampler.connect(source.points, source.triangles, target.points, target.triangles);
  if(error == SP::OK)
    return;
  check_map("source: ", make_mesh("source: ", sphere, faces), "sphere", sphere);
  check_map("target: ", make_mesh("target: ", target_sphere, target_faces), "sphere", target_sphere);
  fail(error, SP::get_error_message(error));
}

template <class Number>
py::array resampled(const Resampler& resampler, const py::array_t<Number, py::array::c_style>& values, std::size_t n,
                    std::size_t threads)
{
  const auto n_columns = static_cast<std::size_t>(values.shape(1));
  py::array_t<Number> result({static_cast<py::ssize_t>(n), values.shape(1)});
  const Number* const source = values.data();
  Number* const target = result.mutable_data();
  const auto n_rows = number_of_rows(values);
  const py::gil_scoped_release unlock;
  for(std::size_t k = 0; k < n_columns; ++k)
  {
    std::vector<Number> column(n_rows);
    for(std::size_t i = 0; i < n_rows; ++i)
      column[i] = source[i * n_columns + k];
    const SP::Error_code error = run_with_threads(threads, [&] { return resampler.resample(column, column); });
    if(error != SP::OK)
      fail(error, SP::get_error_message(error));
    for(std::size_t i = 0; i < n; ++i)
      target[i * n_columns + k] = column[i];
  }
  return std::move(result);
}

} // namespace

py::tuple resample(const py::array& values, const Indices& faces, const Points& sphere, const Indices& target_faces,
                   const Points& target_sphere, const std::string& method, const Values& areas,
                   const Values& target_areas, const py::array_t<bool>& mask, std::size_t threads)
{
  Resampler resampler;
  resampler.method(method == "nearest"    ? SP::Resampling_method::nearest
                   : method == "largest"  ? SP::Resampling_method::largest
                   : method == "adaptive" ? SP::Resampling_method::adaptive
                                          : SP::Resampling_method::barycentric);
  const auto vector_of = [](const Values& array) {
    return std::vector<double>(array.data(), array.data() + array.size());
  };
  resampler.areas(vector_of(areas), vector_of(target_areas));
  resampler.mask(std::vector<bool>(mask.data(), mask.data() + mask.size()));
  {
    const py::gil_scoped_release unlock;
    const Sphere source(faces, sphere), target(target_faces, target_sphere);
    run_with_threads(threads, [&] { connect(resampler, faces, sphere, source, target_faces, target_sphere, target); });
  }
  const std::vector<bool> has_value = resampler.has_value();
  py::array_t<bool> valid(static_cast<py::ssize_t>(has_value.size()));
  std::copy(has_value.begin(), has_value.end(), valid.mutable_data());
  return py::make_tuple(values.dtype().kind() == 'f'
                            ? resampled<double>(resampler, values, has_value.size(), threads)
                            : resampled<std::int64_t>(resampler, values, has_value.size(), threads),
                        valid);
}

Points resample_sphere(const Indices& faces, const Points& sphere, const Points& registered,
                       const Indices& target_faces, const Points& target_sphere, std::size_t threads)
{
  Points result = new_points(number_of_rows(target_sphere));
  double* x = result.mutable_data();
  const py::gil_scoped_release unlock;
  Resampler resampler;
  const Sphere source(faces, sphere), target(target_faces, target_sphere), other(faces, registered);
  const SP::Error_code error = run_with_threads(threads, [&] {
    connect(resampler, faces, sphere, source, target_faces, target_sphere, target);
    Resampler::Points points;
    const SP::Error_code error_of_result = resampler.resample_sphere(other.points, points);
    for(const auto& p : points)
      x = std::copy(p.begin(), p.end(), x);
    return error_of_result;
  });
  if(error != SP::OK && error != SP::ERROR_NO_1_TO_1_MAPPING) // which is_bijective() reports
    fail(error, SP::get_error_message(error));
  return result;
}

} // namespace Module
