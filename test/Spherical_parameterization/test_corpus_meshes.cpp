// Meshes that nobody has chosen: random ones, however the vertices are connected and wherever they are, and a folder of those
// found in the wild and made to break things, where there is one. Every valid mesh is mapped one-to-one, every invalid one is
// refused.
//
// SPHERICAL_PARAMETERIZATION_FIRST_SEED=N SPHERICAL_PARAMETERIZATION_NUMBER_OF_SEEDS=1 repeats the random mesh N alone.

#include "methods.h"
#include "random_meshes.h"
#include "test_scale.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

using namespace test;

namespace {

TEST(Random_meshes, are_of_all_kinds_and_sizes)
{
  std::set<std::string> kinds;
  std::size_t smallest = 300, largest = 4;
  for(std::uint64_t seed = 0; seed < 3000; ++seed)
  {
    const Random_mesh mesh = random_mesh(seed);
    const std::size_t n = mesh.list.points.size();
    kinds.insert(mesh.kind.substr(0, mesh.kind.rfind(',')));
    smallest = (std::min)(smallest, n);
    largest = (std::max)(largest, n);
  }
  EXPECT_EQ(smallest, 4u);
  EXPECT_GE(largest, 290u);
  EXPECT_GT(kinds.size(), connectivities.size() * placements.size()); // and deformed surfaces
}

std::uint64_t setting(const char* variable, std::uint64_t otherwise)
{
  const char* text = std::getenv(variable);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

// Runs a method on so many random meshes. It may refuse them, but not return OK for a map that folds. Returns how many it did.
std::size_t number_of_refusals(const Method& method, std::size_t n, std::uint64_t first_seed, const Options& options)
{
  std::size_t n_refused = 0;
  const std::uint64_t first = setting("SPHERICAL_PARAMETERIZATION_FIRST_SEED", first_seed);
  for(std::uint64_t seed = first; seed < first + setting("SPHERICAL_PARAMETERIZATION_NUMBER_OF_SEEDS", n); ++seed)
  {
    const Random_mesh mesh = random_mesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + mesh.kind);
    const SP::Error_code error = method.run(mesh.list, options).error;
    EXPECT_TRUE(error == SP::OK || error == SP::ERROR_INSUFFICIENT_PRECISION ||
                error == SP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM)
        << SP::get_error_message(error);
    n_refused += error != SP::OK;
  }
  return n_refused;
}

TEST(Random_meshes, are_mapped)
{
  const std::size_t n = test_scale::number_of(500, 20000);
  const std::size_t n_long = n / 10, n_parallel = n / 10;
  EXPECT_EQ(number_of_refusals(bijective(), n - n_long - n_parallel, 1000000, Options().iterations(10).sequential()),
            0u);
  EXPECT_EQ(number_of_refusals(bijective(), n_long, 2000000, Options().sequential()), 0u);
  EXPECT_EQ(number_of_refusals(bijective(), n_parallel, 3000000, Options().iterations(10)), 0u);
}

TEST(Random_meshes, are_drawn_by_their_connectivity)
{
  EXPECT_EQ(number_of_refusals(schnyder(), test_scale::number_of(500, 20000), 4000000, Options().sequential()), 0u);
}

// Other methods that promise a bijection may say that they have found none, but not for the most of them.
TEST(Random_meshes, are_mapped_or_refused_by_other_methods)
{
  const std::size_t n = test_scale::number_of(60, 400);
  EXPECT_EQ(number_of_refusals(hierarchical(), n, 5000000, Options().sequential()), 0u);
  for(const Method& method : {harmonic(), stereographic()})
    EXPECT_LE(number_of_refusals(method, n, 5000000, Options().sequential()), n / 2) << method.name();
}

// The files of a folder whose names start with `prefix`, in alphabetical order; none if there is no such folder.
std::vector<std::string> files(const std::string& folder, const std::string& prefix)
{
  std::vector<std::string> result;
  std::error_code error;
  const std::filesystem::path path = std::filesystem::path(SPHERICAL_PARAMETERIZATION_SHARED_DATA_DIR) / folder;
  for(const auto& entry : std::filesystem::directory_iterator(path, error))
    if(entry.path().filename().string().compare(0, prefix.size(), prefix) == 0)
      result.push_back(entry.path().string());
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

// Calls a function for every closed mesh of these files with at most so many vertices; returns how many these are.
template <class Function>
std::size_t for_each_mesh(const std::vector<std::string>& names, std::size_t max_vertices, const Function& function)
{
  std::size_t n_meshes = 0;
  for(const std::string& name : names)
  {
    SCOPED_TRACE(name);
    Mesh mesh;
    if(!read(name, mesh) || !CGAL::is_closed(mesh) || num_vertices(mesh) > max_vertices)
      continue;
    function(mesh);
    ++n_meshes;
  }
  return n_meshes;
}

class Folder : public ::testing::Test
{
protected:
  const std::vector<std::string> meshes = files("meshes", ""), hard = files("nasty", "hard_"),
                                 invalid = files("nasty", "invalid_");

  void SetUp() override
  {
    if(meshes.empty())
      GTEST_SKIP() << "There is no folder of meshes.";
    if(test_scale::is_slow && !test_scale::is_long())
      GTEST_SKIP() << "This takes too long here.";
  }
};

TEST_F(Folder, of_meshes_is_mapped)
{
  const auto expect_mapped = [](const Mesh& mesh) {
    const SP::Error_code error = bijective().run(mesh, Options().iterations(20)).error;
    EXPECT_EQ(error, SP::OK) << SP::get_error_message(error);
  };
  EXPECT_GE(for_each_mesh(meshes, 11000, expect_mapped), 20u);
  EXPECT_GE(for_each_mesh(hard, 1000000, expect_mapped), 50u);
}

TEST_F(Folder, of_meshes_is_mapped_by_all_methods_or_refused)
{
  std::vector<std::string> names = meshes;
  names.insert(names.end(), hard.begin(), hard.end());
  std::size_t n_bijections = 0;
  const std::size_t n_meshes = for_each_mesh(names, test_scale::is_long() ? 7000 : 3000, [&](const Mesh& mesh) {
    for(const Method& method : all_methods())
    {
      const SP::Error_code error = method.run(mesh, Options().iterations(20)).error;
      EXPECT_TRUE(error == SP::OK || error == SP::ERROR_NO_1_TO_1_MAPPING || error == SP::ERROR_INSUFFICIENT_PRECISION)
          << SP::get_error_message(error);
      EXPECT_TRUE(error == SP::OK || method.name() != "hierarchical");
      n_bijections += error == SP::OK;
    }
  });
  EXPECT_GE(n_meshes, 40u);
  EXPECT_GE(n_bijections, 4 * n_meshes);
}

TEST_F(Folder, of_invalid_meshes_is_refused)
{
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
  for(const std::string& name : invalid)
  {
    SCOPED_TRACE(name);
    Mesh mesh;
    if(!read(name, mesh))
      continue;
    const SP::Error_code error = bijective().run(mesh).error;
    EXPECT_NE(error, SP::OK);
    const auto known = expected.find(std::filesystem::path(name).filename().string());
    EXPECT_TRUE(known == expected.end() || error == known->second) << SP::get_error_message(error);
    ++n_refused;
  }
  EXPECT_GE(n_refused, 10u);
}

} // namespace
