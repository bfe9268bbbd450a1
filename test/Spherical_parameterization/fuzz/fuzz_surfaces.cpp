// A fuzzer for what is found between two surfaces: the bytes subdivide two octahedra, which are the maps to the sphere, move
// their vertices, and place the surfaces. What coincides, as the points are sums of few, is the rule. Each function has to
// succeed if a judge with rational numbers calls the maps one-to-one, and to refuse them otherwise.

#include "Fuzzed_bytes.h"
#include "require.h"

#include "judge.h"
#include "methods.h"
#include "random_meshes.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sphere_locator_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/map_surface.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>
#include <CGAL/Spherical_parameterization/Sampling/remesh_through_sphere.h>
#include <CGAL/Spherical_parameterization/Sampling/transfer.h>

#include <gtest/gtest.h>

using namespace test;

namespace {

using Tag = CGAL::Sequential_tag;
using Vertex_index = Mesh::Vertex_index;
using Value_map = Mesh::Property_map<Vertex_index, double>;

// each vertex costs time
constexpr std::size_t max_vertices = 16;

// An octahedron with new vertices in faces and on edges, at sums of corners, so that it stays one-to-one but for rounding;
// some of the vertices may be moved anywhere.
Triangle_list fuzzed_map(Fuzzed_bytes& bytes)
{
  Triangle_list list = octahedron();
  const bool may_move = bytes.below(4) == 0;
  const std::size_t n_steps = bytes.below(2 * max_vertices);
  for(std::size_t k = 0; k < n_steps && list.points.size() < max_vertices; ++k)
  {
    const std::size_t kind = bytes.below(may_move ? 8 : 7), f = bytes.below(list.triangles.size());
    const Triangle t = list.triangles[f];
    const double s = static_cast<double>(1 + bytes.below(3)), r = static_cast<double>(1 + bytes.below(3));
    const std::size_t v = list.points.size();
    if(kind < 4) // into the face
    {
      list.points.push_back(
          combination(1., combination(s, list.points[t[0]], r, list.points[t[1]]), 1., list.points[t[2]]));
      list.triangles[f] = {t[0], t[1], v};
      list.triangles.push_back({t[1], t[2], v});
      list.triangles.push_back({t[2], t[0], v});
    }
    else if(kind < 7) // onto the first edge, of two faces
    {
      list.points.push_back(combination(s, list.points[t[0]], r, list.points[t[1]]));
      list.triangles[f] = {v, t[1], t[2]};
      list.triangles.push_back({t[0], v, t[2]});
      for(std::size_t g = 0; g < list.triangles.size(); ++g)
        for(std::size_t i = 0; i < 3; ++i)
        {
          const Triangle u = list.triangles[g];
          if(u[i] == t[1] && u[(i + 1) % 3] == t[0])
          {
            list.triangles[g] = {t[1], v, u[(i + 2) % 3]};
            list.triangles.push_back({v, t[0], u[(i + 2) % 3]});
          }
        }
    }
    else
      for(double& x : list.points[t[0]])
        x = bytes.below(4) == 0 ? bytes.special_number() : bytes.small_integer();
  }
  return list;
}

// a surface with the faces of a map: that itself, or with any points, at any scale
Mesh fuzzed_surface(const Triangle_list& map, Fuzzed_bytes& bytes)
{
  Triangle_list list = map;
  const std::size_t kind = bytes.below(3);
  const int exponent = kind == 1 ? static_cast<int>(bytes.below(1800)) - 900 : 0;
  if(kind > 0)
    for(Coordinates& p : list.points)
      for(double& x : p)
        x = kind == 2 && bytes.below(16) == 0 ? bytes.special_number() : std::ldexp(bytes.small_integer(), exponent);
  return make(list);
}

// Whether numbers are so near to each other that doubles hold any map of one surface onto another one.
bool is_ordinary(const Images& points)
{
  double min = HUGE_VAL, max = 0.;
  for(const Coordinates& p : points)
    for(const double x : p)
      if(x != 0.)
      {
        min = (std::min)(min, std::abs(x));
        max = (std::max)(max, std::abs(x));
      }
  return max <= 1e50 * min;
}

// A surface with its map, and what is to be said of them.
struct Fuzzed_surface
{
  explicit Fuzzed_surface(Fuzzed_bytes& bytes)
    : list(fuzzed_map(bytes))
    , mesh(fuzzed_surface(list, bytes))
    , sphere(mesh, list.points)
    , is_one_to_one(is_finite(list.points) && judge::is_one_to_one(list.points, list.triangles))
    , is_good(is_one_to_one && is_finite(points(mesh)))
  {}

