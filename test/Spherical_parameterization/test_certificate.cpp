// The certificate finds every fault that is planted into a map that is one-to-one, and finds none where none is; what is a
// fault is decided by the judge. It agrees with exact arithmetic on the last bit, whoever computes it.

#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>

#include "indexed_meshes.h"
#include "judge.h"
#include "methods.h"
#include "random_meshes.h"
#include "test_scale.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

using namespace test;

namespace {

using Rational = CGAL::Exact_rational;
using Exact = CGAL::Simple_cartesian<Rational>;
using Float = CGAL::Simple_cartesian<float>;
using judge::Image;
using SP::internal::Execution;
using SP::internal::nearest_double;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A map from the vertices of a closed mesh to points around the origin.
template <class Number>
struct Map
{
  std::vector<Triangle> triangles;
  std::vector<Image<Number>> images;
};

template <class Number>
bool is_one_to_one(const Map<Number>& map)
{
  return static_cast<bool>(judge::is_one_to_one(map.images, map.triangles));
}

template <class Number>
bool is_positive(const Map<Number>& map)
{
  return std::all_of(map.triangles.begin(), map.triangles.end(),
                     [&](const Triangle& t) { return judge::is_positive(map.images, t); });
}

// The faults. Each of them takes a map that is one-to-one and returns one that surely is not.

// A point across the opposite edge of a face, as seen from its first vertex: so near that edge as rounding allows.
template <class Number>
Image<Number> point_across(const Map<Number>& map, const Triangle& t)
{
  const Image<Number>&v = map.images[t[0]], &a = map.images[t[1]], &b = map.images[t[2]];
  for(int k = -10; k <= 10; ++k)
  {
    const Number factor = Number(std::ldexp(1., k));
    Image<Number> result;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Number middle = a[i] + b[i];
      result[i] = middle + factor * (middle - v[i]);
    }
    if(judge::sign_of_determinant(result, a, b) < 0)
      return result;
  }
  return {-v[0], -v[1], -v[2]};
}

// The last map that is one-to-one and the first that is not when a vertex is moved straight across an edge. Of floating
// point numbers, a single coordinate differs, by one unit in the last place; of exact ones, all by 2^-100 of the way.
template <class Number>
std::array<Map<Number>, 2> around_fold(const Map<Number>& map, Random& random)
{
  const std::size_t v = random.below(map.images.size());
  const std::vector<Triangle> faces = judge::stars(map.triangles, map.images.size())[v];
  std::array<Map<Number>, 2> result = {map, map};
  Image<Number>&good = result[0].images[v], &bad = result[1].images[v];
  bad = point_across(map, faces[random.below(faces.size())]);
  Map<Number> moved = map;
  const auto is_good = [&](const Image<Number>& p) {
    moved.images[v] = p;
    return std::all_of(faces.begin(), faces.end(),
                       [&](const Triangle& t) { return judge::is_positive(moved.images, t); });
  };
  if constexpr(std::is_floating_point<Number>::value)
  {
    const auto halve = [&] {
      Image<Number> middle;
      for(std::size_t i = 0; i < 3; ++i)
        middle[i] = good[i] / 2 + bad[i] / 2;
      const bool is_new = middle != good && middle != bad;
      (is_good(middle) ? good : bad) = middle;
      return is_new;
    };
    while(halve())
    {}
    for(std::size_t i = 0; i < 3; ++i)
    {
      Image<Number> next = good;
      next[i] = bad[i];
      if(!is_good(next))
      {
        bad = next;
        break;
      }
      good = next;
    }
  }
  else
  {
    // The middle of two points would be twice as long a fraction each time where fractions are not reduced.
    const Image<Number> start = good, end = bad;
    const auto point_at = [&](const Number& t) -> Image<Number> {
      return {start[0] + t * (end[0] - start[0]), start[1] + t * (end[1] - start[1]),
              start[2] + t * (end[2] - start[2])};
    };
    Number t = 0;
    for(int k = 1; k <= 100; ++k)
    {
      const Number next = t + Number(std::ldexp(1., -k));
      if(is_good(point_at(next)))
        t = next;
    }
    good = point_at(t);
    bad = point_at(t + Number(0x1p-100));
  }
  return result;
}

template <class Number>
Map<Number> with_swap(Map<Number> map, Random& random)
{
  const Triangle& t = map.triangles[random.below(map.triangles.size())];
  std::swap(map.images[t[0]], map.images[t[1]]); // this face is turned over, whatever the others do
  return map;
}

