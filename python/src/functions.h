#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_FUNCTIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_FUNCTIONS_H

#include "arrays.h"

#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>

#include <pybind11/stl.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Module {

// The Python part calls these functions after it has checked words, shapes and ranges. Its docstrings document them.

using Values = py::array_t<double, py::array::c_style>;
using Corners = py::array_t<std::int64_t, py::array::c_style>;

// `density` has a number for each vertex or for each face; it is empty for equal densities.
py::tuple parameterize(const Points& vertices, const Indices& faces, const std::string& prefer,
                       const std::string& energy, const std::optional<Points>& initial, bool starts_from_drawing,
                       const std::optional<Values>& density, bool is_of_faces, std::size_t threads, double time_limit,
                       const py::object& callback, bool returns_on_interrupt);

py::tuple fill_holes(const Points& vertices, const Indices& faces, std::size_t max_edges);
// Polygon f has the vertices corners[first[f]] to corners[first[f + 1] - 1].
py::tuple repair_surface(const Points& vertices, const Corners& corners, const Corners& first, double maximum_hole,
                         double maximum_handle, double maximum_added_area, bool refines_patches);
py::list find_handles(const Points& vertices, const Indices& faces, std::size_t max_handles);
void find_defect(const Points& vertices, const Indices& faces); // throws the defect
bool is_bijective(const Indices& faces, const Points& sphere, std::size_t threads);
py::tuple compute_sulcal_measures(const Points& vertices, const Indices& faces, std::size_t threads);
py::array_t<float> round_to_float(const Indices& faces, const Points& sphere, std::size_t threads);
py::dict measure_distortion(const Points& vertices, const Indices& faces, const Points& sphere, std::size_t threads);
py::tuple measure_distance(const Points& vertices1, const Indices& faces1, const Points& vertices2,
                           const Indices& faces2, std::size_t number_of_points, std::size_t threads);

void define_locator(py::module_& module);
py::tuple remesh(const Points& vertices, const Indices& faces, const Points& sphere, const std::string& solid,
                 std::uint32_t subdivision, std::size_t threads);
std::pair<Points, Points> remesh_with(const Points& vertices, const Indices& faces, const Points& sphere,
                                      const Indices& domain_faces, const Points& domain_sphere, std::size_t threads);
py::array transfer(const py::array& values, bool is_of_faces, const Points& vertices, const Indices& faces,
                   const Points& sphere, const Indices& target_faces, const Points& target_sphere, std::size_t threads);

py::tuple resample(const py::array& values, const Indices& faces, const Points& sphere, const Indices& target_faces,
                   const Points& target_sphere, const std::string& method, const Values& areas,
                   const Values& target_areas, const py::array_t<bool>& mask, std::size_t threads);
Points resample_sphere(const Indices& faces, const Points& sphere, const Points& registered,
                       const Indices& target_faces, const Points& target_sphere, std::size_t threads);

py::tuple expand(const Points& vertices, const Indices& faces, const Points& sphere,
                 const std::optional<Values>& values, int degree, const std::string& weights,
                 const std::string& normalization, bool has_phase, std::size_t threads);
Values evaluate_harmonics(const Values& coefficients, const std::string& normalization, bool has_phase,
                          const Points& directions, std::size_t threads);
std::pair<Indices, Points> make_domain(const std::string& solid, std::uint32_t subdivision);
py::tuple standard_position(const Values& coefficients, const std::string& normalization, bool has_phase,
                            std::size_t threads);

SP::Harmonic_normalization normalization_of(const std::string& word);
SP::Spherical_harmonics_3 to_harmonics(const Values& coefficients, const std::string& normalization, bool has_phase);
Values array_of(const SP::Spherical_harmonics_3& harmonics);

std::pair<Points, Indices> read_mesh(const std::string& path);
// The content is that of a table or of a SPHARM-PDM file.
Values read_coefficients(const std::string& content, bool is_table, const std::string& normalization, bool has_phase);
py::bytes write_coefficients(const Values& coefficients, bool is_table, const std::string& normalization,
                             bool has_phase);

using Features = std::vector<std::pair<Values, Values>>;
py::tuple map_surface(const Points& vertices1, const Indices& faces1, const Points& sphere1, const Points& vertices2,
                      const Indices& faces2, const Points& sphere2, const Indices& landmarks,
                      std::optional<double> landmark_weight, const Features& features, double feature_weight,
                      const std::vector<double>& feature_weights, bool compare_values, const Features& masks,
                      std::size_t threads, double time_limit, const py::object& callback, bool returns_on_interrupt);
py::tuple align_spheres(const Points& vertices1, const Indices& faces1, const Points& sphere1, const Points& vertices2,
                        const Indices& faces2, const Points& sphere2, const Features& features, std::size_t threads,
                        double time_limit, const py::object& callback, bool returns_on_interrupt);
py::tuple overlay(const Points& vertices1, const Indices& faces1, const Points& sphere1, const Points& vertices2,
                  const Indices& faces2, const Points& sphere2, std::optional<std::size_t> max_vertices,
                  std::size_t threads);
py::dict measure_distortion_between(const Points& vertices1, const Indices& faces1, const Points& sphere1,
                                    const Points& vertices2, const Indices& faces2, const Points& sphere2,
                                    double smallest_area, std::optional<std::size_t> max_vertices, std::size_t threads);

} // namespace Module

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_FUNCTIONS_H
