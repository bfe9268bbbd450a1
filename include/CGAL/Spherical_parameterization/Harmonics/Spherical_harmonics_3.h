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
/// Normalization of the spherical harmonics.
enum class Harmonic_normalization
{
  four_pi,     ///< the mean square over the sphere is 1, that is, the integral of the square is \f$ 4 \pi \f$
  orthonormal, ///< the integral of the square over the sphere is 1
  schmidt ///< Schmidt semi-normalized: the integral of the square is \f$ 4 \pi / (2 l + 1) \f$ for degree \f$ l \f$
};

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// Weights of the squared error that an expansion minimizes.
enum class Harmonic_weights
{
  surface, ///< area on the surface, at nodes distributed over the whole surface
  sphere,  ///< area on the sphere, at the same nodes
  vertices ///< area on the surface, at the vertices only
};

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// Quality of the fit of an expansion, computed by `expand_in_spherical_harmonics()`. Errors are in the unit of the
/// functions; for the points of a surface, they are distances.
struct Harmonic_fit
{
  Harmonic_weights weights = Harmonic_weights::surface; ///< the weights of the minimized squared error
  double error_over_surface = 0.; ///< root mean square error over the whole surface, weighted by area
  double error_at_vertices = 0.;  ///< root mean square error at the vertices, weighted by vertex areas
  /// Root mean square, over the sphere, of the difference to the expansion with half as many parallels. It exceeds the
  /// error of the coefficients that is caused by the choice of the nodes. It is 0 for `Harmonic_weights::vertices`,
  /// where no nodes are chosen.
  double aliasing = 0.;
  std::size_t number_of_iterations = 0; ///< iterations of conjugate gradients; 0 if none are needed
  /// The largest degree that has no more coefficients than there are vertices. Coefficients of higher degrees describe
  /// the flat faces, not the sampled surface.
  std::size_t degree_of_vertices = 0;
};

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// The class `Spherical_harmonics_3` represents functions on the sphere as sums of real spherical harmonics up to a
/// degree \f$ L \f$. Such a function is
/// \f[ f(\theta, \varphi) = \sum_{l = 0}^L \sum_{m = -l}^l c_{lm} Y_{lm}, \quad Y_{lm} = N_{lm} P_{l|m|}(\cos \theta)
/// \cos m \varphi \ (m \geq 0) \ \textrm{ or } \sin |m| \varphi \ (m < 0), \f]
/// where \f$ \theta \f$ is the angle from the z-axis, and \f$ \varphi \f$ is the longitude from the x-axis towards the
/// y-axis. A surface is represented by three functions, its coordinates.
///
/// Changing the normalization multiplies the coefficients by factors that depend on the degree. Some authors include
/// the Condon-Shortley phase, a factor of \f$ (-1)^m \f$, in the harmonics. Without this phase, the harmonics of degree
/// 1 are positive multiples of y, z and x. The conventions are those of the arrays of pyshtools.
///
/// \sa `CGAL::Spherical_parameterization::expand_in_spherical_harmonics()`
/// \sa `CGAL::Spherical_parameterization::reconstruct_from_spherical_harmonics()`
class Spherical_harmonics_3
{
public:
  /// The largest supported degree: 1000
  static constexpr std::size_t max_degree = 1000; // see Spherical_harmonic_transform

  /// constructs functions that are 0.
  ///
  /// \param number_of_functions the number of functions
  /// \param degree the largest degree; a value above `max_degree` is replaced by `max_degree`
  /// \param normalization,has_phase the conventions of the coefficients
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

  /// returns the number of functions.
  std::size_t number_of_functions() const { return m_coefficients.size(); }

  /// returns the normalization.
  Harmonic_normalization normalization() const { return m_normalization; }

  /// returns whether the harmonics include the Condon-Shortley phase.
  bool has_phase() const { return m_has_phase; }

  /// returns the coefficient of `function` for `degree` and `order`.
  ///
  /// \pre `function < number_of_functions()`, `degree <= degree()`, and `order` is between `-degree` and `degree`
  double coefficient(std::size_t function, std::size_t degree, std::ptrdiff_t order) const
  {
    return m_coefficients[function][place(degree, order)];
  }

  /// sets the coefficient of `function` for `degree` and `order` to `value`; the preconditions are those of
  /// `coefficient()`.
  void set_coefficient(std::size_t function, std::size_t degree, std::ptrdiff_t order, double value)
  {
    m_coefficients[function][place(degree, order)] = value;
  }

  /// sets the largest degree to `degree`, at most `max_degree`; removes higher coefficients, or adds coefficients of 0.
  void set_degree(std::size_t degree)
  {
    m_degree = (std::min)(degree, max_degree);
    for(std::vector<double>& c : m_coefficients)
      c.resize((m_degree + 1) * (m_degree + 1), 0.);
  }

  /// converts the coefficients to `normalization`, with the Condon-Shortley phase if `has_phase`; the functions do not
  /// change.
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

  /// returns the power spectrum: for each degree, the mean square over the sphere of the part of that degree, summed
  /// over all functions. It depends neither on the normalization nor on rotations.
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

  /// The quality of the fit if the coefficients come from `expand_in_spherical_harmonics()`
  Harmonic_fit fit;

private:
  static std::size_t place(std::size_t degree, std::ptrdiff_t order)
  {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(degree * degree + degree) + order);
  }

  // the ratio of a coefficient in this normalization to the one in the 4 pi normalization
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
  std::vector<std::vector<double>> m_coefficients; // of each function, ordered by degree and order
  Harmonic_normalization m_normalization;
  bool m_has_phase;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_SPHERICAL_HARMONICS_3_H
