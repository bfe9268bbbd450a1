// A fuzzer for parameterize(): the bytes choose a method, its parameters, a small mesh and its points. What every method
// promises is checked on the way; see test::Method::run().

#include "Fuzzed_bytes.h"
#include "require.h"

#include "engine.h"
#include "methods.h"
#include "random_meshes.h"

#include <CGAL/spherical_parameterization.h>

#include <gtest/gtest.h>

using namespace test;

namespace {

// each vertex costs time
constexpr std::size_t max_vertices = 24;

// a parameter that is as often in its range as not
double parameter(Fuzzed_bytes& bytes)
{
  return bytes.below(2) == 0 ? bytes.special_number() : static_cast<double>(bytes.byte()) / 8.;
}

// a triangulation of the sphere
std::vector<Triangle> sphere(Fuzzed_bytes& bytes)
{
  Growing_triangulation triangulation;
  for(std::size_t n = bytes.below(2 * max_vertices); n > 0 && triangulation.size() < max_vertices; --n)
  {
    const std::size_t v = bytes.below(triangulation.size());
    const std::size_t degree = triangulation.degree(v);
    const Growing_triangulation::Corner corner = {v, bytes.below(degree)};
    const std::size_t step = bytes.below(degree);
    if(step == 0)
      triangulation.flip(corner);
    else
      triangulation.split(corner, step - 1);
  }
  return triangulation.triangles();
}

// any triangles, as many as the bytes last
std::vector<Triangle> triangles(Fuzzed_bytes& bytes)
{
  std::vector<Triangle> result(bytes.below(2 * max_vertices));
  const std::size_t number_of_vertices = 3 + bytes.below(max_vertices - 2);
  for(Triangle& t : result)
    for(std::size_t& v : t)
      v = bytes.below(number_of_vertices);
  return result;
}

double coordinate(std::size_t kind, Fuzzed_bytes& bytes)
{
  switch(kind)
  {
  case 0:
    return bytes.number();
  case 1:
    return bytes.special_number();
  default:
    return bytes.small_integer();
  }
}

// Points for the triangles; after the last byte they go around, so that they are not all the same.
Triangle_list mesh_of(const std::vector<Triangle>& triangles, Fuzzed_bytes& bytes)
{
  Triangle_list list;
  list.triangles = triangles;
  std::size_t number_of_vertices = 0;
  for(const Triangle& t : triangles)
    number_of_vertices = (std::max)({number_of_vertices, t[0] + 1, t[1] + 1, t[2] + 1});
  const std::size_t kind = bytes.below(4);
  const int exponent = kind == 3 ? static_cast<int>(bytes.below(2000)) - 1000 : 0;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
  {
    Coordinates p = {std::cos(1. * double(v)), std::sin(2. * double(v)), std::sin(3. * double(v))};
    if(bytes.size() > 0)
      for(double& x : p)
        x = std::ldexp(coordinate(kind, bytes), exponent);
    list.points.push_back(p);
  }
  return list;
}

// the triangles that can be added one after the other to a manifold mesh, in a list of the same points
Triangle_list manifold_part(const Triangle_list& list, Mesh& mesh)
{
  Triangle_list part;
  part.points = list.points;
  std::vector<Mesh::Vertex_index> vertices;
  for(const Coordinates& p : list.points)
    vertices.push_back(mesh.add_vertex(Point_3(p[0], p[1], p[2])));
  for(const Triangle& t : list.triangles)
    if(t[0] != t[1] && t[1] != t[2] && t[2] != t[0] &&
       mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) != Mesh::null_face())
      part.triangles.push_back(t);
  return part;
}

