// The command line program, run as a user runs it: exit status, messages, and which files are written.

#define BOOST_BIND_GLOBAL_PLACEHOLDERS // Boost's JSON parser uses them, and says so in every compilation otherwise

#include "test_meshes.h"

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// In CGAL's tree the examples are not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

struct Outcome
{
  int status;
  std::string out, err;
};

class Program : public ::testing::Test
{
protected:
  // a folder of its own for each test
  void SetUp() override
  {
    m_folder = fs::path("program") / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);
    write_off("sphere.off", test_meshes::icosphere(2));
  }

  fs::path path(const std::string& name) const { return m_folder / name; }

  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  void write_off(const std::string& name, const test_meshes::Triangle_list& list) const
  {
    std::ofstream out(path(name));
    out.precision(17);
    out << "OFF\n" << list.points.size() << ' ' << list.triangles.size() << " 0\n";
    for(const auto& p : list.points)
      out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for(const auto& t : list.triangles)
      out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }

  // runs the program within the folder; arguments are separated by blanks
  Outcome run(const std::string& arguments) const
  {
    const std::string command = "cd '" + m_folder.string() + "' && '" SPHERICAL_PARAMETERIZATION_PROGRAM "' " +
                                arguments + " > stdout.txt 2> stderr.txt < /dev/null";
    const int status = std::system(command.c_str());
    return {status % 256 == 0 ? status / 256 : status, content(path("stdout.txt")), content(path("stderr.txt"))};
  }

  void expect_refused(const std::string& arguments, const std::string& part_of_message) const
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find(part_of_message), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
    for(const char* name : {"result.off", "result.json", "result_surface.ply", "result_sphere.ply"})
      EXPECT_FALSE(fs::exists(path(name))) << name;
  }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
  }

private:
  fs::path m_folder;
};

TEST_F(Program, writes_all_that_is_asked_for)
{
  const Outcome outcome = run("sphere.off -o result.off --json result.json --colored result");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.err.empty()) << outcome.err; // no progress line where nobody looks
  EXPECT_NE(outcome.out.find("D_iso"), std::string::npos);
  EXPECT_NE(outcome.out.find("one-to-one"), std::string::npos);
  EXPECT_EQ(content(path("result_surface.ply")).substr(0, 3), "ply");
  EXPECT_EQ(content(path("result_sphere.ply")).substr(0, 3), "ply");
  EXPECT_EQ(number_of_files(), 7u); // input, four files, two streams: nothing temporary is left

  boost::property_tree::ptree json;
  boost::property_tree::read_json(path("result.json").string(), json);
  EXPECT_EQ(json.get<std::size_t>("vertices"), 162u);
  EXPECT_TRUE(json.get<bool>("one_to_one"));
  EXPECT_LT(json.get<double>("distortion.D_iso.maximum"), 1.02);

  // the same faces in the same order, each with the same first corner
  const auto faces_of = [&](const std::string& name) {
    std::istringstream in(content(path(name)));
    const std::vector<std::string> words((std::istream_iterator<std::string>(in)), {});
    return std::vector<std::string>(words.end() - 4 * 320, words.end());
  };
  EXPECT_EQ(faces_of("result.off"), faces_of("sphere.off"));
}

TEST_F(Program, prints_the_table_only_without_output)
{
  const Outcome outcome = run("sphere.off");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("D_angle"), std::string::npos);
  EXPECT_EQ(number_of_files(), 3u);
  EXPECT_TRUE(run("sphere.off --quiet").out.empty());
}

TEST_F(Program, writes_the_same_bytes_with_any_number_of_threads)
{
  EXPECT_EQ(run("sphere.off -o one.off --threads 1 --quiet").status, 0);
  EXPECT_EQ(run("sphere.off -o two.off --threads 2 --quiet").status, 0);
  EXPECT_EQ(content(path("one.off")), content(path("two.off")));
}

