// The energy of a star as a function of its vertex: its value from the positions in space, gradient and Hessian in the
// tangential coordinates by central differences, and the steps on it; and stars in packets, moved as if each were alone.

#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/descent/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/descent/Measured_faces.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Vertex_step.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>

#include "random_stars.h"

using namespace test;

namespace {

using namespace SP::internal;

constexpr double infinite = std::numeric_limits<double>::infinity();

template <class Energy_, class Step_>
struct Model
{
  using Energy = Energy_;
  using Step = Step_;
  static constexpr bool is_flat = std::is_same<Step, Gradient_step>::value;

  template <class FT>
  using Star_in = Star_energy<Energy, Step::template Image_measure, FT>;
  using Star = Star_in<double>;
  static Star make_star() { return Star(Face_energy<Energy>(Energy())); }

  // The value with its derivatives, as far as the step asks for them: that of the gradient has no use for a Hessian.
  static double derivatives(const Star& star, std::array<double, 2>& gradient, std::array<double, 3>& hessian)
  {
    hessian = {};
    if constexpr(is_flat)
      return star.gradient(gradient);
    else
      return star.derivatives(gradient, hessian);
  }
};

// The sum of the energies, that of their exponentials, and what the default method lowers; where the energies are of this size.
std::vector<Face_objective> objectives(double energy, double relative_sharpness)
{
  if(!(relative_sharpness > 0.))
    return {Face_objective()};
  const double s = relative_sharpness / energy;
  Face_objective of_level(s);
  of_level.share = 0.3;
  of_level.level = 0.8 * energy;
  of_level.area_correction = 2. / 9.;
  return {Face_objective(s), of_level};
}

// A star that is loaded anew when its vertex has moved.
template <class Star>
struct Loaded_star
{
  Loaded_star(Star star, Random& random, std::size_t degree, double size)
    : energy(star)
    , m_stars(random, {degree}, size)
    , m_packets(m_stars.packets())
  {}

  void load(double squared_radius, const Face_objective& objective)
  {
    energy.set_objective(squared_radius, objective);
    energy.load(m_packets.view<double>(m_packets.packet(0), 0), m_stars.points.data());
  }
  void load(double squared_radius, double sharpness) { load(squared_radius, Face_objective(sharpness)); }

  void move_to(double x, double y) { m_stars.points[0] = energy.point_at(x, y); }

  // The energies of the faces with the vertex at u, with the invariants from edge lengths and a determinant or a flat
  // area; infinite where a face is not positive.
  template <class Model>
  std::vector<double> energies_at(const Vector_3d& u, double squared_radius,
                                  const Face_objective& objective = Face_objective()) const
  {
    std::vector<double> result;
    const auto& star = m_stars.stars[0];
    for(std::size_t j = 0; j < star.size(); ++j)
    {
      const std::array<const Vector_3d*, 3> x = {&u, &m_stars.points[star.neighbor(j)],
                                                 &m_stars.points[star.neighbor((j + 1) % star.size())]};
      const auto edge = [&](std::size_t a, std::size_t b, std::size_t k) {
        return static_cast<long double>((*x[b])[k]) - (*x[a])[k];
      };
      const auto squared_edge = [&](std::size_t a, std::size_t b) {
        return edge(a, b, 0) * edge(a, b, 0) + edge(a, b, 1) * edge(a, b, 1) + edge(a, b, 2) * edge(a, b, 2);
      };
      // det(u, p, q) = det(u, p - u, q - u)
      long double determinant = 0.L;
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        determinant += u[k] * (edge(0, 1, l) * edge(0, 2, m) - edge(0, 1, m) * edge(0, 2, l));
      }
      const Rest_triangle r = star.rest(j);
      const double doubled_area = 1. / r.inverse_doubled_area;
      const long double pp = squared_edge(1, 2), pq = squared_edge(2, 0), qq = squared_edge(0, 1);
      const long double i = squared_radius * (r.opposite_0 * pp + r.opposite_1 * pq + r.opposite_2 * qq);
      // Heron's formula, as twice the area
      const long double flat = 0.5L * std::sqrt((std::max)(4.L * pp * pq - (pp + pq - qq) * (pp + pq - qq), 0.L));
      const long double d = squared_radius / doubled_area * (Model::is_flat ? flat : determinant) *
                            objective.area_factor(r.opposite_0, r.opposite_1, r.opposite_2, doubled_area);
      result.push_back(determinant > 0.L ? typename Model::Energy()(static_cast<double>(i), static_cast<double>(d))
                                         : infinite);
    }
    return result;
  }

