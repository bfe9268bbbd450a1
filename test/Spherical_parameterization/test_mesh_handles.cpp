// Each handle of a surface gets a closed path of edges, and these do not separate the surface, nor are they much longer than they
// have to be.

#include "methods.h"

#include <CGAL/Spherical_parameterization/Repair/find_handles.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

using namespace test;

namespace {

using Handles = std::vector<SP::Handle<Mesh>>;

// A path may meet a vertex twice, on both sides of another one, where the surface has no size that distinguishes paths.
Handles expect_handles(const Triangle_list& list, std::size_t genus, bool are_simple = true)
{
  Mesh mesh = make(list);
  EXPECT_EQ(SP::find_defect(mesh).count, genus);
  Handles handles;
  EXPECT_EQ(SP::find_handles(mesh, handles), SP::OK);
  EXPECT_EQ(handles.size(), genus);
  const auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first;
  for(const auto& handle : handles)
  {
    EXPECT_GE(handle.path.size(), 3u);
    EXPECT_TRUE(!are_simple ||
                std::set<Mesh::Vertex_index>(handle.path.begin(), handle.path.end()).size() == handle.path.size());
    double length = 0.;
    for(std::size_t k = 0; k < handle.path.size(); ++k)
    {
      const Mesh::Vertex_index v = handle.path[k], w = handle.path[(k + 1) % handle.path.size()];
      const auto [h, is_edge] = halfedge(v, w, mesh);
      EXPECT_TRUE(is_edge);
      is_cut[edge(h, mesh)] = true;
      length += distance(list.points[v], list.points[w]);
    }
    EXPECT_NEAR(handle.length, length, 1e-12 * length);
  }
  const auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  EXPECT_EQ(CGAL::Polygon_mesh_processing::connected_components(mesh, component,
                                                                CGAL::parameters::edge_is_constrained_map(is_cut)),
            1u)
      << "the paths separate the surface";
  return handles;
}

// A sphere, and n times: two of its faces, far from the others, are joined by a tube.
Triangle_list sphere_with_tubes(std::size_t n)
{
  Triangle_list list = icosphere(3);
  std::set<std::size_t> used;
  std::vector<std::size_t> faces;
  for(std::size_t f = 0; f < list.triangles.size() && faces.size() < 2 * n; f += 7)
    if(std::none_of(list.triangles[f].begin(), list.triangles[f].end(),
                    [&](std::size_t v) { return used.count(v) > 0; }))
    {
      faces.push_back(f);
      for(const Triangle& t : list.triangles)
        for(const std::size_t v : list.triangles[f])
          if(std::count(t.begin(), t.end(), v) > 0)
            used.insert(t.begin(), t.end());
    }
  EXPECT_EQ(faces.size(), 2 * n);
  for(std::size_t k = 0; k < n; ++k)
  {
    const Triangle a = list.triangles[faces[2 * k]], b = list.triangles[faces[2 * k + 1]];
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3;
      list.triangles.push_back({a[i], a[j], b[(3 - i) % 3]});
      list.triangles.push_back({a[j], b[(3 - j) % 3], b[(3 - i) % 3]});
    }
  }
  std::sort(faces.rbegin(), faces.rend());
  for(const std::size_t f : faces)
    list.triangles.erase(list.triangles.begin() + static_cast<std::ptrdiff_t>(f));
  return list;
}

TEST(Find_handles, finds_the_shortest_way_around_a_torus)
{
  for(const auto& [m, n] : {std::pair<std::size_t, std::size_t>(40, 9), {9, 40}, {3, 3}, {200, 5}})
  {
    const Handles handles = expect_handles(torus(m, n), 1);
    EXPECT_LE(handles.at(0).path.size(), (std::max)(m, n));
  }
  EXPECT_EQ(expect_handles(torus(60, 8), 1).at(0).path.size(), 8u);
}

TEST(Find_handles, finds_all_of_many)
{
  for(const std::size_t n : std::vector<std::size_t>{1, 2, 5, 9})
  {
    const Handles handles = expect_handles(sphere_with_tubes(n), n);
    for(const auto& handle : handles) // around a tube, near its thinnest
      EXPECT_LE(handle.path.size(), 8u);
  }
  Handles handles;
  EXPECT_EQ(SP::find_handles(make(sphere_with_tubes(5)), handles, CGAL::parameters::maximum_number(2)), SP::OK);
  EXPECT_EQ(handles.size(), 2u);
}

TEST(Find_handles, does_not_depend_on_sizes_and_shapes)
{
  const Triangle_list list = sphere_with_tubes(3);
  const Handles handles = expect_handles(list, 3);
  for(const double scale : {1e-290, 1e290})
  {
    Handles scaled;
    EXPECT_EQ(SP::find_handles(make(test_meshes::scaled(list, scale, scale, scale)), scaled), SP::OK);
    ASSERT_EQ(scaled.size(), 3u);
    for(std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(scaled[k].length / scale / handles[k].length, 1., 1e-12);
  }
  expect_handles(test_meshes::scaled(list, 1., 0., 0.), 3, false);
  EXPECT_EQ(expect_handles(test_meshes::scaled(list, 0., 0., 0.), 3, false).at(0).length, 0.);
}

TEST(Find_handles, finds_none_where_there_are_none)
{
  expect_handles(bumpy_sphere(2), 0);
  Handles handles(1);
  Triangle_list list = torus(5, 5);
  EXPECT_EQ(SP::find_handles(make(test_meshes::disjoint_union(list, list)), handles), SP::ERROR_SEVERAL_COMPONENTS);
  EXPECT_TRUE(handles.empty());
  list.points[3][1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(SP::find_handles(make(list), handles), SP::ERROR_NON_FINITE_COORDINATE);
  list.triangles.pop_back();
  EXPECT_EQ(SP::find_handles(make(list), handles), SP::ERROR_NON_CLOSED_MESH);
}

} // namespace
