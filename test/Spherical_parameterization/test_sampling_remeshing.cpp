// The domains triangulate the sphere; what is sampled through them, or carried from mesh to mesh, is what the rules of the
// documentation say.

#include <CGAL/Spherical_parameterization/Sampling/remesh_through_sphere.h>
#include <CGAL/Spherical_parameterization/Sampling/transfer.h>

#include "broken_maps.h"
#include "methods.h"
#include "random_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

using namespace test;

namespace {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Vertex_index = Mesh::Vertex_index;
using Face_index = Mesh::Face_index;
using Images_of_mesh = Mesh::Property_map<Vertex_index, Point_3>;
using Domain = SP::Sphere_domain_3;

Coordinates coordinates(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

Point_3 scaled_by_power(const Point_3& p, int exponent)
{
  return Point_3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
}

// A mesh with a map to the sphere, as a property of its vertices.
struct Mapped_mesh
{
  Mapped_mesh(const Triangle_list& surface, const Images& images)
    : mesh(make(surface))
    , sphere(mesh.add_property_map<Vertex_index, Point_3>("v:sphere").first)
  {
    for(const Vertex_index v : mesh.vertices())
      sphere[v] = Point_3(images[v][0], images[v][1], images[v][2]);
  }
  explicit Mapped_mesh(const Triangle_list& surface)
    : Mapped_mesh(surface, surface.points)
  {}

  template <class Index, class T>
  auto add(const std::string& name)
  {
    return mesh.add_property_map<Index, T>(name).first;
  }

  void scale(int exponent)
  {
    for(Point_3& p : mesh.points())
      p = scaled_by_power(p, exponent);
  }

  Mesh mesh;
  Images_of_mesh sphere;
};

Mapped_mesh ellipsoid_on_sphere(unsigned int subdivisions)
{
  return {scaled(icosphere(subdivisions), 3., 2., 1.), icosphere(subdivisions).points};
}

struct Remesh
{
  Remesh(const Mapped_mesh& source, const Domain& domain)
    : sphere(mesh.add_property_map<Vertex_index, Point_3>("v:sphere").first)
    , normals(mesh.add_property_map<Vertex_index, Kernel::Vector_3>("v:normal").first)
    , error(SP::remesh_through_sphere(source.mesh, source.sphere, domain, mesh, sphere,
                                      CGAL::parameters::default_values(), CGAL::parameters::vertex_normal_map(normals)))
  {}

  Mesh mesh;
  Images_of_mesh sphere;
  Mesh::Property_map<Vertex_index, Kernel::Vector_3> normals;
  SP::Error_code error;
};

template <class Index, class T, class Make>
void fill(Mapped_mesh& source, const std::string& name, const Make& make_value)
{
  auto map = source.add<Index, T>(name);
  std::size_t i = 0;
  for(auto&& value : map)
    value = make_value(i++);
}

double sine(std::size_t i)
{
  return std::sin(static_cast<double>(i));
}

// of meshes that have no such properties yet
void add_numbers(Mapped_mesh& source)
{
  fill<Vertex_index, double>(source, "v:x", sine);
  fill<Face_index, double>(source, "f:x", sine);
}

SP::Error_code transfer(const Mapped_mesh& source, Mapped_mesh& target)
{
  return SP::transfer(source.mesh, source.sphere, target.mesh, target.sphere);
}

// of meshes that have this property
template <class Index, class T>
void expect_same(Mesh& a, Mesh& b, const std::string& name)
{
  SCOPED_TRACE(name);
  const auto [from, is_new] = a.add_property_map<Index, T>(name);
  const auto [to, is_new_too] = b.add_property_map<Index, T>(name);
  ASSERT_FALSE(is_new || is_new_too);
  EXPECT_TRUE(std::equal(from.begin(), from.end(), to.begin(), to.end()));
}

struct Solid
{
  Domain (*make)(std::uint32_t);
  std::size_t factor; // of n^2 in the number of vertices
  double evenness;    // the largest area over the smallest one that is documented
};
const std::array<Solid, 3> solids = {
    {{&Domain::octahedron, 4, 1.8}, {&Domain::cube, 6, 1.7}, {&Domain::icosahedron, 10, 1.2}}};

TEST(Domains, triangulate_the_sphere_evenly)
{
  for(const Solid& solid : solids)
    for(const std::uint32_t n : {1u, 2u, 3u, 10u, 33u})
    {
      SCOPED_TRACE(std::to_string(solid.factor) + " " + std::to_string(n));
      const Domain domain = solid.make(n);
      const Triangle_list list = list_of(domain);
      EXPECT_EQ(list.points.size(), solid.factor * n * n + 2);
      EXPECT_EQ(list.triangles.size(), 2 * solid.factor * n * n);
      const Mesh mesh = make(list);
      EXPECT_TRUE(SP::is_bijective(mesh, mesh.points()));
      double min = 1e9, max = 0.;
      for(const Triangle& t : list.triangles)
      {
        const double a = area(list.points[t[0]], list.points[t[1]], list.points[t[2]]);
        min = (std::min)(min, a);
        max = (std::max)(max, a);
      }
      EXPECT_LE(max / min, solid.evenness);
      for(const Coordinates& p : list.points)
        EXPECT_NEAR(norm(p), 1., 1e-15);
    }
}

// An octahedron's edge from the x-axis to the y-axis
TEST(Domains, have_edges_of_equal_arcs)
{
  const Triangle_list list = list_of(Domain::octahedron(5));
  for(int i = 0; i <= 5; ++i)
  {
    const Coordinates expected = {std::cos(i * pi / 10.), std::sin(i * pi / 10.), 0.};
    EXPECT_TRUE(std::any_of(list.points.begin(), list.points.end(), [&](const Coordinates& p) {
      return distance(p, expected) < 1e-15;
    })) << i;
  }
}

TEST(Domains, are_divided_into_one_or_more)
{
  for(const Solid& solid : solids)
    for(const std::uint32_t n : {0u, Domain::max_subdivision + 1})
    {
      EXPECT_TRUE(solid.make(n).is_empty());
      EXPECT_TRUE(solid.make(n).directions().empty());
    }
}

TEST(Domains, of_meshes_are_bijections)
{
  const Mapped_mesh mapped = ellipsoid_on_sphere(1);
  Domain domain = Domain::cube(1);
  EXPECT_EQ(SP::make_sphere_domain(mapped.mesh, mapped.sphere, domain), SP::OK);
  EXPECT_EQ(list_of(domain).triangles, triangles(mapped.mesh));
  for(const auto& [list, error] : broken_maps())
  {
    const Mesh mesh = make(list);
    EXPECT_EQ(SP::make_sphere_domain(mesh, mesh.points(), domain), error);
    EXPECT_EQ(list_of(domain).points, icosphere(1).points); // as it was
  }
}

TEST(Remeshing, by_the_mesh_itself_is_the_identity)
{
  const Mapped_mesh source(scaled(random_stacked_sphere(200, 1), 1., 2., 3.), random_stacked_sphere(200, 1).points);
  Domain domain;
  ASSERT_EQ(SP::make_sphere_domain(source.mesh, source.sphere, domain), SP::OK);
  const Remesh remesh(source, domain);
  ASSERT_EQ(remesh.error, SP::OK);
  EXPECT_EQ(points(remesh.mesh), points(source.mesh));
  EXPECT_EQ(triangles(remesh.mesh), triangles(source.mesh));
  EXPECT_TRUE(std::equal(source.sphere.begin(), source.sphere.end(), remesh.sphere.begin(), remesh.sphere.end()));
}

// A surface that is an affine image of the polyhedron that it is mapped to: each sample is known.
TEST(Remeshing, has_its_vertices_where_the_directions_lead)
{
  const Mapped_mesh source = ellipsoid_on_sphere(2);
  for(const Solid& solid : solids)
  {
    const Domain domain = solid.make(9);
    const Remesh remesh(source, domain);
    ASSERT_EQ(remesh.error, SP::OK);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(remesh.mesh));
    EXPECT_TRUE(CGAL::is_closed(remesh.mesh));
    EXPECT_EQ(triangles(remesh.mesh), list_of(domain).triangles);
    for(const Vertex_index v : remesh.mesh.vertices())
    {
      EXPECT_EQ(remesh.sphere[v], domain.directions()[v]);
      const Coordinates q = coordinates(domain.directions()[v]), p = coordinates(remesh.mesh.point(v));
      const Coordinates image = {p[0] / 3., p[1] / 2., p[2]};
      EXPECT_LT(norm(cross(image, q)), 1e-15);
      EXPECT_GT(dot(image, q), 0.9); // the polyhedron is near the unit sphere
    }
  }
}

TEST(Remeshing, gives_normals_of_the_surface)
{
  const Remesh remesh(Mapped_mesh(icosphere(4)), Domain::cube(5));
  ASSERT_EQ(remesh.error, SP::OK);
  for(const Vertex_index v : remesh.mesh.vertices())
  {
    EXPECT_NEAR(remesh.normals[v].squared_length(), 1., 1e-14);
    EXPECT_GT(remesh.normals[v] * (remesh.sphere[v] - CGAL::ORIGIN), 0.9995);
  }
}

// Other meshes and kernels, points that are not the mesh's own, and a mesh that has something already.
TEST(Remeshing, adds_to_any_mesh)
{
  const Triangle_list list = icosphere(1);
  const auto exact = make_mesh<CGAL::Surface_mesh<Epeck::Point_3>>(list);
  CGAL::Polyhedron_3<Kernel> polyhedron = make_mesh<CGAL::Polyhedron_3<Kernel>>(tetrahedron());
  std::map<CGAL::Polyhedron_3<Kernel>::Vertex_handle, CGAL::Simple_cartesian<float>::Point_3> sphere;
  const auto moved = [](const Epeck::Point_3& p) { return p + Epeck::Vector_3(5, 0, 0); };
  std::map<CGAL::Surface_mesh<Epeck::Point_3>::Vertex_index, Epeck::Point_3> moved_points;
  for(const auto v : exact.vertices())
    moved_points[v] = moved(exact.point(v));
  ASSERT_EQ(SP::remesh_through_sphere(exact, exact.points(), Domain::octahedron(2), polyhedron,
                                      boost::make_assoc_property_map(sphere),
                                      CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(moved_points))),
            SP::OK);
  EXPECT_EQ(polyhedron.size_of_vertices(), 4u + 18u);
  EXPECT_EQ(polyhedron.size_of_facets(), 4u + 32u);
  EXPECT_TRUE(polyhedron.is_valid());
  EXPECT_TRUE(polyhedron.is_closed());
  ASSERT_EQ(sphere.size(), 18u);
  for(const auto& [vertex, direction] : sphere)
  {
    const auto p = vertex->point();
    EXPECT_LT(distance({p.x() - 5., p.y(), p.z()}, {direction.x(), direction.y(), direction.z()}), 0.21);
  }
}

