// Whatever is wrong with a surface, what is made of it can be mapped, and most of it is what it was.

#include "indexed_meshes.h"
#include "judge.h"
#include "methods.h"
#include "random_meshes.h"
#include "test_scale.h"

#include <CGAL/Spherical_parameterization/Repair/repair_surface.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>

using namespace test;

namespace {

using Polygons = std::vector<std::vector<std::size_t>>;
using Repaired = SP::Repaired_surface<Point_3>;

struct Soup
{
  Images points;
  Polygons polygons;
};

Soup soup_of(const Triangle_list& list)
{
  Soup soup;
  soup.points = list.points;
  for(const Triangle& t : list.triangles)
    soup.polygons.emplace_back(t.begin(), t.end());
  return soup;
}

std::vector<Point_3> points_of(const Images& images)
{
  std::vector<Point_3> result;
  for(const Coordinates& p : images)
    result.emplace_back(p[0], p[1], p[2]);
  return result;
}

SP::Error_code repair(const Soup& soup, Repaired& result, SP::Repair_report& report,
                      const SP::Repair_limits& limits = SP::Repair_limits())
{
  return SP::repair_surface(points_of(soup.points), soup.polygons, result, report, limits);
}

double area(const Images& points, const std::vector<std::size_t>& t)
{
  const Coordinates a = combination(1., points[t[1]], -1., points[t[0]]),
                    b = combination(1., points[t[2]], -1., points[t[0]]);
  const Coordinates n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return 0.5 * std::sqrt(dot(n, n));
}

// Repairs a soup, and expects a surface that is mapped, each of whose triangles is a part of the polygon that it is said to come from.
SP::Repair_report expect_repaired(const Soup& soup, const SP::Repair_limits& limits = SP::Repair_limits())
{
  Repaired repaired;
  SP::Repair_report report;
  EXPECT_EQ(repair(soup, repaired, report, limits), SP::OK) << report.message;
  Triangle_list list;
  for(const Point_3& p : repaired.points)
    list.points.push_back({p.x(), p.y(), p.z()});
  for(std::size_t v = 0; v < list.points.size(); ++v)
    EXPECT_TRUE(repaired.source_vertices[v] == Repaired::none ||
                list.points[v] == soup.points[repaired.source_vertices[v]]);
  double old_area = 0., new_area = 0.;
  for(std::size_t f = 0; f < repaired.triangles.size(); ++f)
  {
    const auto& t = repaired.triangles[f];
    list.triangles.push_back({t[0], t[1], t[2]});
    const std::size_t source = repaired.source_faces[f];
    (source == Repaired::none ? new_area : old_area) += area(list.points, {t[0], t[1], t[2]});
    if(source == Repaired::none)
      continue;
    for(const std::size_t v : t)
      if(const std::size_t w = repaired.source_vertices[v]; w != Repaired::none)
      {
        const auto& polygon = soup.polygons[source];
        EXPECT_TRUE(std::any_of(polygon.begin(), polygon.end(),
                                [&](std::size_t u) { return u == w || soup.points[u] == soup.points[w]; }));
      }
  }
  EXPECT_LE(report.added_area, limits.maximum_added_area);
  EXPECT_NEAR(new_area / (old_area + new_area), report.added_area, 0.01);
  const Mesh mesh = make(list);
  const auto defect = SP::find_defect(mesh);
  EXPECT_EQ(defect.error, SP::OK) << defect.message;
  const Result result = bijective().run(mesh, Options().iterations(2));
  EXPECT_EQ(result.error, SP::OK);
  EXPECT_TRUE(judge::is_one_to_one(result.images, list.triangles));
  return report;
}

TEST(Repair_surface, leaves_what_is_in_order)
{
  const Soup soup = soup_of(bumpy_sphere(3));
  Repaired repaired;
  SP::Repair_report report;
  EXPECT_EQ(repair(soup, repaired, report), SP::OK);
  EXPECT_TRUE(report.is_empty());
  EXPECT_EQ(repaired.points, points_of(soup.points));
  ASSERT_EQ(repaired.triangles.size(), soup.polygons.size());
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
    EXPECT_TRUE(std::equal(soup.polygons[f].begin(), soup.polygons[f].end(), repaired.triangles[f].begin()));
}

// Puts so many defects of a kind into a mesh.
using Defects = std::function<void(Soup&, std::size_t, Random&)>;

std::map<std::string, Defects> kinds_of_defects()
{
  std::map<std::string, Defects> kinds;
  const auto each = [](const std::function<void(Soup&, Random&)>& f) {
    return [f](Soup& soup, std::size_t n, Random& random) {
      for(std::size_t k = 0; k < n; ++k)
        f(soup, random);
    };
  };
  const auto some_face = [](const Soup& soup, Random& random) { return random.below(soup.polygons.size()); };
  kinds["reversed faces"] = each([=](Soup& soup, Random& random) {
    auto& t = soup.polygons[some_face(soup, random)];
    std::swap(t[0], t[1]);
  });
  kinds["faces that are missing"] = each([=](Soup& soup, Random& random) {
    soup.polygons.erase(soup.polygons.begin() + static_cast<std::ptrdiff_t>(some_face(soup, random)));
  });
  kinds["faces that are there twice"] = each([=](Soup& soup, Random& random) {
    auto t = soup.polygons[some_face(soup, random)];
    if(random.one_in(2))
      std::swap(t[0], t[1]);
    soup.polygons.push_back(t);
  });
  kinds["faces without area"] = each([=](Soup& soup, Random& random) {
    const auto t = soup.polygons[some_face(soup, random)];
    soup.polygons.push_back({t[0], t[1], t[0]});
  });
  kinds["fins"] = each([=](Soup& soup, Random& random) { // an edge with three faces
    const auto t = soup.polygons[some_face(soup, random)];
    soup.points.push_back(combination(1.1, soup.points[t[0]], 0.1, random.in_cube()));
    soup.polygons.push_back({t[0], t[1], soup.points.size() - 1});
  });
  kinds["faces with vertices of their own"] = each([=](Soup& soup, Random& random) {
    for(std::size_t& v : soup.polygons[some_face(soup, random)])
    {
      soup.points.push_back(Coordinates(soup.points[v]));
      v = soup.points.size() - 1;
    }
  });
  kinds["small components"] = each([=](Soup& soup, Random& random) {
    const std::size_t n = soup.points.size();
    const Coordinates p = random.in_cube();
    for(int i = 0; i < 4; ++i)
      soup.points.push_back(combination(1., p, 0.01, random.in_cube()));
    for(const auto& t : Polygons{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
      soup.polygons.push_back({n + t[0], n + t[1], n + t[2]});
  });
  kinds["pinched vertices"] = each([=](Soup& soup, Random& random) {
    const std::size_t v = random.below(soup.points.size()), w = random.below(soup.points.size());
    for(auto& polygon : soup.polygons)
      if(std::count(polygon.begin(), polygon.end(), v) == 0)
        std::replace(polygon.begin(), polygon.end(), w, v);
  });
  kinds["tunnels"] = [=](Soup& soup, std::size_t n, Random& random) { // through the body, as thin as a face
    for(std::size_t k = 0; k < (std::min)(n, std::size_t(5)); ++k)
    {
      std::size_t f = some_face(soup, random), g = some_face(soup, random);
      if(f == g)
        continue;
      const auto a = soup.polygons[f], b = soup.polygons[g];
      std::vector<std::size_t> all(a);
      all.insert(all.end(), b.begin(), b.end());
      std::sort(all.begin(), all.end());
      if(std::unique(all.begin(), all.end()) != all.end())
        continue;
      if(f < g)
        std::swap(f, g);
      soup.polygons.erase(soup.polygons.begin() + static_cast<std::ptrdiff_t>(f));
      soup.polygons.erase(soup.polygons.begin() + static_cast<std::ptrdiff_t>(g));
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t j = (i + 1) % 3;
        soup.polygons.push_back({a[i], a[j], b[(3 - i) % 3]});
        soup.polygons.push_back({a[j], b[(3 - j) % 3], b[(3 - i) % 3]});
      }
    }
  };
  return kinds;
}

TEST(Repair_surface, mends_defects_of_each_kind)
{
  SP::Repair_limits limits;
  limits.maximum_added_area = 0.9; // the meshes are small
  for(const auto& [kind, put_defects] : kinds_of_defects())
    for(std::uint64_t seed = 0; seed < test_scale::number_of(5, 100); ++seed)
    {
      SCOPED_TRACE(kind + ' ' + std::to_string(seed));
      Random random(seed);
      Soup soup =
          soup_of(seed % 2 == 0 ? bumpy_sphere(3) : random_stacked_sphere(60, static_cast<std::uint32_t>(seed)));
      const Polygons before = soup.polygons;
      put_defects(soup, 1 + random.below(8), random);
      EXPECT_EQ(expect_repaired(soup, limits).is_empty(), soup.polygons == before);
    }
}

TEST(Repair_surface, mends_all_kinds_at_once)
{
  SP::Repair_limits limits;
  limits.maximum_added_area = 0.9;
  for(std::uint64_t seed = 0; seed < test_scale::number_of(10, 200); ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Soup soup = soup_of(icosphere(3));
    for(const auto& [kind, put_defects] : kinds_of_defects())
      put_defects(soup, random.below(4), random);
    expect_repaired(soup, limits);
  }
}

TEST(Repair_surface, reports_what_it_has_done)
{
  const Triangle_list sphere = icosphere(2);
  Soup soup = soup_of(sphere);
  soup.polygons[7] = {soup.polygons[7][1], soup.polygons[7][0], soup.polygons[7][2]};
  const SP::Repair_report turned = expect_repaired(soup);
  EXPECT_EQ(turned.reversed_faces.number, 1u);
  EXPECT_EQ(turned.reversed_faces.first, 7u);

  soup = soup_of(sphere);
  soup.polygons.erase(soup.polygons.begin() + 3);
  const SP::Repair_report hole = expect_repaired(soup);
  ASSERT_EQ(hole.patches.size(), 1u);
  EXPECT_EQ(hole.patches[0].number_of_edges, 3u);
  EXPECT_FALSE(hole.patches[0].is_of_handle);
  EXPECT_NEAR(hole.added_area, 1. / static_cast<double>(sphere.triangles.size()), 1e-3);

  // a soup of triangles without common vertices
  soup = Soup();
  for(const Triangle& t : sphere.triangles)
  {
    soup.polygons.emplace_back();
    for(const std::size_t v : t)
    {
      soup.polygons.back().push_back(soup.points.size());
      soup.points.push_back(sphere.points[v]);
    }
  }
  EXPECT_EQ(expect_repaired(soup).merged_vertices.number, soup.points.size() - sphere.points.size());

  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  soup.polygons = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  EXPECT_EQ(expect_repaired(soup).triangulated_polygons.number, 6u);
}

TEST(Repair_surface, cuts_handles_where_it_adds_least)
{
  SP::Repair_limits limits;
  limits.maximum_added_area = 0.2;
  const SP::Repair_report thin = expect_repaired(soup_of(torus(60, 8)), limits);
  EXPECT_EQ(thin.handle_cycles.size(), 1u);
  ASSERT_EQ(thin.patches.size(), 2u);
  EXPECT_EQ(thin.patches[0].number_of_edges, 8u);
  EXPECT_TRUE(thin.patches[0].is_of_handle);
}

TEST(Repair_surface, adds_no_more_than_it_may)
{
  Soup open = soup_of(icosphere(3));
  open.polygons.resize(open.polygons.size() / 2);
  Repaired repaired;
  SP::Repair_report report;
  EXPECT_EQ(repair(open, repaired, report), SP::ERROR_NON_CLOSED_MESH);
  EXPECT_TRUE(repaired.points.empty() && repaired.triangles.empty());
  EXPECT_NE(report.message.find("and the limit is 5 %"), std::string::npos) << report.message;
  SP::Repair_limits limits;
  limits.maximum_added_area = 1.;
  expect_repaired(open, limits);
  limits.maximum_hole = 0.1;
  EXPECT_EQ(repair(open, repaired, report, limits), SP::ERROR_NON_CLOSED_MESH);
  EXPECT_NE(report.message.find("square root of the area"), std::string::npos) << report.message;
  limits = SP::Repair_limits();
  limits.maximum_handle = 0.1;
  EXPECT_EQ(repair(soup_of(torus(60, 8)), repaired, report, limits), SP::ERROR_NO_TOPOLOGICAL_SPHERE);
}

TEST(Repair_surface, refuses_what_is_no_surface)
{
  Soup soup = soup_of(icosphere(1));
  Repaired repaired;
  SP::Repair_report report;
  soup.polygons[5][1] = 1000;
  EXPECT_EQ(repair(soup, repaired, report), SP::ERROR_WRONG_PARAMETER);
  EXPECT_NE(report.message.find("face 5 has the vertex 1000"), std::string::npos) << report.message;
  soup = soup_of(icosphere(1));
  soup.points[4][2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(repair(soup, repaired, report), SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_NE(report.message.find("vertex 4"), std::string::npos) << report.message;
  EXPECT_EQ(repair(Soup(), repaired, report), SP::ERROR_EMPTY_MESH);
  for(const double limit : {-1., std::numeric_limits<double>::quiet_NaN()})
  {
    SP::Repair_limits limits;
    limits.maximum_added_area = limit;
    EXPECT_EQ(repair(soup_of(icosphere(1)), repaired, report, limits), SP::ERROR_WRONG_PARAMETER);
  }
  EXPECT_EQ(repair({soup.points, {{0, 1}, {3, 3, 3}}}, repaired, report), SP::ERROR_EMPTY_MESH);
}

TEST(Repair_surface, does_not_depend_on_sizes)
{
  const Triangle_list list = torus(20, 8);
  SP::Repair_limits limits;
  limits.maximum_added_area = 0.5;
  const SP::Repair_report report = expect_repaired(soup_of(list), limits);
  for(const double scale : {1e-290, 1e290})
  {
    Repaired repaired;
    SP::Repair_report scaled;
    EXPECT_EQ(repair(soup_of(test_meshes::scaled(list, scale, scale, scale)), repaired, scaled, limits), SP::OK);
    EXPECT_NEAR(scaled.added_area, report.added_area, 1e-12);
    EXPECT_NEAR(scaled.patches.at(0).length / scale / report.patches.at(0).length, 1., 1e-12);
  }
}

TEST(Repair_surface, keeps_exact_points)
{
  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  const Soup soup = soup_of(icosphere(1));
  std::vector<Exact_point> points;
  for(const Coordinates& p : soup.points)
    points.emplace_back(CGAL::Exact_predicates_exact_constructions_kernel::FT(p[0]) / 3, p[1], p[2]);
  SP::Repaired_surface<Exact_point> repaired;
  SP::Repair_report report;
  EXPECT_EQ(SP::repair_surface(points, soup.polygons, repaired, report), SP::OK);
  EXPECT_EQ(repaired.points, points);
}

TEST(Repair_surface, closes_what_CGAL_has)
{
  SP::Repair_limits limits;
  limits.maximum_added_area = 1.;
  for(const char* name : {"b9_mesh", "boeing", "cheese", "elephant-with-holes", "polygon_mesh", "turbine", "3torus"})
  {
    SCOPED_TRACE(name);
    Soup soup;
    std::vector<Point_3> points;
    if(!CGAL::IO::read_polygon_soup(CGAL::data_file_path(std::string("meshes/") + name + ".off"), points,
                                    soup.polygons))
      GTEST_SKIP() << "There are no meshes of CGAL here.";
    for(const Point_3& p : points)
      soup.points.push_back({p.x(), p.y(), p.z()});
    expect_repaired(soup, limits);
  }
}

} // namespace
