// Each kind of mesh that cannot be parameterized: all methods refuse it before any work, and find_defect() says what is wrong.

#include "methods.h"

#include <CGAL/Polyhedron_3.h>

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

// Expects that so many of these are found, and a message that has these words, and advice on a line of its own.
Defect expect_defect(const Mesh& mesh, SP::Error_code error, std::size_t count, const std::vector<std::string>& words)
{
  const Defect defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, error);
  EXPECT_EQ(defect.count, count);
  for(const std::string& word : words)
    EXPECT_NE(defect.message.find(word), std::string::npos) << word << " in: " << defect.message;
  EXPECT_NE(defect.message.find(".\n"), std::string::npos) << defect.message;
  return defect;
}

// Expects this error of every method: the visitor is not called.
void expect_refusal(const Mesh& mesh, SP::Error_code error)
{
  std::vector<Method> methods = all_methods();
  methods.push_back(precomputed(mesh, sentinels(num_vertices(mesh))));
  for(const Method& method : methods)
  {
    expect_error(mesh, method, error);
    Recorder recorder;
    EXPECT_EQ(method.run(mesh, Options().visitor(recorder)).error, error);
    EXPECT_TRUE(recorder.events.empty());
  }
  EXPECT_EQ(SP::find_defect(mesh).error, error);
}

Defect expect_refusal(const Mesh& mesh, SP::Error_code error, std::size_t count, const std::vector<std::string>& words)
{
  expect_refusal(mesh, error);
  return expect_defect(mesh, error, count, words);
}

// The second vertex becomes the first, with the faces of both.
void merge(Mesh& mesh, std::size_t first, std::size_t second)
{
  for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(vertex(second)), mesh))
    mesh.set_target(h, vertex(first));
  mesh.remove_vertex(vertex(second));
}

TEST(Mesh_defect, is_none_where_there_is_none)
{
  const Defect defect = SP::find_defect(make(icosphere(1)));
  EXPECT_EQ(defect.error, SP::OK);
  EXPECT_EQ(defect.vertex, Mesh::null_vertex());
  EXPECT_EQ(defect.other_vertex, Mesh::null_vertex());
  EXPECT_EQ(defect.face, Mesh::null_face());
  EXPECT_EQ(defect.count, 0u);
  EXPECT_EQ(defect.message, SP::get_error_message(SP::OK));
}

TEST(Mesh_defect, of_too_few_vertices)
{
  expect_refusal(Mesh(), SP::ERROR_EMPTY_MESH);
  Mesh pillow; // two triangles, back to back
  const Vertex_index a = pillow.add_vertex(Point_3(0., 0., 0.)), b = pillow.add_vertex(Point_3(1., 0., 0.)),
                     c = pillow.add_vertex(Point_3(0., 1., 0.));
  expect_refusal(pillow, SP::ERROR_EMPTY_MESH);
  pillow.add_face(a, b, c);
  pillow.add_face(a, c, b);
  expect_refusal(pillow, SP::ERROR_TOO_FEW_VERTICES, 3, {"only 3 vertices"});
  pillow.add_vertex(Point_3(0., 0., 1.)); // an isolated vertex does not count
  expect_refusal(pillow, SP::ERROR_TOO_FEW_VERTICES, 3, {"only 3 vertices"});
}

TEST(Mesh_defect, of_polygons_names_the_first)
{
  Mesh mesh = cube();
  expect_refusal(mesh, SP::ERROR_NON_TRIANGULAR_MESH, 6, {"face 0 "});
  const Mesh::Halfedge_index h = mesh.halfedge(*mesh.faces().begin());
  CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
  EXPECT_EQ(expect_refusal(mesh, SP::ERROR_NON_TRIANGULAR_MESH, 5, {"face 1 ", "4 corners", "5 such faces"}).face,
            *std::next(mesh.faces().begin()));

  Mesh one_quadrangle = make(icosphere(1));
  CGAL::Euler::join_face(*one_quadrangle.halfedges().begin(), one_quadrangle);
  expect_refusal(one_quadrangle, SP::ERROR_NON_TRIANGULAR_MESH);
}