TEST(Remeshing, refuses_what_is_no_bijection)
{
  const auto expect = [&](const Mapped_mesh& source, const Domain& domain, SP::Error_code error) {
    const Remesh remesh(source, domain);
    EXPECT_EQ(remesh.error, error);
    EXPECT_TRUE(remesh.mesh.is_empty());
  };
  Mapped_mesh source = ellipsoid_on_sphere(1);
  expect(source, Domain::cube(0), SP::ERROR_INVALID_DOMAIN);
  expect(source, Domain(), SP::ERROR_INVALID_DOMAIN);
  for(const auto& [list, error] : broken_maps())
    expect(Mapped_mesh(list), Domain::cube(1), error);
  source.mesh.point(Vertex_index(3)) = Point_3(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  expect(source, Domain::cube(1), SP::ERROR_NON_FINITE_COORDINATE);

  const Mapped_mesh good(icosphere(1));
  Mesh mesh;
  EXPECT_EQ(SP::remesh_through_sphere(good.mesh, good.sphere, Domain::cube(2), mesh,
                                      mesh.add_property_map<Vertex_index, Point_3>("v:sphere").first,
                                      CGAL::parameters::maximum_running_time(1e-9)),
            SP::ERROR_STOPPED);
  EXPECT_TRUE(mesh.is_empty());
}

// Fourth powers of lengths would overflow and underflow.
TEST(Remeshing, does_not_depend_on_the_unit)
{
  const auto remeshed = [](int exponent) {
    Mapped_mesh source = ellipsoid_on_sphere(4);
    add_numbers(source);
    source.scale(exponent);
    return Remesh(source, Domain::icosahedron(2));
  };
  Remesh expected = remeshed(0);
  for(const int exponent : {-996, -270, 270, 510, 996}) // 1e-300, 1e-81, 1e81, 1e153, 1e300
  {
    SCOPED_TRACE(exponent);
    Remesh result = remeshed(exponent);
    ASSERT_EQ(result.error, SP::OK);
    for(const Vertex_index v : result.mesh.vertices())
      EXPECT_EQ(result.mesh.point(v), scaled_by_power(expected.mesh.point(v), exponent));
    expect_same<Vertex_index, double>(expected.mesh, result.mesh, "v:x");
    expect_same<Face_index, double>(expected.mesh, result.mesh, "f:x");
    expect_same<Vertex_index, Kernel::Vector_3>(expected.mesh, result.mesh, "v:normal");
  }
}

// Memory that runs out.
std::size_t n_allocations_left = 0;
template <class T>
struct Scarce_allocator : std::allocator<T>
{
  template <class U>
  struct rebind
  {
    using other = Scarce_allocator<U>;
  };
  Scarce_allocator() = default;
  template <class U>
  Scarce_allocator(const Scarce_allocator<U>&)
  {}
  T* allocate(std::size_t n)
  {
    if(n_allocations_left == 0)
      throw std::bad_alloc();
    --n_allocations_left;
    return std::allocator<T>::allocate(n);
  }
};
using Scarce_polyhedron =
    CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_3, CGAL::HalfedgeDS_default, Scarce_allocator<int>>;

TEST(Remeshing, leaves_the_mesh_as_it_was_if_memory_runs_out)
{
  const Mapped_mesh source = ellipsoid_on_sphere(1);
  n_allocations_left = 1000;
  Scarce_polyhedron mesh = make_mesh<Scarce_polyhedron>(tetrahedron());
  std::map<Scarce_polyhedron::Vertex_handle, Point_3> sphere;
  std::size_t n_failures = 0;
  for(bool has_failed = true; has_failed; n_failures += has_failed)
  {
    n_allocations_left = n_failures;
    has_failed = false;
    try
    {
      ASSERT_EQ(SP::remesh_through_sphere(source.mesh, source.sphere, Domain::octahedron(1), mesh,
                                          boost::make_assoc_property_map(sphere)),
                SP::OK);
    }
    catch(const std::bad_alloc&)
    {
      has_failed = true;
    }
    ASSERT_EQ(mesh.size_of_vertices(), has_failed ? 4u : 10u);
    ASSERT_EQ(mesh.size_of_halfedges(), has_failed ? 12u : 36u);
    ASSERT_EQ(mesh.size_of_facets(), has_failed ? 4u : 12u);
    ASSERT_TRUE(mesh.is_valid());
    ASSERT_TRUE(mesh.is_closed());
  }
  EXPECT_GE(n_failures, 6u + 12u + 8u);
}

TEST(Remeshing, leaves_the_mesh_as_it_was_if_a_map_throws)
{
  const Mapped_mesh source = ellipsoid_on_sphere(1);
  Mesh mesh = make(tetrahedron());
  std::size_t n_left = 5;
  const Full_map<Vertex_index, Point_3> sphere{&n_left};
  const auto remesh = [&] {
    return SP::remesh_through_sphere(source.mesh, source.sphere, Domain::octahedron(1), mesh, sphere);
  };
  EXPECT_THROW((void)remesh(), std::length_error);
  EXPECT_EQ(points(mesh), tetrahedron().points);
  EXPECT_EQ(triangles(mesh), triangles(make(tetrahedron())));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  n_left = 6;
  EXPECT_EQ(remesh(), SP::OK);
  EXPECT_EQ(mesh.number_of_vertices(), 4u + 6u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
}

TEST(Transfer, from_a_mesh_to_itself_changes_no_bit_of_any_type)
{
  Mapped_mesh source(random_stacked_sphere(100, 1)), target(random_stacked_sphere(100, 1));
  const auto byte = [](std::size_t i) { return static_cast<unsigned char>(37 * i); };
  std::vector<std::function<void()>> checks;
  const auto add = [&](auto index, const std::string& name, const auto& make_value) {
    using Index = decltype(index);
    using T = decltype(make_value(0));
    fill<Index, T>(source, name, make_value);
    checks.push_back([&source, &target, name] { expect_same<Index, T>(source.mesh, target.mesh, name); });
  };
  const Vertex_index v;
  const Face_index f;
  add(v, "v:double", sine);
  add(v, "v:float", [](std::size_t i) { return static_cast<float>(sine(i)); });
  add(v, "v:bool", [](std::size_t i) { return sine(i) > 0.; });
  add(v, "v:string", [](std::size_t i) { return std::to_string(i); });
  add(v, "v:color", [&](std::size_t i) { return CGAL::IO::Color(byte(i), byte(i + 1), 7, byte(i + 2)); });
  add(v, "v:vector", [](std::size_t i) { return Kernel::Vector_3(sine(i), 1., 2.); });
  add(v, "v:uv", [](std::size_t i) { return Kernel::Point_2(sine(i), 3.); });
  add(v, "v:array", [](std::size_t i) { return std::array<double, 2>{sine(i), sine(i + 1)}; });
  add(v, "v:series", [](std::size_t i) { return std::vector<double>(5, sine(i)); });
  add(f, "f:label", [](std::size_t i) { return static_cast<int>(i); });
  add(f, "f:double", sine);
  source.scale(1); // the points of the target stay
  ASSERT_EQ(transfer(source, target), SP::OK);
  for(const auto& check : checks)
    check();
  EXPECT_EQ(points(target.mesh), random_stacked_sphere(100, 1).points);
  EXPECT_EQ(images(target.mesh, target.sphere), random_stacked_sphere(100, 1).points);
}

// What each element of the target takes over, by the rules of the documentation, with places from the locator.
class Rules
{
public:
  Rules(const Mapped_mesh& source, const Mapped_mesh& target)
    : m_source(source)
    , m_target(target)
    , m_in_source(source.mesh, source.sphere)
    , m_in_target(target.mesh, target.sphere)
    , m_areas(source.mesh.number_of_vertices(), 0.)
  {
    for(const Face_index f : source.mesh.faces())
      for(const Vertex_index v : CGAL::vertices_around_face(source.mesh.halfedge(f), source.mesh))
        m_areas[v] += area_of(f);
  }

  // the weights of the source's vertices
  std::map<std::size_t, double> of_vertex(Vertex_index v) const
  {
    const std::map<std::size_t, double> interpolation = weights(m_source.mesh, m_in_source.locate(m_target.sphere[v]));
    std::map<std::size_t, double> average;
    for(const Vertex_index s : m_source.mesh.vertices())
    {
      const auto hats = weights(m_target.mesh, m_in_target.locate(m_source.sphere[s]));
      const auto hat = hats.find(v);
      if(hat != hats.end())
        average[s] = hat->second * m_areas[s];
    }
    return std::all_of(interpolation.begin(), interpolation.end(),
                       [&](const auto& w) { return average.count(w.first) > 0; })
               ? average
               : interpolation;
  }

  std::map<std::size_t, double> of_face(Face_index f) const
  {
    const Face_index found = m_in_source.locate(center(m_target, f)).first;
    if(m_in_target.locate(center(m_source, found)).first != f)
      return {{found, 1.}};
    std::map<std::size_t, double> average;
    for(const Face_index s : m_source.mesh.faces())
      if(m_in_target.locate(center(m_source, s)).first == f)
        average[s] = area_of(s);
    return average;
  }

private:
  using Locator = SP::Sphere_locator_3<Mesh, Images_of_mesh>;

  static std::map<std::size_t, double> weights(const Mesh& mesh, const Locator::Face_location& location)
  {
    std::map<std::size_t, double> result;
    auto h = mesh.halfedge(location.first);
    for(const double w : location.second)
    {
      if(w > 0.)
        result[mesh.source(h)] = w;
      h = mesh.next(h);
    }
    return result;
  }

  static Point_3 center(const Mapped_mesh& m, Face_index f)
  {
    Coordinates sum = {0., 0., 0.};
    for(const auto h : CGAL::halfedges_around_face(m.mesh.halfedge(f), m.mesh))
    {
      const Coordinates p = coordinates(m.sphere[m.mesh.source(h)]);
      sum = combination(1., sum, 1. / norm(p), p);
    }
    return Point_3(sum[0], sum[1], sum[2]);
  }

  double area_of(Face_index f) const
  {
    const auto h = m_source.mesh.halfedge(f);
    const auto p = [&](Mesh::Halfedge_index k) { return coordinates(m_source.mesh.point(m_source.mesh.target(k))); };
    return area(p(h), p(m_source.mesh.next(h)), p(m_source.mesh.prev(h)));
  }

  const Mapped_mesh& m_source;
  const Mapped_mesh& m_target;
  Locator m_in_source, m_in_target;
  std::vector<double> m_areas;
};

template <class Label, class Label_of>
bool has_most_weight(const Label& label, const std::map<std::size_t, double>& weights, const Label_of& label_of)
{
  std::map<Label, double> sums;
  for(const auto& [s, w] : weights)
    sums[label_of(s)] += w;
  return std::all_of(sums.begin(), sums.end(), [&](const auto& sum) { return sum.second <= sums[label] + 1e-12; });
}

// A region of the sphere, as atlases have them: those of 12 directions, of which one has no name
std::string region(const Point_3& p)
{
  const std::vector<Coordinates>& seeds = icosphere(0).points;
  const Coordinates q = coordinates(p);
  const auto nearest = std::max_element(
      seeds.begin(), seeds.end(), [&](const Coordinates& a, const Coordinates& b) { return dot(a, q) < dot(b, q); });
  return nearest == seeds.begin() ? "" : "region " + std::to_string(nearest - seeds.begin());
}

double mean(const std::map<std::size_t, double>& weights)
{
  double sum = 0., weight = 0.;
  for(const auto& [s, w] : weights)
  {
    sum += w * sine(s);
    weight += w;
  }
  return sum / weight;
}

TEST(Transfer, follows_its_rules_to_coarser_and_finer_meshes)
{
  const Triangle_list uneven = with_slivers(random_stacked_sphere(150, 3), 5, 1e-3);
  const std::vector<Triangle_list> lists = {octahedron(), icosphere(1), uneven, bumpy_sphere(3), suspension(40)};
  for(const Triangle_list& from : lists)
    for(const Triangle_list& to : lists)
    {
      SCOPED_TRACE(std::to_string(from.points.size()) + " to " + std::to_string(to.points.size()));
      Mapped_mesh source(scaled(from, 1., 1., 2.), from.points), target(tilted(to)); // no center is on an edge
      add_numbers(source);
      const auto region_of = [&](std::size_t i) {
        return region(source.sphere[Vertex_index(static_cast<Mesh::size_type>(i))]);
      };
      const auto number_of_corner = [&](std::size_t i) { // fans of faces have the same
        const Face_index f(static_cast<Mesh::size_type>(i));
        return -static_cast<int>(source.mesh.source(source.mesh.halfedge(f)).idx());
      };
      fill<Vertex_index, std::string>(source, "v:region", region_of);
      fill<Vertex_index, std::size_t>(source, "v:number", [](std::size_t i) { return i; });
      fill<Face_index, int>(source, "f:label", number_of_corner);
      ASSERT_EQ(transfer(source, target), SP::OK);
      const auto x = target.add<Vertex_index, double>("v:x");
      const auto region = target.add<Vertex_index, std::string>("v:region");
      const auto number = target.add<Vertex_index, std::size_t>("v:number");
      const auto face_x = target.add<Face_index, double>("f:x");
      const auto face_label = target.add<Face_index, int>("f:label");
      const Rules rules(source, target);
      for(const Vertex_index v : target.mesh.vertices())
      {
        const auto weights = rules.of_vertex(v);
        ASSERT_NEAR(x[v], mean(weights), 1e-12) << v;
        ASSERT_TRUE(has_most_weight(region[v], weights, region_of)) << v;
        ASSERT_TRUE(has_most_weight(number[v], weights, [](std::size_t s) { return s; })) << v;
      }
      for(const Face_index f : target.mesh.faces())
      {
        const auto weights = rules.of_face(f);
        ASSERT_NEAR(face_x[f], mean(weights), 1e-12) << f;
        ASSERT_TRUE(has_most_weight(face_label[f], weights, number_of_corner)) << f;
      }
    }
}

// To maps of other types and of other meshes, in one call.
TEST(Transfer, takes_pairs_of_maps)
{
  Mapped_mesh source(icosphere(1));
  fill<Vertex_index, float>(source, "v:x", [](std::size_t) { return 0.25f; });
  fill<Face_index, short>(source, "f:label", [](std::size_t) { return static_cast<short>(7); });
  CGAL::Polyhedron_3<Kernel> target = make_mesh<CGAL::Polyhedron_3<Kernel>>(octahedron());
  std::map<CGAL::Polyhedron_3<Kernel>::Vertex_handle, double> x;
  std::map<CGAL::Polyhedron_3<Kernel>::Facet_handle, int> label;
  ASSERT_EQ(SP::transfer(
                source.mesh, source.sphere, target, get(CGAL::vertex_point, target),
                std::tuple(std::pair(source.add<Vertex_index, float>("v:x"), boost::make_assoc_property_map(x)),
                           std::pair(source.add<Face_index, short>("f:label"), boost::make_assoc_property_map(label)))),
            SP::OK);
  EXPECT_EQ(x.size(), 6u);
  EXPECT_EQ(label.size(), 8u);
  for(const auto& [v, value] : x)
    EXPECT_DOUBLE_EQ(value, 0.25);
  for(const auto& [f, value] : label)
    EXPECT_EQ(value, 7);
}

// Where a value is missing, nothing but what depends on it is lost.
TEST(Transfer, of_values_that_are_not_numbers_stays_where_it_is)
{
  Mapped_mesh source(octahedron()), target(list_of(Domain::octahedron(2)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  fill<Vertex_index, double>(source, "v:x", [&](std::size_t i) { return i == 0 ? nan : 1.; });
  ASSERT_EQ(transfer(source, target), SP::OK);
  const auto x = target.add<Vertex_index, double>("v:x");
  for(const Vertex_index v : target.mesh.vertices())
    EXPECT_EQ(std::isnan(x[v]), coordinates(target.sphere[v])[0] > 0.) << v;
}

TEST(Transfer, does_not_depend_on_the_size_of_the_spheres)
{
  Mapped_mesh expected(icosphere(1)), target(icosphere(1)), source(random_stacked_sphere(100, 1));
  add_numbers(source);
  ASSERT_EQ(transfer(source, expected), SP::OK);
  for(const auto& [m, exponent] : {std::pair(&source, -600), {&target, 600}})
    for(Point_3& p : m->sphere)
      p = scaled_by_power(p, exponent);
  ASSERT_EQ(transfer(source, target), SP::OK);
  const auto x = expected.add<Vertex_index, double>("v:x"), y = target.add<Vertex_index, double>("v:x");
  for(const Vertex_index v : target.mesh.vertices())
    EXPECT_NEAR(y[v], x[v], 1e-12);
  expect_same<Face_index, double>(expected.mesh, target.mesh, "f:x");
}

// Areas are those of the points that are given.
TEST(Transfer, weights_with_the_areas_of_the_surface)
{
  const Triangle_list sphere = icosphere(2);
  Mapped_mesh flat(scaled(sphere, 1., 1., 0.1), sphere.points), round(sphere), expected(octahedron()),
      target(octahedron()), other(octahedron());
  add_numbers(flat);
  add_numbers(round);
  const auto of_flat = CGAL::parameters::vertex_point_map(flat.mesh.points());
  ASSERT_EQ(transfer(flat, expected), SP::OK);
  ASSERT_EQ(SP::transfer(round.mesh, round.sphere, target.mesh, target.sphere, of_flat), SP::OK);
  expect_same<Vertex_index, double>(expected.mesh, target.mesh, "v:x");
  const auto x = other.add<Vertex_index, double>("v:x"), y = expected.add<Vertex_index, double>("v:x");
  ASSERT_EQ(SP::transfer(round.mesh, round.sphere, other.mesh, other.sphere,
                         std::pair(round.add<Vertex_index, double>("v:x"), x), of_flat),
            SP::OK);
  expect_same<Vertex_index, double>(expected.mesh, other.mesh, "v:x");
  ASSERT_EQ(transfer(round, other), SP::OK);
  for(const Vertex_index v : other.mesh.vertices())
    EXPECT_GT(std::abs(x[v] - y[v]), 1e-4);
}

// Labels of which each is another one, averaged by few vertices
TEST(Transfer, compares_labels_as_often_as_sorting_does)
{
  struct Label
  {
    std::size_t value = 0;
    bool operator<(const Label& other) const
    {
      ++n_comparisons();
      return value < other.value;
    }
    static std::size_t& n_comparisons()
    {
      static std::size_t n = 0;
      return n;
    }
  };
  Mapped_mesh source(icosphere(5)), target(tilted(octahedron()));
  fill<Vertex_index, Label>(source, "v:label", [](std::size_t i) { return Label{i}; });
  const auto label = target.add<Vertex_index, Label>("v:label");
  ASSERT_EQ(SP::transfer(source.mesh, source.sphere, target.mesh, target.sphere,
                         std::pair(source.add<Vertex_index, Label>("v:label"), label)),
            SP::OK);
  const auto n = static_cast<double>(source.mesh.number_of_vertices());
  EXPECT_LE(static_cast<double>(Label::n_comparisons()), 4. * n * std::log2(n)); // each vertex is in three stars
  for(const Vertex_index v : target.mesh.vertices())
    EXPECT_LT(distance(coordinates(source.sphere[Vertex_index(static_cast<Mesh::size_type>(label[v].value))]),
                       coordinates(target.sphere[v])),
              0.2);
}

TEST(Transfer, writes_nothing_once_it_is_stopped_or_where_it_has_no_bijection)
{
  Mapped_mesh source(icosphere(1)), target(icosphere(1));
  fill<Vertex_index, double>(source, "v:x", [](std::size_t) { return 1.; });
  const auto x = target.add<Vertex_index, double>("v:x");
  struct Visitor : SP::Default_visitor
  {
    int n_questions = 0, max_questions = 0;
    bool go_further(std::size_t, double) { return n_questions++ < max_questions; }
  };
  for(int k = 0; k < 2; ++k)
  {
    Visitor visitor;
    visitor.max_questions = k;
    EXPECT_EQ(SP::transfer(source.mesh, source.sphere, target.mesh, target.sphere,
                           CGAL::parameters::visitor(std::ref(visitor))),
              SP::ERROR_STOPPED);
    EXPECT_EQ(visitor.n_questions, k + 1);
  }
  for(const auto& [list, error] : broken_maps())
  {
    Mapped_mesh broken(list);
    fill<Vertex_index, double>(broken, "v:x", [](std::size_t) { return 2.; });
    EXPECT_EQ(transfer(broken, target), error);
    EXPECT_EQ(transfer(source, broken), error);
  }
  Mapped_mesh infinite(icosphere(1));
  infinite.mesh.point(Vertex_index(3)) = Point_3(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  EXPECT_EQ(transfer(infinite, target), SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_TRUE(std::all_of(x.begin(), x.end(), [](double value) { return value == 0.; }));
  EXPECT_EQ(transfer(source, target), SP::OK);
  EXPECT_TRUE(std::all_of(x.begin(), x.end(), [](double value) { return value == 1.; }));
}

} // namespace