  Triangle_list list;
  Mesh mesh;
  Point_map sphere;
  bool is_one_to_one, is_good;
};

void expect_refused_unless(bool is_good, SP::Error_code error)
{
  EXPECT_EQ(error == SP::OK, is_good) << SP::get_error_message(error);
}

void check_overlay(const Fuzzed_surface& a, const Fuzzed_surface& b)
{
  SP::Surface_overlay_3<Mesh, Mesh> overlay;
  expect_refused_unless(a.is_good && b.is_good, SP::overlay<Tag>(a.mesh, a.sphere, b.mesh, b.sphere, overlay));
  if(!a.is_good || !b.is_good)
    return;
  EXPECT_EQ(overlay.triangles.size(), 2 * overlay.points.size() - 4);
  std::set<std::array<std::uint32_t, 2>> edges;
  for(const auto& t : overlay.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      EXPECT_TRUE(edges.insert({t[i], t[(i + 1) % 3]}).second);
  for(const auto& [v, w] : edges)
    EXPECT_TRUE(edges.count({w, v}) > 0);
}

void check_locator(const Fuzzed_surface& a, const Fuzzed_surface& b)
{
  const SP::Sphere_locator_3<Mesh, Point_map, Tag> locator(a.mesh, a.sphere);
  expect_refused_unless(a.is_one_to_one, locator.error_code());
  if(!a.is_one_to_one || !b.is_one_to_one)
    return;
  for(const Coordinates& q : b.list.points)
  {
    const auto location = locator.locate(Point_3(q[0], q[1], q[2]));
    const Triangle t = a.list.triangles.at(location.first);
    for(std::size_t i = 0; i < 3; ++i)
      EXPECT_GE(judge::sign_of_determinant(a.list.points[t[i]], a.list.points[t[(i + 1) % 3]], q), 0);
  }
}

void check_transfer(Fuzzed_surface& a, Fuzzed_surface& b)
{
  const Value_map from = a.mesh.add_property_map<Vertex_index, double>("v:from").first,
                  to = b.mesh.add_property_map<Vertex_index, double>("v:to", -1.).first;
  for(const Vertex_index v : a.mesh.vertices())
    from[v] = v.idx() % 2 == 0 ? 1. : 2.;
  const bool is_good = a.is_good && b.is_one_to_one;
  expect_refused_unless(is_good, SP::transfer<Tag>(a.mesh, a.sphere, b.mesh, b.sphere, std::pair(from, to)));
  for(const Vertex_index v : b.mesh.vertices())
    EXPECT_TRUE(is_good ? to[v] > 1. - 1e-12 && to[v] < 2. + 1e-12 : to[v] == -1.) << to[v];
}

void check_remesh(const Fuzzed_surface& a, const Fuzzed_surface& b)
{
  SP::Sphere_domain_3 domain;
  expect_refused_unless(b.is_one_to_one, SP::make_sphere_domain(b.mesh, b.sphere, domain));
  Mesh remesh;
  const auto sphere = remesh.add_property_map<Vertex_index, Point_3>("v:sphere").first;
  if(!b.is_one_to_one)
    return;
  expect_refused_unless(a.is_good, SP::remesh_through_sphere<Tag>(a.mesh, a.sphere, domain, remesh, sphere));
  EXPECT_EQ(remesh.number_of_vertices(), a.is_good ? b.list.points.size() : 0);
}

void check_map(const Fuzzed_surface& a, const Fuzzed_surface& b, Fuzzed_bytes& bytes)
{
  using Mapper = SP::Surface_mapper_3<Mesh>;
  std::vector<Mapper::Landmark> landmarks;
  std::set<std::size_t> used_of_a, used_of_b;
  for(std::size_t n = 3 + bytes.below(3); n > 0; --n)
  {
    const std::size_t v = bytes.below(a.list.points.size()), w = bytes.below(b.list.points.size());
    if(used_of_a.insert(v).second && used_of_b.insert(w).second)
      landmarks.emplace_back(Vertex_index(static_cast<Mesh::size_type>(v)),
                             Vertex_index(static_cast<Mesh::size_type>(w)));
  }
  if(landmarks.size() < 3) // The search for a rotation would take all the time.
    return;
  Mapper mapper = Mapper().landmarks(landmarks);
  if(bytes.below(2) == 0)
    mapper = mapper.landmark_weight(static_cast<double>(1 + bytes.below(100)));
  const Point_map images(a.mesh, sentinels(a.list.points.size()));
  const SP::Error_code error = SP::map_surface<Tag>(a.mesh, a.sphere, b.mesh, b.sphere, mapper, images);
  const bool may_be_too_fine = !is_ordinary(a.list.points) || !is_ordinary(points(a.mesh)) ||
                               !is_ordinary(b.list.points) || !is_ordinary(points(b.mesh));
  if(error != SP::ERROR_INSUFFICIENT_PRECISION || !may_be_too_fine)
    expect_refused_unless(a.is_good && b.is_good, error);
  const Images found = test::images(a.mesh, images);
  if(error == SP::OK)
  {
    EXPECT_TRUE(judge::is_one_to_one(found, a.list.triangles));
  }
  else
  {
    EXPECT_TRUE(have_same_bits(found, sentinels(a.list.points.size())));
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  require_expectations();
  Fuzzed_bytes bytes(data, size);
  Fuzzed_surface a(bytes), b(bytes);
  EXPECT_EQ(is_bijective(a.mesh, a.list.points), a.is_one_to_one);
  check_overlay(a, b);
  check_locator(a, b);
  check_transfer(a, b);
  check_remesh(a, b);
  check_map(a, b, bytes);
  return 0;
}
