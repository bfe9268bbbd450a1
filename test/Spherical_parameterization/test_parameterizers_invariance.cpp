// What must not matter: where the surface lies in space, its size, and how its vertices and faces are numbered.
//
// The numbering that the package works with follows the shape of the surface, so it is the same for all of these unless the
// shape leaves a choice. Where two vertices are equally far from the center, or two neighbours equally good targets of a
// removal, the caller's numbering decides, and another map, as good as the first, may be found.

#include "methods.h"

using namespace test;

namespace {

Triangle_list sized(const Triangle_list& list, double factor)
{
  return test_meshes::scaled(list, factor, factor, factor);
}

Triangle_list moved(Triangle_list list, const Coordinates& translation)
{
  for(Coordinates& p : list.points)
    p = combination(1., p, 1., translation);
  return list;
}

Triangle_list rotated(Triangle_list list, double first, double second)
{
  const double c = std::cos(first), s = std::sin(first), d = std::cos(second), t = std::sin(second);
  for(Coordinates& p : list.points)
  {
    const double x = c * p[0] - s * p[1], y = s * p[0] + c * p[1];
    p = {x, d * y - t * p[2], t * y + d * p[2]};
  }
  return list;
}

// The map of another surface, `factor` times as large, is the same up to rounding.
void expect_same_up_to_rounding(const Result& a, const Triangle_list& other, double factor, double tolerance)
{
  const Result b = bijective().run(other);
  EXPECT_EQ(b.error, SP::OK);
  EXPECT_EQ(a.report.number_of_iterations(), b.report.number_of_iterations());
  EXPECT_LT(largest_distance(scaled(a.images, 1. / a.report.radius), scaled(b.images, 1. / b.report.radius)),
            tolerance);
  EXPECT_NEAR(b.report.radius / (factor * a.report.radius), 1., tolerance);
}

TEST(Invariance, of_surfaces_without_a_symmetry)
{
  for(const unsigned int subdivisions : {1u, 3u})
  {
    const Triangle_list list = bumpy_sphere(subdivisions);
    const Result original = bijective().run(list);
    for(const int exponent : {-900, -10, 1, 300, 900}) // powers of two are exact, for the other methods as well
    {
      const double factor = std::ldexp(1., exponent);
      EXPECT_TRUE(have_same_bits(bijective().run(sized(list, factor)).images, scaled(original.images, factor)));
    }
    for(const Method& method : {stereographic(), harmonic(), conformal()})
      EXPECT_TRUE(have_same_bits(method.run(list).images, method.run(sized(list, 1024.)).images));
    for(const double factor : {3.3, 1e-300, 1e-150, 1e-20, 1e150, 1e200, 1e300})
      expect_same_up_to_rounding(original, sized(list, factor), factor, 1e-9);
    expect_same_up_to_rounding(original, moved(list, {0.1, -3.3, 0.777}), 1., 1e-9);
    // far away, the coordinates themselves lose digits
    expect_same_up_to_rounding(original, moved(list, {1e4, -3e4, 5e3}), 1., 1e-8);
    expect_same_up_to_rounding(original, rotated(list, 0.7, 1.9), 1., 1e-9);
    for(std::uint32_t seed = 1; seed < 4; ++seed)
    {
      const std::vector<std::size_t> number = random_permutation(list.points.size(), seed);
      const Images images = bijective().run(renumbered(list, number, seed)).images;
      Images in_old_order;
      for(const std::size_t v : number)
        in_old_order.push_back(images[v]);
      EXPECT_TRUE(have_same_bits(in_old_order, original.images));
    }
  }
}

// Wherever surfaces lie that leave a choice, it is made alike; renumbered, they may get another map that is as good.
TEST(Invariance, of_symmetric_surfaces)
{
  for(const Triangle_list& list : {icosphere(3), ellipsoid(1., 2., 4., 3), suspension(30), octahedron()})
  {
    const Result original = bijective().run(list);
    const double tolerance = 1e-7; // 1.3e-8 was seen: rounding grows over hundreds of sweeps of coarse levels
    expect_same_up_to_rounding(original, sized(list, 3.3), 3.3, tolerance);
    expect_same_up_to_rounding(original, moved(list, {10.1, -3.3, 0.777}), 1., tolerance);
    expect_same_up_to_rounding(original, rotated(list, 0.7, 1.9), 1., tolerance);
    const Result other = bijective().run(renumbered(list, random_permutation(list.points.size(), 1), 1));
    EXPECT_NEAR(other.distortion.isometric.maximum / original.distortion.isometric.maximum, 1., 0.02);
    EXPECT_NEAR(other.distortion.isometric.average / original.distortion.isometric.average, 1., 0.01);
  }
}

// Faces that look inwards get images that do so as well: is_bijective(), which is part of every run, asks for just that.
TEST(Invariance, of_surfaces_that_are_inside_out)
{
  Triangle_list list = bumpy_sphere(3);
  const Result original = bijective().run(list);
  for(Triangle& t : list.triangles)
    std::swap(t[1], t[2]);
  const Result mirrored = bijective().run(list);
  EXPECT_EQ(mirrored.error, SP::OK);
  EXPECT_NEAR(mirrored.report.radius / original.report.radius, 1., 0.01);
  EXPECT_NEAR(mirrored.distortion.isometric.average / original.distortion.isometric.average, 1., 0.02);
}

// Where the descent starts makes no difference in the end.
TEST(Invariance, of_the_start)
{
  const Mesh mesh = make(bumpy_sphere(1));
  const auto distortion = [&](const Method& method) {
    const Result result = method.run(mesh, Options().iterations(500));
    EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
    return result.distortion.isometric;
  };
  const SP::Distortion_statistics a = distortion(bijective()), b = distortion(bijective_from_stereographic()),
                                  c = distortion(bijective_from(mesh, harmonic().run(mesh).images));
  for(const SP::Distortion_statistics& other : {b, c})
  {
    EXPECT_NEAR(other.average / a.average, 1., 0.03);
    EXPECT_NEAR(other.maximum / a.maximum, 1., 0.1);
  }
}

} // namespace