  template <class Model>
  double largest_energy(double squared_radius) const
  {
    const std::vector<double> energies = energies_at<Model>(m_stars.points[0], squared_radius);
    return *std::max_element(energies.begin(), energies.end());
  }

  const Images& points() const { return m_stars.points; }

  // How much face j counts.
  template <class Model>
  double count_of(std::size_t j) const
  {
    return weighs_faces_by_area<typename Model::Energy> ? 1. / m_stars.stars[0].rest(j).inverse_doubled_area : 1.;
  }

  // What a face with this energy adds: E, exp(s (E - largest)), or s psi(E).
  static double value_of(double e, const Face_objective& objective, double largest)
  {
    if(objective.is_average())
      return e;
    const double a = objective.share, s = objective.sharpness;
    if(!objective.has_level())
      return std::exp(s * (e - largest));
    return s * ((1. - a) * e + a / s * std::exp(s * (e - objective.level)));
  }

  Star energy;

private:
  Random_stars m_stars;
  Star_packets m_packets;
};

template <class Model>
class One_star : public ::testing::Test
{
protected:
  using Star = typename Model::Star;

  Loaded_star<Star> random_star(std::size_t degree, double size)
  {
    return {Model::make_star(), m_random, degree, size};
  }

  // Calls a function for stars of all sizes, loaded with each objective at a radius, and the largest energy of the faces.
  template <class Function>
  void for_each_loaded_star(const Function& function)
  {
    for(int k = 0; k < 300; ++k)
    {
      const double sizes[] = {0.6, 0.1, 1e-3, 1e-6};
      const double size = sizes[k % 4], squared_radius = m_random.between(0.5, 2.);
      auto star = random_star(3 + m_random.below(12), size);
      const double largest = star.template largest_energy<Model>(squared_radius);
      for(const double relative_sharpness : {0., 1., 12.})
        for(const Face_objective& objective : objectives(largest, relative_sharpness))
        {
          star.load(squared_radius, objective);
          function(star, objective, squared_radius, largest, size);
        }
    }
  }

  Random m_random{1};
};

using Models = ::testing::Types<Model<SP::Symmetric_Dirichlet_energy_3, Newton_step>,
                                Model<SP::Stretch_energy_3, Newton_step>, // whose faces count by their areas
                                Model<SP::Isometric_energy_3, Gradient_step>>;
