// Calls at the same time for one const mesh do not disturb each other, because the mesh is only read.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <thread>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;

template <class Mesh>
class Simultaneous_calls : public ::testing::Test
{
protected:
  using Vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;

  // The default, and a start through the public interface of another method.
  static std::vector<Coordinates> images(const Mesh& mesh, bool is_default)
  {
    std::map<Vertex_descriptor, Point_3> points;
    const boost::associative_property_map<std::map<Vertex_descriptor, Point_3>> map(points);
    const auto np = CGAL::parameters::number_of_iterations(5u);
    SP::Bijective_low_distortion_parameterizer_3<Mesh> usual;
    SP::Bijective_low_distortion_parameterizer_3<Mesh, SP::Stereographic_parameterizer_3<Mesh>> from_plane;
    EXPECT_EQ(is_default ? SP::parameterize(mesh, usual, map, np) : SP::parameterize(mesh, from_plane, map, np),
              SP::OK);
    EXPECT_TRUE(SP::is_bijective(mesh, map));
    EXPECT_EQ(SP::measure_distortion(mesh, map).number_of_inverted_faces, 0u);
    return test_maps::images(mesh, map);
  }
};

// Polyhedron_3 with ids can have indices that are not valid.
using Meshes = ::testing::Types<CGAL::Surface_mesh<Point_3>, CGAL::Polyhedron_3<Kernel>,
                                CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>;
TYPED_TEST_SUITE(Simultaneous_calls, Meshes, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Simultaneous_calls, for_the_same_mesh)
{
  const TypeParam mesh = test_meshes::make_mesh<TypeParam>(test_meshes::bumpy_sphere(3));
  const std::vector<Coordinates> expected[] = {this->images(mesh, false), this->images(mesh, true)};
  constexpr std::size_t n_threads = 4;
  std::vector<std::vector<Coordinates>> found(n_threads);
  std::vector<std::thread> threads;
  for(std::size_t i = 0; i < n_threads; ++i)
    threads.emplace_back([&, i] {
      for(int run = 0; run < 5; ++run)
        found[i] = this->images(mesh, i % 2 == 1);
    });
  for(std::thread& thread : threads)
    thread.join();
  for(std::size_t i = 0; i < n_threads; ++i)
    EXPECT_TRUE(test_maps::have_same_bits(found[i], expected[i % 2])) << i;
}

// A race need not show; a temporary property of the mesh, where it would come from, does: to the map that the points are
// read from, while the mesh is read, and to the map that is written, while another method makes the start.
TEST(Reading_only, leaves_no_property_even_for_a_while)
{
  using Mesh = CGAL::Surface_mesh<Point_3>;
  const Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  const std::size_t n_properties = mesh.properties<Mesh::Vertex_index>().size();
  std::size_t most_properties = 0;
  const auto count = [&] {
    most_properties = (std::max)(most_properties, mesh.properties<Mesh::Vertex_index>().size());
  };
  const auto vpm = boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v) {
    count();
    return mesh.point(v);
  });
  struct Counting_visitor : SP::Default_visitor
  {
    std::function<void()> count;
    bool go_further(std::size_t, double)
    {
      count();
      return true;
    }
  };
  Counting_visitor visitor;
  visitor.count = count;
  std::map<Mesh::Vertex_index, Point_3> points;
  const boost::associative_property_map<std::map<Mesh::Vertex_index, Point_3>> map(points);
  SP::Bijective_low_distortion_parameterizer_3<Mesh, SP::Harmonic_parameterizer_3<Mesh>> parameterizer;
  ASSERT_EQ(
      SP::parameterize(mesh, parameterizer, map,
                       CGAL::parameters::vertex_point_map(vpm).visitor(std::ref(visitor)).number_of_iterations(2u)),
      SP::OK);
  EXPECT_EQ(most_properties, n_properties);
}

// The ids of a Polyhedron_3 are the caller's, whatever they are.
TEST(Reading_only, leaves_the_ids_of_a_polyhedron)
{
  using Mesh = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  Mesh mesh = test_meshes::make_mesh<Mesh>(test_meshes::icosphere(1));
  for(const auto v : vertices(mesh))
    v->id() = 7;
  std::map<boost::graph_traits<Mesh>::vertex_descriptor, Point_3> points;
  const boost::associative_property_map<decltype(points)> map(points);
  EXPECT_EQ(SP::parameterize(mesh, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  for(const auto v : vertices(mesh))
    EXPECT_EQ(v->id(), 7u);
}

// Vertices that have been removed leave gaps in the indices.
TEST(Reading_only, works_on_a_mesh_with_removed_vertices)
{
  using Mesh = CGAL::Surface_mesh<Point_3>;
  Mesh mesh;
  for(int i = 0; i < 10; ++i)
    mesh.add_vertex(Point_3(i, 0, 0));
  for(const auto v : std::vector<Mesh::Vertex_index>(mesh.vertices().begin(), mesh.vertices().end()))
    mesh.remove_vertex(v);
  const Mesh sphere = test_meshes::make_mesh<Mesh>(test_meshes::icosphere(1));
  std::map<Mesh::Vertex_index, Mesh::Vertex_index> copies;
  mesh.set_recycle_garbage(false);
  for(const auto v : sphere.vertices())
    copies[v] = mesh.add_vertex(sphere.point(v));
  for(const auto f : sphere.faces())
  {
    std::vector<Mesh::Vertex_index> corners;
    for(const auto v : sphere.vertices_around_face(sphere.halfedge(f)))
      corners.push_back(copies[v]);
    mesh.add_face(corners);
  }
  ASSERT_TRUE(mesh.has_garbage());
  std::map<Mesh::Vertex_index, Point_3> points;
  const boost::associative_property_map<std::map<Mesh::Vertex_index, Point_3>> map(points);
  EXPECT_EQ(SP::parameterize(mesh, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  EXPECT_EQ(points.size(), copies.size());
}

} // namespace
