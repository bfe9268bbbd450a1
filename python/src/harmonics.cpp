#include "Interruption.h"
#include "functions.h"
#include "threads.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/expand_in_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/move_to_standard_position.h>
#include <CGAL/Spherical_parameterization/Harmonics/reconstruct_from_spherical_harmonics.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace Module {

SP::Harmonic_normalization normalization_of(const std::string& word)
{
  return word == "ortho"     ? SP::Harmonic_normalization::orthonormal
         : word == "schmidt" ? SP::Harmonic_normalization::schmidt
                             : SP::Harmonic_normalization::four_pi;
}

namespace {

// Calls f(function, l, m, index) for all coefficients and their indices in an array (functions, 2, degree + 1, degree + 1).
template <class Function>
void for_each_index(std::size_t n_functions, std::size_t degree, const Function& f)
{
  const std::size_t n = degree + 1;
  for(std::size_t k = 0; k < n_functions; ++k)
    for(std::size_t l = 0; l <= degree; ++l)
      for(std::size_t m = 0; m <= l; ++m)
      {
        f(k, l, static_cast<std::ptrdiff_t>(m), (2 * k * n + l) * n + m);
        if(m > 0)
          f(k, l, -static_cast<std::ptrdiff_t>(m), ((2 * k + 1) * n + l) * n + m);
      }
}

} // namespace

SP::Spherical_harmonics_3 to_harmonics(const Values& coefficients, const std::string& normalization, bool has_phase)
{
  SP::Spherical_harmonics_3 result(number_of_rows(coefficients), static_cast<std::size_t>(coefficients.shape(2)) - 1,
                                   normalization_of(normalization), has_phase);
  const double* const c = coefficients.data();
  for_each_index(result.number_of_functions(), result.degree(),
                 [&](std::size_t k, std::size_t l, std::ptrdiff_t m, std::size_t index) {
                   result.set_coefficient(k, l, m, c[index]);
                 });
  return result;
}

Values array_of(const SP::Spherical_harmonics_3& harmonics)
{
  const auto n = static_cast<py::ssize_t>(harmonics.degree() + 1);
  Values result({static_cast<py::ssize_t>(harmonics.number_of_functions()), py::ssize_t(2), n, n});
  double* const c = result.mutable_data();
  std::fill_n(c, result.size(), 0.);
  for_each_index(harmonics.number_of_functions(), harmonics.degree(),
                 [&](std::size_t k, std::size_t l, std::ptrdiff_t m, std::size_t index) {
                   c[index] = harmonics.coefficient(k, l, m);
                 });
  return result;
}

namespace {

// The rows of a table.
struct Numbers_map
{
  using key_type = Vertex_index;
  using value_type = std::vector<double>;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const double* data;
  std::size_t n_columns;

  friend value_type get(const Numbers_map& map, Vertex_index v)
  {
    const double* const row = map.data + std::size_t(v) * map.n_columns;
    return value_type(row, row + map.n_columns);
  }
};

} // namespace

py::tuple expand(const Points& vertices, const Indices& faces, const Points& sphere,
                 const std::optional<Values>& values, int degree, const std::string& weights,
                 const std::string& normalization, bool has_phase, std::size_t threads)
{
  SP::Harmonic_expansion_3 expansion(degree);
  expansion.weights(weights == "sphere"     ? SP::Harmonic_weights::sphere
                    : weights == "vertices" ? SP::Harmonic_weights::vertices
                                            : SP::Harmonic_weights::surface);
  const double* const numbers = values ? values->data() : nullptr;
  const std::size_t n_columns = values ? static_cast<std::size_t>(values->shape(1)) : 0;
  SP::Spherical_harmonics_3 harmonics;
  Signal_visitor visitor;
  {
    const py::gil_scoped_release unlock;
    const Mesh mesh = make_mesh("", vertices, faces);
    const auto np = CGAL::parameters::visitor(std::ref(visitor));
    const SP::Error_code error = run_with_threads(threads, [&] {
      return numbers == nullptr ? SP::expand_in_spherical_harmonics(mesh, rows_of(sphere), expansion, harmonics, np)
                                : SP::expand_in_spherical_harmonics(
                                      mesh, rows_of(sphere), Numbers_map{numbers, n_columns}, expansion, harmonics, np);
    });
    if(error == SP::ERROR_TOO_HIGH_DEGREE)
    {
      const auto n = static_cast<std::size_t>(
          std::count_if(mesh.vertices_begin(), mesh.vertices_end(), [&](auto v) { return !mesh.is_isolated(v); }));
      fail(error, "degree is " + std::to_string(degree) + ", which has " +
                      std::to_string((std::size_t(degree) + 1) * (std::size_t(degree) + 1)) +
                      " coefficients, but only " + std::to_string(n) +
                      " vertices determine them: with weights=\"vertices\", it may be at most " +
                      std::to_string(std::size_t(std::sqrt(double(n))) - 1));
    }
    if(error != SP::OK)
    {
      check_surface("", mesh);
      check_map("", mesh, "sphere", sphere);
      fail(error, SP::get_error_message(error));
    }
    harmonics.convert(normalization_of(normalization), has_phase);
  }
  const SP::Harmonic_fit& fit = harmonics.fit;
  return py::make_tuple(array_of(harmonics), py::make_tuple(fit.error_over_surface, fit.error_at_vertices, fit.aliasing,
                                                            fit.number_of_iterations, fit.degree_of_vertices));
}

