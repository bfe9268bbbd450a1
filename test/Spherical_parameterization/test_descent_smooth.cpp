// Smooth steps: the sums that they are made of against brute force, what one of them gains, and when they are made.

#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/descent/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Objective.h>
#include <CGAL/Spherical_parameterization/internal/descent/Smooth_step.h>
#include <CGAL/Spherical_parameterization/internal/descent/Sphere_cells.h>
#include <CGAL/Spherical_parameterization/internal/descent/Strain_sums.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include "engine.h"
#include "indexed_meshes.h"
#include "random_meshes.h"

using namespace test;

namespace {

using SP::Sharpness;
using namespace SP::internal;

TEST(Sphere_cells, interpolates_between_its_nodes)
{
  Random random(2);
  for(const std::size_t n : {2u, 3u, 8u})
  {
    const Sphere_cells grid(n);
    ASSERT_EQ(grid.frames().size(), 6 * n * n + 2);
    Images nodes;
    for(const auto& frame : grid.frames())
      nodes.push_back(frame.point_at(0., 0.));
    for(int k = 0; k < 200; ++k)
    {
      const Coordinates p = normalized(random.in_cube());
      const Sphere_cells::Cell& cell = grid.cells()[grid.cells_at(p)[0]];
      ASSERT_FALSE(cell.is_empty());
      // The direction is a positive combination of the corners of its cell, as the step at it is one of theirs.
      const Coordinates &a = nodes[cell.nodes[0]], &b = nodes[cell.nodes[1]], &c = nodes[cell.nodes[2]];
      const double volume = dot(a, cross(b, c));
      EXPECT_GE(dot(p, cross(b, c)) / volume, -1e-12);
      EXPECT_GE(dot(a, cross(p, c)) / volume, -1e-12);
      EXPECT_GE(dot(a, cross(b, p)) / volume, -1e-12);
      EXPECT_LT(distance(grid.step_at(p, nodes), p), 1.3 / static_cast<double>(n * n)); // of the sphere from its chord
    }
    for(const Coordinates& node : nodes)
      EXPECT_LT(distance(grid.step_at(node, nodes), node), 1e-12);
  }
}

// A surface, its map to the unit sphere, and a descent over it.
template <class Energy>
struct Mapped_surface
{
  using Space = Round_sphere<Energy, Newton_step>;

  Mapped_surface(const Triangle_list& list, const Images& images, const Energy& energy)
    : mesh(surface_of(list))
    , positions(mesh.in_own_order(images))
    , space(Face_energy<Energy>(energy))
    , descent(space, Newton_step(), Execution())
  {
    descent.assign(mesh.rings(), SP::internal::Independent_sets(mesh.rings()), mesh.points(), {},
                   SP::internal::Rest_limits());
  }

