// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_POINT_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_POINT_MAP_H

#include "Copy_constructible.h"

#include <boost/property_map/property_map.hpp>

namespace archetypes {

// ReadablePropertyMap: it is copied and read, and nothing else.
template <class Mesh, class VertexDescriptor, class Point>
class Vertex_point_map : public Copy_constructible
{
public:
  using key_type = VertexDescriptor;
  using value_type = Point;
  using reference = Point; // a new one each time, as of a map that computes them
  using category = boost::readable_property_map_tag;

  explicit Vertex_point_map(const Mesh& mesh)
    : Copy_constructible(TEST)
    , m_mesh(mesh)
  {}

  friend Point get(const Vertex_point_map& map, const VertexDescriptor& vertex) { return map.m_mesh.point(vertex); }

private:
  const Mesh& m_mesh;
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_POINT_MAP_H