// Two copies of the mesh, slit along a path of two edges and glued crosswise: again a sphere, all of whose faces are positive.
// Only that it goes round twice about both ends of the path shows that it is no bijection.
// Precondition: some two vertices are no neighbours.
template <class Number>
Map<Number> with_double_cover(const Map<Number>& map, Random& random)
{
  const std::size_t n = map.images.size();
  const std::vector<std::vector<Triangle>> faces = judge::stars(map.triangles, n);
  // The ends are no neighbours, or they would be joined by two edges afterwards.
  std::size_t middle, start, end;
  std::vector<std::size_t> neighbors;
  const auto is_neighbor_of_start = [&](std::size_t v) {
    return std::any_of(faces[start].begin(), faces[start].end(), [&](const Triangle& t) { return t[1] == v; });
  };
  do
  {
    middle = random.below(n);
    neighbors = judge::ring(faces[middle]);
    start = neighbors[random.below(neighbors.size())];
    end = neighbors[random.below(neighbors.size())];
  } while(end == start || is_neighbor_of_start(end));

  // the neighbours of the vertex in the middle that the faces to the right of the path start with
  std::rotate(neighbors.begin(), std::find(neighbors.begin(), neighbors.end(), start), neighbors.end());
  const std::set<std::size_t> right_of_path(neighbors.begin(), std::find(neighbors.begin(), neighbors.end(), end));
  std::vector<std::size_t> second(n); // number of the second copy of a vertex
  Map<Number> result;
  result.images = map.images;
  for(std::size_t v = 0; v < n; ++v)
  {
    const bool is_end = v == start || v == end;
    second[v] = is_end ? v : result.images.size();
    if(!is_end)
      result.images.push_back(map.images[v]);
  }
  for(const bool is_second : {false, true})
    for(const Triangle& t : map.triangles)
    {
      Triangle copy;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const bool is_right = t[i] == middle && right_of_path.count(t[(i + 1) % 3]) > 0;
        copy[i] = is_second != is_right ? second[t[i]] : t[i];
      }
      result.triangles.push_back(copy);
    }
  return result;
}

// A face without area as seen from the origin.
template <class Number>
Map<Number> with_collapsed_face(Map<Number> map, Random& random)
{
  const Triangle& t = map.triangles[random.below(map.triangles.size())];
  Image<Number>&a = map.images[t[0]], &b = map.images[t[1]], &c = map.images[t[2]];
  switch(random.below(5))
  {
  case 0: // two corners at one point
    a = b;
    break;
  case 1: // two corners in one direction
    a = {b[0] / 2, b[1] / 2, b[2] / 2};
    break;
  case 2: // two corners in opposite directions
    a = {-b[0], -b[1], -b[2]};
    break;
  case 3: // three corners on a great circle; the sum is exact if the others are multiples of one power of two
    if constexpr(std::is_floating_point<Number>::value)
    {
      Number size = 0;
      for(std::size_t i = 0; i < 3; ++i)
        size = (std::max)({size, std::abs(b[i]), std::abs(c[i])});
      const Number unit = std::ldexp(Number(1), std::ilogb(size) - 20);
      for(std::size_t i = 0; i < 3; ++i)
      {
        b[i] = unit * std::nearbyint(b[i] / unit);
        c[i] = unit * std::nearbyint(c[i] / unit);
      }
    }
    a = {b[0] + c[0], b[1] + c[1], b[2] + c[2]};
    break;
  default: // no direction at all
    a = {Number(0), Number(0), Number(0)};
  }
  return map;
}

template <class Number>
Map<Number> antipodal(Map<Number> map)
{
  for(Image<Number>& p : map.images)
    p = {-p[0], -p[1], -p[2]};
  return map;
}

// One coordinate that is no number, or one vertex, or all of them.
template <class Number>
Map<Number> with_non_finite_coordinate(Map<Number> map, Random& random)
{
  constexpr Number huge = std::numeric_limits<Number>::infinity();
  const Number values[] = {std::numeric_limits<Number>::quiet_NaN(), huge, -huge};
  const Number value = values[random.below(3)];
  Image<Number>& p = map.images[random.below(map.images.size())];
  switch(random.below(3))
  {
  case 0:
    p[random.below(3)] = value;
    break;
  case 1:
    p = {value, value, value};
    break;
  default:
    map.images.assign(map.images.size(), {value, value, value});
  }
  return map;
}

