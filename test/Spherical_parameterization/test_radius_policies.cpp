// The radius of the sphere: each formula against the sums that it is made of, and on whole runs against the map that
// was written.

#include <CGAL/Spherical_parameterization/internal/Face_range.h>
#include <CGAL/Spherical_parameterization/internal/sum_over_faces.h>
#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle_list;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

constexpr double pi = test_meshes::pi;

Coordinates cross(const Coordinates& a, const Coordinates& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Coordinates difference(const Coordinates& a, const Coordinates& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Coordinates& a, const Coordinates& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The faces of a surface on its image, whose vertices have the distance `radius` from the origin, from first
// principles.
std::vector<SP::Face_invariants_3> faces_of(const Triangle_list& surface, const std::vector<Coordinates>& image,
                                            double radius)
{
  std::vector<SP::Face_invariants_3> faces;
  for(const test_meshes::Triangle& t : surface.triangles)
  {
    const auto edges = [&](const std::vector<Coordinates>& p) {
      return std::array<Coordinates, 2>{difference(p[t[1]], p[t[0]]), difference(p[t[2]], p[t[0]])};
    };
    const auto e = edges(surface.points), f = edges(image);
    const double area = test_maps::norm(cross(e[0], e[1])), image_area = test_maps::norm(cross(f[0], f[1]));
    // the trace of G^-1 H for the metrics G of the surface and H of the image
    const double i = (dot(e[1], e[1]) * dot(f[0], f[0]) - 2. * dot(e[0], e[1]) * dot(f[0], f[1]) +
                      dot(e[0], e[0]) * dot(f[1], f[1])) /
                     (area * area);
    const double determinant = dot(image[t[0]], cross(image[t[1]], image[t[2]]));
    faces.push_back({area, i, determinant / (area * radius), image_area / area});
  }
  return faces;
}

std::vector<SP::Face_invariants_3> scaled(std::vector<SP::Face_invariants_3> faces, double radius_factor)
{
  const double s = radius_factor * radius_factor;
  for(SP::Face_invariants_3& face : faces)
  {
    face = {face.area, s * face.i, s * face.d, s * face.flat_d};
  }
  return faces;
}

// An ellipsoid of revolution with the half-axes 1, 1, 2 on the unit sphere, by the stretch that made it.
struct Ellipsoid_on_sphere
{
  Triangle_list sphere = test_meshes::icosphere(4);
  Triangle_list ellipsoid = test_meshes::scaled(sphere, 1., 1., 2.);
  std::vector<SP::Face_invariants_3> faces = faces_of(ellipsoid, sphere.points, 1.);

  // the area of the smooth ellipsoid: 2 pi (1 + 2 asin(e) / e), e^2 = 1 - 1 / 4
  static double area()
  {
    const double e = std::sqrt(0.75);
    return 2. * pi * (1. + 2. * std::asin(e) / e);
  }
};

// energies without a closed form of the best scale
struct Plain_symmetric_Dirichlet
{
  double operator()(double i, double d) const { return SP::Symmetric_Dirichlet_energy_3()(i, d); }
  SP::Energy_derivatives_3 derivatives(double i, double d) const
  {
    return SP::Symmetric_Dirichlet_energy_3().derivatives(i, d);
  }
};

struct Plain_isometric
{
  double operator()(double i, double d) const { return SP::Isometric_energy_3()(i, d); }
  SP::Energy_derivatives_3 derivatives(double i, double d) const { return SP::Isometric_energy_3().derivatives(i, d); }
};

struct Plain_conformal
{
  double operator()(double i, double d) const { return SP::Conformal_energy_3()(i, d); }
  SP::Energy_derivatives_3 derivatives(double i, double d) const { return SP::Conformal_energy_3().derivatives(i, d); }
};

const SP::Symmetric_Dirichlet_energy_3 energy;

TEST(Radius, of_a_sphere_on_itself_stays)
{
  const Triangle_list sphere = test_meshes::icosphere(3);
  const std::vector<SP::Face_invariants_3> faces = faces_of(sphere, sphere.points, 1.);
  EXPECT_NEAR(SP::Area_preserving_radius_3()(energy, faces, 1.), 1., 1e-14);
  EXPECT_NEAR(SP::Area_balancing_radius_3()(energy, faces, 1.), 1., 1e-14);
  // The energy's d is that of the planes' distance from the centre, a little below 1: about the largest triangles'
  // inradius squared over two.
  EXPECT_NEAR(SP::Optimal_radius_3()(energy, faces, 1.), 1., 1e-2);
  EXPECT_EQ(SP::Fixed_radius_3(0.75)(energy, faces, 1.), 0.75);
}

TEST(Radius, of_a_sphere_on_one_of_another_size_is_found_in_one_step)
{
  const Triangle_list sphere = test_meshes::icosphere(3), large = test_meshes::scaled(sphere, 5., 5., 5.);
  const std::vector<SP::Face_invariants_3> faces = faces_of(large, sphere.points, 1.);
  EXPECT_NEAR(SP::Area_preserving_radius_3()(energy, faces, 1.), 5., 1e-13);
  EXPECT_NEAR(SP::Area_balancing_radius_3()(energy, faces, 1.), 5., 1e-13);
  EXPECT_NEAR(SP::Optimal_radius_3()(energy, faces, 1.), 5., 5e-2);
}

// The faces of a descent are summed up block by block, by several threads: each face once, however many there are, and
// to the same bits.
TEST(Radius, is_the_same_for_the_faces_of_a_descent)
{
  for(const std::size_t n : {1u, 2u, 1023u, 1024u, 1025u, 2048u, 10000u})
  {
    std::vector<SP::Face_invariants_3> faces;
    double sum = 0.;
    for(std::size_t k = 0; k < n; ++k)
    {
      const double x = 1. + static_cast<double>(k * 7919 % 1000) / 250.;
      faces.push_back({x, 2. + x, 0.9 / x, 1.1 / x});
      sum += x;
    }
    const SP::internal::Face_range<CGAL::Sequential_tag> range(faces.data(), faces.data() + n);
    const SP::internal::Two_sums sums = SP::internal::sum_over_faces(range, [](const SP::Face_invariants_3& face) {
      return SP::internal::Two_sums{1., face.area};
    });
    EXPECT_EQ(sums[0], static_cast<double>(n));
    EXPECT_NEAR(sums[1], sum, 1e-12 * sum);
    const auto expect_same = [&](auto policy, const auto& energy_in_use) {
      const double radius = policy(energy_in_use, range, 1.2);
      EXPECT_NEAR(radius, policy(energy_in_use, faces, 1.2), 1e-12);
      EXPECT_GT(std::abs(radius - 1.2), 1e-3);
#ifdef CGAL_LINKED_WITH_TBB
      const SP::internal::Face_range<CGAL::Parallel_tag> parallel_range(range.begin(), range.end());
      EXPECT_EQ(radius, policy(energy_in_use, parallel_range, 1.2));
#endif
    };
    expect_same(SP::Area_preserving_radius_3(), energy);
    expect_same(SP::Area_balancing_radius_3(), energy);
    expect_same(SP::Optimal_radius_3(), energy);
    expect_same(SP::Optimal_radius_3(), SP::Isometric_energy_3());
    expect_same(SP::Optimal_radius_3(), Plain_isometric());
  }
}

TEST(Radius, starts_with_the_area_of_the_surface)
{
  EXPECT_EQ(SP::Area_preserving_radius_3().initial_radius(3.5), 3.5);
  EXPECT_EQ(SP::Area_balancing_radius_3().initial_radius(3.5), 3.5);
  EXPECT_EQ(SP::Optimal_radius_3().initial_radius(3.5), 3.5);
  EXPECT_EQ(SP::Two_phase_radius_3<>().initial_radius(3.5), 3.5);
  EXPECT_EQ(SP::Fixed_radius_3(0.75).initial_radius(3.5), 0.75);
  EXPECT_EQ(SP::Fixed_radius_3().initial_radius(3.5), 1.);
}

TEST(Area_preserving_radius, of_an_ellipsoid)
{
  const Ellipsoid_on_sphere map;
  double area = 0., image_area = 0.;
  for(const SP::Face_invariants_3& face : map.faces)
  {
    area += face.area;
    image_area += face.flat_d * face.area;
  }
  const double radius = SP::Area_preserving_radius_3()(energy, map.faces, 1.);
  EXPECT_NEAR(radius, std::sqrt(area / image_area), 1e-13);
  EXPECT_NEAR(radius, std::sqrt(Ellipsoid_on_sphere::area() / (4. * pi)), 1e-3);
  // the same sphere, wherever the step starts
  EXPECT_NEAR(SP::Area_preserving_radius_3()(energy, scaled(map.faces, 7.), 7.), radius, 1e-13);
}

TEST(Area_balancing_radius, of_an_ellipsoid)
{
  const Ellipsoid_on_sphere map;
  const double radius = SP::Area_balancing_radius_3()(energy, map.faces, 1.);
  double sum = 0., sum_of_inverses = 0.;
  for(const SP::Face_invariants_3& face : scaled(map.faces, radius))
  {
    sum += face.flat_d;
    sum_of_inverses += 1. / face.flat_d;
  }
  EXPECT_NEAR(sum / sum_of_inverses, 1., 1e-13);
  EXPECT_NEAR(SP::Area_balancing_radius_3()(energy, scaled(map.faces, 0.01), 0.01), radius, 1e-13);
  // A face at the height z of the sphere has A / a = 2 sqrt(1 - 3/4 z^2), and all z are equally frequent.
  const double b = std::sqrt(0.75);
  const double mean = std::sqrt(1. - b * b) + std::asin(b) / b, mean_of_inverses = std::asin(b) / (2. * b);
  EXPECT_NEAR(radius, std::pow(mean / mean_of_inverses, 0.25), 2e-2); // the faces of an icosphere differ in size
}

TEST(Optimal_radius, minimises_the_energy_in_use)
{
  const Ellipsoid_on_sphere map;
  const auto total = [&](const auto& e, double radius) {
    double sum = 0.;
    for(const SP::Face_invariants_3& face : scaled(map.faces, radius))
    {
      sum += e(face.i, face.d);
    }
    return sum;
  };
  const auto expect_minimum = [&](const auto& e) {
    const double radius = SP::Optimal_radius_3()(e, map.faces, 1.);
    EXPECT_LT(total(e, radius), total(e, 1.0001 * radius));
    EXPECT_LT(total(e, radius), total(e, 0.9999 * radius));
  };
  expect_minimum(energy);
  expect_minimum(SP::Isometric_energy_3());
  expect_minimum(SP::Isometric_energy_3(0.9));
  expect_minimum(Plain_symmetric_Dirichlet());
  EXPECT_GT(
      std::abs(SP::Optimal_radius_3()(energy, map.faces, 1.) / SP::Area_balancing_radius_3()(energy, map.faces, 1.) -
               1.),
      1e-3);
}

TEST(Optimal_radius, by_newton_agrees_with_the_closed_form)
{
  const Ellipsoid_on_sphere map;
  for(const double radius : {1., 1e-3, 0.1, 20., 1e3})
  {
    const std::vector<SP::Face_invariants_3> faces = scaled(map.faces, radius);
    const double dirichlet = SP::Optimal_radius_3()(energy, map.faces, 1.);
    const double isometric = SP::Optimal_radius_3()(SP::Isometric_energy_3(), map.faces, 1.);
    EXPECT_NEAR(SP::Optimal_radius_3()(Plain_symmetric_Dirichlet(), faces, radius), dirichlet, 1e-9);
    EXPECT_NEAR(SP::Optimal_radius_3()(Plain_isometric(), faces, radius), isometric, 1e-9);
  }
}

TEST(Optimal_radius, stays_where_the_energy_has_no_scale)
{
  const Ellipsoid_on_sphere map;
  for(const double radius : {1., 0.3, 1e6})
  {
    const std::vector<SP::Face_invariants_3> faces = scaled(map.faces, radius);
    EXPECT_EQ(SP::Optimal_radius_3()(SP::Conformal_energy_3(), faces, radius), radius);
    EXPECT_EQ(SP::Optimal_radius_3()(Plain_conformal(), faces, radius), radius);
  }
}

// Goes to a given radius by a factor in each step; tells apart the phases of the two-phase policy.
struct Moving_radius
{
  double factor;
  bool is_valid() const { return factor > 0.; }
  double initial_radius(double) const { return 100. * factor; }
  template <class Energy, class FaceRange>
  double operator()(const Energy&, const FaceRange&, double radius)
  {
    const double change = factor;
    factor = std::sqrt(factor);
    return change * radius;
  }
};

TEST(Two_phase_radius, changes_when_the_first_phase_has_settled)
{
  const std::vector<SP::Face_invariants_3> none;
  using Two_phase = SP::Two_phase_radius_3<Moving_radius, SP::Fixed_radius_3>;
  for(const double tolerance : {1e-1, 1e-3})
  {
    Two_phase policy(Moving_radius{3.}, SP::Fixed_radius_3(42.), tolerance);
    EXPECT_EQ(policy.initial_radius(1.), 300.);
    double radius = 1., factor = 3.;
    bool is_settled = false;
    for(int k = 0; k < 20; ++k)
    {
      const double next = policy(energy, none, radius);
      if(is_settled)
      {
        EXPECT_EQ(next, 42.);
      }
      else
      {
        EXPECT_EQ(next, factor * radius);
        is_settled = std::abs(factor - 1.) <= tolerance;
        factor = std::sqrt(factor);
      }
      radius = next;
    }
    EXPECT_TRUE(is_settled);
  }
}

// With the tolerance 0, only a call ends the first phase; it does so in any case.
TEST(Two_phase_radius, changes_when_it_is_told_to)
{
  const std::vector<SP::Face_invariants_3> none;
  for(const double tolerance : {0., 1e-3})
  {
    SP::Two_phase_radius_3<SP::Fixed_radius_3, SP::Fixed_radius_3> policy(SP::Fixed_radius_3(7.),
                                                                          SP::Fixed_radius_3(42.), tolerance);
    EXPECT_TRUE(policy.is_valid());
    if(tolerance == 0.)
    {
      for(int k = 0; k < 10; ++k) // the radius has settled at once
      {
        EXPECT_EQ(policy(energy, none, 7.), 7.);
      }
    }
    EXPECT_TRUE(policy.next_phase());
    for(int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(policy(energy, none, 7.), 42.);
      EXPECT_FALSE(policy.next_phase()); // there is no third one
    }
  }
  SP::Two_phase_radius_3<SP::Fixed_radius_3, SP::Fixed_radius_3> settled(SP::Fixed_radius_3(7.),
                                                                         SP::Fixed_radius_3(42.));
  EXPECT_EQ(settled(energy, none, 7.), 7.);
  EXPECT_FALSE(settled.next_phase()); // it has begun already
  using Two_phase = SP::Two_phase_radius_3<>;
  EXPECT_FALSE(Two_phase({}, {}, -1e-3).is_valid());
  EXPECT_FALSE(Two_phase({}, {}, std::nan("")).is_valid());
}

// Each of the two may have phases itself.
TEST(Two_phase_radius, goes_through_all_phases_of_its_parts)
{
  const std::vector<SP::Face_invariants_3> none;
  using Fixed = SP::Fixed_radius_3;
  using Two = SP::Two_phase_radius_3<Fixed, Fixed>;
  SP::Two_phase_radius_3<Two, Two> policy(Two(Fixed(1.), Fixed(2.), 0.), Two(Fixed(3.), Fixed(4.), 0.), 0.);
  for(const double radius : {1., 2., 3., 4.})
  {
    EXPECT_EQ(policy(energy, none, radius), radius);
    EXPECT_EQ(policy.next_phase(), radius < 4.);
  }
  EXPECT_EQ(policy(energy, none, 4.), 4.);
}

TEST(Two_phase_radius, is_equation_9_and_then_11_by_default)
{
  const Ellipsoid_on_sphere map;
  SP::Two_phase_radius_3<> policy;
  const double first = policy(energy, map.faces, 1.);
  EXPECT_EQ(first, SP::Area_preserving_radius_3()(energy, map.faces, 1.));
  const double second = policy(energy, scaled(map.faces, first), first); // settled
  EXPECT_NEAR(second, first, 1e-13);
  const double third = policy(energy, scaled(map.faces, second), second);
  EXPECT_NEAR(third, SP::Area_balancing_radius_3()(energy, map.faces, 1.), 1e-13);
  EXPECT_GT(std::abs(third - second), 1e-3);
}

// Runs on a small surface; the radius of the points that were written, and their invariants.
template <class Radius>
struct Written_map
{
  explicit Written_map(const Radius& policy, unsigned int iterations = 60)
  {
    const Triangle_list surface = test_meshes::scaled(test_meshes::bumpy_sphere(2), 3., 3., 3.);
    const Mesh mesh = test_meshes::make_mesh<Mesh>(surface);
    SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, CGAL::Default, CGAL::Default, Radius> bld(
        SP::Symmetric_Dirichlet_energy_3(), SP::Relative_sharpness_3(), policy);
    const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
    EXPECT_EQ(SP::parameterize(mesh, bld, map, CGAL::parameters::number_of_iterations(iterations)), SP::OK);
    EXPECT_TRUE(SP::is_bijective(mesh, map));
    const std::vector<Coordinates> image = test_maps::images(mesh, map);
    radius = bld.report().radius;
    for(const Coordinates& p : image)
    {
      EXPECT_NEAR(test_maps::norm(p) / radius, 1., 1e-15);
    }
    faces = faces_of(surface, image, radius);
    stop_reason = bld.report().stop_reason;
  }

  double radius;
  std::vector<SP::Face_invariants_3> faces;
  SP::Stop_reason stop_reason;
};

TEST(Radius_of_the_written_map, is_the_fixed_one)
{
  for(const double radius : {1., 0.01, 123.456})
  {
    EXPECT_EQ(Written_map<SP::Fixed_radius_3>(SP::Fixed_radius_3(radius)).radius, radius);
  }
}

TEST(Radius_of_the_written_map, preserves_the_area)
{
  const Written_map<SP::Area_preserving_radius_3> run{SP::Area_preserving_radius_3()};
  EXPECT_NEAR(SP::Area_preserving_radius_3()(energy, run.faces, run.radius) / run.radius, 1., 1e-12);
  EXPECT_GT(std::abs(SP::Area_balancing_radius_3()(energy, run.faces, run.radius) / run.radius - 1.), 1e-6);
}

TEST(Radius_of_the_written_map, balances_the_areas)
{
  const Written_map<SP::Area_balancing_radius_3> run{SP::Area_balancing_radius_3()};
  EXPECT_NEAR(SP::Area_balancing_radius_3()(energy, run.faces, run.radius) / run.radius, 1., 1e-12);
}

TEST(Radius_of_the_written_map, minimises_the_energy)
{
  const Written_map<SP::Optimal_radius_3> run{SP::Optimal_radius_3()};
  EXPECT_NEAR(SP::Optimal_radius_3()(energy, run.faces, run.radius) / run.radius, 1., 1e-12);
  EXPECT_GT(std::abs(SP::Area_balancing_radius_3()(energy, run.faces, run.radius) / run.radius - 1.), 1e-6);
}

TEST(Radius_of_the_written_map, is_that_of_equation_11_by_default)
{
  const Written_map<SP::Two_phase_radius_3<>> run{SP::Two_phase_radius_3<>()};
  EXPECT_NEAR(SP::Area_balancing_radius_3()(energy, run.faces, run.radius) / run.radius, 1., 1e-12);
  // also of a run that ends before the first phase has
  for(const unsigned int iterations : {0u, 1u})
  {
    const Written_map<SP::Two_phase_radius_3<>> start(SP::Two_phase_radius_3<>(), iterations);
    EXPECT_NEAR(SP::Area_balancing_radius_3()(energy, start.faces, start.radius) / start.radius, 1., 1e-12);
  }
}

} // namespace
