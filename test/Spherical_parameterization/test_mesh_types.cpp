// Any model of FaceListGraph with points of any kernel: the map is a bijection, it is the same for all whose coordinates are
// doubles, and the mesh stays as it is.

#include "methods.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

using namespace test;

namespace {

namespace params = CGAL::parameters;

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Double = CGAL::Simple_cartesian<double>;
using Linear_cell_complex =
    CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;

static_assert(!CGAL::graph_has_property<CGAL::Polyhedron_3<Double>, boost::vertex_index_t>::value,
              "This is meant to be the mesh without vertex indices of its own.");

template <class Any_mesh>
using Point_of =
    typename boost::property_traits<typename boost::property_map<Any_mesh, CGAL::vertex_point_t>::type>::value_type;

const Triangle_list& list()
{
  static const Triangle_list result = bumpy_sphere(2);
  return result;
}

// the map of Surface_mesh, to which all others are compared
const Images& reference()
{
  static const Images result = bijective().run(list()).images;
  return result;
}

template <class Any_mesh, class Map>
void expect_reference(const Any_mesh& mesh, const Map& map)
{
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  EXPECT_TRUE(have_same_bits(images(mesh, map), reference()));
}

// Points, and triangles by the numbers of their vertices: all that there is to a mesh.
template <class Any_mesh>
std::pair<Images, std::vector<std::size_t>> content(const Any_mesh& mesh)
{
  std::map<typename boost::graph_traits<Any_mesh>::vertex_descriptor, std::size_t> index;
  for(const auto v : vertices(mesh))
    index.emplace(v, index.size());
  std::vector<std::size_t> corners;
  for(const auto f : faces(mesh))
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back(index.at(v));
  return {images(mesh, get(CGAL::vertex_point, mesh)), corners};
}

template <class Any_mesh>
class Mesh_type : public ::testing::Test
{};

using Mesh_types =
    ::testing::Types<Mesh, CGAL::Polyhedron_3<Double>, CGAL::Surface_mesh<Epeck::Point_3>, Linear_cell_complex>;
TYPED_TEST_SUITE(Mesh_type, Mesh_types, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Mesh_type, is_mapped_and_not_changed)
{
  const TypeParam mesh = make_mesh<TypeParam>(list());
  const auto before = content(mesh);
  const auto map = make_sentinel_map<Point_of<TypeParam>>(mesh);
  ASSERT_EQ(SP::parameterize(mesh, map), SP::OK);
  expect_reference(mesh, map); // An exact kernel gets the same doubles: all coordinates are theirs.
  EXPECT_EQ(distortion_of(mesh, map).number_of_inverted_faces, 0u);
  const auto after = content(mesh);
  EXPECT_TRUE(have_same_bits(after.first, before.first));
  EXPECT_EQ(after.second, before.second);
}

// The points may be replaced in place: everything has been read before anything is written.
TEST(Surface_mesh, may_be_mapped_onto_its_own_points)
{
  Mesh mesh = make(list());
  ASSERT_EQ(SP::parameterize(mesh, mesh.points()), SP::OK);
  expect_reference(mesh, mesh.points());
}

TEST(Surface_mesh, may_contain_removed_elements_and_isolated_vertices)
{
  // A sphere that goes, the mesh, a sphere that goes, and vertices without faces here and there.
  const Triangle_list other = icosphere(1);
  Triangle_list all = disjoint_union(disjoint_union(other, list()), other);
  const std::size_t first = other.points.size(), last = first + list().points.size();
  all.points.push_back({1e6, 0., 0.});
  Mesh mesh = make(all);
  const std::size_t n_faces = num_faces(mesh);
  for(std::size_t f = 0; f < n_faces; ++f)
    if(f < other.triangles.size() || f >= n_faces - other.triangles.size())
      CGAL::Euler::remove_face(halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(f)), mesh), mesh);
  const Mesh::Vertex_index isolated = mesh.add_vertex(Point_3(-1e6, 0., 0.));
  ASSERT_TRUE(mesh.has_garbage());
  auto map = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere", Point_3(7, 8, 9)).first;
  SP::Bijective_low_distortion_parameterizer_3 bld;
  ASSERT_EQ(SP::parameterize(mesh, bld, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  EXPECT_EQ(map[isolated], Point_3(7, 8, 9));
  EXPECT_GE(bld.report().number_of_isolated_vertices, 1u);
  Images result;
  for(std::size_t v = first; v < last; ++v)
  {
    const Point_3& p = map[Mesh::Vertex_index(static_cast<Mesh::size_type>(v))];
    result.push_back({p.x(), p.y(), p.z()});
  }
  EXPECT_TRUE(have_same_bits(result, reference()));
}

TEST(Vertex_point_map, replaces_the_points_of_the_mesh)
{
  // The mesh has other points; those of the test are in a map, and of another kernel than the images.
  const Mesh mesh = make(icosphere(2));
  const auto surface = make_vertex_map<Double::Point_3>(mesh, list().points);
  const auto map = make_sentinel_map<Point_3>(mesh);
  ASSERT_EQ(SP::parameterize(mesh, map, params::vertex_point_map(surface)), SP::OK);
  expect_reference(mesh, map);
}

// A view of one component of a mesh.
TEST(Face_filtered_graph, is_mapped)
{
  Mesh mesh = make(disjoint_union(icosphere(0), list()));
  auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  std::size_t k = 0;
  for(const auto f : faces(mesh))
    component[f] = k++ < icosphere(0).triangles.size() ? 0 : 1;
  const CGAL::Face_filtered_graph<Mesh> view(mesh, std::size_t(1), component);
  auto map = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere", Point_3(7, 8, 9)).first;
  ASSERT_EQ(SP::parameterize(view, map), SP::OK);
  expect_reference(view, map);
  EXPECT_EQ(map[Mesh::Vertex_index(0)], Point_3(7, 8, 9));
}

} // namespace

// A mesh that says that it is larger than it is.
struct Large_mesh : Mesh
{
  using Mesh::Mesh;
  std::size_t claimed_number_of_halfedges = 0;
};

namespace boost {
template <>
struct graph_traits<Large_mesh> : graph_traits<Mesh>
{};
template <>
struct property_map<Large_mesh, CGAL::vertex_point_t> : property_map<Mesh, CGAL::vertex_point_t>
{};
} // namespace boost

namespace CGAL {
template <>
struct graph_has_property<Large_mesh, vertex_point_t> : Tag_true
{};
} // namespace CGAL

std::size_t num_halfedges(const Large_mesh& mesh)
{
  return mesh.claimed_number_of_halfedges;
}

namespace {

TEST(Large_mesh, is_refused)
{
  Large_mesh mesh;
  static_cast<Mesh&>(mesh) = make(icosphere(1));
  const Point_map map(mesh, sentinels(num_vertices(mesh)));
  for(const std::size_t n : {(std::size_t(1) << 31) - 1, std::size_t(1) << 31, std::size_t(1) << 40})
  {
    mesh.claimed_number_of_halfedges = n;
    EXPECT_EQ(SP::parameterize(mesh, map), SP::ERROR_TOO_LARGE_MESH);
    EXPECT_EQ(SP::find_defect(mesh).error, SP::ERROR_TOO_LARGE_MESH);
    EXPECT_TRUE(have_same_bits(images(mesh, map), sentinels(num_vertices(mesh))));
  }
  mesh.claimed_number_of_halfedges = mesh.number_of_halfedges();
  EXPECT_EQ(SP::parameterize(mesh, map), SP::OK);
}

} // namespace
