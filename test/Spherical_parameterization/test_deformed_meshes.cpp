// Real meshes, stretched, sheared, twisted, crumpled and crushed beyond recognition: all of them get a certified
// bijection.

#include <CGAL/spherical_parameterization.h>

#include "fuzzing.h"
#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/config.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using fuzzing::Mesh;
using fuzzing::Outcome;
using fuzzing::Random;
using fuzzing::Seeds;
using fuzzing::Tally;
using test_meshes::Coordinates;
using test_meshes::Triangle;
using test_meshes::Triangle_list;

// of all tests of this file together
constexpr std::size_t number_of_deformations = 300;

double dot(const Coordinates& p, const Coordinates& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

// p + s d
Coordinates moved(const Coordinates& p, double s, const Coordinates& d)
{
  return {p[0] + s * d[0], p[1] + s * d[1], p[2] + s * d[2]};
}

// A mesh around the origin that gets deformed.
class Deformation
{
public:
  Deformation(const Triangle_list& list, Random& random)
    : m_list(list)
    , m_random(random)
  {
    Coordinates center = {0., 0., 0.};
    for(const Coordinates& p : m_list.points)
      center = moved(center, 1. / static_cast<double>(m_list.points.size()), p);
    for(Coordinates& p : m_list.points)
    {
      p = moved(p, -1., center);
      m_extent = (std::max)(m_extent, test_maps::norm(p));
    }
    for(const Triangle& t : m_list.triangles)
      m_edge +=
          test_maps::distance(m_list.points[t[0]], m_list.points[t[1]]) / static_cast<double>(m_list.triangles.size());
  }

  const Triangle_list& result() const { return m_list; }

  // along the axes, each by its own factor: a needle or a disc
  void scale()
  {
    std::array<double, 3> factors;
    for(double& f : factors)
      f = m_random.one_in(3) ? 1. : m_random.magnitude(-20, 0);
    m_list = test_meshes::scaled(m_list, factors[0], factors[1], factors[2]);
  }

  // each vertex by a vector of its own, of 1e-6 to 10 lengths of an edge
  void add_noise()
  {
    const double length = m_edge * m_random.magnitude(-20, 3) * 1.25;
    for(Coordinates& p : m_list.points)
      p = moved(p, length, m_random.in_ball());
  }

  // by 1e-6 to 1e6 along any direction
  void stretch()
  {
    const Coordinates d = m_random.direction();
    const double factor = m_random.magnitude(-20, 20);
    for(Coordinates& p : m_list.points)
      p = moved(p, (factor - 1.) * dot(p, d), d);
  }

  void shear()
  {
    const Coordinates d = m_random.direction(), e = m_random.direction();
    const double factor = m_random.magnitude(-1, 14);
    for(Coordinates& p : m_list.points)
      p = moved(p, factor * dot(p, d), e);
  }

  // around the z-axis, by up to 30 turns
  void twist()
  {
    const double turns = m_random.between(0.1, 30.);
    for(Coordinates& p : m_list.points)
    {
      const double angle = test_meshes::pi * turns * p[2] / m_extent;
      p = {std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1], p[2]};
    }
  }

  // some vertices far away from the centre
  void add_spikes()
  {
    const std::size_t n_spikes = 1 + m_random.below(50);
    const double factor = m_random.magnitude(1, 13);
    for(std::size_t i = 0; i < n_spikes; ++i)
    {
      Coordinates& p = m_list.points[m_random.below(m_list.points.size())];
      p = moved(p, factor * m_random.unit(), p);
    }
  }

  // a region, from a few vertices up to all of them, to a point or a line, or nearly so
  void collapse()
  {
    const Coordinates c = m_list.points[m_random.below(m_list.points.size())], d = m_random.direction();
    const double radius = (std::max)(m_extent * m_random.between(0.05, 2.), 2. * m_edge);
    const double rest = m_random.one_in(2) ? 0. : m_random.magnitude(-50, -4);
    const bool is_line = m_random.one_in(2);
    for(Coordinates& p : m_list.points)
      if(test_maps::distance(p, c) < radius)
      {
        const Coordinates q = is_line ? moved(c, dot(p, d) - dot(c, d), d) : c;
        p = moved(q, rest, moved(p, -1., q));
      }
  }

private:
  Triangle_list m_list;
  Random& m_random;
  double m_extent = 0., m_edge = 0.; // the largest distance from the origin, the average length of an edge
};

// Deforms a mesh in one or two ways, and says which.
Triangle_list deformed(const Triangle_list& list, Random& random, std::string& kind)
{
  struct Way
  {
    const char* name;
    void (Deformation::*deform)();
  };
  static constexpr Way ways[] = {{"scaled", &Deformation::scale},      {"noisy", &Deformation::add_noise},
                                 {"stretched", &Deformation::stretch}, {"sheared", &Deformation::shear},
                                 {"twisted", &Deformation::twist},     {"spiked", &Deformation::add_spikes},
                                 {"collapsed", &Deformation::collapse}};
  constexpr std::size_t n_ways = sizeof(ways) / sizeof(ways[0]);
  Deformation deformation(list, random);
  const std::size_t first = random.below(n_ways);
  (deformation.*ways[first].deform)();
  kind = ways[first].name;
  if(random.one_in(4))
  {
    const std::size_t second = random.below(n_ways);
    (deformation.*ways[second].deform)();
    kind = "two of these";
  }
  return deformation.result();
}

