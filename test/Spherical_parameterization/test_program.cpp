// The command line program, run as a user runs it: exit status, messages, and which files are written.

#include "Binary_file.h"
#include "Program_fixture.h"
#include "decoded_images.h"
#include "methods.h"
#include "test_meshes.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sphere_locator_3.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Geometry_image.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>
#include <CGAL/Spherical_parameterization/Sampling/remesh_through_sphere.h>
#include <CGAL/Spherical_parameterization/Sampling/transfer.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Polygon_mesh_processing/locate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// In CGAL's tree the examples are not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

#include "../../examples/Spherical_parameterization/include/Program_error.h"

namespace fs = std::filesystem;

namespace {

namespace SP = CGAL::Spherical_parameterization;

using test::Mesh;
using test::Point_3;
using Vertex_index = Mesh::Vertex_index;
using Vector_map = Mesh::Property_map<Vertex_index, test::Kernel::Vector_3>;

class Command_line : public Program_fixture
{
protected:
  void SetUp() override
  {
    Program_fixture::SetUp();
    write_off("sphere.off", test_meshes::icosphere(2));
  }

  void expect_refused(const std::string& arguments, const std::string& part_of_message) const
  {
    expect_message(arguments, part_of_message);
    SCOPED_TRACE(arguments);
    for(const char* name : {"result.off", "result.json", "result_surface.ply", "result_sphere.ply"})
      EXPECT_FALSE(fs::exists(path(name))) << name;
  }

  // an .off file, or a .ply file with its properties
  Mesh mesh_in(const std::string& name) const
  {
    std::ifstream in(path(name), std::ios::binary);
    Mesh mesh;
    std::string comments;
    const bool is_ply = path(name).extension() == ".ply";
    EXPECT_TRUE(is_ply ? CGAL::IO::read_PLY(in, mesh, comments) : CGAL::IO::read_OFF(in, mesh)) << name;
    return mesh;
  }
};

// What the library makes of the meshes that the program has read and written, for its files to be compared with.
struct Library_remesh
{
  Library_remesh(const Mesh& surface, const Mesh& map, const SP::Sphere_domain_3& domain)
    : sphere(mesh.add_property_map<Vertex_index, Point_3>("v:sphere").first)
    , normals(mesh.add_property_map<Vertex_index, test::Kernel::Vector_3>("v:normal").first)
  {
    EXPECT_EQ(SP::remesh_through_sphere(surface, map.points(), domain, mesh, sphere, CGAL::parameters::default_values(),
                                        CGAL::parameters::vertex_normal_map(normals)),
              SP::OK);
  }

  Mesh mesh;
  Mesh::Property_map<Vertex_index, Point_3> sphere;
  Vector_map normals;
};

// Files have all digits; the parts of a sum may come in another order.
template <class Point>
void expect_near(const std::vector<Point>& found, const std::vector<Point>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t v = 0; v < found.size(); ++v)
    for(int k = 0; k < 3; ++k)
      ASSERT_NEAR(found[v][k], expected[v][k], 1e-12) << v;
}

// The same faces in the same order; a reader chooses which corner comes first.
void expect_same_faces(std::vector<test::Triangle> found, std::vector<test::Triangle> expected)
{
  for(std::vector<test::Triangle>* triangles : {&found, &expected})
    for(test::Triangle& t : *triangles)
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  EXPECT_EQ(found, expected);
}

std::vector<Point_3> points_of(const Mesh& mesh)
{
  return std::vector<Point_3>(mesh.points().begin(), mesh.points().end());
}

template <class Index, class T>
std::vector<T> values_of(Mesh& mesh, const std::string& name)
{
  const auto [map, is_new] = mesh.add_property_map<Index, T>(name);
  EXPECT_FALSE(is_new) << name;
  return std::vector<T>(map.begin(), map.end());
}

TEST_F(Command_line, writes_all_that_is_asked_for)
{
  const Outcome outcome = run("sphere.off -o result.off --json result.json --colored result");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.err.empty()) << outcome.err; // no progress line where nobody looks
  EXPECT_NE(outcome.out.find("D_iso"), std::string::npos);
  EXPECT_NE(outcome.out.find("one-to-one"), std::string::npos);
  EXPECT_EQ(content(path("result_surface.ply")).substr(0, 3), "ply");
  EXPECT_EQ(content(path("result_sphere.ply")).substr(0, 3), "ply");
  EXPECT_EQ(names_of_files().size(), 7u); // input, four files, two streams: nothing temporary is left

  const boost::property_tree::ptree report = json();
  EXPECT_EQ(report.get<std::size_t>("vertices"), 162u);
  EXPECT_TRUE(report.get<bool>("one_to_one"));
  EXPECT_LT(report.get<double>("distortion.D_iso.maximum"), 1.02);
  EXPECT_FALSE(report.get_child_optional("balanced")); // the radius is a part of the result already

  // the same faces in the same order, each with the same first corner
  const auto faces_of = [&](const std::string& name) {
    std::istringstream in(content(path(name)));
    const std::vector<std::string> words((std::istream_iterator<std::string>(in)), {});
    return std::vector<std::string>(words.end() - 4 * 320, words.end());
  };
  EXPECT_EQ(faces_of("result.off"), faces_of("sphere.off"));
}

TEST_F(Command_line, prints_the_table_only_without_output)
{
  const Outcome outcome = run("sphere.off");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("D_angle"), std::string::npos);
  EXPECT_EQ(names_of_files().size(), 3u);
  EXPECT_TRUE(run("sphere.off --quiet").out.empty());
}

TEST_F(Command_line, takes_every_setting_and_ignores_none)
{
  write_off("long.off", test_meshes::scaled(test_meshes::icosphere(2), 1., 1.5, 2.5));
  ASSERT_EQ(run("long.off -o start.off --iterations 1 --quiet").status, 0);
  std::map<std::string, std::string> arguments_of; // each map
  std::vector<std::string> settings = {"--prefer average",
                                       "--prefer worst",
                                       "--prefer sampling",
                                       "--sharpness 3.5",
                                       "--s-first 0.5 --s-last 5",
                                       "--s-last 2 --average-sweeps 3",
                                       "--s-first 5 --s-last 5 --average-sweeps 0",
                                       "--radius two-phase",
                                       "--radius optimal",
                                       "--radius area",
                                       "--radius balanced",
                                       "--radius fixed=2.5",
                                       "--initial start.off",
                                       "--method hierarchical",
                                       "--method hierarchical --energy conformal",
                                       "--method hierarchical --prefer worst",
                                       "--method hierarchical --sharpness 3",
                                       "--method harmonic",
                                       "--method harmonic --iterations 2",
                                       "--method conformal",
                                       "--method arap",
                                       "--method arap --initial harmonic",
                                       "--method arap --initial start.off",
                                       "--method stereographic",
                                       "--paper --iterations 130",
                                       "--paper --iterations 130 --initial hierarchical --radius area",
                                       "--paper --s-first 1 --s-last 1 --average-sweeps 5 --iterations 30",
                                       "--tolerance 0",
                                       "--tolerance 0.01",
                                       "--density equal",
                                       "--density equal --energy isometric",
                                       "--density equal --prefer average --iterations 2",
                                       "--iterations 3",
                                       "--iterations 0"};
  for(const char* energy : {"symmetric-dirichlet", "isometric", "conformal"})
    for(const char* start : {"hierarchical", "stereographic", "harmonic", "conformal", "schnyder"})
      settings.push_back(std::string("--energy ") + energy + " --initial " + start);
  for(const std::string& arguments : settings)
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run("long.off -o result.off --json result.json " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(json().get<bool>("one_to_one"));
    EXPECT_LT(json().get<double>("distortion.D_angle.maximum"), 6.);
    const auto [other, is_new] = arguments_of.emplace(content(path("result.off")), arguments);
    EXPECT_TRUE(is_new) << "the same map as " << other->second;
  }
  EXPECT_EQ(run("long.off -o result.off --method schnyder").status, 0); // whose angles are any
  EXPECT_TRUE(arguments_of.emplace(content(path("result.off")), "--method schnyder").second);
  for(const char* arguments :
      {"", "--method bld", "--energy symmetric-dirichlet", "--initial hierarchical", "--prefer balance",
       "--sharpness 20", "--radius objective", "--tolerance 1e-3", "--time-limit 100"})
  {
    SCOPED_TRACE(arguments);
    EXPECT_EQ(run(std::string("long.off -o result.off ") + arguments).status, 0);
    EXPECT_EQ(arguments_of[content(path("result.off"))], "--energy symmetric-dirichlet --initial hierarchical");
  }
  run("sphere.off --json result.json --radius fixed=2.5");
  EXPECT_EQ(json().get<double>("radius"), 2.5);
}

TEST_F(Command_line, tells_the_history_of_the_sweeps)
{
  write_off("bumpy.off", test_meshes::bumpy_sphere(2));
  for(const char* arguments :
      {"", "--iterations 7", "--iterations 0", "--prefer average", "--paper --iterations 120", "--method harmonic",
       "--method conformal", "--method arap", "--method hierarchical", "--method stereographic", "--method schnyder"})
  {
    SCOPED_TRACE(arguments);
    ASSERT_NE(run(std::string("bumpy.off --json result.json ") + arguments).status, 1);
    const boost::property_tree::ptree report = json();
    const std::size_t sweeps = report.get<std::size_t>("sweeps.average") + report.get<std::size_t>("sweeps.sharp");
    std::size_t iteration = 0;
    double radius = 0.;
    for(const auto& row : report.get_child("history"))
    {
      std::vector<double> values;
      for(const auto& value : row.second)
        values.push_back(value.second.get_value<double>());
      ASSERT_EQ(values.size(), 3u);
      EXPECT_EQ(values[0], static_cast<double>(++iteration));
      EXPECT_GT(values[1], 0.);
      radius = values[2];
    }
    EXPECT_EQ(iteration, sweeps);
    // the last row is of the map that was written, but for a last step of the radius
    EXPECT_NEAR(radius, iteration > 0 ? report.get<double>("radius") : 0., 0.3 * radius);
  }
}

