// Maps are rounded to floats such that they stay one-to-one, which the judge decides; what need not be moved is not.

#include <CGAL/Spherical_parameterization/internal/certificate/Float_rounding.h>

#include "judge.h"
#include "methods.h"
#include "random_meshes.h"
#include "test_scale.h"

#include <CGAL/Simple_cartesian.h>

using namespace test;

namespace {

using Float_point = CGAL::Simple_cartesian<float>::Point_3;
using Float_image = judge::Image<float>;

// Images are the nearest floats. They are stored in between, as compilers take conversions there and back together.
std::vector<Float_image> nearest(const Images& images)
{
  std::vector<Float_image> result;
  for(const Coordinates& p : images)
  {
    const volatile float x = static_cast<float>(p[0]), y = static_cast<float>(p[1]), z = static_cast<float>(p[2]);
    result.push_back({x, y, z});
  }
  return result;
}

std::size_t number_of_folded_faces(const std::vector<Float_image>& images, const std::vector<Triangle>& triangles)
{
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(),
                                                [&](const Triangle& t) { return !judge::is_positive(images, t); }));
}

struct Outcome
{
  SP::Error_code error;
  std::vector<Float_image> images;
};

Outcome round_to_float(const Triangle_list& list, const Images& images)
{
  const Mesh mesh = make(list);
  const auto sphere = test_meshes::make_vertex_map<Point_3>(mesh, images);
  const auto floats = get(CGAL::dynamic_vertex_property_t<Float_point>(), mesh);
  for(const auto v : vertices(mesh))
    put(floats, v, Float_point(7.f, 7.f, 7.f));
  Outcome result;
  result.error = SP::round_to_float(mesh, sphere, floats);
  for(const auto v : vertices(mesh))
    result.images.push_back({get(floats, v).x(), get(floats, v).y(), get(floats, v).z()});
  return result;
}

// units in the last place of the largest coordinate
double units_between(const Float_image& p, const Coordinates& q)
{
  double result = 0.;
  for(std::size_t i = 0; i < 3; ++i)
    result = (std::max)(result, std::abs(static_cast<double>(p[i]) - q[i]) / SP::internal::Float_rounding::spacing(q));
  return result;
}

double ratio_of_radii(const std::vector<Float_image>& images)
{
  double min = std::numeric_limits<double>::infinity(), max = 0.;
  for(const Float_image& p : images)
  {
    const double radius = std::hypot(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
    min = (std::min)(min, radius);
    max = (std::max)(max, radius);
  }
  return max / min;
}

TEST(Rounding_to_floats, takes_the_nearest_ones_if_no_face_folds)
{
  for(const double radius : {1., 100., 1e-30, 1e30})
  {
    const Triangle_list list = icosphere(3);
    const Images images = scaled(list.points, radius);
    const Outcome outcome = round_to_float(list, images);
    EXPECT_EQ(outcome.error, SP::OK);
    EXPECT_EQ(outcome.images, nearest(images));
  }
}

TEST(Rounding_to_floats, leaves_no_fold)
{
  for(const double radius : {1., 100.})
    for(const std::size_t n : {3u, 4u})
      for(const auto& [smallest, max_units] : {std::pair(1e-9, 20.), std::pair(1e-10, 30.), std::pair(1e-12, 50.)})
      {
        const double ratio = n == 3 ? 0.3 : 0.5;
        SCOPED_TRACE(::testing::Message() << "radius " << radius << ", " << n << " around, down to " << smallest);
        const Triangle_list list =
            tube(n, static_cast<std::size_t>(std::log(smallest) / std::log(ratio)), ratio, radius);
        ASSERT_TRUE(judge::is_one_to_one(list.points, list.triangles));
        EXPECT_GT(number_of_folded_faces(nearest(list.points), list.triangles), 0u);
        const Outcome outcome = round_to_float(list, list.points);
        ASSERT_EQ(outcome.error, SP::OK);
        EXPECT_TRUE(judge::is_one_to_one(outcome.images, list.triangles));
        EXPECT_LT(ratio_of_radii(outcome.images), 1.00001);
        double units = 0.;
        for(std::size_t v = 0; v < list.points.size(); ++v)
          units = (std::max)(units, units_between(outcome.images[v], list.points[v]));
        EXPECT_LT(units, max_units);
        EXPECT_EQ(round_to_float(list, list.points).images, outcome.images);
      }
}

TEST(Rounding_to_floats, moves_nothing_but_what_is_next_to_a_fold)
{
  // A vertex that is next to an edge, nearer than floats can be.
  Triangle_list list = icosphere(2);
  const Triangle face = list.triangles[100];
  Images images = scaled(list.points, 100.);
  const Coordinates middle = combination(0.5, images[face[1]], 0.5, images[face[2]]),
                    inner = combination(1. - 1e-9, middle, 1e-9, images[face[0]]);
  const std::size_t v = images.size();
  list.points = images;
  split_face(list, 100, combination(100. / norm(inner), inner, 0., inner));
  images = list.points;
  ASSERT_TRUE(judge::is_one_to_one(images, list.triangles));
  const std::vector<Float_image> rounded = nearest(images);
  Outcome outcome = round_to_float(list, images);
  ASSERT_EQ(outcome.error, SP::OK);
  EXPECT_TRUE(judge::is_one_to_one(outcome.images, list.triangles));
  for(std::size_t w = 0; w < images.size(); ++w)
    if(w == v || w == face[1] || w == face[2])
      EXPECT_LE(units_between(outcome.images[w], images[w]), 2.5);
    else
      EXPECT_EQ(outcome.images[w], rounded[w]);
}

TEST(Rounding_to_floats, keeps_any_map_one_to_one_or_says_that_it_cannot)
{
  std::size_t n_folding = 0, n_held = 0;
  for(std::uint64_t seed = 0; seed < test_scale::number_of(60, 2000); ++seed)
  {
    const Random_mesh random = random_mesh(seed);
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ": " << random.kind);
    const Mesh mesh = make(random.list);
    SP::Hierarchical_parameterizer_3 method;
    const auto sphere = get(CGAL::dynamic_vertex_property_t<Point_3>(), mesh);
    if(SP::parameterize(mesh, method, sphere) != SP::OK)
      continue;
    Images images;
    for(const auto v : vertices(mesh))
      images.push_back({get(sphere, v).x(), get(sphere, v).y(), get(sphere, v).z()});
    const bool folds = number_of_folded_faces(nearest(images), random.list.triangles) > 0;
    const Outcome outcome = round_to_float(random.list, images);
    n_folding += folds;
    if(outcome.error == SP::OK)
    {
      EXPECT_TRUE(judge::is_one_to_one(outcome.images, random.list.triangles));
      n_held += folds;
    }
    else
    {
      EXPECT_TRUE(folds);
      EXPECT_EQ(outcome.error, SP::ERROR_INSUFFICIENT_PRECISION);
      EXPECT_EQ(outcome.images, std::vector<Float_image>(images.size(), Float_image{7.f, 7.f, 7.f}));
    }
  }
  EXPECT_GT(n_folding, 0u);
  EXPECT_GE(2 * n_held, n_folding);
}

