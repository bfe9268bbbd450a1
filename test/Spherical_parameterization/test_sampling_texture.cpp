// Texture coordinates are those of the surface everywhere, whatever the poles and the seam pass through, and files hold them.

#include <CGAL/Spherical_parameterization/Sampling/compute_texture_coordinates.h>
#include <CGAL/Spherical_parameterization/Sampling/write_OBJ.h>

#include "broken_maps.h"
#include "locale_of_commas.h"
#include "methods.h"
#include "random_meshes.h"
#include "test_scale.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

using namespace test;

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Point_2 = Kernel::Point_2;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Axes
{
  Coordinates north = {0., 0., 1.}, zero = {1., 0., 0.};

  // the direction of texture coordinates
  Coordinates direction(const Point_2& uv) const
  {
    const Coordinates z = normalized(north), y = normalized(cross(north, zero)), x = cross(y, z);
    const double longitude = 2. * CGAL_PI * (uv.x() - 0.5), latitude = CGAL_PI * (uv.y() - 0.5);
    return combination(
        1., combination(std::cos(latitude) * std::cos(longitude), x, std::cos(latitude) * std::sin(longitude), y),
        std::sin(latitude), z);
  }
};

template <class Any_mesh>
struct Textured
{
  template <class Source, class Map>
  Textured(const Source& source, const Map& map, const Axes& axes)
    : uv(get(CGAL::dynamic_halfedge_property_t<Point_2>(), mesh))
  {
    using Point = typename boost::property_traits<Map>::value_type;
    const auto point = [](const Coordinates& p) { return Point(p[0], p[1], p[2]); };
    error = SP::compute_texture_coordinates(source, map, mesh, uv, point(axes.north), point(axes.zero));
  }

  Any_mesh mesh;
  typename boost::property_map<Any_mesh, CGAL::dynamic_halfedge_property_t<Point_2>>::type uv;
  SP::Error_code error;
};

double area(const Point_2& a, const Point_2& b, const Point_2& c)
{
  return 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
}

bool is_at_pole(const Point_2& uv)
{
  return uv.y() == 0. || uv.y() == 1.;
}

