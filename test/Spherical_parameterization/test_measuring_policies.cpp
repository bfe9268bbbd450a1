// The energies of a triangle: values by their definition in the singular values, derivatives by central differences, and
// the scale that minimises a sum of energies by a search. The radius of the sphere: each formula against the sums that it is
// made of, and on whole runs against the map that was written. The sharpness of runs.

#include "methods.h"
#include "random_meshes.h"

#ifdef CGAL_LINKED_WITH_TBB
// The range of faces whose sums are parallel is made by the descent alone; this is a descent for tests.
template <>
class CGAL::Spherical_parameterization::internal::Block_coordinate_descent<void, void>
{
public:
  static Face_range_3 parallel_range(const std::vector<Face_invariants_3>& faces)
  {
    return {faces.data(), faces.data() + faces.size(), execution_of<Parallel_tag>()};
  }
};
#endif

using namespace test;

namespace {

using Faces = std::vector<SP::Face_invariants_3>;

SP::Face_range_3 range(const Faces& faces)
{
  return {faces.data(), faces.data() + faces.size()};
}

// ---------------------------------------------------------------------------------------------------------------------
// Energies

using Definition = std::function<long double(long double, long double)>; // of the singular values

template <class Energy>
void expect_definition(const Energy& energy, const Definition& definition)
{
  Random random(1);
  for(int k = 0; k < 1000; ++k)
  {
    const double s1 = random.factor(1e3), s2 = random.factor(1e3);
    const double reference = static_cast<double>(definition(s1, s2));
    ASSERT_NEAR(energy(s1 * s1 + s2 * s2, s1 * s2), reference, 1e-14 * reference);
  }
  EXPECT_DOUBLE_EQ(energy(2., 1.), static_cast<double>(definition(1.L, 1.L)));
}

template <class Energy>
void expect_derivatives(const Energy& energy)
{
  Random random(2);
  for(int k = 0; k < 1000; ++k)
  {
    const double s1 = random.factor(100.), s2 = random.factor(100.);
    const double i = s1 * s1 + s2 * s2, d = s1 * s2;
    const double hi = 1e-4 * i, hd = 1e-4 * d;
    const SP::Energy_derivatives_3<> e = energy.derivatives(i, d);
    ASSERT_NEAR(e.value, energy(i, d), 1e-14 * e.value);

    // The error of a central difference is a sixth of the third derivative times the square of the step, and the energies
    // have no higher power than the -4th in d.
    const double tolerance = 1e-6 * e.value;
    ASSERT_NEAR(e.i * i, (energy(i + hi, d) - energy(i - hi, d)) / (2. * hi) * i, tolerance);
    ASSERT_NEAR(e.d * d, (energy(i, d + hd) - energy(i, d - hd)) / (2. * hd) * d, tolerance);
    const SP::Energy_derivatives_3<> i1 = energy.derivatives(i + hi, d), i0 = energy.derivatives(i - hi, d);
    const SP::Energy_derivatives_3<> d1 = energy.derivatives(i, d + hd), d0 = energy.derivatives(i, d - hd);
    ASSERT_NEAR(e.ii * i * i, (i1.i - i0.i) / (2. * hi) * i * i, tolerance);
    ASSERT_NEAR(e.id * i * d, (i1.d - i0.d) / (2. * hi) * i * d, tolerance);
    ASSERT_NEAR(e.id * i * d, (d1.i - d0.i) / (2. * hd) * i * d, tolerance);
    ASSERT_NEAR(e.dd * d * d, (d1.d - d0.d) / (2. * hd) * d * d, tolerance);
  }
}

Faces random_faces(std::uint32_t seed, double scale)
{
  Random random(seed);
  Faces faces;
  for(int k = 0; k < 50; ++k)
  {
    const double s1 = scale * random.factor(5.), s2 = scale * random.factor(5.);
    const double area = random.factor(10.), flatness = 1. + random.factor(10.);
    faces.push_back({area, s1 * s1 + s2 * s2, s1 * s2, flatness * s1 * s2});
  }
  return faces;
}

template <class Energy>
double total_energy(const Energy& energy, const Faces& faces, double scale)
{
  double total = 0.;
  for(const SP::Face_invariants_3& face : faces)
    total += energy(scale * scale * face.i, scale * scale * face.d);
  return total;
}

template <class Energy>
void expect_optimal_scale(const Energy& energy)
{
  for(std::uint32_t seed = 0; seed < 20; ++seed)
  {
    const Faces faces = random_faces(seed, std::pow(10., static_cast<int>(seed % 7) - 3.));
    const double scale = energy.optimal_scale(range(faces)), minimum = total_energy(energy, faces, scale);
    EXPECT_LT(minimum, total_energy(energy, faces, (1. + 1e-6) * scale));
    EXPECT_LT(minimum, total_energy(energy, faces, (1. - 1e-6) * scale));
  }
}

Definition blend(long double alpha)
{
  return [alpha](long double s1, long double s2) {
    return alpha * (s1 / s2 + s2 / s1) + (1.L - alpha) * (s1 * s2 + 1.L / (s1 * s2));
  };
}

TEST(Energies, have_their_definitions_and_derivatives)
{
  const auto expect = [](const auto& energy, const Definition& definition) {
    expect_definition(energy, definition);
    expect_derivatives(energy);
  };
  expect(SP::Symmetric_Dirichlet_energy_3(),
         [](long double s1, long double s2) { return (s1 * s1 + s2 * s2 + 1.L / (s1 * s1) + 1.L / (s2 * s2)) / 2.L; });
  for(const double epsilon : {1e-3, 0.5})
    expect(SP::Stretch_energy_3(epsilon), [epsilon](long double s1, long double s2) {
      return 1.L / (s1 * s1) + 1.L / (s2 * s2) + epsilon * (s1 * s1 + s2 * s2);
    });
  for(const double alpha : {0.1, 0.5, 0.9, 1.})
    expect(SP::Isometric_energy_3(alpha), blend(alpha));
  expect(SP::Conformal_energy_3(), blend(1.));
}

TEST(Energies, know_their_optimal_scale)
{
  expect_optimal_scale(SP::Symmetric_Dirichlet_energy_3());
  for(const double alpha : {0.1, 0.5, 0.9})
    expect_optimal_scale(SP::Isometric_energy_3(alpha));
  // no radius is better than another
  EXPECT_EQ(SP::Conformal_energy_3().optimal_scale(range(random_faces(1, 1.))), 1.);
}

TEST(Energies, know_the_range_of_their_weights)
{
  EXPECT_EQ(SP::Isometric_energy_3().alpha(), 0.5);
  for(const auto& [alpha, is_valid] :
      {std::pair(1e-3, true), {1., true}, {0., false}, {1.001, false}, {std::nan(""), false}})
    EXPECT_EQ(SP::Isometric_energy_3(alpha).is_valid(), is_valid) << alpha;
  for(const auto& [epsilon, is_valid] : {std::pair(1e-9, true), {0., false}, {std::nan(""), false}})
    EXPECT_EQ(SP::Stretch_energy_3(epsilon).is_valid(), is_valid) << epsilon;
}

// ---------------------------------------------------------------------------------------------------------------------
// Radius policies

// The faces of a surface on its image, whose vertices have the distance `radius` from the origin, from first principles.
Faces faces_of(const Triangle_list& surface, const Images& image, double radius)
{
  Faces faces;
  for(const Triangle& t : surface.triangles)
  {
    const auto edges = [&](const Images& p) {
      return std::array<Coordinates, 2>{difference(p[t[1]], p[t[0]]), difference(p[t[2]], p[t[0]])};
    };
    const auto e = edges(surface.points), f = edges(image);
    const double doubled_area = norm(cross(e[0], e[1])), doubled_image = norm(cross(f[0], f[1]));
    // the trace of G^-1 H for the metrics G of the surface and H of the image
    const double i = (dot(e[1], e[1]) * dot(f[0], f[0]) - 2. * dot(e[0], e[1]) * dot(f[0], f[1]) +
                      dot(e[0], e[0]) * dot(f[1], f[1])) /
                     (doubled_area * doubled_area);
    const double determinant = dot(image[t[0]], cross(image[t[1]], image[t[2]]));
    faces.push_back({0.5 * doubled_area, i, determinant / (doubled_area * radius), doubled_image / doubled_area});
  }
  return faces;
}

Faces scaled(Faces faces, double radius_factor)
{
  const double s = radius_factor * radius_factor;
  for(SP::Face_invariants_3& face : faces)
    face = {face.area, s * face.i, s * face.d, s * face.flat_d};
  return faces;
}

// An ellipsoid of revolution with the half-axes 1, 1, 2 on the unit sphere, by the stretch that made it.
struct Ellipsoid_on_sphere
{
  Triangle_list sphere = icosphere(4);
  Triangle_list ellipsoid = test_meshes::scaled(sphere, 1., 1., 2.);
  Faces faces = faces_of(ellipsoid, sphere.points, 1.);
};

// an energy without a closed form of the best scale
template <class Energy>
struct Plain
{
  double operator()(double i, double d) const { return Energy()(i, d); }
  SP::Energy_derivatives_3<> derivatives(double i, double d) const { return Energy().derivatives(i, d); }
};

const SP::Symmetric_Dirichlet_energy_3 energy;

TEST(Radius, of_a_sphere_on_a_sphere_is_found_in_one_step)
{
  const Triangle_list sphere = icosphere(3);
  for(const double size : {1., 5.})
  {
    const Faces faces = faces_of(test_meshes::scaled(sphere, size, size, size), sphere.points, 1.);
    EXPECT_NEAR(SP::Area_preserving_radius_3()(energy, range(faces), 1.), size, 1e-14 * size);
    EXPECT_NEAR(SP::Area_balancing_radius_3()(energy, range(faces), 1.), size, 1e-14 * size);
    // The energy's d is that of the planes' distance from the center, a little below 1: about the largest triangles'
    // inradius squared over two.
    EXPECT_NEAR(SP::Optimal_radius_3()(energy, range(faces), 1.), size, 1e-2 * size);
    EXPECT_EQ(SP::Fixed_radius_3(0.75)(energy, range(faces), 1.), 0.75);
  }
}

// The faces of a run are summed up block by block, by several threads: each face once, however many there are, and to the
// same bits.
TEST(Face_range, has_sums_that_do_not_depend_on_threads)
{
  for(const std::size_t n : {0u, 1u, 2u, 1023u, 1024u, 1025u, 2048u, 10000u})
  {
    Faces faces;
    double sum = 0.;
    for(std::size_t k = 0; k < n; ++k)
    {
      const double x = 1. + static_cast<double>(k * 7919 % 1000) / 250.;
      faces.push_back({x, 2. + x, 0.9 / x, 1.1 / x});
      sum += x;
    }
    EXPECT_EQ(range(faces).size(), n);
    EXPECT_EQ(range(faces).empty(), n == 0);
    const auto terms = [](const SP::Face_invariants_3& face) { return std::array<double, 2>{1., face.area}; };
    const std::array<double, 2> sums = range(faces).sums<2>(terms);
    EXPECT_EQ(sums[0], static_cast<double>(n));
    EXPECT_NEAR(sums[1], sum, 1e-12 * sum);
#ifdef CGAL_LINKED_WITH_TBB
    const SP::Face_range_3 parallel = SP::internal::Block_coordinate_descent<void, void>::parallel_range(faces);
    EXPECT_EQ(parallel.sums<2>(terms), sums);
    if(n > 0)
    {
      EXPECT_EQ(SP::Area_balancing_radius_3()(energy, parallel, 1.2),
                SP::Area_balancing_radius_3()(energy, range(faces), 1.2));
      EXPECT_EQ(SP::Optimal_radius_3()(Plain<SP::Isometric_energy_3>(), parallel, 1.2),
                SP::Optimal_radius_3()(Plain<SP::Isometric_energy_3>(), range(faces), 1.2));
    }
#endif
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
  const double radius = SP::Area_preserving_radius_3()(energy, range(map.faces), 1.);
  EXPECT_NEAR(radius, std::sqrt(area / image_area), 1e-13);
  // the same sphere, wherever the step starts
  EXPECT_NEAR(SP::Area_preserving_radius_3()(energy, range(scaled(map.faces, 7.)), 7.), radius, 1e-13);
}

TEST(Area_balancing_radius, of_an_ellipsoid)
{
  const Ellipsoid_on_sphere map;
  const double radius = SP::Area_balancing_radius_3()(energy, range(map.faces), 1.);
  double sum = 0., sum_of_inverses = 0.;
  for(const SP::Face_invariants_3& face : scaled(map.faces, radius))
  {
    sum += face.flat_d;
    sum_of_inverses += 1. / face.flat_d;
  }
  EXPECT_NEAR(sum / sum_of_inverses, 1., 1e-13);
  EXPECT_NEAR(SP::Area_balancing_radius_3()(energy, range(scaled(map.faces, 0.01)), 0.01), radius, 1e-13);
}

TEST(Optimal_radius, minimises_the_energy_in_use)
{
  const Ellipsoid_on_sphere map;
  const auto expect_minimum = [&](const auto& e) {
    const auto total = [&](double radius) {
      double sum = 0.;
      for(const SP::Face_invariants_3& face : scaled(map.faces, radius))
        sum += (SP::internal::weighs_faces_by_area<std::decay_t<decltype(e)>> ? face.area : 1.) * e(face.i, face.d);
      return sum;
    };
    const double radius = SP::Optimal_radius_3()(e, range(map.faces), 1.);
    EXPECT_LT(total(radius), total(1.0001 * radius));
    EXPECT_LT(total(radius), total(0.9999 * radius));
  };
  expect_minimum(energy);
  expect_minimum(SP::Isometric_energy_3());
  expect_minimum(SP::Isometric_energy_3(0.9));
  expect_minimum(Plain<SP::Symmetric_Dirichlet_energy_3>());
  expect_minimum(SP::Stretch_energy_3());
}

TEST(Optimal_radius, by_newton_agrees_with_the_closed_form)
{
  const Ellipsoid_on_sphere map;
  const auto expect_same = [&](const auto& e, const auto& plain) {
    const double expected = SP::Optimal_radius_3()(e, range(map.faces), 1.);
    for(const double radius : {1., 1e-3, 0.1, 20., 1e3})
      EXPECT_NEAR(SP::Optimal_radius_3()(plain, range(scaled(map.faces, radius)), radius), expected, 1e-9);
  };
  expect_same(energy, Plain<SP::Symmetric_Dirichlet_energy_3>());
  expect_same(SP::Isometric_energy_3(), Plain<SP::Isometric_energy_3>());
}

TEST(Optimal_radius, stays_where_the_energy_has_no_scale)
{
  const Ellipsoid_on_sphere map;
  for(const double radius : {1., 0.3, 1e6})
  {
    const Faces faces = scaled(map.faces, radius);
    EXPECT_EQ(SP::Optimal_radius_3()(SP::Conformal_energy_3(), range(faces), radius), radius);
    EXPECT_EQ(SP::Optimal_radius_3()(Plain<SP::Conformal_energy_3>(), range(faces), radius), radius);
  }
}

const SP::Face_range_3 none(nullptr, nullptr);

// Multiplies the radius by a factor, then by the root of that, and so on.
struct Moving_radius
{
  double factor;
  bool is_valid() const { return factor > 0.; }
  double initial_radius(double) const { return 100. * factor; }
  template <class Energy>
  double operator()(const Energy&, const SP::Face_range_3&, double radius)
  {
    const double change = factor;
    factor = std::sqrt(factor);
    return change * radius;
  }
};

TEST(Two_phase_radius, changes_when_the_first_phase_has_settled)
{
  using Two_phase = SP::Two_phase_radius_3<Moving_radius, SP::Fixed_radius_3>;
  for(const double tolerance : {1e-1, 1e-3})
  {
    Two_phase policy(Moving_radius{3.}, SP::Fixed_radius_3(42.), tolerance);
    EXPECT_EQ(policy.initial_radius(1.), 300.);
    double radius = 1., change = 9.;
    while(std::abs(change - 1.) > tolerance)
    {
      change = std::sqrt(change);
      EXPECT_EQ(policy(energy, none, radius), change * radius);
      radius *= change;
    }
    for(int k = 0; k < 3; ++k)
      EXPECT_EQ(policy(energy, none, radius), 42.);
  }
}

// With the tolerance 0, only a call ends a phase; it does so in any case. Each of the two may have phases itself.
TEST(Two_phase_radius, changes_when_it_is_told_to)
{
  using Fixed = SP::Fixed_radius_3;
  using Two = SP::Two_phase_radius_3<Fixed, Fixed>;
  SP::Two_phase_radius_3<Two, Two> four(Two(Fixed(1.), Fixed(2.), 0.), Two(Fixed(3.), Fixed(4.), 0.), 0.);
  EXPECT_TRUE(four.is_valid());
  for(const double radius : {1., 2., 3., 4.})
  {
    for(int k = 0; k < 10; ++k) // the radius has settled at once
      EXPECT_EQ(four(energy, none, radius), radius);
    EXPECT_EQ(four.next_phase(), radius < 4.);
  }
  EXPECT_EQ(four(energy, none, 4.), 4.);

  Two at_once(Fixed(7.), Fixed(42.)), settled = at_once;
  EXPECT_TRUE(at_once.next_phase());
  EXPECT_EQ(at_once(energy, none, 7.), 42.);
  EXPECT_FALSE(at_once.next_phase()); // there is no third one
  EXPECT_EQ(settled(energy, none, 7.), 7.);
  EXPECT_FALSE(settled.next_phase()); // it has begun already
  for(const double tolerance : {-1e-3, std::nan("")})
    EXPECT_FALSE(Two(Fixed(), Fixed(), tolerance).is_valid());
}

TEST(Two_phase_radius, is_equation_9_and_then_11_by_default)
{
  const Ellipsoid_on_sphere map;
  SP::Two_phase_radius_3<> policy;
  const double first = policy(energy, range(map.faces), 1.);
  EXPECT_EQ(first, SP::Area_preserving_radius_3()(energy, range(map.faces), 1.));
  const double second = policy(energy, range(scaled(map.faces, first)), first); // settled
  EXPECT_NEAR(second, first, 1e-13);
  const double third = policy(energy, range(scaled(map.faces, second)), second);
  EXPECT_NEAR(third, SP::Area_balancing_radius_3()(energy, range(map.faces), 1.), 1e-13);
  EXPECT_GT(std::abs(third - second), 1e-3);
}

// The radius of the points that were written, and their invariants.
struct Written_map
{
  template <class Radius>
  explicit Written_map(const Radius& policy, int iterations = 60)
  {
    const Triangle_list surface = test_meshes::scaled(bumpy_sphere(2), 3., 3., 3.);
    const Result result = Method("radius", SP::Bijective_low_distortion_parameterizer_3().radius(policy))
                              .run(surface, Options().iterations(iterations));
    EXPECT_EQ(result.error, SP::OK);
    radius = result.report.radius;
    faces = faces_of(surface, result.images, radius);
  }

  // how far the radius is from that of a policy
  template <class Policy>
  double excess_over(Policy policy) const
  {
    return std::abs(policy(energy, range(faces), radius) / radius - 1.);
  }

  double radius;
  Faces faces;
};

TEST(Radius_of_the_written_map, is_that_of_the_policy)
{
  for(const double radius : {1., 0.01, 123.456})
    EXPECT_EQ(Written_map(SP::Fixed_radius_3(radius)).radius, radius);
  const Written_map preserving{SP::Area_preserving_radius_3()}, balancing{SP::Area_balancing_radius_3()},
      optimal{SP::Optimal_radius_3()};
  EXPECT_LT(preserving.excess_over(SP::Area_preserving_radius_3()), 1e-12);
  EXPECT_GT(preserving.excess_over(SP::Area_balancing_radius_3()), 1e-6);
  EXPECT_LT(balancing.excess_over(SP::Area_balancing_radius_3()), 1e-12);
  EXPECT_LT(optimal.excess_over(SP::Optimal_radius_3()), 1e-12);
  EXPECT_GT(optimal.excess_over(SP::Area_balancing_radius_3()), 1e-6);
  for(const int iterations : {0, 1, 60}) // by eq. 11, also of a run that ends before the first phase has
    EXPECT_LT(Written_map(SP::Two_phase_radius_3<>(), iterations).excess_over(SP::Area_balancing_radius_3()), 1e-12);
}

// ---------------------------------------------------------------------------------------------------------------------
// Sharpness

Result run_with(const SP::Sharpness& sharpness, int iterations, double energy_tolerance = 1e-5,
                double radius_tolerance = 1e-3)
{
  return Method("sharpness", SP::Bijective_low_distortion_parameterizer_3().sharpness(sharpness).tolerances(
                                 energy_tolerance, radius_tolerance))
      .run(bumpy_sphere(2), Options().iterations(iterations));
}

TEST(Sharpness, knows_its_range)
{
  using SP::Sharpness;
  for(const Sharpness& s :
      {Sharpness(), Sharpness::lowest_average(), Sharpness::lowest_worst(), Sharpness::relative(1e6),
       Sharpness::fixed(0.7), Sharpness::schedule(), Sharpness::schedule(0.1, 0.1, 100)})
    EXPECT_TRUE(s.is_valid());
  for(const double x : {-1., -1e-9, HUGE_VAL, std::nan("")})
  {
    EXPECT_FALSE(Sharpness::relative(x).is_valid());
    EXPECT_FALSE(Sharpness::fixed(x).is_valid());
    EXPECT_FALSE(Sharpness::schedule(x, 10.).is_valid());
    EXPECT_FALSE(Sharpness::schedule(0.1, x).is_valid());
    EXPECT_FALSE(Sharpness::schedule(0.1, x, 100).is_valid());
  }
  EXPECT_FALSE(Sharpness::fixed(0.).is_valid());
  EXPECT_FALSE(Sharpness::schedule(10., 0.1).is_valid());
}

TEST(Sharpness, of_a_schedule_goes_from_first_to_last)
{
  const Result short_run = run_with(SP::Sharpness::schedule(), 3), run = run_with(SP::Sharpness::schedule(), 2000);
  EXPECT_EQ(short_run.report.stop_reason, SP::ITERATION_LIMIT);
  EXPECT_LT(short_run.report.sharpness, 10.);
  EXPECT_EQ(run.report.sharpness, 10.); // convergence waits for the last one
  EXPECT_GT(run.report.number_of_average_iterations, 0u);
  EXPECT_GT(run.report.number_of_sharp_iterations, 0u);
  EXPECT_EQ(run.report.stop_reason, SP::CONVERGED);
}

TEST(Sharpness, trades_the_average_for_the_maximum)
{
  const Result plain = run_with(SP::Sharpness::lowest_average(), 300),
               sharp = run_with(SP::Sharpness::relative(25.), 300);
  EXPECT_EQ(plain.report.number_of_sharp_iterations, 0u);
  EXPECT_EQ(plain.report.sharpness, 0.);
  EXPECT_EQ(sharp.report.number_of_average_iterations, 0u);
  // s = b / R, and the largest energy is above R
  EXPECT_GT(sharp.report.sharpness * sharp.report.largest_energy, 26.);
  EXPECT_LT(sharp.report.sharpness * sharp.report.largest_energy, 2. * 26.);
  EXPECT_LT(plain.report.average_energy, sharp.report.average_energy);
  EXPECT_LT(sharp.report.largest_energy, plain.report.largest_energy);
  EXPECT_LT(plain.distortion.isometric.average, sharp.distortion.isometric.average);
  for(const Result& result : {sharp, run_with(SP::Sharpness::lowest_worst(), 300)})
    EXPECT_LT(result.distortion.isometric.maximum, 0.9 * plain.distortion.isometric.maximum);
}

TEST(Sharpness, may_be_as_large_as_you_like)
{
  for(const SP::Sharpness& s : {SP::Sharpness::relative(1e3), SP::Sharpness::relative(1e6), SP::Sharpness::fixed(1e5)})
    EXPECT_LT(run_with(s, 20).report.largest_energy, 100.);
}

TEST(Tolerances, are_met)
{
  const Result loose = run_with(SP::Sharpness(), 1000, 1e-3), tight = run_with(SP::Sharpness(), 1000, 1e-6),
               never = run_with(SP::Sharpness(), 100, 0., 0.);
  EXPECT_EQ(loose.report.stop_reason, SP::CONVERGED);
  EXPECT_EQ(tight.report.stop_reason, SP::CONVERGED);
  EXPECT_LT(loose.report.number_of_iterations(), tight.report.number_of_iterations());
  EXPECT_LT(tight.report.largest_energy, loose.report.largest_energy * 1.001);
  EXPECT_EQ(never.report.number_of_iterations(), 100u);
}

} // namespace
