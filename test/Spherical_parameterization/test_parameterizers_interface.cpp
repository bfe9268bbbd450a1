// The interface as a user writes it: settings that change one thing each, and models of the concepts, with no more than the concepts ask for, in place of those of the package.

#include <CGAL/Spherical_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Conformal_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Published_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Stereographic_parameterizer_3.h>

#include "archetypes.h"
#include "engine.h"
#include "methods.h"

#include <Eigen/Cholesky>

using namespace test;

namespace {

namespace params = CGAL::parameters;

const Mesh& mesh()
{
  static const Mesh result = make(bumpy_sphere(2));
  return result;
}

// Runs a parameterizer that is to find a bijection.
template <class Parameterizer>
Images run(Parameterizer&& parameterizer, unsigned int iterations = 30)
{
  const Point_map map(mesh(), sentinels(num_vertices(mesh())));
  EXPECT_EQ(SP::parameterize(mesh(), parameterizer, map, params::number_of_iterations(iterations)), SP::OK);
  const Images result = images(mesh(), map);
  EXPECT_TRUE(is_bijective(mesh(), result));
  return result;
}

template <class Parameterizer>
void expect_same_map(Parameterizer&& a, const Images& b)
{
  EXPECT_TRUE(have_same_bits(run(a), b));
}

template <class Parameterizer>
void expect_other_map(Parameterizer&& a, const Images& b)
{
  EXPECT_FALSE(have_same_bits(run(a), b));
}

const Images& default_images()
{
  static const Images result = run(SP::Bijective_low_distortion_parameterizer_3());
  return result;
}

using Bld = SP::Bijective_low_distortion_parameterizer_3<>;
using SP::Sharpness;

using archetypes::Copy_constructible;
using archetypes::Distortion_energy;

constexpr Copy_constructible::Maker maker = Copy_constructible::MADE_BY_TEST;

TEST(Setting, leaves_the_parameterizer_that_it_is_asked_of)
{
  const Bld bld;
  static_cast<void>(bld.sharpness(Sharpness::lowest_average()).tolerances(1., 1.).energy(SP::Conformal_energy_3()));
  expect_same_map(Bld(bld), default_images());
}

TEST(Setting, of_what_is_the_default_changes_nothing)
{
  const SP::Symmetric_Dirichlet_energy_3 energy;
  expect_same_map(Bld().energy(energy), default_images());
  expect_same_map(Bld().sharpness(Sharpness()), default_images());
  expect_same_map(Bld().sharpness(Sharpness::balanced()), default_images());
  expect_same_map(Bld().tolerances(1e-3, 2e-3), default_images());
  expect_same_map(Bld().initial_parameterizer(SP::Hierarchical_parameterizer_3().energy(energy).sweeps_per_level(5)),
                  default_images());
}

TEST(Setting, matters_in_no_order)
{
  const SP::Isometric_energy_3 energy(0.7);
  const SP::Fixed_radius_3 radius(1.4);
  const Sharpness sharpness = Sharpness::relative(3.);
  const Images expected = run(Bld().energy(energy).radius(radius).sharpness(sharpness).tolerances(1e-2, 1.));
  EXPECT_FALSE(have_same_bits(expected, default_images()));
  expect_same_map(Bld().sharpness(sharpness).tolerances(1e-2, 1.).radius(radius).energy(energy), expected);
  // the hierarchy of the default gets the energy, whenever it is set
  const auto hierarchical = SP::Hierarchical_parameterizer_3().energy(energy);
  expect_same_map(
      Bld().initial_parameterizer(hierarchical).radius(radius).tolerances(1e-2, 1.).energy(energy).sharpness(sharpness),
      expected);
}

TEST(Setting, of_each_kind_matters)
{
  expect_other_map(Bld().sharpness(Sharpness::lowest_average()), default_images());
  expect_other_map(Bld().tolerances(0., 0.), default_images());
  expect_other_map(Bld().initial_parameterizer(SP::Stereographic_parameterizer_3()), default_images());

  const SP::Hierarchical_parameterizer_3 hierarchical;
  const Images of_hierarchy = run(SP::Hierarchical_parameterizer_3(hierarchical));
  expect_same_map(hierarchical.energy(SP::Isometric_energy_3()), of_hierarchy);
  expect_other_map(hierarchical.energy(SP::Symmetric_Dirichlet_energy_3()), of_hierarchy);

  const SP::Published_low_distortion_parameterizer_3 published;
  const Images of_published = run(SP::Published_low_distortion_parameterizer_3(published), 120);
  EXPECT_FALSE(have_same_bits(run(published.sharpness(Sharpness::fixed(1.)), 120), of_published));
  EXPECT_FALSE(have_same_bits(run(published.radius(SP::Fixed_radius_3(1.3)), 120), of_published));
  EXPECT_FALSE(
      have_same_bits(run(published.initial_parameterizer(SP::Stereographic_parameterizer_3()), 120), of_published));
}

TEST(Concept, distortion_energy)
{
  auto balanced = Bld().energy(Distortion_energy(maker, 0.1));
  auto average = Bld().energy(Distortion_energy(maker, 0.1)).sharpness(Sharpness::lowest_average());
  const Images of_balanced = run(balanced);
  run(average);
  EXPECT_LT(average.report().average_energy, average.report().initial_energy);
  EXPECT_LT(average.report().average_energy, balanced.report().average_energy);
  EXPECT_LT(balanced.report().largest_energy, average.report().largest_energy);
  expect_other_map(Bld().energy(Distortion_energy(maker, 10.)), of_balanced);
  // Optimal_radius_3 has to find the best radius for itself
  expect_other_map(Bld().energy(Distortion_energy(maker, 0.1)).radius(SP::Optimal_radius_3()), of_balanced);
  auto hierarchical = SP::Hierarchical_parameterizer_3().energy(Distortion_energy(maker, 0.1));
  run(hierarchical);
  EXPECT_GT(hierarchical.report().number_of_level_iterations, 0u);
}

// An energy that is written for single numbers is that for lanes, to the last bit; and only positive faces have one.
TEST(Concept, distortion_energy_of_single_numbers)
{
  expect_same_map(Bld().energy(Hooked_energy()), default_images());
}

// The map is as good as the one that it started from; the report states what the energy has done, whatever ended the run.
TEST(Concept, distortion_energy_may_not_be_finite)
{
  for(const double weight : {std::nan(""), std::numeric_limits<double>::infinity()})
    for(const double seconds : {0., 1e-9})
    {
      auto bld = Bld().energy(Distortion_energy(maker, weight));
      const Point_map map(mesh(), sentinels(num_vertices(mesh())));
      ASSERT_EQ(SP::parameterize(mesh(), bld, map, params::number_of_iterations(5).maximum_running_time(seconds)),
                SP::OK);
      EXPECT_TRUE(is_bijective(mesh(), images(mesh(), map)));
      EXPECT_EQ(bld.report().stop_reason, SP::NON_FINITE_ENERGY);
      EXPECT_TRUE(std::isnan(bld.report().average_energy));
      EXPECT_TRUE(std::isnan(bld.report().largest_energy));
    }
}

TEST(Concept, distortion_energy_may_return_any_scale)
{
  const auto run_with = [](const Hooked_energy& energy) {
    auto method = Bld().energy(energy).radius(SP::Optimal_radius_3());
    const Images result = run(method, 90);
    return std::make_pair(measure(mesh(), result).isometric, method.report());
  };
  const auto [right, report] = run_with(Hooked_energy());
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double scale : {std::nan(""), infinity, 0., -1.})
  {
    const auto [distortion, wrong_report] = run_with(Hooked_energy(nullptr, scale));
    // The radius stays, so what is lost is what a better one would have gained.
    EXPECT_LT(distortion.maximum, 1.3 * right.maximum) << scale;
    EXPECT_LT(distortion.average, 1.3 * right.average) << scale;
    EXPECT_LT(wrong_report.number_of_level_iterations, 2 * report.number_of_level_iterations) << scale;
    EXPECT_EQ(wrong_report.number_of_attempts, 1u) << scale;
  }
}