TEST_F(Command_line, counts_the_sweeps_of_the_schedules)
{
  write_off("bumpy.off", test_meshes::bumpy_sphere(2));
  const auto sweeps = [&](const std::string& arguments) {
    EXPECT_EQ(run("bumpy.off --json result.json " + arguments).status, 0) << arguments;
    return std::make_pair(json().get<int>("sweeps.average"), json().get<int>("sweeps.sharp"));
  };
  EXPECT_EQ(sweeps("--paper --iterations 120"), std::make_pair(100, 20));
  EXPECT_EQ(sweeps("--paper --iterations 20 --average-sweeps 15"), std::make_pair(15, 5));
  EXPECT_EQ(sweeps("--s-first 1 --s-last 3 --average-sweeps 4 --iterations 6"), std::make_pair(4, 2));
  EXPECT_EQ(sweeps("--s-first 5 --s-last 5 --iterations 3"), std::make_pair(0, 3));
  EXPECT_EQ(sweeps("--s-last 5 --average-sweeps 0 --iterations 1"), std::make_pair(0, 1));
  EXPECT_EQ(json().get<double>("sharpness"), 0.1);
}

// Slivers go on changing, if only in the last digits.
TEST_F(Command_line, ends_after_the_sweeps_that_its_help_names)
{
  write_off("slivers.off", test_meshes::with_slivers(test_meshes::icosphere(4), 40, 1e-4));
  ASSERT_EQ(run("slivers.off --tolerance 0 --json result.json").status, 0);
  EXPECT_EQ(json().get<int>("sweeps.sharp"), 250);
}

TEST_F(Command_line, writes_a_map_that_folds_and_says_so)
{
  write_off("spiky.off", test_meshes::random_stacked_sphere(300, 7));
  for(const char* method : {"conformal", "arap"})
  {
    SCOPED_TRACE(method);
    for(const char* name : {"result.off", "result.json", "result_surface.ply", "result_sphere.ply"})
      fs::remove(path(name));
    const Outcome outcome =
        run(std::string("spiky.off -o result.off --json result.json --colored result --method ") + method);
    EXPECT_EQ(outcome.status, 2);
    const boost::property_tree::ptree report = json();
    EXPECT_FALSE(report.get<bool>("one_to_one"));
    const std::size_t number_of_inverted_faces = report.get<std::size_t>("distortion.inverted_faces");
    EXPECT_GT(number_of_inverted_faces, 0u);
    const std::string fault = std::to_string(number_of_inverted_faces) + " faces are inverted";
    EXPECT_NE(outcome.out.find("Not one-to-one: " + fault), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("Certified"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find(fault), std::string::npos) << outcome.err;
    for(const char* name : {"result.off", "result_surface.ply", "result_sphere.ply"})
      EXPECT_GT(content(path(name)).size(), 1000u) << name;
    // it is a map, but none to start from
    expect_message(std::string("spiky.off --initial result.off"), "one-to-one");
  }
  for(const char* method : {"--method arap", "--paper", "--method bld"})
    expect_message(std::string("spiky.off --initial conformal ") + method, "--initial hierarchical");
}

TEST_F(Command_line, advises_another_start_where_one_needs_more_precision)
{
  write_off("tentacle.off", test_meshes::with_tentacle(400, 60.));
  for(const char* start : {"stereographic", "harmonic"})
  {
    expect_message(std::string("tentacle.off --initial ") + start, "--initial hierarchical");
    expect_message(std::string("tentacle.off --initial ") + start, std::string("no one-to-one ") + start + " start");
    expect_message(std::string("tentacle.off --method ") + start, "--method hierarchical");
  }
  EXPECT_EQ(run("tentacle.off --initial hierarchical --iterations 1").status, 0);
}

TEST_F(Command_line, compares_maps_to_the_unit_sphere_at_their_balanced_radius)
{
  // Where a small sphere is mapped to the unit sphere, only the balanced radius tells that its shape is kept.
  test_meshes::Triangle_list list = test_meshes::scaled(test_meshes::icosphere(2), 1e-200, 1e-200, 1e-200);
  write_off("small.off", list);
  for(const char* arguments : {"--method hierarchical", "--method harmonic", "--method conformal",
                               "--method stereographic", "--energy conformal"})
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(std::string("small.off --json result.json ") + arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("balanced areas"), std::string::npos);
    const boost::property_tree::ptree report = json();
    EXPECT_GT(report.get<double>("distortion.D_iso.average"), 1e199);
    EXPECT_NEAR(report.get<double>("balanced.radius"), 1e-200, 1e-202);
    EXPECT_LT(report.get<double>("balanced.D_iso.maximum"), 1.2);
    EXPECT_NEAR(report.get<double>("balanced.D_area.average"), 2., 0.01);
  }
  const std::vector<std::pair<const char*, const char*>> measures = {
      {"hierarchical", "balanced D_iso"}, {"harmonic", "D_angle"}, {"bld", "D_iso"}};
  for(const auto& [method, measure] : measures)
  {
    ASSERT_EQ(run(std::string("small.off --json result.json --colored result --method ") + method).status, 0);
    EXPECT_EQ(json().get<std::string>("colors.measure"), measure);
    EXPECT_LT(json().get<double>("colors.maximum"), 2.2);
  }
  // a radius that was chosen is meant
  for(const char* arguments : {"--energy conformal --radius fixed=3", "--method arap"})
  {
    SCOPED_TRACE(arguments);
    ASSERT_EQ(run(std::string("small.off --json result.json ") + arguments).status, 0);
    EXPECT_FALSE(json().get_child_optional("balanced"));
  }
}

TEST_F(Command_line, starts_from_a_map)
{
  ASSERT_EQ(run("sphere.off -o first.off --iterations 1 --quiet").status, 0);
  EXPECT_EQ(run("sphere.off -o second.off --initial first.off --quiet").status, 0);
  // the surface itself, star-shaped about the origin, is a map as well
  EXPECT_EQ(run("sphere.off -o third.off --initial sphere.off --quiet").status, 0);

  expect_refused("sphere.off -o result.off --initial missing.off", "missing.off");
  write_off("coarse.off", test_meshes::icosphere(1));
  expect_refused("sphere.off -o result.off --initial coarse.off", "vertices");
  test_meshes::Triangle_list mirrored = test_meshes::icosphere(2);
  for(auto& p : mirrored.points)
    p[0] = -p[0];
  write_off("mirrored.off", mirrored);
  expect_refused("sphere.off -o result.off --initial mirrored.off", "one-to-one");
}

// The program's --remesh and the same in two runs, over a solid and over the sphere that it has written.
TEST_F(Command_line, remeshes_through_the_sphere)
{
  Outcome outcome = run("sphere.off --remesh octahedron=4 -o remesh.off --sphere map.off --json result.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Remesh:    66 vertices, 128 faces"), std::string::npos) << outcome.out;
  const Mesh sphere = mesh_in("sphere.off"), map = mesh_in("map.off"), remesh = mesh_in("remesh.off");
  expect_same_faces(test::triangles(map), test::triangles(sphere));
  const Library_remesh expected(sphere, map, SP::Sphere_domain_3::octahedron(4));
  expect_same_faces(test::triangles(remesh), test::triangles(expected.mesh));
  expect_near(points_of(remesh), points_of(expected.mesh));
  const boost::property_tree::ptree report = json();
  EXPECT_NE(report.get<std::string>("method").find("stretch energy"), std::string::npos);
  EXPECT_EQ(report.get<std::size_t>("remesh.vertices"), 66u);
  EXPECT_GT(report.get<double>("remesh.psnr"), 35.);
  EXPECT_LT(report.get<double>("remesh.distance_from_surface.maximum"), 0.2);

  outcome = run("sphere.off --initial map.off --iterations 0 --remesh map.off -o same.off");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Mesh same = mesh_in("same.off");
  expect_same_faces(test::triangles(same), test::triangles(sphere));
  expect_near(points_of(same), points_of(sphere));
  EXPECT_EQ(run("sphere.off --remesh map.off").status, 0); // tells the distance alone
}

// A sphere with values at its vertices, one of which can be chosen.
std::string ply_with_values(unsigned int subdivisions, float first_height = 1.f)
{
  Binary_file ply(false);
  const test_meshes::Triangle_list list = test_meshes::icosphere(subdivisions);
  ply << "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(list.points.size()) +
             "\nproperty double x\nproperty double y\nproperty double z\nproperty float height\nproperty uint label\n"
             "element face " +
             std::to_string(list.triangles.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
  for(std::size_t v = 0; v < list.points.size(); ++v)
  {
    const test_meshes::Coordinates& p = list.points[v];
    ply << double(p[0]) << double(p[1]) << double(p[2]) << (v == 0 ? first_height : static_cast<float>(p[2]))
        << std::uint32_t(p[0] > 0.1 ? 7 : 3);
  }
  for(const test_meshes::Triangle& t : list.triangles)
    ply << std::uint8_t(3) << static_cast<std::uint32_t>(t[0]) << static_cast<std::uint32_t>(t[1])
        << static_cast<std::uint32_t>(t[2]);
  return ply.content;
}

// The vertices of the input come first, and each face is told to be a part of one of the input.
TEST_F(Command_line, splits_faces_where_that_pays)
{
  write_off("target.off", test_meshes::scaled(test_meshes::icosphere(3), 1., 2., 0.5));
  write("a.txt", "0\n1\n2\n3\n");
  write("b.txt", "0\n1\n2\n14\n"); // one is not where the others are
  const std::string map = "sphere.off --onto target.off --landmarks a.txt b.txt";
  const Outcome outcome = run(map + " --split -o mapped.off --sphere p.off --overlay overlay.ply --json split.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Split:     "), std::string::npos) << outcome.out;
  const Mesh first = mesh_in("sphere.off"), mapped = mesh_in("mapped.off"), directions = mesh_in("p.off");
  const auto report = json("split.json");
  const std::size_t n = report.get<std::size_t>("match.split.new_vertices");
  EXPECT_GT(n, 0u);
  EXPECT_LE(n, first.number_of_vertices() / 2);
  EXPECT_EQ(report.get<std::size_t>("match.split.new_faces"), 2 * n);
  EXPECT_EQ(report.get_child("match.split.faces_of_input").size(), first.number_of_faces() + 2 * n);
  EXPECT_LT(report.get<double>("match.split.energy"), report.get<double>("match.split.energy_before"));
  EXPECT_EQ(mapped.number_of_vertices(), first.number_of_vertices() + n);
  EXPECT_EQ(mapped.number_of_faces(), first.number_of_faces() + 2 * n);
  expect_same_faces(test::triangles(mapped), test::triangles(directions));
  EXPECT_TRUE(SP::is_bijective(directions, directions.points()));
  Mesh overlay = mesh_in("overlay.ply");
  for(const int f : values_of<Mesh::Face_index, int>(overlay, "f:face"))
    EXPECT_LT(static_cast<std::size_t>(f), first.number_of_faces());
  if(const Outcome with_page = run(map + " --split --page page.html --convention cortex --quiet");
     with_page.status == 0)
  {
    const std::string page = content(path("page.html")), begin = "id=\"folds\">";
    const std::size_t start = page.find(begin) + begin.size();
    const std::string classes = page.substr(start, page.find("</script>", start) - start);
    EXPECT_FALSE(classes.empty());
    EXPECT_EQ(classes.find_first_not_of("ABEQ="), classes.npos); // 16 bits that are 0 or 1, in base 64
  }
  else
    EXPECT_NE(with_page.err.find("was built without the page"), std::string::npos) << with_page.err;
  expect_refused("sphere.off -o result.off --split", "--split goes with --onto");
  expect_refused(map + " -o result.off --split --fill-holes all", "--split and --fill-holes cannot be combined");
}

