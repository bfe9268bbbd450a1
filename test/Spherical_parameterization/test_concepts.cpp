// Models of the concepts as a user would write them, with no more than the concepts ask for, in place of those of the
// package: each yields a certified map, and each is really used.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle_list;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Default = CGAL::Default;

template <class InitialParameterizer = Default, class Energy = Default, class Sharpness = Default,
          class Radius = Default, class VertexUpdate = Default, class Barrier = Default>
using Bld = SP::Bijective_low_distortion_parameterizer_3<Mesh, InitialParameterizer, Energy, Sharpness, Radius,
                                                         VertexUpdate, Barrier>;

// DistortionEnergy_3, without a default constructor: the angle distortion and some of the square of the area
// distortion.
class My_energy
{
public:
  explicit My_energy(double weight)
    : m_weight(weight)
  {}

  double operator()(double i, double d) const { return derivatives(i, d).value; }

  SP::Energy_derivatives_3 derivatives(double i, double d) const
  {
    const double w = m_weight, d2 = d * d;
    return {i / d + w * (d2 + 1. / d2),
            1. / d,
            -i / d2 + 2. * w * (d - 1. / (d2 * d)),
            0.,
            -1. / d2,
            2. * i / (d2 * d) + 2. * w * (1. + 3. / (d2 * d2))};
  }

private:
  double m_weight;
};

// SharpnessPolicy_3: a ramp that stops after ten sweeps.
class My_sharpness
{
public:
  double operator()(std::size_t sweep, double /* average_energy */, double /* largest_energy */)
  {
    m_sweep = sweep;
    return 0.05 * static_cast<double>(sweep < 10 ? sweep : 10);
  }
  double on_coarse_level(double largest_energy) const { return 1. / largest_energy; }
  bool is_final() const { return m_sweep >= 10; }

private:
  std::size_t m_sweep = 0;
};

// SphereRadiusPolicy_3: such that the average of d on the sphere is 1.
struct My_radius
{
  double initial_radius(double equal_area_radius) const { return 2. * equal_area_radius; }

  template <class Energy, class FaceRange>
  double operator()(const Energy&, const FaceRange& faces, double radius)
  {
    double sum = 0.;
    std::size_t n = 0;
    for(const auto& face : faces)
    {
      sum += face.flat_d;
      ++n;
    }
    return radius * std::sqrt(static_cast<double>(n) / sum);
  }
};

// VertexUpdate_3: a gradient step.
struct My_update
{
  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const
  {
    std::array<double, 2> gradient;
    const double start = energy.gradient(gradient);
    const double length = std::hypot(gradient[0], gradient[1]);
    if(!(length > 0.))
    {
      return false;
    }
    for(double t = energy.shortest_edge(); t > 1e-4 * energy.shortest_edge(); t *= 0.8)
    {
      const double x = -t * gradient[0] / length, y = -t * gradient[1] / length;
      if(energy(x, y) < start)
      {
        step = {x, y};
        return true;
      }
    }
    return false;
  }
};

// SphereRadiusPolicy_3 with phases: one sphere after the other, and how often it was asked for the next one.
struct My_radius_in_phases
{
  double initial_radius(double) const { return 1.; }

  template <class Energy, class FaceRange>
  double operator()(const Energy&, const FaceRange&, double)
  {
    return 1. + 0.1 * phase;
  }

  bool next_phase()
  {
    ++number_of_calls();
    return ++phase <= 3;
  }

  static int& number_of_calls()
  {
    static int n = 0;
    return n;
  }

  int phase = 0;
};

// SparseLinearAlgebraWithFactorTraits_d, with nothing but dense arrays: the Cholesky factorisation by the book.
class My_solver
{
public:
  using NT = double;

  class Vector
  {
  public:
    explicit Vector(std::size_t n)
      : m_values(n, 0.)
    {}
    double& operator[](std::ptrdiff_t i) { return m_values[static_cast<std::size_t>(i)]; }
    double operator[](std::ptrdiff_t i) const { return m_values[static_cast<std::size_t>(i)]; }

  private:
    std::vector<double> m_values;
  };

