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
using namespace SP::internal; // whose arithmetic of vectors this file uses
using SP::internal::cross;
using SP::internal::dot;
using SP::internal::normalized;

using Vertex_index = Mesh::Vertex_index;
using Face_index = Mesh::Face_index;
using Sphere_map = Mesh::Property_map<Vertex_index, Point_3>;

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

std::vector<Vertex_index> corners_of(const Mesh& mesh, Face_index f)
{
  const auto h = halfedge(f, mesh);
  return {source(h, mesh), target(h, mesh), target(next(h, mesh), mesh)};
}

// The areas of the cells of the map, in the order of the vertices.
std::vector<double> cell_areas(const Mesh& mesh, const Sphere_map& sphere)
{
  std::vector<double> result(num_vertices(mesh), 0.);
  for(const auto f : faces(mesh))
  {
    const std::vector<Vertex_index> v = corners_of(mesh, f);
    const auto at = [&](std::size_t k) { return SP::internal::direction_of(sphere[v[k]]); };
    for(const auto w : v)
      result[w] += Spherical_area(at(0), at(1), at(2)).value() / 3.;
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
    const std::vector<Vertex_index> v = corners_of(mesh, f);
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

// A mesh and a map to be written.
struct Subject
{
  explicit Subject(const Triangle_list& list)
    : mesh(make(list))
    , sphere(mesh.add_property_map<Vertex_index, Point_3>("v:sphere", Point_3(0., 0., 0.)).first)
  {}

  // A density of the vertices.
  template <class Function>
  Mesh::Property_map<Vertex_index, double> density(const Function& f)
  {
    const auto result = mesh.add_property_map<Vertex_index, double>("v:density").first;
    for(const auto v : vertices(mesh))
      result[v] = f(mesh.point(v));
    return result;
  }

  Mesh mesh;
  Sphere_map sphere;
};

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
  for(const auto& [list, tolerance] : {std::pair<Triangle_list, double>(tetrahedron(), 5e-4),
                                       {bumpy_sphere(3), 5e-4},
                                       {bumpy_sphere(3), 1e-6},
                                       {with_tentacle(20, 3.), 5e-4}})
  {
    auto [mesh, sphere] = Subject(list);
    auto method = SP::Target_area_parameterizer_3<>();
    if(tolerance != 5e-4) // the default
      method = method.area_tolerance(tolerance);
    ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
    const Area_report& report = method.area_report();
    EXPECT_TRUE(report.is_reached());
    EXPECT_LE(report.deviation, tolerance);
    EXPECT_EQ(report.number_of_raised_faces, 0u);
    EXPECT_EQ(method.report().stop_reason, SP::CONVERGED);
    expect_report(mesh, sphere, report, wanted_areas(mesh, [](Face_index) { return 1.; }));
  }
}

TEST(Target_areas, follow_densities_of_faces_and_vertices)
{
  Subject subject(bumpy_sphere(3));
  auto& [mesh, sphere] = subject;
  const auto of_vertices = subject.density([](const Point_3& p) { return p.x() > 0. ? 10. : 1.; });
  const auto of_faces = mesh.add_property_map<Face_index, float>("f:density", 0.f).first;
  for(const auto f : faces(mesh))
    for(const auto v : corners_of(mesh, f))
      of_faces[f] += 7.f * static_cast<float>(of_vertices[v]); // in any unit
  const auto expect_reached = [&, &mesh = mesh, &sphere = sphere](auto&& method) {
    ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
    EXPECT_TRUE(method.area_report().is_reached());
    expect_report(mesh, sphere, method.area_report(),
                  wanted_areas(mesh, [&](Face_index f) { return static_cast<double>(of_faces[f]); }));
  };
  expect_reached(SP::Target_area_parameterizer_3<>().target_density(of_vertices));
  expect_reached(SP::Target_area_parameterizer_3<>().energy(SP::Conformal_energy_3()).target_density(of_faces));
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
  auto [mesh, sphere] = Subject(tetrahedron());
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
    const std::vector<Vertex_index> around = corners_of(mesh, large);
    const bool is_corner = std::find(around.begin(), around.end(), v) != around.end();
    EXPECT_EQ(report.ratios[v] < 1., is_corner);
  }
  expect_report(mesh, sphere, report, wanted_areas(mesh, [&](Face_index f) { return density[f]; }));
}

TEST(Target_areas, may_be_of_a_contrast_of_a_million_or_zero)
{
  Subject subject(bumpy_sphere(2));
  auto& [mesh, sphere] = subject;
  auto method = SP::Target_area_parameterizer_3<>().target_density(
      subject.density([](const Point_3& p) { return std::pow(1e6, 0.5 + 0.5 * p.x()); }));
  ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, sphere));
  EXPECT_LE(method.area_report().deviation, 0.1);

  subject.density([](const Point_3& p) { return p.x() > 0. ? 1e300 : 0.; });
  ASSERT_EQ(SP::parameterize(mesh, method, sphere), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, sphere));
  EXPECT_GT(method.area_report().number_of_raised_faces, num_faces(mesh) / 3);
  EXPECT_LT(method.area_report().number_of_raised_faces, num_faces(mesh) / 2);
}

TEST(Target_areas, are_refused_where_densities_are_none)
{
  auto [mesh, sphere] = Subject(bumpy_sphere(1));
  auto of_vertices = mesh.add_property_map<Vertex_index, double>("v:density", 1.).first;
  auto of_faces = mesh.add_property_map<Face_index, double>("f:density", 1.).first;
  const auto expect_refusal = [&, &mesh = mesh, &sphere = sphere] {
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
  std::fill(of_vertices.begin(), of_vertices.end(), 0.);
  std::fill(of_faces.begin(), of_faces.end(), 0.);
  expect_refusal();
  auto method = SP::Target_area_parameterizer_3<>().area_tolerance(-1.);
  EXPECT_EQ(SP::parameterize(mesh, method, sphere), SP::ERROR_WRONG_PARAMETER);
}

TEST(Target_areas, are_the_same_with_any_number_of_threads)
{
  auto [mesh, sphere] = Subject(bumpy_sphere(4));
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
  Subject subject(bumpy_sphere(2));
  auto& [mesh, sphere] = subject;
  auto method = SP::Target_area_parameterizer_3<>().target_density(
      subject.density([](const Point_3& p) { return std::exp(2. * p.y()); }));
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

// The factorization of a step takes longest, and is asked as well.
TEST(Target_areas, may_be_stopped_within_a_step)
{
  struct Visitor : SP::Default_visitor
  {
    bool go_further(std::size_t iteration, double)
    {
      n_questions = iteration == last ? n_questions + 1 : 1;
      last = iteration;
      return iteration == 0 || n_questions < 3;
    }
    std::size_t last = 0, n_questions = 0;
  };
  auto [mesh, sphere] = Subject(bumpy_sphere(5));
  SP::Target_area_parameterizer_3<> method;
  Visitor visitor;
  ASSERT_EQ(SP::parameterize(mesh, method, sphere, CGAL::parameters::visitor(std::ref(visitor))), SP::OK);
  EXPECT_EQ(method.report().stop_reason, SP::STOPPED);
  EXPECT_EQ(visitor.n_questions, 3u);
  EXPECT_TRUE(SP::is_bijective(mesh, sphere));
}

} // namespace
