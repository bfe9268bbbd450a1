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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_GEOMETRY_IMAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_GEOMETRY_IMAGE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Subdivided_solid.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/add_triangles.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The vertex of a domain that each pixel of a geometry image represents: for an octahedron that is unfolded to a square, or for
// the faces of a cube, one below the other.
struct Geometry_image_layout
{
  std::size_t width, height;
  std::vector<std::uint32_t> vertices; // of the pixels, row by row
  std::size_t number_of_vertices;      // of the domain
  std::vector<std::array<std::uint32_t, 3>> triangles;

  // The upper half of the octahedron is at the center of the square. Each of the four lower faces is unfolded along the edge that
  // it shares with the upper half, so vertices on its other edges are represented by two or four pixels.
  static Geometry_image_layout of_octahedron(std::uint32_t n)
  {
    Subdivided_solid<3> solid = subdivided_octahedron(n);
    const std::size_t width = 2 * std::size_t(n) + 1;
    std::vector<std::uint32_t> vertices(width * width);
    auto v = solid.rows.begin();
    for(const auto& face : octahedron_faces)
      for(int j = 0, m = static_cast<int>(n); j <= m; ++j)
        for(int i = 0; i <= m - j; ++i)
        {
          const std::array<int, 3> parts = {m - i - j, i, j}; // of the corners
          std::array<int, 3> sizes = {0, 0, 0}, signs = {0, 0, 0};
          for(std::size_t k = 0; k < 3; ++k)
          {
            sizes[face[k] % 3] = parts[k];
            signs[face[k] % 3] = face[k] < 3 ? 1 : -1;
          }
          const bool is_upper = signs[2] > 0;
          const int column = m + signs[0] * (is_upper ? sizes[0] : m - sizes[1]),
                    row = m + signs[1] * (is_upper ? sizes[1] : m - sizes[0]);
          vertices[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] = *v++;
        }
    return {width, width, std::move(vertices), solid.directions.size(), std::move(solid.triangles)};
  }

  static Geometry_image_layout of_cube(std::uint32_t n)
  {
    Subdivided_solid<4> solid = subdivided_cube(n);
    const std::size_t width = std::size_t(n) + 1;
    return {width, 6 * width, std::move(solid.rows), solid.directions.size(), std::move(solid.triangles)};
  }

  // The layout for the mesh over an octahedron or a cube with this number of vertices, if any.
  static std::optional<Geometry_image_layout> of_vertices(std::size_t n_vertices)
  {
    for(const std::size_t factor : {4u, 6u})
    {
      const auto n = n_vertices < 2 ? 0 : std::llround(std::sqrt(static_cast<double>((n_vertices - 2) / factor)));
      const auto m = static_cast<std::uint32_t>(n);
      if(n > 0 && n <= Sphere_domain_3::max_subdivision && factor * m * m + 2 == n_vertices)
        return factor == 4 ? of_octahedron(m) : of_cube(m);
    }
    return std::nullopt;
  }

  // Whether geometry images have this size.
  static bool is_size(std::size_t width, std::size_t height)
  {
    return height == width ? width >= 3 && width % 2 == 1 && width / 2 <= Sphere_domain_3::max_subdivision
                           : height == 6 * width && width >= 2 && width - 1 <= Sphere_domain_3::max_subdivision;
  }

  static std::optional<Geometry_image_layout> of_size(std::size_t width, std::size_t height)
  {
    if(!is_size(width, height))
      return std::nullopt;
    return height == width ? of_octahedron(static_cast<std::uint32_t>(width / 2))
                           : of_cube(static_cast<std::uint32_t>(width - 1));
  }
};

// The values of the pixels of an image, row by row, with one or three components each.
struct Geometry_image
{
  std::size_t width = 0, height = 0, number_of_components = 3;
  std::vector<double> values;
};

// Computes the image of a property of the vertices of a mesh.
template <class TriangleMesh, class VertexMap>
Error_code make_geometry_image(const TriangleMesh& tmesh, const VertexMap& map, Geometry_image& image)
{
  constexpr std::size_t n_components =
      std::is_arithmetic<typename boost::property_traits<VertexMap>::value_type>::value ? 1 : 3;
  std::vector<std::array<double, n_components>> values;
  for(const auto v : vertices(tmesh))
    if constexpr(n_components == 1)
      values.push_back({static_cast<double>(get(map, v))});
    else
      values.push_back(rounded(get(map, v)));
  const auto layout = Geometry_image_layout::of_vertices(values.size());
  if(!layout)
    return ERROR_NO_GEOMETRY_IMAGE_MESH;
  image = {layout->width, layout->height, n_components, {}};
  for(const std::uint32_t v : layout->vertices)
    for(const double x : values[v])
    {
      if(!is_finite(x))
        return ERROR_NON_FINITE_COORDINATE;
      image.values.push_back(x);
    }
  return OK;
}

// Adds the mesh whose points an image represents.
template <class TriangleMesh>
Error_code add_mesh_of_geometry_image(const Geometry_image& image, TriangleMesh& tmesh)
{
  const auto layout = Geometry_image_layout::of_size(image.width, image.height);
  if(!layout || image.number_of_components != 3)
    return ERROR_INVALID_IMAGE_SIZE;
  std::vector<const double*> pixels(layout->number_of_vertices, nullptr); // one for each vertex
  for(std::size_t k = 0; k < layout->vertices.size(); ++k)
  {
    const double*& pixel = pixels[layout->vertices[k]];
    if(!pixel)
      pixel = &image.values[3 * k];
    for(std::size_t i = 0; i < 3; ++i)
    {
      if(!is_finite(image.values[3 * k + i]))
        return ERROR_NON_FINITE_COORDINATE;
      if(image.values[3 * k + i] != pixel[i])
        return ERROR_NON_MATCHING_BOUNDARY;
    }
  }
  add_triangles(link_triangles(layout->triangles, pixels.size()), pixels.size(), tmesh,
                [&](const auto& new_vertices, const auto&) {
                  write_vectors(get(vertex_point, tmesh), new_vertices, [&](std::size_t v) { return pixels[v]; });
                });
  return OK;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_GEOMETRY_IMAGE_H
