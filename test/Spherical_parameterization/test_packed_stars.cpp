// Several stars at once: packed numbers, the layout of stars in packets, and that a star in a lane is moved as if it were
// alone, with the same bits for any number of lanes and whatever processor the code is compiled for.

#include "test_indexed_meshes.h"

#include <CGAL/Spherical_parameterization/Determinant_barrier_3.h>
#include <CGAL/Spherical_parameterization/Flat_area_barrier_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Newton_update_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/Energy_summary.h>
#include <CGAL/Spherical_parameterization/internal/Lanes.h>
#include <CGAL/Spherical_parameterization/internal/Independent_sets.h>
#include <CGAL/Spherical_parameterization/internal/Measured_faces.h>
#include <CGAL/Spherical_parameterization/internal/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/run_in_lanes.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using namespace SP::internal;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;

double uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * static_cast<double>(random()) / 0x1p32;
}

// Stars of random degrees, far from each other on the unit sphere or not: their vertices move, their neighbors do not.
// Star k is what Star_packets asks for.
class Random_stars
{
public:
  Random_stars(unsigned seed, const std::vector<std::size_t>& degrees, double size = 0.1)
  {
    std::mt19937 random(seed);
    for(const std::size_t degree : degrees)
    {
      const Vector_3d center =
          normalized({uniform(random, -1., 1.), uniform(random, -1., 1.), uniform(random, -1., 1.)});
      const Tangent_frame frame(center);
      m_vertices.push_back(static_cast<std::uint32_t>(m_points.size()));
      m_points.push_back(center);
      m_stars.push_back({{}, {}});
      for(std::size_t j = 0; j < degree; ++j)
      {
        const double angle =
            2. * pi * (static_cast<double>(j) + uniform(random, 0., 0.4)) / static_cast<double>(degree);
        const double r = size * uniform(random, 0.6, 1.);
        const auto coordinate = [&]() { return size * uniform(random, -1., 1.); };
        m_stars.back().neighbors.push_back(static_cast<std::uint32_t>(m_points.size()));
        m_points.push_back(frame.point_at(r * std::cos(angle), r * std::sin(angle)));
        m_stars.back().rests.push_back(Rest_triangle::from_points({coordinate(), coordinate(), coordinate()},
                                                                  {coordinate(), coordinate(), coordinate()},
                                                                  {coordinate(), coordinate(), coordinate()}));
      }
    }
  }

  struct Star
  {
    std::vector<std::uint32_t> neighbors;
    std::vector<Rest_triangle> rests;

    std::size_t degree() const { return neighbors.size(); }
    std::uint32_t neighbor(std::size_t j) const { return neighbors[j]; }
    Rest_triangle rest(std::size_t j) const { return rests[j]; }
  };

  const std::vector<Vector_3d>& points() const { return m_points; }
  std::uint32_t vertex(std::size_t k) const { return m_vertices[k]; }
  const Star& star(std::size_t k) const { return m_stars[k]; }

