#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_INDEXED_MESHES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_INDEXED_MESHES_H

// The package's own flat meshes from lists of points and triangles, points in their numbering, and that the rings of a mesh
// are those of a sphere.

#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include "images.h"

#include <gtest/gtest.h>

namespace test {

namespace SP = CGAL::Spherical_parameterization;

using CGAL::Spherical_parameterization::internal::Surface;
using CGAL::Spherical_parameterization::internal::Vertex_rings;

using Index_triangle = std::array<std::uint32_t, 3>;

inline std::vector<Index_triangle> index_triangles(const Triangle_list& list)
{
  std::vector<Index_triangle> result;
  for(const Triangle& t : list.triangles)
    result.push_back(
        {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  return result;
}

inline Surface surface_of(const Triangle_list& list)
{
  Surface mesh;
  EXPECT_EQ(mesh.assign(list.points, SP::internal::link_triangles(index_triangles(list), list.points.size())), SP::OK);
  return mesh;
}

// The numbers of the vertices in the list that the surface was made from.
inline std::vector<std::uint32_t> callers_numbers(const Surface& mesh)
{
  std::vector<std::uint32_t> result(mesh.number_of_vertices());
  std::iota(result.begin(), result.end(), 0u);
  return mesh.in_own_order(result);
}

// the triangle with its smallest vertex first
inline Index_triangle rotated(Index_triangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

inline std::vector<Index_triangle> sorted(std::vector<Index_triangle> triangles)
{
  for(Index_triangle& t : triangles)
    t = rotated(t);
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

inline bool have_same_rings(const Vertex_rings& a, const Vertex_rings& b)
{
  if(a.number_of_vertices() != b.number_of_vertices())
    return false;
  for(std::size_t v = 0; v < a.number_of_vertices(); ++v)
  {
    const Vertex_rings::Ring r = a.ring(v), s = b.ring(v);
    if(!std::equal(r.begin(), r.end(), s.begin(), s.end()))
      return false;
  }
  return true;
}

// A closed simplicial surface with the Euler number of a sphere: around each vertex one cycle of different neighbours, consistent
// with the rings of the neighbours.
inline void expect_simplicial_sphere(const Vertex_rings& rings)
{
  const std::size_t n = rings.number_of_vertices();
  ASSERT_GE(n, 4u);
  std::set<Index_triangle> faces;
  std::size_t n_corners = 0;
  for(std::uint32_t v = 0; v < n; ++v)
  {
    const Vertex_rings::Ring ring = rings.ring(v);
    ASSERT_GE(ring.size(), 3u);
    ASSERT_EQ(ring.size(), rings.degree(v));
    std::vector<std::uint32_t> neighbors(ring.begin(), ring.end());
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      ASSERT_LT(ring[j], n);
      ASSERT_NE(ring[j], v);
      faces.insert(rotated({v, ring[j], ring[(j + 1) % ring.size()]}));
    }
    std::sort(neighbors.begin(), neighbors.end());
    ASSERT_TRUE(std::adjacent_find(neighbors.begin(), neighbors.end()) == neighbors.end()) << "a double edge at " << v;
    n_corners += ring.size();
  }
  // Each face has been seen from its three corners, in the same sense.
  ASSERT_EQ(n_corners, rings.number_of_corners());
  ASSERT_EQ(3 * faces.size(), n_corners);
  ASSERT_EQ(faces.size(), rings.number_of_faces());
  ASSERT_EQ(n + faces.size() - n_corners / 2, 2u); // Euler
  // Every edge has a face on either side.
  std::set<std::pair<std::uint32_t, std::uint32_t>> halfedges;
  for(const Index_triangle& t : faces)
    for(std::size_t i = 0; i < 3; ++i)
      ASSERT_TRUE(halfedges.emplace(t[i], t[(i + 1) % 3]).second);
  for(const auto& h : halfedges)
    ASSERT_EQ(halfedges.count({h.second, h.first}), 1u);
}

// A suspension of a polygon of n corners that go up and down.
inline Triangle_list wavy_suspension(std::size_t n)
{
  Triangle_list list = suspension(n);
  for(std::size_t i = 0; i < n; ++i)
    list.points[i][2] = 0.1 * std::sin(static_cast<double>(i));
  return list;
}

inline std::vector<Triangle_list> spheres()
{
  return {tetrahedron(),
          octahedron(),
          icosphere(2),
          bumpy_sphere(3),
          suspension(3),
          wavy_suspension(200),
          random_stacked_sphere(500, 1)};
}

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_INDEXED_MESHES_H