// The maps that are one-to-one: the surface itself where the origin sees all of it, and what the package makes of it.

const std::vector<Map<double>>& original_maps()
{
  static const std::vector<Map<double>> maps = [] {
    std::vector<Map<double>> result;
    const auto add_itself = [&](const Triangle_list& list) { result.push_back({list.triangles, list.points}); };
    add_itself(octahedron());
    for(unsigned int subdivisions : {0u, 1u, 2u})
      add_itself(icosphere(subdivisions));
    for(std::size_t n : {3u, 4u, 7u, 16u, 50u})
      add_itself(suspension(n));
    for(std::size_t n : {1u, 3u, 10u, 30u, 100u})
      add_itself(random_stacked_sphere(n, 1));
    add_itself(bumpy_sphere(1));
    add_itself(bumpy_sphere(2));
    add_itself(ellipsoid(1e-3, 1., 1e3, 1));
    for(const Triangle_list& list : {bumpy_sphere(1), random_stacked_sphere(80, 4), with_tentacle(20, 4.)})
      for(const Method& method : {bijective(), bijective_conformal(), harmonic()})
        result.push_back({list.triangles, method.run(list, Options().iterations(10)).images});
    return result;
  }();
  return maps;
}

// 2^k with k from -n to n
double random_power(int n, Random& random)
{
  return std::ldexp(1., random.integer(-n, n));
}

Map<double> rotated(Map<double> map, Random& random)
{
  for(std::size_t axis = 0; axis < 3; ++axis)
  {
    const double angle = pi * random.between(-1., 1.), c = std::cos(angle), s = std::sin(angle);
    for(Coordinates& p : map.images)
    {
      double &x = p[axis], &y = p[(axis + 1) % 3];
      const double turned = c * x - s * y;
      y = s * x + c * y;
      x = turned;
    }
  }
  return map;
}

// A linear map of space, which leaves a map one-to-one but for rounding, by powers of two along the axes: needles.
Map<double> squeezed(Map<double> map, int largest_exponent, Random& random)
{
  const Coordinates factors = {random_power(largest_exponent, random), random_power(largest_exponent, random), 1.};
  for(Coordinates& p : map.images)
    for(std::size_t i = 0; i < 3; ++i)
      p[i] *= factors[i];
  return map;
}

// Another map of the same mesh. Rounding may have turned faces over.
template <class Number>
Map<Number> varied(Map<double> map, std::size_t kind, Random& random)
{
  constexpr bool is_float = std::is_same<Number, float>::value;
  if(kind > 0)
    map = rotated(map, random);
  switch(kind)
  {
  case 2:
  case 3:
    map = squeezed(map, is_float ? 8 : 30, random);
    if(kind == 3)
      map.images = directions_of(map.images);
    break;
  case 4: // at any distance from the origin
  case 5: // where determinants underflow or overflow
  {
    const double size = std::ldexp(1., (random.one_in(2) ? 1 : -1) * (is_float ? 100 : 400));
    for(Coordinates& p : map.images)
      p = scaled({p}, kind == 5 ? size : random_power(20, random))[0];
    break;
  }
  default:
    break;
  }
  Map<Number> result;
  result.triangles = map.triangles;
  for(const Coordinates& p : map.images)
    result.images.push_back({static_cast<Number>(p[0]), static_cast<Number>(p[1]), static_cast<Number>(p[2])});
  if constexpr(!std::is_floating_point<Number>::value)
    for(Image<Number>& p : result.images) // to numbers that doubles cannot hold
    {
      const Number x = (3 * p[0] - 4 * p[1]) / 5, y = (4 * p[0] + 3 * p[1]) / 5;
      p = {x + p[2] / 3, y, p[2] / 7};
    }
  return result;
}

// `n` maps that are one-to-one, no two of them equal.
template <class Number, class Function>
void for_each_map(std::size_t n, Random& random, const Function& f)
{
  constexpr std::size_t number_of_kinds = 6;
  const std::vector<Map<double>>& originals = original_maps();
  for(std::size_t n_found = 0, n_tried = 0; n_found < n; ++n_tried)
  {
    const std::size_t kind = n_tried / originals.size() % number_of_kinds;
    if(kind == 0 && n_tried >= originals.size())
      continue; // the originals themselves once only
    const Map<Number> map = varied<Number>(originals[n_tried % originals.size()], kind, random);
    if(!is_one_to_one(map))
      continue;
    f(map);
    ++n_found;
  }
}