  class Matrix
  {
  public:
    explicit Matrix(std::size_t n, bool /* is_symmetric */ = false)
      : m_rows(n, std::vector<double>(n, 0.))
    {}
    Matrix(std::size_t n, std::size_t n_columns, bool /* is_symmetric */ = false)
      : m_rows(n, std::vector<double>(n_columns, 0.))
    {}
    void set_coef(std::size_t i, std::size_t j, double value, bool /* is_new */ = false) { m_rows[i][j] = value; }
    const std::vector<std::vector<double>>& rows() const { return m_rows; }

  private:
    std::vector<std::vector<double>> m_rows;
  };

  bool factor(const Matrix& matrix, double& denominator)
  {
    denominator = 1.;
    m_lower = matrix.rows();
    for(std::size_t i = 0; i < m_lower.size(); ++i)
    {
      for(std::size_t j = 0; j <= i; ++j)
      {
        double sum = m_lower[i][j];
        for(std::size_t k = 0; k < j; ++k)
        {
          sum -= m_lower[i][k] * m_lower[j][k];
        }
        if(i == j && !(sum > 0.))
        {
          return false;
        }
        m_lower[i][j] = i == j ? std::sqrt(sum) : sum / m_lower[j][j];
      }
    }
    return true;
  }

  bool linear_solver(const Vector& right, Vector& solution)
  {
    const auto index = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    const std::size_t n = m_lower.size();
    for(std::size_t i = 0; i < n; ++i)
    {
      double sum = right[index(i)];
      for(std::size_t k = 0; k < i; ++k)
      {
        sum -= m_lower[i][k] * solution[index(k)];
      }
      solution[index(i)] = sum / m_lower[i][i];
    }
    for(std::size_t i = n; i-- > 0;)
    {
      for(std::size_t k = i + 1; k < n; ++k)
      {
        solution[index(i)] -= m_lower[k][i] * solution[index(k)];
      }
      solution[index(i)] /= m_lower[i][i];
    }
    ++number_of_calls();
    return true;
  }

  static int& number_of_calls()
  {
    static int n = 0;
    return n;
  }

private:
  std::vector<std::vector<double>> m_lower;
};

// SphericalParameterizer_3: projects a surface from the origin, which is a bijection if it is star-shaped about it.
struct Radial_projection
{
  template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters>
  SP::Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, const NamedParameters& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const auto vpm = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                      get_const_property_map(CGAL::vertex_point, tmesh));
    ++number_of_calls();
    for(const auto v : vertices(tmesh))
    {
      const auto& p = get(vpm, v);
      const double r = std::hypot(p.x(), p.y(), p.z());
      put(vertex_sphere_map, v, Point_3(p.x() / r, p.y() / r, p.z() / r));
    }
    return SP::OK;
  }

  static int& number_of_calls()
  {
    static int n = 0;
    return n;
  }
};

// SphericalParameterizationVisitor
struct My_visitor
{
  void on_initialization_begin(std::size_t) {}
  void on_level(std::size_t) { ++n_levels; }
  void on_initialization_end() {}
  void after_iteration(std::size_t, double, double) { ++n_iterations; }
  bool go_further(std::size_t, double) { return true; }
  void on_optimization_end() {}

  std::size_t n_levels = 0, n_iterations = 0;
};

const Mesh& mesh()
{
  static const Mesh result = test_meshes::make_mesh<Mesh>(test_meshes::bumpy_sphere(2));
  return result;
}

template <class Parameterizer>
std::vector<Coordinates> images(Parameterizer& parameterizer)
{
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh());
  EXPECT_EQ(SP::parameterize(mesh(), parameterizer, map, CGAL::parameters::number_of_iterations(30u)), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh(), map));
  return test_maps::images(mesh(), map);
}

const std::vector<Coordinates>& default_images()
{
  static const std::vector<Coordinates> result = [] {
    Bld<> bld;
    return images(bld);
  }();
  return result;
}

// The map is certified, and another one than that of the default policies.
template <class Parameterizer>
void expect_map_of_its_own(Parameterizer& parameterizer)
{
  EXPECT_FALSE(test_maps::have_same_bits(images(parameterizer), default_images()));
  EXPECT_TRUE(parameterizer.is_valid());
}

