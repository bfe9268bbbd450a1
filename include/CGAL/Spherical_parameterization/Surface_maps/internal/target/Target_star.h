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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_STAR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_STAR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Target_metric.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>

#include <limits>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The symmetric Dirichlet energy of the map between two surfaces, integrated over both and divided by two:
//
//   E = (1 + d) / 2 (I + I / d^2) / 2
//
// per unit of area of the first surface; 2 where the map is isometric.
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

  template <class FT>
  Energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    const FT e = 1. / d, factor = 0.25 * (1. + d) * (1. + e * e), slope = 0.25 * (1. - e * e - 2. * e * e * e);
    return {factor * i, factor, slope * i, FT(0.), slope, 0.25 * i * (2. * e * e * e + 6. * e * e * e * e)};
  }
};

// The energy of the faces around a vertex of the first surface, as a function of the two tangential coordinates of its image on the sphere
// of the second one: the objective of a Newton_step. Faces are weighted with their doubled areas. With a packed number type, one object
// processes as many stars as the type has lanes.
//
// The metric S of the second surface at the center of the image yields I from the terms e^T S e of the edges e, and its area factor yields
// d from the determinant of the corners. Hence E is infinite exactly where a face is inverted on the sphere, like all energies of the
// package.
//
// The gradient includes the change of the metric with the center. Without it, each face would be stationary at its current position, and
// extremities would not move along the surface to their correct positions. The Hessian omits it.
//
// A goal adds the squared distance from it, and features add their squared differences, each with a weight.
template <class FT = double>
class Target_star
{
public:
  // The values of features in each lane.
  using Values = std::array<const double*, Lanes<FT>::width>;

  explicit Target_star(const Target_metric& metric)
    : m_metric(metric)
  {}

  // Loads the star of a vertex, without a goal or features, for a level of the metric.
  void load(const Star_view<FT>& star, const Vector_3d* positions, std::size_t level)
  {
    m_level = level;
    m_center = star.center(positions);
    m_frame = Basic_tangent_frame<FT>(m_center);
    m_size = star.size();
    if(m_faces.size() < m_size)
      m_faces.resize(2 * m_size);
    m_squared_shortest_edge = FT((std::numeric_limits<double>::max)());
    for(std::size_t j = 0; j < m_size; ++j)
    {
      Face& f = m_faces[j];
      f.p = star.neighbor(j, positions);
      f.q = star.neighbor(j + 1 < m_size ? j + 1 : 0, positions);
      f.normal = cross(f.p, f.q);
      f.opposite = {star.opposite_0(j), star.opposite_1(j), star.opposite_2(j)};
      f.inverse_doubled_area = star.inverse_doubled_area(j);
      // The rest shape of a padding row is 0, and so are its energy and its derivatives.
      const auto is_padding = !(f.inverse_doubled_area > 0.);
      f.doubled_area = 1. / select(is_padding, FT(1.), f.inverse_doubled_area);
      f.padding = select(is_padding, FT(1.), FT(0.));
      m_squared_shortest_edge = minimum(m_squared_shortest_edge, squared_length(f.p - m_center));
    }
    m_is_open = 1.;
    m_has_goal = false;
    m_features = nullptr;
  }

  FT area() const
  {
    FT result = 0.;
    for(std::size_t j = 0; j < m_size; ++j)
      result += 0.5 * (1. - m_faces[j].padding) * m_faces[j].doubled_area;
    return result;
  }

  const FT& squared_shortest_edge() const { return m_squared_shortest_edge; }
  FT shortest_edge() const { return square_root(m_squared_shortest_edge); }