template <class Point>
Coordinates coordinates(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

// Checks what holds for every map. Returns the area of all texture triangles, where those at the poles count twice, as they
// are half of the rectangles that they stand for, and the least area.
template <class Any_mesh>
void expect_whole(const Textured<Any_mesh>& textured, double& total_area, double& least_area)
{
  const Any_mesh& mesh = textured.mesh;
  ASSERT_FALSE(is_empty(mesh));
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  ASSERT_TRUE(CGAL::is_closed(mesh));
  ASSERT_TRUE(CGAL::is_triangle_mesh(mesh));
  ASSERT_EQ(num_vertices(mesh) + num_faces(mesh), num_edges(mesh) + 2);
  total_area = 0.;
  least_area = 1.;
  for(const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    const Point_2 a = get(textured.uv, h), b = get(textured.uv, next(h, mesh)),
                  c = get(textured.uv, next(next(h, mesh), mesh));
    const auto [west, east] = std::minmax({a.x(), b.x(), c.x()});
    ASSERT_LE(east - west, 0.5 + 1e-12);
    ASSERT_GE(west, 0.);
    ASSERT_LE(east, 1.);
    const double image = area(a, b, c);
    total_area += is_at_pole(a) || is_at_pole(b) || is_at_pole(c) ? 2. * image : image;
    least_area = (std::min)(least_area, image);
  }
}

// Checks all that is promised for a map without needles. Where a pole is on an edge but for rounding, texture triangles may
// be turned over by this area, and it is not known which of them are at the pole.
template <class Any_mesh, class Map>
void expect_right(const Any_mesh& mesh, const Map& map, const Axes& axes, double margin = 0.)
{
  const Textured<Any_mesh> textured(mesh, map, axes);
  const Any_mesh& result = textured.mesh;
  ASSERT_EQ(textured.error, SP::OK);
  double total_area = 0., least_area = 0.;
  ASSERT_NO_FATAL_FAILURE(expect_whole(textured, total_area, least_area));
  ASSERT_NEAR(margin > 0. ? 1. : total_area, 1., 1e-12);
  ASSERT_GE(least_area, -margin);
  ASSERT_TRUE(least_area > 0. || margin > 0.);

  const double expected_area = CGAL::to_double(PMP::area(mesh));
  ASSERT_NEAR(CGAL::to_double(PMP::area(result)), expected_area, 1e-12 * expected_area);
  auto v = vertices(result).begin();
  for(const auto w : vertices(mesh))
    ASSERT_EQ(get(CGAL::vertex_point, result, *v++), get(CGAL::vertex_point, mesh, w));
  const SP::Sphere_locator_3 locator(mesh, map, true);
  const double size = std::sqrt(expected_area);
  for(const auto h : halfedges(result))
  {
    const Coordinates q = axes.direction(get(textured.uv, h));
    using Image = typename boost::property_traits<Map>::value_type;
    const auto location = locator.locate(Image(q[0], q[1], q[2]));
    const Coordinates expected = coordinates(PMP::construct_point(location, mesh));
    ASSERT_LE(distance(coordinates(get(CGAL::vertex_point, result, target(h, result))), expected), 1e-6 * size);
  }
}

void expect_right(const Triangle_list& surface, const Images& images, const Axes& axes, double margin = 0.)
{
  const Mesh mesh = make(surface);
  ASSERT_NO_FATAL_FAILURE(expect_right(mesh, Point_map(mesh, images), axes, margin));
}

// Poles and seams anywhere, at vertices, on edges and along them, exactly if coordinates are multiples of 2^-20.
std::vector<Axes> axes_of(const Triangle_list& sphere, std::size_t n)
{
  std::vector<Axes> result = {Axes(), {{0., 1., 0.}, {0., 0., 1.}}};
  Random random(1);
  for(std::size_t k = 0; k < n; ++k)
  {
    const Triangle t = sphere.triangles[k * sphere.triangles.size() / n];
    const Coordinates &a = sphere.points[t[0]], &b = sphere.points[t[1]], &c = sphere.points[t[2]];
    const Coordinates middle = combination(1., a, 1., b), center = combination(1., middle, 1., c);
    for(const Coordinates& north : {random.direction(), a, middle, center})
      for(const Coordinates& zero : {random.direction(), b, c, middle})
        for(const double sign : {1., -1.})
          if(norm(cross(north, zero)) > 1e-9)
            result.push_back({north, combination(sign, zero, 0., zero)});
  }
  return result;
}

Triangle_list rounded(Triangle_list list)
{
  for(Coordinates& p : list.points)
    for(double& x : p)
      x = std::round(x * 0x1p20) * 0x1p-20;
  return list;
}

// The same mesh at other places
Triangle_list bent(Triangle_list list)
{
  for(Coordinates& p : list.points)
    p = {3. * p[0] + p[1] * p[1], 2. * p[1], p[2] + 0.2 * p[0] * p[1]};
  return list;
}

TEST(Texture_coordinates, of_an_octahedron_that_is_cut_along_its_edges)
{
  const Mesh mesh = make(octahedron());
  const Textured<Mesh> textured(mesh, mesh.points(), Axes());
  ASSERT_EQ(textured.error, SP::OK);
  EXPECT_EQ(num_vertices(textured.mesh), 6u);
  std::vector<std::set<std::pair<double, double>>> corners(6);
  for(const auto h : halfedges(textured.mesh))
  {
    const Point_2 p = get(textured.uv, h);
    corners[target(h, textured.mesh)].emplace(p.x(), p.y());
  }
  using Corners = std::set<std::pair<double, double>>;
  EXPECT_EQ(corners[0], (Corners{{0.5, 0.5}}));
  EXPECT_EQ(corners[1], (Corners{{0., 0.5}, {1., 0.5}}));
  EXPECT_EQ(corners[2], (Corners{{0.75, 0.5}}));
  EXPECT_EQ(corners[3], (Corners{{0.25, 0.5}}));
  EXPECT_EQ(corners[4], (Corners{{0.125, 1.}, {0.375, 1.}, {0.625, 1.}, {0.875, 1.}}));
  EXPECT_EQ(corners[5], (Corners{{0.125, 0.}, {0.375, 0.}, {0.625, 0.}, {0.875, 0.}}));
}

// Each is exact: the seam through a vertex, across an edge and along one, the poles in faces, on edges and at vertices.
TEST(Texture_coordinates, of_an_octahedron_that_is_cut_across)
{
  const Mesh mesh = make(octahedron());
  for(const auto& [axes, n_vertices] : {std::pair(Axes{{0., 0., 1.}, {1., 1., 0.}}, 7u),
                                        {Axes{{0., 0., 1.}, {1., 2., 5.}}, 7u},
                                        {Axes{{1., 0., 1.}, {0., 1., 0.}}, 8u},
                                        {Axes{{1., 0., 1.}, {1., 0., 0.}}, 8u},
                                        {Axes{{1., 1., 1.}, {1., 0., 0.}}, 9u},
                                        {Axes{{1., 1., 1.}, {-1., 0., 0.}}, 9u}})
  {
    EXPECT_EQ(num_vertices(Textured<Mesh>(mesh, mesh.points(), axes).mesh), n_vertices);
    expect_right(octahedron(), octahedron().points, axes);
  }
}

const std::vector<Triangle_list>& spheres()
{
  static const std::vector<Triangle_list> result = {tetrahedron(),  icosphere(0),
                                                    icosphere(3),   random_stacked_sphere(20, 1),
                                                    suspension(50), with_slivers(icosphere(2), 20, 1e-3)};
  return result;
}

// Also where poles are on edges but for rounding.
TEST(Texture_coordinates, are_those_of_the_surface)
{
  for(const Triangle_list& list : spheres())
    for(const auto& [sphere, margin] : {std::pair(rounded(list), 0.), std::pair(list, 1e-9)})
    {
      SCOPED_TRACE(sphere.points.size());
      for(const Axes& axes : axes_of(sphere, test_scale::number_of(1, 10)))
      {
        SCOPED_TRACE(::testing::PrintToString(axes.north) + ::testing::PrintToString(axes.zero));
        expect_right(bent(sphere), sphere.points, axes, margin);
      }
    }
}

TEST(Texture_coordinates, cover_the_image_in_maps_of_random_meshes)
{
  for(std::uint64_t seed = 0; seed < test_scale::number_of(10, 500); ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh mesh = make(random_mesh(seed).list);
    const Images images = hierarchical().run(mesh).images;
    Random random(seed);
    const Textured<Mesh> textured(mesh, Point_map(mesh, images), {random.direction(), random.direction()});
    double total_area = 0., least_area = 0.;
    expect_whole(textured, total_area, least_area);
    EXPECT_NEAR(total_area, 1., 1e-12);
    EXPECT_EQ(textured.error, least_area < -1e-10 ? SP::ERROR_INVERTED_TEXTURE : SP::OK) << least_area;
  }
}

TEST(Texture_coordinates, do_not_depend_on_the_distance_of_images_and_poles)
{
  const Triangle_list list = icosphere(2);
  const Mesh mesh = make(bent(list));
  const Axes axes = {{1., 2., 3.}, {-1., 0.5, 0.}};
  const Textured<Mesh> expected(mesh, Point_map(mesh, list.points), axes);
  for(const double factor : {0x1p-900, 0x1p900})
  {
    const Axes far = {combination(factor, axes.north, 0., axes.north),
                      combination(0.5 * factor, axes.zero, 0., axes.zero)};
    const Textured<Mesh> textured(mesh, Point_map(mesh, scaled(list.points, factor)), far);
    ASSERT_EQ(textured.error, SP::OK);
    ASSERT_EQ(num_halfedges(textured.mesh), num_halfedges(expected.mesh));
    for(const auto h : halfedges(expected.mesh))
      ASSERT_EQ(get(textured.uv, h), get(expected.uv, h));
    for(const auto v : vertices(expected.mesh))
      ASSERT_LE(CGAL::squared_distance(textured.mesh.point(v), expected.mesh.point(v)), 1e-24);
  }
}

TEST(Texture_coordinates, any_mesh_and_kernel)
{
  const Triangle_list list = rounded(icosphere(2));
  const Mesh mesh = make(list);
  const auto polyhedron = make_mesh<CGAL::Polyhedron_3<Kernel>>(list);
  const auto exact = make_mesh<CGAL::Surface_mesh<Epeck::Point_3>>(list);
  const Triangle& t = list.triangles[5];
  for(const Axes& axes : {Axes(), Axes{combination(1., list.points[t[0]], 1., list.points[t[1]]), {1., 2., 3.}}})
  {
    expect_right(mesh, mesh.points(), axes);
    expect_right(polyhedron, get(CGAL::vertex_point, polyhedron), axes);
    expect_right(exact, exact.points(), axes);
  }
}

// What a mesh has already, stays.
TEST(Texture_coordinates, are_added_to_a_mesh)
{
  const Mesh mesh = make(octahedron());
  Mesh both = mesh;
  auto uv = both.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv", Point_2(7., 7.)).first;
  ASSERT_EQ(SP::compute_texture_coordinates(mesh, mesh.points(), both, uv), SP::OK);
  EXPECT_EQ(num_vertices(both), 12u);
  EXPECT_EQ(num_faces(both), 16u);
  for(const auto h : halfedges(both))
    EXPECT_EQ(uv[h] == Point_2(7., 7.), h.idx() < num_halfedges(mesh));
}

// Needles that are narrower than the arcs along them are bent, and more of them than new vertices could divide
TEST(Texture_coordinates, that_stay_folded_are_told)
{
  Triangle_list list = icosphere(2);
  for(std::size_t k = 0, n = list.triangles.size(); k < n; ++k)
  {
    const Triangle t = list.triangles[k];
    const Coordinates on_edge = combination(0.7, list.points[t[0]], 0.3, list.points[t[1]]);
    split_face(list, k, combination(1. - 3e-6, on_edge, 3e-6, list.points[t[2]]));
  }
  const Mesh mesh = make(list);
  const Textured<Mesh> textured(mesh, mesh.points(), Axes());
  EXPECT_EQ(textured.error, SP::ERROR_INVERTED_TEXTURE);
  double total_area = 0., least_area = 0.;
  expect_whole(textured, total_area, least_area);
  EXPECT_NEAR(total_area, 1., 1e-12);
  EXPECT_LT(least_area, -1e-10);
}

TEST(Texture_coordinates, leave_the_mesh_as_it_was_if_a_map_throws)
{
  const Mesh mesh = make(icosphere(1));
  Mesh result = make(tetrahedron());
  std::size_t n_left = 100;
  using Map = Full_map<Mesh::Halfedge_index, Point_2>;
  EXPECT_THROW((void)SP::compute_texture_coordinates(mesh, mesh.points(), result, Map{&n_left}), std::length_error);
  EXPECT_EQ(points(result), tetrahedron().points);
  EXPECT_EQ(triangles(result), triangles(make(tetrahedron())));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(result));
}

