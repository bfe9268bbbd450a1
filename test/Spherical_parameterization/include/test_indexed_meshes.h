// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_INDEXED_MESHES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_INDEXED_MESHES_H

// The package's own flat meshes from lists of points and triangles, and points in their numbering.

#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>

#include "test_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_indexed_meshes {

using CGAL::Spherical_parameterization::internal::Indexed_mesh;
using test_meshes::Coordinates;
using test_meshes::Triangle_list;

using Index_triangle = std::array<std::uint32_t, 3>;

inline std::vector<Index_triangle> triangles_of(const Triangle_list& list)
{
  std::vector<Index_triangle> result;
  for(const test_meshes::Triangle& t : list.triangles)
  {
    result.push_back(
        {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  }
  return result;
}

inline Indexed_mesh indexed_mesh(const Triangle_list& list)
{
  Indexed_mesh mesh;
  EXPECT_EQ(mesh.assign(list.points, triangles_of(list)), CGAL::Spherical_parameterization::OK);
  return mesh;
}

// Points that are given for the vertices of the list, in the numbering of the mesh that was made from it.
inline std::vector<Coordinates> renumbered(const Indexed_mesh& mesh, const std::vector<Coordinates>& points)
{
  std::vector<Coordinates> result;
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
  {
    result.push_back(points[mesh.original(v)]);
  }
  return result;
}

} // namespace test_indexed_meshes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_INDEXED_MESHES_H
