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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_TRIANGLE_SET_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_TRIANGLE_SET_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The squared distance to a triangle, which may degenerate to an edge or a point: to the foot of the perpendicular if it is inside the
// triangle, otherwise to a point on an edge. The foot is computed in coordinates along the longest edge and the height above it,
// which is equally accurate for needles.
inline double squared_distance(const Vector_3d& p, const Vector_3d* t)
{
  double result = (std::numeric_limits<double>::max)(), longest = 0.;
  std::size_t base = 0;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Vector_3d edge = t[(i + 1) % 3] - t[i], d = p - t[i];
    const double square = squared_length(edge);
    const double s = square > 0. ? (std::min)((std::max)(dot(d, edge) / square, 0.), 1.) : 0.;
    result = (std::min)(result, squared_length(d - s * edge));
    if(square > longest)
    {
      longest = square;
      base = i;
    }
  }
  if(!(longest > 0.))
    return result;
  const Vector_3d edge = t[(base + 1) % 3] - t[base], side = t[(base + 2) % 3] - t[base], d = p - t[base];
  const double x_of_apex = dot(side, edge) / longest, x = dot(d, edge) / longest;
  const Vector_3d height = side - x_of_apex * edge, above = d - x * edge;
  const double square = squared_length(height);
  if(!(square > 0.))
    return result;
  const double y = dot(above, height) / square, x_of_base = x - y * x_of_apex;
  if(y >= 0. && x_of_base >= 0. && x_of_base + y <= 1.)
    result = (std::min)(result, squared_length(above - y * height));
  return result;
}

// The triangles of a surface, with evenly distributed sample points, and the distance to the nearest triangle. CGAL::AABB_tree has
// axis-aligned boxes only, see align_with_needles(), and takes up to 2.5 times as long on typical surfaces.
class Triangle_set
{
public:
  // Takes triangles given by their corners, which must be normalized and must outlive this object.
  Triangle_set(const Vector_3d* corners, std::size_t n_corners)
    : m_corners(corners)
    , m_areas(n_corners / 3)
    , m_order(n_corners / 3)
    , m_boxes(n_corners / 3)
  {
    double area = 0.;
    for(std::size_t i = 0; i < m_areas.size(); ++i)
    {
      const Vector_3d* const t = triangle(i);
      m_areas[i] = area += length(cross(t[1] - t[0], t[2] - t[0]));
    }
    if(!(area > 0.))
      std::iota(m_areas.begin(), m_areas.end(), 1.);
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    build(0, m_order.size());
  }

  double diagonal() const
  {
    const Box box = box_of(0, m_order.size(), [](const Vector_3d& p) { return p; });
    return length(box.max - box.min);
  }

  // Sample point k of n: triangles are selected at equal steps of the accumulated area; the point in the triangle is given by the
  // additive recurrence of the plastic number, which has low discrepancy.
  Vector_3d place(std::size_t k, std::size_t n) const
  {
    const double area = (static_cast<double>(k) + 0.5) / static_cast<double>(n) * m_areas.back();
    const auto i = std::lower_bound(m_areas.begin(), m_areas.end() - 1, area) - m_areas.begin();
    const Vector_3d* const t = triangle(static_cast<std::size_t>(i));
    constexpr double plastic_number = 1.32471795724474602596;
    double u = std::fmod(static_cast<double>(k + 1) / plastic_number, 1.);
    double v = std::fmod(static_cast<double>(k + 1) / (plastic_number * plastic_number), 1.);
    if(u + v > 1.)
    {
      u = 1. - u;
      v = 1. - v;
    }
    return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
  }

  double squared_distance_to(const Vector_3d& p) const
  {
    double result = (std::numeric_limits<double>::max)();
    find_nearest(0, m_order.size(), p, result);
    return result;
  }

private:
  using Frame = std::array<Vector_3d, 3>;
  static constexpr double huge = (std::numeric_limits<double>::max)();
  static constexpr std::size_t leaf_size = 4, none = (std::numeric_limits<std::size_t>::max)();

  const Vector_3d* triangle(std::size_t i) const { return m_corners + 3 * i; }

  static Vector_3d in_frame(const Frame& frame, const Vector_3d& p)
  {
    return {dot(frame[0], p), dot(frame[1], p), dot(frame[2], p)};
  }

  struct Box
  {
    Vector_3d min = {huge, huge, huge}, max = {-huge, -huge, -huge}; // empty
    std::size_t frame = none; // the index of its frame; none if it is axis-aligned

    void extend(const Vector_3d& p)
    {
      for(std::size_t i = 0; i < 3; ++i)
      {
        min[i] = (std::min)(min[i], p[i]);
        max[i] = (std::max)(max[i], p[i]);
      }
    }

    // Half of its surface area.
    double area() const
    {
      const Vector_3d size = max - min;
      return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }
  };

