// A fuzzer for parameterize(): the bytes choose a method, its parameters, a small mesh and its points. What every method
// promises is checked on the way; see test_runs::run().

#include "Fuzzed_bytes.h"

#include "fuzzing.h"
#include "independent_check.h"
#include "random_triangulations.h"
#include "test_maps.h"
#include "test_meshes.h"
#include "test_runs.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

using fuzzing::Mesh;
using fuzzing::Point_3;
using test_meshes::Coordinates;
using test_meshes::Triangle_list;

namespace {

// Makes a failed expectation an exception, which ends the program: to a fuzzer, that is a crash to be reported.
bool initialize()
{
  ::testing::InitGoogleTest();
  ::testing::GTEST_FLAG(throw_on_failure) = true;
  return true;
}

// each vertex costs time
constexpr std::size_t most_vertices = 24;

enum Method
{
  DEFAULT,
  HIERARCHICAL,
  STEREOGRAPHIC,
  HARMONIC,
  CONFORMAL,
  ARAP,
  PUBLISHED,
  POLICIES, // the default method, with other policies than its own, from a given map
  NUMBER_OF_METHODS
};

// a parameter that is as often in its range as not
double parameter(Fuzzed_bytes& bytes)
{
  return bytes.below(2) == 0 ? bytes.special_number() : static_cast<double>(bytes.byte()) / 8.;
}

// a triangulation of the sphere
std::vector<test_meshes::Triangle> sphere(Fuzzed_bytes& bytes)
{
  random_triangulations::Growing_triangulation triangulation;
  for(std::size_t n = bytes.below(2 * most_vertices); n > 0 && triangulation.size() < most_vertices; --n)
  {
    const std::size_t v = bytes.below(triangulation.size());
    const std::size_t degree = triangulation.degree(v);
    const random_triangulations::Growing_triangulation::Corner corner = {v, bytes.below(degree)};
    const std::size_t step = bytes.below(degree);
    if(step == 0)
      triangulation.flip(corner);
    else
      triangulation.split(corner, step - 1);
  }
  return triangulation.triangles();
}

// any triangles, as many as the bytes last
std::vector<test_meshes::Triangle> triangles(Fuzzed_bytes& bytes)
{
  std::vector<test_meshes::Triangle> result(bytes.below(2 * most_vertices));
  const std::size_t number_of_vertices = 3 + bytes.below(most_vertices - 2);
  for(test_meshes::Triangle& t : result)
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
Triangle_list mesh_of(const std::vector<test_meshes::Triangle>& triangles, Fuzzed_bytes& bytes)
{
  Triangle_list list;
  list.triangles = triangles;
  std::size_t number_of_vertices = 0;
  for(const test_meshes::Triangle& t : triangles)
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
  for(const test_meshes::Triangle& t : list.triangles)
    if(t[0] != t[1] && t[1] != t[2] && t[2] != t[0] &&
       mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) != Mesh::null_face())
      part.triangles.push_back(t);
  return part;
}

bool is_finite(const Triangle_list& list)
{
  for(const Coordinates& p : list.points)
    for(const double x : p)
      if(!std::isfinite(x))
        return false;
  return true;
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

bool is_about_the_mesh(SP::Error_code error)
{
  return error >= SP::ERROR_EMPTY_MESH && error <= SP::ERROR_NON_FINITE_COORDINATE;
}

class Run
{
public:
  Run(const Triangle_list& list, const Mesh& mesh, bool is_sphere, Fuzzed_bytes& bytes)
    : m_list(list)
    , m_mesh(mesh)
    , m_is_sphere(is_sphere)
  {
    m_number_of_iterations = static_cast<int>(bytes.below(6)) - 1;
    m_seconds = bytes.below(4) == 0 ? parameter(bytes) : 0.;
  }

  // Runs the parameterizer. `is_valid` says whether its parameters are in their ranges, `is_sure` that it maps every
  // surface, and `may_fold` that it promises nothing.
  template <class Parameterizer>
  void operator()(Parameterizer parameterizer, bool is_valid, bool is_sure, bool may_fold)
  {
    fuzzing::With_threads<Parameterizer, CGAL::Sequential_tag> sequential(parameterizer);
    const auto np = CGAL::parameters::number_of_iterations(m_number_of_iterations).maximum_running_time(m_seconds);
    if(is_finite(m_list) && !has_ordinary_size(m_list)) // test_runs::run() cannot tell what is on the sphere
    {
      const auto map = test_maps::make_sentinel_map<Point_3>(m_mesh);
      if(sequential.parameterize(m_mesh, map, np) == SP::OK)
      {
        EXPECT_TRUE(SP::is_bijective(m_mesh, map));
      }
      return;
    }

    const test_runs::Result result = test_runs::run<Point_3>(m_mesh, sequential, may_fold, np);
    if(result.error == SP::OK)
    {
      EXPECT_TRUE(independent_check::is_one_to_one(result.images, m_list.triangles));
    }
    if(!is_valid)
    {
      EXPECT_EQ(result.error, SP::ERROR_WRONG_PARAMETER);
    }
    else if(result.error == SP::ERROR_WRONG_PARAMETER)
    {
      EXPECT_LT(m_number_of_iterations, 0);
    }
    else if(m_is_sphere && !is_finite(m_list))
    {
      EXPECT_EQ(result.error, SP::ERROR_NON_FINITE_COORDINATE);
    }
    else if(m_is_sphere && is_sure)
    {
      EXPECT_EQ(result.error, SP::OK);
    }
    else if(m_is_sphere)
    {
      EXPECT_FALSE(is_about_the_mesh(result.error));
    }
  }

private:
  const Triangle_list& m_list;
  const Mesh& m_mesh;
  bool m_is_sphere;
  int m_number_of_iterations;
  double m_seconds;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const bool is_initialized = initialize();
  (void)is_initialized;
  Fuzzed_bytes bytes(data, size);
  const Method method = static_cast<Method>(bytes.below(NUMBER_OF_METHODS));
  const double a = parameter(bytes), b = parameter(bytes), c = parameter(bytes);
  const bool is_sphere = bytes.below(4) != 0;

  Fuzzed_bytes settings = bytes; // of the run; the same bytes are a part of the mesh
  Mesh mesh;
  const Triangle_list list = manifold_part(mesh_of(is_sphere ? sphere(bytes) : triangles(bytes), bytes), mesh);
  Run run(list, mesh, is_sphere, settings);
  switch(method)
  {
  case DEFAULT: {
    SP::Bijective_low_distortion_parameterizer_3<Mesh> parameterizer{SP::Symmetric_Dirichlet_energy_3(),
                                                                     SP::Relative_sharpness_3(a)};
    parameterizer.set_tolerances(b, c);
    run(parameterizer, parameterizer.is_valid(), true, false);
    break;
  }
  case HIERARCHICAL: {
    const SP::Hierarchical_parameterizer_3<Mesh> parameterizer;
    run(parameterizer, parameterizer.is_valid(), true, false);
    break;
  }
  case STEREOGRAPHIC:
    run(SP::Stereographic_parameterizer_3<Mesh>(), true, false, false);
    break;
  case HARMONIC:
    run(SP::Harmonic_parameterizer_3<Mesh>(), true, false, false);
    break;
  case CONFORMAL:
    run(SP::Conformal_parameterizer_3<Mesh>(), true, false, true);
    break;
  case ARAP:
    run(SP::ARAP_parameterizer_3<Mesh>(), true, false, true);
    break;
  case PUBLISHED:
    run(SP::Published_low_distortion_parameterizer_3<Mesh>(), true, false, false);
    break;
  case POLICIES:
  case NUMBER_OF_METHODS: {
    using Map = Mesh::Property_map<Mesh::Vertex_index, Point_3>;
    using Start = SP::Precomputed_parameterizer_3<Mesh, Map>;
    const SP::Bijective_low_distortion_parameterizer_3<Mesh, Start, SP::Isometric_energy_3, SP::Absolute_sharpness_3,
                                                       SP::Fixed_radius_3, SP::Gradient_update_3,
                                                       SP::Flat_area_barrier_3>
        parameterizer(Start(mesh.points()), SP::Isometric_energy_3(c), SP::Absolute_sharpness_3(a, b),
                      SP::Fixed_radius_3(c));
    run(parameterizer, parameterizer.is_valid(), false, false);
    break;
  }
  }
  return 0;
}
