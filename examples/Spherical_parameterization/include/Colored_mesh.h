// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_COLORED_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_COLORED_MESH_H

#include "Color_map.h"
#include "Polygon_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <vector>

namespace Program {

/// A mesh with a distortion per face, shown as a colour per vertex: what all viewers of PLY files understand.
class Colored_mesh
{
public:
  using Triangle = std::array<std::size_t, 3>;

  /// gives each vertex the average of its faces. The colours range from `least` to a value that is exceeded by one vertex in
  /// a hundred, because a single bad face would hide all others.
  ///
  /// \param distortions one for each face, at least `least`; those that are infinite are left out
  Colored_mesh(std::size_t number_of_vertices, const std::vector<Triangle>& triangles,
               const std::vector<double>& distortions, double least)
    : m_triangles(triangles)
    , m_values(number_of_vertices, 0.)
    , m_least(least)
  {
    std::vector<int> counts(number_of_vertices, 0);
    for(std::size_t f = 0; f < triangles.size(); ++f)
      if(std::isfinite(distortions[f]))
        for(const std::size_t v : triangles[f])
        {
          m_values[v] += distortions[f];
          ++counts[v];
        }
    std::vector<double> known;
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      if(counts[v] > 0)
      {
        m_values[v] /= counts[v];
        known.push_back(m_values[v]);
      }
    m_largest = smallest_range * least;
    if(known.empty())
      return;
    const std::size_t rank = static_cast<std::size_t>(quantile * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(rank), known.end());
    m_largest = (std::max)(m_largest, known[rank]);
  }

  /// returns the distortion with the darkest colour.
  double least() const { return m_least; }

  /// returns the distortion with the lightest colour, which larger ones have as well.
  double largest() const { return m_largest; }

  /// writes a PLY file with the vertices at `points`. The distortion is there as a number, too, as MeshLab's "quality".
  void write(std::ostream& out, const std::vector<Point_3>& points) const
  {
    constexpr int digits_of_points = 17, digits_of_values = 6;

    out << "ply\nformat ascii 1.0\nelement vertex " << points.size()
        << "\nproperty double x\nproperty double y\nproperty double z"
           "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\nelement face "
        << m_triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for(std::size_t v = 0; v < points.size(); ++v)
    {
      const std::array<int, 3> color =
          m_values[v] > 0. ? color_of((m_values[v] - m_least) / (m_largest - m_least)) : grey;
      out.precision(digits_of_points);
      out << points[v].x() << ' ' << points[v].y() << ' ' << points[v].z() << ' ';
      out.precision(digits_of_values);
      out << color[0] << ' ' << color[1] << ' ' << color[2] << ' ' << m_values[v] << '\n';
    }
    for(const Triangle& t : m_triangles)
      out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }

private:
  static constexpr double quantile = 0.99;
  static constexpr double smallest_range = 1.01;
  static constexpr std::array<int, 3> grey = {128, 128, 128}; // of vertices without a distortion

  const std::vector<Triangle>& m_triangles;
  std::vector<double> m_values; // 0 where there is none
  double m_least, m_largest;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_COLORED_MESH_H
