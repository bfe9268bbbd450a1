// What the maps that BLD is compared with are made of: Moebius transformations, the linear system, the harmonic energy and
// its minimisation, the way through the plane, and the energy of maps that are as rigid as possible.

#include <CGAL/Spherical_parameterization/internal/initializers/Laplacian_system.h>
#include <CGAL/Spherical_parameterization/internal/initializers/ARAP_map.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Harmonic_map.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Stereographic_embedding.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include "indexed_meshes.h"
#include "random_meshes.h"
#include "recording_control.h"

using namespace test;

namespace {

using namespace SP::internal; // whose arithmetic of vectors these files use
using SP::internal::cross;
using SP::internal::dot;
using SP::internal::normalized;

using Solver = SP::internal::Solver_traits<CGAL::Default>::type;

constexpr double any_weight = std::numeric_limits<double>::lowest();

TEST(Moebius_transformation, maps_the_sphere_to_itself_conformally)
{
  Random random(3);
  for(int k = 0; k < 300; ++k)
  {
    const Vector_3d c = random.between(0., 0.9) * random.direction(), u = random.direction();
    const Moebius_transformation transformation{c};
    const Vector_3d image = transformation(u);
    EXPECT_NEAR(length(image), 1., 1e-15);

    // Two orthogonal tangents go to two that are orthogonal, equally long and oriented alike.
    const Tangent_frame frame(u);
    const double h = 1e-5;
    const auto derivative = [&](double x, double y) {
      return (0.5 / h) * (transformation(frame.point_at(x, y)) - transformation(frame.point_at(-x, -y)));
    };
    const Vector_3d dx = derivative(h, 0.), dy = derivative(0., h);
    const double factor = length(dx);
    EXPECT_NEAR(length(dy) / factor, 1., 1e-6);
    EXPECT_NEAR(dot(dx, dy) / (factor * factor), 0., 1e-6);
    EXPECT_NEAR(dot(cross(dx, dy), image) / (factor * factor), 1., 1e-6);
  }
}

TEST(Moebius_transformation, pushes_towards_a_point)
{
  Random random(4);
  for(int k = 0; k < 100; ++k)
  {
    const Vector_3d direction = random.direction(), u = random.direction();
    const Vector_3d c = random.between(0.1, 0.9) * direction;
    const Moebius_transformation there{c}, back{{-c[0], -c[1], -c[2]}}, nothing{{0., 0., 0.}};
    EXPECT_LT(length(nothing(u) - u), 1e-15);
    EXPECT_LT(length(back(there(u)) - u), 1e-13);
    EXPECT_LT(length(there(direction) - direction), 1e-14);
    EXPECT_LT(length(there(-1. * direction) + direction), 1e-13);
    EXPECT_GT(dot(there(u), direction), dot(u, direction));
    // along the circle through the three points: in the plane of u and the direction
    EXPECT_NEAR(dot(there(u), normalized(cross(u, direction))), 0., 1e-13);
    // a weak push moves u by twice its tangential part
    const Vector_3d weak = Moebius_transformation{1e-6 * direction}(u)-u;
    EXPECT_LT(length(weak - 2e-6 * (direction - dot(u, direction) * u)), 1e-11);
  }
}

// Few points, far off, with masses that differ by orders of magnitude, one of them nearly half of all: where Newton's
// method alone would go astray.
TEST(Center_mass, brings_the_center_of_uneven_masses_to_the_origin)
{
  Random random(6);
  for(int k = 0; k < 3000; ++k)
  {
    const Moebius_transformation push{0.999 * random.direction()};
    std::vector<Vector_3d> points, others;
    std::vector<double> masses;
    const std::size_t n = 5 + random.below(10);
    while(points.size() < n)
    {
      others.push_back(random.direction());
      points.push_back(push(others.back()));
      masses.push_back(std::exp(random.between(-8., 0.)));
    }
    if(k % 2 == 0)
      masses[0] = 0.98 * std::accumulate(masses.begin() + 1, masses.end(), 0.);
    if(*std::max_element(masses.begin(), masses.end()) > 0.4999 * std::accumulate(masses.begin(), masses.end(), 0.))
      continue;
    double last = length(center_of_mass(points, masses));
    const auto is_nearer = [&](const std::vector<Vector_3d>& p) {
      const double distance = length(center_of_mass(p, masses));
      EXPECT_LT(distance, last);
      last = distance;
      return true;
    };
    const double distance = center_mass(points, masses, is_nearer);
    EXPECT_LT(distance, 1e-8);
    EXPECT_EQ(distance, length(center_of_mass(points, masses)));
    // There is only one such transformation, up to a rotation, wherever it starts.
    EXPECT_LT(center_mass(others, masses, [](const auto&) { return true; }), 1e-8);
    for(std::size_t v = 0; v < n; ++v)
    {
      EXPECT_NEAR(length(points[v]), 1., 1e-15);
      EXPECT_NEAR(length(points[v] - points[0]), length(others[v] - others[0]), 1e-3);
    }
  }
}

TEST(Center_mass, goes_no_further_than_allowed)
{
  Random random(7);
  std::vector<Vector_3d> start;
  while(start.size() < 100)
    start.push_back(Moebius_transformation{{0.5, 0.3, 0.2}}(random.direction()));
  const std::vector<double> masses(start.size(), 1.);
  const double start_distance = length(center_of_mass(start, masses));
  std::vector<Vector_3d> points = start;
  EXPECT_EQ(center_mass(points, masses, [](const auto&) { return false; }), start_distance);
  EXPECT_EQ(points, start);

  // half of the way is allowed: it gets close to there, and every state was asked for
  std::set<std::vector<Vector_3d>> allowed;
  const double distance = center_mass(points, masses, [&](const std::vector<Vector_3d>& p) {
    const bool is_allowed = length(center_of_mass(p, masses)) > 0.5 * start_distance;
    if(is_allowed)
      allowed.insert(p);
    return is_allowed;
  });
  EXPECT_GT(distance, 0.5 * start_distance);
  EXPECT_LT(distance, 0.52 * start_distance);
  EXPECT_EQ(allowed.count(points), 1u);
}

// the Laplacian of a vertex
Vector_3d laplacian(const Vertex_rings& rings, const std::vector<double>& weights, const std::vector<Vector_3d>& x,
                    std::size_t v)
{
  Vector_3d sum = {0., 0., 0.};
  for(std::size_t j = 0; j < rings.degree(v); ++j)
    sum = sum + weights[rings.offset(v) + j] * (x[v] - x[rings.ring(v)[j]]);
  return sum;
}

TEST(Laplacian_system, is_solved)
{
  Random random(8);
  const Surface mesh = surface_of(bumpy_sphere(3));
  const std::size_t n = mesh.number_of_vertices();
  const std::vector<double> weights = cotangent_weights(mesh.rings(), mesh.points(), min_positive_weight);
  const auto each_tenth = [](std::uint32_t v) { return v % 10 == 3; };
  Laplacian_system<Solver> system; // one object for all, factored anew
  const auto expect_solved = [&](const auto& is_fixed) {
    ASSERT_TRUE(system.factor(mesh.rings(), weights, is_fixed));
    for(int k = 0; k < 3; ++k) // several right-hand sides
    {
      std::vector<Vector_3d> right(n), x;
      for(Vector_3d& b : right)
        b = random.between(0., 10.) * random.direction();
      x = right;
      ASSERT_TRUE(system.solve(x));
      for(std::uint32_t v = 0; v < n; ++v)
      {
        const Vector_3d left = is_fixed(v) ? x[v] : laplacian(mesh.rings(), weights, x, v);
        EXPECT_LT(length(left - (is_fixed(v) ? Vector_3d{} : right[v])), 1e-9);
      }
    }
  };
  expect_solved(each_tenth);
  expect_solved([](std::uint32_t v) { return v == 0; });
}

TEST(Laplacian_system, says_that_it_cannot_be_solved)
{
  const Surface mesh = surface_of(icosphere(1));
  Laplacian_system<Solver> system;
  for(const double weight : {0., 1.})
    EXPECT_EQ(system.factor(mesh.rings(), std::vector<double>(mesh.rings().number_of_corners(), weight),
                            [](std::uint32_t v) { return v == 0; }),
              weight > 0.);
}

TEST(Dirichlet_energy, is_the_sum_over_the_edges)
{
  Random random(9);
  const Triangle_list list = icosphere(2);
  const Surface mesh = surface_of(scaled(list, 1., 1.5, 2.));
  const std::vector<Vector_3d> u = mesh.in_own_order(list.points);
  const Vertex_rings& rings = mesh.rings();
  const std::vector<double> weights = cotangent_weights(rings, mesh.points(), any_weight);
  std::vector<double> shares(u.size());
  const double energy = dirichlet_energy(rings, weights, u, shares, Execution());
  double sum = 0., sum_of_shares = 0.;
  for(std::uint32_t v = 0; v < u.size(); ++v)
  {
    for(std::size_t j = 0; j < rings.degree(v); ++j)
    {
      const std::uint32_t w = rings.ring(v)[j];
      sum += v < w ? 0.5 * weights[rings.offset(v) + j] * squared_length(u[v] - u[w]) : 0.;
    }
    EXPECT_NEAR(shares[v], 0.5 * dot(laplacian(rings, weights, u, v), u[v]), 1e-12);
    sum_of_shares += shares[v];
  }
  EXPECT_NEAR(4. * pi * energy, sum, 1e-11);
  EXPECT_NEAR(sum_of_shares, sum, 1e-11);
}

// How far the Laplacian is from being normal to the sphere, as a part of all of it. What a multiplier of the condition
// on the center explains does not count: a vector for all vertices, in proportion to their shares in the energy.
double tangential_part(const Vertex_rings& rings, const std::vector<double>& weights, const std::vector<Vector_3d>& u)
{
  std::vector<Vector_3d> tangential;
  std::vector<double> shares;
  Vector_3d sum = {0., 0., 0.};
  double all = 0., unexplained = 0.;
  for(std::size_t v = 0; v < u.size(); ++v)
  {
    const Vector_3d l = laplacian(rings, weights, u, v);
    shares.push_back(0.5 * dot(l, u[v]));
    tangential.push_back(l - dot(l, u[v]) * u[v]);
    sum = sum + tangential[v];
    all += length(l);
  }
  const Vector_3d multiplier = SP::internal::solve_tangential(u, shares, sum);
  for(std::size_t v = 0; v < u.size(); ++v)
    unexplained += length(tangential[v] - shares[v] * (multiplier - dot(multiplier, u[v]) * u[v]));
  return unexplained / all;
}

TEST(Harmonic_map, is_a_critical_point_of_the_energy)
{
  std::array<double, 2> last_end = {1., 1.};
  for(const unsigned int subdivisions : {2u, 3u, 4u})
  {
    const Surface mesh = surface_of(bumpy_sphere(subdivisions));
    for(const bool is_guarded : {true, false})
    {
      SCOPED_TRACE(is_guarded);
      const std::vector<double> weights =
          cotangent_weights(mesh.rings(), mesh.points(), is_guarded ? min_positive_weight : any_weight);
      Stereographic_embedding<Solver> embedding(mesh);
      std::vector<Vector_3d> u;
      ASSERT_TRUE(embedding.solve());
      ASSERT_TRUE(embedding.project(u));
      const double start = tangential_part(mesh.rings(), weights, u);
      std::vector<double> shares(u.size());
      const double start_energy = dirichlet_energy(mesh.rings(), weights, u, shares, Execution());

      Recording_control control;
      SP::internal::Run run(control, Execution());
      run.surface = mesh;
      run.positions = u;
      run.radius = 0.;
      ASSERT_EQ(SP::internal::lower_energy<Solver>(Harmonic_map(mesh, is_guarded, Execution()), 100, run), SP::OK);
      u = run.positions;
      const SP::Parameterization_report& report = control.report();
      EXPECT_EQ(run.radius, 1.);
      EXPECT_EQ(report.stop_reason, SP::CONVERGED);
      EXPECT_EQ(report.initial_energy, start_energy);
      EXPECT_EQ(report.average_energy, dirichlet_energy(mesh.rings(), weights, u, shares, Execution()));
      ASSERT_FALSE(control.energies.empty());
      EXPECT_EQ(report.average_energy, control.energies.back());
      EXPECT_EQ(report.number_of_average_iterations, control.energies.size());
      EXPECT_LT(report.average_energy, start_energy);
      double lowest = start_energy;
      for(const double e : control.energies)
      {
        EXPECT_LT(e, (1. + 1e-4) * lowest); // a centring transformation may cost a little
        lowest = (std::min)(lowest, e);
      }
      EXPECT_LT(length(center_of_mass(u, vertex_masses(mesh.rings(), mesh.points()))), 1e-8);
      const double end = tangential_part(mesh.rings(), weights, u);
      EXPECT_LT(end, 0.01 * start);
      EXPECT_LT(end, 2e-3);
      EXPECT_LT(end, (is_guarded ? 1. : 0.4) * last_end[is_guarded ? 1 : 0]); // the more exact, the finer the mesh
      last_end[is_guarded ? 1 : 0] = end;
    }
  }
}

TEST(Central_vertex, is_as_near_to_all_as_any)
{
  for(const Triangle_list& list : {with_tentacle(40, 4.), icosphere(3), suspension(12), tetrahedron()})
  {
    const Surface mesh = surface_of(list);
    const Vertex_rings& rings = mesh.rings();
    std::vector<std::uint32_t> eccentricities;
    for(std::uint32_t source = 0; source < rings.number_of_vertices(); ++source)
    {
      const std::vector<std::uint32_t> distance = SP::internal::edge_distances(rings, source);
      for(std::uint32_t v = 0; v < rings.number_of_vertices(); ++v)
      {
        std::uint32_t nearest = distance[rings.ring(v)[0]];
        for(const std::uint32_t w : rings.ring(v))
          nearest = (std::min)(nearest, distance[w]);
        ASSERT_EQ(distance[v], v == source ? 0 : nearest + 1);
      }
      eccentricities.push_back(*std::max_element(distance.begin(), distance.end()));
    }
    const auto [least, largest] = std::minmax_element(eccentricities.begin(), eccentricities.end());
    const std::uint32_t central = eccentricities[SP::internal::central_vertex(rings)];
    EXPECT_LE(central, 1.15 * *least);
    EXPECT_TRUE(central < *largest || *least == *largest);
  }
}

TEST(Stereographic_embedding, is_positive_and_centred)
{
  std::vector<Triangle_list> lists = {tetrahedron(),   octahedron(),    icosphere(0),         icosphere(3),
                                      bumpy_sphere(1), bumpy_sphere(3), with_tentacle(20, 1.)};
  for(const std::size_t n : {3u, 4u, 5u, 6u, 7u, 10u, 20u, 50u})
  {
    lists.push_back(suspension(n));
    lists.push_back(scaled(suspension(n), 1., 1., 0.05));
    lists.push_back(scaled(suspension(n), 1., 0.2, 5.));
  }
  for(const Triangle_list& list : lists)
  {
    const Surface mesh = surface_of(list);
    Stereographic_embedding<Solver> embedding(mesh);
    std::vector<Vector_3d> u;
    ASSERT_TRUE(embedding.solve());
    EXPECT_TRUE(embedding.project(u));
    EXPECT_TRUE(SP::internal::are_safely_positive(mesh.rings(), u));
    EXPECT_LT(length(center_of_mass(u, vertex_masses(mesh.rings(), mesh.points()))), 1e-8);
    for(const Vector_3d& p : u)
      EXPECT_NEAR(length(p), 1., 1e-15);
  }
}

// The energy of the map u on the sphere of radius r by its singular values: their squares add up to I and their
// product, negative for a face that is turned over, is d, so their sum is the root of I + 2 d.
double energy_of(const Surface& mesh, const std::vector<Vector_3d>& u, double r)
{
  double sum = 0.;
  mesh.rings().for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::vector<Vector_3d>& p = mesh.points();
    const Vector_3d e = p[b] - p[a], f = p[c] - p[a], g = u[b] - u[a], h = u[c] - u[a], n = cross(g, h);
    const double area = length(cross(e, f));
    const double i =
        r * r *
        (squared_length(f) * squared_length(g) - 2. * dot(e, f) * dot(g, h) + squared_length(e) * squared_length(h)) /
        (area * area);
    const double d = (dot(n, u[a] + u[b] + u[c]) < 0. ? -1. : 1.) * r * r * length(n) / area;
    sum += 0.25 * area * (i - 2. * std::sqrt((std::max)(i + 2. * d, 0.)) + 2.);
  });
  return sum / (4. * pi);
}