// What the package says of a map.
template <class Kernel>
bool is_accepted(const Map<typename Kernel::FT>& map)
{
  using Point = typename Kernel::Point_3;
  const auto mesh = make_mesh<CGAL::Surface_mesh<Point>>({Images(map.images.size()), map.triangles});
  const auto points = get(CGAL::dynamic_vertex_property_t<Point>(), mesh);
  auto p = map.images.begin();
  for(const auto v : vertices(mesh))
  {
    put(points, v, Point((*p)[0], (*p)[1], (*p)[2]));
    ++p;
  }
  return SP::is_bijective(mesh, points);
}

// what a check in double precision would say
template <class Number>
bool seems_positive(const Map<Number>& map)
{
  const auto rounded = [&](std::size_t v) {
    const Image<Number>& p = map.images[v];
    return Image<double>{nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
  };
  return std::all_of(map.triangles.begin(), map.triangles.end(), [&](const Triangle& t) {
    return judge::determinant(rounded(t[0]), rounded(t[1]), rounded(t[2])) > 0.;
  });
}

// Examines so many maps and all faults of each. Some of the folds, and of the maps without, are such that rounded arithmetic
// does not distinguish them, if coordinates have more digits than a float.
template <class Kernel>
void expect_all_found(std::size_t n, std::uint64_t seed)
{
  using Number = typename Kernel::FT;
  Random random(seed);
  std::size_t n_invisible = 0;
  for_each_map<Number>(n, random, [&](const Map<Number>& map) {
    EXPECT_TRUE(is_accepted<Kernel>(map));
    const auto expect_refused = [&](const char* fault, const Map<Number>& planted) {
      EXPECT_FALSE(is_accepted<Kernel>(planted)) << fault;
    };
    expect_refused("swap", with_swap(map, random));
    expect_refused("collapsed face", with_collapsed_face(map, random));
    expect_refused("antipodal", antipodal(map));
    if constexpr(std::is_floating_point<Number>::value)
      expect_refused("non-finite", with_non_finite_coordinate(map, random));
    const Map<Number> covered_twice = with_double_cover(map, random); // nothing but the degree is wrong
    EXPECT_TRUE(is_positive(covered_twice));
    EXPECT_EQ(judge::degree(covered_twice.images, covered_twice.triangles), 2u);
    expect_refused("double cover", covered_twice);
    const auto [before_fold, fold] = around_fold(map, random);
    EXPECT_TRUE(is_one_to_one(before_fold) && is_accepted<Kernel>(before_fold));
    EXPECT_FALSE(is_positive(fold));
    expect_refused("fold", fold);
    n_invisible += seems_positive(fold);
  });
  if(!std::is_same<Number, float>::value)
  {
    EXPECT_GT(n_invisible, n / 20);
  }
}

TEST(Planted_fault, is_found)
{
  expect_all_found<test::Kernel>(test_scale::number_of(300, 1000), 1);
  expect_all_found<Float>(test_scale::number_of(100, 500), 2);
  expect_all_found<Exact>(test_scale::number_of(30, 200), 3);
}

using test::is_bijective; // which files that are compiled with this one call

bool is_bijective(const Triangle_list& list, const Images& images)
{
  return test::is_bijective(make(list), images);
}

TEST(Is_bijective, decides_on_the_last_bit)
{
  const Triangle_list list = octahedron();
  Images images = list.points;
  for(const double x : {0x1p-60, 0., -0x1p-60})
  {
    images[0] = {x, 1., -1.};
    EXPECT_EQ(is_bijective(list, images), x > 0.) << x;
  }
  // A symmetry of the octahedron permutes its vertices, but it is a bijection.
  EXPECT_TRUE(is_bijective(list, {{0, 1, 0}, {0, -1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}}));
}

// A map that is positive and has degree one exists on a sphere alone, so there is no need for a test of the topology. These
// come closest: two spheres of which one covers everything, and tori.
TEST(Is_bijective, accepts_topological_spheres_only)
{
  const auto accepts = [](const Triangle_list& list) { return is_bijective(list, list.points); };
  const Triangle_list sphere = icosphere(1);
  EXPECT_TRUE(accepts(sphere));
  EXPECT_FALSE(accepts(disjoint_union(sphere, sphere)));
  EXPECT_FALSE(accepts(disjoint_union(sphere, test_meshes::scaled(sphere, -1., 1., 1.))));
  EXPECT_FALSE(accepts(torus(9, 6)));
  EXPECT_FALSE(accepts(Triangle_list()));
  Triangle_list open = sphere, isolated = sphere;
  open.triangles.pop_back();
  EXPECT_FALSE(accepts(open));
  isolated.points.push_back({std::nan(""), infinity, 0.}); // the images of isolated vertices do not count
  EXPECT_TRUE(accepts(isolated));
  const Mesh quadrangles = cube();
  EXPECT_FALSE(SP::is_bijective(quadrangles, quadrangles.points()));
}

TEST(Is_bijective, finds_that_the_sphere_is_covered_several_times)
{
  for(std::size_t n = 5; n < 12; ++n)
    EXPECT_FALSE(is_bijective(suspension(n), suspension(n, 2).points));
  EXPECT_FALSE(is_bijective(suspension(11), suspension(11, 5).points));
}

TEST(Is_bijective, skips_removed_vertices_and_faces)
{
  Mesh mesh = make(disjoint_union(icosphere(1), icosphere(0)));
  // the first of the two spheres goes, so that the indices left have gaps
  const std::size_t n = icosphere(1).triangles.size();
  for(std::size_t i = 0; i < n; ++i)
    CGAL::Euler::remove_face(halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(i)), mesh), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  EXPECT_TRUE(SP::is_bijective(mesh, mesh.points()));
}