TYPED_TEST_SUITE(One_star, Models, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(One_star, is_the_sum_over_the_faces)
{
  Random& random = this->m_random;
  this->for_each_loaded_star([&](const auto& star, const Face_objective& objective, double squared_radius,
                                 double largest, double size) {
    std::array<double, 2> gradient, gradient_alone;
    std::array<double, 3> hessian;
    const double f = TypeParam::derivatives(star.energy, gradient, hessian);
    EXPECT_NEAR(f, star.energy(0., 0.), 1e-9 * f);
    EXPECT_EQ(star.energy.gradient(gradient_alone), f);
    EXPECT_EQ(gradient_alone, gradient);

    const double x = 0.2 * size * random.between(-1., 1.), y = 0.2 * size * random.between(-1., 1.);
    const std::vector<double> energies =
        star.template energies_at<TypeParam>(star.energy.point_at(x, y), squared_radius, objective);
    double sum = 0., amplification = 1.; // of the relative error, by the exponential
    for(std::size_t j = 0; j < energies.size(); ++j)
    {
      sum += star.template count_of<TypeParam>(j) * star.value_of(energies[j], objective, largest);
      amplification = (std::max)(amplification, objective.sharpness * energies[j]);
    }
    // The positions in space are rounded to 1e-16 of the radius, the offsets are not.
    const double value = star.energy(x, y);
    EXPECT_TRUE(value == sum || std::abs(value - sum) <= amplification * (1e-10 + 1e-13 / size) * sum) << value - sum;
  });
}

TYPED_TEST(One_star, has_the_derivatives_of_its_value)
{
  this->for_each_loaded_star([&](const auto& star, const Face_objective&, double, double, double) {
    const auto& e = star.energy;
    std::array<double, 2> g;
    std::array<double, 3> h;
    const double f = TypeParam::derivatives(e, g, h);

    // Everything in units of the shortest edge, of which the step is so small a part that the star does not notice,
    // and so large that rounding does not matter.
    const double unit = e.shortest_edge(), step = 2e-4 * unit;
    const double fx = e(step, 0.), fX = e(-step, 0.), fy = e(0., step), fY = e(0., -step);
    const double scale = f + unit * std::hypot(g[0], g[1]) + unit * unit * (std::abs(h[0]) + std::abs(h[2]));
    EXPECT_NEAR(g[0] * unit, (fx - fX) / (2. * step) * unit, 1e-4 * scale);
    EXPECT_NEAR(g[1] * unit, (fy - fY) / (2. * step) * unit, 1e-4 * scale);
    if(TypeParam::is_flat)
      return;
    const double unit2 = unit * unit, step2 = step * step;
    EXPECT_NEAR(h[0] * unit2, (fx - 2. * f + fX) / step2 * unit2, 1e-3 * scale);
    EXPECT_NEAR(h[2] * unit2, (fy - 2. * f + fY) / step2 * unit2, 1e-3 * scale);
    const double mixed = e(step, step) - e(step, -step) - e(-step, step) + e(-step, -step);
    EXPECT_NEAR(h[1] * unit2, mixed / (4. * step2) * unit2, 1e-3 * scale);
  });
}

TYPED_TEST(One_star, is_infinite_where_a_face_is_not_positive)
{
  for(int k = 0; k < 100; ++k)
  {
    const double size = k % 2 == 0 ? 0.5 : 1e-4;
    auto star = this->random_star(5, size);
    star.load(1., 0.);
    EXPECT_LT(star.energy(0., 0.), infinite);
    double shortest = infinite;
    for(std::size_t j = 1; j < star.points().size(); ++j)
      shortest = (std::min)(shortest, distance(star.points()[0], star.points()[j]));
    EXPECT_NEAR(star.energy.shortest_edge(), shortest, 1e-9 * shortest);
    for(int j = 0; j < 12; ++j)
      EXPECT_EQ(star.energy(1.1 * size * std::cos(j * pi / 6.), 1.1 * size * std::sin(j * pi / 6.)), infinite);
    EXPECT_EQ(star.energy(2., 0.), infinite); // beyond the sphere
    EXPECT_EQ(star.energy(std::nan(""), 0.), infinite);
  }
}

// exp(s E) is beyond doubles, exp(s (E - largest E)) is not.
TYPED_TEST(One_star, does_not_overflow)
{
  for(const double sharpness : {1e3, 1e6})
  {
    auto star = this->random_star(6, 0.1);
    star.load(1., sharpness);
    std::array<double, 2> g;
    std::array<double, 3> h;
    const double f = TypeParam::derivatives(star.energy, g, h);
    double least = infinite, all = 0.;
    for(std::size_t j = 0; j < 6; ++j)
    {
      least = (std::min)(least, star.template count_of<TypeParam>(j));
      all += star.template count_of<TypeParam>(j);
    }
    EXPECT_GE(f, (1. - 1e-9) * least); // the sharpness times the rounding of an energy
    EXPECT_LE(f, all);
    EXPECT_TRUE(std::isfinite(g[0] + g[1] + h[0] + h[1] + h[2]));
    EXPECT_GT(std::hypot(g[0], g[1]), 0.);
  }
}

// Whatever the star, the step goes downhill or stays.
TYPED_TEST(One_star, is_lowered_by_the_step)
{
  Random& random = this->m_random;
  const typename TypeParam::Step take_step;
  int n_moves = 0;
  for(int k = 0; k < 200; ++k)
  {
    auto star = this->random_star(3 + random.below(8), k % 2 == 0 ? 0.5 : 1e-5);
    star.load(1., k % 3 == 0 ? 0. : 0.5);
    std::array<double, 2> step = {-7., -7.}, g;
    if(take_step(star.energy, step))
    {
      ++n_moves;
      EXPECT_LT(star.energy(step[0], step[1]), star.energy(0., 0.));
      star.energy.gradient(g);
      EXPECT_LT(step[0] * g[0] + step[1] * g[1], 0.);
      if(TypeParam::is_flat)
      {
        EXPECT_LE(std::hypot(step[0], step[1]), star.energy.shortest_edge());
        EXPECT_NEAR(step[0] * g[1], step[1] * g[0], 1e-12 * std::hypot(step[0], step[1]) * std::hypot(g[0], g[1]));
      }
    }
    else
    {
      EXPECT_EQ(step, (std::array<double, 2>{-7., -7.}));
    }
  }
  EXPECT_GE(n_moves, 195); // a random star is hardly ever at its minimum
}

// As many steps of one vertex as it takes lead to where the gradient vanishes, though each goes nearly twice as far as it
// should for that.
TEST(Newton_step, leads_to_the_minimum)
{
  using Newton_model = Model<SP::Symmetric_Dirichlet_energy_3, Newton_step>;
  Random random(6);
  for(int k = 0; k < 50; ++k)
  {
    Loaded_star<Newton_model::Star> star(Newton_model::make_star(), random, 6, 0.1);
    const auto size_of_gradient = [&] {
      star.load(1., k % 2 == 0 ? 0. : 0.1);
      std::array<double, 2> g;
      const double f = star.energy.gradient(g);
      return std::hypot(g[0], g[1]) * star.energy.shortest_edge() / f;
    };
    const double start = size_of_gradient();
    std::array<double, 2> step;
    for(int i = 0; i < 300 && Newton_step()(star.energy, step); ++i)
    {
      star.move_to(step[0], step[1]);
      size_of_gradient();
    }
    EXPECT_GT(start, 1e-4);
    EXPECT_LT(size_of_gradient(), 1e-7);
  }
}

// A quadratic function, where Newton's method is exact.
struct Quadratic
{
  double derivatives(std::array<double, 2>& gradient, std::array<double, 3>& hessian) const
  {
    gradient = g;
    hessian = h;
    return 3.;
  }
  double operator()(double x, double y) const
  {
    ++n_evaluations;
    return 3. + g[0] * x + g[1] * y + 0.5 * (h[0] * x * x + 2. * h[1] * x * y + h[2] * y * y);
  }
  double shortest_edge() const { return 1.; }

  std::array<double, 2> g;
  std::array<double, 3> h;
  mutable int n_evaluations = 0;
};

// with these eigenvalues
Quadratic random_quadratic(double a, double b, Random& random)
{
  const double angle = random.between(0., 2. * pi), c = std::cos(angle), s = std::sin(angle);
  const double x = random.between(-1., 1.), y = random.between(-1., 1.);
  return {{x, y}, {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c}};
}

TEST(Newton_step, is_over_relaxed_where_the_hessian_is_positive)
{
  Random random(7);
  for(int k = 0; k < 200; ++k)
  {
    const double a = random.between(0.1, 5.), b = random.between(0.1, 5.);
    const Quadratic f = random_quadratic(a, b, random);
    const std::array<double, 2> newton = {-(f.h[2] * f.g[0] - f.h[1] * f.g[1]) / (a * b),
                                          -(f.h[0] * f.g[1] - f.h[1] * f.g[0]) / (a * b)};
    std::array<double, 2> step;
    ASSERT_TRUE(Newton_step()(f, step));
    EXPECT_EQ(f.n_evaluations, 1); // at 1.7 times its length, it is lower
    for(std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(step[i], 1.7 * newton[i], 1e-12 * (1. + std::abs(newton[i])));
    ASSERT_TRUE(Newton_step(1.9)(f, step));
    for(std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(step[i], 1.9 * newton[i], 1e-12 * (1. + std::abs(newton[i])));
  }
}

TEST(Newton_step, takes_the_absolute_values_of_the_eigenvalues)
{
  Random random(8);
  for(int k = 0; k < 200; ++k)
  {
    const double a = random.between(0.01, 5.), b = -random.between(0.01, 5.);
    const Quadratic f = random_quadratic(k % 2 == 0 ? a : b, b, random);
    std::array<double, 2> step;
    ASSERT_TRUE(Newton_step()(f, step));
    EXPECT_LT(f(step[0], step[1]), 3.);
    EXPECT_LT(f.g[0] * step[0] + f.g[1] * step[1], 0.);
  }
}

TEST(Newton_step, stays_where_there_is_nothing_to_do)
{
  std::array<double, 2> step;
  EXPECT_FALSE(Newton_step()(Quadratic{{0., 0.}, {1., 0., 1.}}, step));
  EXPECT_FALSE(Newton_step()(Quadratic{{1., 0.}, {0., 0., 0.}}, step));
  EXPECT_FALSE(Newton_step()(Quadratic{{infinite, 0.}, {infinite, 0., 1.}}, step));
  EXPECT_FALSE(Newton_step()(Quadratic{{std::nan(""), 0.}, {1., 0., 1.}}, step));
}

// A function with this gradient that is lower only within `range` of the vertex.
struct Well
{
  double gradient(std::array<double, 2>& gradient) const
  {
    gradient = g;
    return 1.;
  }
  double operator()(double x, double y) const
  {
    trials.push_back(std::hypot(x, y));
    return trials.back() < range ? 0.5 : 1.;
  }
  double shortest_edge() const { return edge; }

  std::array<double, 2> g;
  double edge, range;
  mutable std::vector<double> trials = {};
};

// Each trial is a step in the tangential plane, projected to the unit sphere; the first one as long as the shortest edge.
TEST(Gradient_step, shortens_its_step_until_the_energy_falls)
{
  for(const double edge : {1., 0.3, 1e-6})
    for(const double range : {infinite, 0.2 * edge, 1e-2 * edge, 1e-6 * edge, 1e-9 * edge})
    {
      const Well well{{3., -4.}, edge, range};
      std::array<double, 2> step;
      ASSERT_TRUE(Gradient_step()(well, step));
      double t = edge;
      for(const double trial : well.trials)
      {
        EXPECT_NEAR(trial, t / std::sqrt(1. + t * t), 1e-14 * t);
        t *= 0.8;
      }
      const double length = well.trials.back();
      EXPECT_NEAR(step[0], -0.6 * length, 1e-14 * length);
      EXPECT_NEAR(step[1], 0.8 * length, 1e-14 * length);
      EXPECT_LT(length, range);
      EXPECT_TRUE(well.trials.size() == 1 ? range == infinite : length > 0.799 * range); // the first that does
    }
}

TEST(Gradient_step, stays_where_there_is_nothing_to_do)
{
  std::array<double, 2> step = {-7., -7.};
  for(const double edge : {1., 1e-6}) // lower only by a shorter step than the shortest, which is relative to the edge
  {
    const Well steep{{1., 1.}, edge, 1e-11 * edge};
    EXPECT_FALSE(Gradient_step()(steep, step));
    EXPECT_EQ(steep.trials.size(), 104u); // 0.8^103 > 1e-10 > 0.8^104
  }
  for(const double g : {0., infinite, std::nan("")})
    EXPECT_FALSE(Gradient_step()(Well{{g, 0.}, 0.3, 1.}, step));
  EXPECT_EQ(step, (std::array<double, 2>{-7., -7.}));
}

TEST(Star_packets, hold_every_star_once)
{
  Random random(2);
  std::vector<std::size_t> degrees = Random_stars::random_degrees(random, 3000);
  degrees[5] = degrees[1500] = 40;
  degrees[1501] = 500;
  Random_stars stars(random, degrees, 0.1);
  // The degree is known, whatever the rest shapes are: also of faces that are too large for their area to have an inverse.
  for(const std::size_t k : {2u, 5u, 1000u})
    for(Rest_triangle& rest : stars.stars[k].rests)
      rest.inverse_doubled_area = 0.;
  const std::vector<std::size_t> first_of_set = {0, 7, 7, 1700, 2999, 3000};
  const Star_packets packets = stars.packets(first_of_set);
  ASSERT_EQ(packets.number_of_sets(), first_of_set.size() - 1);

  std::vector<int> n_times(degrees.size(), 0);
  for(std::size_t set = 0; set < packets.number_of_sets(); ++set)
    for(std::size_t k = packets.first_packet(set); k < packets.first_packet(set + 1); ++k)
    {
      const Star_packets::Packet& packet = packets.packet(k);
      EXPECT_GE(packet.first_place, packets.first_place_of_set(set));
      EXPECT_LT(packet.first_place, packets.first_place_of_set(set + 1));
      for(std::size_t i = 0; i < packet.number_of_stars; ++i)
      {
        const std::uint32_t v = packets.vertex(packet.first_place + i);
        const std::size_t source = static_cast<std::size_t>(
            std::lower_bound(stars.vertices.begin(), stars.vertices.end(), v) - stars.vertices.begin());
        ++n_times[source];
        EXPECT_GE(source, first_of_set[set]);
        EXPECT_LT(source, first_of_set[set + 1]);
        EXPECT_EQ(packet.stride == 1, degrees[source] > 32);

        const Random_stars::Star& expected = stars.stars[source];
        const Star_view<double> copy = packets.star(packet.first_place + i);
        const Star_view<double> view = packets.view<double>(packet, i);
        ASSERT_EQ(copy.size(), expected.size());
        ASSERT_EQ(view.size(), expected.size());
        for(std::size_t j = 0; j < view.size(); ++j)
        {
          EXPECT_EQ(view.neighbor(j, stars.points.data()), stars.points[expected.neighbors[j]]);
          EXPECT_EQ(view.inverse_doubled_area(j), expected.rests[j].inverse_doubled_area);
          EXPECT_EQ(view.opposite_0(j), expected.rests[j].opposite_0);
          EXPECT_EQ(view.opposite_1(j), expected.rests[j].opposite_1);
          EXPECT_EQ(view.opposite_2(j), expected.rests[j].opposite_2);
          EXPECT_EQ(copy.neighbor(j), expected.neighbors[j]);
          EXPECT_EQ(copy.rest(j).opposite_1, expected.rests[j].opposite_1);
        }
      }
    }
  EXPECT_EQ(n_times, std::vector<int>(degrees.size(), 1));
}

// The stars of a packet differ in their numbers of faces: what fills the shorter ones is no face.
TEST(Star_packets, list_every_face_once)
{
  for(const Triangle_list& list : {icosphere(3), suspension(40)}) // 5 and 6 faces in a packet, and packets of one star
  {
    const Surface mesh = surface_of(list);
    const Vertex_rings& rings = mesh.rings();
    const Independent_sets sets(rings);
    const Star_packets stars = stars_of(mesh, sets.vertices, sets.first);
    const std::vector<std::uint32_t> places = places_of(stars, mesh.number_of_vertices());
    std::vector<Index_triangle> expected, listed;
    std::size_t n_of_rows = 0;
    rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      expected.push_back(rotated({a, b, c}));
    });
    for(std::size_t k = 0; k < stars.number_of_packets(); ++k)
      stars.for_each_face(k, places,
                          [&](bool is_of_row, std::size_t, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                            EXPECT_LT(places[a], (std::min)(places[b], places[c]));
                            listed.push_back(rotated({a, b, c}));
                            n_of_rows += is_of_row;
                          });
    EXPECT_EQ(sorted(listed), sorted(expected));
    EXPECT_EQ(n_of_rows % Star_packets::width, 0u);
    EXPECT_EQ(n_of_rows > list.triangles.size() / 2, stars.packet(0).stride > 1);
  }
}

// The positions after one Newton step of each star, several at a time.
template <class FT>
Images moved(const Random_stars& stars, const Face_objective& objective)
{
  Images positions = stars.points;
  const Star_packets packets = stars.packets();
  Star_energy<SP::Isometric_energy_3, Newton_step::Image_measure, FT> star(
      Face_energy<SP::Isometric_energy_3>(SP::Isometric_energy_3(0.3)));
  star.set_objective(1.1, objective);
  for(std::size_t k = 0; k < packets.number_of_packets(); ++k)
  {
    const Star_packets::Packet& packet = packets.packet(k);
    for(std::size_t first = 0; first < packet.number_of_stars; first += Lanes<FT>::width)
    {
      star.load(packets.view<FT>(packet, first), stars.points.data());
      std::array<FT, 2> step = {FT(0.), FT(0.)};
      const auto is_moved = Newton_step()(star, step);
      const Vector_3<FT> point = star.point_at(step[0], step[1]);
      for(std::size_t i = 0; i < Lanes<FT>::width && first + i < packet.number_of_stars; ++i)
        if(lane(is_moved, i))
          positions[packets.vertex(packet.first_place + first + i)] = {lane(point[0], i), lane(point[1], i),
                                                                       lane(point[2], i)};
    }
  }
  return positions;
}

// With the same bits for any number of lanes, whatever the processor, and whichever stars are beside.
TEST(Packed_stars, move_as_if_they_were_alone)
{
  Random random(3);
  for(const double sharpness : {0., 0.5, 1e3})
    for(const Face_objective& objective : objectives(1., sharpness))
      for(const double size : {0.5, 1e-5})
      {
        if(objective.has_level() && sharpness > 100.)
          continue; // the levels follow the energies, and are no such thing for these stars
        const Random_stars stars(random, Random_stars::random_degrees(random, 203), size);
        const Images alone = moved<double>(stars, objective), in_two = moved<Two_lanes>(stars, objective),
                     in_four = moved<Four_lanes>(stars, objective);
        Images on_this_processor;
        run_in_lanes([&](auto number_type) {
          using FT = typename decltype(number_type)::FT;
          on_this_processor = moved<FT>(stars, objective);
        });
        EXPECT_TRUE(have_same_bits(in_two, in_four));
        EXPECT_TRUE(have_same_bits(in_two, on_this_processor));
        std::size_t n_moved = 0;
        for(std::size_t v = 0; v < alone.size(); ++v)
        {
          n_moved += in_two[v] != stars.points[v];
          // The exponential functions differ by rounding.
          EXPECT_LT(distance(alone[v], in_two[v]), 1e-9 * (1. + sharpness) * size) << v;
        }
        EXPECT_GE(n_moved, 190u);
      }
}

} // namespace
