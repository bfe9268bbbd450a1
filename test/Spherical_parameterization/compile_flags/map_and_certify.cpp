// Maps a few meshes, checks the maps and the certificate with integer arithmetic of its own, and prints a checksum of
// the bits of all maps. It is compiled with the flags of all kinds of users; see CMakeLists.txt.

#include <CGAL/Spherical_parameterization/Fixed_radius_3.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/reproducibility.h>

#include "images.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <limits>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
using test_meshes::Coordinates;
using test_meshes::Triangle_list;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Integer = boost::multiprecision::cpp_int;

// x 2^1074, from the bits, as no flag changes what is done to integers; `x` is finite.
Integer exact(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  const auto exponent = static_cast<unsigned int>((bits >> 52) & 0x7FFu);
  Integer result = bits & 0xFFFFFFFFFFFFFu;
  if(exponent > 0)
    result = (result + (Integer(1) << 52)) << (exponent - 1);
  return bits >> 63 ? Integer(-result) : result;
}

bool is_positive(const Coordinates& a, const Coordinates& b, const Coordinates& c)
{
  const Integer determinant = exact(a[0]) * (exact(b[1]) * exact(c[2]) - exact(b[2]) * exact(c[1])) +
                              exact(a[1]) * (exact(b[2]) * exact(c[0]) - exact(b[0]) * exact(c[2])) +
                              exact(a[2]) * (exact(b[0]) * exact(c[1]) - exact(b[1]) * exact(c[0]));
  return determinant > 0;
}

bool are_all_positive(const Triangle_list& list, const std::vector<Coordinates>& images)
{
  bool result = true;
  for(const test_meshes::Triangle& t : list.triangles)
    result = result && is_positive(images[t[0]], images[t[1]], images[t[2]]);
  return result;
}

bool is_certified(const Mesh& mesh, const std::vector<Coordinates>& images)
{
  return SP::is_bijective(mesh, test_meshes::make_vertex_map<Point_3>(mesh, images));
}

void expect(bool condition, const char* what)
{
  if(condition)
    return;
  std::cerr << "Failed: " << what << '\n';
  std::exit(EXIT_FAILURE);
}

// FNV-1a
void add_to_checksum(const std::vector<Coordinates>& images, std::uint64_t& checksum)
{
  std::vector<unsigned char> bytes(images.size() * sizeof(Coordinates));
  std::memcpy(bytes.data(), images.data(), bytes.size());
  for(const unsigned char byte : bytes)
    checksum = (checksum ^ byte) * 0x100000001b3u;
}

// Moves a vertex by the smallest steps there are to the other side of an edge of its link, where the certificate has to
// say what the integers say at each step.
void check_certificate_near_an_edge(const Triangle_list& list, const Mesh& mesh, std::vector<Coordinates> images)
{
  const test_meshes::Triangle& t = list.triangles[list.triangles.size() / 2];
  const Coordinates &b = images[t[1]], &c = images[t[2]];
  const Coordinates middle = {0.5 * b[0] + 0.5 * c[0], 0.5 * b[1] + 0.5 * c[1], 0.5 * b[2] + 0.5 * c[2]};
  std::size_t n_accepted = 0, n_refused = 0;
  for(int step = -20; step <= 20; ++step)
  {
    Coordinates& a = images[t[0]];
    a = middle;
    for(int k = 0; k < std::abs(step); ++k)
      a[0] = std::nextafter(a[0], step < 0 ? -2. : 2.);
    const bool is_right = are_all_positive(list, images);
    expect(is_certified(mesh, images) == is_right, "the certificate agrees with integers next to an edge");
    ++(is_right ? n_accepted : n_refused);
  }
  expect(n_refused > 0, "a vertex next to an edge folds");
  std::cerr << "next to an edge: " << n_accepted << " accepted, " << n_refused << " refused\n";
}

// Stores NaN for the first vertex, whatever it is given.
struct Spoiling_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = Point_3;
  using reference = Point_3;
  using category = boost::read_write_property_map_tag;

  std::vector<Point_3>* points;

  friend Point_3 get(const Spoiling_map& map, key_type v) { return (*map.points)[v]; }
  friend void put(const Spoiling_map& map, key_type v, const Point_3& p)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    (*map.points)[v] = v == key_type(0) ? Point_3(nan, nan, nan) : p;
  }
};

void check(const Triangle_list& list, std::uint64_t& checksum)
{
  const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
  std::vector<Coordinates> images(list.points.size());
  const auto map = test_meshes::make_vertex_map<Point_3>(mesh, images);
  expect(SP::parameterize(mesh, map) == SP::OK, "the mesh is mapped");
  images = test::images(mesh, map);
  expect(are_all_positive(list, images), "all faces are positive");
  expect(is_certified(mesh, images), "the map is certified");
  add_to_checksum(images, checksum);

  check_certificate_near_an_edge(list, mesh, images);

  std::vector<Point_3> spoilt(images.size());
  expect(SP::parameterize(mesh, Spoiling_map{&spoilt}) == SP::ERROR_INSUFFICIENT_PRECISION,
         "a map that holds other values than it was given is found");

  std::vector<Coordinates> tiny = images, folded = images;
  for(Coordinates& p : tiny)
    for(double& x : p)
      x = std::ldexp(x, -1060); // subnormal: most faces become flat
  expect(is_certified(mesh, tiny) == are_all_positive(list, tiny), "the certificate agrees with subnormal integers");
  std::swap(folded[list.triangles[0][0]], folded[list.triangles[0][1]]);
  expect(!is_certified(mesh, folded), "a swap is found");
  for(const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    std::vector<Coordinates> broken = images;
    broken[1][2] = x;
    expect(!is_certified(mesh, broken), "a coordinate that is not finite is found in the map");
    Triangle_list broken_list = list;
    broken_list.points[1][2] = x;
    const Mesh broken_mesh = test_meshes::make_mesh<Mesh>(broken_list);
    expect(SP::parameterize(broken_mesh, test_meshes::make_vertex_map<Point_3>(broken_mesh, images)) ==
               SP::ERROR_NON_FINITE_COORDINATE,
           "a coordinate that is not finite is found in the mesh");
  }
}

int main()
{
  for(const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 0., -1.})
    expect(!SP::Fixed_radius_3(x).is_valid(), "a radius that is not positive and finite is found");
  expect(SP::Fixed_radius_3(2.).is_valid(), "a radius may be positive and finite");
#ifdef __FAST_MATH__
  expect(!SP::is_reproducible(), "arithmetic that is not that of IEEE 754 is found");
#else
  expect(SP::is_reproducible(), "arithmetic is that of IEEE 754");
#endif
  std::uint64_t checksum = 0xcbf29ce484222325u;
  check(test_meshes::bumpy_sphere(3), checksum);
  check(test_meshes::with_tentacle(60, 10.), checksum);
  check(test_meshes::ellipsoid(1., 1., 1e-4, 2), checksum);
  check(test_meshes::random_stacked_sphere(200, 5), checksum);
  std::cout << std::hex << checksum << '\n';
}
