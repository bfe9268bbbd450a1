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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_STEP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_STEP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/areas/Block_equations.h>
#include <CGAL/Spherical_parameterization/internal/areas/Area_shares.h>
#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_EIGEN3_ENABLED

// A step of all vertices on the unit sphere that moves the areas of their cells towards the prescribed areas and
// decreases an energy. It is a step of Newton's method, without the second derivatives of the areas, for
//
//   sum of E over the faces + (mu / 2) sum over the vertices of (ratio - 1)^2,
//
// where a ratio is the area of a cell divided by the prescribed one. The energy is that of the map from the faces of
// the surface scaled to their prescribed areas, with the determinant of the corners as image area, so that it goes to
// infinity where a face becomes inverted. Its Hessian is made positive definite face by face. With multipliers y = mu
// (ratio - 1), the equations are
//
//   ( H + tau G   J^T   ) ( x )   ( -gradient )
//   ( J         -1 / mu ) ( y ) = ( 1 - ratio )
//
// The matrix is quasi-definite, so it has a factorization in every elimination order, and it is not ill-conditioned for
// large mu. G measures how much a step changes each image relative to its size, and tau limits this change.
template <class Energy>
class Area_step
{
public:
  // The rings and the areas must outlive this object.
  Area_step(const Vertex_rings& rings, const std::vector<Vector_3d>& points, const std::vector<double>& areas_of_faces,
            const std::vector<double>& areas_of_vertices, const Energy& energy)
    : m_rings(rings)
    , m_wanted(areas_of_vertices)
    , m_energy(energy)
    , m_isometric_energy(m_energy(2., 1.))
    , m_equations(rings)
    , m_steps(points.size())
    , m_frames(points.size())
  {
    make_faces(points, areas_of_faces);
  }

  // The objective. It may be infinite or NaN.
  double objective(const std::vector<Vector_3d>& positions, double penalty)
  {
    double sum = 0.;
    for(const Face& face : m_faces)
    {
      const Image image(face, positions);
      sum += face.weight * (m_energy(image.i, image.d) - m_isometric_energy);
    }
    find_area_ratios(m_rings, positions, m_wanted, m_ratios);
    for(const double ratio : m_ratios)
      sum += 0.5 * penalty * (ratio - 1.) * (ratio - 1.);
    return sum;
  }

  // The ratios at the positions of the last measurement.
  const std::vector<double>& ratios() const { return m_ratios; }

  // Computes the step. Returns false if there is none, or if goes_on(), called every few milliseconds, returns false.
  template <class Goes_on>
  bool find(const std::vector<Vector_3d>& positions, double penalty, double damping, const Goes_on& goes_on)
  {
    m_equations.set_zero();
    for(std::size_t v = 0; v < positions.size(); ++v)
    {
      const Tangent_frame frame(positions[v]);
      m_frames[v] = {frame.vector_of(1., 0.), frame.vector_of(0., 1.)};
    }
    for(const Face& face : m_faces)
      add_energy(face, positions, damping);
    find_area_ratios(m_rings, positions, m_wanted, m_ratios);
    for(std::uint32_t v = 0; v < positions.size(); ++v)
      add_areas(v, positions, penalty);

    std::vector<double> solution;
    if(!m_equations.solve(solution, goes_on))
      return false;
    m_slope = 0.;
    bool result = true;
    for(std::size_t v = 0; v < positions.size(); ++v)
    {
      const std::size_t k = m_equations.row(v);
      m_steps[v] = solution[k] * m_frames[v][0] + solution[k + 1] * m_frames[v][1];
      result = result && is_finite(m_steps[v]);
      const double excess = m_ratios[v] - 1.; // which changes by J x = y / mu - excess
      m_slope += excess * (solution[k + 2] - penalty * excess) -
                 (m_equations.right_side[k] * solution[k] + m_equations.right_side[k + 1] * solution[k + 1]);
    }
    return result && m_slope < 0.;
  }

  // The derivative of the objective along the step.
  double slope() const { return m_slope; }

  // The positions after a fraction of the step.
  void move(const std::vector<Vector_3d>& positions, double t, std::vector<Vector_3d>& moved) const
  {
    moved.resize(positions.size());
    for(std::size_t v = 0; v < positions.size(); ++v)
      moved[v] = normalized(positions[v] + t * m_steps[v]);
  }

private:
  using Complex = std::complex<double>;
  static constexpr double min_curvature = 1e-3; // of the energy in the Jacobian of a face; 8 for an isometric face