// The program's --onto, with landmarks, and all that it writes.
TEST_F(Command_line, maps_a_surface_onto_another_one)
{
  const std::string map = "sphere.off --onto target.off";
  write_off("target.off", test_meshes::scaled(test_meshes::icosphere(1), 1., 1.2, 0.9));
  Outcome outcome =
      run(map + " -o mapped.off --sphere p.off --overlay overlay.ply --morph 0.25 morph.off --json mapped.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Onto:      target.off: 42 vertices"), std::string::npos) << outcome.out;
  const Mesh first = mesh_in("sphere.off"), directions = mesh_in("p.off"), mapped = mesh_in("mapped.off"),
             target = mesh_in("target.off"), target_sphere = mesh_in("p_target.off"), morph = mesh_in("morph.off");
  expect_same_faces(test::triangles(directions), test::triangles(first));
  expect_same_faces(test::triangles(mapped), test::triangles(first));
  expect_same_faces(test::triangles(target_sphere), test::triangles(target));
  const SP::Sphere_locator_3 locator(target, target_sphere.points());
  ASSERT_EQ(locator.error_code(), SP::OK);
  std::vector<Point_3> places;
  for(const Vertex_index v : directions.vertices())
    places.push_back(CGAL::Polygon_mesh_processing::construct_point(locator.locate(directions.point(v)), target));
  expect_near(points_of(mapped), places);

  SP::Surface_overlay_3<Mesh, Mesh> expected;
  ASSERT_EQ(SP::overlay(first, directions.points(), target, target_sphere.points(), expected), SP::OK);
  Mesh overlay = mesh_in("overlay.ply");
  const auto x = values_of<Vertex_index, double>(overlay, "v:x_on_target"),
             y = values_of<Vertex_index, double>(overlay, "v:y_on_target"),
             z = values_of<Vertex_index, double>(overlay, "v:z_on_target");
  std::vector<Point_3> on_first, on_target, between;
  std::vector<Point_3> found_on_target;
  for(std::size_t v = 0; v < x.size(); ++v)
    found_on_target.emplace_back(x[v], y[v], z[v]);
  for(const auto& [p, q] : expected.points)
  {
    on_first.push_back(p);
    on_target.push_back(q);
    between.push_back(p + 0.25 * (q - p));
  }
  expect_near(points_of(overlay), on_first);
  expect_near(found_on_target, on_target);
  expect_near(points_of(morph), between);
  std::vector<int> faces, faces_of_target;
  for(const auto& [face, face_of_target] : expected.faces)
  {
    faces.push_back(static_cast<int>(face));
    faces_of_target.push_back(static_cast<int>(face_of_target));
  }
  EXPECT_EQ((values_of<Mesh::Face_index, int>(overlay, "f:face")), faces);
  EXPECT_EQ((values_of<Mesh::Face_index, int>(overlay, "f:face_of_target")), faces_of_target);
  std::vector<test::Triangle> triangles;
  for(const auto& t : expected.triangles)
    triangles.push_back({t[0], t[1], t[2]});
  expect_same_faces(test::triangles(overlay), triangles);
  expect_same_faces(test::triangles(morph), triangles);
  EXPECT_LT(json("mapped.json").get<double>("match.energy.average"), 2.2);
  // The directions are a map of the first surface, and the other file is one of the second.
  EXPECT_EQ(run("sphere.off --initial p.off --iterations 0").status, 0);
  EXPECT_EQ(run("target.off --initial p_target.off --iterations 0").status, 0);

  write("a.txt", "0 comment\n\n1\n5\n");
  write("b.txt", "7\n8\n11\n");
  outcome = run(map + " --landmarks a.txt b.txt --json mapped.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::size_t n_missed = json("mapped.json").get<std::size_t>("match.missed_landmarks");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), static_cast<std::ptrdiff_t>(n_missed));
  EXPECT_EQ(run("--landmarks a.txt b.txt --soft-landmarks 2 " + map).status, 0);
  EXPECT_EQ(run("--quiet " + map + " --landmarks a.txt b.txt").out, "");

  write("a.txt", "\xEF\xBB\xBF"
                 "0\n1\n5\n"); // the mark that some editors put before UTF-8
  EXPECT_EQ(run(map + " --landmarks a.txt b.txt").status, 0);

  write("twice.txt", "3\n4\n3\n");
  expect_refused(map + " -o result.off --landmarks twice.txt b.txt",
                 "twice.txt: line 3: vertex 3 is a landmark already, in line 1");
  write("outside.txt", "3\n42\n");
  expect_refused(map + " -o result.off --landmarks outside.txt outside.txt",
                 "outside.txt: line 2: the mesh has no vertex '42'");
  write("word.txt", "one\n");
  expect_refused(map + " -o result.off --landmarks word.txt b.txt", "word.txt: line 1: 'one' is no number");
  expect_refused(map + " -o result.off --landmarks word.txt missing.txt", "");
  write("few.txt", "0\n");
  expect_refused(map + " -o result.off --landmarks few.txt b.txt", "has 3 landmarks, but few.txt has 1");
  expect_refused(map + " -o result.off --landmarks a.txt", "--landmarks needs two files");
  expect_refused(map + " -o result.off --morph 2 morph.off", "--morph has to be a number from 0 to 1");
  expect_refused("sphere.off -o result.off --overlay overlay.ply", "--overlay goes with --onto");
  expect_refused(map + " -o result.off --features a.txt b.txt", "a.txt: this is no file with values of vertices");
  write("a.ply", ply_with_values(2));
  write("b.ply", ply_with_values(1));
  outcome = run(map + " --features a.ply b.ply");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Aligned:   by features"), std::string::npos) << outcome.out;
  const std::string left_out =
      ".ply: not compared: the property 'label' of the vertices, whose type is neither float nor double\n";
  EXPECT_EQ(outcome.err, "a" + left_out + "b" + left_out + uncertain);
  expect_refused(map + " -o result.off --features b.ply b.ply",
                 "b.ply: has no features for the mesh: it has 42 vertices");

  const std::string features = " --features a.ply b.ply", by_features = map + " -o result.off" + features;
  EXPECT_EQ(run(map + features + " --feature-weights height=2 --compare values").status, 0);
  for(const char* weights : {"height", "height=x", "=1", "height=-1", "height=1,height=2"})
    expect_refused(by_features + " --feature-weights " + weights, "--feature-weights has to be a list such as sulc=2");
  expect_refused(by_features + " --feature-weights depth=2", "has no feature of the name 'depth'");
  expect_refused(by_features + " --feature-weights height=0", "has no feature left");
  expect_refused(by_features + " --compare shapes", "--compare has to be");
  expect_refused(map + " -o result.off --compare values", "--compare goes with --features");
  const auto mask = [](unsigned int subdivisions, bool counts) { // of half of the surface
    const test_meshes::Triangle_list list = test_meshes::icosphere(subdivisions);
    std::ostringstream ply;
    ply << "ply\nformat ascii 1.0\nelement vertex " << list.points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar counts\nend_header\n";
    for(const test_meshes::Coordinates& p : list.points)
      ply << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << (counts && p[2] > 0.) << '\n';
    return ply.str();
  };
  write("a_mask.ply", mask(2, true));
  write("b_mask.ply", mask(1, true));
  write("nothing.ply", mask(1, false));
  EXPECT_EQ(run(map + features + " --masks a_mask.ply b_mask.ply").status, 0);
  expect_refused(map + " -o result.off --masks a_mask.ply nothing.ply", "nothing.ply: is 0 for all vertices");
  expect_refused(map + " -o result.off --masks b_mask.ply b_mask.ply", "b_mask.ply: is no mask for the mesh");
  expect_refused(map + " -o result.off --masks a.ply b_mask.ply", "a.ply: is no mask: it has 2 values for each vertex");
  outcome = run(map + " --time-limit 1e-9");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("; time limit"), std::string::npos) << outcome.out;
  write("nan.ply", ply_with_values(1, std::numeric_limits<float>::quiet_NaN()));
  expect_refused(map + " -o result.off --features a.ply nan.ply", "the property height of vertex 0 is infinite or not");
  write_off("plain.off", test_meshes::icosphere(1));
  EXPECT_EQ(run("plain.off -o plain.ply").status, 0);
  expect_refused(map + " -o result.off --features a.ply plain.ply", "plain.ply: has no property of vertices");
  expect_refused(map + " -o result.off --method conformal --landmarks a.txt b.txt --soft-landmarks 0",
                 "--soft-landmarks has to be");
  write_off("torus.off", test_meshes::torus(8, 5));
  expect_refused("sphere.off --onto torus.off -o result.off", "genus");

  write_off("hubs.off", test_meshes::suspension(3000)); // with too many crossings to be refined in common
  const std::string hubs = "hubs.off --onto hubs.off --quiet";
  outcome = run(hubs + " -o mapped.off --json mapped.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_LT(json("mapped.json").get<double>("match.sampled_energy"), 2.1);
  expect_refused(hubs + " -o result.off --overlay overlay.ply", "The common refinement of the two surfaces has more");
}