  Star_packets packets(const std::vector<std::size_t>& first_of_set) const
  {
    Star_packets result;
    result.assign(m_vertices, first_of_set, [&](std::uint32_t v) { return star_of(v).degree(); });
    for(std::size_t k = 0; k < result.number_of_packets(); ++k)
      result.fill(k, [&](std::uint32_t v) { return star_of(v); });
    return result;
  }
  const Star& star_of(std::uint32_t v) const
  {
    return m_stars[static_cast<std::size_t>(std::find(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin())];
  }
  Star_packets packets() const { return packets({0, m_stars.size()}); }

private:
  std::vector<Vector_3d> m_points;
  std::vector<std::uint32_t> m_vertices;
  std::vector<Star> m_stars;
};

using Two = Two_lanes;
using Four = Four_lanes;

// The positions after one update of each star, several at a time.
template <class FT, class Energy, class Barrier>
std::vector<Vector_3d> moved(const Random_stars& stars, const Energy& energy, const Barrier&, double sharpness)
{
  std::vector<Vector_3d> positions = stars.points();
  const Star_packets packets = stars.packets();
  Star_energy<Energy, Barrier, FT> star(energy);
  star.set_objective(1.1, sharpness);
  for(std::size_t k = 0; k < packets.number_of_packets(); ++k)
  {
    const Star_packets::Packet& packet = packets.packet(k);
    for(std::size_t first = 0; first < packet.number_of_stars; first += Lanes<FT>::width)
    {
      star.load(packets.view<FT>(packet, first), stars.points().data());
      std::array<FT, 2> step = {FT(0.), FT(0.)};
      const auto is_moved = SP::Newton_update_3()(star, step);
      const Vector_3<FT> point = star.point_at(step[0], step[1]);
      for(std::size_t i = 0; i < Lanes<FT>::width && first + i < packet.number_of_stars; ++i)
        if(lane(is_moved, i))
          positions[packets.vertex(packet.first_place + first + i)] = {lane(point[0], i), lane(point[1], i),
                                                                       lane(point[2], i)};
    }
  }
  return positions;
}

std::vector<std::size_t> random_degrees(unsigned seed, std::size_t n)
{
  std::mt19937 random(seed);
  std::vector<std::size_t> degrees;
  for(std::size_t k = 0; k < n; ++k)
    degrees.push_back(3 + random() % 9);
  return degrees;
}

// The symmetric Dirichlet energy as a user would write it, for single numbers.
struct Plain_energy
{
  double operator()(double i, double d) const
  {
    EXPECT_GT(d, 0.);
    return SP::Symmetric_Dirichlet_energy_3()(i, d);
  }
  SP::Energy_derivatives_3 derivatives(double i, double d) const
  {
    return SP::Symmetric_Dirichlet_energy_3().derivatives(i, d);
  }
};

// What is derived from an energy for several numbers may be for single ones again.
struct Derived_energy : SP::Symmetric_Dirichlet_energy_3
{
  double operator()(double i, double d) const { return SP::Symmetric_Dirichlet_energy_3::operator()(i, d); }
};

TEST(Packed_double, has_an_exponential)
{
  std::mt19937 random(1);
  for(int k = 0; k < 100000; ++k)
  {
    const double x = k % 3 == 0 ? uniform(random, -700., 700.) : uniform(random, -12., 1.);
    const Four packed = Lanes<Four>::generate([&](std::size_t i) { return x + static_cast<double>(i); });
    const Four e = exponential(packed);
    for(std::size_t i = 0; i < Lanes<Four>::width; ++i)
      EXPECT_NEAR(lane(e, i) / std::exp(lane(packed, i)), 1., 1e-15);
  }
  EXPECT_EQ(lane(exponential(Four(0.)), 0), 1.);
  EXPECT_NEAR(lane(exponential(Four(-708.)), 0) / std::exp(-708.), 1., 1e-15);
  EXPECT_NEAR(lane(exponential(Four(709.)), 0) / std::exp(709.), 1., 1e-15);
  EXPECT_LT(lane(exponential(Four(std::numeric_limits<double>::quiet_NaN())), 0), 1e-307);
  EXPECT_GT(lane(exponential(Four(1e3)), 0), 1e307);
  EXPECT_GT(lane(exponential(Four(infinity)), 0), 1e307);
  EXPECT_LT(lane(exponential(Four(-1e300)), 0), 1e-307);
  EXPECT_LT(lane(exponential(Four(-infinity)), 0), 1e-307);
}

TEST(Packed_double, decides_lane_by_lane)
{
  const Four a = Lanes<Four>::generate([](std::size_t i) { return static_cast<double>(i) - 1.; }), b = Four(0.5);
  const Four least = smaller(a, b), most = larger(a, b), size = absolute(a), root = square_root(size);
  const Four chosen = select(a < b && !(a < Four(0.)), Four(7.), a);
  for(std::size_t i = 0; i < Lanes<Four>::width; ++i)
  {
    const double x = static_cast<double>(i) - 1.;
    EXPECT_EQ(lane(least, i), x < 0.5 ? x : 0.5);
    EXPECT_EQ(lane(most, i), x < 0.5 ? 0.5 : x);
    EXPECT_EQ(lane(size, i), std::abs(x));
    EXPECT_EQ(lane(root, i), std::sqrt(std::abs(x)));
    EXPECT_EQ(lane(chosen, i), x < 0.5 && !(x < 0.) ? 7. : x);
  }
  EXPECT_TRUE(any(a < b));
  EXPECT_FALSE(any(a > Four(5.)));
  EXPECT_EQ(any(a < Four(-0.5)), true);
}

TEST(Star_packets, hold_every_star_once)
{
  std::vector<std::size_t> degrees = random_degrees(2, 3000);
  degrees[5] = degrees[1500] = 40;
  degrees[1501] = 500;
  const Random_stars stars(2, degrees);
  const std::vector<std::size_t> first_of_set = {0, 7, 7, 1700, 2999, 3000};
  const Star_packets packets = stars.packets(first_of_set);
  ASSERT_EQ(packets.number_of_sets(), first_of_set.size() - 1);

  std::vector<int> n_times(degrees.size(), 0);
  for(std::size_t set = 0; set < packets.number_of_sets(); ++set)
  {
    for(std::size_t k = packets.first_packet(set); k < packets.first_packet(set + 1); ++k)
    {
      const Star_packets::Packet& packet = packets.packet(k);
      EXPECT_GE(packet.first_place, packets.first_place_of_set(set));
      EXPECT_LT(packet.first_place, packets.first_place_of_set(set + 1));
      for(std::size_t i = 0; i < packet.number_of_stars; ++i)
      {
        std::size_t source = 0;
        while(stars.vertex(source) != packets.vertex(packet.first_place + i))
          ++source;
        ++n_times[source];
        EXPECT_GE(source, first_of_set[set]);
        EXPECT_LT(source, first_of_set[set + 1]);
        EXPECT_EQ(packet.stride == 1, degrees[source] > 32);

        const Random_stars::Star& expected = stars.star(source);
        const Star_packets::Star copy = packets.star(packet.first_place + i);
        ASSERT_EQ(copy.degree(), expected.degree());
        const Star_view<double> view = packets.view<double>(packet, i);
        ASSERT_EQ(view.size(), expected.degree());
        for(std::size_t j = 0; j < view.size(); ++j)
        {
          EXPECT_EQ(view.neighbor(j, stars.points().data()), stars.points()[expected.neighbors[j]]);
          EXPECT_EQ(view.inverse_area(j), expected.rests[j].inverse_area);
          EXPECT_EQ(view.opposite_0(j), expected.rests[j].opposite_0);
          EXPECT_EQ(view.opposite_1(j), expected.rests[j].opposite_1);
          EXPECT_EQ(view.opposite_2(j), expected.rests[j].opposite_2);
          EXPECT_EQ(copy.neighbor(j), expected.neighbors[j]);
          EXPECT_EQ(copy.rest(j).opposite_1, expected.rests[j].opposite_1);
        }
      }
    }
  }
  EXPECT_EQ(n_times, std::vector<int>(degrees.size(), 1));
}

// The stars of a packet differ in their numbers of faces: what fills the shorter ones is no face.
void expect_every_face_once(const test_meshes::Triangle_list& list)
{
  const Indexed_mesh mesh = test_indexed_meshes::indexed_mesh(list);
  const Vertex_rings& rings = mesh.rings();
  const Independent_sets sets(rings);
  Star_packets stars;
  stars.assign(sets.vertices(), sets.first(), [&](std::uint32_t v) { return rings.degree(v); });
  for(std::size_t k = 0; k < stars.number_of_packets(); ++k)
  {
    stars.fill(k, [&](std::uint32_t v) {
      Random_stars::Star star;
      const Vertex_rings::Ring ring = rings.ring(v);
      star.neighbors.assign(ring.begin(), ring.end());
      star.rests.assign(ring.size(), Rest_triangle{1., 1., 1., 1.});
      return star;
    });
  }

  using Face = std::array<std::uint32_t, 3>;
  std::vector<Face> expected, listed;
  rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { expected.push_back({a, b, c}); });
  for(std::size_t k = 0; k < stars.number_of_packets(); ++k)
  {
    const std::size_t n_before = listed.size();
    stars.for_each_face(k, [&](std::size_t, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      listed.push_back({a, b, c});
    });
    EXPECT_EQ(stars.number_of_faces(k), listed.size() - n_before);
  }
  std::sort(expected.begin(), expected.end());
  std::sort(listed.begin(), listed.end());
  EXPECT_EQ(listed, expected);
}

