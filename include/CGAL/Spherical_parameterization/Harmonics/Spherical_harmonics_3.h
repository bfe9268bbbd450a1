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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_SPHERICAL_HARMONICS_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_SPHERICAL_HARMONICS_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// How spherical harmonics are scaled.
enum class Harmonic_normalization
{
  four_pi,     ///< the mean of their squares over the sphere is 1, that is, their integral is \f$ 4 \pi \f$
  orthonormal, ///< the integral of their squares over the sphere is 1
  schmidt      ///< that integral is \f$ 4 \pi / (2 l + 1) \f$ for the degree \f$ l \f$: semi-normalized, by Schmidt
};

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// What the squared error of an expansion is weighed with.
enum class Harmonic_weights
{
  surface, ///< areas of the surface, at nodes spread over all of it
  sphere,  ///< areas of the sphere, at the same nodes
  vertices ///< areas of the surface, at the vertices alone
};

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// How well an expansion fits: what `expand_in_spherical_harmonics()` tells beside the coefficients. The errors are in the unit
/// of the functions; of the points of a surface, they are distances.
struct Harmonic_fit
{
  Harmonic_weights weights = Harmonic_weights::surface; ///< what the squared error was weighed with
  double error_over_surface = 0.;                       ///< root mean square error over all of the surface, by its area
  double error_at_vertices = 0.;                        ///< the same at the vertices, by the areas around them
  /// Root mean square, over the sphere, of the difference to the expansion at half as many parallels: larger than what the
  /// choice of the nodes does to the coefficients; 0 at the vertices, where there is no choice
  double aliasing = 0.;
  std::size_t number_of_iterations = 0; ///< of conjugate gradients; 0 where none are needed
  /// The largest degree with no more coefficients than vertices: what is above it tells of flat faces, not of the surface
  std::size_t degree_of_vertices = 0;
};

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// Functions on the sphere as sums of real spherical harmonics up to a degree \f$ L \f$,
///
/// \f[ f(\theta, \varphi) = \sum_{l = 0}^L \sum_{m = -l}^l c_{lm} Y_{lm}, \quad Y_{lm} = N_{lm} P_{l|m|}(\cos \theta)
/// \cos m \varphi \ (m \geq 0) \ \textrm{ or } \sin |m| \varphi \ (m < 0), \f]
///
/// \f$ \theta \f$ from the z-axis, \f$ \varphi \f$ the longitude from the x-axis to the y-axis. A surface is three functions: its
/// coordinates. The coefficients of several normalizations differ by factors, and those with the phase of Condon and Shortley, by
/// which some authors multiply harmonics, by \f$ (-1)^m \f$. Without the phase, the harmonics of degree 1 are positive
/// multiples of y, z and x. The arrays of pyshtools have the same conventions.
///
/// \sa `CGAL::Spherical_parameterization::expand_in_spherical_harmonics()`
/// \sa `CGAL::Spherical_parameterization::reconstruct_from_spherical_harmonics()`
class Spherical_harmonics_3
{
public:
  /// The largest degree: 1000
  static constexpr std::size_t max_degree = 1000; // see Spherical_harmonic_transform

  /// makes functions that are 0.
  ///
  /// \param number_of_functions how many there are
  /// \param degree the largest degree; one above `max_degree` becomes that
  /// \param normalization,has_phase the harmonics that the coefficients belong to
  explicit Spherical_harmonics_3(std::size_t number_of_functions = 3, std::size_t degree = 0,
                                 Harmonic_normalization normalization = Harmonic_normalization::four_pi,
                                 bool has_phase = false)
    : m_degree((std::min)(degree, max_degree))
    , m_coefficients(number_of_functions, std::vector<double>((m_degree + 1) * (m_degree + 1), 0.))
    , m_normalization(normalization)
    , m_has_phase(has_phase)
  {}

  /// returns the largest degree.
  std::size_t degree() const { return m_degree; }

  /// returns how many functions there are.
  std::size_t number_of_functions() const { return m_coefficients.size(); }

  /// returns the normalization.
  Harmonic_normalization normalization() const { return m_normalization; }

  /// returns whether the harmonics have the phase of Condon and Shortley.
  bool has_phase() const { return m_has_phase; }

  /// returns the coefficient of `function`, for a `degree` up to `degree()` and an `order` from minus the degree to the degree.
  double coefficient(std::size_t function, std::size_t degree, std::ptrdiff_t order) const
  {
    return m_coefficients[function][place(degree, order)];
  }

  /// sets the coefficient of `function` for `degree` and `order` to `value`.
  void set_coefficient(std::size_t function, std::size_t degree, std::ptrdiff_t order, double value)
  {
    m_coefficients[function][place(degree, order)] = value;
  }

  /// leaves out what is above `degree`, or adds coefficients of 0 up to it, or to `max_degree`.
  void set_degree(std::size_t degree)
  {
    m_degree = (std::min)(degree, max_degree);
    for(std::vector<double>& c : m_coefficients)
      c.resize((m_degree + 1) * (m_degree + 1), 0.);
  }

  /// turns the coefficients into those of the same functions in `normalization`, with the phase of Condon and Shortley if `has_phase`.
  void convert(Harmonic_normalization normalization, bool has_phase = false)
  {
    for(std::size_t l = 0; l <= m_degree; ++l)
    {
      const double factor = scale(normalization, l) / scale(m_normalization, l);
      for(std::ptrdiff_t m = -static_cast<std::ptrdiff_t>(l); m <= static_cast<std::ptrdiff_t>(l); ++m)
        for(std::vector<double>& c : m_coefficients)
          c[place(l, m)] *= has_phase != m_has_phase && m % 2 != 0 ? -factor : factor;
    }
    m_normalization = normalization;
    m_has_phase = has_phase;
  }

  /// returns the power spectrum: for each degree, the mean square over the sphere of what all functions have of it. It does not
  /// depend on the normalization, nor on any rotation.
  std::vector<double> power_spectrum() const
  {
    std::vector<double> result(m_degree + 1, 0.);
    for(std::size_t l = 0; l <= m_degree; ++l)
    {
      for(const std::vector<double>& c : m_coefficients)
        for(std::size_t k = l * l; k < (l + 1) * (l + 1); ++k)
          result[l] += c[k] * c[k];
      const double factor = scale(m_normalization, l);
      result[l] /= factor * factor;
    }
    return result;
  }

  /// How well they fit, if they are from an expansion; see `expand_in_spherical_harmonics()`
  Harmonic_fit fit;

private:
  static std::size_t place(std::size_t degree, std::ptrdiff_t order)
  {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(degree * degree + degree) + order);
  }

  // a coefficient over that of the normalization 4 pi
  static double scale(Harmonic_normalization normalization, std::size_t degree)
  {
    constexpr double four_pi = 12.566370614359172954;
    switch(normalization)
    {
    case Harmonic_normalization::orthonormal:
      return std::sqrt(four_pi);
    case Harmonic_normalization::schmidt:
      return std::sqrt(2. * static_cast<double>(degree) + 1.);
    default:
      return 1.;
    }
  }

  std::size_t m_degree;
  std::vector<std::vector<double>> m_coefficients; // of each function, by degree and order
  Harmonic_normalization m_normalization;
  bool m_has_phase;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_SPHERICAL_HARMONICS_3_H
