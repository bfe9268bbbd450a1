// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_SPHERE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_SPHERE_MAP_H

#include "Copy_constructible.h"

#include <boost/property_map/property_map.hpp>

#include <map>

namespace archetypes {

// WritablePropertyMap: it is copied and written, and nothing else. What it has got is for the test to look at.
template <class VertexDescriptor, class Point>
class Vertex_sphere_map : public Copy_constructible
{
public:
  using key_type = VertexDescriptor;
  using value_type = Point;
  using reference = void;
  using category = boost::writable_property_map_tag;

  explicit Vertex_sphere_map(std::map<VertexDescriptor, Point>& images)
    : Copy_constructible(TEST)
    , m_images(images)
  {}

  friend void put(const Vertex_sphere_map& map, const VertexDescriptor& vertex, const Point& image)
  {
    map.m_images[vertex] = image;
  }

private:
  std::map<VertexDescriptor, Point>& m_images;
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_VERTEX_SPHERE_MAP_H