// What is written and measured is what the file has, and the filler is told.
TEST_F(Command_line, fills_holes)
{
  const test_meshes::Triangle_list list = test_meshes::bumpy_sphere(2);
  test_meshes::Triangle_list opened = list;
  opened.triangles.clear();
  for(const test_meshes::Triangle& t : list.triangles)
    if(std::count(t.begin(), t.end(), 20u) + std::count(t.begin(), t.end(), 100u) == 0)
      opened.triangles.push_back(t);
  write_off("opened.off", opened);
  const Outcome refused = run("opened.off -o sphere.off");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("--fill-holes all"), std::string::npos) << refused.err;

  const Outcome outcome = run("opened.off --fill-holes all -o sphere.off --filled filled.ply --json result.json "
                              "--colored colored --page page.html");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Holes     2 filled"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(json().get_child("holes").size(), 2u);
  EXPECT_GT(json().get_child("holes").front().second.get<double>("share_of_area"), 0.);
  const std::string counts = std::to_string(opened.points.size()) + ' ' + std::to_string(opened.triangles.size());
  EXPECT_EQ(content(path("sphere.off")).substr(4, counts.size()), counts);
  // The closed surface is a mesh as others, with the same map.
  EXPECT_EQ(run("filled.ply -o again.off").status, 0);
  EXPECT_NE(content(path("filled.ply")).find("filler"), std::string::npos);
  const Outcome remesh = run("opened.off --fill-holes all --remesh octahedron=4 -o remesh.ply");
  EXPECT_EQ(remesh.status, 0) << remesh.err;
  EXPECT_NE(content(path("remesh.ply")).find("filler"), std::string::npos);
  // The filler is masked: features are those of the file.
  const auto write_heights = [&](const std::string& name, const test_meshes::Triangle_list& mesh) {
    std::ofstream ply(path(name));
    ply << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nproperty float height\nend_header\n";
    for(const test_meshes::Coordinates& p : mesh.points)
      ply << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[2] << '\n';
  };
  write_off("closed.off", list);
  write_heights("closed.ply", list);
  write_heights("opened.ply", opened);
  const Outcome onto =
      run("opened.off --fill-holes all --onto closed.off -o onto.off --features opened.ply closed.ply");
  EXPECT_EQ(onto.status, 0) << onto.err;
  EXPECT_EQ(run("opened.off --fill-holes 4 -o sphere.off").status, 1);
  opened.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  write_off("broken.off", opened);
  const Outcome broken = run("broken.off --fill-holes all -o sphere.off");
  EXPECT_EQ(broken.status, 1);
  EXPECT_NE(broken.err.find("vertex 3 has a coordinate that is"), std::string::npos) << broken.err;

  test_meshes::Triangle_list sheet;
  sheet.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0.1}};
  sheet.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}};
  write_off("sheet.off", sheet);
  const Outcome warned = run("sheet.off --fill-holes all -o sphere.off");
  EXPECT_EQ(warned.status, 0) << warned.err;
  EXPECT_NE(warned.err.find("more than half"), std::string::npos) << warned.err;
  sheet.triangles = {{0, 1, 4}, {2, 3, 4}};
  write_off("sheet.off", sheet);
  const Outcome touching = run("sheet.off --fill-holes all -o sphere.off");
  EXPECT_EQ(touching.status, 1);
  EXPECT_NE(touching.err.find("touches itself in vertex 4"), std::string::npos) << touching.err;
  for(const char* options :
      {"--fill-holes 2", "--fill-holes some", "--filled a.ply", "--fill-holes all --filled a.off",
       "--fill-holes all --initial filled.ply", "--fill-holes all --remesh cube=2 --transfer filled.ply",
       "--components all", "--components each --output-folder folder"})
    EXPECT_EQ(run(std::string("opened.off ") + options).status, 1) << options;
}

TEST_F(Command_line, tells_of_handles)
{
  write_off("torus.off", test_meshes::torus(20, 6));
  const Outcome outcome = run("torus.off -o of_torus.off --handles handles.ply");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("A path of 6 edges around a handle, of length 6, at vertex"), std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(path("of_torus.off")));
  EXPECT_NE(content(path("handles.ply")).find("element edge 6\n"), std::string::npos);
  write_off("sphere.off", test_meshes::icosphere(1));
  EXPECT_EQ(run("sphere.off --handles handles.ply").status, 0);
  EXPECT_NE(content(path("handles.ply")).find("element edge 0\n"), std::string::npos);
}

TEST_F(Command_line, maps_one_part_or_each)
{
  const test_meshes::Triangle_list two =
      test_meshes::disjoint_union(test_meshes::octahedron(), test_meshes::bumpy_sphere(2));
  write_off("two.off", test_meshes::disjoint_union(two, test_meshes::tetrahedron()));
  const Outcome refused = run("two.off -o sphere.off");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("--components largest"), std::string::npos) << refused.err;
  const Outcome outcome = run("two.off -o sphere.off --components largest --json result.json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Part      1 of 3, with 320 faces; the others have 8 and 4"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(json().get<std::size_t>("faces"), 320u);
  EXPECT_EQ(json().get<std::size_t>("component"), 1u);
  EXPECT_EQ(json().get_child("faces_of_components").size(), 3u);
  EXPECT_EQ(run("two.off -o sphere.off --components each --json each.json").status, 0);
  for(const auto& [name, n_faces] : {std::pair("sphere_1.off", "320"), {"sphere_2.off", "8"}, {"sphere_3.off", "4"}})
    EXPECT_EQ(content(path(name)).substr(4, 5 + std::string(n_faces).size()), "172 " + std::string(n_faces) + " ")
        << name;
  EXPECT_TRUE(std::filesystem::exists(path("each_3.json")));
}

TEST_F(Command_line, carries_values_over)
{
  write("values.ply", ply_with_values(2));
  write_off("other.off", test_meshes::icosphere(1));
  // values_sphere has the directions of the vertices that have the values
  const auto expect_values = [&](const std::string& input, const std::string& options,
                                 const std::string& values_sphere) {
    const Outcome outcome =
        run(input + " --remesh cube=3 --transfer values.ply -o result.ply --sphere map.off --quiet" + options);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    Library_remesh expected(mesh_in(input), mesh_in("map.off"), SP::Sphere_domain_3::cube(3));
    const Mesh values = mesh_in("values.ply"), sphere = mesh_in(values_sphere);
    ASSERT_EQ(SP::transfer(values, sphere.points(), expected.mesh, expected.sphere), SP::OK);
    Mesh result = mesh_in("result.ply");
    expect_same_faces(test::triangles(result), test::triangles(expected.mesh));
    expect_near(points_of(result), points_of(expected.mesh));
    expect_near(values_of<Vertex_index, test::Kernel::Vector_3>(result, "v:normal"),
                std::vector<test::Kernel::Vector_3>(expected.normals.begin(), expected.normals.end()));
    EXPECT_EQ((values_of<Vertex_index, float>(result, "v:height")),
              (values_of<Vertex_index, float>(expected.mesh, "v:height")));
    const auto labels = values_of<Vertex_index, std::uint32_t>(result, "v:label");
    EXPECT_EQ(labels, (values_of<Vertex_index, std::uint32_t>(expected.mesh, "v:label")));
    EXPECT_EQ(std::set<std::uint32_t>(labels.begin(), labels.end()), (std::set<std::uint32_t>{3, 7}));
    fs::remove(path("result.ply"));
  };
  expect_values("sphere.off", "", "map.off");
  expect_values("other.off", " --values-sphere sphere.off", "sphere.off");
  expect_refused("other.off --remesh cube=3 -o result.ply --transfer values.ply", "has no values for this mesh");
  expect_refused("other.off --remesh cube=3 -o result.ply --transfer values.ply --values-sphere other.off",
                 "is no map of this mesh");
  expect_refused("sphere.off --remesh cube=3 -o result.ply --transfer missing.ply", "No such file");
  EXPECT_FALSE(fs::exists(path("result.ply")));
}

TEST_F(Command_line, gives_parts_of_the_surface_the_areas_that_are_wanted)
{
  const auto density_file = [&](const std::string& name, const std::string& density_of_first) {
    const Mesh mesh = mesh_in("sphere.off");
    std::ostringstream text;
    text << "ply\nformat ascii 1.0\nelement vertex " << mesh.number_of_vertices()
         << "\nproperty double x\nproperty double y\nproperty double z\nproperty int label\nproperty float density\n"
            "end_header\n";
    for(const Vertex_index v : mesh.vertices())
      text << mesh.point(v) << " 5 " << (v.idx() == 0 ? density_of_first : mesh.point(v).x() > 0. ? "10" : "1") << '\n';
    write(name, text.str());
  };
  density_file("density.ply", "3");
  std::string last = "";
  for(const char* density : {"equal", "density.ply"})
  {
    const Outcome outcome = run(std::string("sphere.off -o result.off --json result.json --density ") + density);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("0 of 162 vertices are off by more than 1 %\n"), std::string::npos) << outcome.out;
    EXPECT_TRUE(json().get<bool>("one_to_one"));
    EXPECT_TRUE(json().get<bool>("areas.reached"));
    EXPECT_LT(json().get<double>("areas.deviation"), 1e-3);
    EXPECT_NE(content(path("result.off")), last);
    last = content(path("result.off"));
  }

  fs::remove(path("result.off"));
  fs::remove(path("result.json"));
  density_file("negative.ply", "-1");
  density_file("nan.ply", "nan");
  write("other.ply", ply_with_values(1));
  for(const auto& [arguments, message] : std::vector<std::pair<std::string, std::string>>{
          {"--density negative.ply", "the density of vertex 0 is negative"},
          {"--density nan.ply", "the density of vertex 0 is negative, infinite or not a number"},
          {"--density other.ply", "is no density"},
          {"--density missing.ply", "No such file"},
          {"--density sphere.off", "--density needs .ply files"},
          {"--density ''", "the word equal"},
          {"--density equal --radius area", "--radius and --density cannot be combined"},
          {"--density equal --initial harmonic", "--initial and --density cannot be combined"},
          {"--density equal --method arap", "--density goes with --method bld"},
          {"--density density.ply --fill-holes all", "as the filler has no values"}})
    expect_refused("sphere.off -o no.off " + arguments, message);
  EXPECT_FALSE(fs::exists(path("no.off")));
}

