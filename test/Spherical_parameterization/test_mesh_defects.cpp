// What find_defect() says about each kind of mesh that cannot be parameterized; that it agrees with parameterize() is
// tested along with the error codes.

#include <CGAL/Spherical_parameterization/find_defect.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include "methods.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

using namespace test;

namespace {

using Vertex_index = Mesh::Vertex_index;
using Defect = SP::Mesh_defect<Mesh>;

Vertex_index vertex(std::size_t i)
{
  return Vertex_index(static_cast<Mesh::size_type>(i));
}

std::set<Vertex_index> ends(const Defect& defect)
{
  return {defect.vertex, defect.other_vertex};
}

// Expects that the message has these words, and advice on a line of its own.
void expect_words(const Defect& defect, const std::vector<std::string>& words)
{
  for(const std::string& word : words)
    EXPECT_NE(defect.message.find(word), std::string::npos) << word << " in: " << defect.message;
  EXPECT_NE(defect.message.find(".\n"), std::string::npos) << defect.message;
}

TEST(Find_defect, finds_none_where_there_is_none)
{
  const Defect defect = SP::find_defect(make(icosphere(1)));
  EXPECT_EQ(defect.error, SP::OK);
  EXPECT_EQ(defect.vertex, Mesh::null_vertex());
  EXPECT_EQ(defect.other_vertex, Mesh::null_vertex());
  EXPECT_EQ(defect.face, Mesh::null_face());
  EXPECT_EQ(defect.count, 0u);
  EXPECT_EQ(defect.message, SP::get_error_message(SP::OK));
}

TEST(Find_defect, counts_vertices_with_a_face)
{
  Mesh pillow;
  const Vertex_index a = pillow.add_vertex(Point_3(0., 0., 0.)), b = pillow.add_vertex(Point_3(1., 0., 0.)),
                     c = pillow.add_vertex(Point_3(0., 1., 0.));
  pillow.add_vertex(Point_3(0., 0., 1.));
  pillow.add_face(a, b, c);
  pillow.add_face(a, c, b);
  const Defect defect = SP::find_defect(pillow);
  EXPECT_EQ(defect.error, SP::ERROR_TOO_FEW_VERTICES);
  EXPECT_EQ(defect.count, 3u);
  expect_words(defect, {"only 3 vertices"});
  EXPECT_EQ(SP::find_defect(Mesh()).error, SP::ERROR_EMPTY_MESH);
}

TEST(Find_defect, names_the_first_polygon)
{
  Mesh cube;
  CGAL::make_hexahedron(Point_3(-1, -1, -1), Point_3(1, -1, -1), Point_3(1, 1, -1), Point_3(-1, 1, -1),
                        Point_3(-1, 1, 1), Point_3(-1, -1, 1), Point_3(1, -1, 1), Point_3(1, 1, 1), cube);
  const Mesh::Face_index first = *cube.faces().begin();
  const Mesh::Halfedge_index h = cube.halfedge(first);
  CGAL::Euler::split_face(h, cube.next(cube.next(h)), cube);
  const Defect defect = SP::find_defect(cube);
  EXPECT_EQ(defect.error, SP::ERROR_NON_TRIANGULAR_MESH);
  EXPECT_EQ(defect.face, *std::next(cube.faces().begin()));
  EXPECT_EQ(defect.count, 5u);
  expect_words(defect, {"face 1 ", "4 corners", "5 such faces"});
}

TEST(Find_defect, names_an_edge_of_the_border)
{
  Triangle_list list = icosphere(1);
  const Triangle t = list.triangles[30];
  list.triangles.erase(list.triangles.begin() + 30);
  const Mesh mesh = make(list);
  const Defect defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::ERROR_NON_CLOSED_MESH);
  EXPECT_EQ(defect.count, 3u);
  const std::set<Vertex_index> corners = {vertex(t[0]), vertex(t[1]), vertex(t[2])};
  EXPECT_TRUE(corners.count(defect.vertex) == 1 && corners.count(defect.other_vertex) == 1);
  EXPECT_NE(defect.vertex, defect.other_vertex);
  ASSERT_NE(defect.face, Mesh::null_face());
  const Mesh::Halfedge_index h = mesh.halfedge(defect.vertex, defect.other_vertex);
  EXPECT_EQ(mesh.face(mesh.opposite(h)), defect.face);
  expect_words(defect, {std::to_string(defect.vertex.idx()), std::to_string(defect.other_vertex.idx()),
                        "face " + std::to_string(defect.face.idx()), "3 such edges"});
}

TEST(Find_defect, names_the_parts)
{
  const Triangle_list sphere = icosphere(1), ring = torus(7, 5);
  const Mesh mesh = make(disjoint_union(disjoint_union(sphere, ring), sphere));
  const Defect defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::ERROR_SEVERAL_COMPONENTS);
  EXPECT_EQ(defect.count, 3u);
  const std::size_t n = sphere.points.size();
  EXPECT_LT(std::size_t(defect.vertex), n);
  EXPECT_GE(std::size_t(defect.other_vertex), n);
  EXPECT_LT(std::size_t(defect.other_vertex), n + ring.points.size());
  expect_words(defect, {"3 parts", "of 80 faces", "of 70.", "face 0 ", "face 80 "});
}

TEST(Find_defect, counts_handles)
{
  const Defect defect = SP::find_defect(make(torus(7, 5)));
  EXPECT_EQ(defect.error, SP::ERROR_NO_TOPOLOGICAL_SPHERE);
  EXPECT_EQ(defect.count, 1u);
  expect_words(defect, {"genus 1", "35 vertices", "105 edges", "70 faces"});
}