void expect_refusal(const Triangle_list& list, const Axes& axes, SP::Error_code error)
{
  const Mesh mesh = make(list);
  const Textured<Mesh> textured(mesh, Point_map(mesh, list.points), axes);
  EXPECT_EQ(textured.error, error);
  EXPECT_TRUE(is_empty(textured.mesh));
}

TEST(Texture_coordinates, are_refused_with_a_reason)
{
  for(const Axes& axes :
      {Axes{{0., 0., 0.}, {1., 0., 0.}}, Axes{{0., 0., 1.}, {0., -0., 0.}}, Axes{{0., nan, 1.}, {1., 0., 0.}},
       Axes{{0., 0., 1.}, {-infinity, 0., 0.}}, Axes{{1., 2., 3.}, {2., 4., 6.}}, Axes{{1., 2., 3.}, {-1., -2., -3.}}})
    expect_refusal(icosphere(1), axes, SP::ERROR_INVALID_DIRECTION);
  for(const auto& [list, error] : broken_maps())
    expect_refusal(list, Axes(), error);
  Mesh infinite = make(icosphere(1));
  infinite.point(Mesh::Vertex_index(3)) = Point_3(0., nan, 0.);
  const Textured<Mesh> textured(infinite, Point_map(infinite, icosphere(1).points), Axes());
  EXPECT_EQ(textured.error, SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_TRUE(is_empty(textured.mesh));
}

TEST(Obj_file, holds_the_mesh_and_each_coordinate_once)
{
  const Mesh mesh = make(icosphere(2));
  const Textured<Mesh> textured(mesh, mesh.points(), {{1., 2., 3.}, {3., 1., 2.}});
  std::stringstream file;
  file.precision(3);
  ASSERT_EQ(SP::IO::write_OBJ(file, textured.mesh, textured.uv), SP::OK);
  EXPECT_EQ(file.precision(), 3);
  expect_same_with_commas([&] {
    std::ostringstream out;
    EXPECT_EQ(SP::IO::write_OBJ(out, textured.mesh, textured.uv), SP::OK);
    EXPECT_EQ(out.getloc(), std::locale());
    return out.str();
  });

  std::vector<Point_3> points;
  std::vector<Point_2> coordinates;
  std::size_t n_faces = 0;
  for(std::string key; file >> key;)
    if(key == "v")
    {
      double x, y, z;
      ASSERT_TRUE(file >> x >> y >> z);
      points.emplace_back(x, y, z);
    }
    else if(key == "vt")
    {
      double u, v;
      ASSERT_TRUE(file >> u >> v);
      coordinates.emplace_back(u, v);
    }
    else
    {
      ASSERT_EQ(key, "f");
      const Mesh::Face_index f(static_cast<Mesh::size_type>(n_faces++));
      for(const auto h : halfedges_around_face(halfedge(f, textured.mesh), textured.mesh))
      {
        std::size_t v = 0, vt = 0;
        char slash = ' ';
        ASSERT_TRUE(file >> v >> slash >> vt);
        ASSERT_EQ(slash, '/');
        ASSERT_EQ(points.at(v - 1), textured.mesh.point(target(h, textured.mesh)));
        ASSERT_EQ(coordinates.at(vt - 1), get(textured.uv, h));
      }
    }
  EXPECT_EQ(points.size(), num_vertices(textured.mesh));
  EXPECT_EQ(n_faces, num_faces(textured.mesh));
  EXPECT_EQ(std::set<Point_2>(coordinates.begin(), coordinates.end()).size(), coordinates.size());
}

TEST(Obj_file, that_cannot_be_written_is_told)
{
  const Mesh mesh = make(octahedron());
  const Textured<Mesh> textured(mesh, mesh.points(), Axes());
  for(const char* name : {"no_folder/textured.obj", "/dev/full"})
  {
    std::ofstream file(name);
    EXPECT_EQ(SP::IO::write_OBJ(file, textured.mesh, textured.uv), SP::ERROR_CANNOT_WRITE_FILE);
  }
}

} // namespace