  FT derivatives(std::array<FT, 2>& gradient, std::array<FT, 3>& hessian) const
  {
    const Vector_3<FT> t1 = m_frame.vector_of(FT(1.), FT(0.)), t2 = m_frame.vector_of(FT(0.), FT(1.));
    FT value = 0.;
    gradient = {FT(0.), FT(0.)};
    hessian = {FT(0.), FT(0.), FT(0.)};
    for(std::size_t j = 0; j < m_size; ++j)
    {
      const Face& f = m_faces[j];
      const Vector_3<FT> e0 = f.q - f.p, e1 = m_center - f.q, e2 = f.p - m_center;
      const auto location = m_metric.locate(m_center + f.p + f.q, m_level);
      const auto a0 = location.flattened(e0), a1 = location.flattened(e1), a2 = location.flattened(e2),
                 u1 = location.flattened(t1), u2 = location.flattened(t2);
      const auto& [o0, o1, o2] = f.opposite;
      const std::array<FT, 3> products = {o0 * a0[0] * a0[0] + o1 * a1[0] * a1[0] + o2 * a2[0] * a2[0],
                                          o0 * a0[0] * a0[1] + o1 * a1[0] * a1[1] + o2 * a2[0] * a2[1],
                                          o0 * a0[1] * a0[1] + o1 * a1[1] * a1[1] + o2 * a2[1] * a2[1]};
      const auto dirichlet = [&](const Metric_sample<FT>& g) {
        return products[0] * g.numbers[0] + 2. * products[1] * g.numbers[1] + products[2] * g.numbers[2];
      };
      const auto [s, along_u, along_v] = m_metric.with_slopes_at(location, m_level);
      const FT i = dirichlet(s), volume = dot(m_center, f.normal), to_d = f.inverse_doubled_area * s.area(),
               d = to_d * volume + f.padding;
      // The metric depends on the sum of the corners.
      const auto c1 = location.change(u1), c2 = location.change(u2);
      const FT iu = dirichlet(along_u), iv = dirichlet(along_v), to_area = f.inverse_doubled_area * volume;
      // So does the flattening of edges; the edges at the vertex also depend on the vertex itself.
      const FT h0 = -o0 * location.height(e0), h1 = o1 * (1. - location.height(e1)),
               h2 = -o2 * (1. + location.height(e2));
      const std::array<FT, 2> pull = {h0 * a0[0] + h1 * a1[0] + h2 * a2[0], h0 * a0[1] + h1 * a1[1] + h2 * a2[1]};
      const FT ix = 2. * s.product(pull, u1) + (iu * c1[0] + iv * c1[1]);
      const FT iy = 2. * s.product(pull, u2) + (iu * c2[0] + iv * c2[1]);
      const FT dx = to_d * dot(t1, f.normal) + to_area * (along_u.area() * c1[0] + along_v.area() * c1[1]);
      const FT dy = to_d * dot(t2, f.normal) + to_area * (along_u.area() * c2[0] + along_v.area() * c2[1]);
      const FT o = 2. * (o1 + o2);
      const FT ixx = o * s.product(u1, u1), ixy = o * s.product(u1, u2), iyy = o * s.product(u2, u2);
      const Energy_derivatives_3<FT> e = m_energy.derivatives(i, d);
      const FT& w = f.doubled_area;
      value += w * e.value;
      gradient[0] += w * (e.i * ix + e.d * dx);
      gradient[1] += w * (e.i * iy + e.d * dy);
      hessian[0] += w * (e.i * ixx - e.d * d + 2. * e.id * ix * dx + e.dd * dx * dx);
      hessian[1] += w * (e.i * ixy + e.id * (ix * dy + iy * dx) + e.dd * dx * dy);
      hessian[2] += w * (e.i * iyy - e.d * d + 2. * e.id * iy * dy + e.dd * dy * dy);
    }
    if(m_features)
    {
      std::array<FT, 2> g;
      std::array<FT, 3> h;
      const FT difference = m_features->squared_difference(m_center, m_feature_values, t1, t2, g, h);
      const auto add = [&](FT& sum, double factor, const FT& x) {
        sum += select(m_feature_weight > 0., factor * m_feature_weight * x, FT(0.));
      };
      add(value, 1., difference);
      for(std::size_t i = 0; i < 2; ++i)
        add(gradient[i], 2., g[i]);
      for(std::size_t i = 0; i < 3; ++i)
        add(hessian[i], 2., h[i]);
    }
    if(m_has_goal)
    {
      const Vector_3<FT> offset = m_center - m_goal;
      value += m_goal_weight * squared_length(offset);
      gradient[0] += 2. * m_goal_weight * dot(offset, t1);
      gradient[1] += 2. * m_goal_weight * dot(offset, t2);
      // The lower bound keeps it positive at a quarter turn and beyond.
      const FT curvature = 2. * m_goal_weight * maximum(dot(m_center, m_goal), FT(0.1));
      hessian[0] += curvature;
      hessian[2] += curvature;
    }
    gradient = {m_is_open * gradient[0], m_is_open * gradient[1]};
    return value;
  }

