// Holes are filled such that the surface can be mapped, whatever their borders look like, and what was there stays as it is.

#include "judge.h"
#include "methods.h"
#include "random_meshes.h"

#include <CGAL/Spherical_parameterization/Repair/fill_holes.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

using namespace test;

namespace {

using Holes = std::vector<SP::Filled_hole<Mesh>>;

// without the faces at these vertices
Triangle_list without_stars(Triangle_list list, const std::set<std::size_t>& vertices)
{
  const auto is_at_one = [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](std::size_t v) { return vertices.count(v) > 0; });
  };
  list.triangles.erase(std::remove_if(list.triangles.begin(), list.triangles.end(), is_at_one), list.triangles.end());
  return list;
}

// Fills the holes, and expects a surface that is mapped, with all vertices and faces that were there.
Holes expect_filled(const Triangle_list& list)
{
  Mesh mesh = make(list);
  const std::vector<Triangle> before = triangles(mesh);
  Holes holes;
  EXPECT_EQ(SP::fill_holes(mesh, holes), SP::OK);
  const std::vector<Triangle> all = triangles(mesh);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), all.begin()));
  const Images all_points = points(mesh);
  EXPECT_TRUE(std::equal(list.points.begin(), list.points.end(), all_points.begin()));
  const auto defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::OK) << defect.message;
  std::size_t n_new = 0;
  double share = 0.;
  for(const auto& hole : holes)
  {
    EXPECT_GE(hole.number_of_edges, 3u);
    EXPECT_GE(hole.faces.size() + 2, hole.number_of_edges);
    EXPECT_GE(hole.perimeter, 0.);
    n_new += hole.faces.size();
    share += hole.share;
    for(const auto f : hole.faces)
      EXPECT_GE(std::size_t(f), list.triangles.size());
  }
  EXPECT_EQ(n_new, all.size() - list.triangles.size());
  EXPECT_LE(share, 1. + 1e-12);
  const Result result = bijective().run(mesh, Options().iterations(5));
  EXPECT_EQ(result.error, SP::OK);
  EXPECT_TRUE(judge::is_one_to_one(result.images, all));
  return holes;
}

TEST(Fill_holes, leaves_a_surface_that_can_be_mapped)
{
  const Triangle_list list = bumpy_sphere(3);
  EXPECT_TRUE(expect_filled(list).empty());
  const Holes one = expect_filled(without_stars(list, {20}));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_GT(one[0].share, 0.);
  EXPECT_LT(one[0].share, 0.1);
  Triangle_list without_face = list;
  without_face.triangles.pop_back();
  EXPECT_EQ(expect_filled(without_face).at(0).faces.size(), 1u);

  std::set<std::size_t> one_side;
  for(std::size_t v = 0; v < list.points.size(); ++v)
    if(list.points[v][0] > 0.5)
      one_side.insert(v);
  EXPECT_EQ(expect_filled(without_stars(list, one_side)).size(), 1u);
}

// Scans and models as people have them: with necks, and with holes below
TEST(Fill_holes, closes_the_open_surfaces_of_CGAL)
{
  for(const char* name :
      {"head", "lion", "mannequin-devil", "nefertiti", "mech-holes-shark", "ChineseDragon-10kv", "blade"})
  {
    SCOPED_TRACE(name);
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(CGAL::data_file_path(std::string("meshes/") + name + ".off"), mesh))
      GTEST_SKIP() << "There are no meshes of CGAL here.";
    EXPECT_EQ(SP::find_defect(mesh).error, SP::ERROR_NON_CLOSED_MESH);
    EXPECT_FALSE(expect_filled({points(mesh), triangles(mesh)}).empty());
  }
}

TEST(Fill_holes, fills_hundreds)
{
  Triangle_list list = bumpy_sphere(5);
  std::set<std::size_t> used;
  const auto is_used = [&](std::size_t v) { return used.count(v) > 0; };
  std::vector<Triangle> kept;
  for(const Triangle& t : list.triangles)
    if(std::none_of(t.begin(), t.end(), is_used))
      used.insert(t.begin(), t.end());
    else
      kept.push_back(t);
  const std::size_t n_removed = list.triangles.size() - kept.size();
  EXPECT_GT(n_removed, 1000u);
  list.triangles = kept;
  EXPECT_EQ(expect_filled(list).size(), n_removed);
}