TEST_F(Program, takes_every_setting)
{
  for(const char* arguments :
      {"--energy isometric", "--energy conformal", "--prefer average", "--prefer worst", "--sharpness 3.5",
       "--s-first 0.5 --s-last 5", "--radius optimal", "--radius area", "--radius fixed=2.5", "--radius two-phase",
       "--initial hierarchical", "--iterations 3", "--iterations 0", "--time-limit 100"})
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(std::string("sphere.off -o result.off --json result.json ") + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
  boost::property_tree::ptree json;
  run("sphere.off --json result.json --radius fixed=2.5");
  boost::property_tree::read_json(path("result.json").string(), json);
  EXPECT_EQ(json.get<double>("radius"), 2.5);
}

TEST_F(Program, starts_from_a_map)
{
  ASSERT_EQ(run("sphere.off -o first.off --iterations 1 --quiet").status, 0);
  EXPECT_EQ(run("sphere.off -o second.off --initial first.off --quiet").status, 0);
  // the surface itself, star-shaped about the origin, is a map as well
  EXPECT_EQ(run("sphere.off -o third.off --initial sphere.off --quiet").status, 0);

  expect_refused("sphere.off -o result.off --initial missing.off", "missing.off");
  expect_refused("sphere.off -o result.off --initial harmonic", "hierarchical");
  write_off("coarse.off", test_meshes::icosphere(1));
  expect_refused("sphere.off -o result.off --initial coarse.off", "vertices");
  test_meshes::Triangle_list mirrored = test_meshes::icosphere(2);
  for(auto& p : mirrored.points)
    p[0] = -p[0];
  write_off("mirrored.off", mirrored);
  expect_refused("sphere.off -o result.off --initial mirrored.off", "one-to-one");
}

TEST_F(Program, refuses_bad_values_with_the_good_ones)
{
  const std::string call = "sphere.off -o result.off ";
  expect_refused(call + "--energy elastic", "symmetric-dirichlet");
  expect_refused(call + "--prefer best", "balance");
  expect_refused(call + "--radius 2", "two-phase");
  expect_refused(call + "--radius fixed=0", "fixed=");
  expect_refused(call + "--radius fixed=-1", "fixed=");
  expect_refused(call + "--radius fixed=nan", "fixed=");
  expect_refused(call + "--sharpness -1", "sharpness");
  expect_refused(call + "--sharpness nan", "sharpness");
  expect_refused(call + "--s-first 5 --s-last 1", "s-first");
  expect_refused(call + "--s-first 1 --prefer worst", "s-first");
  expect_refused(call + "--sharpness 1 --prefer worst", "prefer");
  expect_refused(call + "--iterations -1", "iterations");
  expect_refused(call + "--iterations many", "iterations");
  expect_refused(call + "--time-limit -1", "time-limit");
  expect_refused(call + "--threads 0", "threads");
  expect_refused(call + "--unknown", "unknown");
  expect_refused("", "INPUT");
}

TEST_F(Program, refuses_what_it_cannot_read_or_write)
{
  expect_refused("missing.off -o result.off", "missing.off");
  write("mesh.xyz", "0 0 0\n");
  expect_refused("mesh.xyz -o result.off", ".off");
  expect_refused("sphere.off -o missing/result.off", "missing");
  expect_refused("sphere.off -o result.txt", ".off");
  expect_refused("sphere.off -o result.off --json missing/result.json", "missing");
  expect_refused("sphere.off -o result.off --colored missing/result", "missing");
  fs::create_directory(path("folder.off"));
  expect_refused("sphere.off -o folder.off", "folder.off");
}

TEST_F(Program, says_what_is_wrong_with_a_mesh)
{
  const auto expect = [&](const std::string& text, const std::string& message) {
    write("bad.off", text);
    expect_refused("bad.off -o result.off --json result.json --colored result", message);
  };
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  expect("", "empty");
  expect("ply\n", "OFF");
  expect("OFF\n0 0 0\n", "no faces");
  expect("OFF\n4 4 0\n" + points + "3 0 2 1\n3 0 1 3\n", "truncated");
  expect("OFF\n-4 4 0\n", "negative");
  expect("OFF\n99999999999999 4 0\n" + points, "too short");
  expect("OFF\n4 4 0\n0 0 0\n1 x 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "not a number");
  expect("OFF\n4 4 0\n0 0 0\n1 nan 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "vertex 1");
  expect("OFF\n4 4 0\n0 0 0\n1 inf 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "vertex 1");
  expect("OFF\n4 4 0\n" + points + "3 0 2 1\n3 0 1 4\n3 1 2 3\n3 2 0 3\n", "face 1");
  expect("OFF\n4 4 0\n" + points + "3 0 2 1\n3 0 1 -3\n3 1 2 3\n3 2 0 3\n", "face 1");
  expect("OFF\n4 4 0\n" + points + "3 0 2 1\n3 0 1 1\n3 1 2 3\n3 2 0 3\n", "twice");
  expect("OFF\n4 3 0\n" + points + "4 0 2 1 3\n3 0 1 3\n3 1 2 3\n", "not a triangle");
  expect("OFF\n4 3 0\n" + points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n", "border");
  expect("OFF\n4 4 0\n" + points + "3 0 1 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "direction");
  expect("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n", "3 vertices");
}

TEST_F(Program, refuses_every_invalid_mesh_of_the_corpus)
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