TEST(Concept, default_in_each_place_is_the_default)
{
  const auto expect_default = [](auto&& parameterizer) {
    EXPECT_TRUE(test_maps::have_same_bits(images(parameterizer), default_images()));
  };
  expect_default(Bld<Default, Default, Default, Default, Default>());
  expect_default(
      Bld<SP::Hierarchical_parameterizer_3<Mesh, SP::Symmetric_Dirichlet_energy_3, SP::Relative_sharpness_3>>());
  expect_default(Bld<Default, SP::Symmetric_Dirichlet_energy_3>());
  expect_default(Bld<Default, Default, SP::Relative_sharpness_3>());
  expect_default(Bld<Default, Default, Default, SP::Two_phase_radius_3<>>());
  expect_default(Bld<Default, Default, Default, Default, SP::Newton_update_3>());
  expect_default(Bld<Default, Default, Default, Default, Default, SP::Determinant_barrier_3>());
}

struct My_hierarchical
  : SP::Hierarchical_parameterizer_3<Mesh, SP::Isometric_energy_3, SP::Relative_sharpness_3, SP::Newton_update_3>
{
  My_hierarchical()
    : Hierarchical_parameterizer_3(SP::Isometric_energy_3(0.2), SP::Relative_sharpness_3(3.))
  {}
};

// Whether a type is written out or not makes no difference to what an object of it is made with.
TEST(Concept, default_written_out_is_the_default)
{
  using Isometric = SP::Isometric_energy_3;
  Bld<Default, Isometric> bld(Isometric(0.9));
  Bld<SP::Hierarchical_parameterizer_3<Mesh, Isometric, SP::Relative_sharpness_3>, Isometric> written_out(
      Isometric(0.9));
  EXPECT_TRUE(test_maps::have_same_bits(images(bld), images(written_out)));

  // A class of the caller's makes itself, whatever it is derived from.
  Bld<My_hierarchical, Isometric> from_mine(Isometric(0.9)), from_given(My_hierarchical(), Isometric(0.9));
  EXPECT_TRUE(test_maps::have_same_bits(images(from_mine), images(from_given)));

  SP::Hierarchical_parameterizer_3<Mesh> hierarchical;
  SP::Hierarchical_parameterizer_3<Mesh, Isometric, SP::Relative_sharpness_3, SP::Newton_update_3> all_written_out;
  EXPECT_TRUE(test_maps::have_same_bits(images(hierarchical), images(all_written_out)));
}

TEST(Concept, distortion_energy)
{
  Bld<Default, My_energy> bld(My_energy(0.1), SP::Relative_sharpness_3());
  expect_map_of_its_own(bld);
  Bld<Default, My_energy> average(My_energy(0.1), SP::Relative_sharpness_3(0.));
  expect_map_of_its_own(average);
  EXPECT_LT(average.report().average_energy, average.report().initial_energy);
  EXPECT_LT(average.report().average_energy, bld.report().average_energy);
  EXPECT_LT(bld.report().largest_energy, average.report().largest_energy);
  // by Optimal_radius_3, which has to find the best radius for itself
  Bld<Default, My_energy, Default, SP::Optimal_radius_3> optimal(My_energy(0.1), SP::Relative_sharpness_3(),
                                                                 SP::Optimal_radius_3());
  expect_map_of_its_own(optimal);
  Bld<Default, My_energy> heavy(My_energy(10.), SP::Relative_sharpness_3());
  EXPECT_FALSE(test_maps::have_same_bits(images(heavy), images(bld)));
}

TEST(Concept, distortion_energy_of_a_hierarchy)
{
  SP::Hierarchical_parameterizer_3<Mesh, My_energy, My_sharpness, My_update> parameterizer{My_energy(0.5)};
  expect_map_of_its_own(parameterizer);
  EXPECT_GT(parameterizer.report().number_of_level_iterations, 0u);
}

TEST(Concept, sharpness_policy)
{
  Bld<Default, Default, My_sharpness> bld;
  expect_map_of_its_own(bld);
  EXPECT_EQ(bld.report().number_of_average_iterations, 1u); // that of sharpness 0
  EXPECT_EQ(bld.report().sharpness, 0.5);
  EXPECT_GT(bld.report().number_of_sharp_iterations, 10u); // it is not final before
}