  FT operator()(const FT& x, const FT& y) const
  {
    const FT infinite = std::numeric_limits<double>::infinity();
    auto is_valid = x * x + y * y < max_squared_step;
    if(!any(is_valid))
      return infinite;
    const Vector_3<FT> center = m_frame.point_at(x, y);
    FT value = 0.;
    for(std::size_t j = 0; j < m_size; ++j)
    {
      const Face& f = m_faces[j];
      const Vector_3<FT> e1 = center - f.q, e2 = f.p - center;
      const FT volume = dot(center, f.normal);
      is_valid = is_valid && (is_safely_positive(volume, squared_length(e1) + squared_length(e2)) || f.padding > 0.);
      if constexpr(Lanes<FT>::width == 1) // with several lanes, the test costs more than it saves
        if(!is_valid)
          return infinite;
      const auto location = m_metric.locate(center + f.p + f.q, m_level);
      const Metric_sample<FT> s = m_metric.at(location, m_level);
      const auto a0 = location.flattened(f.q - f.p), a1 = location.flattened(e1), a2 = location.flattened(e2);
      const FT i =
          f.opposite[0] * s.product(a0, a0) + f.opposite[1] * s.product(a1, a1) + f.opposite[2] * s.product(a2, a2);
      const FT d = f.inverse_doubled_area * volume * s.area() + f.padding;
      value += f.doubled_area * m_energy(i, select(is_valid, d, FT(1.)));
    }
    if(!any(is_valid))
      return infinite;
    if(m_features)
      value += select(m_feature_weight > 0.,
                      m_feature_weight * m_features->squared_difference(center, m_feature_values), FT(0.));
    if(m_has_goal)
      value += m_goal_weight * squared_length(center - m_goal);
    return select(is_valid, value, infinite);
  }

  FT at(const Vector_3<FT>& q) const
  {
    const Vector_3<FT> offset = m_frame.offset_of(q);
    // Points of the opposite hemisphere have the same coordinates.
    return select(dot(q, m_center) > 0., (*this)(offset[0], offset[1]), FT(std::numeric_limits<double>::infinity()));
  }

  // Sets the gradient to zero in lanes that are not open, so that these vertices do not move.
  void set_open(const std::array<bool, Lanes<FT>::width>& is_open)
  {
    m_is_open = Lanes<FT>::generate([&](std::size_t k) { return is_open[k] ? 1. : 0.; });
  }

  // Sets a goal, which is active where the weight is positive.
  void set_goal(const Vector_3<FT>& goal, const FT& weight)
  {
    m_has_goal = true;
    m_goal = goal;
    m_goal_weight = weight;
  }

  // Sets the features of the second surface, and their values at the vertex, a row of the image. They are active where the weight is
  // positive. All arguments must outlive the star.
  void set_features(const Sphere_image* features, const Values& values, const FT& weight)
  {
    m_features = features;
    m_feature_values = values;
    m_feature_weight = weight;
  }

  Vector_3<FT> point_at(const FT& x, const FT& y) const { return m_frame.point_at(x, y); }

private:
  static constexpr double max_squared_step = 0.75; // the same as in Star_energy

  struct Face
  {
    Vector_3<FT> p, q, normal;  // the other two corners, and their cross product
    std::array<FT, 3> opposite; // see Rest_triangle
    FT inverse_doubled_area, doubled_area;
    FT padding; // 1 beyond the end of the star, where d is set to 1
  };

  const Target_metric& m_metric;
  Two_way_energy m_energy;
  std::size_t m_level = 0, m_size = 0;
  Vector_3<FT> m_center = {FT(0.), FT(0.), FT(1.)};
  Basic_tangent_frame<FT> m_frame = Basic_tangent_frame<FT>({FT(0.), FT(0.), FT(1.)});
  FT m_squared_shortest_edge = 0.;
  std::vector<Face> m_faces;
  FT m_is_open = 1.; // 1 or 0, a factor of the gradient
  bool m_has_goal = false;
  Vector_3<FT> m_goal = {FT(0.), FT(0.), FT(1.)};
  FT m_goal_weight = 0.;
  const Sphere_image* m_features = nullptr;
  Values m_feature_values{};
  FT m_feature_weight = 0.;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_STAR_H