Values evaluate_harmonics(const Values& coefficients, const std::string& normalization, bool has_phase,
                          const Points& directions, std::size_t threads)
{
  std::vector<double> values;
  Signal_visitor visitor;
  {
    const py::gil_scoped_release unlock;
    const SP::Spherical_harmonics_3 harmonics = to_harmonics(coefficients, normalization, has_phase);
    const std::size_t n = number_of_rows(directions);
    std::vector<Point_3> points;
    points.reserve(n);
    for(std::size_t k = 0; k < n; ++k)
      points.push_back(get(rows_of(directions), Vertex_index(static_cast<Mesh::size_type>(k))));
    const SP::Error_code error = run_with_threads(threads, [&] {
      return SP::evaluate_spherical_harmonics(harmonics, points, values, CGAL::parameters::visitor(std::ref(visitor)));
    });
    if(error != SP::OK)
      fail(error, SP::get_error_message(error));
  }
  Values result({directions.shape(0), coefficients.shape(0)});
  std::copy(values.begin(), values.end(), result.mutable_data());
  return result;
}

std::pair<Indices, Points> make_domain(const std::string& solid, std::uint32_t subdivision)
{
  const SP::Sphere_domain_3 domain = solid == "cube"          ? SP::Sphere_domain_3::cube(subdivision)
                                     : solid == "icosahedron" ? SP::Sphere_domain_3::icosahedron(subdivision)
                                                              : SP::Sphere_domain_3::octahedron(subdivision);
  Points sphere = new_points(domain.directions().size());
  const Row_map<double> rows(sphere.mutable_data());
  for(std::size_t k = 0; k < domain.directions().size(); ++k)
    put(rows, Vertex_index(static_cast<Mesh::size_type>(k)), domain.directions()[k]);
  return {to_array(domain.triangles()), sphere};
}

py::tuple standard_position(const Values& coefficients, const std::string& normalization, bool has_phase,
                            std::size_t threads)
{
  SP::Spherical_harmonics_3 harmonics;
  SP::Standard_position position;
  Signal_visitor visitor;
  {
    const py::gil_scoped_release unlock;
    harmonics = to_harmonics(coefficients, normalization, has_phase);
    const SP::Error_code error = run_with_threads(threads, [&] {
      return SP::move_to_standard_position(harmonics, position, CGAL::parameters::visitor(std::ref(visitor)));
    });
    if(error == SP::ERROR_UNDETERMINED_ROTATION)
      fail(error, "coefficients: the ellipsoid of degree 1 is a point or a line, which has no axes");
    if(error != SP::OK)
      fail(error, SP::get_error_message(error));
  }
  const auto matrix = [](const SP::Standard_position::Rotation& rotation) {
    Values result({py::ssize_t(3), py::ssize_t(3)});
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        result.mutable_at(i, j) = rotation.m(i, j);
    return result;
  };
  const auto vector = [](const std::array<double, 3>& x) { return Values(py::ssize_t(3), x.data()); };
  return py::make_tuple(array_of(harmonics), matrix(position.rotation_of_surface), matrix(position.rotation_of_sphere),
                        vector(position.center), vector(position.semi_axes), vector(position.skewness),
                        position.axes_are_determined, position.signs_are_determined);
}

} // namespace Module