  // A linear map z -> a z + b conj(z) + c of the triangle in the plane has a = sum of gradient_i * (image of corner i),
  // and b is the same sum with conjugate gradients. Its invariants are I = 2 (|a|^2 + |b|^2) and d = |a|^2 - |b|^2.
  using Gradients = std::array<Complex, 3>;
  static Gradients gradients(const std::array<Complex, 3>& corners, double doubled_area)
  {
    Gradients result;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Complex opposite = corners[(i + 2) % 3] - corners[(i + 1) % 3];
      result[i] = Complex(-0.5 * opposite.imag(), -0.5 * opposite.real()) / doubled_area;
    }
    return result;
  }

  struct Face
  {
    std::array<std::uint32_t, 3> vertices;
    Gradients rest;
    double weight;
    std::array<std::size_t, 3> pairs; // of corners 0 and 1, 1 and 2, 2 and 0, see Block_equations::entry()
  };

  // The image of a face, in the plane of its corners.
  struct Image
  {
    Image(const Face& face, const std::vector<Vector_3d>& positions)
    {
      for(std::size_t k = 0; k < 3; ++k)
        corners[k] = positions[face.vertices[k]];
      const Vector_3d to_1 = corners[1] - corners[0], to_2 = corners[2] - corners[0];
      const Vector_3d normal = cross(to_1, to_2);
      doubled_area = length(normal);
      determinant = dot(corners[0], normal);
      axes[0] = normalized(to_1);
      axes[1] = cross((1. / doubled_area) * normal, axes[0]);
      flat = {Complex(0., 0.), Complex(dot(to_1, axes[0]), 0.), in_plane(to_2)};
      a = b = 0.;
      for(std::size_t k = 1; k < 3; ++k)
      {
        a += times(face.rest[k], flat[k]);
        b += times(std::conj(face.rest[k]), flat[k]);
      }
      const double aa = squared_length(a), bb = squared_length(b);
      i = 2. * (aa + bb);
      factor = (aa - bb) / doubled_area;
      d = factor * determinant;
    }

    Complex in_plane(const Vector_3d& v) const { return Complex(dot(v, axes[0]), dot(v, axes[1])); }

    std::array<Vector_3d, 3> corners;
    std::array<Vector_3d, 2> axes;
    std::array<Complex, 3> flat; // the corners in the plane, relative to the first one
    double doubled_area, determinant, factor;
    Complex a, b;
    double i, d;
  };

  // A product without the tests for NaN that the language requires and without differences between standard libraries.
  static Complex times(const Complex& x, const Complex& y)
  {
    return Complex(x.real() * y.real() - x.imag() * y.imag(), x.real() * y.imag() + x.imag() * y.real());
  }

  static double squared_length(const Complex& x) { return x.real() * x.real() + x.imag() * x.imag(); }
  static double absolute(const Complex& x) { return std::sqrt(squared_length(x)); }

  void make_faces(const std::vector<Vector_3d>& points, const std::vector<double>& areas)
  {
    double sum = 0.;
    for(const double area : areas)
      sum += area;
    m_faces.reserve(areas.size());
    m_rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      const double area = areas[m_faces.size()];
      const Rest_triangle rest = Rest_triangle::from_points(points[a], points[b], points[c]);
      const double cotangent_0 = rest.opposite_0 / rest.inverse_doubled_area,
                   cotangent_1 = rest.opposite_1 / rest.inverse_doubled_area;
      // Corner 2 is above the base, which its height divides in proportion to the cotangents.
      const double base = std::sqrt(2. * area * (cotangent_0 + cotangent_1)), height = 2. * area / base;
      Face face;
      face.vertices = {a, b, c};
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::uint32_t v = face.vertices[k], w = face.vertices[(k + 1) % 3];
        face.pairs[k] = m_rings.offset(v) + m_rings.ring(v).position_of(w);
      }
      face.rest = gradients({Complex(0., 0.), Complex(base, 0.), Complex(height * cotangent_0, height)}, 2. * area);
      face.weight = Face_energy<Energy>::weighs_faces_by_area ? area * static_cast<double>(areas.size()) / sum : 1.;
      m_faces.push_back(face);
    });
  }

  void add_energy(const Face& face, const std::vector<Vector_3d>& positions, double damping)
  {
    const Image image(face, positions);
    const Energy_derivatives_3<double> e = m_energy.derivatives(image.i, image.d);

    // In the Jacobian, the energy has one pair of eigenvectors that changes p = |a| and q = |b|, with I = 2 (p^2 + q^2)
    // and d = p^2 - q^2, and two eigenvectors that change only the arguments of a and b.
    const double p2 = 0.5 * (0.5 * image.i + image.d);
    const double q2 = (std::max)(0.5 * (0.5 * image.i - image.d), 1e-12 * p2);
    const double p = std::sqrt(p2), q = std::sqrt(q2);
    const double of_argument_a = 4. * e.i + 2. * e.d, of_argument_b = 4. * e.i - 2. * e.d;
    double pp = of_argument_a + p2 * (16. * e.ii + 16. * e.id + 4. * e.dd);
    double qq = of_argument_b + q2 * (16. * e.ii - 16. * e.id + 4. * e.dd);
    double pq = p * q * (16. * e.ii - 4. * e.dd);
    make_positive(pp, pq, qq);
    const double aa = (std::max)(of_argument_a, min_curvature), bb = (std::max)(of_argument_b, min_curvature);

    const double flat_p = absolute(image.a), flat_q = absolute(image.b);
    const Complex direction_a = std::conj(image.a) / flat_p,
                  direction_b = flat_q > 0. ? std::conj(image.b) / flat_q : Complex(1., 0.);
    const Gradients own = gradients(image.flat, image.doubled_area);
    std::array<std::array<double, 9>, 6> changes; // by a move of each corner along each axis of its frame
    std::array<double, 6> slopes;
    for(std::size_t k = 0; k < 6; ++k)
    {
      const std::size_t corner = k / 2;
      const Vector_3d& axis = m_frames[face.vertices[corner]][k % 2];
      const Vector_3d &x = image.corners[corner], &next = image.corners[(corner + 1) % 3],
                      &last = image.corners[(corner + 2) % 3];
      const Complex move = image.in_plane(axis);
      const Complex da = times(times(face.rest[corner], move), direction_a),
                    db = times(times(std::conj(face.rest[corner]), move), direction_b);
      const double di = 4. * (flat_p * da.real() + flat_q * db.real());
      const double of_determinant = dot(axis, cross(x, last - next) + cross(next - x, last - x));
      const double dd = image.factor * of_determinant;
      slopes[k] = face.weight * (e.i * di + e.d * dd);
      const Complex scaling = times(own[corner], move), shear = times(std::conj(own[corner]), move);
      changes[k] = {(0.25 * di + 0.5 * dd) / (2. * p),
                    (0.25 * di - 0.5 * dd) / (2. * q),
                    da.imag(),
                    db.imag(),
                    scaling.real(),
                    scaling.imag(),
                    shear.real(),
                    shear.imag(),
                    of_determinant / image.determinant};
    }
    const auto curvature = [&](std::size_t k, std::size_t l) {
      const std::array<double, 9>&f = changes[k], &g = changes[l];
      const double of_energy =
          pp * f[0] * g[0] + qq * f[1] * g[1] + pq * (f[0] * g[1] + f[1] * g[0]) + aa * f[2] * g[2] + bb * f[3] * g[3];
      double of_step = 0.;
      for(std::size_t i = 4; i < 9; ++i)
        of_step += f[i] * g[i];
      return face.weight * of_energy + damping * of_step;
    };
    for(std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::uint32_t v = face.vertices[corner];
      const std::size_t k = 2 * corner, l = 2 * ((corner + 1) % 3);
      m_equations.diagonal(v, 0, 0) += curvature(k, k);
      m_equations.diagonal(v, 1, 0) += curvature(k, k + 1);
      m_equations.diagonal(v, 1, 1) += curvature(k + 1, k + 1);
      for(std::size_t i = 0; i < 2; ++i)
      {
        m_equations.right_side[m_equations.row(v) + i] -= slopes[k + i];
        for(std::size_t j = 0; j < 2; ++j)
          m_equations.entry(face.pairs[corner], i, j) += curvature(k + i, l + j);
      }
    }
  }

  // Raises the eigenvalues of a symmetric matrix that are below the minimum.
  static void make_positive(double& pp, double& pq, double& qq)
  {
    const double mean = 0.5 * (pp + qq), half = 0.5 * (pp - qq), radius = hypotenuse(half, pq);
    if(mean - radius >= min_curvature)
      return;
    const double larger = (std::max)(mean + radius, min_curvature), scale = 0.5 * (larger - min_curvature),
                 middle = 0.5 * (larger + min_curvature);
    const double cosine = radius > 0. ? half / radius : 1., sine = radius > 0. ? pq / radius : 0.;
    pp = middle + scale * cosine;
    qq = middle - scale * cosine;
    pq = scale * sine;
  }

  // The area of a vertex's cell changes with its neighbors only: they are the boundary of its faces.
  void add_areas(std::uint32_t v, const std::vector<Vector_3d>& positions, double penalty)
  {
    m_equations.diagonal(v, 2, 2) = -1. / penalty;
    m_equations.right_side[m_equations.row(v) + 2] = 1. - m_ratios[v];
    const Vertex_rings::Ring ring = m_rings.ring(v);
    const Vector_3d& center = positions[v];
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      const std::uint32_t w = ring[j];
      const Vector_3d &x = positions[w], &next = positions[ring.around(j + 1)],
                      &last = positions[ring.around(j + ring.size() - 1)];
      const Vector_3d gradient = (1. / (3. * m_wanted[v])) * (Spherical_area(x, next, center).gradient(x) +
                                                              Spherical_area(x, center, last).gradient(x));
      for(std::size_t i = 0; i < 2; ++i)
        m_equations.entry(m_rings.offset(v) + j, 2, i) += dot(gradient, m_frames[w][i]);
    }
  }

  const Vertex_rings& m_rings;
  const std::vector<double>& m_wanted;
  Face_energy<Energy> m_energy;
  double m_isometric_energy;
  std::vector<Face> m_faces;
  Block_equations m_equations;
  std::vector<Vector_3d> m_steps;
  std::vector<std::array<Vector_3d, 2>> m_frames;
  std::vector<double> m_ratios;
  double m_slope = 0.;
};

#endif // CGAL_EIGEN3_ENABLED

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_AREA_STEP_H
