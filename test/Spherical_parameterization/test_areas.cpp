// Areas as wanted: the areas of spherical triangles and their derivatives, the shares of the parts of a surface, and maps that
// meet them, as far as they can be met.

#include <CGAL/Spherical_parameterization/Target_area_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/internal/areas/Area_shares.h>

#include "methods.h"
#include "random_meshes.h"

#include <CGAL/Polyhedron_3.h>

using namespace test;

namespace {

using SP::Area_report;
using SP::internal::cross;
using SP::internal::dot;
using SP::internal::length;
using SP::internal::normalized;
using SP::internal::operator-;
using SP::internal::operator+;
using SP::internal::operator*;
using SP::internal::Spherical_area;
using SP::internal::Vector_3d;

using Vertex_index = Mesh::Vertex_index;
using Face_index = Mesh::Face_index;
using Sphere_map = Mesh::Property_map<Vertex_index, Point_3>;

// ---------------------------------------------------------------------------------------------------------------------
// Areas of spherical triangles

TEST(Spherical_area, is_that_of_an_octant)
{
  const Vector_3d x = {1., 0., 0.}, y = {0., 1., 0.}, z = {0., 0., 1.};
  EXPECT_NEAR(Spherical_area(x, y, z).value(), pi / 2., 1e-15);
  EXPECT_NEAR(Spherical_area(x, z, y).value(), -pi / 2., 1e-15);
}

TEST(Spherical_area, keeps_its_precision_on_small_triangles)
{
  const Vector_3d x = normalized(Vector_3d{1., 2., 3.});
  const SP::internal::Tangent_frame frame(x);
  for(const double size : {1e-3, 1e-6, 1e-9})
  {
    const Vector_3d p = normalized(x + frame.vector_of(size, 0.)), q = normalized(x + frame.vector_of(0., size));
    EXPECT_NEAR(Spherical_area(x, p, q).value() / (0.5 * size * size), 1., size + 1e-6);
  }
}

TEST(Spherical_area, has_the_gradient_of_difference_quotients)
{
  Random random(1);
  for(int k = 0; k < 100; ++k)
  {
    const Vector_3d x = random.direction(), p = random.direction(), q = random.direction(), along = random.direction();
    const Vector_3d tangent = along - dot(along, x) * x;
    constexpr double h = 1e-5;
    const auto area_at = [&](double t) { return Spherical_area(normalized(x + t * tangent), p, q).value(); };
    const double quotient = (area_at(h) - area_at(-h)) / (2. * h);
    const Vector_3d gradient = Spherical_area(x, p, q).gradient(x);
    EXPECT_NEAR(dot(gradient, x), 0., 1e-9 * (1. + length(gradient)));
    const bool is_smooth = length(gradient) < 10.; // elsewhere, they are near where the area leaps
    EXPECT_TRUE(!is_smooth || std::abs(dot(gradient, tangent) - quotient) < 1e-6);
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// Maps

// The areas of the cells of the map over the mean, by the angles of triangles, in the order of the vertices.
std::vector<double> cell_areas(const Mesh& mesh, const Sphere_map& sphere)
{
  std::vector<double> result(num_vertices(mesh), 0.);
  for(const auto f : faces(mesh))
  {
    std::vector<Vector_3d> corners;
    std::vector<std::size_t> vertices;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
    {
      corners.push_back(SP::internal::direction_of(sphere[v]));
      vertices.push_back(v);
    }
    // Girard: the excess of the angles, between the planes through the sides
    double excess = -pi;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Vector_3d to_next = cross(corners[k], corners[(k + 1) % 3]),
                      to_last = cross(corners[k], corners[(k + 2) % 3]);
      excess += std::atan2(length(cross(to_next, to_last)), dot(to_next, to_last));
    }
    for(const std::size_t v : vertices)
      result[v] += excess / 3.;
  }
  return result;
}

// What is wanted of them, by the densities of the faces.
template <class Density>
std::vector<double> wanted_areas(const Mesh& mesh, const Density& density)
{
  std::vector<double> result(num_vertices(mesh), 0.);
  double sum = 0.;
  for(const auto f : faces(mesh))
  {
    std::vector<Vertex_index> v;
    for(const auto w : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      v.push_back(w);
    const double share =
        std::sqrt(CGAL::squared_area(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]))) * density(f);
    for(const auto w : v)
      result[w] += share / 3.;
    sum += share;
  }
  for(double& area : result)
    area *= 4. * pi / sum;
  return result;
}

Sphere_map sphere_of(Mesh& mesh)
{
  return mesh.add_property_map<Vertex_index, Point_3>("v:sphere", Point_3(0., 0., 0.)).first;
}

void expect_report(const Mesh& mesh, const Sphere_map& sphere, const Area_report& report,
                   const std::vector<double>& wanted)
{
  const std::vector<double> areas = cell_areas(mesh, sphere);
  ASSERT_EQ(report.ratios.size(), areas.size());
  double largest = 0.;
  for(std::size_t v = 0; v < areas.size(); ++v)
  {
    EXPECT_NEAR(report.ratios[v], areas[v] / wanted[v], 1e-6);
    largest = (std::max)(largest, std::abs(report.ratios[v] - 1.));
  }
  EXPECT_DOUBLE_EQ(report.largest_deviation, largest);
  EXPECT_LE(report.deviation, largest);
  EXPECT_TRUE(SP::is_bijective(mesh, sphere));
}

TEST(Target_areas, are_equal)
{
  for(const Triangle_list& list : {tetrahedron(), bumpy_sphere(3), with_tentacle(20, 3.)})
  {
    Mesh mesh = make(list);
    const Sphere_map sphere = sphere_of(mesh);
    SP::Target_area_parameterizer_3<> method;
    ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
    const Area_report& report = method.area_report();
    EXPECT_TRUE(report.is_reached());
    EXPECT_LE(report.deviation, 5e-4);
    EXPECT_EQ(report.number_of_raised_faces, 0u);
    EXPECT_EQ(method.report().stop_reason, SP::CONVERGED);
    expect_report(mesh, sphere, report, wanted_areas(mesh, [](Face_index) { return 1.; }));
  }
}

TEST(Target_areas, are_as_near_as_they_are_asked_for)
{
  Mesh mesh = make(bumpy_sphere(3));
  const Sphere_map sphere = sphere_of(mesh);
  auto method = SP::Target_area_parameterizer_3<>().area_tolerance(1e-6);
  ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
  EXPECT_LE(method.area_report().deviation, 1e-6);
}

TEST(Target_areas, follow_densities_of_faces_and_vertices)
{
  Mesh mesh = make(bumpy_sphere(3));
  const Sphere_map sphere = sphere_of(mesh);
  const auto of_vertices = mesh.add_property_map<Vertex_index, double>("v:density").first;
  const auto of_faces = mesh.add_property_map<Face_index, float>("f:density").first;
  for(const auto v : vertices(mesh))
    of_vertices[v] = mesh.point(v).x() > 0. ? 10. : 1.;
  for(const auto f : faces(mesh))
  {
    float sum = 0.f;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      sum += static_cast<float>(of_vertices[v]);
    of_faces[f] = 7.f * sum; // in any unit
  }
  auto by_vertices = SP::Target_area_parameterizer_3<>().target_density(of_vertices);
  ASSERT_EQ(SP::parameterize(mesh, by_vertices, sphere), SP::OK);
  const std::vector<double> wanted = wanted_areas(mesh, [&](Face_index f) { return static_cast<double>(of_faces[f]); });
  EXPECT_TRUE(by_vertices.area_report().is_reached());
  expect_report(mesh, sphere, by_vertices.area_report(), wanted);

  auto by_faces = SP::Target_area_parameterizer_3<>().energy(SP::Conformal_energy_3()).target_density(of_faces);
  ASSERT_EQ(SP::parameterize(mesh, by_faces, sphere), SP::OK);
  EXPECT_TRUE(by_faces.area_report().is_reached());
  expect_report(mesh, sphere, by_faces.area_report(), wanted);
}

TEST(Target_areas, are_those_of_any_mesh_type)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Point_3 points[4] = {{0., 0., 0.}, {1., 0., 0.}, {0., 2., 0.}, {0., 0., 3.}};
  Polyhedron mesh;
  mesh.make_tetrahedron(points[0], points[1], points[2], points[3]);
  std::map<Polyhedron::Facet_const_handle, int> density;
  for(auto f = mesh.facets_begin(); f != mesh.facets_end(); ++f)
    density[f] = 2;
  std::map<Polyhedron::Vertex_const_handle, Point_3> sphere;
  auto method = SP::Target_area_parameterizer_3<>().target_density(boost::make_assoc_property_map(density));
  ASSERT_EQ(SP::parameterize(mesh, method, boost::make_assoc_property_map(sphere)), SP::OK);
  EXPECT_TRUE(method.area_report().is_reached());
}