TEST(Star_packets, list_every_face_once)
{
  expect_every_face_once(test_meshes::icosphere(3));   // 5 and 6 faces in a packet
  expect_every_face_once(test_meshes::suspension(40)); // and packets of one star
}

template <class Energy, class Barrier>
void expect_the_same_in_any_lanes(const Energy& energy, const Barrier& barrier)
{
  for(const double sharpness : {0., 0.5, 1e3})
    for(const double size : {0.5, 1e-5})
    {
      const Random_stars stars(3, random_degrees(3, 203), size);
      const std::vector<Vector_3d> alone = moved<double>(stars, energy, barrier, sharpness);
      const std::vector<Vector_3d> in_two = moved<Two>(stars, energy, barrier, sharpness);
      const std::vector<Vector_3d> in_four = moved<Four>(stars, energy, barrier, sharpness);
      std::vector<Vector_3d> on_this_processor;
      run_in_lanes([&](auto number_type) {
        using FT = typename decltype(number_type)::FT;
        on_this_processor = moved<FT>(stars, energy, barrier, sharpness);
      });
      EXPECT_EQ(in_two, in_four);
      EXPECT_EQ(in_two, on_this_processor);
      std::size_t n_moved = 0;
      for(std::size_t v = 0; v < alone.size(); ++v)
      {
        n_moved += in_two[v] != stars.points()[v];
        // The exponential functions differ by rounding.
        EXPECT_LT(length(alone[v] - in_two[v]), 1e-9 * (1. + sharpness) * size) << v;
      }
      EXPECT_GE(n_moved, 190u);
    }
}