// All of these are disks: what they are filled with is as large as they are.
TEST(Fill_holes, closes_what_is_all_hole)
{
  EXPECT_EQ(expect_filled({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).size(), 1u);
  EXPECT_EQ(expect_filled({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}}).size(), 1u);
  for(const std::size_t n : std::vector<std::size_t>{3, 4, 50, 1000})
  {
    Triangle_list fan = without_stars(test_meshes::scaled(suspension(n), 1., 1., 0.), {n + 1});
    fan.points.pop_back();
    const Holes holes = expect_filled(fan);
    ASSERT_EQ(holes.size(), 1u);
    EXPECT_EQ(holes[0].number_of_edges, n);
    EXPECT_NEAR(holes[0].share, 0.5, 0.2);
  }
}

TEST(Fill_holes, does_not_depend_on_sizes_and_shapes)
{
  const Triangle_list list = without_stars(bumpy_sphere(2), {20, 33});
  const Holes holes = expect_filled(list);
  for(const double scale : {1e-290, 1e-40, 1e40, 1e290})
  {
    const Holes scaled = expect_filled(test_meshes::scaled(list, scale, scale, scale));
    ASSERT_EQ(scaled.size(), holes.size());
    for(std::size_t k = 0; k < holes.size(); ++k)
    {
      EXPECT_EQ(scaled[k].number_of_edges, holes[k].number_of_edges);
      EXPECT_NEAR(scaled[k].perimeter / scale / holes[k].perimeter, 1., 1e-12);
    }
  }
  EXPECT_EQ(expect_filled(test_meshes::scaled(list, 1., 1., 0.)).size(), 2u);
  const Holes in_one_place = expect_filled(test_meshes::scaled(list, 0., 0., 0.));
  ASSERT_EQ(in_one_place.size(), 2u);
  EXPECT_EQ(in_one_place[0].share, 0.);
}

TEST(Fill_holes, leaves_large_ones_open)
{
  Mesh mesh = make(without_stars(bumpy_sphere(2), {0, 100})); // of five and six edges
  Holes holes;
  EXPECT_EQ(SP::fill_holes(mesh, holes, CGAL::parameters::maximum_number(5)), SP::OK);
  ASSERT_EQ(holes.size(), 2u);
  for(const auto& hole : holes)
    EXPECT_EQ(hole.faces.empty(), hole.number_of_edges > 5) << hole.number_of_edges;
  EXPECT_EQ(SP::find_defect(mesh).count, 6u); // edges on the border
}

TEST(Fill_holes, tells_where_borders_touch)
{
  const Triangle_list bow = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  Triangle_list diagonal = octahedron();
  diagonal.triangles = {diagonal.triangles[0], diagonal.triangles[2], diagonal.triangles[5], diagonal.triangles[7]};
  for(const Triangle_list& list : {bow, diagonal})
  {
    Mesh mesh = make(list);
    Holes holes;
    EXPECT_EQ(SP::fill_holes(mesh, holes), SP::ERROR_NO_SIMPLICIAL_COMPLEX);
    ASSERT_EQ(holes.size(), 1u);
    EXPECT_LT(std::size_t(holes[0].vertex), list.points.size());
    EXPECT_EQ(triangles(mesh), triangles(make(list)));
  }
}

TEST(Fill_holes, refuses_points_that_are_not_finite)
{
  Triangle_list list = without_stars(bumpy_sphere(2), {20});
  list.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  Mesh mesh = make(list);
  Holes holes;
  EXPECT_EQ(SP::fill_holes(mesh, holes), SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_TRUE(holes.empty());
  EXPECT_EQ(triangles(mesh), triangles(make(list)));
}

} // namespace
