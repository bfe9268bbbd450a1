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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_OF_FACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_OF_FACES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/measuring/Triangle_stretch.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Maximum, average and standard deviation of a sequence of numbers >= 0, in one pass; all are infinite if a number is, or if
// there is none. The sums are those of Welford, because a difference of the sums of squares has no correct digit left where
// the numbers hardly differ.
class Statistics_accumulator
{
public:
  void add(double x)
  {
    m_maximum = (std::max)(m_maximum, x);
    ++m_size;
    const double difference = x - m_average;
    m_average += difference / static_cast<double>(m_size);
    m_squares += difference * (x - m_average);
  }

  double maximum() const { return m_size > 0 ? m_maximum : std::numeric_limits<double>::infinity(); }
  double average() const { return is_finite(maximum()) ? m_average : maximum(); }
  double deviation() const
  {
    return is_finite(maximum()) ? std::sqrt(m_squares / static_cast<double>(m_size)) : maximum();
  }

private:
  std::size_t m_size = 0;
  double m_maximum = 0.;
  double m_average = 0.;
  double m_squares = 0.; // sum of the squared differences from the average
};

// p - q, computed in the number type of the coordinates if that is exact
template <class Point_3>
Vector_3d difference(const Point_3& p, const Point_3& q)
{
  if constexpr(std::is_arithmetic<std::decay_t<decltype(p.x())>>::value)
  {
    // Differences of float are exact, or more so, in double precision.
    return {static_cast<double>(p.x()) - static_cast<double>(q.x()),
            static_cast<double>(p.y()) - static_cast<double>(q.y()),
            static_cast<double>(p.z()) - static_cast<double>(q.z())};
  }
  else
    return {CGAL::to_double(p.x() - q.x()), CGAL::to_double(p.y() - q.y()), CGAL::to_double(p.z() - q.z())};
}

template <class Point_3>
Triangle_edges triangle_edges(const Point_3& p0, const Point_3& p1, const Point_3& p2)
{
  return {difference(p2, p1), difference(p0, p2), difference(p1, p0)};
}

template <class Point_3>
struct Has_floating_point_coordinates
  : std::is_floating_point<std::decay_t<decltype(std::declval<const Point_3&>().x())>>
{};

// What a map does to a face, see Triangle_stretch.
struct Measured_face
{
  double isometric, area, angle;
  bool is_inverted, is_degenerate;
};

// Measures all faces, in parallel unless numbers are exact: copies of those may share mutable state. `Selection` is
// Exact_predicates_kernel_of_map of the property map of the images.
template <class Selection, class Surface_point_3, class Image_point_3>
std::vector<Measured_face> distortion_of_faces(const std::vector<Surface_point_3>& points,
                                               const std::vector<Image_point_3>& images,
                                               const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                               Execution execution)
{
  constexpr std::size_t block_size = 256;
  constexpr bool may_be_parallel =
      Has_floating_point_coordinates<Surface_point_3>::value && Has_floating_point_coordinates<Image_point_3>::value;
  const Orientation_about_origin_3<typename Selection::type> orientation;
  std::vector<Measured_face> result(triangles.size());
  for_each_block(
      may_be_parallel ? execution : Execution(), 0, result.size(), block_size, [&](std::size_t begin, std::size_t end) {
        for(std::size_t k = begin; k < end; ++k)
        {
          const auto [a, b, c] = triangles[k];
          const Image_point_3 &u = images[a], &v = images[b], &w = images[c];
          const Triangle_stretch stretch(triangle_edges(points[a], points[b], points[c]), triangle_edges(u, v, w));
          const bool is_inverted =
              orientation(Selection::convert(u), Selection::convert(v), Selection::convert(w)) != POSITIVE;
          result[k] = {stretch.isometric(), stretch.area(), stretch.angle(), is_inverted, stretch.is_degenerate()};
        }
      });
  return result;
}

// where measure_distortion() without a property map for faces leaves their values
struct No_face_map
{
  template <class Face, class Distortion>
  friend void put(const No_face_map&, const Face&, const Distortion&)
  {}
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MEASURING_DISTORTION_OF_FACES_H