struct Named_mesh
{
  std::string name;
  Triangle_list list;
};

// The meshes of those files that are there.
std::vector<Named_mesh> read(const std::string& folder, const std::vector<std::string>& names)
{
  std::vector<Named_mesh> result;
  for(const std::string& name : names)
  {
    const std::string file = folder + name + ".off";
    std::vector<fuzzing::Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
    if(!std::filesystem::exists(file) || !CGAL::IO::read_polygon_soup(file, points, polygons))
      continue;
    Triangle_list list;
    for(const fuzzing::Point_3& p : points)
      list.points.push_back({p.x(), p.y(), p.z()});
    for(const std::vector<std::size_t>& t : polygons)
      list.triangles.push_back({t.at(0), t.at(1), t.at(2)});
    result.push_back({name, std::move(list)});
  }
  return result;
}

void expect_all_mapped(const Seeds& seeds, const std::vector<Named_mesh>& meshes)
{
  Tally tally;
  for(std::size_t i = 0; i < seeds.size(); ++i)
  {
    Random random(seeds[i]);
    const Named_mesh& mesh = meshes[random.below(meshes.size())];
    std::string kind;
    const Triangle_list list = deformed(mesh.list, random, kind);
    const std::string description = fuzzing::how_to_repeat(seeds[i], mesh.name + ", " + kind);
    SP::Bijective_low_distortion_parameterizer_3<Mesh> parameterizer;
    const unsigned int most_iterations = list.points.size() < 1000 ? 100u : 5u;
    const Outcome outcome = fuzzing::run<CGAL::Sequential_tag>(list, parameterizer, most_iterations, description);
    tally.add({kind, "mesh: " + mesh.name}, outcome, seeds[i], description);
  }
  tally.print();
  EXPECT_EQ(tally.size(), seeds.size());
  EXPECT_EQ(tally.number_of_refusals(), 0u) << tally.refusals();
}

TEST(Deformations, change_the_shape)
{
  const Triangle_list list = test_meshes::bumpy_sphere(2);
  std::set<std::string> kinds;
  for(std::uint64_t seed = 0; seed < 200; ++seed)
  {
    Random random(seed);
    std::string kind;
    const Triangle_list result = deformed(list, random, kind);
    SCOPED_TRACE(kind);
    kinds.insert(kind);
    ASSERT_EQ(result.triangles, list.triangles);
    ASSERT_EQ(result.points.size(), list.points.size());
    std::size_t n_moved = 0;
    for(std::size_t v = 0; v < list.points.size(); ++v)
    {
      const Coordinates &p = result.points[v], &q = list.points[v];
      ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
      // relative to another vertex, as moving the whole surface is no deformation
      const Coordinates &p0 = result.points[v / 2], &q0 = list.points[v / 2];
      n_moved += std::abs(test_maps::distance(p, p0) - test_maps::distance(q, q0)) > 1e-9;
    }
    EXPECT_GE(n_moved, 1u);
  }
  EXPECT_EQ(kinds.size(), 8u);
}

TEST(Deformed_meshes, made_for_tests_are_mapped)
{
  expect_all_mapped(Seeds(number_of_deformations, 40. / 300., 30000000),
                    {{"bumpy sphere", test_meshes::bumpy_sphere(3)},
                     {"tentacle", test_meshes::with_tentacle(60, 6.)},
                     {"random stacked sphere", test_meshes::random_stacked_sphere(500, 1)}});
}

void expect_all_files_mapped(const Seeds& seeds, const std::string& folder, const std::vector<std::string>& names)
{
  const std::vector<Named_mesh> meshes = read(folder, names);
  if(meshes.empty())
    GTEST_SKIP() << "There is no folder of meshes.";
  EXPECT_GE(2 * meshes.size(), names.size());
  expect_all_mapped(seeds, meshes);
}

// CGAL's own data.
TEST(Deformed_meshes, of_the_library_are_mapped)
{
  expect_all_files_mapped(Seeds(number_of_deformations, 200. / 300., 10000000), CGAL::data_file_path("meshes/"),
                          {"star",    "cross",  "u",     "dragknob",    "part",    "oblong",      "cactus",
                           "spool",   "handle", "hand",  "ellipe0.003", "blobby",  "triceratops", "cow",
                           "retinal", "dino",   "homer", "bull",        "fandisk", "camel"});
}

TEST(Deformed_meshes, of_the_shared_folder_are_mapped)
{
  expect_all_files_mapped(Seeds(number_of_deformations, 60. / 300., 20000000),
                          std::string(SPHERICAL_PARAMETERIZATION_SHARED_DATA_DIR) + "/meshes/",
                          {"fandisk_606", "spot_2930", "bunny_3485", "shrec391_steer_4315", "screwdriver_6789",
                           "shrec381_cow2_6938", "blub_7106", "cat_stretch_7949", "buste_8160"});
}

} // namespace