TEST(Mesh_defect, of_a_border_names_an_edge)
{
  Triangle_list list = icosphere(1);
  const Triangle t = list.triangles[30];
  list.triangles.erase(list.triangles.begin() + 30);
  const Mesh mesh = make(list);
  const Defect defect = expect_refusal(mesh, SP::ERROR_NON_CLOSED_MESH, 3, {"3 such edges"});
  const std::set<Vertex_index> corners = {vertex(t[0]), vertex(t[1]), vertex(t[2])};
  EXPECT_TRUE(corners.count(defect.vertex) == 1 && corners.count(defect.other_vertex) == 1);
  EXPECT_NE(defect.vertex, defect.other_vertex);
  ASSERT_NE(defect.face, Mesh::null_face());
  const Mesh::Halfedge_index h = mesh.halfedge(defect.vertex, defect.other_vertex);
  EXPECT_EQ(mesh.face(mesh.opposite(h)), defect.face);
  expect_defect(mesh, defect.error, 3,
                {std::to_string(defect.vertex.idx()), std::to_string(defect.other_vertex.idx()),
                 "face " + std::to_string(defect.face.idx())});
  list.points.resize(3);
  list.triangles = {{0, 1, 2}};
  expect_refusal(make(list), SP::ERROR_NON_CLOSED_MESH);
}

TEST(Mesh_defect, of_several_parts_names_them)
{
  const Triangle_list sphere = icosphere(1), ring = torus(7, 5);
  const Defect defect =
      expect_refusal(make(disjoint_union(disjoint_union(sphere, ring), sphere)), SP::ERROR_SEVERAL_COMPONENTS, 3,
                     {"3 parts", "of 80 faces", "of 70.", "face 0 ", "face 80 "});
  const std::size_t n = sphere.points.size();
  EXPECT_LT(std::size_t(defect.vertex), n);
  EXPECT_GE(std::size_t(defect.other_vertex), n);
  EXPECT_LT(std::size_t(defect.other_vertex), n + ring.points.size());
  expect_refusal(make(disjoint_union(sphere, sphere)), SP::ERROR_SEVERAL_COMPONENTS);
  // together they have the Euler number of a sphere
  expect_refusal(make(disjoint_union(sphere, ring)), SP::ERROR_SEVERAL_COMPONENTS);
  expect_refusal(make(disjoint_union(ring, sphere)), SP::ERROR_SEVERAL_COMPONENTS);
}

TEST(Mesh_defect, of_handles_counts_them)
{
  expect_refusal(make(torus(7, 5)), SP::ERROR_NO_TOPOLOGICAL_SPHERE, 1,
                 {"genus 1", "35 vertices", "105 edges", "70 faces"});
}

TEST(Mesh_defect, of_repeated_edges_names_one)
{
  // A double pyramid over a quadrangle becomes one over a triangle, two corners of which get a second edge instead of the
  // edge between a tip and the third corner.
  Mesh mesh = make(suspension(4));
  const Vertex_index corner = CGAL::Euler::collapse_edge(edge(mesh.halfedge(vertex(0), vertex(1)), mesh), mesh);
  CGAL::Euler::flip_edge(mesh.halfedge(corner, vertex(4)), mesh);
  ASSERT_EQ(mesh.number_of_vertices(), 5u);
  ASSERT_TRUE(CGAL::is_closed(mesh) && CGAL::is_triangle_mesh(mesh) && mesh.is_valid());
  // a removed vertex does not count: the names are places in the range, the descriptors are the mesh's own
  EXPECT_EQ(ends(expect_refusal(mesh, SP::ERROR_NO_SIMPLICIAL_COMPLEX, 1, {"the edge between", "more than once"})),
            (std::set<Vertex_index>{vertex(2), vertex(3)}));

  // In a larger mesh, a vertex in a face gets degree 2: then two faces have the same vertices.
  Mesh large = make(icosphere(1));
  const Mesh::Halfedge_index h = CGAL::Euler::add_center_vertex(*large.halfedges().begin(), large);
  const Vertex_index center = large.target(h);
  EXPECT_EQ(SP::parameterize(large, Point_map(large, sentinels(num_vertices(large)))), SP::OK);
  CGAL::Euler::flip_edge(h, large);
  ASSERT_EQ(large.degree(center), 2u);
  expect_refusal(large, SP::ERROR_NO_SIMPLICIAL_COMPLEX);
}