TEST(Packed_stars, move_as_if_they_were_alone)
{
  expect_the_same_in_any_lanes(SP::Symmetric_Dirichlet_energy_3(), SP::Determinant_barrier_3());
  expect_the_same_in_any_lanes(SP::Isometric_energy_3(0.3), SP::Flat_area_barrier_3());
}

// An energy for single numbers is asked lane by lane, and only for positive faces.
TEST(Packed_stars, take_energies_for_single_numbers)
{
  const Random_stars stars(4, random_degrees(4, 100), 0.3);
  EXPECT_EQ(moved<Four>(stars, Plain_energy(), SP::Determinant_barrier_3(), 0.5),
            moved<Four>(stars, SP::Symmetric_Dirichlet_energy_3(), SP::Determinant_barrier_3(), 0.5));
  EXPECT_EQ(moved<Four>(stars, Derived_energy(), SP::Determinant_barrier_3(), 0.5),
            moved<Four>(stars, SP::Symmetric_Dirichlet_energy_3(), SP::Determinant_barrier_3(), 0.5));
}

// A star's result does not depend on the stars beside it.
TEST(Packed_stars, do_not_mind_each_other)
{
  std::vector<std::size_t> degrees(8, 6);
  const Random_stars stars(5, degrees);
  const std::vector<Vector_3d> expected =
      moved<Four>(stars, SP::Symmetric_Dirichlet_energy_3(), SP::Determinant_barrier_3(), 0.5);
  const Star_packets packets = stars.packets();
  for(std::size_t first = 0; first + 4 <= 8; ++first)
  {
    Star_energy<SP::Symmetric_Dirichlet_energy_3, SP::Determinant_barrier_3, Four> star(
        (SP::Symmetric_Dirichlet_energy_3()));
    star.set_objective(1.1, 0.5);
    star.load(packets.view<Four>(packets.packet(0), first), stars.points().data());
    std::array<Four, 2> step = {Four(0.), Four(0.)};
    SP::Newton_update_3()(star, step);
    const Vector_3<Four> point = star.point_at(step[0], step[1]);
    for(std::size_t i = 0; i < Lanes<Four>::width; ++i)
      EXPECT_EQ(lane(point[1], i), expected[packets.vertex(first + i)][1]);
  }
}