// The filter never contradicts exact arithmetic, however small, large or flat the triangle, in any rounding mode, in which
// numbers that overflow need not become infinite.
TEST(Orientation_about_origin, agrees_with_exact_arithmetic)
{
  const SP::internal::Orientation_about_origin_3<test::Kernel> orientation;
  Random random(7);
  const int former_mode = std::fegetround();
  std::array<std::size_t, 3> signs = {};
  for(const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for(int i = 0; i < (mode == FE_TONEAREST ? 20000 : 4000); ++i)
    {
      const int scales[] = {0, 0, 0, 300, -300, -340, 500, -1020, -500, 1000, 340};
      const int scale = scales[random.below(11)];
      const int edge = -random.integer(0, 49), height = edge - random.integer(0, 59);
      std::array<Coordinates, 3> p = {random.in_cube(), random.in_cube(), random.in_cube()};
      // p1 is close to p0, and p2 on the line through both but for the height
      const double t = random.between(-1., 1.);
      const Coordinates step = scaled({p[1]}, std::ldexp(1., edge))[0];
      p[1] = combination(1., p[0], 1., step);
      p[2] = combination(1., combination(1., p[0], t, step), std::ldexp(1., height), p[2]);
      if(i % 8 == 0)
        p[2] = combination(1., p[0], 1., p[1]); // a plane through the origin, or nearly so
      if(i % 16 == 0)
        p[2] = combination(2., p[1], 0., p[1]); // a line through the origin
      std::array<Point_3, 3> points;
      for(std::size_t j = 0; j < 3; ++j)
      {
        for(double& x : p[j])
          x = std::ldexp(x, scale);
        points[j] = Point_3(p[j][0], p[j][1], p[j][2]);
      }
      const int sign = CGAL::sign(judge::determinant(judge::exact(p[0]), judge::exact(p[1]), judge::exact(p[2])));
      std::fesetround(mode);
      const std::array<int, 4> found = {
          orientation(points[0], points[1], points[2]), orientation(points[1], points[2], points[0]),
          orientation(points[2], points[0], points[1]), -orientation(points[0], points[2], points[1])};
      std::fesetround(former_mode);
      for(const int s : found)
        ASSERT_EQ(s, sign) << mode << ' ' << i;
      ASSERT_EQ(static_cast<int>(SP::internal::exact_determinant_sign(p[0], p[1], p[2])), sign);
      ++signs[static_cast<std::size_t>(sign + 1)];
    }
  for(const std::size_t n : signs)
    EXPECT_GT(n, 1000u);
}

// What the certificate of a list says, which must not depend on who computes it, nor on the order of the triangles.
SP::internal::Bijectivity_certificate certificate_of(Triangle_list list)
{
  std::shuffle(list.triangles.begin(), list.triangles.end(), std::mt19937(3));
  std::vector<Point_3> points;
  for(const Coordinates& p : list.points)
    points.push_back(Point_3(p[0], p[1], p[2]));
  const auto certify = [&](Execution execution) {
    return SP::internal::certify_bijectivity<test::Kernel>(points, list.triangles, execution);
  };
  const auto result = certify(Execution());
#ifdef CGAL_LINKED_WITH_TBB
  // more threads than the machine may have
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  const auto in_parallel =
      tbb::task_arena(4).execute([&] { return certify(SP::internal::execution_of<CGAL::Parallel_tag>()); });
  EXPECT_EQ(in_parallel.number_of_non_positive_faces, result.number_of_non_positive_faces);
  EXPECT_EQ(in_parallel.degree, result.degree);
#endif
  return result;
}

TEST(Certificate, is_the_same_in_parallel)
{
  Triangle_list list = icosphere(5); // enough faces for many blocks
  EXPECT_TRUE(certificate_of(list).is_bijective());
  EXPECT_EQ(certificate_of(suspension(5001, 2)).degree, 2u);
  EXPECT_EQ(certificate_of(suspension(5001, 1250)).degree, 1250u);

  // A vertex in the first direction that faces are counted around: it is on their boundaries, and another one is taken.
  const double x = 742913. * 0x1p-20;
  const Coordinates q = {1., x, x * x};
  *std::max_element(list.points.begin(), list.points.end(),
                    [&](const Coordinates& a, const Coordinates& b) { return dot(a, q) < dot(b, q); }) = q;
  EXPECT_TRUE(certificate_of(list).is_bijective());

  // Faces that are inverted here and there are all counted.
  std::size_t n_inverted = 0;
  for(std::size_t k = 5; k < list.triangles.size(); k += 997, ++n_inverted)
    std::swap(list.triangles[k][0], list.triangles[k][1]);
  EXPECT_EQ(certificate_of(list).number_of_non_positive_faces, n_inverted);
}

TEST(Is_safely_positive, of_all_faces)
{
  const Triangle_list sphere = icosphere(2);
  const Surface mesh = surface_of(sphere);
  const Images positions = mesh.in_own_order(sphere.points);
  const auto are_safe = [&](const Images& p) { return SP::internal::are_safely_positive(mesh.rings(), p); };
  EXPECT_TRUE(are_safe(positions));
  EXPECT_FALSE(are_safe(scaled(positions, -1.)));
  // one vertex over the opposite edge of one of its faces, or just not yet
  for(const std::uint32_t v : {0u, 17u, 161u})
    for(const double t : {0.9, 0.999, 1.001, 1.1})
    {
      const Vertex_rings::Ring ring = mesh.rings().ring(v);
      const Coordinates middle = combination(0.5, positions[ring[0]], 0.5, positions[ring[1]]);
      Images moved = positions;
      moved[v] = normalized(combination(1. - t, positions[v], t, middle));
      EXPECT_EQ(are_safe(moved), t < 1.) << v << ' ' << t;
    }
  Images unknown = positions;
  unknown[5][1] = std::nan("");
  EXPECT_FALSE(are_safe(unknown));
}

// Faces that pass the test keep their orientation when their corners are scaled to any radius and rounded.
TEST(Is_safely_positive, is_safe_under_rounding)
{
  Random random(8);
  int n_safe = 0, n_narrow = 0;
  for(int k = 0; k < 20000; ++k)
  {
    const SP::internal::Tangent_frame frame(random.direction());
    const double size = std::pow(10., -random.between(0.5, 8.)),
                 height = size * std::pow(10., -random.between(0., 15.));
    Images corners = {frame.point_at(0., 0.), frame.point_at(size, 0.),
                      frame.point_at(random.between(0., 1.) * size, height)};
    const Coordinates p = frame.offset_of(corners[1]), q = frame.offset_of(corners[2]);
    const double determinant = p[0] * q[1] - p[1] * q[0]; // that of the corners in the coordinates of the frame
    if(!SP::internal::is_safely_positive(determinant, dot(p, p) + dot(q, q)))
      continue;
    ++n_safe;
    n_narrow += height < 1e-12;
    EXPECT_TRUE(judge::is_positive(corners, {0, 1, 2}));
    EXPECT_TRUE(judge::is_positive(scaled(corners, random.between(0.1, 10.)), {0, 1, 2}));
  }
  EXPECT_GT(n_safe, 10000);
  EXPECT_GT(n_narrow, 500); // the test lets narrow faces pass as well
}

} // namespace