TEST(Concept, sphere_radius_policy)
{
  const Images result = run(Bld().radius(archetypes::Sphere_radius_policy(maker)));
  double sum = 0.;
  const Images surface = points(mesh());
  for(const Triangle& t : triangles(mesh()))
    sum += area(result[t[0]], result[t[1]], result[t[2]]) / area(surface[t[0]], surface[t[1]], surface[t[2]]);
  EXPECT_NEAR(sum / static_cast<double>(num_faces(mesh())), 1., 1e-12);
}

// one sphere after the other, and how often it was asked for the next one
struct My_radius_in_phases
{
  double initial_radius(double) const { return 1.; }

  template <class Energy>
  double operator()(const Energy&, const SP::Face_range_3&, double)
  {
    return 1. + 0.1 * phase;
  }

  bool next_phase()
  {
    ++*number_of_calls;
    std::this_thread::sleep_for(pause);
    return ++phase <= number_of_phases;
  }

  int* number_of_calls;
  int number_of_phases = 3;
  std::chrono::milliseconds pause{0};
  int phase = 0;
};

TEST(Concept, sphere_radius_policy_with_phases)
{
  int number_of_calls = 0;
  auto bld = Bld().radius(My_radius_in_phases{&number_of_calls});
  run(bld, 1000);
  // The run goes on as long as there is a next phase; then the last radius is asked for.
  EXPECT_EQ(bld.report().stop_reason, SP::CONVERGED);
  EXPECT_EQ(number_of_calls, 4); // the last one returns false
  EXPECT_EQ(bld.report().radius, 1.4);
  run(bld, 2);
  // A run that was ended early skips the phases that are left.
  EXPECT_EQ(number_of_calls, 8);
  EXPECT_EQ(bld.report().radius, 1.4);
}

