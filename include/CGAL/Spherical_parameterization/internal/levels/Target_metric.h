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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_METRIC_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_METRIC_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The metric of a surface on its sphere: how long a tangent vector of the sphere is on the surface, |J e|^2 = e^T S e with
// S = J^T J, J the derivative of the inverse map, and how large areas are.
struct Metric_sample
{
  std::array<double, 8> numbers; // xx, xy, xz, yy, yz, zz of S, the area, and 0

  Vector_3d operator()(const Vector_3d& e) const
  {
    const auto& s = numbers;
    return {s[0] * e[0] + s[1] * e[1] + s[2] * e[2], s[1] * e[0] + s[3] * e[1] + s[4] * e[2],
            s[2] * e[0] + s[4] * e[1] + s[5] * e[2]};
  }
  double squared_length(const Vector_3d& e) const { return dot(e, (*this)(e)); }
  double area() const { return numbers[6]; }
};

// The metric of a surface, of area 4 pi, as images on the faces of a cube around the sphere, from fine to coarse: a value
// anywhere is interpolated between four nodes, so that it is continuous, unlike the metric itself, and takes no search.
class Target_metric
{
public:
  template <class K>
  Target_metric(const Sphere_triangulation<K>& images, const std::vector<Vector_3d>& points, const Execution& execution)
  {
    double area = 0.;
    for(const Linked_triangle& t : images.triangles())
      area += 0.5 * length(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
    const double scale = std::sqrt(4. * CGAL_PI / area);
    std::size_t n = min_size;
    while(6 * n * n < 2 * images.triangles().size() && n < max_size)
      n *= 2;
    std::vector<typename K::Point_3> directions;
    Cube_place::for_each_node(n, [&](std::size_t side, double u, double v) {
      const Vector_3d p = Cube_place::point(side, u, v);
      directions.emplace_back(p[0], p[1], p[2]);
    });
    const auto places = images.locate(directions, execution);
    Image finest{n, std::vector<Texel>(places.size())};
    // 1024 nodes of parallel work: enough that handing it out costs nothing
    for_each_block(execution, 0, places.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for(std::size_t k = begin; k < end; ++k)
      {
        const Linked_triangle& t = images.triangles()[places[k].triangle];
        const std::array<Vector_3d, 3> x = {scale * points[t[0]], scale * points[t[1]], scale * points[t[2]]};
        const std::array<Vector_3d, 3> p = images.corners(t);
        const auto& q = directions[k];
        finest.samples[k] = texel(sample_of(p, x, normalized(Vector_3d{q.x(), q.y(), q.z()})));
      }
    });
    m_images.push_back(smoothed(finest, n));
    while(m_images.back().n > min_size)
      m_images.push_back(smoothed(m_images.back(), m_images.back().n / 2));
  }

  // The level that a mesh with so many vertices is to see: a coarser one hides what it could follow, a finer one is noise
  // to it, as each of its faces looks at one place.
  std::size_t level_for(std::size_t n_vertices) const
  {
    std::size_t level = 0;
    while(level + 1 < m_images.size() && 6 * m_images[level].n * m_images[level].n > nodes_per_vertex * n_vertices)
      ++level;
    return level;
  }

  Metric_sample at(const Vector_3d& p, std::size_t level) const { return m_images[level].at(p); }

  // The same with the derivatives in two tangential directions.
  Metric_sample at(const Vector_3d& p, std::size_t level, const Vector_3d& t1, const Vector_3d& t2,
                   std::array<Metric_sample, 2>& derivatives) const
  {
    const Image& image = m_images[level];
    const Cube_place place(p, image.n);
    const auto nodes = place.nodes();
    derivatives = {image.mixed(nodes, place.change_of_weights(t1)), image.mixed(nodes, place.change_of_weights(t2))};
    return image.mixed(nodes, place.weights());
  }

private:
  // A vertex of the first surface has 3 to 12 nodes, a few for each of its two faces: images differ by a factor of 4.
  // The least image, of 96 nodes, is for a tetrahedron; the largest, of 6.3 million, takes 200 MB.
  static constexpr std::size_t nodes_per_vertex = 12, min_size = 4, max_size = 1024;

  using Texel = std::array<float, 8>; // the numbers of a Metric_sample

  struct Image
  {
    std::size_t n; // steps along an edge of the cube
    std::vector<Texel> samples;

    Metric_sample mixed(const std::array<std::size_t, 4>& nodes, const std::array<double, 4>& w) const
    {
      const Texel &s0 = samples[nodes[0]], &s1 = samples[nodes[1]], &s2 = samples[nodes[2]], &s3 = samples[nodes[3]];
      Metric_sample result;
      for(std::size_t k = 0; k < 8; ++k)
        result.numbers[k] = w[0] * static_cast<double>(s0[k]) + w[1] * static_cast<double>(s1[k]) +
                            w[2] * static_cast<double>(s2[k]) + w[3] * static_cast<double>(s3[k]);
      return result;
    }

