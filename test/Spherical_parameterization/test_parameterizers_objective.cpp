// The objective of the default method over whole runs: it never rises, its end is an end, isometries are found, and slivers
// own neither the radius nor the other faces.

#include "engine.h"
#include "methods.h"
#include "random_meshes.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

using namespace test;

namespace {

Method with_dial(double beta)
{
  return Method("dial", SP::Bijective_low_distortion_parameterizer_3().sharpness(SP::Sharpness::relative(beta)));
}

// Cuts the face `k` by a vertex next to the middle of its first edge: one of the three parts is a cap.
Triangle_list with_cap(Triangle_list list, std::size_t k)
{
  const Triangle t = list.triangles[k];
  const Coordinates a = list.points[t[0]], b = list.points[t[1]], c = list.points[t[2]];
  split_face(list, k, combination(1. - 1e-4, combination(0.5, a, 0.5, b), 1e-4, c));
  return list;
}

struct Named_mesh
{
  std::string name;
  Mesh mesh;
};

std::vector<Named_mesh> small_meshes()
{
  return {{"cube", make(list_of(SP::Sphere_domain_3::cube(1)))},
          {"tentacle", make(with_tentacle(30, 6.))},
          {"ellipsoid", make(ellipsoid(1., 1., 9., 3))},
          {"stacked", make(random_stacked_sphere(300, 1))},
          {"bumpy", make(bumpy_sphere(3))},
          {"caps", make(with_cap(with_cap(bumpy_sphere(3), 17), 400))},
          {"slivers", make(with_slivers(bumpy_sphere(3), 10, 1e-5))},
          {"slivers of an extremity", make(with_slivers(with_tentacle(30, 6.), 4, 1e-3))}};
}

// The dial may be turned once, which changes the objective.
void expect_no_rise(const Method& method, const Mesh& mesh, bool turns_dial = false)
{
  Recorder recorder;
  EXPECT_EQ(method.run(mesh, Options().visitor(recorder)).error, SP::OK);
  const std::vector<Recorder::Event> iterations = recorder.all("iteration");
  ASSERT_GT(iterations.size(), 1u);
  // Faces that have 1e-10 of their areas are measured to four digits.
  const auto rounding = [](double energy) { return energy < 1e15 ? 1e-12 : 1e-4; };
  std::size_t n_rises = 0;
  for(std::size_t i = 1; i < iterations.size(); ++i)
    n_rises += iterations[i].energy > iterations[i - 1].energy * (1. + rounding(iterations[i].energy));
  EXPECT_LE(n_rises, turns_dial ? 1u : 0u);
}

// Splits the faces above 2 in three, in their planes.
Triangle_list with_split_cap(Triangle_list list)
{
  const std::size_t n = list.triangles.size();
  for(std::size_t k = 0; k < n; ++k)
  {
    const Coordinates c = centroid(list, list.triangles[k]);
    if(c[2] >= 2.)
      split_face(list, k, c);
  }
  return list;
}

// The share of the sphere that the faces above 2 have.
double share_of_cap(const Method& method, const Triangle_list& list)
{
  const Result result = method.run(list);
  EXPECT_EQ(result.error, SP::OK);
  double cap = 0., all = 0.;
  for(const Triangle& t : list.triangles)
  {
    const double share = area(result.images[t[0]], result.images[t[1]], result.images[t[2]]);
    all += share;
    if(centroid(list, t)[2] >= 2.)
      cap += share;
  }
  return cap / all;
}

// Faces that count by their areas count together as the one that they are parts of.
TEST(Stretch_energy, hardly_depends_on_how_flat_faces_are_split)
{
  const Triangle_list whole = ellipsoid(1., 1., 4., 3), split = with_split_cap(whole);
  ASSERT_GT(split.points.size(), whole.points.size() + 50);
  const double share = share_of_cap(sampling(), whole);
  EXPECT_NEAR(share_of_cap(sampling(), split) / share, 1., 0.15); // 1.44 if each face counts the same
  EXPECT_GT(share, 1.25 * share_of_cap(bijective(), whole)); // What is curved gets samples: 1.17 without the curvature.
}

// Vertices, radius, level: no step may take back what the others have gained.
TEST(Objective, never_rises)
{
  std::vector<Named_mesh> meshes = small_meshes();
  for(std::uint64_t seed = 1; seed <= 12; ++seed)
    meshes.push_back({"random " + std::to_string(seed), make(random_mesh(seed).list)});
  const std::filesystem::path folder = std::filesystem::path(SPHERICAL_PARAMETERIZATION_SHARED_DATA_DIR) / "meshes";
  for(const char* name : {"cow_2904.off", "triceratops_2832.off"})
  {
    Named_mesh shared{name, {}};
    if(CGAL::IO::read_polygon_mesh((folder / name).string(), shared.mesh))
      meshes.push_back(shared);
  }
  const Method stretch("stretch", SP::Bijective_low_distortion_parameterizer_3().energy(SP::Stretch_energy_3()));
  for(const Named_mesh& m : small_meshes())
  {
    SCOPED_TRACE(m.name);
    expect_no_rise(stretch, m.mesh); // Levels and radius follow the areas as well.
  }
  for(const Named_mesh& m : meshes)
    for(const double beta : {0., 3., 20., 50.})
    {
      if(beta < 20. && m.mesh.number_of_vertices() > 2000)
        continue;
      SCOPED_TRACE(m.name + ", " + std::to_string(beta));
      expect_no_rise(with_dial(beta), m.mesh, beta > 20.);
    }
}

// The radius of the map is that of the lowest sum over flat areas: of the plain sum of I + I / d^2, where both parts are
// the same.
TEST(Objective, chooses_the_radius_of_the_map_as_it_is_measured)
{
  const Triangle_list list = bumpy_sphere(2);
  const Result result = with_dial(0.).run(list);
  double sum = 0., sum_of_inverses = 0.;
  for(const Triangle& t : list.triangles)
  {
    const SP::internal::Rest_triangle rest =
        SP::internal::Rest_triangle::from_points(list.points[t[0]], list.points[t[1]], list.points[t[2]]);
    const Coordinates &p = result.images[t[0]], &q = result.images[t[1]], &r = result.images[t[2]];
    const auto squared = [](double x) { return x * x; };
    const double i = rest.opposite_0 * squared(distance(q, r)) + rest.opposite_1 * squared(distance(r, p)) +
                     rest.opposite_2 * squared(distance(p, q));
    sum += i;
    sum_of_inverses += i / squared(2. * area(p, q, r) * rest.inverse_doubled_area);
  }
  EXPECT_NEAR(sum / sum_of_inverses, 1., 1e-10);
}

TEST(Objective, has_its_end_at_isometries)
{
  for(const Triangle_list& list : {tetrahedron(), octahedron(), icosphere(0)})
  {
    const Result result = bijective().run(scaled(list, 7., 7., 7.));
    EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
    EXPECT_LT(result.distortion.isometric.maximum, 1. + 1e-9);
    EXPECT_NEAR(result.report.radius, 7., 1e-8);
  }
}

// Faces may be many times as long as the sphere is wide.
TEST(Objective, suits_coarse_and_long_meshes)
{
  EXPECT_LT(bijective().run(scaled(octahedron(), 1., 1., 100.)).distortion.isometric.maximum, 10.);
  EXPECT_LT(bijective().run(scaled(icosphere(0), 1., 1., 100.)).distortion.isometric.maximum, 10.);
}

TEST(Objective, of_small_meshes_is_brought_to_its_end)
{
  for(const Named_mesh& m : small_meshes())
    EXPECT_EQ(bijective().run(m.mesh).report.stop_reason, SP::CONVERGED) << m.name;
  for(const Triangle_list& list : {bumpy_sphere(2), with_tentacle(6, 6.), random_stacked_sphere(300, 8)})
  {
    const Result result = bijective().run(list);
    EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
    const Result longer = Method("longer", SP::Bijective_low_distortion_parameterizer_3().tolerances(0., 0.))
                              .run(list, Options().iterations(5000));
    EXPECT_NEAR(longer.distortion.isometric.average / result.distortion.isometric.average, 1., 0.03);
    EXPECT_NEAR(longer.distortion.isometric.maximum / result.distortion.isometric.maximum, 1., 0.05);
  }
}

// Faces without area, which have no distortion, have neither a say in what the others get, nor in the radius.
TEST(Objective, gives_the_others_what_they_had_without_flat_faces)
{
  const Triangle_list list = bumpy_sphere(3);
  const Result without = bijective().run(list);
  for(const std::size_t shift : {0u, 400u, 1000u})
  {
    Triangle_list rotated = list; // its first edge gets the needle
    std::rotate(rotated.triangles.begin(), rotated.triangles.begin() + static_cast<std::ptrdiff_t>(shift),
                rotated.triangles.end());
    const Mesh mesh = make(with_slivers(rotated, 1, 1e-14));
    const Result with = bijective().run(mesh);
    EXPECT_EQ(with.distortion.number_of_degenerate_faces, 2u);
    EXPECT_NEAR(with.distortion.isometric.average / without.distortion.isometric.average, 1., 0.01) << shift;
    EXPECT_NEAR(with.distortion.isometric.maximum / without.distortion.isometric.maximum, 1., 0.1) << shift;
    EXPECT_NEAR(with.report.radius / without.report.radius, 1., 0.02) << shift;
    EXPECT_NEAR(with.report.sharpness / without.report.sharpness, 1., 0.1) << shift;
  }
}

TEST(Objective, with_slivers_is_the_same_with_any_number_of_threads)
{
  const Mesh mesh = make(with_slivers(bumpy_sphere(4), 40, 1e-5));
  EXPECT_TRUE(have_same_bits(bijective().run(mesh).images, bijective().run(mesh, Options().sequential()).images));
}

TEST(Objective, takes_any_dial)
{
  for(const double beta : {1e-6, 1e-3, 1e3, 1e6})
  {
    const Result result = with_dial(beta).run(bumpy_sphere(2), Options().iterations(30));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_TRUE(std::isfinite(result.report.average_energy));
    EXPECT_LT(result.report.average_energy, 1.2 * result.report.initial_energy);
  }
}

} // namespace