TEST(Mesh_defect, of_two_fans_names_the_vertex_where_they_meet)
{
  const Triangle_list sphere = icosphere(1);
  Mesh mesh = make(disjoint_union(sphere, sphere));
  merge(mesh, 3, sphere.points.size());
  const Defect defect = expect_refusal(mesh, SP::ERROR_NO_SIMPLICIAL_COMPLEX, 1, {"vertex 3", "a fan of 5 faces"});
  EXPECT_EQ(defect.vertex, vertex(3));
  EXPECT_EQ(defect.other_vertex, Mesh::null_vertex());
}

// Each defect counts once, whatever else there is.
TEST(Mesh_defect, counts_repeated_edges_and_vertices_apart)
{
  const Triangle_list sphere = icosphere(1);
  const std::size_t n = sphere.points.size();
  Mesh mesh = make(disjoint_union(disjoint_union(sphere, sphere), sphere));
  merge(mesh, 0, n);
  merge(mesh, 1, 2 * n + 1);
  EXPECT_EQ(expect_defect(mesh, SP::ERROR_NO_SIMPLICIAL_COMPLEX, 2, {"2 such vertices"}).vertex, vertex(0));

  // two parts that share an edge, but not the faces at it
  const Mesh::Halfedge_index h = *mesh.halfedges().begin();
  const std::size_t a = std::size_t(mesh.source(h)), b = std::size_t(mesh.target(h));
  mesh = make(disjoint_union(sphere, sphere));
  merge(mesh, a, n + a);
  merge(mesh, b, n + b);
  EXPECT_EQ(ends(expect_defect(mesh, SP::ERROR_NO_SIMPLICIAL_COMPLEX, 1, {"more than once"})),
            (std::set<Vertex_index>{vertex(a), vertex(b)}));
}

TEST(Mesh_defect, of_an_edge_without_faces_names_it)
{
  Mesh mesh = make(icosphere(1));
  const Vertex_index a = mesh.add_vertex(Point_3(0., 0., 2.)), b = mesh.add_vertex(Point_3(0., 0., 3.));
  const Mesh::Halfedge_index h = mesh.halfedge(mesh.edge(mesh.add_edge(a, b)));
  mesh.set_next(h, mesh.opposite(h));
  mesh.set_next(mesh.opposite(h), h);
  mesh.set_halfedge(b, h);
  mesh.set_halfedge(a, mesh.opposite(h));
  const Defect defect = expect_defect(mesh, SP::ERROR_NON_CLOSED_MESH, 1, {"no face"});
  EXPECT_EQ(ends(defect), (std::set<Vertex_index>{a, b}));
  EXPECT_EQ(defect.face, Mesh::null_face());
}

TEST(Mesh_defect, of_coordinates_that_are_not_finite_names_the_vertex)
{
  Triangle_list list;
  for(const double x : {HUGE_VAL, -HUGE_VAL, std::nan("")})
  {
    list = icosphere(1);
    list.points.push_back({x, x, x}); // an isolated vertex may be anywhere
    EXPECT_EQ(bijective().run(list).error, SP::OK);
    list = icosphere(1);
    list.points[7][1] = x;
    expect_refusal(make(list), SP::ERROR_NON_FINITE_COORDINATE);
  }
  list.points[9][2] = HUGE_VAL;
  const Mesh mesh = make(list);
  EXPECT_EQ(expect_defect(mesh, SP::ERROR_NON_FINITE_COORDINATE, 2, {"vertex 7 ", "2 such vertices"}).vertex,
            vertex(7));
  // with the points that the caller names
  const auto points = make_vertex_map<Point_3>(mesh, icosphere(1).points);
  EXPECT_EQ(SP::find_defect(mesh, CGAL::parameters::vertex_point_map(points)).error, SP::OK);

  // Vertices of a Polyhedron_3 have no index; they are numbered all the same.
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Polyhedron polyhedron = make_mesh<Polyhedron>(list);
  const SP::Mesh_defect<Polyhedron> defect = SP::find_defect(polyhedron);
  EXPECT_EQ(defect.error, SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_EQ(defect.vertex, *std::next(vertices(polyhedron).begin(), 7));
  EXPECT_NE(defect.message.find("vertex 7 "), std::string::npos) << defect.message;
}

} // namespace
