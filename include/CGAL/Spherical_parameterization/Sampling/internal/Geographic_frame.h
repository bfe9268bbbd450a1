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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_GEOGRAPHIC_FRAME_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_GEOGRAPHIC_FRAME_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/Spherical_parameterization/internal/numbers/nearest_double.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Longitude and latitude with respect to a north pole and a zero meridian. The plane of both consists of the zero meridian, the
// seam on the opposite side of the sphere, and the poles. The side of the plane on which a point lies, and the points where edges
// meet the plane, are determined exactly for the given points and directions. `K` is a kernel of Exact_predicates_kernel.
template <class K>
class Geographic_frame
{
  using FT = typename K::FT;
  using Exact_FT = std::conditional_t<std::is_same<FT, double>::value, Exact_rational, FT>;

public:
  using Point_3 = typename K::Point_3;

  // East and west of the zero meridian, by less than a half-turn.
  enum class Triangle_location
  {
    east,
    west,
    zero_meridian,
    seam,
    north_pole,
    south_pole
  };

  static bool is_pole(Triangle_location place)
  {
    return place == Triangle_location::north_pole || place == Triangle_location::south_pole;
  }

  // The position of a point with respect to the frame.
  struct Site
  {
    Triangle_location place = Triangle_location::seam;
    double u = 0., v = 0.; // longitude and latitude from 0 to 1; u is not used at the seam and at the poles
    Vector_3d direction = {0., 0., 0.}; // of length 1; in the axes towards the zero meridian, east and north
    double distance = 0.;               // from the origin
  };

  // A point on an edge.
  struct Crossing
  {
    double share; // the fraction of the length of the edge on the surface, from its first end
    Site site;
  };

  // `zero_meridian` is any direction in the half plane of the zero meridian.
  Geographic_frame(const Point_3& north, const Point_3& zero_meridian)
    : m_north(north)
    , m_zero(zero_meridian)
  {
    const Vector_3d n = approximate(north), m = approximate(zero_meridian);
    if(!is_finite(n) || !is_finite(m) || size(n) == 0. || size(m) == 0.)
      return;
    m_axes[2] = normalized(scaled(n));
    const Vector_3d east = cross(m_axes[2], normalized(scaled(m)));
    if(!(length(east) > 0.))
      return;
    m_axes[1] = normalized(east);
    m_axes[0] = cross(m_axes[1], m_axes[2]);
    m_east = Point_3(FT(m_axes[1][0]), FT(m_axes[1][1]), FT(m_axes[1][2]));
    m_is_valid = m_orientation(m_north, m_zero, m_east) == POSITIVE;
  }

  // Whether both directions are finite and not zero, and are not parallel up to rounding error.
  bool is_valid() const { return m_is_valid; }

  const Point_3& north_pole() const { return m_north; }
  Point_3 south_pole() const { return Point_3(-m_north.x(), -m_north.y(), -m_north.z()); }

  Sign orientation(const Point_3& a, const Point_3& b, const Point_3& c) const { return m_orientation(a, b, c); }

