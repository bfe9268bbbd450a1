// The flat meshes that the work is done on: rings, numbering, scaling and refusals of Indexed_mesh, the colouring, and
// the hierarchy of coarser meshes.

#include <CGAL/Spherical_parameterization/internal/Edge_set.h>
#include <CGAL/Spherical_parameterization/internal/Independent_sets.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Mesh_hierarchy.h>

#include "test_indexed_meshes.h"
#include "test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using SP::internal::Edge_set;
using SP::internal::Independent_sets;
using SP::internal::Indexed_mesh;
using SP::internal::Mesh_hierarchy;
using SP::internal::Vector_3d;
using SP::internal::Vertex_rings;
using test_indexed_meshes::Index_triangle;
using test_indexed_meshes::indexed_mesh;
using test_indexed_meshes::triangles_of;
using test_meshes::Triangle_list;

SP::Error_code assign(Indexed_mesh& mesh, const Triangle_list& list)
{
  return mesh.assign(list.points, triangles_of(list));
}

// the triangle with its smallest vertex first
Index_triangle rotated(Index_triangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

std::vector<Index_triangle> sorted(std::vector<Index_triangle> triangles)
{
  for(Index_triangle& t : triangles)
  {
    t = rotated(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

bool have_same_bits(const std::vector<Vector_3d>& a, const std::vector<Vector_3d>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vector_3d)) == 0;
}

bool have_same_rings(const Vertex_rings& a, const Vertex_rings& b)
{
  if(a.number_of_vertices() != b.number_of_vertices())
  {
    return false;
  }
  for(std::size_t v = 0; v < a.number_of_vertices(); ++v)
  {
    const Vertex_rings::Ring r = a.ring(v), s = b.ring(v);
    if(!std::equal(r.begin(), r.end(), s.begin(), s.end()))
    {
      return false;
    }
  }
  return true;
}

// A closed simplicial surface, connected, of genus 0: around each vertex one cycle of different neighbours, consistent
// with the rings of the neighbours.
void expect_simplicial_sphere(const Vertex_rings& rings)
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
  {
    for(std::size_t i = 0; i < 3; ++i)
    {
      ASSERT_TRUE(halfedges.emplace(t[i], t[(i + 1) % 3]).second);
    }
  }
  for(const auto& h : halfedges)
  {
    ASSERT_EQ(halfedges.count({h.second, h.first}), 1u);
  }
  std::vector<char> is_reached(n, 0);
  std::vector<std::uint32_t> front = {0};
  is_reached[0] = 1;
  for(std::size_t k = 0; k < front.size(); ++k)
  {
    for(const std::uint32_t w : rings.ring(front[k]))
    {
      if(!is_reached[w])
      {
        is_reached[w] = 1;
        front.push_back(w);
      }
    }
  }
  ASSERT_EQ(front.size(), n);
}

// A suspension of a polygon of n corners that go up and down.
Triangle_list wavy_suspension(std::size_t n)
{
  Triangle_list list = test_meshes::suspension(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    list.points[i][2] = 0.1 * std::sin(static_cast<double>(i));
  }
  return list;
}

std::vector<std::pair<const char*, Triangle_list>> spheres()
{
  return {{"tetrahedron", test_meshes::tetrahedron()},
          {"octahedron", test_meshes::octahedron()},
          {"icosphere", test_meshes::icosphere(2)},
          {"bumpy sphere", test_meshes::bumpy_sphere(3)},
          {"double pyramid of 3", test_meshes::suspension(3)},
          {"double pyramid of 200", wavy_suspension(200)},
          {"stacked sphere", test_meshes::random_stacked_sphere(500, 1)}};
}

TEST(Indexed_mesh, keeps_the_triangles_and_their_orientation)
{
  for(const auto& sphere : spheres())
  {
    SCOPED_TRACE(sphere.first);
    const Triangle_list& list = sphere.second;
    const Indexed_mesh mesh = indexed_mesh(list);
    ASSERT_EQ(mesh.number_of_vertices(), list.points.size());
    expect_simplicial_sphere(mesh.rings());
    std::vector<Index_triangle> triangles = mesh.triangles();
    for(Index_triangle& t : triangles)
    {
      EXPECT_EQ(t, rotated(t)); // smallest vertex first
      t = {mesh.original(t[0]), mesh.original(t[1]), mesh.original(t[2])};
    }
    EXPECT_EQ(sorted(triangles), sorted(triangles_of(list)));
  }
}

TEST(Indexed_mesh, numbers_the_vertices_by_shape_not_by_order)
{
  const Triangle_list list = test_meshes::bumpy_sphere(3);
  const Indexed_mesh mesh = indexed_mesh(list);
  for(std::uint32_t seed = 1; seed < 6; ++seed)
  {
    const std::vector<std::size_t> number = test_meshes::random_permutation(list.points.size(), seed);
    const Indexed_mesh other = indexed_mesh(test_meshes::renumbered(list, number, seed));
    EXPECT_TRUE(have_same_bits(mesh.points(), other.points()));
    EXPECT_TRUE(have_same_rings(mesh.rings(), other.rings()));
    for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    {
      ASSERT_EQ(other.original(v), number[mesh.original(v)]);
    }
  }
}

TEST(Indexed_mesh, numbers_neighbors_close_to_each_other)
{
  // breadth first: a vertex is met from an earlier one, and the rings of earlier vertices come first
  const Indexed_mesh mesh = indexed_mesh(test_meshes::bumpy_sphere(3));
  std::uint32_t last_parent = 0;
  for(std::uint32_t v = 1; v < mesh.number_of_vertices(); ++v)
  {
    const Vertex_rings::Ring ring = mesh.rings().ring(v);
    const std::uint32_t parent = *std::min_element(ring.begin(), ring.end());
    EXPECT_LT(parent, v);
    EXPECT_GE(parent, last_parent);
    last_parent = parent;
  }
}

double area(const Indexed_mesh& mesh)
{
  double result = 0.;
  for(const Index_triangle& t : mesh.triangles())
  {
    const Vector_3d &a = mesh.points()[t[0]], &b = mesh.points()[t[1]], &c = mesh.points()[t[2]];
    const double e[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, f[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    result += 0.5 * std::hypot(e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]);
  }
  return result;
}

TEST(Indexed_mesh, has_the_area_of_the_unit_sphere)
{
  const double pi = test_meshes::pi;
  for(const double size : {1., 1e-3, 1e7, 1e-200, 1e200, 1e-300, 3e307})
  {
    const Triangle_list list = test_meshes::scaled(test_meshes::octahedron(), size, size, size);
    const Indexed_mesh mesh = indexed_mesh(list);
    EXPECT_NEAR(area(mesh), 4. * pi, 1e-13);
    // eight triangles of sides sqrt(2): area 4 sqrt(3) = 4 pi r^2
    const double radius = std::sqrt(std::sqrt(3.) / pi) * size;
    EXPECT_NEAR(mesh.equal_area_radius() / radius, 1., 1e-14);
    EXPECT_NEAR(mesh.scaled_radius(radius), 1., 1e-14);
    EXPECT_NEAR(mesh.scaled_radius(0.125 * radius), 0.125, 1e-15);
  }
}

TEST(Indexed_mesh, is_the_same_at_any_scale_and_place)
{
  const Triangle_list list = test_meshes::bumpy_sphere(3);
  const Indexed_mesh mesh = indexed_mesh(list);
  for(const int exponent : {-900, -40, -1, 1, 30, 900})
  {
    const double s = std::ldexp(1., exponent);
    const Indexed_mesh other = indexed_mesh(test_meshes::scaled(list, s, s, s));
    EXPECT_TRUE(have_same_bits(mesh.points(), other.points()));
    EXPECT_TRUE(have_same_rings(mesh.rings(), other.rings()));
    EXPECT_EQ(other.equal_area_radius(), s * mesh.equal_area_radius());
  }
  Triangle_list moved = list;
  for(test_meshes::Coordinates& p : moved.points)
  {
    p = {p[0] + 1000., p[1] - 0.3, p[2] + 7.};
  }
  const Indexed_mesh other = indexed_mesh(moved);
  EXPECT_TRUE(have_same_rings(mesh.rings(), other.rings()));
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
  {
    EXPECT_NEAR(
        SP::internal::length({mesh.points()[v][0] - other.points()[v][0], mesh.points()[v][1] - other.points()[v][1],
                              mesh.points()[v][2] - other.points()[v][2]}),
        0., 1e-12);
  }
}

TEST(Indexed_mesh, leaves_out_vertices_without_a_triangle)
{
  Triangle_list list = test_meshes::bumpy_sphere(1);
  const Indexed_mesh mesh = indexed_mesh(list);
  const std::size_t n = list.points.size();
  list.points.insert(list.points.begin(), {0., 0., 0.});
  list.points.push_back({1., 0., 0.});
  for(test_meshes::Triangle& t : list.triangles)
  {
    t = {t[0] + 1, t[1] + 1, t[2] + 1};
  }
  const Indexed_mesh other = indexed_mesh(list);
  ASSERT_EQ(other.number_of_vertices(), n);
  EXPECT_TRUE(have_same_bits(mesh.points(), other.points()));
  for(std::size_t v = 0; v < n; ++v)
  {
    EXPECT_EQ(other.original(v), mesh.original(v) + 1);
  }
}

TEST(Indexed_mesh, counts_flat_faces)
{
  EXPECT_EQ(indexed_mesh(test_meshes::icosphere(2)).number_of_flat_faces(), 0u);
  // A vertex in the middle of an edge of an octahedron: one face of the edge is split, and one without area joins the
  // other.
  Triangle_list list = test_meshes::octahedron();
  list.points.push_back({0.5, 0.5, 0.});
  list.triangles[0] = {0, 6, 4};
  list.triangles.push_back({6, 2, 4});
  list.triangles.push_back({0, 2, 6});
  EXPECT_EQ(indexed_mesh(list).number_of_flat_faces(), 1u);
  // a surface without area
  const Triangle_list segment = test_meshes::scaled(test_meshes::icosphere(1), 1., 0., 0.);
  const Indexed_mesh mesh = indexed_mesh(segment);
  EXPECT_EQ(mesh.number_of_flat_faces(), segment.triangles.size());
  for(const Vector_3d& p : mesh.points())
  {
    EXPECT_TRUE(std::isfinite(p[0] + p[1] + p[2]));
  }
  const Triangle_list point = test_meshes::scaled(test_meshes::icosphere(1), 0., 0., 0.);
  EXPECT_EQ(indexed_mesh(point).number_of_flat_faces(), point.triangles.size());
}

TEST(Indexed_mesh, refuses_what_is_no_sphere)
{
  Indexed_mesh mesh;
  const Triangle_list sphere = test_meshes::icosphere(1);
  EXPECT_EQ(assign(mesh, test_meshes::disjoint_union(sphere, sphere)), SP::ERROR_SEVERAL_COMPONENTS);
  // V - E + F = 2 does not prove a sphere
  const Triangle_list torus = test_meshes::torus(7, 5);
  EXPECT_EQ(assign(mesh, test_meshes::disjoint_union(sphere, torus)), SP::ERROR_SEVERAL_COMPONENTS);
  EXPECT_EQ(assign(mesh, torus), SP::ERROR_NO_TOPOLOGICAL_SPHERE);

  Triangle_list open = sphere;
  open.triangles.pop_back();
  EXPECT_EQ(assign(mesh, open), SP::ERROR_NO_SIMPLICIAL_COMPLEX);
  Triangle_list touching = test_meshes::disjoint_union(sphere, sphere); // two spheres with a vertex in common
  for(test_meshes::Triangle& t : touching.triangles)
  {
    for(std::size_t& v : t)
    {
      v = v == sphere.points.size() ? 0 : v;
    }
  }
  EXPECT_EQ(assign(mesh, touching), SP::ERROR_NO_SIMPLICIAL_COMPLEX);

  EXPECT_EQ(mesh.assign({{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}}, {{0, 1, 2}, {0, 2, 1}}),
            SP::ERROR_TOO_FEW_VERTICES);
  for(const double x : {std::numeric_limits<double>::infinity(), std::nan("")})
  {
    Triangle_list list = sphere;
    list.points[7][2] = x;
    EXPECT_EQ(assign(mesh, list), SP::ERROR_NON_FINITE_COORDINATE);
  }
}

TEST(Independent_sets, are_independent_and_complete)
{
  for(const auto& sphere : spheres())
  {
    SCOPED_TRACE(sphere.first);
    const Indexed_mesh mesh = indexed_mesh(sphere.second);
    const Vertex_rings& rings = mesh.rings();
    const std::size_t n = rings.number_of_vertices();
    const Independent_sets sets(rings);
    ASSERT_EQ(sets.first(0), 0u);
    ASSERT_EQ(sets.first(sets.number_of_sets()), n);
    std::vector<std::size_t> color(n, n);
    for(std::size_t k = 0; k < sets.number_of_sets(); ++k)
    {
      ASSERT_LT(sets.first(k), sets.first(k + 1));
      for(std::size_t slot = sets.first(k); slot < sets.first(k + 1); ++slot)
      {
        const std::uint32_t v = sets.vertices()[slot];
        ASSERT_EQ(color[v], n); // for the first time
        color[v] = k;
        EXPECT_TRUE(slot == sets.first(k) || sets.vertices()[slot - 1] < v);
      }
    }
    for(std::uint32_t v = 0; v < n; ++v)
    {
      for(const std::uint32_t w : rings.ring(v))
      {
        EXPECT_NE(color[v], color[w]);
      }
    }
    EXPECT_LE(sets.number_of_sets(), 12u); // a greedy colouring of a planar graph, hardly ever above 7
  }
}

TEST(Edge_set, has_what_was_inserted_and_grows)
{
  for(const std::size_t expected_size : {std::size_t(0), std::size_t(5000)})
  {
    Edge_set edges(expected_size);
    for(std::uint32_t a = 0; a < 5000; ++a)
    {
      EXPECT_FALSE(edges.contains(a, 3 * a + 1));
      edges.insert(3 * a + 1, a);
    }
    for(std::uint32_t a = 0; a < 5000; ++a)
    {
      EXPECT_TRUE(edges.contains(a, 3 * a + 1));
      EXPECT_TRUE(edges.contains(3 * a + 1, a));
      EXPECT_FALSE(edges.contains(a, 3 * a + 2));
    }
  }
}

void expect_hierarchy(const Indexed_mesh& mesh)
{
  const Mesh_hierarchy hierarchy = Mesh_hierarchy::build<CGAL::Sequential_tag>(mesh.rings(), mesh.points());
  const std::size_t n_levels = hierarchy.number_of_levels();
  ASSERT_GE(n_levels, 1u);
  ASSERT_TRUE(have_same_rings(hierarchy.rings(0), mesh.rings()));
  ASSERT_EQ(hierarchy.level(n_levels - 1).vertices.size(), 4u);
  ASSERT_TRUE(hierarchy.level(n_levels - 1).removed.empty());
  const double total = std::accumulate(hierarchy.level(0).areas.begin(), hierarchy.level(0).areas.end(), 0.);
  ASSERT_NEAR(total, area(mesh), 1e-10);

  std::size_t n_corners = 0; // of all levels
  for(std::size_t k = 0; k < n_levels; ++k)
  {
    SCOPED_TRACE(k);
    const Mesh_hierarchy::Level& level = hierarchy.level(k);
    const std::size_t n = level.vertices.size();
    ASSERT_EQ(hierarchy.rings(k).number_of_vertices(), n);
    ASSERT_EQ(level.areas.size(), n);
    expect_simplicial_sphere(hierarchy.rings(k));
    if(::testing::Test::HasFatalFailure())
    {
      return;
    }
    ASSERT_TRUE(std::is_sorted(level.vertices.begin(), level.vertices.end()));
    ASSERT_NEAR(std::accumulate(level.areas.begin(), level.areas.end(), 0.), total, 1e-9 * total);
    n_corners += hierarchy.rings(k).number_of_corners();
    if(k + 1 == n_levels)
    {
      break;
    }

    const Mesh_hierarchy::Level& coarse = hierarchy.level(k + 1);
    ASSERT_FALSE(level.removed.empty());
    std::vector<char> is_removed(n, 0);
    for(const Mesh_hierarchy::Removed_vertex& r : level.removed)
    {
      ASSERT_LT(r.vertex, n);
      ASSERT_LT(r.target, hierarchy.rings(k).degree(r.vertex));
      ASSERT_FALSE(is_removed[r.vertex]);
      is_removed[r.vertex] = 1;
    }
    std::vector<std::uint32_t> kept;
    std::vector<std::uint32_t> number(n, 0); // in the coarser level
    for(std::uint32_t v = 0; v < n; ++v)
    {
      if(!is_removed[v])
      {
        number[v] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(level.vertices[v]);
      }
    }
    ASSERT_EQ(kept, coarse.vertices);

    // The coarser mesh has the faces without removed vertices and, for each removed one, the fan of its target.
    std::vector<Index_triangle> faces, coarse_faces;
    hierarchy.rings(k).for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      ASSERT_LE(is_removed[a] + is_removed[b] + is_removed[c], 1); // no two of them are neighbours
      if(!is_removed[a] && !is_removed[b] && !is_removed[c])
      {
        faces.push_back({number[a], number[b], number[c]});
      }
    });
    for(const Mesh_hierarchy::Removed_vertex& r : level.removed)
    {
      const Vertex_rings::Ring ring = hierarchy.rings(k).ring(r.vertex);
      for(std::size_t j = 1; j + 1 < ring.size(); ++j)
      {
        faces.push_back({number[ring[r.target]], number[ring[(r.target + j) % ring.size()]],
                         number[ring[(r.target + j + 1) % ring.size()]]});
      }
    }
    hierarchy.rings(k + 1).for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      coarse_faces.push_back({a, b, c});
    });
    ASSERT_EQ(sorted(faces), sorted(coarse_faces));
  }
  // All levels together are a constant times the mesh: they shrink geometrically.
  EXPECT_LE(n_corners, 20 * (mesh.rings().number_of_corners() + 12));
}