TEST(Find_defect, names_the_repeated_edge)
{
  // A double pyramid over a quadrangle becomes one over a triangle, two corners of which get a second edge instead of the
  // edge between a tip and the third corner.
  Mesh mesh = make(suspension(4));
  const Vertex_index corner = CGAL::Euler::collapse_edge(edge(mesh.halfedge(vertex(0), vertex(1)), mesh), mesh);
  CGAL::Euler::flip_edge(mesh.halfedge(corner, vertex(4)), mesh);
  const Defect defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::ERROR_NO_SIMPLICIAL_COMPLEX);
  EXPECT_EQ(ends(defect), (std::set<Vertex_index>{vertex(2), vertex(3)}));
  EXPECT_EQ(defect.count, 1u);
  // a removed vertex does not count: the names are places in the range, the descriptors are the mesh's own
  expect_words(defect, {"the edge between", "more than once"});
}

TEST(Find_defect, names_the_vertex_where_two_fans_meet)
{
  const Triangle_list sphere = icosphere(1);
  Mesh mesh = make(disjoint_union(sphere, sphere));
  const Vertex_index other(static_cast<Mesh::size_type>(sphere.points.size()));
  for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(other), mesh))
    mesh.set_target(h, Vertex_index(3));
  mesh.remove_vertex(other);
  const Defect defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::ERROR_NO_SIMPLICIAL_COMPLEX);
  EXPECT_EQ(defect.vertex, Vertex_index(3));
  EXPECT_EQ(defect.other_vertex, Mesh::null_vertex());
  EXPECT_EQ(defect.count, 1u);
  expect_words(defect, {"vertex 3", "a fan of 5 faces"});
}

// Each defect counts once, whatever else there is.
TEST(Find_defect, counts_repeated_edges_and_vertices_apart)
{
  const Triangle_list sphere = icosphere(1);
  const auto number = [](std::size_t i) { return static_cast<Mesh::size_type>(i); };
  const std::size_t n = sphere.points.size();
  Mesh mesh = make(disjoint_union(disjoint_union(sphere, sphere), sphere));
  const auto merge = [&](std::size_t from, std::size_t to) {
    const Vertex_index other(number(from));
    for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(other), mesh))
      mesh.set_target(h, Vertex_index(number(to)));
    mesh.remove_vertex(other);
  };
  merge(n, 0);
  merge(2 * n + 1, 1);
  Defect defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::ERROR_NO_SIMPLICIAL_COMPLEX);
  EXPECT_EQ(defect.vertex, Vertex_index(0));
  EXPECT_EQ(defect.count, 2u);
  expect_words(defect, {"2 such vertices"});

  // two parts that share an edge, but not the faces at it
  const Mesh::Halfedge_index h = *mesh.halfedges().begin();
  const std::size_t a = std::size_t(mesh.source(h)), b = std::size_t(mesh.target(h));
  Mesh twice = make(disjoint_union(sphere, sphere));
  mesh = twice;
  merge(n + a, a);
  merge(n + b, b);
  defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::ERROR_NO_SIMPLICIAL_COMPLEX);
  EXPECT_EQ(ends(defect), (std::set<Vertex_index>{Vertex_index(number(a)), Vertex_index(number(b))}));
  EXPECT_EQ(defect.count, 1u);
  expect_words(defect, {"more than once"});
}

TEST(Find_defect, names_an_edge_without_faces)
{
  Mesh mesh = make(icosphere(1));
  const Vertex_index a = mesh.add_vertex(Point_3(0., 0., 2.)), b = mesh.add_vertex(Point_3(0., 0., 3.));
  const Mesh::Halfedge_index h = mesh.halfedge(mesh.edge(mesh.add_edge(a, b)));
  mesh.set_next(h, mesh.opposite(h));
  mesh.set_next(mesh.opposite(h), h);
  mesh.set_halfedge(b, h);
  mesh.set_halfedge(a, mesh.opposite(h));
  const Defect defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::ERROR_NON_CLOSED_MESH);
  EXPECT_EQ(ends(defect), (std::set<Vertex_index>{a, b}));
  EXPECT_EQ(defect.face, Mesh::null_face());
  EXPECT_EQ(defect.count, 1u);
  expect_words(defect, {"no face"});
}

TEST(Find_defect, names_the_vertex_that_is_not_finite)
{
  Triangle_list list = icosphere(1);
  list.points[7][1] = std::nan("");
  list.points[9][2] = HUGE_VAL;
  const Mesh mesh = make(list);
  const Defect defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_EQ(defect.vertex, vertex(7));
  EXPECT_EQ(defect.count, 2u);
  expect_words(defect, {"vertex 7 ", "2 such vertices"});

  // with the points that the caller names
  const auto points = make_vertex_map<Point_3>(mesh, icosphere(1).points);
  EXPECT_EQ(SP::find_defect(mesh, CGAL::parameters::vertex_point_map(points)).error, SP::OK);
}

// Vertices of a Polyhedron_3 have no index; they are numbered all the same.
TEST(Find_defect, numbers_the_elements_of_any_mesh)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Triangle_list list = icosphere(1);
  list.points[11][0] = std::nan("");
  const Polyhedron mesh = make_mesh<Polyhedron>(list);
  const SP::Mesh_defect<Polyhedron> defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_EQ(defect.vertex, *std::next(vertices(mesh).begin(), 11));
  EXPECT_NE(defect.message.find("vertex 11 "), std::string::npos) << defect.message;
}

} // namespace