// All energies of a mesh at once: those of the single faces, up to rounding.
TEST(Measured_faces, agree_with_the_single_faces)
{
  const Indexed_mesh mesh = test_indexed_meshes::indexed_mesh(test_meshes::icosphere(3));
  const std::size_t n = mesh.number_of_vertices();
  std::vector<Vector_3d> positions;
  for(const Vector_3d& p : mesh.points())
    positions.push_back(normalized(p + Vector_3d{0.1, 0.2, -0.1}));
  const auto rest_of_face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return Rest_triangle::from_points(mesh.points()[a], mesh.points()[b], mesh.points()[c]);
  };
  std::vector<std::uint32_t> vertices(n);
  std::vector<std::size_t> first_of_set;
  for(std::size_t v = 0; v < n; ++v)
  {
    vertices[v] = static_cast<std::uint32_t>(v);
    first_of_set.push_back(v);
  }
  first_of_set.push_back(n);
  Star_packets stars;
  stars.assign(vertices, first_of_set, [&](std::uint32_t v) { return mesh.rings().degree(v); });
  for(std::size_t v = 0; v < n; ++v)
  {
    Random_stars::Star star;
    const Vertex_rings::Ring ring = mesh.rings().ring(v);
    for(std::size_t j = 0; j < ring.size(); ++j)
    {
      star.neighbors.push_back(ring[j]);
      star.rests.push_back(rest_of_face(vertices[v], ring[j], ring[(j + 1) % ring.size()]));
    }
    stars.fill(v, [&](std::uint32_t) { return star; });
  }
  Measured_faces faces;
  faces.assign<CGAL::Sequential_tag>(stars, mesh.rings().number_of_faces());

  const SP::Symmetric_Dirichlet_energy_3 energy;
  const double sharpness = 3., radius = 1.2;
  const Energy_summary all =
      faces.measure<SP::Determinant_barrier_3, CGAL::Sequential_tag, true>(stars, energy, positions, radius, sharpness);
  Energy_summary expected(sharpness);
  std::size_t face = 0, n_above = 0;
  // Each vertex is a set of its own, so that the faces come in the order of their smallest vertices.
  mesh.rings().for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vector_3d u = positions[a], p = positions[b] - u, q = positions[c] - u, normal = cross(p, q);
    const Rest_triangle rest = rest_of_face(a, b, c);
    const double i = radius * radius *
                     (rest.opposite_0 * squared_length(q - p) + rest.opposite_1 * squared_length(q) +
                      rest.opposite_2 * squared_length(p));
    const double d = radius * radius * rest.inverse_area * dot(u, normal);
    const SP::Face_invariants_3& measured = faces.invariants()[face++];
    EXPECT_NEAR(measured.i, i, 1e-13 * i);
    EXPECT_NEAR(measured.d, d, 1e-13 * d);
    EXPECT_NEAR(measured.flat_d, radius * radius * rest.inverse_area * length(normal), 1e-13 * d);
    EXPECT_NEAR(measured.area * rest.inverse_area, 1., 1e-15);
    const double e = energy(i, d);
    expected.add_all<double>(&e, 1);
    n_above += energy(i, d) > 2.05;
  });
  ASSERT_EQ(face, faces.invariants().size());
  EXPECT_NEAR(all.average(), expected.average(), 1e-13 * expected.average());
  EXPECT_NEAR(all.largest(), expected.largest(), 1e-13 * expected.largest());
  EXPECT_NEAR(all.mean(), expected.mean(), 1e-12 * expected.mean());

  ASSERT_GT(n_above, 10u);
  ASSERT_LT(n_above, face);
  std::size_t n_told = 0;
  faces.for_each_above(energy, 2.05, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    EXPECT_TRUE(a < b && a < c && b != c);
    ++n_told;
    return true;
  });
  EXPECT_EQ(n_told, n_above);
  n_told = 0;
  faces.for_each_above(energy, 2.05, [&](std::uint32_t, std::uint32_t, std::uint32_t) { return ++n_told < 3; });
  EXPECT_EQ(n_told, 3u);
}

} // namespace