  static Vector_3<FT> coordinates(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

  Site site(const Point_3& p) const { return site(place(p), coordinates(p)); }

  // The midpoint of the arc between two points, if the arc does not cross the seam.
  static Crossing middle(const Site& a, const Site& b)
  {
    const Vector_3d d = a.direction + b.direction;
    const double share = 1. / (1. + b.distance / a.distance);
    const bool is_a_on_plane = is_on_plane(a.place), is_b_on_plane = is_on_plane(b.place);
    const Triangle_location place = a.place == b.place                ? a.place
                                    : is_a_on_plane && !is_b_on_plane ? b.place
                                    : is_b_on_plane && !is_a_on_plane ? a.place
                                    : is_a_on_plane
                                        ? (d[0] < 0. ? Triangle_location::seam : Triangle_location::zero_meridian)
                                        : (d[1] < 0. ? Triangle_location::west : Triangle_location::east);
    Crossing result = {share, site(place, normalized(d), share * b.distance * length(d))};
    const Vector_3d& e = result.site.direction;
    constexpr double min_distance = 1e-9; // from a pole; closer to it, rounding errors determine the longitude
    if(has_longitude(a.place) && has_longitude(b.place) && hypotenuse(e[0], e[1]) < min_distance)
      result.site.u = 0.5 * (a.u + b.u);
    return result;
  }

  // The point between the ends of the edge from a to b where it meets the seam or a pole, if any.
  std::optional<Crossing> crossing(const Point_3& a, Triangle_location at_a, const Point_3& b,
                                   Triangle_location at_b) const
  {
    if((at_a == Triangle_location::west && at_b == Triangle_location::east) ||
       (at_a == Triangle_location::zero_meridian && at_b == Triangle_location::seam))
    {
      std::optional<Crossing> result = crossing(b, at_b, a, at_a);
      if(result)
        result->share = 1. - result->share;
      return result;
    }
    if(at_a == Triangle_location::east && at_b == Triangle_location::west)
    {
      // The edge meets the plane in the direction |det(n, m, b)| a + |det(n, m, a)| b.
      const Sign side = m_orientation(a, b, m_north);
      if(side == NEGATIVE)
        return std::nullopt; // the crossing is at the zero meridian
      const Triangle_location place = side == POSITIVE                          ? Triangle_location::seam
                                      : m_orientation(a, b, m_zero) == POSITIVE ? Triangle_location::north_pole
                                                                                : Triangle_location::south_pole;
      return crossing(a, b, cross(exact(m_north), exact(m_zero)), place);
    }
    if(at_a == Triangle_location::seam && at_b == Triangle_location::zero_meridian)
      return crossing(a, b, cross(exact(m_east), exact(m_north)),
                      m_orientation(a, b, m_east) == POSITIVE ? Triangle_location::north_pole
                                                              : Triangle_location::south_pole);
    return std::nullopt;
  }

private:
  static Exact_FT exact(const FT& x)
  {
    if constexpr(std::is_same<FT, double>::value)
      return exact_rational(x);
    else
      return x;
  }
  static Vector_3<Exact_FT> exact(const Point_3& p) { return {exact(p.x()), exact(p.y()), exact(p.z())}; }

  static Vector_3d approximate(const Point_3& p)
  {
    // Lazy numbers that are not finite must not be evaluated.
    return {CGAL::to_interval(p.x()).first, CGAL::to_interval(p.y()).first, CGAL::to_interval(p.z()).first};
  }

  template <class Number>
  static Number size(const Vector_3<Number>& p)
  {
    return (std::max)({CGAL::abs(p[0]), CGAL::abs(p[1]), CGAL::abs(p[2])});
  }

  // The same direction with largest absolute coordinate 1.
  template <class Number>
  static Vector_3d scaled(const Vector_3<Number>& p)
  {
    const Number s = size(p);
    return {nearest_double(Number(p[0] / s)), nearest_double(Number(p[1] / s)), nearest_double(Number(p[2] / s))};
  }

  Triangle_location place(const Point_3& p) const
  {
    const Sign side = m_orientation(m_north, m_zero, p);
    if(side != ZERO)
      return side == POSITIVE ? Triangle_location::east : Triangle_location::west;
    const Sign half = m_orientation(m_north, p, m_east);
    if(half != ZERO)
      return half == POSITIVE ? Triangle_location::zero_meridian : Triangle_location::seam;
    return m_orientation(p, m_zero, m_east) == POSITIVE ? Triangle_location::north_pole : Triangle_location::south_pole;
  }

  static bool has_longitude(Triangle_location place) { return place != Triangle_location::seam && !is_pole(place); }

  static bool is_on_plane(Triangle_location place)
  {
    return place != Triangle_location::east && place != Triangle_location::west;
  }

  template <class Number>
  Site site(Triangle_location place, const Vector_3<Number>& p) const
  {
    const Vector_3d q = scaled(p);
    return site(place, normalized(Vector_3d{dot(q, m_axes[0]), dot(q, m_axes[1]), dot(q, m_axes[2])}),
                nearest_double(size(p)) * length(q));
  }

  // Clamps, so that neither rounding nor the sign of a zero moves a point to the other side of the plane.
  static Site site(Triangle_location place, const Vector_3d& direction, double distance)
  {
    const double x = direction[0], y = direction[1], z = direction[2];
    const double longitude = place == Triangle_location::east   ? arc_tangent((std::max)(0., y), x)
                             : place == Triangle_location::west ? -arc_tangent((std::max)(0., -y), x)
                                                                : 0.;
    const double latitude = place == Triangle_location::north_pole   ? CGAL_PI / 2.
                            : place == Triangle_location::south_pole ? -CGAL_PI / 2.
                                                                     : arc_tangent(z, hypotenuse(x, y));
    return {place, 0.5 + longitude / (2. * CGAL_PI), 0.5 + latitude / CGAL_PI, direction, distance};
  }

  // The crossing of an edge with the plane with this normal. The ends lie on different sides of the plane.
  Crossing crossing(const Point_3& a, const Point_3& b, const Vector_3<Exact_FT>& normal, Triangle_location place) const
  {
    const Vector_3<Exact_FT> p = exact(a), q = exact(b);
    const Exact_FT at_p = dot(normal, p), at_q = dot(normal, q);
    const Exact_FT share = at_p / (at_p - at_q);
    return {nearest_double(share), site(place, p + share * (q - p))};
  }

  Orientation_about_origin_3<K> m_orientation;
  Point_3 m_north, m_zero, m_east; // det(north, zero, east) > 0
  std::array<Vector_3d, 3> m_axes; // orthonormal: towards the zero meridian, east, north
  bool m_is_valid = false;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_GEOGRAPHIC_FRAME_H
