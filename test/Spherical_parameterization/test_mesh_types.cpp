// Any model of FaceListGraph with points of any kernel: the map is a bijection, it is the same for all whose
// coordinates are doubles, and the mesh stays as it is.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace params = CGAL::parameters;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle_list;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Double = CGAL::Simple_cartesian<double>;
using Float = CGAL::Simple_cartesian<float>;
using Linear_cell_complex =
    CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Epick>>::type;

using Surface_mesh = CGAL::Surface_mesh<Epick::Point_3>;

static_assert(!CGAL::graph_has_property<CGAL::Polyhedron_3<Double>, boost::vertex_index_t>::value,
              "This is meant to be the mesh without vertex indices of its own.");

template <class Mesh>
using Point_of =
    typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;

const Triangle_list& list()
{
  static const Triangle_list result = test_meshes::bumpy_sphere(2);
  return result;
}

// the map of Surface_mesh<Epick::Point_3>, to which all others are compared
const std::vector<Coordinates>& reference()
{
  static const std::vector<Coordinates> result = [] {
    const Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(list());
    const auto map = test_maps::make_sentinel_map<Epick::Point_3>(mesh);
    EXPECT_EQ(SP::parameterize(mesh, map), SP::OK);
    return test_maps::images(mesh, map);
  }();
  return result;
}

// Points, and triangles by the numbers of their vertices: all that there is to a mesh.
template <class Mesh>
std::pair<std::vector<Coordinates>, std::vector<std::size_t>> content(const Mesh& mesh)
{
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> index;
  for(const auto v : vertices(mesh))
  {
    index.emplace(v, index.size());
  }
  std::vector<std::size_t> corners;
  for(const auto f : faces(mesh))
  {
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
    {
      corners.push_back(index.at(v));
    }
  }
  return {test_maps::images(mesh, get(CGAL::vertex_point, mesh)), corners};
}

template <class Mesh>
class Mesh_type : public ::testing::Test
{};

using Mesh_types = ::testing::Types<Surface_mesh, CGAL::Polyhedron_3<Epick>, CGAL::Polyhedron_3<Double>,
                                    CGAL::Surface_mesh<Epeck::Point_3>, Linear_cell_complex>;
TYPED_TEST_SUITE(Mesh_type, Mesh_types, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Mesh_type, is_mapped_and_not_changed)
{
  using Point_3 = Point_of<TypeParam>;
  const TypeParam mesh = test_meshes::make_mesh<TypeParam>(list());
  const auto before = content(mesh);
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  ASSERT_EQ(SP::parameterize(mesh, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  // An exact kernel gets the same doubles: all coordinates are theirs.
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, map), reference()));
  const auto after = content(mesh);
  EXPECT_TRUE(test_maps::have_same_bits(after.first, before.first));
  EXPECT_EQ(after.second, before.second);
}

// A mesh and points that have nothing in common with Surface_mesh and doubles, by the other methods.
template <class Parameterizer, class Reference>
void expect_same_images()
{
  using Other_mesh = typename Parameterizer::Triangle_mesh;
  const Other_mesh other = test_meshes::make_mesh<Other_mesh>(list());
  const Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(list());
  const auto other_map = test_maps::make_sentinel_map<Point_of<Other_mesh>>(other);
  const auto map = test_maps::make_sentinel_map<Epick::Point_3>(mesh);
  Parameterizer parameterizer;
  Reference reference_parameterizer;
  ASSERT_EQ(parameterizer.parameterize(other, other_map), SP::OK);
  ASSERT_EQ(reference_parameterizer.parameterize(mesh, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(other, other_map));
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(other, other_map), test_maps::images(mesh, map)));
}

TEST(Other_methods, do_not_depend_on_the_types)
{
  expect_same_images<SP::Harmonic_parameterizer_3<CGAL::Polyhedron_3<Double>>,
                     SP::Harmonic_parameterizer_3<Surface_mesh>>();
  expect_same_images<SP::ARAP_parameterizer_3<CGAL::Surface_mesh<Epeck::Point_3>>,
                     SP::ARAP_parameterizer_3<Surface_mesh>>();
}