TEST(Concept, sphere_radius_policy)
{
  Bld<Default, Default, Default, My_radius> bld;
  expect_map_of_its_own(bld);
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh());
  const auto distortion = get(CGAL::dynamic_face_property_t<SP::Face_distortion>(), mesh());
  ASSERT_EQ(SP::parameterize(mesh(), bld, map), SP::OK);
  SP::measure_distortion(mesh(), map, distortion);
  // The areas of all faces by hand: the policy makes the average of their ratios 1.
  double sum = 0.;
  const auto area = [](const Point_3& a, const Point_3& b, const Point_3& c) {
    return std::sqrt(CGAL::to_double(CGAL::squared_area(a, b, c)));
  };
  for(const auto f : faces(mesh()))
  {
    const auto h = halfedge(f, mesh());
    const auto a = source(h, mesh()), b = target(h, mesh()), c = target(next(h, mesh()), mesh());
    sum += area(get(map, a), get(map, b), get(map, c)) / area(mesh().point(a), mesh().point(b), mesh().point(c));
  }
  EXPECT_NEAR(sum / static_cast<double>(num_faces(mesh())), 1., 1e-12);
}

TEST(Concept, sphere_radius_policy_with_phases)
{
  Bld<Default, Default, Default, My_radius_in_phases> bld;
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh());
  My_radius_in_phases::number_of_calls() = 0;
  ASSERT_EQ(SP::parameterize(mesh(), bld, map, CGAL::parameters::number_of_iterations(1000u)), SP::OK);
  // The run goes on as long as there is a next phase; then the last radius is asked for.
  EXPECT_EQ(bld.report().stop_reason, SP::CONVERGED);
  EXPECT_EQ(My_radius_in_phases::number_of_calls(), 4); // the last one returns false
  EXPECT_EQ(bld.report().radius, 1.4);
  ASSERT_EQ(SP::parameterize(mesh(), bld, map, CGAL::parameters::number_of_iterations(2u)), SP::OK);
  // A run that was ended early skips the phases that are left.
  EXPECT_EQ(My_radius_in_phases::number_of_calls(), 8);
  EXPECT_EQ(bld.report().radius, 1.4);
}

TEST(Concept, sparse_linear_algebra_traits)
{
  const auto expect_same_map = [&](auto&& by_my_solver, auto&& by_default) {
    My_solver::number_of_calls() = 0;
    const std::vector<Coordinates> mine = images(by_my_solver);
    EXPECT_GT(My_solver::number_of_calls(), 3);
    EXPECT_LT(test_maps::largest_distance(mine, images(by_default)), 1e-8);
  };
  expect_same_map(SP::Stereographic_parameterizer_3<Mesh, My_solver>(), SP::Stereographic_parameterizer_3<Mesh>());
  expect_same_map(SP::Harmonic_parameterizer_3<Mesh, My_solver>(), SP::Harmonic_parameterizer_3<Mesh>());
  expect_same_map(SP::ARAP_parameterizer_3<Mesh, Radial_projection, My_solver>(),
                  SP::ARAP_parameterizer_3<Mesh, Radial_projection>());
}

TEST(Concept, vertex_update)
{
  Bld<Default, Default, Default, Default, My_update> bld;
  expect_map_of_its_own(bld);
  EXPECT_LT(bld.report().largest_energy, 20.);
  EXPECT_LT(bld.report().average_energy, bld.report().initial_energy);
}

TEST(Concept, spherical_parameterizer)
{
  const int n_calls = Radial_projection::number_of_calls();
  Bld<Radial_projection> bld;
  expect_map_of_its_own(bld);
  EXPECT_EQ(Radial_projection::number_of_calls(), n_calls + 1);
  EXPECT_EQ(bld.report().number_of_levels, 0u); // no hierarchy
  EXPECT_LT(bld.report().largest_energy, 20.);
  EXPECT_LT(bld.report().average_energy, bld.report().initial_energy);
  // from an object of its own, and alone
  const Radial_projection projection;
  Bld<Radial_projection> from_object(projection);
  expect_map_of_its_own(from_object);

  // Without any sweep, the projection itself is what comes out.
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh());
  ASSERT_EQ(SP::parameterize(mesh(), bld, map, CGAL::parameters::number_of_iterations(0u)), SP::OK);
  for(const auto v : vertices(mesh()))
  {
    const Point_3 &p = mesh().point(v), &u = get(map, v);
    const Coordinates direction = test_meshes::normalized({p.x(), p.y(), p.z()});
    const double r = bld.report().radius;
    EXPECT_LT(test_maps::distance({u.x() / r, u.y() / r, u.z() / r}, direction), 1e-15);
  }
}

