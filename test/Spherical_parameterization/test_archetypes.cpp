// Archetypes of the concepts, which can do what the concepts ask for and nothing else, at every place where a model may
// stand: what compiles with them asks for no more than is documented. See test_concepts.cpp for what models change.

#include <CGAL/spherical_parameterization.h>

#include "archetypes/Distortion_energy.h"
#include "archetypes/Distortion_energy_in_lanes.h"
#include "archetypes/Face_range.h"
#include "archetypes/Sharpness_policy.h"
#include "archetypes/Sphere_radius_policy.h"
#include "archetypes/Spherical_parameterizer.h"
#include "archetypes/Vertex_energy.h"
#include "archetypes/Vertex_point_map.h"
#include "archetypes/Vertex_sphere_map.h"
#include "archetypes/Vertex_update.h"
#include "archetypes/Visitor.h"
#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <type_traits>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Default = CGAL::Default;

using archetypes::Copy_constructible;
using archetypes::Distortion_energy;
using archetypes::Distortion_energy_in_lanes;
using archetypes::Face_range;
using archetypes::Sharpness_policy;
using archetypes::Sphere_radius_policy;
using archetypes::Spherical_parameterizer;
using archetypes::Vertex_energy;
using archetypes::Vertex_update;
using archetypes::Visitor;
using Vertex_point_map = archetypes::Vertex_point_map<Mesh, Vertex, Point_3>;
using Vertex_sphere_map = archetypes::Vertex_sphere_map<Vertex, Point_3>;

constexpr Copy_constructible::Maker TEST = Copy_constructible::TEST;

// An archetype that could do more than its concept asks for would let more pass than it should.
template <class Archetype>
constexpr bool is_minimal =
    std::is_copy_constructible<Archetype>::value && !std::is_default_constructible<Archetype>::value &&
    !std::is_copy_assignable<Archetype>::value;
static_assert(is_minimal<Distortion_energy>, "");
static_assert(is_minimal<Distortion_energy_in_lanes>, "");
static_assert(is_minimal<Sharpness_policy>, "");
static_assert(is_minimal<Sphere_radius_policy>, "");
static_assert(is_minimal<Spherical_parameterizer>, "");
static_assert(is_minimal<Vertex_update>, "");
static_assert(is_minimal<Visitor>, "");
static_assert(is_minimal<Vertex_point_map>, "");
static_assert(is_minimal<Vertex_sphere_map>, "");

const Mesh& mesh()
{
  // so round that no method folds it, and not so round that there is nothing to do
  static const Mesh result = test_meshes::make_mesh<Mesh>(test_meshes::ellipsoid(1., 1.3, 0.8, 2));
  return result;
}

// Maps the mesh by a parameterizer, with archetypes for the property maps and the visitor.
template <class Parameterizer>
void expect_bijection(Parameterizer&& parameterizer)
{
  std::map<Vertex, Point_3> images;
  Visitor visitor(TEST);
  const Vertex_point_map points(mesh());
  ASSERT_EQ(SP::parameterize(mesh(), parameterizer, Vertex_sphere_map(images),
                             CGAL::parameters::vertex_point_map(points).visitor(std::ref(visitor))),
            SP::OK);
  EXPECT_EQ(images.size(), num_vertices(mesh()));
  EXPECT_TRUE(SP::is_bijective(mesh(), boost::make_assoc_property_map(images)));
}

TEST(Archetype, distortion_energy)
{
  const Distortion_energy energy(TEST);
  expect_bijection(SP::Bijective_low_distortion_parameterizer_3<Mesh, Default, Distortion_energy>(energy));
  expect_bijection(SP::Hierarchical_parameterizer_3<Mesh, Distortion_energy>(energy));
  expect_bijection(
      SP::Bijective_low_distortion_parameterizer_3<Mesh, Default, Distortion_energy, Default, SP::Optimal_radius_3>(
          energy));
}

TEST(Archetype, distortion_energy_in_lanes)
{
  const Distortion_energy_in_lanes energy(TEST);
  expect_bijection(SP::Bijective_low_distortion_parameterizer_3<Mesh, Default, Distortion_energy_in_lanes>(energy));
  expect_bijection(SP::Hierarchical_parameterizer_3<Mesh, Distortion_energy_in_lanes>(energy));
}

TEST(Archetype, sharpness_policy)
{
  const Sharpness_policy sharpness(TEST);
  expect_bijection(SP::Bijective_low_distortion_parameterizer_3<Mesh, Default, Default, Sharpness_policy>(
      SP::Symmetric_Dirichlet_energy_3(), sharpness));
  expect_bijection(
      SP::Hierarchical_parameterizer_3<Mesh, Default, Sharpness_policy>(SP::Isometric_energy_3(), sharpness));
  SP::Published_low_distortion_parameterizer_3<Mesh, Default, Sharpness_policy> published(
      SP::Harmonic_parameterizer_3<Mesh>(), sharpness);
  published.set_number_of_iterations(20);
  expect_bijection(published);
}