TEST_F(Command_line, opens_all_that_it_reads_before_it_maps_anything)
{
  write_off("torus.off", test_meshes::torus(8, 5));
  for(const char* options :
      {"--onto missing.ply", "--onto sphere.off --landmarks sphere.off missing.ply",
       "--onto sphere.off --features missing.ply sphere.ply", "--remesh cube=3 --transfer missing.ply",
       "--remesh cube=3 --transfer sphere.ply --values-sphere missing.ply"})
  {
    write("sphere.ply", "");
    expect_message(std::string("torus.off ") + options, "missing.ply: No such file");
  }
}

// The pixels, decoded by the libraries of the formats, are those of the surface over an octahedron.
TEST_F(Command_line, writes_geometry_images)
{
  const auto expect_pixels = [&](const test::Decoded_image& image, const auto& values, double tolerance) {
    const SP::internal::Geometry_image_layout layout = SP::internal::Geometry_image_layout::of_octahedron(4);
    ASSERT_EQ(image.width, 9u);
    ASSERT_EQ(image.height, 9u);
    ASSERT_EQ(image.channels.size(), 3u);
    for(std::size_t k = 0; k < layout.vertices.size(); ++k)
      for(std::size_t c = 0; c < 3; ++c)
        ASSERT_NEAR(image.channels[c].at(k), values[Vertex_index(layout.vertices[k])][static_cast<int>(c)], tolerance)
            << k << ' ' << c;
  };
  [[maybe_unused]] const auto expect_images = [&](const std::string& format, const auto& decode, double tolerance) {
    const Outcome outcome = run("sphere.off --geometry-image image." + format + " --image-size 9 -o map.off");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Library_remesh expected(mesh_in("sphere.off"), mesh_in("map.off"), SP::Sphere_domain_3::octahedron(4));
    expect_pixels(decode(content(path("image." + format))), expected.mesh.points(), tolerance);
    expect_pixels(decode(content(path("image_normals." + format))), expected.normals, tolerance);
  };
#ifdef TEST_PNG
  expect_images("png", test::decode_png, 2.01 / 65535. / 2.);
#endif
#ifdef TEST_EXR
  expect_images("exr", test::decode_exr, 6e-8);
#endif
}