TEST(Concept, sphere_radius_policy_may_have_phases_without_end)
{
  const int endless = (std::numeric_limits<int>::max)();
  int number_of_calls = 0;
  auto bld = Bld().radius(My_radius_in_phases{&number_of_calls, endless});
  run(bld, 3);
  EXPECT_EQ(number_of_calls, 1000);
  EXPECT_EQ(bld.report().stop_reason, SP::ITERATION_LIMIT);

  number_of_calls = 0;
  auto slow = Bld().radius(My_radius_in_phases{&number_of_calls, endless, std::chrono::milliseconds(1)});
  const Point_map map(mesh(), sentinels(num_vertices(mesh())));
  EXPECT_EQ(SP::parameterize(mesh(), slow, map, params::number_of_iterations(3).maximum_running_time(0.5)), SP::OK);
  EXPECT_LT(number_of_calls, 1000);
  EXPECT_EQ(slow.report().stop_reason, SP::TIME_LIMIT);
}

struct Mad_radius
{
  double initial_radius(double) const { return std::nan(""); }

  template <class Energy>
  double operator()(const Energy&, const SP::Face_range_3&, double)
  {
    ++calls;
    return calls % 3 == 0 ? std::nan("") : calls % 3 == 1 ? -1. : std::numeric_limits<double>::infinity();
  }

  int calls = 0;
};

TEST(Concept, sphere_radius_policy_may_return_anything)
{
  auto bld = Bld().radius(Mad_radius());
  run(bld);
  // the sphere with the area of the surface
  double sum = 0.;
  const Images surface = points(mesh());
  for(const Triangle& t : triangles(mesh()))
    sum += area(surface[t[0]], surface[t[1]], surface[t[2]]);
  EXPECT_NEAR(bld.report().radius, std::sqrt(sum / (4. * pi)), 1e-9);
}

// SparseLinearAlgebraWithFactorTraits_d, with nothing but a dense matrix.
class My_solver
{
public:
  using NT = double;

