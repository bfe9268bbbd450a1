// A folder of meshes found in the wild and of meshes made to break things, where there is one: every valid mesh is
// mapped one-to-one, every invalid one is refused.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_runs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// The files of a folder whose names start with `prefix`, in alphabetical order; none if there is no such folder.
std::vector<std::string> files(const std::string& folder, const std::string& prefix)
{
  std::vector<std::string> result;
  std::error_code error;
  const std::filesystem::path path = std::filesystem::path(SPHERICAL_PARAMETERIZATION_SHARED_DATA_DIR) / folder;
  for(const auto& entry : std::filesystem::directory_iterator(path, error))
  {
    if(entry.path().filename().string().compare(0, prefix.size(), prefix) == 0)
    {
      result.push_back(entry.path().string());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool read(const std::string& file, Mesh& mesh)
{
  try
  {
    return CGAL::IO::read_polygon_mesh(file, mesh);
  }
  catch(const std::exception&) // some readers throw
  {
    return false;
  }
}

// Every method on the mesh: never OK on a map that folds, and no fold where a bijection is promised. Returns how many
// got one.
template <class Method>
int run_method(const Mesh& mesh, bool may_fold)
{
  Method method;
  const test_runs::Result result =
      test_runs::run<Point_3>(mesh, method, may_fold, CGAL::parameters::number_of_iterations(20u));
  EXPECT_TRUE(result.error == SP::OK || result.error == SP::ERROR_NO_1_TO_1_MAPPING ||
              result.error == SP::ERROR_INSUFFICIENT_PRECISION)
      << SP::get_error_message(result.error);
  return result.error == SP::OK ? 1 : 0;
}

int run_all_methods(const Mesh& mesh)
{
  return run_method<SP::Stereographic_parameterizer_3<Mesh>>(mesh, false) +
         run_method<SP::Harmonic_parameterizer_3<Mesh>>(mesh, false) +
         run_method<SP::Hierarchical_parameterizer_3<Mesh>>(mesh, false) +
         run_method<SP::Published_low_distortion_parameterizer_3<Mesh>>(mesh, false) +
         run_method<SP::Conformal_parameterizer_3<Mesh>>(mesh, true) +
         run_method<SP::ARAP_parameterizer_3<Mesh>>(mesh, true);
}

// Either the map is there and a bijection, or it is untouched.
SP::Error_code parameterize(const Mesh& mesh)
{
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  const std::vector<Coordinates> before = test_maps::images(mesh, map);
  const SP::Error_code error = SP::parameterize(mesh, map, CGAL::parameters::number_of_iterations(20u));
  if(error == SP::OK)
  {
    EXPECT_TRUE(SP::is_bijective(mesh, map));
    EXPECT_EQ(SP::measure_distortion(mesh, map).number_of_inverted_faces, 0u);
  }
  else
  {
    EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, map), before));
  }
  return error;
}

TEST(Corpus, meshes_are_mapped)
{
  const std::vector<std::string> names = files("meshes", "");
  if(names.empty())
  {
    GTEST_SKIP() << "There is no folder of meshes.";
  }
  std::size_t n_meshes = 0;
  for(const std::string& name : names)
  {
    SCOPED_TRACE(name);
    Mesh mesh;
    ASSERT_TRUE(read(name, mesh));
    if(num_vertices(mesh) < 11000) // the others are for the benchmarks
    {
      EXPECT_EQ(parameterize(mesh), SP::OK);
      ++n_meshes;
    }
  }
  EXPECT_GE(n_meshes, 20u);
}

TEST(Corpus, hard_meshes_are_mapped)
{
  const std::vector<std::string> names = files("nasty", "hard_");
  if(names.empty())
  {
    GTEST_SKIP() << "There is no folder of meshes.";
  }
  std::size_t n_mapped = 0;
  for(const std::string& name : names)
  {
    SCOPED_TRACE(name);
    Mesh mesh;
    if(!read(name, mesh) || !CGAL::is_closed(mesh))
    {
      continue;
    }
    const SP::Error_code error = parameterize(mesh);
    EXPECT_EQ(error, SP::OK) << SP::get_error_message(error);
    n_mapped += error == SP::OK;
  }
  EXPECT_GE(n_mapped, 50u);
}

TEST(Corpus, guarantees_of_all_methods_hold)
{
  std::vector<std::string> names = files("meshes", "");
  const std::vector<std::string> hard = files("nasty", "hard_");
  names.insert(names.end(), hard.begin(), hard.end());
  if(names.empty())
  {
    GTEST_SKIP() << "There is no folder of meshes.";
  }
  std::size_t n_meshes = 0, n_bijections = 0;
  for(const std::string& name : names)
  {
    SCOPED_TRACE(name);
    Mesh mesh;
    if(read(name, mesh) && CGAL::is_closed(mesh) && num_vertices(mesh) < 7000)
    {
      const int n = run_all_methods(mesh);
      EXPECT_GE(n, 1); // the hierarchical one
      n_bijections += static_cast<std::size_t>(n);
      ++n_meshes;
    }
  }
  EXPECT_GE(n_meshes, 50u);
  EXPECT_GE(n_bijections, 4 * n_meshes);
}

TEST(Corpus, invalid_meshes_are_refused)
{
  const std::vector<std::string> names = files("nasty", "invalid_");
  if(names.empty())
  {
    GTEST_SKIP() << "There is no folder of meshes.";
  }
  // for those that CGAL 5.5 reads; other versions may read more or less
  const std::map<std::string, SP::Error_code> expected = {
      {"invalid_coordinate_inf.off", SP::ERROR_NON_FINITE_COORDINATE},
      {"invalid_coordinate_nan.off", SP::ERROR_NON_FINITE_COORDINATE},
      {"invalid_genus1_torus.off", SP::ERROR_NO_TOPOLOGICAL_SPHERE},
      {"invalid_genus1_torus_21v.off", SP::ERROR_NO_TOPOLOGICAL_SPHERE},
      {"invalid_open_hemisphere.off", SP::ERROR_NON_CLOSED_MESH},
      {"invalid_open_one_face_missing.off", SP::ERROR_NON_CLOSED_MESH},
      {"invalid_quads_cube.off", SP::ERROR_NON_TRIANGULAR_MESH},
      {"invalid_single_triangle.off", SP::ERROR_NON_CLOSED_MESH},
      {"invalid_sphere_plus_torus_chi2.off", SP::ERROR_SEVERAL_COMPONENTS},
      {"invalid_triangle_soup_unmerged_vertices.off", SP::ERROR_NON_CLOSED_MESH},
      {"invalid_two_components.off", SP::ERROR_SEVERAL_COMPONENTS},
      {"invalid_two_components_nested.off", SP::ERROR_SEVERAL_COMPONENTS},
      {"invalid_two_triangle_pillow.off", SP::ERROR_TOO_FEW_VERTICES},
      {"invalid_zero_counts.off", SP::ERROR_EMPTY_MESH}};
  std::size_t n_refused = 0;
  for(const std::string& name : names)
  {
    SCOPED_TRACE(name);
    Mesh mesh;
    if(!read(name, mesh))
    {
      continue;
    }
    const SP::Error_code error = parameterize(mesh);
    EXPECT_NE(error, SP::OK);
    const auto known = expected.find(std::filesystem::path(name).filename().string());
    EXPECT_TRUE(known == expected.end() || error == known->second) << SP::get_error_message(error);
    ++n_refused;
  }
  EXPECT_GE(n_refused, 10u);
}

} // namespace