#ifdef TEST_EXR
TEST_F(Command_line, writes_no_image_of_what_its_numbers_cannot_hold)
{
  for(const double scale : {1e-50, 1e50})
  {
    write_off("scaled.off", test_meshes::scaled(test_meshes::icosphere(1), scale, scale, scale));
    const Outcome outcome = run("scaled.off --geometry-image image.exr");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("image.exr: The values are too large, or all too small"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(fs::exists(path("image.exr")));
    EXPECT_EQ(run("scaled.off --geometry-image image.png").status, 0);
  }
}
#endif

TEST_F(Command_line, writes_a_page)
{
  const std::string name = "a<!--b.off";
  write_off(name, test_meshes::icosphere(2));
  const Outcome outcome = run("'" + name + "' --page page.html --quiet");
  if(outcome.status == 1 && outcome.err.find("was built without the page") != std::string::npos)
  {
    EXPECT_FALSE(fs::exists(path("page.html")));
    GTEST_SKIP() << outcome.err;
  }
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string page = content(path("page.html"));
  EXPECT_EQ(page.substr(0, 15), "<!DOCTYPE html>");
  EXPECT_EQ(page.find("<!--b"), std::string::npos); // a comment that would swallow the page
  EXPECT_NE(page.find("a\\u003c!--b.off"), std::string::npos);

  const std::string begin = "id=\"corners\">"; // of 320 faces, with two bytes each
  const std::size_t start = page.find(begin) + begin.size();
  EXPECT_EQ(page.find("</script>", start) - start, 320u * 3 * 2 / 3 * 4);
  const std::string folds = "id=\"folded\"></script>";
  EXPECT_NE(page.find(folds), std::string::npos);

  // two surfaces: the common refinement, and for each of its triangles both faces
  write_off("long.off", test_meshes::scaled(test_meshes::icosphere(2), 1., 1.5, 2.5));
  ASSERT_EQ(run("long.off --onto sphere.off --page page.html --overlay overlay.ply --quiet").status, 0);
  const std::string overlay = content(path("overlay.ply")), two = content(path("page.html"));
  const std::size_t n = std::stoul(overlay.substr(overlay.find("element face ") + 13));
  for(const std::string id : {"left_faces", "right_faces"})
  {
    const std::size_t first = two.find("id=\"" + id + "\">") + id.size() + 6;
    EXPECT_EQ(two.find("</script>", first) - first, (4 * n + 2) / 3 * 4) << id;
  }
}

// What is wrong with the domain or the map is told before anything is written.
TEST_F(Command_line, samples_by_spheres_only)
{
  write_off("torus.off", test_meshes::torus(6, 6));
  write_off("far.off", test_meshes::scaled(test_meshes::icosphere(1), 1., 1., 0.));
  expect_refused("sphere.off --remesh torus.off -o result.off", "genus");
  expect_refused("sphere.off --remesh far.off -o result.off", "is no mesh of the sphere to sample by");
  expect_refused("sphere.off --remesh missing.off -o result.off", "or the name of a file");
  expect_refused("sphere.off --remesh cube=2 -o result.off --sphere result.off", "written twice");
  expect_refused("sphere.off --remesh cube=2 --output-folder out", "leave out --output-folder");
  expect_refused("sphere.off --page page.html --output-folder out", "leave out --output-folder");
}

TEST_F(Command_line, refuses_bad_values_with_the_good_ones)
{
  const std::vector<std::pair<const char*, const char*>> table = {
      {"--method tutte", "bld, hierarchical, harmonic, conformal, arap, stereographic or schnyder"},
      {"--energy elastic", "symmetric-dirichlet, isometric or conformal"},
      {"--prefer best", "average, balance, worst or sampling"},
      {"--initial spherical", "hierarchical, stereographic, harmonic, conformal or schnyder, or the name of a file"},
      {"--radius 2", "objective, two-phase, optimal, area, balanced or fixed=R"},
      {"--paper --radius objective", "has to be two-phase, optimal, area, balanced or fixed=R"},
      {"--tolerance -1", "a number from 0 to 1"},
      {"--tolerance nan", "a number from 0 to 1"},
      {"--radius fixed=0", "a number R from 2.3e-308 to 1.7e308"},
      {"--radius fixed=-1", "a number R from 2.3e-308"},
      {"--radius fixed=1e-320", "a number R from 2.3e-308"},
      {"--radius fixed=nan", "a number R from 2.3e-308"},
      {"--radius fixed=inf", "a number R from 2.3e-308"},
      {"--radius fixed=", "a number R from 2.3e-308"},
      {"--radius fixed=1x", "a number R from 2.3e-308"},
      {"--sharpness -1", "from 0 to 1e6"},
      {"--sharpness nan", "from 0 to 1e6"},
      {"--s-first 0", "from 2.3e-308 to 1e6"},
      {"--s-last 1e7", "from 2.3e-308 to 1e6"},
      {"--s-first 5 --s-last 1", "0 < s-first <= s-last"},
      {"--s-first 20", "0 < s-first <= s-last"},
      {"--s-last 1 --average-sweeps -1", "a whole number from 0"},
      {"--s-last 1 --average-sweeps 1.5", "a whole number from 0"},
      {"--iterations -1", "a whole number from 0"},
      {"--iterations many", "a whole number from 0"},
      {"--time-limit -1", "from 2.3e-308 to 1.7e308"},
      {"--time-limit 1e-320", "from 2.3e-308 to 1.7e308"},
      {"--threads 0", "a whole number from 1"},
      {"--remesh octahedron=0", "a whole number N from 1 to 5000"},
      {"--remesh octahedron=1.5", "a whole number N from 1 to 5000"},
      {"--remesh octahedron=1e9", "a whole number N from 1 to 5000"},
      {"--remesh prism=3", "octahedron=N, cube=N or icosahedron=N"},
      {"--remesh cube=2 --transfer sphere.off", "--transfer needs .ply files"},
      {"--geometry-image image.gif", ".png or .exr"},
      {"--page page.txt", "a name that ends with .html"},
      {"--geometry-image image.png --image-size 64", "an odd number from 3 to 10001"},
      {"--geometry-image image.png --image-size 1", "a whole number from 3"},
      {"--unknown", "unknown"},
  };
  for(const auto& [arguments, valid] : table)
    expect_refused(std::string("sphere.off -o result.off --json result.json ") + arguments, valid);
  expect_refused("", "INPUT");
}

TEST_F(Command_line, refuses_options_that_would_be_ignored)
{
  const std::vector<std::pair<const char*, const char*>> table = {
      {"--s-first 1 --prefer worst", "--s-first and --prefer"},
      {"--sharpness 1 --prefer worst", "--prefer and --sharpness"},
      {"--energy isometric --prefer sampling", "leave out --energy"},
      {"--s-last 3 --sharpness 1", "--s-last and --sharpness"},
      {"--average-sweeps 5", "--s-first, --s-last or --paper"},
      {"--average-sweeps 5 --sharpness 1", "--average-sweeps and --sharpness"},
      {"--method harmonic --energy isometric", "bld or hierarchical"},
      {"--method harmonic --initial stereographic", "bld or arap"},
      {"--method arap --sharpness 1", "bld or hierarchical"},
      {"--method arap --radius area", "arap knows --initial, --iterations and --time-limit"},
      {"--method conformal --radius area", "conformal knows --iterations and --time-limit"},
      {"--method stereographic --iterations 5", "bld, harmonic, conformal or arap"},
      {"--method stereographic --time-limit 5", "stereographic has no settings"},
      {"--method hierarchical --iterations 5", "hierarchical knows --energy, --prefer, --sharpness"},
      {"--method hierarchical --s-first 1", "--method bld"},
      {"--paper --method bld", "--method"},
      {"--paper --energy isometric", "--initial, --s-first, --s-last, --average-sweeps, --radius, --iterations"},
      {"--paper --prefer worst", "--initial, --s-first"},
      {"--paper --sharpness 1", "--initial, --s-first"},
      {"--method harmonic --tolerance 0", "--tolerance goes with --method bld"},
      {"--paper --tolerance 0", "--initial, --s-first"},
      {"--sphere result2.off", "--sphere goes with --remesh"},
      {"--transfer values.ply", "--transfer goes with --remesh"},
      {"--image-size 65", "--image-size goes with --geometry-image"},
      {"--remesh cube=2 --values-sphere sphere.off", "--values-sphere goes with --transfer"},
      {"--remesh cube=2 --transfer values.ply", "the name of a .ply or .gii file, as other formats"},
  };
  for(const auto& [arguments, valid] : table)
    expect_refused(std::string("sphere.off -o result.off --json result.json ") + arguments, valid);
}

TEST_F(Command_line, refuses_what_it_cannot_read_or_write)
{
  expect_refused("missing.off -o result.off", "missing.off");
  write("mesh.xyz", "0 0 0\n");
  expect_refused("mesh.xyz -o result.off", ".off");
  expect_refused("sphere.off -o missing/result.off", "missing");
  expect_refused("sphere.off -o result.txt", ".off");
  expect_refused("sphere.off -o result.off --json missing/result.json", "missing");
  expect_refused("sphere.off -o result.off --colored missing/result", "missing");
  expect_refused("sphere.off -o result.off --page missing/result.html", "missing");
  fs::create_directory(path("folder.off"));
  expect_refused("sphere.off -o folder.off", "folder.off");
  expect_refused("folder.off -o result.off", "folder.off is a folder");
  fs::create_symlink("/dev/zero", path("zeros.off")); // which never ends
  expect_refused("zeros.off -o result.off", "zeros.off: this is a pipe or a device");
  expect_refused("'' -o result.off", "No such file or directory");
}

TEST_F(Command_line, writes_no_file_twice)
{
  for(const char* options : {"-o twice.off --json ./twice.off", "-o ./twice.off --json twice.off",
                             "-o twice_sphere.ply --colored ./twice", "-o twice.off --json twice.off"})
  {
    const Outcome outcome = run(std::string("sphere.off ") + options);
    EXPECT_EQ(outcome.status, 1) << options;
    EXPECT_NE(outcome.err.find("would be written twice"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(path("twice.off")));
  }
}

TEST_F(Command_line, reads_landmarks_with_any_ends_of_lines)
{
  for(const char* ends : {"0\n5\n9\n", "0\r5\r9\r", "0\r\n5\r\n9", "0\r5 a\n9"})
  {
    write("ends.txt", ends);
    EXPECT_EQ(run("sphere.off --onto sphere.off --landmarks ends.txt ends.txt --json result.json").status, 0);
    EXPECT_EQ(json().get_child("match.landmark_distances").size(), 3u);
  }
}

TEST_F(Command_line, writes_through_a_link_or_a_pipe_that_is_named)
{
  fs::create_directory(path("elsewhere"));
  write("elsewhere/target.off", "");
  fs::permissions(path("elsewhere/target.off"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("elsewhere/target.off", path("link.off"));
  ASSERT_EQ(run("sphere.off -o link.off --quiet").status, 0);
  EXPECT_TRUE(fs::is_symlink(path("link.off")));
  ASSERT_EQ(run("sphere.off -o result.off --quiet").status, 0);
  const std::string expected = content(path("result.off"));
  EXPECT_EQ(content(path("elsewhere/target.off")), expected);
  EXPECT_EQ(fs::status(path("elsewhere/target.off")).permissions(), fs::perms::owner_read | fs::perms::owner_write);

  fs::create_symlink("elsewhere/new.off", path("dangling.off"));
  ASSERT_EQ(run("sphere.off -o dangling.off --quiet").status, 0);
  EXPECT_TRUE(fs::is_symlink(path("dangling.off")));
  EXPECT_EQ(content(path("elsewhere/new.off")), expected);
  fs::create_symlink("nowhere/new.off", path("lost.off"));
  EXPECT_EQ(run("sphere.off -o lost.off --quiet").status, 1);

  // the reader of the pipe gets all of it, and not its end before
  EXPECT_EQ(run_script("mkfifo pipe.off; timeout 60 cat pipe.off > read.off & timeout 60 \"$PROGRAM\" sphere.off -o "
                       "pipe.off --quiet && wait $!")
                .status,
            0);
  EXPECT_EQ(content(path("read.off")), expected);
}

TEST_F(Command_line, prints_the_report_as_JSON)
{
  const Outcome outcome = run("sphere.off -o result.off --json -");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  write("result.json", outcome.out);
  EXPECT_EQ(json().get<std::size_t>("vertices"), 162u);
  EXPECT_FALSE(fs::exists(path("-")));
  EXPECT_EQ(run("sphere.off -o result.off --json - --quiet").out.substr(0, 1), "{"); // it was asked for
}

TEST_F(Command_line, fails_where_its_output_cannot_be_written)
{
  for(const char* arguments :
      {"sphere.off", "sphere.off --json -", "--help", "--version", "sphere.off --output-folder out"})
  {
    const Outcome outcome = run(std::string(arguments) + " > /dev/full");
    EXPECT_EQ(outcome.status, 1) << arguments;
    EXPECT_EQ(outcome.err, "spherical_parameterization: the standard output cannot be written\n") << arguments;
  }
  // the map is not lost
  const Outcome full = run("sphere.off -o result.off > /dev/full");
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.err, "spherical_parameterization: the standard output cannot be written. All files have been written "
                      "nevertheless.\n");
  EXPECT_EQ(run("sphere.off --initial result.off --iterations 0").status, 0);
  fs::remove(path("result.off"));
  // no file gets the place of a stream that is closed, and with it what is meant for that: the file here is a pipe
  write_off("long.off", test_meshes::icosphere(4));
  EXPECT_EQ(
      run_script("mkfifo pipe.off; \"$PROGRAM\" long.off -o pipe.off --iterations 0 --quiet >&- & exec 3< pipe.off; "
                 "head -c 1 <&3 | wc -c; readlink /proc/$!/fd/1; cat <&3 > rest.off; wait $!")
          .out,
      "1\n/dev/null\n");
  for(const char* name : {"long.off", "pipe.off", "rest.off"})
    fs::remove(path(name));
  // a limit of the size is no reason to die of a signal, and leaves nothing
  const Outcome outcome = run_script("ulimit -f 1; \"$PROGRAM\" sphere.off -o result.off --quiet");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "spherical_parameterization: result.off: cannot be written: File too large\n");
  EXPECT_EQ(names_of_files(), (std::set<std::string>{"sphere.off", "out", "stdout.txt", "stderr.txt"}));
}

TEST(Program_messages, call_what_is_the_same_by_the_same_words)
{
  EXPECT_EQ(::Program::message_of(std::bad_alloc()), "the memory does not suffice");
  EXPECT_EQ(::Program::message_of(::Program::Program_error("a\nb", "c")), "a\\x0ab: c");
}

std::string too_many_threads(unsigned int n_wanted, unsigned int n_had)
{
  return "spherical_parameterization: --threads " + std::to_string(n_wanted) + ": no more than " +
         std::to_string(n_had) + " can be had here\n";
}

TEST_F(Command_line, runs_on_one_thread_where_no_other_can_be_had)
{
  // The limit does not hold for root.
  const std::string limited = "$([ \"$(id -u)\" != 0 ] || echo setpriv --reuid=65534 --regid=65534 --clear-groups) "
                              "prlimit --nproc=1 ";
  if(run_script(limited + "\"$PROGRAM\" --version").status != 0)
    GTEST_SKIP() << "The program cannot be run by a user with a limit of processes, or under a sanitizer.";
  for(const std::string threads : {"", "--threads 1", "--threads 3"})
  {
    const Outcome outcome = run_script(limited + "\"$PROGRAM\" sphere.off " + threads);
    EXPECT_EQ(outcome.status, 0) << threads;
    EXPECT_EQ(outcome.err, threads == "--threads 3" ? too_many_threads(3, 1) : "");
  }
}

// Each thread would have memory of its own.
TEST_F(Command_line, uses_no_more_threads_than_there_are_cores)
{
  const unsigned int n_cores = (std::max)(std::thread::hardware_concurrency(), 1u);
  const std::string limited = "( ulimit -v 4000000; \"$PROGRAM\" ";
  if(run_script(limited + "--version )").status != 0)
    GTEST_SKIP() << "The program cannot be run with a limit of memory, as under a sanitizer.";
  const Outcome outcome = run_script(limited + "sphere.off --threads 100000000 )");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, too_many_threads(100000000, n_cores));
  EXPECT_EQ(run("sphere.off --quiet --threads 100000000").err, "");
}

TEST_F(Command_line, takes_names_of_any_bytes)
{
  const std::string name = "a\xff\xc3\xa4\n\x1b[31m\xc2\x9b.off", shown = "a\\xff\xc3\xa4\\x0a\\x1b[31m\\xc2\\x9b.off";
  fs::create_directory(path("in"));
  fs::copy_file(path("sphere.off"), path("in/" + name));
  const Outcome outcome = run("in --output-folder out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 9 + shown.size()), "[1/1] in/" + shown) << outcome.out;
  EXPECT_EQ(json("out/" + name.substr(0, name.size() - 3) + "json").get<std::string>("input"),
            "in/a\\xff\xc3\xa4\n\x1b[31m\xc2\x9b.off");
  EXPECT_NE(run("in --output-folder out --resume").out.find("left out 1"), std::string::npos);
  const std::string single = run("'in/" + name + "' -o 'out/" + name + "'").out;
  EXPECT_NE(single.find("Mesh      in/" + shown), std::string::npos) << single;
  EXPECT_NE(single.find("Written:   out/" + shown), std::string::npos) << single;
  for(const std::string& arguments : {"'missing" + name + "'", "'missing" + name + "' --output-folder out",
                                      "sphere.off --initial 'missing" + name + "'",
                                      "sphere.off -o 'missing" + name + "/x.off'", "sphere.off '--" + name + "'"})
    expect_message(arguments, shown.substr(0, shown.size() - 4));

  const std::string long_name = std::string(246, 'x') + ".off"; // there is room for .json, and for no more
  fs::copy_file(path("sphere.off"), path("in/" + long_name));
  EXPECT_EQ(run("in --output-folder out").status, 0);
  EXPECT_EQ(run("sphere.off -o " + std::string(251, 'y') + ".off").status, 0);
  fs::copy_file(path("sphere.off"), path("in/" + std::string(251, 'z') + ".off")); // whose report has no name
  expect_message("in --output-folder out --quiet", "zzz.json: cannot be written: File name too long");
}

TEST_F(Command_line, counts_faces_that_are_nearly_flat)
{
  test_meshes::Triangle_list list = test_meshes::icosphere(1);
  list.points[0] = list.points[list.triangles[0][1]]; // the faces between them are left without area
  list.points[1] = list.points[0];
  write_off("flat.off", list);
  const std::string out = run("flat.off").out;
  EXPECT_NE(out.find(" faces are nearly flat\n"), std::string::npos) << out;
}

TEST_F(Command_line, suggests_what_a_folder_needs)
{
  fs::create_directory(path("in"));
  expect_message("in", "in is a folder; to map the meshes in it, say with --output-folder where to");
  expect_refused("in -o result.off", "--output-folder");
}

TEST_F(Command_line, says_what_is_wrong_with_a_mesh)
{
  const auto expect = [&](const std::string& text, const std::string& message) {
    write("bad.off", text);
    expect_refused("bad.off -o result.off --json result.json --colored result", message);
  };
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  expect("OFF\n0 0 0\n", "no faces");
  expect("OFF\n4 4 0\n0 0 0\n1 nan 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "vertex 1 has a coordinate");
  expect("OFF\n4 4 0\n0 0 0\n1 inf 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "vertex 1 has a coordinate");
  expect("OFF\n4 4 0\n" + points + "3 0 2 1\n3 0 1 1\n3 1 2 3\n3 2 0 3\n", "face 1 has the vertex 1 twice");
  expect("OFF\n4 4 0\n" + points + "3 0 2 1\n2 0 1\n3 1 2 3\n3 2 0 3\n", "face 1 is not a triangle but has 2 corners");
  expect("OFF\n4 3 0\n" + points + "4 0 2 1 3\n3 1 2 3\n3 2 0 3\n", "face 0 is not a triangle but has 4 corners");
  expect("OFF\n4 3 0\n" + points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n", "the mesh has a border");
  expect(
      "OFF\n4 4 0\n" + points + "3 0 1 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
      "the faces 0 and 1 are oriented against each other: both use the edge between the vertices 0 and 1 in the same");
  expect("OFF\n4 5 0\n" + points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 1 0 2\n",
         "the faces 0 and 4 have the same corners");
  expect("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n", "only 3 vertices have a face");
  expect("OFF\n7 8 0\n" + points +
             "-1 0 0\n0 -1 0\n0 0 -1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
             "3 0 4 5\n3 0 6 4\n3 4 6 5\n3 5 6 0\n",
         "the surface touches itself in vertex 0");
  expect("OFF\n12 4 0\n0 0 0\n0 1 0\n1 0 0\n0 0 0\n1 0 0\n0 0 1\n1 0 0\n0 1 0\n0 0 1\n0 1 0\n0 0 0\n0 0 1\n"
         "3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n",
         "8 vertices repeat the position of another one");
  // before the map to start from
  write("start.off", "");
  expect_message("bad.off --initial start.off", "the mesh has a border");
}

const test_meshes::Triangle_list corner = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

template <class Coordinate, class Index>
std::string binary_ply(bool is_big_endian, const std::string& coordinate, const std::string& index)
{
  Binary_file file(is_big_endian);
  file << "ply\nformat binary_" + std::string(is_big_endian ? "big" : "little") + "_endian 1.0\ncomment a corner\n" +
              "element camera 1\nproperty list uchar short view\nelement vertex 4\nproperty uchar red\nproperty " +
              coordinate + " x\nproperty " + coordinate + " y\nproperty " + coordinate +
              " z\nelement face 4\nproperty list uchar " + index +
              " vertex_indices\nproperty uchar label\nend_header\n";
  file << std::uint8_t(2) << std::int16_t(-7) << std::int16_t(8);
  for(const test_meshes::Coordinates& p : corner.points)
  {
    file << std::uint8_t(255);
    for(const double x : p)
      file << static_cast<Coordinate>(x);
  }
  for(const test_meshes::Triangle& t : corner.triangles)
  {
    file << std::uint8_t(3);
    for(const std::size_t v : t)
      file << static_cast<Index>(v);
    file << std::uint8_t(9);
  }
  return file.content;
}

std::string binary_stl(const std::string& title, std::uint32_t number_of_facets, float first_coordinate = 0.f)
{
  Binary_file file(false);
  file << title + std::string(80 - title.size(), '\0') << number_of_facets;
  for(const test_meshes::Triangle& t : corner.triangles)
  {
    file << 0.f << 0.f << 0.f;
    for(const std::size_t v : t)
    {
      const test_meshes::Coordinates p = corner.points[v];
      file << (v == 0 ? first_coordinate : static_cast<float>(p[0])) << static_cast<float>(p[1])
           << static_cast<float>(p[2]);
    }
    file << std::int16_t(0);
  }
  return file.content;
}

std::string in_capitals(std::string text)
{
  for(char& c : text)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  for(std::size_t i = text.find(from); i != std::string::npos; i = text.find(from, i + to.size()))
    text.replace(i, from.size(), to);
  return text;
}

const std::string corner_ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
                               "float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
                               "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const std::string corner_ts =
    "GOCAD TSurf 1\nHEADER {\nname:corner\n}\nTFACE\nVRTX 0 0 0 0\nVRTX 1 1 0 0\nVRTX 2 0 1 0\n"
    "VRTX 3 0 0 1\nTRGL 0 2 1\nTRGL 0 1 3\nTRGL 1 2 3\nTRGL 2 0 3\nEND\n";

TEST_F(Command_line, reads_every_format_alike)
{
  write("corner.off", corner_off);
  ASSERT_EQ(run("corner.off -o expected.off --quiet").status, 0);
  const std::string expected = content(path("expected.off"));
  const std::string homogeneous = "4 4 6\n0 0 0 2\n2 0 0 2\n0 0.5 0 0.5\n0 0 -1 -1\n", faces = corner_off.substr(34);
  const std::vector<std::pair<const char*, std::string>> table = {
      {"variant.off", "OFF 4 4" + corner_off.substr(7)},
      {"variant.off", "# a comment\n\n" + replaced(corner_off, "\n", " # another\r\n\r\n")},
      {"variant.off", "\xEF\xBB\xBF" + corner_off + "\n# and more\n\n"},
      {"variant.off", "4OFF\n" + homogeneous + faces},
      {"variant.off", "nOFF\n3\n" + corner_off.substr(4)},
      {"variant.off", "C4nOFF 3\n" + replaced(homogeneous, "2\n", "2 0.5 0.5 0.5 1\n") + faces},
      {"variant.obj", corner_obj},
      {"variant.obj", "mtllib a.mtl\no a\ng b\nvn 0 0 1\n" + replaced(corner_obj, "\n", " \r\n") + "l 1 2\n"},
      {"variant.obj", replaced(corner_obj, " ", "\t")},
      {"variant.obj", replaced(corner_obj, "f 1 3 2", "f 1/1/1 -2//7 2/5")},
      {"variant.obj", corner_obj.substr(32) + corner_obj.substr(0, 32)},
      {"variant.ply", corner_ply},
      {"variant.ply", replaced(corner_ply, "\n", "\r\n")},
      {"variant.ply", replaced(replaced(corner_ply, "float", "int8"), "vertex_indices", "vertex_index")},
      {"variant.ply", binary_ply<float, std::uint32_t>(false, "float", "uint")},
      {"variant.ply", binary_ply<double, std::int16_t>(false, "float64", "int16")},
      {"variant.ply", binary_ply<double, std::uint8_t>(true, "double", "uchar")},
      {"variant.ply", binary_ply<std::int16_t, std::uint32_t>(true, "short", "int")},
      {"variant.ts", corner_ts},
      {"variant.ts", replaced(replaced(corner_ts, "\n", "\r\n"), "VRTX", "PVRTX")},
      {"variant.ts", replaced(replaced(corner_ts, "VRTX 3", "VRTX -7"), " 3\n", " -7\n")},
      {"variant.ts", replaced(replaced(corner_ts, "TRGL 0 2 1", "ATOM 9 2\nTRGL 0 9 1"), "END\n", "END")}};
  for(const auto& [name, text] : table)
  {
    SCOPED_TRACE(text);
    write(name, text);
    const Outcome outcome = run(std::string(name) + " -o result.off --quiet");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(content(path("result.off")), expected);
    fs::remove(path("result.off"));
  }

  // the vertices of this format have the order in which the facets name them first
  write("other.off", replaced(replaced(replaced(corner_off, "1 0 0\n0 1 0", "0 1 0\n1 0 0"), "3 0 2 1", "3 0 1 2"),
                              "3 0 1 3\n3 1 2 3\n3 2 0 3", "3 0 2 3\n3 2 1 3\n3 1 0 3"));
  ASSERT_EQ(run("other.off -o expected.off --quiet").status, 0);
  for(const std::string& text : {corner_stl, replaced(corner_stl, "\n", "\r\n"), in_capitals(corner_stl),
                                 binary_stl("a corner", 4), binary_stl("solid corner", 4)})
  {
    write("variant.stl", text);
    const Outcome outcome = run("variant.stl -o result.off --quiet");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(content(path("result.off")), content(path("expected.off")));
    fs::remove(path("result.off"));
  }
}

TEST_F(Command_line, says_where_a_file_is_damaged)
{
  const std::string little = binary_ply<float, std::uint32_t>(false, "float", "uint");
  const std::string huge = std::to_string(1ull << 60);
  std::string long_list = binary_ply<float, std::uint32_t>(false, "float", "uint");
  long_list = replaced(long_list, "list uchar uint", "list uint uint");
  const std::vector<std::array<std::string, 3>> table = {
      {"bad.off", "", "the file is empty"},
      {"bad.off", "ply\n", "line 1: an OFF file begins with OFF, not with 'ply'"},
      {"bad.off", "OFF\n-4 4 0\n", "line 2: the number of vertices is negative"},
      {"bad.off", corner_off.substr(0, 50), "the file ends after 2 of 4 faces: it is truncated"},
      {"bad.off", replaced(corner_off, "1 0 0", "1,0 0 0"), "line 4: coordinate x of vertex 1 is not a number: '1,0'"},
      {"bad.off", replaced(corner_off, "\n1 0 0\n", "\n1 0\n"), "line 4: coordinate z of vertex 1 is missing"},
      {"bad.off", replaced(corner_off, "3 0 2 1", "-3 0 2 1"), "line 7: the number of corners of face 0 is negative"},
      {"bad.off", replaced(corner_off, "3 0 2 1", "9 0 2 1"), "line 7: corner 3 of face 0 is missing"},
      {"bad.off", corner_off + "3 0 1 2\n", "line 11: the file goes on after 4 faces with '3'"},
      {"bad.off", corner_off + "\x1b[31m\n", "line 11: the file goes on after 4 faces with a byte that is no text"},
      {"bad.off", replaced(corner_off, "3 0 2 1", "3 0 2 4"), "line 7: face 0 has the corner 4"},
      {"bad.off", replaced(corner_off, "4 4 0", huge + " 4 0"), "too short for " + huge + " vertices"},
      {"bad.off", replaced(corner_off, "4 4 0", "4 " + huge + " 0"), "too short for " + huge + " faces"},
      {"bad.off", replaced(corner_off, "OFF", "nOFF\n4"), "line 2: the dimension is 4"},
      {"bad.off", "OFF BINARY\n" + std::string(40, '\7'), "line 1: the binary variant is not read"},
      {"bad.off", corner_off.substr(0, 20) + std::string(1, '\0') + corner_off.substr(20), "a byte that is no text"},
      {"bad.off", "\x1F\x8B\x08" + corner_off, "compressed"},
      {"bad.off", std::string(100000, '\0'), "begins with nothing but zeros"},
      {"bad.obj", corner_off, "line 1: no line of an OBJ file begins with 'OFF'"},
      {"bad.obj", replaced(corner_obj, "v 1 0 0", "v 1 0"), "line 2: coordinate z of vertex 1 is missing"},
      {"bad.obj", replaced(corner_obj, "f 1 3 2", "f 1 3 2.5"), "line 5: corner 2 of face 0 should be a whole number"},
      {"bad.obj", replaced(corner_obj, "f 1 3 2", "f 0 3 2"), "line 5: face 0 has the corner 0"},
      {"bad.obj", replaced(corner_obj, "f 1 3 2", "f 1 3 -5"), "line 5: face 0 has the corner -5"},
      {"bad.obj", replaced(corner_obj, "f 1 3 2", "f 1 3 7"),
       "line 5: a face has the corner 7, but the file has 4 vertices"},
      {"bad.ply", corner_off, "line 1: a PLY file begins with ply, not with 'OFF'"},
      {"bad.ply", replaced(corner_ply, "ascii", "text"), "line 2: the format is ascii, binary_little_endian or"},
      {"bad.ply", replaced(corner_ply, "format", "comment"), "the header has no line that begins with format"},
      {"bad.ply", corner_ply.substr(0, 38), "the file ends within its header"},
      {"bad.ply", replaced(corner_ply, "vertex 4", "vertex " + huge), "too short for " + huge + " 'vertex' elements"},
      {"bad.ply", replaced(corner_ply, "face 4", "face 5"), "ends in 'face' 4 of 5"},
      {"bad.ply", replaced(corner_ply, "face 4", "face -4"), "line 7: the number of 'face' elements is negative"},
      {"bad.ply", replaced(corner_ply, "float x", "list uchar float x"), "no properties x, y and z that are numbers"},
      {"bad.ply", "ply\nformat ascii 1.0\nelement vertex " + huge + "\nend_header\n", "no properties x, y and z"},
      {"bad.ply", replaced(corner_ply, "float y", "float x"), "line 5: the same property once more"},
      {"bad.ply", replaced(corner_ply, "float x", "real x"), "line 4: the type of a property is unknown: 'real'"},
      {"bad.ply", replaced(corner_ply, "uchar int", "uchar float"), "line 8: the corners of a face have to be whole"},
      {"bad.ply", replaced(corner_ply, "uchar int", "float int"),
       "line 8: the size of a list has to be a whole number"},
      {"bad.ply", replaced(corner_ply, "vertex_indices", "indices"), "no property vertex_indices that is a list"},
      {"bad.ply", replaced(corner_ply, "3 0 2 1", "3 0 2"), "line 14: a number of 'face' 0 is missing"},
      {"bad.ply", replaced(corner_ply, "3 0 2 1", "-3 0 2 1"), "'face' 0 has a list of negative length"},
      {"bad.ply", replaced(corner_ply, "3 0 2 1", "3 0 2 -1"), "'face' 0 has a corner that does not exist"},
      {"bad.ply", replaced(corner_ply, "1 0 0", "1 0.x 0"), "line 11: a number of 'vertex' 1 is not a number"},
      {"bad.ply", little.substr(0, little.size() - 1), "ends in 'face' 3 of 4"},
      {"bad.ply", replaced(little, "vertex 4", "vertex " + huge), "too short for " + huge + " 'vertex' elements"},
      {"bad.ply", long_list, "'face' 0"},
      {"bad.stl", corner_off, "this is no STL file"},
      {"bad.stl", replaced(corner_stl, "solid facet", "Solid facet"), "this is no STL file"},
      {"bad.stl", binary_stl("a corner", 5), "nor is it long enough for the 5 facets"},
      {"bad.stl", binary_stl("a corner", 4000000000u), "for the 4000000000 facets"},
      {"bad.stl", binary_stl("a corner", 4, NAN), "facet 0 has a coordinate that is infinite or not a number"},
      {"bad.stl", replaced(corner_stl, "vertex 0 0 1", "vertex 0 inf 1"), "facet 1 has a coordinate that is infinite"},
      {"bad.stl", replaced(corner_stl, "vertex 0 0 1\n", "vertex 0 x 1\n"), "coordinate y of facet 1 is not a number"},
      {"bad.stl", replaced(corner_stl, "vertex 0 0 1\n", ""), "facet 1 has 2 vertices"},
      {"bad.stl", replaced(corner_stl, "vertex 0 0 1", "vertex 0 0 1\nvertex 1 1 1"), "facet 1 has a fourth vertex"},
      {"bad.stl", replaced(corner_stl, "endfacet\n", ""), "facet 0 does not end"},
      {"bad.stl", replaced(corner_stl, "endsolid\n", ""), "ends without endsolid"},
      {"bad.stl", replaced(corner_stl, "facet normal", "facette"), "line 2: no line of an STL file begins with"},
      {"bad.ts", corner_off, "line 1: a surface of a GOCAD file begins with GOCAD, not with 'OFF'"},
      {"bad.ts", replaced(corner_ts, "TRGL 0 2 1", "TRGL 0 2 7"), "line 10: corner 2 is the vertex 7"},
      {"bad.ts", replaced(corner_ts, "VRTX 2", "VRTX 1"), "line 8: the vertex 1 exists already"},
      {"bad.ts", replaced(corner_ts, "VRTX 2 0 1", "VRTX 2 0 y"), "line 8: coordinate y of vertex 2 is not a number"},
      {"bad.ts", replaced(corner_ts, "END\n", ""), "ends without END"}};
  for(const auto& [name, text, message] : table)
  {
    write(name, text);
    expect_refused(name + " -o result.off --json result.json --colored result", message);
  }
}

TEST_F(Command_line, counts_the_faces_of_an_edge_that_has_many)
{
  const std::size_t n = 50000;
  std::string points = "0 0 0\n1 0 0\n", faces;
  for(std::size_t i = 0; i < n; ++i)
  {
    points += "0 1 " + std::to_string(i) + "\n";
    faces += "3 0 1 " + std::to_string(i + 2) + "\n";
  }
  const std::string text = "OFF\n" + std::to_string(n + 2) + " " + std::to_string(n + 1) + " 0\n" + points + faces;
  write("book.off", text + "3 0 1 2\n");
  expect_refused("book.off -o result.off", "the faces 0 and 50000 have the same corners");
  write("book.off", text + "3 0 2 3\n");
  expect_refused("book.off -o result.off", "the edge between the vertices 0 and 1 has 50000 faces");
}

TEST_F(Command_line, refuses_every_invalid_mesh_of_the_corpus)
{
  const fs::path folder = fs::path(SPHERICAL_PARAMETERIZATION_SHARED_DATA_DIR) / "nasty";
  if(!fs::exists(folder))
    GTEST_SKIP() << "The corpus is not there.";
  std::size_t number_of_meshes = 0;
  for(const fs::directory_entry& entry : fs::directory_iterator(folder))
    if(entry.path().filename().string().rfind("invalid_", 0) == 0)
    {
      expect_refused("'" + entry.path().string() + "' -o result.off", entry.path().filename().string());
      ++number_of_meshes;
    }
  EXPECT_GT(number_of_meshes, 20u);
}

} // namespace

#endif
