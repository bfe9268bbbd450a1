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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_METRIC_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_METRIC_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/target/Sphere_image.h>

#include <CGAL/number_type_config.h>

#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The metric of a surface in a direction of its sphere: the length of a tangent vector of the sphere on the surface,
// |J e|^2 = e^T S e with S = J^T J, where J is the derivative of the inverse map, and the area factor.
//
// S ignores the component of a vector along the direction. Hence it has three numbers, and acts on vectors that are flattened into the
// plane of a side of a cube around the sphere, see Cube_location.
template <class FT>
struct Metric_sample
{
  std::array<FT, 4> numbers; // the entries uu, uv and vv of S, and the area factor

  std::array<FT, 2> operator()(const std::array<FT, 2>& e) const
  {
    return {numbers[0] * e[0] + numbers[1] * e[1], numbers[1] * e[0] + numbers[2] * e[1]};
  }
  FT product(const std::array<FT, 2>& e, const std::array<FT, 2>& f) const
  {
    const auto s = (*this)(f);
    return e[0] * s[0] + e[1] * s[1];
  }
  const FT& area() const { return numbers[3]; }
};

// The metric of a surface of area 4 pi, as images on the faces of a cube around the sphere, from fine to coarse. Values are interpolated
// between four nodes, without a search. Unlike the metric itself, they are continuous, except where two sides meet: there, the values
// agree at the nodes, and differ between them by the square of the distance of nodes.
class Target_metric
{
public:
  // For maps of meshes with at most `n_vertices` vertices.
  Target_metric(const Sphere_mesh& images, const std::vector<Vector_3d>& points, std::size_t n_vertices,
                const Execution& execution)
  {
    constexpr std::size_t oversampling = 4; // of the finest image that level_for() selects, which is averaged from it
    const std::size_t max_nodes = oversampling * nodes_per_vertex * n_vertices;
    double area = 0.;
    for(const Linked_triangle& t : images.triangles())
      area += 0.5 * length(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
    const double scale = std::sqrt(4. * CGAL_PI / area);
    std::size_t n = min_size;
    while(6 * n * n < (std::min)(2 * images.triangles().size(), max_nodes) && n < max_size)
      n *= 2;
    const std::vector<Vector_3d> nodes = nodes_of_cube(n);
    const auto locations = images.locate(points_of(nodes), execution);
    Tensor_image image{n, std::vector<Tensor>(nodes.size())};
    // Blocks of 1024 nodes are large enough that the overhead of parallel execution is negligible.
    for_each_in_blocks(execution, 0, nodes.size(), 1024, [&](std::size_t k) {
      const Linked_triangle& t = images.triangles()[locations[k].triangle];
      const std::array<Vector_3d, 3> x = {scale * points[t[0]], scale * points[t[1]], scale * points[t[2]]};
      image.tensors[k] = tensor_of(images.corners(t), x, normalized(nodes[k]));
    });
    for(image = smoothed(image, n, execution);; image = smoothed(image, image.n / 2, execution))
    {
      m_images.push_back(flattened(image));
      if(image.n <= min_size)
        break;
    }
  }

  // The level for a mesh with this number of vertices: a coarser one hides detail that the mesh could follow, a finer one appears as noise,
  // because each face samples one location.
  std::size_t level_for(std::size_t n_vertices) const
  {
    std::size_t level = 0;
    while(level + 1 < m_images.size() && 6 * m_images[level].n * m_images[level].n > nodes_per_vertex * n_vertices)
      ++level;
    return level;
  }

  template <class FT>
  Basic_cube_location<FT> locate(const Vector_3<FT>& p, std::size_t level) const
  {
    return Basic_cube_location<FT>(p, m_images[level].n);
  }

  // The metric at a location of this level.
  template <class FT>
  Metric_sample<FT> at(const Basic_cube_location<FT>& location, std::size_t level) const
  {
    const auto weights = location.weights();
    const auto c = corners(location, level);
    Metric_sample<FT> result;
    for(std::size_t k = 0; k < 4; ++k)
      result.numbers[k] = weights[0] * c[0][k] + weights[1] * c[1][k] + weights[2] * c[2][k] + weights[3] * c[3][k];
    return result;
  }

  // The same, and its derivatives along both sides of the square.
  template <class FT>
  std::array<Metric_sample<FT>, 3> with_slopes_at(const Basic_cube_location<FT>& location, std::size_t level) const
  {
    const auto c = corners(location, level);
    std::array<Metric_sample<FT>, 3> result;
    for(std::size_t k = 0; k < 4; ++k)
    {
      const Bilinear<FT> metric(c[0][k], c[1][k], c[2][k], c[3][k], location.u(), location.v());
      result[0].numbers[k] = metric.value;
      result[1].numbers[k] = metric.along_u;
      result[2].numbers[k] = metric.along_v;
    }
    return result;
  }

private:
  // A vertex of the first surface has 3 to 12 nodes, a few for each of its two faces: the sizes of images differ by a factor of 4. The
  // smallest image, with 96 nodes, suffices for a tetrahedron; the largest, with 6.3 million nodes, takes 100 MB.
  static constexpr std::size_t nodes_per_vertex = 12, min_size = 4, max_size = 1024;

  // The numbers of a Metric_sample, in single precision for memory bandwidth.
  using Texel = std::array<float, 4>;

  struct Image
  {
    std::size_t n; // steps along an edge of the cube
    std::vector<Texel> texels;
  };

  // The numbers of the corners around a location.
  template <class FT>
  std::array<std::array<FT, 4>, 4> corners(const Basic_cube_location<FT>& location, std::size_t level) const
  {
    const std::vector<Texel>& texels = m_images[level].texels;
    const auto corner = [&](std::size_t i) {
      std::array<const float*, Lanes<FT>::width> rows;
      for(std::size_t l = 0; l < rows.size(); ++l)
        rows[l] = texels[location.nodes(l)[i]].data();
      return Lanes<FT>::load_columns(rows);
    };
    return {corner(0), corner(1), corner(2), corner(3)};
  }

  // S in space, which does not depend on the side, for operations across sides: xx, xy, xz, yy, yz, zz, and the area factor.
  using Tensor = std::array<double, 7>;

  struct Tensor_image
  {
    std::size_t n;
    std::vector<Tensor> tensors;

    Tensor at(const Vector_3d& p) const
    {
      const Cube_location location(p, n);
      const auto nodes = location.nodes();
      const auto weights = location.weights();
      Tensor result{};
      for(std::size_t i = 0; i < 4; ++i)
        add(weights[i], tensors[nodes[i]], result);
      return result;
    }
  };

  static void add(double weight, const Tensor& tensor, Tensor& sum)
  {
    for(std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += weight * tensor[k];
  }

  static Image flattened(const Tensor_image& image)
  {
    // The indices for the two coordinates of each side, see Cube_location::point().
    constexpr std::array<std::array<std::size_t, 3>, 3> indices = {{{3, 4, 5}, {5, 2, 0}, {0, 1, 3}}};
    Image result{image.n, {}};
    result.texels.reserve(image.tensors.size());
    Cube_location::for_each_node(image.n, [&](std::size_t side, double, double) {
      const Tensor& s = image.tensors[result.texels.size()];
      const auto& [uu, uv, vv] = indices[side / 2];
      result.texels.push_back(
          {static_cast<float>(s[uu]), static_cast<float>(s[uv]), static_cast<float>(s[vv]), static_cast<float>(s[6])});
    });
    return result;
  }

  // Averages an image over the neighborhoods of the nodes of an image with n steps.
  static Tensor_image smoothed(const Tensor_image& fine, std::size_t n, const Execution& execution)
  {
    Tensor_image result{n, std::vector<Tensor>(Cube_location::number_of_nodes(n))};
    const double h = 2. / static_cast<double>(fine.n);
    for_each_in_blocks(execution, 0, result.tensors.size(), 1024, [&](std::size_t node) {
      const auto [side, u, v] = Cube_location::node(node, n);
      for(int k = -1; k <= 1; ++k)
        for(int l = -1; l <= 1; ++l)
          add((k == 0 ? 0.5 : 0.25) * (l == 0 ? 0.5 : 0.25), fine.at(Cube_location::point(side, u + h * k, v + h * l)),
              result.tensors[node]);
    });
    join_sides(result);
    return result;
  }

  // Replaces the values of nodes that several sides share, on the edges of the cube, by their mean, because each side averages them
  // differently.
  static void join_sides(Tensor_image& image)
  {
    const int n = static_cast<int>(image.n);
    std::vector<std::pair<std::array<int, 3>, std::size_t>> nodes; // with their coordinates on the cube
    std::size_t index = 0;
    for(std::size_t side = 0; side < 6; ++side)
      for(int i = 0; i <= n; ++i)
        for(int j = 0; j <= n; ++j, ++index)
          if(i % n == 0 || j % n == 0)
          {
            std::array<int, 3> coordinates;
            coordinates[side / 2] = side % 2 == 0 ? n : -n;
            coordinates[(side / 2 + 1) % 3] = 2 * i - n;
            coordinates[(side / 2 + 2) % 3] = 2 * j - n;
            nodes.emplace_back(coordinates, index);
          }
    std::sort(nodes.begin(), nodes.end());
    for(std::size_t begin = 0, end; begin < nodes.size(); begin = end)
    {
      for(end = begin; end < nodes.size() && nodes[end].first == nodes[begin].first; ++end)
        ;
      Tensor mean{};
      for(std::size_t k = begin; k < end; ++k)
        add(1. / static_cast<double>(end - begin), image.tensors[nodes[k].second], mean);
      for(std::size_t k = begin; k < end; ++k)
        image.tensors[nodes[k].second] = mean;
    }
  }

  // The tensor in the direction q, for the triangle x of the surface and its image p.
  static Tensor tensor_of(const std::array<Vector_3d, 3>& p, const std::array<Vector_3d, 3>& x, const Vector_3d& q)
  {
    std::array<Vector_3d, 3> l = {cross(p[1], p[2]), cross(p[2], p[0]), cross(p[0], p[1])};
    const double determinant = dot(p[0], l[0]);
    double sum = 0.;
    Vector_3d point = {0., 0., 0.};
    for(std::size_t i = 0; i < 3; ++i)
    {
      l[i] = (1. / determinant) * l[i];
      sum += dot(l[i], q);
      point = point + dot(l[i], q) * x[i];
    }
    point = (1. / sum) * point;
    // J = sum over i of (x_i - x) l_i^T / sum
    std::array<Vector_3d, 3> rows = {Vector_3d{0., 0., 0.}, Vector_3d{0., 0., 0.}, Vector_3d{0., 0., 0.}};
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t r = 0; r < 3; ++r)
        rows[r] = rows[r] + ((x[i][r] - point[r]) / sum) * l[i];
    Tensor s{};
    for(const Vector_3d& r : rows)
      for(std::size_t i = 0, k = 0; i < 3; ++i)
        for(std::size_t j = i; j < 3; ++j, ++k)
          s[k] += r[i] * r[j];
    s[6] = std::sqrt((std::max)(s[0] * s[3] - s[1] * s[1] + s[0] * s[5] - s[2] * s[2] + s[3] * s[5] - s[4] * s[4], 0.));
    return s;
  }

  std::vector<Image> m_images;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_TARGET_TARGET_METRIC_H