  struct Vector
  {
    explicit Vector(std::size_t n)
      : values(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n)))
    {}
    double& operator[](std::ptrdiff_t i) { return values[i]; }
    double operator[](std::ptrdiff_t i) const { return values[i]; }

    Eigen::VectorXd values;
  };

  struct Matrix
  {
    explicit Matrix(std::size_t n, bool /* is_symmetric */ = false)
      : Matrix(n, n)
    {}
    Matrix(std::size_t n, std::size_t n_columns, bool /* is_symmetric */ = false)
      : values(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n_columns)))
    {}
    void set_coef(std::size_t i, std::size_t j, double value, bool /* is_new */ = false)
    {
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = value;
    }

    Eigen::MatrixXd values;
  };

  bool factor(const Matrix& matrix, double& denominator)
  {
    denominator = 1.;
    return m_cholesky.compute(matrix.values).info() == Eigen::Success;
  }

  bool linear_solver(const Vector& right, Vector& solution)
  {
    solution.values = m_cholesky.solve(right.values);
    ++number_of_calls;
    return true;
  }

  static inline int number_of_calls = 0;

private:
  Eigen::LLT<Eigen::MatrixXd> m_cholesky;
};

TEST(Concept, sparse_linear_algebra_traits)
{
  const auto expect_close = [](auto&& by_my_solver, auto&& by_default) {
    My_solver::number_of_calls = 0;
    const Images mine = run(by_my_solver);
    EXPECT_GT(My_solver::number_of_calls, 3);
    EXPECT_LT(largest_distance(mine, run(by_default)), 1e-8);
  };
  expect_close(SP::Harmonic_parameterizer_3<My_solver>(), SP::Harmonic_parameterizer_3());
  using Start = SP::Stereographic_parameterizer_3<>;
  expect_close(SP::ARAP_parameterizer_3<Start, My_solver>(), SP::ARAP_parameterizer_3<Start>());
}

// Projects a surface from the origin, which is a bijection if it is star-shaped about it, or gives up.
struct Radial_projection
{
  template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters>
  SP::Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, const NamedParameters& np)
  {
    const auto vpm = params::choose_parameter(params::get_parameter(np, CGAL::internal_np::vertex_point),
                                              get_const_property_map(CGAL::vertex_point, tmesh));
    for(const auto v : vertices(tmesh))
    {
      const auto& p = get(vpm, v);
      const double r = norm({p.x(), p.y(), p.z()});
      put(vertex_sphere_map, v, Point_3(p.x() / r, p.y() / r, p.z() / r));
    }
    return code;
  }

  SP::Error_code code = SP::OK;
};

TEST(Concept, spherical_parameterizer)
{
  auto bld = Bld().initial_parameterizer(Radial_projection());
  const Images mapped = run(bld);
  EXPECT_EQ(bld.report().number_of_levels, 0u); // no hierarchy
  EXPECT_LT(bld.report().average_energy, bld.report().initial_energy);

  // Without any sweep, the projection itself is what comes out.
  const Images projected = run(bld, 0);
  const Images surface = points(mesh());
  for(std::size_t v = 0; v < surface.size(); ++v)
    EXPECT_LT(distance(normalized(projected[v]), normalized(surface[v])), 1e-15);

  // It gets the points that the caller gives.
  const Mesh other = make(icosphere(2)); // the same connectivity
  const Point_map map(other, sentinels(num_vertices(other)));
  ASSERT_EQ(
      SP::parameterize(other, bld, map, params::vertex_point_map(Point_map(other, surface)).number_of_iterations(30u)),
      SP::OK);
  EXPECT_TRUE(have_same_bits(images(other, map), mapped));
}

