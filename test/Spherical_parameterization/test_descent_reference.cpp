// The descent of the package against the reference implementation of its method: both end at the same value of the same
// objective.

#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include "engine.h"
#include "indexed_meshes.h"
#include "judge.h"
#include "methods.h"
#include "random_meshes.h"
#include "reference_method.h"

using namespace test;

namespace {

Reference_method::Vectors vectors(const Images& points)
{
  Reference_method::Vectors result;
  for(const Coordinates& p : points)
    result.emplace_back(p[0], p[1], p[2]);
  return result;
}

// The reference starts from Schnyder's map, far from the end. The package converges with small tolerances to the same
// value, and with the default ones to at most 0.2 % more.
void expect_same_minimum(const Triangle_list& list, double beta)
{
  const auto method = SP::Bijective_low_distortion_parameterizer_3().sharpness(SP::Sharpness::relative(beta));
  Recorder recorder;
  const Options options = Options().iterations(20000).visitor(recorder);
  const Result with_defaults = Method("default", method).run(list),
               converged = Method("converged", method.tolerances(1e-9, 1e-9)).run(list, options);
  ASSERT_EQ(with_defaults.error, SP::OK);
  ASSERT_EQ(converged.error, SP::OK);

  Reference_method reference(vectors(list.points), list.triangles, beta);
  reference.set_map(vectors(directions_of(schnyder().run(list).images)));
  reference.minimize(1e-9);
  Images images;
  for(const Reference_method::Vector& p : reference.map())
    images.push_back({p[0], p[1], p[2]});
  EXPECT_TRUE(judge::is_one_to_one(images, list.triangles));

  const double expected = reference.phi(), tolerance = 1e-6 * expected;
  EXPECT_NEAR(recorder.all("iteration").back().energy, expected, tolerance); // at the radius and the level of the run
  reference.set_map(vectors(directions_of(converged.images)));
  EXPECT_NEAR(reference.phi(), expected, tolerance);
  reference.set_map(vectors(directions_of(with_defaults.images)));
  EXPECT_GT(reference.phi(), expected - tolerance);
  EXPECT_LT(reference.phi(), 1.002 * expected);
}

TEST(Reference_method, has_the_same_minimum_on_known_meshes)
{
  for(const Triangle_list& list : {tetrahedron(), scaled(octahedron(), 1., 2., 4.), icosphere(1),
                                   ellipsoid(1., 2., 3., 2), bumpy_sphere(2), random_stacked_sphere(40, 3)})
    for(const double beta : {0., 20., 40.})
    {
      SCOPED_TRACE(std::to_string(list.points.size()) + " vertices, dial " + std::to_string(beta));
      expect_same_minimum(list, beta);
    }
}

// The reference takes long on large meshes; the objective has several minima on the most
// distorted ones.
TEST(Reference_method, has_the_same_minimum_on_random_meshes)
{
  constexpr std::size_t max_size = 80;
  constexpr double max_average_energy = 6.;
  std::size_t n_compared = 0;
  for(std::uint64_t seed = 1; seed <= 120; ++seed)
  {
    const Random_mesh mesh = random_mesh(seed);
    const Surface surface = surface_of(mesh.list);
    if(mesh.list.points.size() > max_size || surface.number_of_flat_faces() > 0 ||
       bijective().run(mesh.list).report.average_energy > max_average_energy)
      continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + mesh.kind);
    expect_same_minimum(mesh.list, 20.);
    ++n_compared;
  }
  EXPECT_GE(n_compared, 10u);
}

} // namespace