// A map that folds is written in full, and it is the same map.
TEST(Other_methods, write_maps_that_fold)
{
  const CGAL::Polyhedron_3<Double> polyhedron = test_meshes::make_mesh<CGAL::Polyhedron_3<Double>>(list());
  const Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(list());
  const auto other_map = test_maps::make_sentinel_map<Float::Point_3>(polyhedron);
  const auto map = test_maps::make_sentinel_map<Epick::Point_3>(mesh);
  ASSERT_EQ(SP::Conformal_parameterizer_3<CGAL::Polyhedron_3<Double>>().parameterize(polyhedron, other_map),
            SP::ERROR_NO_1_TO_1_MAPPING);
  ASSERT_EQ(SP::Conformal_parameterizer_3<Surface_mesh>().parameterize(mesh, map), SP::ERROR_NO_1_TO_1_MAPPING);
  EXPECT_LT(test_maps::largest_distance(test_maps::images(polyhedron, other_map), test_maps::images(mesh, map)), 1e-6);
}

TEST(Surface_mesh, keeps_its_properties)
{
  Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(list());
  auto map = mesh.add_property_map<Surface_mesh::Vertex_index, Epick::Point_3>("v:sphere").first;
  const auto properties = [&] {
    return std::vector<std::vector<std::string>>{
        mesh.properties<Surface_mesh::Vertex_index>(), mesh.properties<Surface_mesh::Halfedge_index>(),
        mesh.properties<Surface_mesh::Edge_index>(), mesh.properties<Surface_mesh::Face_index>()};
  };
  const std::vector<std::vector<std::string>> before = properties();
  ASSERT_EQ(SP::parameterize(mesh, map), SP::OK);
  EXPECT_EQ(properties(), before);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, map), reference()));
}

// The points may be replaced in place: everything has been read before anything is written.
TEST(Surface_mesh, may_be_mapped_onto_its_own_points)
{
  Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(list());
  ASSERT_EQ(SP::parameterize(mesh, mesh.points()), SP::OK);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, mesh.points()), reference()));
}

TEST(Surface_mesh, may_contain_removed_elements_and_isolated_vertices)
{
  // A sphere that goes, the mesh, a sphere that goes, and vertices without faces here and there.
  const Triangle_list other = test_meshes::icosphere(1);
  Triangle_list all = test_meshes::disjoint_union(test_meshes::disjoint_union(other, list()), other);
  const std::size_t first = other.points.size(), last = first + list().points.size();
  all.points.push_back({1e6, 0., 0.});
  Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(all);
  const std::size_t n_faces = num_faces(mesh);
  for(std::size_t f = 0; f < n_faces; ++f)
  {
    if(f < other.triangles.size() || f >= n_faces - other.triangles.size())
    {
      CGAL::Euler::remove_face(halfedge(Surface_mesh::Face_index(static_cast<Surface_mesh::size_type>(f)), mesh), mesh);
    }
  }
  const Surface_mesh::Vertex_index isolated = mesh.add_vertex(Epick::Point_3(-1e6, 0., 0.));
  ASSERT_TRUE(mesh.has_garbage());
  auto map =
      mesh.add_property_map<Surface_mesh::Vertex_index, Epick::Point_3>("v:sphere", Epick::Point_3(7, 8, 9)).first;
  SP::Bijective_low_distortion_parameterizer_3<Surface_mesh> bld;
  ASSERT_EQ(SP::parameterize(mesh, bld, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  EXPECT_EQ(map[isolated], Epick::Point_3(7, 8, 9));
  EXPECT_GE(bld.report().number_of_isolated_vertices, 1u);
  std::vector<Coordinates> images;
  for(std::size_t v = first; v < last; ++v)
  {
    const Epick::Point_3& p = map[Surface_mesh::Vertex_index(static_cast<Surface_mesh::size_type>(v))];
    images.push_back({p.x(), p.y(), p.z()});
  }
  EXPECT_TRUE(test_maps::have_same_bits(images, reference()));
}

TEST(Vertex_point_map, replaces_the_points_of_the_mesh)
{
  // The mesh has other points; those of the test are in a map, and of another kernel than the images.
  const Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(test_meshes::icosphere(2));
  const auto points = test_meshes::make_vertex_map<Double::Point_3>(mesh, list().points);
  const auto map = test_maps::make_sentinel_map<Epick::Point_3>(mesh);
  ASSERT_EQ(SP::parameterize(mesh, map, params::vertex_point_map(points)), SP::OK);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, map), reference()));
  SP::Bijective_low_distortion_parameterizer_3<Surface_mesh> bld;
  ASSERT_EQ(SP::parameterize(mesh, bld, map, params::vertex_point_map(points).number_of_iterations(100u)), SP::OK);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, map), reference()));
  ASSERT_EQ(SP::parameterize(mesh, map), SP::OK);
  EXPECT_FALSE(test_maps::have_same_bits(test_maps::images(mesh, map), reference()));
}