  const Surface mesh;
  const Images positions;
  const Space space;
  Block_coordinate_descent<Space, Newton_step> descent;
};

using Matrix = std::array<double, 4>;

template <class Energy>
void expect_sums_of_faces(const Energy& energy, double beta)
{
  const Triangle_list list = bumpy_sphere(3);
  Images images = directions_of(list.points);
  for(Coordinates& p : images) // no face has its center between two cells
    p = normalized(combination(1., p, 1., {0.05, 0.07, -0.03}));
  Mapped_surface<Energy> map(list, images, energy);
  const auto& positions = map.positions; // no decomposition, whose names lambdas cannot use in Clang
  const auto& space = map.space;
  auto& descent = map.descent;
  using Space = typename Mapped_surface<Energy>::Space;
  Objective objective(Sharpness::relative(beta), true);
  objective.start_sweep(0, descent.measure(positions, 1.1, objective.of_faces()));
  const Face_objective& of_faces = objective.of_faces();

  const Sphere_cells grid(3);
  Strain_sums<Space> sums(space);
  sums.sum_up(grid, descent.measured_faces(), descent.stars(), positions, 1.1, of_faces, Execution());

  const auto& points = map.mesh.points();
  std::vector<std::vector<Index_triangle>> faces(grid.cells().size());
  map.mesh.rings().for_each_face([&](std::uint32_t u, std::uint32_t v, std::uint32_t w) {
    const Coordinates center = combination(1., combination(1., positions[u], 1., positions[v]), 1., positions[w]);
    faces[grid.cells_at(center)[0]].push_back({u, v, w});
  });
  // the part of the objective that a cell has, for A, R and the radius
  const auto value = [&](std::size_t cell, const Matrix& a, double level, double radius) {
    double result = 0.;
    const double b = beta + 1., s = b / level, share = of_faces.share;
    for(const auto& [u, v, w] : faces[cell])
    {
      const std::array<Coordinates, 3> p = {positions[u], positions[v], positions[w]};
      const Rest_triangle rest = Rest_triangle::from_points(points[u], points[v], points[w]);
      const auto invariants = space.template invariants<double>(
          p, {rest.opposite_0, rest.opposite_1, rest.opposite_2}, rest.inverse_doubled_area,
          1. / rest.inverse_doubled_area, radius * radius, of_faces);
      const Coordinates &x = grid.cells()[cell].x, &y = grid.cells()[cell].y;
      const auto length_in_plane = [&](const Coordinates& from, const Coordinates& to, const Matrix& m) {
        const Coordinates e = combination(1., to, -1., from);
        const double ex = dot(e, x), ey = dot(e, y);
        return std::pow(m[0] * ex + m[1] * ey, 2) + std::pow(m[2] * ex + m[3] * ey, 2);
      };
      const auto i_of = [&](const Matrix& m) {
        return rest.opposite_0 * length_in_plane(p[1], p[2], m) + rest.opposite_1 * length_in_plane(p[2], p[0], m) +
               rest.opposite_2 * length_in_plane(p[0], p[1], m);
      };
      const double i = invariants[0] * i_of(a) / i_of({1., 0., 0., 1.}),
                   d = invariants[1] * (a[0] * a[3] - a[1] * a[2]);
      const double e = energy(i, d);
      const double psi =
          beta > 0. ? (1. - share) * e + share * ((1. - 1. / b) * level + std::exp(s * (e - level)) / s) : e;
      const double area = 0.5 / rest.inverse_doubled_area;
      result += (SP::internal::weighs_faces_by_area<Energy> ? 2. * area : 1.) * psi;
    }
    return result;
  };
  const double level = beta > 0. ? of_faces.level : 1.;
  using Variables = std::array<double, 6>; // A, R and the logarithm of the radius
  const auto at = [&](std::size_t cell, const Variables& x) {
    return value(cell, {x[0], x[1], x[2], x[3]}, x[4], std::exp(x[5]));
  };
  const Variables here = {1., 0., 0., 1., level, std::log(1.1)};
  int n_cells = 0;
  std::array<double, 5> shared = {};
  for(std::size_t cell = 0; cell < grid.cells().size(); ++cell)
  {
    const double size = at(cell, here);
    if(grid.cells()[cell].is_empty() || size == 0.)
      continue;
    ++n_cells;
    const auto difference = [&](std::size_t k, std::size_t l) { // of second order
      const double h = 1e-4;
      double sum = 0.;
      for(const double u : {-1., 1.})
        for(const double v : {-1., 1.})
        {
          Variables x = here;
          x[k] += u * h;
          x[l] += v * h;
          sum += u * v * at(cell, x);
        }
      return sum / (4. * h * h);
    };
    const auto slope = [&](std::size_t k) {
      const double h = 1e-5;
      Variables up = here, down = here;
      up[k] += h;
      down[k] -= h;
      return (at(cell, up) - at(cell, down)) / (2. * h);
    };
    const auto gradient = sums.gradient(cell), in_level = sums.gradient_in_level(cell),
               in_radius = sums.gradient_in_radius(cell);
    const auto hessian = sums.hessian(cell);
    double scale = 0.;
    for(std::size_t k = 0; k < 4; ++k)
      scale += std::abs(hessian[k][k]);
    for(std::size_t k = 0; k < 4; ++k)
    {
      EXPECT_NEAR(gradient[k], slope(k), 1e-6 * scale);
      for(std::size_t l = 0; l < 4; ++l)
        EXPECT_NEAR(hessian[k][l], difference(k, l), 1e-4 * scale) << k << ' ' << l;
      EXPECT_NEAR(in_level[k], beta > 0. ? difference(k, 4) : 0., 1e-4 * scale);
      EXPECT_NEAR(in_radius[k], difference(k, 5), 1e-4 * scale);
    }
    shared[0] += slope(4);
    shared[1] += slope(5);
    shared[2] += difference(4, 4);
    shared[3] += difference(4, 5);
    shared[4] += difference(5, 5);
  }
  EXPECT_GT(n_cells, 50);
  if(beta == 0.)
    shared[0] = shared[2] = shared[3] = 0.;
  double scale = 0.;
  for(const double x : shared)
    scale += std::abs(x);
  for(std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(sums.of_level_and_radius()[k], shared[k], 1e-4 * scale) << k;
}

TEST(Strain_sums, are_the_derivatives_of_the_objective)
{
  for(const double beta : {0., 20.})
  {
    expect_sums_of_faces(SP::Symmetric_Dirichlet_energy_3(), beta);
    expect_sums_of_faces(SP::Stretch_energy_3(), beta);
  }
}

// A sphere whose map to itself is smooth but no isometry: a sweep takes little of that away, a step most of it.
TEST(Smooth_step, takes_away_what_sweeps_are_slow_with)
{
  const Triangle_list round = icosphere(5);
  Images images = directions_of(round.points);
  for(Coordinates& p : images)
    p = normalized(Coordinates{p[0], p[1], p[2] + 0.4});
  const SP::Symmetric_Dirichlet_energy_3 energy;
  Mapped_surface<SP::Symmetric_Dirichlet_energy_3> map(round, images, energy);
  const auto& positions = map.positions; // no decomposition, whose names lambdas cannot use in Clang
  const auto& space = map.space;
  auto& descent = map.descent;
  for(const double beta : {0., 20.})
  {
    Objective objective(Sharpness::relative(beta), true);
    const auto measure = [&](const Images& images_at_hand, double radius) {
      auto summary = descent.measure(images_at_hand, radius, objective.of_faces());
      for(int k = 0; k < 50 && objective.improve_level(summary) > 1e-12; ++k)
        summary = descent.summary(radius, objective.of_faces());
      return objective.value(summary);
    };
    objective.start_sweep(0, descent.measure(positions, 1., objective.of_faces()));
    const double before = measure(positions, 1.);

    Images swept = positions;
    descent.sweep(swept, 1., objective.of_faces());
    const double gain_of_sweep = before - measure(swept, 1.);

    measure(positions, 1.);
    Smooth_step<std::decay_t<decltype(space)>> step(space, positions.size(), true);
    ASSERT_TRUE(step.find(descent.measured_faces(), descent.stars(), positions, 1., objective.of_faces(), Execution()));
    Images moved;
    step.move(positions, 1., moved, Execution());
    EXPECT_TRUE(descent.are_safely_positive(moved));
    const double after = measure(moved, step.radius_factor(1.));
    EXPECT_GT(before - after, 0.6 * (before - 2.)) << beta;
    EXPECT_LT(gain_of_sweep, 0.2 * (before - 2.)) << beta;
    EXPECT_EQ(step.level_step(1.) != 0., beta > 0.);

    step.move(positions, 0., moved, Execution());
    for(std::size_t v = 0; v < moved.size(); ++v)
      EXPECT_LT(distance(moved[v], positions[v]), 1e-15);
    std::swap(moved[0], moved[1]);
    EXPECT_FALSE(descent.are_safely_positive(moved));
  }
}

TEST(Smooth_step_schedule, makes_steps_rare_that_gain_little)
{
  Smooth_step_schedule schedule;
  std::vector<std::size_t> sweeps;
  double value = 100.;
  for(std::size_t sweep = 0; sweep < 80; ++sweep)
  {
    if(schedule.is_due(sweep))
    {
      const double gain = sweeps.size() < 3 ? 2. : sweep < 60 ? 0.5 : 3.;
      schedule.has_made(sweep, value, value - gain);
      value -= gain;
      sweeps.push_back(sweep);
      EXPECT_TRUE(schedule.may_end(sweep));
      EXPECT_EQ(schedule.may_end(sweep + 1), sweeps.size() >= 5 && sweeps.size() <= 8);
    }
    value -= 1.;
  }
  EXPECT_EQ(sweeps, (std::vector<std::size_t>{2, 4, 6, 8, 12, 20, 36, 52, 68, 70, 72, 74, 76, 78}));
}

} // namespace