TEST(Concept, spherical_parameterizer_gets_the_points_given)
{
  const Mesh other = test_meshes::make_mesh<Mesh>(test_meshes::icosphere(2)); // the same connectivity
  const auto points = test_meshes::make_vertex_map<Point_3>(other, test_meshes::bumpy_sphere(2).points);
  const auto map = test_maps::make_sentinel_map<Point_3>(other);
  Bld<Radial_projection> bld;
  ASSERT_EQ(SP::parameterize(other, bld, map, CGAL::parameters::vertex_point_map(points).number_of_iterations(30u)),
            SP::OK);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(other, map), images(bld)));
}

TEST(Concept, spherical_parameterizer_is_checked)
{
  // Moved off the origin, the surface is not star-shaped about it, and the projection folds.
  Triangle_list list = test_meshes::bumpy_sphere(2);
  for(Coordinates& p : list.points)
  {
    p[0] += 3.;
  }
  const Mesh moved = test_meshes::make_mesh<Mesh>(list);
  const auto map = test_maps::make_sentinel_map<Point_3>(moved);
  const std::vector<Coordinates> before = test_maps::images(moved, map);
  Bld<Radial_projection> bld;
  EXPECT_EQ(SP::parameterize(moved, bld, map), SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(moved, map), before));
}

// A parameterizer that gives up: its word is passed on.
struct Giving_up
{
  template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters>
  SP::Error_code parameterize(const TriangleMesh&, VertexSphereMap, const NamedParameters&)
  {
    return code;
  }

  SP::Error_code code = SP::ERROR_INSUFFICIENT_PRECISION;
};

TEST(Concept, spherical_parameterizer_may_fail)
{
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh());
  const std::vector<Coordinates> before = test_maps::images(mesh(), map);
  Bld<Giving_up> bld;
  EXPECT_EQ(SP::parameterize(mesh(), bld, map), SP::ERROR_INSUFFICIENT_PRECISION);
  // A map that folds is nothing to start from; the caller's own map has not been written then.
  Bld<Giving_up> from_folds(Giving_up{SP::ERROR_NO_1_TO_1_MAPPING});
  EXPECT_EQ(SP::parameterize(mesh(), from_folds, map), SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
  EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh(), map), before));
}

// Whatever is a parameterizer can start another one.
TEST(Concept, spherical_parameterizer_of_the_package_starts_another)
{
  // A map from a run that was stopped, carried on, is as good as one in one go.
  Bld<> short_run;
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh());
  ASSERT_EQ(SP::parameterize(mesh(), short_run, map, CGAL::parameters::number_of_iterations(3u)), SP::OK);
  using Precomputed = SP::Precomputed_parameterizer_3<Mesh, decltype(map)>;
  Bld<std::remove_const_t<Precomputed>> rest{Precomputed(map)};
  ASSERT_EQ(SP::parameterize(mesh(), rest, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh(), map));
  EXPECT_NEAR(rest.report().initial_energy, short_run.report().average_energy, 1e-2);
  Bld<> one_go;
  ASSERT_EQ(SP::parameterize(mesh(), one_go, map), SP::OK);
  EXPECT_NEAR(rest.report().largest_energy / one_go.report().largest_energy, 1., 0.02);

  Bld<Bld<>> twice;
  expect_map_of_its_own(twice);
  EXPECT_NEAR(twice.report().initial_energy / one_go.report().average_energy, 1., 1e-2);
  EXPECT_LT(twice.report().largest_energy, one_go.report().largest_energy * 1.01);
}

TEST(Concept, visitor)
{
  My_visitor visitor;
  Bld<> bld;
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh());
  ASSERT_EQ(SP::parameterize(mesh(), bld, map, CGAL::parameters::visitor(std::ref(visitor)).number_of_iterations(30u)),
            SP::OK);
  EXPECT_EQ(visitor.n_levels, bld.report().number_of_levels);
  EXPECT_EQ(visitor.n_iterations, bld.report().number_of_iterations());
}

TEST(Concept, all_at_once)
{
  Bld<Radial_projection, My_energy, My_sharpness, My_radius, My_update> bld(Radial_projection(), My_energy(0.3));
  expect_map_of_its_own(bld);
  EXPECT_LT(bld.report().average_energy, bld.report().initial_energy);
}

} // namespace