// Nothing but what the concept WritablePropertyMap asks for.
struct Write_only_map
{
  using key_type = Surface_mesh::Vertex_index;
  using value_type = Epick::Point_3;
  using reference = void;
  using category = boost::writable_property_map_tag;

  friend void put(const Write_only_map& map, key_type v, const value_type& p) { map.points->emplace(v, p); }

  std::map<key_type, value_type>* points;
};

TEST(Vertex_sphere_map, needs_to_be_writable_only)
{
  const Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(list());
  std::map<Surface_mesh::Vertex_index, Epick::Point_3> points;
  ASSERT_EQ(SP::parameterize(mesh, Write_only_map{&points}), SP::OK);
  std::vector<Coordinates> images;
  for(const auto& point : points)
  {
    images.push_back({point.second.x(), point.second.y(), point.second.z()});
  }
  EXPECT_TRUE(test_maps::have_same_bits(images, reference()));
}

// a face of size 1e-12, whose corners cannot be told from each other by numbers of single precision
Triangle_list with_a_tiny_face()
{
  Triangle_list graded = test_meshes::icosphere(1);
  const test_meshes::Triangle t = graded.triangles[0];
  const Coordinates &a = graded.points[t[0]], &b = graded.points[t[1]], &c = graded.points[t[2]];
  for(int k = 0; k < 3; ++k) // a tiny triangle in the middle of a face
  {
    const double s = 1. / 3. + (k == 0 ? 1e-12 : 0.), u = 1. / 3. + (k == 1 ? 1e-12 : 0.), w = 1. - s - u;
    graded.points.push_back(
        {s * a[0] + u * b[0] + w * c[0], s * a[1] + u * b[1] + w * c[1], s * a[2] + u * b[2] + w * c[2]});
  }
  const std::size_t n = graded.points.size();
  graded.triangles.erase(graded.triangles.begin());
  for(const test_meshes::Triangle& triangle : {test_meshes::Triangle{n - 3, n - 2, n - 1},
                                               {t[0], t[1], n - 3},
                                               {t[1], n - 2, n - 3},
                                               {t[1], t[2], n - 2},
                                               {t[2], n - 1, n - 2},
                                               {t[2], t[0], n - 1},
                                               {t[0], n - 3, n - 1}})
  {
    graded.triangles.push_back(triangle);
  }
  return graded;
}

// The certificate is for the points as they are written: of floats here.
TEST(Vertex_sphere_map, may_be_of_single_precision)
{
  const Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(list());
  const auto map = test_maps::make_sentinel_map<Float::Point_3>(mesh);
  ASSERT_EQ(SP::parameterize(mesh, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  EXPECT_LT(test_maps::largest_distance(test_maps::images(mesh, map), reference()), 1e-6);

  const Surface_mesh fine = test_meshes::make_mesh<Surface_mesh>(with_a_tiny_face());
  const auto single = test_maps::make_sentinel_map<Float::Point_3>(fine);
  const std::vector<Coordinates> before = test_maps::images(fine, single);
  EXPECT_EQ(SP::parameterize(fine, single), SP::ERROR_INSUFFICIENT_PRECISION);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(fine, single), before));
  EXPECT_EQ(SP::parameterize(fine, test_maps::make_sentinel_map<Epick::Point_3>(fine)), SP::OK);
}

