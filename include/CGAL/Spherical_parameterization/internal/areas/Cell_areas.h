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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_CELL_AREAS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_CELL_AREAS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The area of the spherical triangle of three points of the unit sphere, negative if it is turned over, as a function of its
// corner x. With the determinant D of the corners and S = 1 + x.p + p.q + q.x, it is 2 atan(D / S). Both follow from differences
// of the corners, so that small triangles keep their relative precision.
class Spherical_area
{
public:
  Spherical_area(const Vector_3d& x, const Vector_3d& p, const Vector_3d& q)
    : m_to_p(p - x)
    , m_to_q(q - x)
    , m_normal(cross(m_to_p, m_to_q))
    , m_determinant(dot(x, m_normal))
    , m_sum(4. - 0.5 * (squared_length(m_to_p) + squared_length(m_to_q) + squared_length(q - p)))
  {}

  double value() const { return 2. * std::atan2(m_determinant, m_sum); }

  // the derivative in x, without its part along x
  Vector_3d gradient(const Vector_3d& x) const
  {
    const Vector_3d of_determinant = cross(x, m_to_q - m_to_p) + m_normal; // p x q
    const Vector_3d of_sum = 2. * x + m_to_p + m_to_q;                     // p + q
    const double factor = 2. / (m_sum * m_sum + m_determinant * m_determinant);
    const Vector_3d result = factor * (m_sum * of_determinant - m_determinant * of_sum);
    return result - dot(result, x) * x;
  }

private:
  Vector_3d m_to_p, m_to_q, m_normal;
  double m_determinant, m_sum;
};

// The areas of the cells of the vertices on the unit sphere, over what is wanted: a third of the areas of their faces.
inline void find_area_ratios(const Vertex_rings& rings, const std::vector<Vector_3d>& positions,
                             const std::vector<double>& wanted, std::vector<double>& ratios)
{
  ratios.assign(positions.size(), 0.);
  rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const double third = Spherical_area(positions[a], positions[b], positions[c]).value() / 3.;
    ratios[a] += third;
    ratios[b] += third;
    ratios[c] += third;
  });
  for(std::size_t v = 0; v < ratios.size(); ++v)
    ratios[v] /= wanted[v];
}

// The standard deviation of numbers over their mean.
inline double relative_deviation(const std::vector<double>& values)
{
  double sum = 0., squares = 0.;
  for(const double x : values)
    sum += x;
  const double mean = sum / static_cast<double>(values.size());
  for(const double x : values)
    squares += (x - mean) * (x - mean);
  return std::sqrt(squares / static_cast<double>(values.size())) / mean;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AREAS_CELL_AREAS_H
