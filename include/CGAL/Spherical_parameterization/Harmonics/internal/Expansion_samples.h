// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_EXPANSION_SAMPLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_EXPANSION_SAMPLES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/Harmonics/expand_in_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Sphere_nodes.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Spherical_harmonic_transform.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/conjugate_gradients.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Weighted least squares fit of sums of harmonics to values at the nodes, by conjugate gradients on the normal
// equations. Their matrix is never formed: an iteration costs two transforms, whereas forming the matrix would cost
// about as much as n iterations for n coefficients. With the weights of a Gauss-Legendre grid, the matrix is the
// identity, and one iteration is enough. Otherwise, its condition number is at most the ratio of the largest to the
// smallest quotient of weight and area on the sphere. If the nodes hardly determine some directions in the space of
// coefficients, late iterations gain little. So the iteration ends when ten iterations decrease the sum of squares by
// less than 0.1 percent, or when the residual is at the level of rounding errors.
class Least_squares
{
public:
  static constexpr std::size_t n_functions = Sphere_nodes::n_functions;

  // `weights` has the order of the values; nodes that pad a group have the weight 0
  Least_squares(const Spherical_harmonic_transform& transform, const Sphere_nodes& nodes,
                const std::vector<double>& weights, const Execution& execution)
    : m_transform(transform)
    , m_nodes(nodes)
    , m_weights(weights)
    , m_execution(execution)
  {}

  // Returns false if the control has stopped it.
  bool solve(const std::vector<double>& values, std::vector<double>& coefficients, Run_control& control)
  {
    constexpr std::size_t max_steps = 1000, n_between = 10;
    constexpr double min_decrease = 1e-3, squared_rounding = 1e-26;
    using Values = std::vector<double>;
    using Numbers = std::array<double, n_functions>;
    Values residual, image, product = weighed(values);
    Numbers squares = dots_at_nodes(values, product); // the minimized sums
    m_transform.project(m_nodes, product, residual, m_execution);
    coefficients.assign(residual.size(), 0.);
    Numbers last = {}; // the products before the last step
    double before = -1.;
    m_n_steps = conjugate_gradients(
        coefficients, residual,
        [&](const Values& p, Values& q) {
          m_transform.evaluate(m_nodes, p, image, m_execution);
          m_transform.project(m_nodes, weighed(image), q, m_execution);
          return dots(p, q);
        },
        [](const Values& r, Values& z) { return z = r, dots(r, r); },
        [&](std::size_t k, const Numbers& rho, const Numbers& first, const Numbers& step) {
          if(k == max_steps || !control.go_further(0, 0.))
            return false;
          bool is_done = true;
          for(std::size_t i = 0; i < n_functions; ++i)
          {
            squares[i] -= step[i] * last[i];
            is_done = is_done && rho[i] <= squared_rounding * first[i];
          }
          last = rho;
          if(k % n_between == 0)
          {
            const double sum = squares[0] + squares[1] + squares[2];
            is_done = is_done || (k > 0 && sum > (1. - min_decrease) * before);
            before = sum;
          }
          return !is_done;
        });
    return !control.is_stopped();
  }

  // Integrates the products of the values and the harmonics. For the weights of a Gauss-Legendre grid, this equals
  // solve().
  void project(const std::vector<double>& values, std::vector<double>& coefficients) const
  {
    m_transform.project(m_nodes, weighed(values), coefficients, m_execution);
  }

  std::size_t number_of_steps() const { return m_n_steps; }

  // Weighted sum of the squared differences between the values and the sums of harmonics.
  double squared_error(const std::vector<double>& values, const std::vector<double>& coefficients) const
  {
    std::vector<double> differences;
    m_transform.evaluate(m_nodes, coefficients, differences, m_execution);
    for(std::size_t k = 0; k < differences.size(); ++k)
      differences[k] -= values[k];
    const std::array<double, n_functions> sums = dots_at_nodes(differences, weighed(differences));
    return sums[0] + sums[1] + sums[2];
  }

private:
  std::vector<double> weighed(std::vector<double> values) const
  {
    for(std::size_t k = 0; k < values.size(); ++k)
      values[k] *= m_weights[k];
    return values;
  }

  static std::array<double, n_functions> dots(const std::vector<double>& a, const std::vector<double>& b)
  {
    std::array<double, n_functions> sums = {0., 0., 0.};
    for(std::size_t k = 0; k < a.size(); k += n_functions)
      for(std::size_t i = 0; i < n_functions; ++i)
        sums[i] += a[k + i] * b[k + i];
    return sums;
  }

