// The map of the connectivity alone is one-to-one for every triangulation, with determinants as large as its proof says; and it
// is what the default method starts from if the hierarchy has found no map.

#include <CGAL/Spherical_parameterization/internal/initializers/Schnyder_drawing.h>
#include <CGAL/Spherical_parameterization/internal/run/run_descent.h>

#include "indexed_meshes.h"
#include "judge.h"
#include "methods.h"
#include "random_meshes.h"

using namespace test;

namespace {

// An energy for which the hierarchy finds no map
struct Unmappable_energy : SP::Symmetric_Dirichlet_energy_3
{};

} // namespace

template <>
bool SP::internal::embed_hierarchically(const Surface&, const Unmappable_energy&, const Level_settings&,
                                        std::vector<Vector_3d>& positions, Run_control& control, Execution,
                                        const std::vector<double>&)
{
  positions.clear();
  control.report().number_of_attempts = 9;
  return false;
}

namespace {

// Expects the map of a triangulation to be one-to-one, and returns the smallest determinant of its faces times that of which the
// proof says that none is smaller.
double smallest_determinant(const Triangle_list& list)
{
  const SP::internal::Surface surface = surface_of(list);
  const Images images = surface.in_callers_order(SP::internal::Schnyder_drawing(surface.rings()).positions());
  EXPECT_TRUE(judge::is_one_to_one(images, list.triangles));
  double result = HUGE_VAL;
  for(const Triangle& t : list.triangles)
    result = (std::min)(result, SP::internal::dot(images[t[0]], SP::internal::cross(images[t[1]], images[t[2]])));
  const double n_faces = 2. * static_cast<double>(list.points.size()) - 7.;
  return 2. * n_faces * n_faces * result;
}

std::size_t smallest_degree(const Triangle_list& list)
{
  std::vector<std::size_t> degrees(list.points.size(), 0);
  for(const Triangle& t : list.triangles)
    for(const std::size_t v : t)
      ++degrees[v];
  return *std::min_element(degrees.begin(), degrees.end());
}

TEST(Schnyder_drawing, is_one_to_one_for_the_smallest_triangulations)
{
  for(const Triangle_list& list : {tetrahedron(), octahedron(), icosphere(0)})
    EXPECT_GE(smallest_determinant(list), 1.);
  for(std::size_t n = 3; n < 12; ++n)
    EXPECT_GE(smallest_determinant(suspension(n)), 1.) << n;
}

TEST(Schnyder_drawing, is_one_to_one_for_random_triangulations)
{
  std::array<std::size_t, 6> n_of_degree{};
  for(std::uint64_t seed = 0; seed < 500; ++seed)
  {
    const Random_mesh mesh = random_mesh(6000000 + seed);
    SCOPED_TRACE(mesh.kind);
    ++n_of_degree.at(smallest_degree(mesh.list));
    EXPECT_GE(smallest_determinant(mesh.list), 1. - 1e-6);
  }
  EXPECT_GE(n_of_degree[3], 50u);
  EXPECT_GE(n_of_degree[4], 20u);
  EXPECT_GE(smallest_determinant(icosphere(3)), 1.);
}

// Removes the face f of a list and the face g of another one, and joins them there: the first corner of f becomes that of g.
void glue(Triangle_list& list, std::size_t f, const Triangle_list& other, std::size_t g)
{
  const Triangle a = list.triangles[f], b = other.triangles[g];
  std::vector<std::size_t> number;
  for(std::size_t v = 0; v < other.points.size(); ++v)
  {
    const auto corner = std::find(b.begin(), b.end(), v) - b.begin();
    number.push_back(corner < 3 ? a[static_cast<std::size_t>((3 - corner) % 3)] : list.points.size());
    if(corner == 3)
      list.points.push_back(other.points[v]);
  }
  list.triangles.erase(list.triangles.begin() + static_cast<std::ptrdiff_t>(f));
  for(std::size_t k = 0; k < other.triangles.size(); ++k)
    if(k != g)
    {
      const Triangle t = other.triangles[k];
      list.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    }
}

// An icosahedron, and a vertex in its last face: the last three faces begin with it.
Triangle_list icosahedron_with_a_vertex_more()
{
  Triangle_list list = icosphere(0);
  split_face(list, list.triangles.size() - 1, {1., 2., 3.});
  for(std::size_t k = list.triangles.size() - 3; k < list.triangles.size(); ++k)
    std::rotate(list.triangles[k].begin(), list.triangles[k].begin() + 2, list.triangles[k].end());
  return list;
}

// The first vertex is the open end, its ring begins anywhere, and an edge outside joins two or three of its neighbours.
TEST(Schnyder_drawing, is_one_to_one_for_edges_across_the_hole)
{
  Triangle_list four; // as few vertices as there can be, if none has three neighbours
  four.points.resize(11);
  four.triangles = {{0, 1, 2}, {0, 2, 3},  {0, 3, 4},  {0, 4, 1}, {1, 4, 5},  {1, 5, 2},
                    {2, 5, 3}, {3, 5, 6},  {3, 6, 4},  {4, 6, 7}, {4, 7, 8},  {4, 8, 9},
                    {4, 9, 5}, {5, 9, 10}, {5, 10, 7}, {5, 7, 6}, {7, 10, 8}, {8, 10, 9}};
  Triangle_list five = icosahedron_with_a_vertex_more();
  const std::size_t n_faces = five.triangles.size();
  glue(five, n_faces - 1, icosahedron_with_a_vertex_more(), n_faces - 1);
  glue(five, n_faces - 3, icosahedron_with_a_vertex_more(), n_faces - 1);
  for(const auto& [list, s] : {std::pair<Triangle_list, std::size_t>(four, 6), {five, 12}})
    for(const bool is_mirrored : {false, true})
    {
      // the vertices with s first, and their rings
      std::vector<Triangle> faces = list.triangles;
      for(Triangle& t : faces)
      {
        for(std::size_t& v : t)
          v = v == s ? 0 : v == 0 ? s : v;
        if(is_mirrored)
          std::swap(t[0], t[1]);
      }
      std::vector<std::vector<std::size_t>> all;
      for(const std::vector<Triangle>& star : judge::stars(faces, list.points.size()))
        all.push_back(judge::ring(star));
      for(std::size_t turn = 0; turn < all[0].size(); ++turn)
      {
        std::rotate(all[0].begin(), all[0].begin() + 1, all[0].end());
        SP::internal::Vertex_rings rings;
        for(const auto& ring : all)
        {
          for(const std::size_t w : ring)
            rings.push_neighbor(static_cast<std::uint32_t>(w));
          rings.end_ring();
        }
        EXPECT_TRUE(judge::is_one_to_one(SP::internal::Schnyder_drawing(rings).positions(), faces)) << turn;
      }
      EXPECT_EQ(smallest_degree({list.points, faces}), all[0].size());
    }
}

TEST(Schnyder_drawing, is_one_to_one_for_hubs_and_nested_triangles)
{
  EXPECT_GE(smallest_determinant(suspension(20000)), 1. - 1e-6);
  EXPECT_GE(smallest_determinant(random_stacked_sphere(20000, 1)), 1. - 1e-6);
  EXPECT_GE(smallest_determinant(nested_triangles(5000)), 1. - 1e-6);
}

TEST(Schnyder_parameterizer, needs_no_points)
{
  Triangle_list list = bumpy_sphere(3);
  const Result result = schnyder().run(list);
  EXPECT_EQ(result.error, SP::OK);
  for(Coordinates& p : list.points)
    p = {1., 2., 3.};
  EXPECT_EQ(schnyder().run(list).error, SP::OK);
  EXPECT_EQ(result.report.stop_reason, SP::CONVERGED);
  EXPECT_EQ(result.report.radius, 1.);
  EXPECT_FALSE(result.report.used_last_resort);
}

TEST(Last_resort, is_where_the_descent_starts_from)
{
  const auto bld = SP::Bijective_low_distortion_parameterizer_3().energy(Unmappable_energy());
  const Method method("from the last resort", bld),
      from_schnyder("from Schnyder's drawing", bld.initial_parameterizer(SP::Schnyder_parameterizer_3()));
  for(const Triangle_list& list : {tetrahedron(), bumpy_sphere(2), with_tentacle(20, 3.), suspension(500)})
  {
    const Result result = method.run(list, Options().iterations(40));
    EXPECT_EQ(result.error, SP::OK);
    EXPECT_TRUE(result.report.used_last_resort);
    EXPECT_EQ(result.report.number_of_attempts, 9u);
    EXPECT_LE(result.report.average_energy, result.report.initial_energy);
    const SP::Parameterization_report other = from_schnyder.run(list, Options().iterations(40)).report;
    EXPECT_NEAR(result.report.initial_energy / other.initial_energy, 1., 1e-9);
  }
  EXPECT_FALSE(bijective().run(bumpy_sphere(2)).report.used_last_resort);
  const Result hierarchical =
      Method("hierarchical", SP::Hierarchical_parameterizer_3().energy(Unmappable_energy())).run(bumpy_sphere(2));
  EXPECT_EQ(hierarchical.error, SP::OK);
  EXPECT_TRUE(hierarchical.report.used_last_resort);
  EXPECT_TRUE(have_same_bits(hierarchical.images, schnyder().run(bumpy_sphere(2)).images));
}

} // namespace