  double squared_distance_to(const Box& box, const Vector_3d& p) const
  {
    const Vector_3d q = box.frame == none ? p : in_frame(m_frames[box.frame], p);
    Vector_3d d;
    for(std::size_t i = 0; i < 3; ++i)
      d[i] = (std::max)({box.min[i] - q[i], q[i] - box.max[i], 0.});
    return squared_length(d);
  }

  // A balanced binary tree: ranges of `m_order` are halved while they are longer than `leaf_size`. The index of a box is the middle
  // of its range; these indices are distinct, because no half has less than two elements.
  static std::size_t middle(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }

  // The bounding box of a range, in the coordinates of some frame.
  template <class Coordinates>
  Box box_of(std::size_t begin, std::size_t end, const Coordinates& coordinates) const
  {
    Box box;
    for(std::size_t k = begin; k < end; ++k)
      for(std::size_t i = 0; i < 3; ++i)
        box.extend(coordinates(triangle(m_order[k])[i]));
    return box;
  }

  // Aligns the box of a range of needles with them. The axis-aligned boxes of needles around a vertex overlap nearly everywhere,
  // so that each query would visit most of them.
  void align_with_needles(std::size_t begin, std::size_t end, Box& box)
  {
    // The area of the triangles divided by that of the box; it is larger unless the triangles are needles.
    constexpr double min_filling = 0.1;
    // Exceeds all rounding errors: those of the coordinates of a corner and of a query, 5.2 * 2^-53 each, and those of distances,
    // which are at most 4, because the frame is orthonormal only up to a few units of 2^-53.
    constexpr double tolerance = 0x1p-47;
    double area = 0., longest = 0.;
    Frame frame = {};
    for(std::size_t k = begin; k < end; ++k)
    {
      const Vector_3d* const t = triangle(m_order[k]);
      const Vector_3d normal = cross(t[1] - t[0], t[2] - t[0]);
      area += 0.5 * length(normal);
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Vector_3d edge = t[(i + 1) % 3] - t[i];
        if(squared_length(edge) > longest && length(normal) > 0.)
        {
          longest = squared_length(edge);
          frame[0] = edge;
          frame[2] = normal;
        }
      }
    }
    if(area > min_filling * box.area() || !(longest > 0.))
      return;
    frame[0] = normalized(frame[0]);
    frame[1] = cross(normalized(frame[2]), frame[0]);
    if(!(squared_length(frame[1]) > 0.5)) // the triangle degenerates to an edge up to rounding error
      return;
    frame[1] = normalized(frame[1]);
    frame[2] = cross(frame[0], frame[1]);
    Box laid = box_of(begin, end, [&](const Vector_3d& p) { return in_frame(frame, p); });
    if(laid.area() > 0.5 * box.area())
      return;
    for(std::size_t i = 0; i < 3; ++i)
    {
      laid.min[i] -= tolerance;
      laid.max[i] += tolerance;
    }
    laid.frame = m_frames.size();
    m_frames.push_back(frame);
    box = laid;
  }

  void build(std::size_t begin, std::size_t end)
  {
    Box& box = m_boxes[middle(begin, end)] = box_of(begin, end, [](const Vector_3d& p) { return p; });
    align_with_needles(begin, end, box);
    if(end - begin <= leaf_size)
      return;
    // The range is halved along the axis of largest extent of the centers, not of the boxes: needles around a vertex have equal
    // extents.
    const auto center = [&](std::size_t t) { return triangle(t)[0] + triangle(t)[1] + triangle(t)[2]; };
    Box centers;
    for(std::size_t k = begin; k < end; ++k)
      centers.extend(center(m_order[k]));
    const Vector_3d size = centers.max - centers.min;
    const std::size_t axis = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    std::size_t* const order = m_order.data();
    std::nth_element(order + begin, order + middle(begin, end), order + end,
                     [&](std::size_t s, std::size_t t) { return center(s)[axis] < center(t)[axis]; });
    build(begin, middle(begin, end));
    build(middle(begin, end), end);
  }

  // Reduces `nearest` to the squared distance to the nearest triangle of a range, if that is smaller.
  void find_nearest(std::size_t begin, std::size_t end, const Vector_3d& p, double& nearest) const
  {
    if(end - begin <= leaf_size)
    {
      for(std::size_t k = begin; k < end; ++k)
        nearest = (std::min)(nearest, squared_distance(p, triangle(m_order[k])));
      return;
    }
    const std::size_t m = middle(begin, end);
    const double left = squared_distance_to(m_boxes[middle(begin, m)], p),
                 right = squared_distance_to(m_boxes[middle(m, end)], p);
    if(left <= right && left < nearest)
      find_nearest(begin, m, p, nearest);
    if(right < nearest)
      find_nearest(m, end, p, nearest);
    if(right < left && left < nearest)
      find_nearest(begin, m, p, nearest);
  }

  const Vector_3d* m_corners;
  std::vector<double> m_areas; // accumulated areas of the triangles; accumulated counts if all areas are 0
  std::vector<std::size_t> m_order;
  std::vector<Box> m_boxes;
  std::vector<Frame> m_frames; // of the boxes that are not axis-aligned
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_TRIANGLE_SET_H