TEST(Mesh_hierarchy, leads_to_a_tetrahedron_through_simplicial_spheres)
{
  for(const auto& sphere : spheres())
  {
    SCOPED_TRACE(sphere.first);
    expect_hierarchy(indexed_mesh(sphere.second));
  }
}

TEST(Mesh_hierarchy, copes_with_vertices_of_huge_degree)
{
  const Indexed_mesh mesh = indexed_mesh(wavy_suspension(20000));
  expect_hierarchy(mesh);
  // and when they are flat, or all at one point
  expect_hierarchy(indexed_mesh(test_meshes::scaled(test_meshes::suspension(1000), 1., 1., 0.)));
  expect_hierarchy(indexed_mesh(test_meshes::scaled(test_meshes::suspension(1000), 0., 0., 0.)));
}

TEST(Mesh_hierarchy, copes_with_a_thousand_nested_separating_triangles)
{
  // each vertex is put into a face of the vertex before, so that every removal but the last ones breaks the link
  // condition
  Triangle_list list = test_meshes::tetrahedron();
  std::size_t face = 0;
  for(std::size_t k = 0; k < 1000; ++k)
  {
    const test_meshes::Triangle t = list.triangles[face];
    const std::size_t v = list.points.size();
    const test_meshes::Coordinates a = list.points[t[0]], b = list.points[t[1]], c = list.points[t[2]];
    list.points.push_back({(a[0] + b[0] + c[0]) / 3., (a[1] + b[1] + c[1]) / 3., (a[2] + b[2] + c[2]) / 3.});
    list.triangles[face] = {t[0], t[1], v};
    list.triangles.push_back({t[1], t[2], v});
    list.triangles.push_back({t[2], t[0], v});
    face = list.triangles.size() - 1;
  }
  const Indexed_mesh mesh = indexed_mesh(list);
  expect_hierarchy(mesh);
}

} // namespace
