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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_STAR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_STAR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/levels/Target_metric.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The symmetric Dirichlet energy of the map between two surfaces, integrated over both and halved,
//
//   E = (1 + d) / 2 (I + I / d^2) / 2
//
// for each unit of area of the first one: 2 where the map is isometric.
class Two_way_energy
{
public:
  static constexpr bool weighs_faces_by_area = true;

  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    const FT e = 1. / d;
    return 0.25 * i * (1. + d) * (1. + e * e);
  }

  Energy_derivatives_3<double> derivatives(double i, double d) const
  {
    const double e = 1. / d, factor = 0.25 * (1. + d) * (1. + e * e), slope = 0.25 * (1. - e * e - 2. * e * e * e);
    return {factor * i, factor, slope * i, 0., slope, 0.25 * i * (2. * e * e * e + 6. * e * e * e * e)};
  }
};

// The energy of the faces around one vertex of the first surface, as a function of the two tangential coordinates of its
// image on the sphere of the second one: what a Newton_step lowers. That of a face counts as its doubled area does.
//
// The metric S of the second surface, at the centre of the image, makes I of the edges e by e^T S e, and its area factor
// makes d of the determinant of the corners: so E is infinite exactly where a face turns over on the sphere, as all
// energies of the package are.
//
// The gradient has the change of the metric along with the centre. Without it each face would be content where it is, and
// no limb would ever slide to where it belongs. The Hessian leaves it out.
//
// A goal adds the squared distance from it, and features the squares of their differences, each times a weight.
class Target_star
{
public:
  explicit Target_star(const Target_metric& metric)
    : m_metric(metric)
  {}

  // Takes the star of a vertex, without a goal or features, to be seen at a level of the metric.
  void load(const Star_view<double>& star, const Vector_3d* positions, std::size_t level)
  {
    m_level = level;
    m_center = star.center(positions);
    m_frame = Tangent_frame(m_center);
    m_faces.resize(star.size());
    m_squared_shortest_edge = (std::numeric_limits<double>::max)();
    for(std::size_t j = 0; j < star.size(); ++j)
    {
      Face& f = m_faces[j];
      f.p = star.neighbor(j, positions);
      f.q = star.neighbor(j + 1 < star.size() ? j + 1 : 0, positions);
      f.normal = cross(f.p, f.q);
      f.rest = star.rest(j);
      m_squared_shortest_edge = (std::min)(m_squared_shortest_edge, squared_length(f.p - m_center));
    }
    m_goal = nullptr;
    m_features = nullptr;
  }

  double area() const
  {
    double result = 0.;
    for(const Face& f : m_faces)
      result += 0.5 / f.rest.inverse_doubled_area;
    return result;
  }

  double squared_shortest_edge() const { return m_squared_shortest_edge; }
  double shortest_edge() const { return std::sqrt(m_squared_shortest_edge); }

