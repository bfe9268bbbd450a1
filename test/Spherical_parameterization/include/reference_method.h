// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_REFERENCE_METHOD_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_REFERENCE_METHOD_H

// The method of the package in one file: the objective that Bijective_low_distortion_parameterizer_3 minimizes and a descent
// to the same minimum, without what makes it fast. Equations are those of C. Wang, X. Hu, X. Fu, L. Liu: Bijective spherical parametrization with low distortion.
// Input: a closed triangle mesh M of genus 0, and a bijective map of its vertices v to points u_v of the unit sphere.
// Output: u_v and the radius r that minimize the distortion of the triangles r (u_a, u_b, u_c), as in eq. 6 and 7. The
// map stays bijective since every triangle keeps its orientation, det(u_a, u_b, u_c) > 0 (section 4.3).
//
// It is block coordinate descent (section 4.2): each step decreases one function Phi of the map, r and a level R. The
// package does so from coarse to fine (internal/hierarchy), moves independent vertices at once (internal/descent),
// removes smooth errors by steps of all vertices (Smooth_step.h), sweeps the worst faces more often (Descent_loop.h), gives
// limits to the shapes of slivers (Rest_triangle.h), tries the first step of a vertex
// without the test of sufficient decrease (Vertex_step.h), and chooses the radius anew at the end.

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace test {

class Reference_method
{
public:
  using Vector = Eigen::Vector3d;
  using Vectors = std::vector<Vector>;
  using Triangle = std::array<std::size_t, 3>; // counterclockwise, seen from outside

  // `beta` is that of Sharpness: 0 for the lowest average distortion, 20 by default, 40 for a low maximum.
  Reference_method(const Vectors& points, const std::vector<Triangle>& triangles, double beta)
    : m_a(beta / (beta + 40.))
    , m_b(beta + 1.)
    , m_stars(points.size())
  {
    double area = 0.;
    for(const Triangle& t : triangles)
      area += 0.5 * normal(points, t).norm();
    const double scale = 4. * static_cast<double>(EIGEN_PI) / area; // to the area of the unit sphere: eq. 10 is r = 1
    for(const auto& [a, b, c] : triangles)
    {
      m_faces.emplace_back(points, Triangle{a, b, c}, scale);
      for(const Triangle& t : {Triangle{a, b, c}, Triangle{b, c, a}, Triangle{c, a, b}})
        m_stars[t[0]].emplace_back(points, t, scale);
    }
  }

  // Starts from a bijective map to the unit sphere, with the best R and r.
  void set_map(const Vectors& u)
  {
    m_u = u;
    for(int k = 0; k < 100; ++k)
      optimize_level_and_radius();
  }
  const Vectors& map() const { return m_u; }
  double phi() const { return sum(m_faces, &Image::psi) / static_cast<double>(m_faces.size()); }

  // Decreases Phi until 10 sweeps change it by no more than the tolerance.
  void minimize(double tolerance)
  {
    for(double last = HUGE_VAL; last - phi() > tolerance * phi();)
    {
      last = phi();
      for(int sweep = 0; sweep < 10; ++sweep, optimize_level_and_radius())
        for(std::size_t v = 0; v < m_u.size(); ++v)
          move(v);
    }
  }

private:
  struct Face
  {
    Face(const Vectors& p, const Triangle& t, double scale)
      : vertices(t)
      , area(scale * normal(p, t).norm())
    {
      for(std::size_t k = 0; k < 3; ++k)
        o[k] = scale * (p[t[(k + 1) % 3]] - p[t[k]]).dot(p[t[(k + 2) % 3]] - p[t[k]]) / (area * area);
      correction = 1. + (std::min)((o[0] + o[1] + o[2]) * area * area / 9., 4.);
    }

    Triangle vertices;
    double area, correction; // A, twice the area in M; c, see below
    std::array<double, 3> o; // cot(theta_k) / A for the angles theta_k of M
  };

  // The singular values s1, s2 of the affine map of a face to its image follow from I = s1^2 + s2^2, which is
  // (1 / A) sum_k cot(theta_k) l_k^2 with the edges l_k of the image opposite to theta_k, and from d = s1 s2 = a / A,
  // where a is twice the area of the image. Here, a is r^2 c det(u_0, u_1, u_2): it vanishes where the orientation
  // changes, which the area of the flat image does not, so that the energy is a barrier. A triangle inscribed in the unit
  // sphere has twice the area det / h, with the distance h of its plane from the origin, and h^2 = 1 - R^2 with its circumradius
  // R, so that 1 / h is 1 + (sum of the squared edges) / 18 to first order for one that is equilateral: c is that, of the face
  // of M, and at most 5 for faces as large as the sphere. The energy is the symmetric Dirichlet energy
  // E = (s1^2 + s2^2 + 1/s1^2 + 1/s2^2) / 2; unlike eq. 3, it grows with the square of D_iso = max(s2, 1/s1) of eq. 12.
  //
  // Phi is the mean over the faces of psi(E), a mixture of E as in eq. 6 and of exponentials as in eq. 7, s = b / R:
  //   psi(E) = (1 - a) E + a ((1 - 1/b) R + (R/b) w),  w = exp(b (E/R - 1)),  a = beta / (beta + 40),  b = beta + 1.
  // At the best R, the second part is a soft maximum of the energies, in their own unit: no s has to be chosen.
  struct Image
  {
    double i, d, e, w, psi;
  };
  Image image_of(const Face& face) const
  {
    const double r2 = m_radius * m_radius, det = m_u[face.vertices[0]].dot(normal(m_u, face.vertices));
    double i = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      i += r2 * face.o[k] * (m_u[face.vertices[(k + 1) % 3]] - m_u[face.vertices[(k + 2) % 3]]).squaredNorm();
    const double d = r2 * face.correction / face.area * det, e = det > 0. ? 0.5 * i * (1. + 1. / (d * d)) : HUGE_VAL;
    const double w = std::exp(m_b * (e / m_level - 1.));
    return {i, d, e, w, (1. - m_a) * e + m_a * m_level * (1. + (w - 1.) / m_b)};
  }

  template <class Function>
  double sum(const std::vector<Face>& faces, const Function& f) const
  {
    return std::accumulate(faces.begin(), faces.end(), 0.,
                           [&](double s, const Face& t) { return s + std::invoke(f, image_of(t)); });
  }

  // Phi is convex in R and in log r. Its derivatives are the means of a (1 - 1/b + (1/b - E/R) w) and of
  // psi'(E) dE / d log r, where psi' = 1 - a + a w and dE / d log r = I - I / d^2.
  void optimize_level_and_radius()
  {
    const auto bisect = [this](double& variable, double low, double high, const auto& derivative) {
      for(int k = 0; k < 50; ++k)
      {
        variable = std::sqrt(low * high);
        (sum(m_faces, derivative) < 0. ? low : high) = variable;
      }
    };
    const double sum_of_energies = sum(m_faces, &Image::e);
    bisect(m_level, sum_of_energies / static_cast<double>(m_faces.size()), sum_of_energies,
           [&](const Image& f) { return 1. - 1. / m_b + (1. / m_b - f.e / m_level) * f.w; });
    bisect(m_radius, 0.5 * m_radius, 2. * m_radius, [&](const Image& f) { // farther away, w might overflow
      return (1. - m_a + m_a * f.w) * (f.i - f.i / (f.d * f.d));
    });
  }

  // A step of u_v that decreases the sum of psi(E) over the faces (v, p, q) around it: eq. 8 with Newton's direction.
  // In space, the gradient of psi(E(I, d)) and its Hessian follow by the chain rule from
  //   grad I = 2 r^2 (o_q (u_v - p) + o_p (u_v - q)),  hess I = 2 r^2 (o_p + o_q) Id,  grad d = (r^2 c / A) p x q.
  // On the sphere, they are the tangential part, and that of the Hessian minus (u_v . gradient) Id.
  void move(std::size_t v)
  {
    const Vector start = m_u[v];
    const double r2 = m_radius * m_radius, start_value = sum(m_stars[v], &Image::psi);
    Vector gradient = Vector::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    for(const Face& face : m_stars[v])
    {
      const auto [i, d, e, w, psi] = image_of(face);
      const Vector &p = m_u[face.vertices[1]], &q = m_u[face.vertices[2]];
      const Vector di = 2. * r2 * (face.o[2] * (start - p) + face.o[1] * (start - q));
      const Vector dd = r2 * face.correction / face.area * p.cross(q);
      const double ei = 0.5 * (1. + 1. / (d * d)), eid = -1. / (d * d * d), ed = i * eid, edd = -3. * ed / d;
      const double first = 1. - m_a + m_a * w, second = m_a * m_b / m_level * w; // psi' and psi''
      const Vector de = ei * di + ed * dd;
      gradient += first * de;
      hessian += first * (eid * (di * dd.transpose() + dd * di.transpose()) + edd * dd * dd.transpose());
      hessian += first * ei * 2. * r2 * (face.o[1] + face.o[2]) * Eigen::Matrix3d::Identity();
      hessian += second * de * de.transpose();
    }
    Eigen::Matrix<double, 3, 2> tangents;
    tangents << start.unitOrthogonal(), start.cross(start.unitOrthogonal());
    hessian -= start.dot(gradient) * Eigen::Matrix3d::Identity();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> h(tangents.transpose() * hessian * tangents);
    const Eigen::Vector2d c = h.eigenvalues().cwiseAbs(),
                          g = h.eigenvectors().transpose() * tangents.transpose() * gradient;
    const Eigen::Vector2d step = -g.cwiseQuotient(c.cwiseMax(1e-3 * c.maxCoeff())); // along eigenvectors, downwards
    // The line search starts with over-relaxation, by which sweeps converge faster.
    for(double t = 1.9; t > 1e-4; t *= 0.5)
    {
      m_u[v] = (start + t * (tangents * (h.eigenvectors() * step))).normalized();
      if(sum(m_stars[v], &Image::psi) < start_value + 1e-4 * t * g.dot(step)) // false if a triangle is inverted
        return;
    }
    m_u[v] = start;
  }

  static Vector normal(const Vectors& p, const Triangle& t) { return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]); }
  double m_a, m_b, m_radius = 1., m_level = 1.;
  Vectors m_u;
  std::vector<Face> m_faces;
  std::vector<std::vector<Face>> m_stars; // the faces around each vertex, which is the first of each
};

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_REFERENCE_METHOD_H