TEST(Rounding_to_floats, writes_nothing_if_there_is_no_such_map)
{
  const std::vector<Float_image> untouched(icosphere(2).points.size(), Float_image{7.f, 7.f, 7.f});
  const auto expect = [&](SP::Error_code error, const Images& images) {
    const Outcome outcome = round_to_float(icosphere(2), images);
    EXPECT_EQ(outcome.error, error);
    EXPECT_EQ(outcome.images, untouched);
  };
  Images folded = icosphere(2).points;
  folded[0] = {-folded[0][0], -folded[0][1], -folded[0][2]};
  expect(SP::ERROR_NO_1_TO_1_MAPPING, folded);
  folded[0][0] = std::numeric_limits<double>::quiet_NaN();
  expect(SP::ERROR_NO_1_TO_1_MAPPING, folded);
  expect(SP::ERROR_OUT_OF_FLOAT_RANGE, scaled(icosphere(2).points, 1e39));
  expect(SP::ERROR_OUT_OF_FLOAT_RANGE, scaled(icosphere(2).points, 1e-38));

  // some 1000 vertices within a unit in the last place
  const Triangle_list list = tube(32, 100, 0.8, 1.);
  ASSERT_TRUE(judge::is_one_to_one(list.points, list.triangles));
  EXPECT_EQ(round_to_float(list, list.points).error, SP::ERROR_INSUFFICIENT_PRECISION);

  Mesh open = make(icosphere(2));
  CGAL::Euler::remove_face(halfedge(*faces(open).begin(), open), open);
  EXPECT_EQ(SP::round_to_float(open, open.points(), open.points()), SP::ERROR_NON_CLOSED_MESH);
}

TEST(Rounding_to_floats, may_replace_the_map_and_leaves_isolated_vertices)
{
  Mesh mesh = make(icosphere(2));
  const Point_3 any(0.1, 0.2, 0.3);
  const auto isolated = mesh.add_vertex(any);
  const Mesh before = mesh;
  ASSERT_EQ(SP::round_to_float<CGAL::Sequential_tag>(mesh, mesh.points(), mesh.points()), SP::OK);
  EXPECT_EQ(mesh.point(isolated), any);
  for(const auto v : mesh.vertices())
    if(v != isolated)
      for(int i = 0; i < 3; ++i)
      {
        const volatile float x = static_cast<float>(before.point(v)[i]);
        EXPECT_EQ(mesh.point(v)[i], static_cast<double>(x));
      }
}

} // namespace