TEST(Archetype, sphere_radius_policy)
{
  const Sphere_radius_policy radius(TEST);
  expect_bijection(SP::Bijective_low_distortion_parameterizer_3<Mesh, Default, Default, Default, Sphere_radius_policy>(
      SP::Symmetric_Dirichlet_energy_3(), SP::Relative_sharpness_3(), radius));
  SP::Published_low_distortion_parameterizer_3<Mesh, Default, Default, Sphere_radius_policy> published(
      SP::Harmonic_parameterizer_3<Mesh>(), SP::Absolute_sharpness_3(), radius);
  published.set_number_of_iterations(20);
  expect_bijection(published);
  using Two_phases = SP::Two_phase_radius_3<Sphere_radius_policy, Sphere_radius_policy>;
  expect_bijection(SP::Bijective_low_distortion_parameterizer_3<Mesh, Default, Default, Default, Two_phases>(
      SP::Symmetric_Dirichlet_energy_3(), SP::Relative_sharpness_3(), Two_phases(radius, radius)));
}

// The other side: the package's own policies, called with archetypes of what they are promised
template <class Policy>
void expect_radius(Policy policy)
{
  const Face_range faces;
  const double radius = policy(Distortion_energy(TEST), faces, 2.);
  EXPECT_TRUE(radius > 0. && std::isfinite(radius));
}

TEST(Archetype, face_range)
{
  expect_radius(SP::Area_balancing_radius_3());
  expect_radius(SP::Area_preserving_radius_3());
  expect_radius(SP::Fixed_radius_3());
  expect_radius(SP::Optimal_radius_3());
  expect_radius(SP::Two_phase_radius_3<>());
  const Face_range faces;
  EXPECT_GT(SP::Symmetric_Dirichlet_energy_3().optimal_scale(faces), 0.);
  EXPECT_GT(SP::Isometric_energy_3().optimal_scale(faces), 0.);
}

TEST(Archetype, vertex_update)
{
  const Vertex_update update(TEST);
  expect_bijection(
      SP::Bijective_low_distortion_parameterizer_3<Mesh, Default, Default, Default, Default, Vertex_update>(
          SP::Symmetric_Dirichlet_energy_3(), SP::Relative_sharpness_3(), SP::Two_phase_radius_3<>(), update));
  expect_bijection(SP::Hierarchical_parameterizer_3<Mesh, Default, Default, Vertex_update>(
      SP::Isometric_energy_3(), SP::Relative_sharpness_3(), update));
}

TEST(Archetype, vertex_energy)
{
  const Vertex_energy energy(TEST);
  std::array<double, 2> step = {0., 0.};
  EXPECT_TRUE(SP::Newton_update_3(1.)(energy, step));
  EXPECT_NEAR(step[0], 0.1, 1e-15); // one Newton step leads to the minimum of a quadratic function
  EXPECT_NEAR(step[1], -0.2, 1e-15);
  EXPECT_TRUE(SP::Gradient_update_3()(energy, step));
  EXPECT_LT(energy(step[0], step[1]), energy(0., 0.));
}

TEST(Archetype, spherical_parameterizer)
{
  const Spherical_parameterizer initial(TEST);
  Spherical_parameterizer alone(initial);
  expect_bijection(alone);
  expect_bijection(SP::Bijective_low_distortion_parameterizer_3<Mesh, Spherical_parameterizer>(initial));
  SP::Published_low_distortion_parameterizer_3<Mesh, Spherical_parameterizer> published(initial);
  published.set_number_of_iterations(20);
  expect_bijection(published);
  expect_bijection(SP::ARAP_parameterizer_3<Mesh, Spherical_parameterizer>(initial));
}

TEST(Archetype, visitor_and_property_maps)
{
  expect_bijection(SP::Stereographic_parameterizer_3<Mesh>());
  expect_bijection(SP::Harmonic_parameterizer_3<Mesh>());
  expect_bijection(SP::Conformal_parameterizer_3<Mesh>());
  const Vertex_point_map start(mesh()); // the surface is star-shaped about the origin
  expect_bijection(SP::Precomputed_parameterizer_3<Mesh, Vertex_point_map>(start));

  // by value, and with the default method
  std::map<Vertex, Point_3> images;
  EXPECT_EQ(SP::parameterize(mesh(), Vertex_sphere_map(images), CGAL::parameters::visitor(Visitor(TEST))), SP::OK);
  EXPECT_EQ(images.size(), num_vertices(mesh()));
}

TEST(Archetype, measured_maps)
{
  const Vertex_point_map points(mesh());
  EXPECT_TRUE(SP::is_bijective(mesh(), points));
  const auto np = CGAL::parameters::vertex_point_map(points);
  EXPECT_EQ(SP::measure_distortion(mesh(), points, np).isometric.maximum, 1.);
  EXPECT_EQ(SP::find_defect(mesh(), np).error, SP::OK);
}

} // namespace