// Whether doubles hold a sphere of about the size of the mesh: a larger one has an infinite radius, and a smaller one too
// few points.
bool has_ordinary_size(const Triangle_list& list)
{
  double size = 0.;
  for(std::size_t i = 0; i < 3 && !list.points.empty(); ++i)
  {
    const auto is_less = [i](const Coordinates& p, const Coordinates& q) { return p[i] < q[i]; };
    const auto range = std::minmax_element(list.points.begin(), list.points.end(), is_less);
    size = (std::max)(size, (*range.second)[i] - (*range.first)[i]);
  }
  return size == 0. || (size > 1e-290 && size < 1e306);
}

// A method with parameters, whether these are in their ranges, and whether it maps every surface.
struct Fuzzed_method
{
  template <class Parameterizer>
  static Fuzzed_method with_parameters(const Parameterizer& parameterizer, bool is_sure)
  {
    return {Method("fuzzed", parameterizer), parameterizer.is_valid(), is_sure};
  }

  Method method;
  bool is_valid, is_sure;
};

Fuzzed_method make_method(std::size_t kind, double a, double b, double c, const Mesh& mesh)
{
  using Bld = SP::Bijective_low_distortion_parameterizer_3<>;
  switch(kind)
  {
  case 0:
    return Fuzzed_method::with_parameters(Bld().sharpness(SP::Sharpness::relative(a)).tolerances(b, c), true);
  case 1:
    return {hierarchical(), true, true};
  case 2:
    return {stereographic(), true, false};
  case 3:
    return {harmonic(), true, false};
  case 4:
    return {conformal(), true, false};
  case 5:
    return {arap(), true, false};
  case 6:
    return {published(), true, false};
  default: // the default method with other policies than its own, from a given map
    return Fuzzed_method::with_parameters(
        Bld()
            .initial_parameterizer(SP::Precomputed_parameterizer_3(Point_map(mesh, points(mesh))))
            .energy(SP::Isometric_energy_3(c))
            .sharpness(SP::Sharpness::schedule(a, b))
            .radius(SP::Fixed_radius_3(c)),
        false);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  require_expectations();
  Fuzzed_bytes bytes(data, size);
  const std::size_t kind = bytes.below(8);
  const double a = parameter(bytes), b = parameter(bytes), c = parameter(bytes);
  const bool is_sphere = bytes.below(4) != 0;

  Fuzzed_bytes settings = bytes; // of the run; the same bytes are a part of the mesh
  Mesh mesh;
  const Triangle_list list = manifold_part(mesh_of(is_sphere ? sphere(bytes) : triangles(bytes), bytes), mesh);
  const int n_iterations = static_cast<int>(settings.below(6)) - 1;
  const double seconds = settings.below(4) == 0 ? parameter(settings) : 0.;
  const Options options = Options().iterations(n_iterations).seconds(seconds).sequential();
  const auto [method, is_valid, is_sure] = make_method(kind, a, b, c, mesh);
  if(is_finite(list.points) && !has_ordinary_size(list)) // run() cannot know what is on the sphere
  {
    const Point_map map(mesh, sentinels(num_vertices(mesh)));
    if(method.parameterize(mesh, map, options) == SP::OK)
    {
      EXPECT_TRUE(is_bijective(mesh, images(mesh, map)));
    }
    return 0;
  }

  const SP::Error_code error = method.run(mesh, options).error;
  if(!is_valid)
  {
    EXPECT_EQ(error, SP::ERROR_WRONG_PARAMETER);
  }
  else if(error == SP::ERROR_WRONG_PARAMETER)
  {
    EXPECT_LT(n_iterations, 0);
  }
  else if(is_sphere && !is_finite(list.points))
  {
    EXPECT_EQ(error, SP::ERROR_NON_FINITE_COORDINATE);
  }
  else if(is_sphere && is_sure)
  {
    EXPECT_EQ(error, SP::OK);
  }
  else if(is_sphere) // nothing is wrong with the mesh
  {
    EXPECT_TRUE(error < SP::ERROR_EMPTY_MESH || error > SP::ERROR_NON_FINITE_COORDINATE);
  }
  return 0;
}