  std::array<double, n_functions> dots_at_nodes(const std::vector<double>& a, const std::vector<double>& b) const
  {
    std::array<double, n_functions> sums = {0., 0., 0.};
    const std::size_t size = m_nodes.size_of_group() / n_functions;
    for(std::size_t begin = 0; begin < a.size(); begin += m_nodes.size_of_group())
      for(std::size_t i = 0; i < n_functions; ++i)
        for(std::size_t k = begin + i * size; k < begin + (i + 1) * size; ++k)
          sums[i] += a[k] * b[k];
    return sums;
  }

  const Spherical_harmonic_transform& m_transform;
  const Sphere_nodes& m_nodes;
  const std::vector<double>& m_weights;
  Execution m_execution;
  std::size_t m_n_steps = 0;
};

// Returns a function for the area of a triangle given by indices of these points.
inline auto area_on(const std::vector<Vector_3d>& points)
{
  return [&points](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return 0.5 * doubled_area(points[a], points[b], points[c]);
  };
}

// Samples of functions on the vertices, and their weights, whose sum is 1.
class Expansion_samples
{
public:
  // Samples at the vertices, each weighted by a third of the area of its faces.
  explicit Expansion_samples(const Expansion_surface& surface)
    : m_nodes(directions_of(surface.images))
    , m_counts(vertex_sums(surface.triangles, surface.points.size(), area_on(surface.points)))
  {
    normalize_counts(std::vector<double>(surface.points.size(), 1.));
    m_terms.reserve(surface.points.size());
    for(std::uint32_t v = 0; v < surface.points.size(); ++v)
      m_terms.push_back({{v, v, v}, {1., 0., 0.}});
  }

  // Samples at the nodes of a grid, weighted by area on the surface or on the sphere. For a triangle with the images p,
  // q, r and the area A on the surface, the ratio of area on the surface to area on the sphere in the direction of a
  // point x of the flat triangle p, q, r is 2 A |x|^3 / det(p, q, r).
  Expansion_samples(const Expansion_surface& surface, Gauss_grid grid, bool weighs_surface)
    : m_nodes(std::move(grid.nodes))
  {
    const std::size_t width = m_nodes.width(), n = m_nodes.number_of_parallels() * width;
    std::vector<Vector_3d> directions;
    directions.reserve(n);
    std::vector<double> areas;
    areas.reserve(n);
    for(std::size_t k = 0; k < n; ++k)
    {
      directions.push_back(m_nodes.direction(k / width, k % width));
      areas.push_back(grid.weights[k / width]);
    }
    m_counts = areas;
    m_terms = surface.locate(directions);
    for(std::size_t k = 0; weighs_surface && k < n; ++k)
    {
      const auto& [t, w] = m_terms[k];
      const std::array<Vector_3d, 3> p =
          scaled_together({surface.images[t[0]], surface.images[t[1]], surface.images[t[2]]});
      const double det = dot(p[0], cross(p[1], p[2])), r = length(w[0] * p[0] + w[1] * p[1] + w[2] * p[2]);
      m_counts[k] *= det > 0. ? area_on(surface.points)(t[0], t[1], t[2]) * (r * r * r / det) : 0.;
    }
    normalize_counts(areas);
  }

  const Sphere_nodes& nodes() const { return m_nodes; }
  const std::vector<double>& weights() const { return m_weights; }

  std::vector<double> sample(const std::vector<Vector_3d>& values) const
  {
    std::vector<double> result(m_nodes.number_of_values(), 0.);
    for(std::size_t k = 0; k < m_terms.size(); ++k)
    {
      const Vertex_mean& t = m_terms[k];
      const Vector_3d x = t.weights[0] * values[t.vertices[0]] + t.weights[1] * values[t.vertices[1]] +
                          t.weights[2] * values[t.vertices[2]];
      for(std::size_t i = 0; i < Sphere_nodes::n_functions; ++i)
        result[place(k, i)] = x[i];
    }
    return result;
  }

private:
  std::size_t place(std::size_t k, std::size_t function) const
  {
    return m_nodes.place(k / m_nodes.width(), k % m_nodes.width(), function);
  }

  static std::vector<Vector_3d> directions_of(std::vector<Vector_3d> images)
  {
    for(Vector_3d& p : images)
      p = direction_of(p);
    return images;
  }

  // Normalizes the counts to weights with the sum 1. If all are 0, the weights are those of `usual`.
  void normalize_counts(const std::vector<double>& usual)
  {
    double sum = 0.;
    for(const double x : m_counts)
      sum += x;
    if(!(sum > 0.))
    {
      m_counts = usual;
      sum = 0.;
      for(const double x : m_counts)
        sum += x;
    }
    m_weights.assign(m_nodes.number_of_values(), 0.);
    for(std::size_t k = 0; k < m_counts.size(); ++k)
      for(std::size_t i = 0; i < Sphere_nodes::n_functions; ++i)
        m_weights[place(k, i)] = m_counts[k] / sum;
    m_counts = {};
  }

