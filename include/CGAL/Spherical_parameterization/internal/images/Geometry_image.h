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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGES_GEOMETRY_IMAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGES_GEOMETRY_IMAGE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/surface/Added_triangles.h>
#include <CGAL/Spherical_parameterization/internal/images/Geometry_image_layout.h>
#include <CGAL/Spherical_parameterization/internal/surface/link_triangles.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The values of the pixels of an image, row by row, each with one component or with three.
struct Geometry_image
{
  std::size_t width = 0, height = 0, number_of_components = 3;
  std::vector<double> values;
};

// Makes the image of a property of the vertices of a mesh.
template <class TriangleMesh, class VertexMap>
Error_code make_geometry_image(const TriangleMesh& tmesh, const VertexMap& map, Geometry_image& image)
{
  using Value = typename boost::property_traits<VertexMap>::value_type;
  constexpr bool is_number = std::is_arithmetic<Value>::value;
  const std::optional<Geometry_image_layout> layout =
      Geometry_image_layout::of_vertices(static_cast<std::size_t>(num_vertices(tmesh)));
  if(!layout)
    return ERROR_NO_GEOMETRY_IMAGE_MESH;
  std::vector<std::array<double, is_number ? 1 : 3>> values;
  for(const auto v : vertices(tmesh))
  {
    const auto& value = get(map, v);
    if constexpr(is_number)
      values.push_back({static_cast<double>(value)});
    else
      values.push_back({CGAL::to_double(value.x()), CGAL::to_double(value.y()), CGAL::to_double(value.z())});
    for(const double x : values.back())
      if(!is_finite(x))
        return ERROR_NON_FINITE_COORDINATE;
  }
  image = {layout->width(), layout->height(), is_number ? 1u : 3u, {}};
  for(const std::uint32_t v : layout->vertices())
    image.values.insert(image.values.end(), values[v].begin(), values[v].end());
  return OK;
}

// Adds the mesh whose points an image shows.
template <class TriangleMesh>
Error_code add_mesh_of_geometry_image(const Geometry_image& image, TriangleMesh& tmesh)
{
  const std::optional<Geometry_image_layout> layout = Geometry_image_layout::of_size(image.width, image.height);
  if(!layout || image.number_of_components != 3)
    return ERROR_INVALID_IMAGE_SIZE;
  const Sphere_domain_3 domain = layout->domain();
  std::vector<std::size_t> pixels(domain.directions().size(), layout->vertices().size()); // one for each vertex
  for(std::size_t k = 0; k < layout->vertices().size(); ++k)
  {
    std::size_t& pixel = pixels[layout->vertices()[k]];
    if(pixel == layout->vertices().size())
      pixel = k;
    for(std::size_t i = 0; i < 3; ++i)
    {
      if(!is_finite(image.values[3 * k + i]))
        return ERROR_NON_FINITE_COORDINATE;
      if(image.values[3 * k + i] != image.values[3 * pixel + i])
        return ERROR_NON_MATCHING_BOUNDARY;
    }
  }
  const Added_triangles<TriangleMesh> added(link_triangles(domain.triangles(), pixels.size()), pixels.size(), tmesh);
  const auto points = get(vertex_point, tmesh);
  using Point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  using FT = typename Kernel_traits<Point>::Kernel::FT;
  for(std::size_t v = 0; v < pixels.size(); ++v)
  {
    const double* const p = &image.values[3 * pixels[v]];
    put(points, added.vertices[v], Point(static_cast<FT>(p[0]), static_cast<FT>(p[1]), static_cast<FT>(p[2])));
  }
  return OK;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGES_GEOMETRY_IMAGE_H