  double derivatives(std::array<double, 2>& gradient, std::array<double, 3>& hessian) const
  {
    const Vector_3d t1 = m_frame.vector_of(1., 0.), t2 = m_frame.vector_of(0., 1.);
    double value = 0.;
    gradient = {0., 0.};
    hessian = {0., 0., 0.};
    for(const Face& f : m_faces)
    {
      const Vector_3d e0 = f.q - f.p, e1 = m_center - f.q, e2 = f.p - m_center;
      const Cube_place place = m_metric.place(m_center + f.p + f.q, m_level);
      const auto a0 = place.flattened(e0), a1 = place.flattened(e1), a2 = place.flattened(e2), u1 = place.flattened(t1),
                 u2 = place.flattened(t2);
      // The metric changes with the sum of the corners.
      const Metric_sample s = m_metric.mixed(place, m_level, place.weights()),
                          s1 = m_metric.mixed(place, m_level, place.change_of_weights(u1)),
                          s2 = m_metric.mixed(place, m_level, place.change_of_weights(u2));
      const double o0 = f.rest.opposite_0, o1 = f.rest.opposite_1, o2 = f.rest.opposite_2;
      const double inverse_area = f.rest.inverse_doubled_area;
      const std::array<double, 3> products = {o0 * a0[0] * a0[0] + o1 * a1[0] * a1[0] + o2 * a2[0] * a2[0],
                                              o0 * a0[0] * a0[1] + o1 * a1[0] * a1[1] + o2 * a2[0] * a2[1],
                                              o0 * a0[1] * a0[1] + o1 * a1[1] * a1[1] + o2 * a2[1] * a2[1]};
      const auto dirichlet = [&](const Metric_sample& g) {
        return products[0] * g.numbers[0] + 2. * products[1] * g.numbers[1] + products[2] * g.numbers[2];
      };
      const double i = dirichlet(s), volume = dot(m_center, f.normal), to_d = inverse_area * s.area(),
                   d = to_d * volume;
      // So does how edges are flattened; those next to the vertex change with it as well.
      const double h0 = -o0 * place.height(e0), h1 = o1 * (1. - place.height(e1)), h2 = -o2 * (1. + place.height(e2));
      const std::array<double, 2> pull = {h0 * a0[0] + h1 * a1[0] + h2 * a2[0], h0 * a0[1] + h1 * a1[1] + h2 * a2[1]};
      const double ix = 2. * s.product(pull, u1) + dirichlet(s1);
      const double iy = 2. * s.product(pull, u2) + dirichlet(s2);
      const double dx = to_d * dot(t1, f.normal) + inverse_area * volume * s1.area();
      const double dy = to_d * dot(t2, f.normal) + inverse_area * volume * s2.area();
      const double o = 2. * (o1 + o2);
      const double ixx = o * s.product(u1, u1), ixy = o * s.product(u1, u2), iyy = o * s.product(u2, u2);
      const Energy_derivatives_3<double> e = m_energy.derivatives(i, d);
      const double w = 1. / inverse_area;
      value += w * e.value;
      gradient[0] += w * (e.i * ix + e.d * dx);
      gradient[1] += w * (e.i * iy + e.d * dy);
      hessian[0] += w * (e.i * ixx - e.d * d + 2. * e.id * ix * dx + e.dd * dx * dx);
      hessian[1] += w * (e.i * ixy + e.id * (ix * dy + iy * dx) + e.dd * dx * dy);
      hessian[2] += w * (e.i * iyy - e.d * d + 2. * e.id * iy * dy + e.dd * dy * dy);
    }
    if(m_features)
    {
      std::array<double, 2> g;
      std::array<double, 3> h;
      value += m_feature_weight * m_features->squared_difference(m_center, m_feature_values, t1, t2, g, h);
      for(std::size_t i = 0; i < 2; ++i)
        gradient[i] += 2. * m_feature_weight * g[i];
      for(std::size_t i = 0; i < 3; ++i)
        hessian[i] += 2. * m_feature_weight * h[i];
    }
    if(m_goal)
    {
      const Vector_3d offset = m_center - *m_goal;
      value += m_goal_weight * squared_length(offset);
      gradient[0] += 2. * m_goal_weight * dot(offset, t1);
      gradient[1] += 2. * m_goal_weight * dot(offset, t2);
      const double curvature = 2. * m_goal_weight * (std::max)(dot(m_center, *m_goal), 0.1); // > 0 a quarter turn away
      hessian[0] += curvature;
      hessian[2] += curvature;
    }
    return value;
  }

  double operator()(double x, double y) const
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if(!(x * x + y * y < max_squared_step))
      return infinite;
    const Vector_3d center = m_frame.point_at(x, y);
    double value = 0.;
    for(const Face& f : m_faces)
    {
      const Vector_3d e1 = center - f.q, e2 = f.p - center;
      const double volume = dot(center, f.normal);
      if(!is_safely_positive(volume, squared_length(e1) + squared_length(e2)))
        return infinite;
      const Cube_place place = m_metric.place(center + f.p + f.q, m_level);
      const Metric_sample s = m_metric.mixed(place, m_level, place.weights());
      const auto a0 = place.flattened(f.q - f.p), a1 = place.flattened(e1), a2 = place.flattened(e2);
      const double inverse_area = f.rest.inverse_doubled_area;
      const double i = f.rest.opposite_0 * s.product(a0, a0) + f.rest.opposite_1 * s.product(a1, a1) +
                       f.rest.opposite_2 * s.product(a2, a2);
      value += m_energy(i, inverse_area * volume * s.area()) / inverse_area;
    }
    if(m_features)
      value += m_feature_weight * m_features->squared_difference(center, m_feature_values);
    if(m_goal)
      value += m_goal_weight * squared_length(center - *m_goal);
    return value;
  }

  double at(const Vector_3d& q) const
  {
    if(!(dot(q, m_center) > 0.)) // The coordinates of the other half are the same.
      return std::numeric_limits<double>::infinity();
    const Vector_3d offset = m_frame.offset_of(q);
    return (*this)(offset[0], offset[1]);
  }

  // The goal has to last as long as the star.
  void set_goal(const Vector_3d* goal, double weight)
  {
    m_goal = goal;
    m_goal_weight = weight;
  }

  // The features of the second surface, and their values at the vertex; both have to last as long as the star.
  void set_features(const Sphere_image* features, const double* values, double weight)
  {
    m_features = features;
    m_feature_values = values;
    m_feature_weight = weight;
  }

  Vector_3d point_at(double x, double y) const { return m_frame.point_at(x, y); }

private:
  static constexpr double max_squared_step = 0.75; // as Star_energy has it

  struct Face
  {
    Vector_3d p, q, normal; // the other two corners, and their cross product
    Rest_triangle rest;
  };

  const Target_metric& m_metric;
  Two_way_energy m_energy;
  std::size_t m_level = 0;
  Vector_3d m_center = {0., 0., 1.};
  Tangent_frame m_frame = Tangent_frame({0., 0., 1.});
  double m_squared_shortest_edge = 0.;
  std::vector<Face> m_faces;
  const Vector_3d* m_goal = nullptr;
  double m_goal_weight = 0.;
  const Sphere_image* m_features = nullptr;
  const double* m_feature_values = nullptr;
  double m_feature_weight = 0.;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_STAR_H