  Sphere_nodes m_nodes;
  std::vector<double> m_counts, m_weights; // per sample; in the order of the values
  std::vector<Vertex_mean> m_terms;
};

// Expansions of functions on the vertices of a mesh.
class Expansion
{
public:
  // The points must be scaled so that areas neither overflow nor underflow.
  Expansion(const Expansion_surface& surface, std::size_t degree, Harmonic_weights weights, const Execution& execution)
    : m_transform(degree)
    , m_at_vertices(surface)
    , m_over_surface(surface, Gauss_grid(degree_of_grid(degree, surface.points.size())), true)
    , m_execution(execution)
  {
    m_fit.weights = weights;
    m_fit.degree_of_vertices = static_cast<std::size_t>(std::sqrt(static_cast<double>(surface.points.size()))) - 1;
    if(weights == Harmonic_weights::vertices)
      return;
    const std::size_t n = degree_of_grid(degree, surface.points.size());
    const bool weighs_surface = weights == Harmonic_weights::surface;
    if(!weighs_surface)
      m_over_sphere.emplace(surface, Gauss_grid(n), false);
    m_coarse.emplace(surface, Gauss_grid((std::max)(degree, n / 2)), weighs_surface);
  }

  const Spherical_harmonic_transform& transform() const { return m_transform; }
  const Harmonic_fit& fit() const { return m_fit; }

  // Writes the coefficients of three functions on the vertices in the order of the transform, and updates the fit.
  // Returns false if the control has stopped it.
  bool expand(const std::vector<Vector_3d>& of_vertices, std::vector<double>& coefficients, Run_control& control)
  {
    std::vector<Vector_3d> values = of_vertices;
    Vector_3d origin;
    const int exponent = normalize(values, &origin);
    const Expansion_samples& samples = m_fit.weights == Harmonic_weights::vertices  ? m_at_vertices
                                       : m_fit.weights == Harmonic_weights::surface ? m_over_surface
                                                                                    : *m_over_sphere;
    std::vector<double> coarse;
    if(!solve(samples, values, coefficients, true, control) ||
       (m_coarse && !solve(*m_coarse, values, coarse, false, control)))
      return false;
    double difference = 0.; // for harmonics with mean square 1
    for(std::size_t k = 0; k < coarse.size(); ++k)
      difference += (coefficients[k] - coarse[k]) * (coefficients[k] - coarse[k]);
    const auto add = [&](double& error, double square) {
      error = hypotenuse(error, std::ldexp(std::sqrt(square), exponent));
    };
    add(m_fit.aliasing, difference);
    add(m_fit.error_over_surface, squared_error(m_over_surface, values, coefficients));
    add(m_fit.error_at_vertices, squared_error(m_at_vertices, values, coefficients));
    for(double& c : coefficients)
      c = std::ldexp(c, exponent);
    for(std::size_t i = 0; i < Sphere_nodes::n_functions; ++i)
      coefficients[i] += origin[i]; // degree 0
    return control.go_further(0, 0.);
  }

private:
  // Functions that are linear on faces have harmonics of all degrees, and those above the degree of the grid cause
  // aliasing. So the grid has twice as many parallels as the degree, or the resolution of the mesh, requires. More than
  // 600 are used only for high degrees.
  static std::size_t degree_of_grid(std::size_t degree, std::size_t n_vertices)
  {
    constexpr std::size_t usual_maximum = 600;
    const auto across = static_cast<std::size_t>(std::sqrt(static_cast<double>(n_vertices)));
    return (std::max)((std::min)(2 * (std::max)(degree, across), usual_maximum), degree + degree / 2);
  }

  bool solve(const Expansion_samples& samples, const std::vector<Vector_3d>& values, std::vector<double>& coefficients,
             bool counts, Run_control& control)
  {
    Least_squares squares(m_transform, samples.nodes(), samples.weights(), m_execution);
    if(m_fit.weights == Harmonic_weights::sphere)
      squares.project(samples.sample(values), coefficients);
    else if(!squares.solve(samples.sample(values), coefficients, control))
      return false;
    if(counts)
      m_fit.number_of_iterations = (std::max)(m_fit.number_of_iterations, squares.number_of_steps());
    return true;
  }

  double squared_error(const Expansion_samples& samples, const std::vector<Vector_3d>& values,
                       const std::vector<double>& coefficients) const
  {
    return Least_squares(m_transform, samples.nodes(), samples.weights(), m_execution)
        .squared_error(samples.sample(values), coefficients);
  }

  Spherical_harmonic_transform m_transform;
  Harmonic_fit m_fit;
  Expansion_samples m_at_vertices, m_over_surface;
  std::optional<Expansion_samples> m_over_sphere, m_coarse; // the second one with fewer parallels
  Execution m_execution;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_EXPANSION_SAMPLES_H