// A map of the bumpy sphere, with faces turned over if `scatter` is large.
struct Scattered_map
{
  explicit Scattered_map(double scatter)
    : list(bumpy_sphere(2))
    , mesh(test::surface_of(list))
    , u(mesh.in_own_order(icosphere(2).points))
  {
    Random random(1);
    for(Vector_3d& p : u)
      p = normalized(p + scatter * random.in_cube());
  }

  std::size_t number_of_inverted_faces() const
  {
    std::size_t n = 0;
    mesh.rings().for_each_face(
        [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { n += dot(u[a], cross(u[b], u[c])) < 0.; });
    return n;
  }

  Triangle_list list;
  Surface mesh;
  std::vector<Vector_3d> u;
};

TEST(ARAP_energy, is_that_of_the_singular_values_at_the_best_radius)
{
  for(const double scatter : {0., 0.05, 0.3})
  {
    const Scattered_map map(scatter);
    EXPECT_EQ(map.number_of_inverted_faces() > 0, scatter > 0.1);
    ARAP_energy energy(map.mesh.rings(), map.mesh.points(), Execution());
    const double value = energy.fit(map.u), radius = energy.radius();
    EXPECT_NEAR(value, energy_of(map.mesh, map.u, radius), 1e-12);
    // The rotations do not depend on the radius, so the energy is a parabola in it.
    const double below = energy_of(map.mesh, map.u, 0.99 * radius), above = energy_of(map.mesh, map.u, 1.01 * radius);
    EXPECT_GT(below, value);
    EXPECT_GT(above, value);
    EXPECT_NEAR(above, below, 1e-12);
  }
}

TEST(ARAP_energy, of_an_isometry_is_0)
{
  for(const double scale : {1., 7.})
  {
    const Triangle_list sphere = icosphere(2), list = test_meshes::scaled(sphere, scale, scale, scale);
    const Surface mesh = surface_of(list);
    ARAP_energy energy(mesh.rings(), mesh.points(), Execution());
    EXPECT_NEAR(energy.fit(mesh.in_own_order(sphere.points)), 0., 1e-14);
    EXPECT_NEAR(energy.radius() * mesh.equal_area_radius(), scale, 1e-14 * scale);
    // the mirror image is none
    const std::vector<Coordinates> mirrored = test_meshes::scaled(sphere, 1., 1., -1.).points;
    EXPECT_GT(energy.fit(mesh.in_own_order(mirrored)), 0.1);
  }
}

TEST(ARAP_energy, has_the_gradient_of_its_value)
{
  for(const double scatter : {0.05, 0.3})
  {
    Scattered_map map(scatter);
    ARAP_energy energy(map.mesh.rings(), map.mesh.points(), Execution());
    energy.fit(map.u);
    const double radius = energy.radius();
    std::vector<Vector_3d> forces(map.u.size());
    energy.forces(map.u, forces);
    Vector_3d sum = {0., 0., 0.};
    for(std::size_t v = 0; v < map.u.size(); ++v)
    {
      sum = sum + forces[v];
      const double h = 1e-6;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Vector_3d u = map.u[v];
        map.u[v][i] = u[i] + h;
        const double above = energy.fit(map.u); // with the best radius, which makes no difference to first order
        map.u[v][i] = u[i] - h;
        const double below = energy.fit(map.u);
        map.u[v] = u;
        EXPECT_NEAR(-radius * forces[v][i] / (4. * pi), (above - below) / (2. * h), 1e-7 * (1. + length(forces[v])));
      }
    }
    EXPECT_LT(length(sum), 1e-12); // moving all points together changes nothing
  }
}

} // namespace