TEST(Target_areas, are_told_where_they_cannot_be_had)
{
  // The face of three of the four vertices would be more than half of the sphere.
  Mesh mesh = make(tetrahedron());
  const Sphere_map sphere = sphere_of(mesh);
  const auto density = mesh.add_property_map<Face_index, double>("f:density", 1.).first;
  const Face_index large = *faces(mesh).begin();
  density[large] = 27.;
  auto method = SP::Target_area_parameterizer_3<>().target_density(density);
  ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
  const Area_report& report = method.area_report();
  EXPECT_FALSE(report.is_reached());
  EXPECT_EQ(report.number_of_off_vertices, 4u);
  for(const auto v : vertices(mesh))
  {
    const auto around = CGAL::vertices_around_face(halfedge(large, mesh), mesh);
    const bool is_corner = std::find(around.begin(), around.end(), v) != around.end();
    EXPECT_EQ(report.ratios[v] < 1., is_corner);
  }
  expect_report(mesh, sphere, report, wanted_areas(mesh, [&](Face_index f) { return density[f]; }));
}

TEST(Target_areas, may_be_of_a_contrast_of_a_million_or_zero)
{
  Mesh mesh = make(bumpy_sphere(2));
  const Sphere_map sphere = sphere_of(mesh);
  const auto density = mesh.add_property_map<Vertex_index, double>("v:density").first;
  for(const auto v : vertices(mesh))
    density[v] = std::pow(1e6, 0.5 + 0.5 * mesh.point(v).x());
  auto method = SP::Target_area_parameterizer_3<>().target_density(density);
  ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, sphere));
  EXPECT_LE(method.area_report().deviation, 0.1);

  for(const auto v : vertices(mesh))
    density[v] = mesh.point(v).x() > 0. ? 1e300 : 0.;
  ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, sphere));
  EXPECT_GT(method.area_report().number_of_raised_faces, num_faces(mesh) / 3);
  EXPECT_LT(method.area_report().number_of_raised_faces, num_faces(mesh) / 2);
}