TEST(Concept, spherical_parameterizer_is_checked_and_may_fail)
{
  Triangle_list list = bumpy_sphere(2);
  for(Coordinates& p : list.points)
    p[0] += 3.; // off the origin, the surface is not star-shaped about it
  const Mesh moved = make(list);
  const auto expect_error = [](const Mesh& tmesh, Radial_projection projection, SP::Error_code error) {
    const Images before = sentinels(num_vertices(tmesh));
    const Point_map map(tmesh, before);
    EXPECT_EQ(SP::parameterize(tmesh, Bld().initial_parameterizer(projection), map), error);
    EXPECT_TRUE(have_same_bits(images(tmesh, map), before));
  };
  expect_error(moved, {}, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  expect_error(mesh(), {SP::ERROR_INSUFFICIENT_PRECISION}, SP::ERROR_INSUFFICIENT_PRECISION);
  // A map that folds is nothing to start from; the caller's own map has not been written then.
  expect_error(mesh(), {SP::ERROR_NO_1_TO_1_MAPPING}, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
}

using Vertex_point_map = archetypes::Vertex_point_map<Mesh, Mesh::Vertex_index, Point_3>;
using Vertex_sphere_map = archetypes::Vertex_sphere_map<Mesh::Vertex_index, Point_3>;

// An archetype that could do more than its concept asks for would let more pass than it should.
template <class Archetype>
constexpr bool is_minimal =
    std::is_copy_constructible<Archetype>::value && !std::is_default_constructible<Archetype>::value &&
    !std::is_copy_assignable<Archetype>::value;
static_assert(is_minimal<Distortion_energy> && is_minimal<archetypes::Distortion_energy_in_lanes>, "");
static_assert(is_minimal<archetypes::Sphere_radius_policy> && is_minimal<archetypes::Spherical_parameterizer>, "");
static_assert(is_minimal<archetypes::Visitor> && is_minimal<Vertex_point_map> && is_minimal<Vertex_sphere_map>, "");

// Maps a surface that no method folds, with archetypes for the property maps and the visitor.
template <class Parameterizer>
void expect_bijection(Parameterizer&& parameterizer)
{
  static const Mesh round = make(ellipsoid(1., 1.3, 0.8, 2));
  std::map<Mesh::Vertex_index, Point_3> result;
  archetypes::Visitor visitor(maker);
  ASSERT_EQ(SP::parameterize(
                round, parameterizer, Vertex_sphere_map(result),
                params::vertex_point_map(Vertex_point_map(round)).visitor(std::ref(visitor)).number_of_iterations(20u)),
            SP::OK);
  EXPECT_EQ(result.size(), num_vertices(round));
  EXPECT_TRUE(SP::is_bijective(round, boost::make_assoc_property_map(result)));
}

TEST(Archetype, distortion_energy)
{
  const Distortion_energy energy(maker, 0.1);
  expect_bijection(Bld().energy(energy).radius(SP::Optimal_radius_3()));
  expect_bijection(SP::Hierarchical_parameterizer_3().energy(energy));
}

TEST(Archetype, sphere_radius_policy)
{
  const archetypes::Sphere_radius_policy radius(maker);
  expect_bijection(Bld().radius(radius));
  expect_bijection(SP::Published_low_distortion_parameterizer_3().radius(radius));
  using Two_phases = SP::Two_phase_radius_3<archetypes::Sphere_radius_policy, archetypes::Sphere_radius_policy>;
  expect_bijection(Bld().radius(Two_phases(radius, radius)));
}

TEST(Archetype, spherical_parameterizer)
{
  const archetypes::Spherical_parameterizer initial(maker);
  expect_bijection(archetypes::Spherical_parameterizer(initial));
  expect_bijection(Bld().initial_parameterizer(initial));
  expect_bijection(SP::Published_low_distortion_parameterizer_3().initial_parameterizer(initial));
  expect_bijection(SP::ARAP_parameterizer_3(initial));
}

TEST(Archetype, visitor_and_property_maps)
{
  expect_bijection(SP::Stereographic_parameterizer_3());
  expect_bijection(SP::Harmonic_parameterizer_3());
  expect_bijection(SP::Conformal_parameterizer_3());
  expect_bijection(SP::Precomputed_parameterizer_3(Vertex_point_map(mesh())));

  // by value, and with the default method
  std::map<Mesh::Vertex_index, Point_3> result;
  EXPECT_EQ(SP::parameterize(mesh(), Vertex_sphere_map(result), params::visitor(archetypes::Visitor(maker))), SP::OK);
  EXPECT_EQ(result.size(), num_vertices(mesh()));
  EXPECT_TRUE(have_same_bits(images(mesh(), boost::make_assoc_property_map(result)), bijective().run(mesh()).images));

  const Vertex_point_map surface(mesh());
  const auto np = params::vertex_point_map(surface);
  EXPECT_TRUE(SP::is_bijective(mesh(), surface));
  EXPECT_EQ(distortion_of(mesh(), surface, np).isometric.maximum, 1.);
  EXPECT_EQ(SP::find_defect(mesh(), np).error, SP::OK);
}

} // namespace