// What a map hands out are doubles, but what it keeps are not, as with the points of OpenMesh.
struct Rounding_map
{
  using key_type = Surface_mesh::Vertex_index;
  using value_type = Epick::Point_3;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  friend value_type get(const Rounding_map& map, key_type v)
  {
    const Float::Point_3& p = get(map.kept, v);
    return {static_cast<double>(p.x()), static_cast<double>(p.y()), static_cast<double>(p.z())};
  }
  friend void put(const Rounding_map& map, key_type v, const value_type& p)
  {
    put(map.kept, v, Float::Point_3(map.rounded(p.x()), map.rounded(p.y()), map.rounded(p.z())));
  }

  float rounded(double x) const
  {
    const float y = static_cast<float>(x);
    return unit > 0.f ? unit * std::round(y / unit) : y;
  }

  decltype(test_maps::make_sentinel_map<Float::Point_3>(Surface_mesh())) kept;
  float unit = 0.f; // of which the coordinates are multiples, if any
};

TEST(Vertex_sphere_map, may_keep_other_values_than_it_was_given)
{
  const Surface_mesh mesh = test_meshes::make_mesh<Surface_mesh>(list());
  const Rounding_map map = {test_maps::make_sentinel_map<Float::Point_3>(mesh)};
  ASSERT_EQ(SP::parameterize(mesh, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  EXPECT_LT(test_maps::largest_distance(test_maps::images(mesh, map), reference()), 1e-6);

  const Surface_mesh fine = test_meshes::make_mesh<Surface_mesh>(with_a_tiny_face());
  const Rounding_map single = {test_maps::make_sentinel_map<Float::Point_3>(fine)};
  const std::vector<Coordinates> before = test_maps::images(fine, single);
  EXPECT_EQ(SP::parameterize(fine, single), SP::ERROR_INSUFFICIENT_PRECISION);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(fine, single), before));
  // beyond the largest number that is kept
  const Surface_mesh huge = test_meshes::make_mesh<Surface_mesh>(test_meshes::scaled(list(), 1e200, 1e200, 1e200));
  const Rounding_map narrow = {test_maps::make_sentinel_map<Float::Point_3>(huge)};
  const std::vector<Coordinates> before_narrow = test_maps::images(huge, narrow);
  EXPECT_EQ(SP::parameterize(huge, narrow), SP::ERROR_INSUFFICIENT_PRECISION);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(huge, narrow), before_narrow));
  EXPECT_EQ(SP::parameterize(huge, SP::ARAP_parameterizer_3<Surface_mesh>(), narrow), SP::ERROR_INSUFFICIENT_PRECISION);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(huge, narrow), before_narrow));

  // A method that promises nothing writes the map, and says what it is as it has been kept.
  const Rounding_map rough = {test_maps::make_sentinel_map<Float::Point_3>(mesh), 1.f};
  EXPECT_EQ(SP::parameterize(mesh, SP::ARAP_parameterizer_3<Surface_mesh>(), map), SP::OK);
  EXPECT_EQ(SP::parameterize(mesh, SP::ARAP_parameterizer_3<Surface_mesh>(), rough), SP::ERROR_NO_1_TO_1_MAPPING);
  for(const Coordinates& p : test_maps::images(mesh, rough))
  {
    EXPECT_TRUE(std::abs(p[0]) <= 2. && p[0] == std::round(p[0]));
  }
}

// A view of one component of a mesh.
TEST(Face_filtered_graph, is_mapped)
{
  Surface_mesh mesh =
      test_meshes::make_mesh<Surface_mesh>(test_meshes::disjoint_union(test_meshes::icosphere(0), list()));
  auto component = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:component", 0).first;
  std::size_t k = 0;
  for(const auto f : faces(mesh))
  {
    component[f] = k++ < test_meshes::icosphere(0).triangles.size() ? 0 : 1;
  }
  const CGAL::Face_filtered_graph<Surface_mesh> view(mesh, std::size_t(1), component);
  auto map =
      mesh.add_property_map<Surface_mesh::Vertex_index, Epick::Point_3>("v:sphere", Epick::Point_3(7, 8, 9)).first;
  ASSERT_EQ(SP::parameterize(view, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(view, map));
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(view, map), reference()));
  EXPECT_EQ(map[Surface_mesh::Vertex_index(0)], Epick::Point_3(7, 8, 9));
}

} // namespace