    Metric_sample at(const Vector_3d& p) const
    {
      const Cube_place place(p, n);
      return mixed(place.nodes(), place.weights());
    }
  };

  static Texel texel(const Metric_sample& s)
  {
    Texel result;
    for(std::size_t k = 0; k < 8; ++k)
      result[k] = static_cast<float>(s.numbers[k]);
    return result;
  }

  // Averages over the neighbourhood of each node of an image with n steps.
  static Image smoothed(const Image& fine, std::size_t n)
  {
    Image result{n, {}};
    const double h = 2. / static_cast<double>(fine.n);
    Cube_place::for_each_node(n, [&](std::size_t side, double u, double v) {
      Metric_sample sum{};
      for(int k = -1; k <= 1; ++k)
        for(int l = -1; l <= 1; ++l)
        {
          const double w = (k == 0 ? 0.5 : 0.25) * (l == 0 ? 0.5 : 0.25);
          const Metric_sample s = fine.at(Cube_place::point(side, u + h * k, v + h * l));
          for(std::size_t m = 0; m < 8; ++m)
            sum.numbers[m] += w * s.numbers[m];
        }
      result.samples.push_back(texel(sum));
    });
    join_sides(result);
    return result;
  }

  // Gives the nodes of several sides, on the edges of the cube, their mean: each side has averaged them in its own way.
  static void join_sides(Image& image)
  {
    const int n = static_cast<int>(image.n);
    std::vector<std::pair<std::array<int, 3>, std::size_t>> nodes; // with their places on the cube
    std::size_t index = 0;
    for(std::size_t side = 0; side < 6; ++side)
      for(int i = 0; i <= n; ++i)
        for(int j = 0; j <= n; ++j, ++index)
          if(i % n == 0 || j % n == 0)
          {
            std::array<int, 3> place;
            place[side / 2] = side % 2 == 0 ? n : -n;
            place[(side / 2 + 1) % 3] = 2 * i - n;
            place[(side / 2 + 2) % 3] = 2 * j - n;
            nodes.emplace_back(place, index);
          }
    std::sort(nodes.begin(), nodes.end());
    for(std::size_t begin = 0, end; begin < nodes.size(); begin = end)
    {
      Metric_sample sum{};
      for(end = begin; end < nodes.size() && nodes[end].first == nodes[begin].first; ++end)
        for(std::size_t m = 0; m < 8; ++m)
          sum.numbers[m] += static_cast<double>(image.samples[nodes[end].second][m]);
      for(double& x : sum.numbers)
        x /= static_cast<double>(end - begin);
      for(std::size_t k = begin; k < end; ++k)
        image.samples[nodes[k].second] = texel(sum);
    }
  }

  // at the direction q, for the triangle x of the surface and its image p
  static Metric_sample sample_of(const std::array<Vector_3d, 3>& p, const std::array<Vector_3d, 3>& x,
                                 const Vector_3d& q)
  {
    std::array<Vector_3d, 3> l = {cross(p[1], p[2]), cross(p[2], p[0]), cross(p[0], p[1])};
    const double determinant = dot(p[0], l[0]);
    double sum = 0.;
    Vector_3d place = {0., 0., 0.};
    for(std::size_t i = 0; i < 3; ++i)
    {
      l[i] = (1. / determinant) * l[i];
      sum += dot(l[i], q);
      place = place + dot(l[i], q) * x[i];
    }
    place = (1. / sum) * place;
    // J = sum over i of (x_i - x) l_i^T / sum
    std::array<Vector_3d, 3> rows = {Vector_3d{0., 0., 0.}, Vector_3d{0., 0., 0.}, Vector_3d{0., 0., 0.}};
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t r = 0; r < 3; ++r)
        rows[r] = rows[r] + ((x[i][r] - place[r]) / sum) * l[i];
    Metric_sample result{};
    for(const Vector_3d& r : rows)
      for(std::size_t i = 0, k = 0; i < 3; ++i)
        for(std::size_t j = i; j < 3; ++j, ++k)
          result.numbers[k] += r[i] * r[j];
    const auto& s = result.numbers;
    result.numbers[6] =
        std::sqrt((std::max)(s[0] * s[3] - s[1] * s[1] + s[0] * s[5] - s[2] * s[2] + s[3] * s[5] - s[4] * s[4], 0.));
    return result;
  }

  std::vector<Image> m_images;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_TARGET_METRIC_H