TEST(Target_areas, are_refused_where_densities_are_none)
{
  Mesh mesh = make(bumpy_sphere(1));
  const Sphere_map sphere = sphere_of(mesh);
  const auto of_vertices = mesh.add_property_map<Vertex_index, double>("v:density", 1.).first;
  const auto of_faces = mesh.add_property_map<Face_index, double>("f:density", 1.).first;
  const auto expect_refusal = [&] {
    auto by_vertices = SP::Target_area_parameterizer_3<>().target_density(of_vertices);
    EXPECT_EQ(SP::parameterize(mesh, by_vertices, sphere), SP::ERROR_INVALID_DENSITY);
    auto by_faces = SP::Target_area_parameterizer_3<>().target_density(of_faces);
    EXPECT_EQ(SP::parameterize(mesh, by_faces, sphere), SP::ERROR_INVALID_DENSITY);
    for(const auto v : vertices(mesh))
      EXPECT_EQ(sphere[v], Point_3(0., 0., 0.));
    EXPECT_TRUE(by_faces.area_report().ratios.empty());
  };
  for(const double bad : {-1e-300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    of_vertices[Vertex_index(5)] = of_faces[Face_index(5)] = bad;
    expect_refusal();
  }
  for(const auto v : vertices(mesh))
    of_vertices[v] = 0.;
  for(const auto f : faces(mesh))
    of_faces[f] = 0.;
  expect_refusal();
  auto method = SP::Target_area_parameterizer_3<>().area_tolerance(-1.);
  EXPECT_EQ(SP::parameterize(mesh, method, sphere), SP::ERROR_WRONG_PARAMETER);
}

TEST(Target_areas, are_the_same_with_any_number_of_threads)
{
  Mesh mesh = make(bumpy_sphere(4));
  const Sphere_map sphere = sphere_of(mesh);
  SP::Target_area_parameterizer_3<> method;
  ASSERT_EQ(SP::parameterize<CGAL::Sequential_tag>(mesh, method, sphere), SP::OK);
  const std::vector<double> ratios = method.area_report().ratios;
  const std::vector<Point_3> images(sphere.begin(), sphere.end());
  ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
  EXPECT_EQ(ratios, method.area_report().ratios);
  EXPECT_EQ(images, std::vector<Point_3>(sphere.begin(), sphere.end()));
}

TEST(Target_areas, may_be_stopped_at_any_time)
{
  Mesh mesh = make(bumpy_sphere(2));
  const Sphere_map sphere = sphere_of(mesh);
  const auto density = mesh.add_property_map<Vertex_index, double>("v:density").first;
  for(const auto v : vertices(mesh))
    density[v] = std::exp(2. * mesh.point(v).y());
  auto method = SP::Target_area_parameterizer_3<>().target_density(density);
  Recorder all;
  ASSERT_EQ(SP::parameterize(mesh, method, sphere, CGAL::parameters::visitor(std::ref(all))), SP::OK);
  EXPECT_TRUE(method.area_report().is_reached());
  EXPECT_EQ(all.events.back().name, "optimization_end");
  EXPECT_EQ(all.all("optimization_end").size(), 1u);
  const auto iterations = all.all("iteration");
  EXPECT_EQ(iterations.size(), method.report().number_of_iterations());
  for(std::size_t k = 0; k < iterations.size(); ++k)
    EXPECT_EQ(iterations[k].number, k + 1);

  double deviation = std::numeric_limits<double>::infinity();
  for(std::size_t k = all.number_of_questions - method.area_report().number_of_steps; k <= all.number_of_questions; ++k)
  {
    Recorder some(k);
    ASSERT_EQ(SP::parameterize(mesh, method, sphere, CGAL::parameters::visitor(std::ref(some))), SP::OK);
    EXPECT_EQ(method.report().stop_reason, SP::STOPPED);
    EXPECT_TRUE(SP::is_bijective(mesh, sphere));
    EXPECT_EQ(some.number_of_questions, k);
    EXPECT_LT(method.area_report().deviation, deviation);
    deviation = method.area_report().deviation;
  }
}

} // namespace
