// The command line program with many meshes: what is written for each, what stops none of the others, what --resume
// leaves out, and how the meshes are spread over the cores.

#include "Program_fixture.h"
#include "test_meshes.h"

// In CGAL's tree the examples are not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

#include "../../examples/Spherical_parameterization/include/Batch_scheduler.h"
#include "../../examples/Spherical_parameterization/include/Interrupt_guard.h"

#include <gtest/gtest.h>

#include <boost/crc.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <numeric>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

class Batch : public Program_fixture
{
protected:
  void SetUp() override
  {
    Program_fixture::SetUp();
    fs::create_directory(path("in"));
  }

  void write_meshes(const std::vector<std::string>& names) const
  {
    for(const std::string& name : names)
      write("in/" + name, corner_off);
  }

  // runs the program and returns what is told of each input. Each has a line of its own, in the order of their numbers.
  std::map<std::string, std::string> run_batch(const std::string& arguments, int status)
  {
    SCOPED_TRACE(arguments);
    m_outcome = run(arguments);
    EXPECT_EQ(m_outcome.status, status) << m_outcome.out << m_outcome.err;
    std::map<std::string, std::string> told;
    const std::regex pattern("\\[([0-9]+)/([0-9]+)\\] (.*?): (.*)");
    std::istringstream lines(m_outcome.out);
    std::size_t number_of_meshes = 0;
    std::string summary;
    for(std::string line; std::getline(lines, line);)
    {
      EXPECT_TRUE(summary.empty()) << "something follows the summary: " << line;
      std::smatch parts;
      if(!std::regex_match(line, parts, pattern))
      {
        summary = line;
        continue;
      }
      EXPECT_TRUE(told.emplace(parts[3], parts[4]).second) << line;
      EXPECT_EQ(parts[1], std::to_string(told.size()));
      number_of_meshes = std::stoul(parts[2]);
    }
    EXPECT_EQ(told.size(), number_of_meshes);
    EXPECT_EQ(summary.substr(0, 7), "Mapped ") << summary;
    return told;
  }

  // runs the program once more and returns the names of the meshes that it maps again
  Names redone(const std::string& arguments, int status = 0)
  {
    Names names;
    for(const auto& [input, text] : run_batch(arguments + " --output-folder out --resume", status))
      names.insert(fs::path(input).filename().string());
    return names;
  }

  void make_older(const std::string& name, int hours) const
  {
    fs::last_write_time(path(name), fs::last_write_time(path(name)) - std::chrono::hours(hours));
  }

  // changes a report as a program would that writes such reports
  void replace_in(const std::string& name, const std::string& from, const std::string& to) const
  {
    std::string text = content(path(name));
    ASSERT_NE(text.find(from), std::string::npos) << text;
    text.replace(text.find(from), from.size(), to);
    const std::size_t end = text.rfind(",\n  \"crc32\": ");
    ASSERT_NE(end, std::string::npos) << text;
    boost::crc_32_type crc;
    crc.process_bytes(text.data(), end);
    write(name, text.substr(0, end) + ",\n  \"crc32\": " + std::to_string(crc.checksum()) + "\n}\n");
  }

  Outcome m_outcome;
};

TEST_F(Batch, maps_what_is_valid_and_tells_what_is_not)
{
  write_off("in/bumpy.off", test_meshes::bumpy_sphere(2));
  write_off("in/sphere.b.off", test_meshes::icosphere(2));
  write_off("in/torus.off", test_meshes::torus(8, 5));
  write("in/corner.obj", corner_obj);
  write("in/empty.ply", "");
  write("in/text.ts", "this is no mesh\n");
  // no meshes
  write("in/notes.txt", "notes\n");
  write("in/._bumpy.off", "what some systems note on a file\n");
  fs::create_directory(path("in/folder.off"));
  fs::create_directory(path("more"));
  write("more/last one.OFF", corner_off);

  const auto told = run_batch("in 'more/last one.OFF' --output-folder new/out", 1);
  ASSERT_EQ(told.size(), 7u);
  EXPECT_EQ(told.at("in/bumpy.off").substr(0, 20), "162 vertices, D_iso ");
  EXPECT_EQ(told.at("in/torus.off").substr(0, 35), "failed: the surface has the genus 1");
  EXPECT_EQ(told.at("in/empty.ply").substr(0, 8), "failed: ");
  EXPECT_EQ(told.at("in/text.ts").substr(0, 8), "failed: ");
  for(const char* message : {"in/torus.off: the surface has the genus 1", "CGAL::alpha_wrap_3()",
                             "in/empty.ply: ", "in/text.ts: line 1: a surface of a GOCAD file begins with GOCAD"})
    EXPECT_NE(m_outcome.err.find(message), std::string::npos) << message;
  EXPECT_NE(m_outcome.out.find("\nMapped 4, left out 0, folded 0, failed 3; "), std::string::npos) << m_outcome.out;

  // nothing but what was mapped, and nothing temporary
  EXPECT_EQ(names_of_files("new/out"), (Names{"bumpy.off", "bumpy.json", "corner.obj", "corner.json", "last one.OFF",
                                              "last one.json", "sphere.b.off", "sphere.b.json"}));
  const boost::property_tree::ptree report = json("new/out/sphere.b.json");
  EXPECT_EQ(report.get<std::string>("input"), "in/sphere.b.off");
  EXPECT_EQ(report.get<std::size_t>("vertices"), 162u);
  EXPECT_TRUE(report.get<bool>("one_to_one"));
  EXPECT_EQ(report.get<std::size_t>("input_stamp.bytes"), fs::file_size(path("in/sphere.b.off")));
  EXPECT_EQ(report.get<std::size_t>("sphere_bytes"), fs::file_size(path("new/out/sphere.b.off")));
}

TEST_F(Batch, writes_the_bits_of_single_runs)
{
  const std::vector<std::string> names = {"a", "b", "c", "d", "e", "f"};
  for(std::size_t i = 0; i < names.size(); ++i)
    write_off("in/" + names[i] + ".off",
              test_meshes::scaled(test_meshes::bumpy_sphere(i < 2 ? 4 : 3), 1., 1. + 0.1 * static_cast<double>(i), 1.));
  run_batch("in --output-folder all", 0);
  for(const char* threads : {"1", "2", "3"})
    run_batch(std::string("in --output-folder out") + threads + " --threads " + threads, 0);
  for(const std::string& name : names)
  {
    ASSERT_EQ(run("in/" + name + ".off -o single.off --json single.json").status, 0);
    for(const char* folder : {"all", "out1", "out2", "out3"})
    {
      EXPECT_TRUE(content(path(std::string(folder) + "/" + name + ".off")) == content(path("single.off"))) << name;
      // the same report, but for seconds and names, and its checksum
      boost::property_tree::ptree report = json(std::string(folder) + "/" + name + ".json"),
                                  single = json("single.json");
      for(boost::property_tree::ptree* tree : {&report, &single})
        for(const char* member : {"seconds", "files", "crc32"})
          EXPECT_EQ(tree->erase(member), 1u);
      EXPECT_TRUE(report == single) << name;
    }
  }
}

TEST_F(Batch, gives_all_meshes_the_faces_of_a_template)
{
  write_off("in/a.off", test_meshes::bumpy_sphere(2));
  write_off("in/b.off", test_meshes::scaled(test_meshes::icosphere(2), 1., 1.2, 0.8));
  write_off("model.off", test_meshes::scaled(test_meshes::icosphere(1), 1., 1.3, 0.8));
  run_batch("in --template model.off --output-folder out", 0);
  EXPECT_EQ(names_of_files("out"), (Names{"a.off", "a.json", "b.off", "b.json"}));
  for(const char* name : {"out/a.off", "out/b.off"})
    EXPECT_EQ(content(path(name)).substr(0, 11), "OFF\n42 80 0");
  EXPECT_EQ(json("out/a.json").get<std::string>("match.template"), "model.off");
  run_batch("in --template model.off --output-folder out --resume", 0);
  EXPECT_NE(m_outcome.out.find("left out 2"), std::string::npos) << m_outcome.out;
  write_off("model.off", test_meshes::scaled(test_meshes::icosphere(1), 1., 1.3, 0.85)); // then all are done again
  run_batch("in --template model.off --output-folder out --resume", 0);
  EXPECT_NE(m_outcome.out.find("Mapped 2, left out 0"), std::string::npos) << m_outcome.out;
  expect_message("in/a.off --template model.off", "--template goes with --output-folder");
}

TEST_F(Batch, chooses_the_format)
{
  write("in/a.obj", corner_obj);
  write("in/b.off", corner_off);
  write("in/c.STL", corner_stl);
  run_batch("in --output-folder own", 0);
  EXPECT_EQ(names_of_files("own"), (Names{"a.obj", "a.json", "b.off", "b.json", "c.off", "c.json"}));
  for(const char* format : {"ply", ".PLY", "ts"})
  {
    SCOPED_TRACE(format);
    const std::string ending = format == std::string("ts") ? ".ts" : ".ply",
                      begin = ending == ".ts" ? "GOCAD" : "ply\n";
    fs::remove_all(path("out"));
    run_batch(std::string("in --output-folder out --format ") + format, 0);
    EXPECT_EQ(names_of_files("out"), (Names{"a" + ending, "a.json", "b" + ending, "b.json", "c" + ending, "c.json"}));
    EXPECT_EQ(content(path("out/a" + ending)).substr(0, begin.size()), begin);
  }
}

TEST_F(Batch, refuses_to_start)
{
  write_meshes({"a.off", "b.off"});
  fs::create_directories(path("other"));
  fs::create_directories(path("empty"));
  write("other/a.off", corner_off);
  write("other/b.obj", corner_obj);
  write("other/c.obj", corner_obj);
  write("file", "");
  fs::create_directories(path("linked"));
  fs::create_symlink("../in/a.off", path("linked/a.off"));
  fs::create_symlink("in/a.off", path("bare.off"));
  const std::vector<std::pair<const char*, const char*>> table = {
      {"in other/a.off --output-folder out", "out/a.json: would be written for both in/a.off and other/a.off"},
      {"in other/b.obj --output-folder out", "out/b.json: would be written for both in/b.off and other/b.obj"},
      {"in in/b.off --output-folder out", "in/b.off: is given twice"},
      {"in ./in/b.off --output-folder out", "./in/b.off: is given twice"},
      {"in missing.off --output-folder out", "missing.off: there is no such file"},
      {"in missing --output-folder out", "missing: there is no such file"},
      {"in file --output-folder out", "file: the name of a mesh file has to end with one of .off"},
      {"empty --output-folder out", "empty: there is no mesh file in this folder"},
      {"in '' --output-folder out", ": there is no such file"},
      {"in --output-folder in", "in: the results would be among the meshes"},
      {"in --output-folder ./in/../in --format ply", "the results would be among the meshes"},
      {"in/a.off --output-folder in", "in/a.off: would replace an input"},
      {"linked/a.off --output-folder linked", "linked/a.off: would replace an input"},
      {"bare.off --output-folder .", "bare.off: would replace an input"},
      {"other/c.obj --format off --output-folder in --initial in/c.off", "in/c.off: would replace an input"},
      {"in --output-folder file", "file: cannot be made"},
      {"in --output-folder file/out", "file/out: cannot be made"},
      {"in --output-folder /proc", "cannot be written"},
      {"in --output-folder ''", "--output-folder needs a name"},
      {"in --output-folder out -o out.off", "--output is for one mesh"},
      {"in --output-folder out --json out.json", "--json is for one mesh"},
      {"in --output-folder out --colored out", "--colored is for one mesh"},
      {"in --output-folder out --format stl", "--format has to be one of off, obj, ply, ts, gifti or freesurfer"},
      {"in --output-folder out --format ''", "--format has to be one of"},
      {"in --output-folder out --iterations many", "a whole number from 0"},
      {"in/a.off --resume", "--resume goes with --output-folder"},
      {"in/a.off in/b.off", "there is more than one INPUT; a name with blanks has to be quoted"},
      {"--output-folder out", "there is no INPUT"},
  };
  write("in/c.off", corner_off);
  const Names before = names_of_files("in");
  for(const auto& [arguments, message] : table)
  {
    expect_message(arguments, message);
    EXPECT_FALSE(fs::exists(path("out"))) << arguments;
  }
  EXPECT_EQ(names_of_files("in"), before);
  EXPECT_EQ(names_of_files("linked").size(), 1u);
}

TEST_F(Batch, leaves_out_exactly_what_is_done)
{
  write_meshes({"a.off", "b.off", "c.off", "d.off", "e.off", "f.off"});
  const Names all = names_of_files("in");
  EXPECT_EQ(redone("in"), all);
  const fs::file_time_type time = fs::last_write_time(path("out/a.off"));
  EXPECT_EQ(redone("in"), Names());
  EXPECT_NE(m_outcome.out.find("Mapped 0, left out 6, folded 0, failed 0"), std::string::npos) << m_outcome.out;
  EXPECT_EQ(redone("in --threads 1"), Names()); // as it is the same map
  EXPECT_EQ(redone("in/../in"), Names());       // as it is the same file
  EXPECT_EQ(fs::last_write_time(path("out/a.off")), time);

  // the map
  fs::remove(path("out/a.off"));
  fs::resize_file(path("out/b.off"), fs::file_size(path("out/b.off")) - 1);
  EXPECT_EQ(redone("in"), (Names{"a.off", "b.off"}));
  std::string map = content(path("out/c.off"));
  ++map[map.size() / 2];
  write("out/c.off", map);
  EXPECT_EQ(redone("in"), (Names{"c.off"}));
  // the report
  fs::remove(path("out/a.json"));
  fs::resize_file(path("out/b.json"), 100);
  write("out/c.json", "");
  write("out/d.json", "[1, 2]");
  write("out/e.json", "{\"program\": {\"method\": 1}}");
  write("out/f.json", std::string(1000000, '[')); // which a parser that calls itself for each would not survive
  EXPECT_EQ(redone("in"), all);
  std::string rows, numbers;
  for(int i = 0; i < 50000; ++i)
  {
    rows += "\n    [1, 2.5e-3, null],";
    numbers += "1, ";
  }
  replace_in("out/a.json", "\"history\": [", "\"history\": [" + rows); // as of a run with many sweeps
  replace_in("out/b.json", "\"history\": [", "\"more\": [" + numbers + "1], \"history\": [");
  fs::resize_file(path("out/c.json"), fs::file_size(path("out/c.json")) / 2); // within the history
  std::string report = content(path("out/d.json"));
  report.erase(report.find("],", report.find("history")), 1); // damage where nothing is read
  write("out/d.json", report);
  EXPECT_EQ(redone("in"), (Names{"b.off", "c.off", "d.off"}));
  replace_in("out/a.json", "converged", "interrupted");
  replace_in("out/b.json", "\"program\": \"spherical_parameterization",
             "\"program\": \"spherical_parameterization 0.0.1");
  EXPECT_EQ(redone("in"), (Names{"a.off", "b.off"}));
  // the input
  const fs::file_time_type time_of_c = fs::last_write_time(path("in/c.off"));
  make_older("in/c.off", 1); // as if it were another file of the same size
  EXPECT_EQ(redone("in"), (Names{"c.off"}));
  fs::last_write_time(path("in/c.off"), time_of_c);
  EXPECT_EQ(redone("in"), (Names{"c.off"}));
  const fs::file_time_type time_of_d = fs::last_write_time(path("in/d.off"));
  write("in/d.off", corner_off + "# longer\n");
  fs::last_write_time(path("in/d.off"), time_of_d);
  EXPECT_EQ(redone("in"), (Names{"d.off"}));
  const std::size_t size = 10000;
  write("in/e.off", corner_off + '#' + std::string(size - corner_off.size() - 1, ' '));
  EXPECT_EQ(redone("in --format off"), (Names{"e.off"}));
  const fs::file_time_type time_of_e = fs::last_write_time(path("in/e.off"));
  fs::remove(path("in/e.off"));
  write("in/e.obj", corner_obj + '#' + std::string(size - corner_obj.size() - 1, ' '));
  fs::last_write_time(path("in/e.obj"), time_of_e);
  EXPECT_EQ(redone("in --format off"), (Names{"e.obj"}));
  EXPECT_EQ(redone("in --format off"), Names());
  fs::remove(path("in/e.obj"));
  fs::remove(path("in/f.off"));

  // the options
  const Names rest = names_of_files("in");
  for(const char* options : {"--prefer worst", "--iterations 1", "--iterations 2", "--radius fixed=2",
                             "--method harmonic", "--format ply", "--time-limit 100", "--method hierarchical"})
  {
    SCOPED_TRACE(options);
    EXPECT_EQ(redone(std::string("in ") + options), rest);
    EXPECT_EQ(redone(std::string("in ") + options), Names());
  }
  // without --resume nothing is left out
  EXPECT_EQ(run_batch("in --output-folder out", 0).size(), rest.size());
  EXPECT_EQ(run_batch("in --output-folder out", 0).size(), rest.size());
}

TEST_F(Batch, starts_again_if_the_start_is_another_one)
{
  write_meshes({"a.off", "b.off"});
  ASSERT_EQ(run("in/a.off -o start.off --iterations 0").status, 0);
  EXPECT_EQ(redone("in --initial start.off"), (Names{"a.off", "b.off"}));
  EXPECT_EQ(redone("in --initial start.off"), Names());
  make_older("start.off", 1);
  EXPECT_EQ(redone("in --initial start.off"), (Names{"a.off", "b.off"}));
  EXPECT_EQ(redone("in --initial start.off"), Names());
  write("start.off", content(path("start.off")) + "\n");
  EXPECT_EQ(redone("in --initial start.off"), (Names{"a.off", "b.off"}));
}

TEST_F(Batch, goes_on_where_a_file_cannot_be_written)
{
  write_meshes({"a.off", "b.off", "c.off"});
  write_off("in/long.off", test_meshes::icosphere(4));
  fs::create_directories(path("out/b.json"));
  ASSERT_EQ(run_script("mkfifo out/c.off").status, 0);
  // a pipe without a reader would wait for one
  m_outcome = run_script("ulimit -f 100; timeout 60 \"$PROGRAM\" in --output-folder out");
  EXPECT_EQ(m_outcome.status, 1);
  for(const char* message : {"in/long.off: failed: out/long.off: cannot be written: File too large\n",
                             "in/b.off: failed: out/b.json: cannot be written: it is a directory\n",
                             "in/c.off: failed: out/c.off: cannot be written: it is a pipe or a device"})
    EXPECT_NE(m_outcome.out.find(message), std::string::npos) << m_outcome.out;
  EXPECT_EQ(names_of_files("out"), (Names{"a.off", "a.json", "b.json", "c.off"}));
  fs::remove(path("out/b.json"));
  fs::remove(path("out/c.off"));
  EXPECT_EQ(redone("in"), (Names{"b.off", "c.off", "long.off"}));
}

TEST_F(Batch, writes_nowhere_but_to_its_folder)
{
  write_meshes({"a.off", "b.off", "c.off"});
  write("precious.txt", "precious");
  fs::create_directory(path("out"));
  fs::create_directory(path("folder"));
  for(const char* name : {"out/a.json", "out/b.off", "out/.spherical_parameterization"})
    fs::create_symlink("../precious.txt", path(name));
  fs::create_symlink("../in/c.off", path("out/a.off"));
  fs::create_symlink("../folder", path("out/b.json"));
  fs::create_symlink("../new.txt", path("out/c.json"));
  fs::create_hard_link(path("precious.txt"), path("out/c.off"));
  run_batch("in --output-folder out", 0);
  EXPECT_EQ(content(path("precious.txt")), "precious");
  EXPECT_EQ(content(path("in/c.off")), corner_off);
  EXPECT_TRUE(names_of_files("folder").empty());
  EXPECT_FALSE(fs::exists(path("new.txt")));
  for(const char* name : {"out/a.off", "out/a.json", "out/b.off", "out/b.json", "out/c.off", "out/c.json"})
    EXPECT_FALSE(fs::is_symlink(path(name))) << name;
  EXPECT_EQ(redone("in"), Names());
}

TEST_F(Batch, keeps_the_modes_of_files)
{
  write_meshes({"a.off"});
  run_batch("in --output-folder out", 0);
  const fs::perms secret = fs::perms::owner_read | fs::perms::owner_write, open = secret | fs::perms::others_read;
  fs::permissions(path("out/a.off"), secret);
  fs::permissions(path("out/a.json"), open);
  run_batch("in --output-folder out", 0);
  EXPECT_EQ(fs::status(path("out/a.off")).permissions(), secret);
  EXPECT_EQ(fs::status(path("out/a.json")).permissions(), open);
}

TEST_F(Batch, maps_the_others_where_links_lead_nowhere)
{
  write_meshes({"a.off"});
  fs::create_symlink("nowhere", path("in/broken.off"));
  fs::create_symlink("loop.off", path("in/loop.off"));
  const auto told = run_batch("in --output-folder out", 1);
  EXPECT_EQ(told.size(), 3u);
  EXPECT_EQ(told.at("in/broken.off"), "failed: No such file or directory");
  EXPECT_EQ(told.at("in/loop.off"), "failed: Too many levels of symbolic links");
  EXPECT_EQ(names_of_files("out"), (Names{"a.off", "a.json"}));
}

TEST_F(Batch, sweeps_what_killed_runs_have_left)
{
  write_meshes({"a.off"});
  fs::create_directory(path("out"));
  // of a process that is no more, of one that is, of another computer, and of another container on this one
  const Outcome outcome = run_script("host=.spherical_parameterization.$(uname -n); "
                                     "name=$host.$(stat -L -c %i /proc/self/ns/pid || echo 0); sh -c : & wait $!; "
                                     "touch out/$name.$!.1 out/$name.$$.2 out/.spherical_parameterization.other.1.$!.3 "
                                     "out/$host.1.$!.4; "
                                     "\"$PROGRAM\" in --output-folder out; cd out && \"$PROGRAM\" a.off -o b.off");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(names_of_files("out").size(), 6u); // two maps, a report, and what may still be written
  ASSERT_EQ(run("out/a.off -o out/b.off").status, 0);
  EXPECT_EQ(names_of_files("out").size(), 5u); // the shell of the first run is no more
}

TEST_F(Batch, keeps_no_result_of_a_mesh_that_fails)
{
  write_meshes({"a.off", "b.off"});
  run_batch("in --output-folder out", 0);
  write_off("in/a.off", test_meshes::torus(8, 5));
  EXPECT_EQ(redone("in", 1), Names{"a.off"});
  EXPECT_EQ(names_of_files("out"), (Names{"b.off", "b.json"}));
  EXPECT_EQ(redone("in", 1), Names{"a.off"}); // tried again
}

TEST_F(Batch, tells_by_its_exit_status_what_has_become_of_the_meshes)
{
  write_meshes({"a.off", "b.off"});
  run_batch("in --output-folder out --method conformal", 0);
  write_off("in/spiky.off", test_meshes::random_stacked_sphere(300, 7));
  auto told = run_batch("in --output-folder out --method conformal", 2);
  EXPECT_NE(told.at("in/spiky.off").find(", folds: "), std::string::npos) << told.at("in/spiky.off");
  EXPECT_NE(m_outcome.err.find("in/spiky.off: the map is not one-to-one"), std::string::npos) << m_outcome.err;
  EXPECT_NE(m_outcome.out.find("Mapped 3, left out 0, folded 1, failed 0"), std::string::npos) << m_outcome.out;
  EXPECT_TRUE(fs::exists(path("out/spiky.off")));
  EXPECT_EQ(redone("in --method conformal", 2), Names());
  EXPECT_NE(m_outcome.out.find("Mapped 0, left out 3, folded 1, failed 0"), std::string::npos) << m_outcome.out;
  EXPECT_EQ(m_outcome.err, "spherical_parameterization: in/spiky.off: the map of an earlier run is not one-to-one\n");
  write("in/bad.off", "");
  run_batch("in --output-folder out --method conformal", 1);
  EXPECT_EQ(redone("in --method conformal", 1), Names{"bad.off"});
}

TEST_F(Batch, is_quiet)
{
  write_meshes({"a.off", "b.off"});
  write("in/bad.off", "");
  const Outcome outcome = run("in --output-folder out --quiet");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  EXPECT_EQ(outcome.err.find("spherical_parameterization: in/bad.off: the file is empty"), 0u) << outcome.err;
  EXPECT_EQ(names_of_files("out"), (Names{"a.off", "a.json", "b.off", "b.json"}));
}

// Interrupts runs on two threads as soon as there is a map.
class Interrupted_batch : public Batch
{
protected:
  static constexpr std::size_t n = 30;

  void SetUp() override
  {
    Batch::SetUp();
    write_off("in/0.off", test_meshes::bumpy_sphere(4));
    for(std::size_t i = 1; i < n; ++i)
      fs::copy_file(path("in/0.off"), path("in/" + std::to_string(i) + ".off"));
  }

  // returns the names without endings of the meshes that are told to be mapped, which are not all. A busy machine may let
  // the signal come after the last mesh: then all is repeated.
  Names interrupt_by(const std::string& signal, const std::string& preparation, const std::string& options = "") const
  {
    Names mapped;
    Outcome outcome;
    for(int attempt = 0; attempt == 0 || (attempt < 20 && mapped.size() == n); ++attempt)
    {
      // A shell makes its background processes deaf to Ctrl-C, unless they have an ear for it of their own.
      outcome = run_script(preparation + "\"$PROGRAM\" in --output-folder out --threads 2 " + options +
                           " & while kill -0 $! && ! grep -q "
                           "'^.1/' stdout.txt; do sleep 0.01; done; kill -" +
                           signal + " $!; wait $!");
      mapped.clear();
      const std::regex pattern("\\] in/([0-9]+)\\.off: 2562 vertices");
      for(std::sregex_iterator match(outcome.out.begin(), outcome.out.end(), pattern), end; match != end; ++match)
        mapped.insert((*match)[1]);
    }
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_GT(mapped.size(), 0u);
    EXPECT_LT(mapped.size(), n);
    const std::string missed = "interrupted: " + std::to_string(n - mapped.size()) + " of 30 meshes";
    EXPECT_NE(outcome.err.find(missed), std::string::npos) << outcome.err;
    return mapped;
  }

  // returns the names without endings of the meshes that have a map and a report; nothing else is there
  Names results() const
  {
    Names stems, expected;
    const Names files = names_of_files("out");
    for(const std::string& name : files)
      stems.insert(fs::path(name).stem().string());
    for(const std::string& stem : stems)
      expected.insert({stem + ".off", stem + ".json"});
    EXPECT_EQ(files, expected);
    return stems;
  }
};

TEST_F(Interrupted_batch, leaves_nothing_incomplete_and_goes_on_later)
{
  const Names mapped = interrupt_by("TERM", "rm -rf out; ");
  EXPECT_EQ(results(), mapped);
  EXPECT_EQ(redone("in").size(), n - mapped.size());
  ASSERT_EQ(run("in/0.off -o single.off").status, 0);
  const std::string expected = content(path("single.off"));
  for(std::size_t i = 0; i < n; ++i)
    EXPECT_TRUE(content(path("out/" + std::to_string(i) + ".off")) == expected) << i;
}

TEST_F(Interrupted_batch, leaves_no_template_that_was_stopped_on_its_way)
{
  write_off("model.off", test_meshes::scaled(test_meshes::icosphere(2), 1., 1.3, 0.8));
  const Names mapped = interrupt_by("TERM", "rm -rf out; ", "--template model.off");
  EXPECT_EQ(results(), mapped);
  for(const std::string& name : mapped)
    EXPECT_NE(json("out/" + name + ".json").get<std::string>("match.stop_reason"), "stopped by the visitor") << name;
}

TEST_F(Interrupted_batch, keeps_the_earlier_results_of_meshes_that_are_not_begun)
{
  for(const char* signal : {"INT", "HUP"})
  {
    interrupt_by(signal, "\"$PROGRAM\" in --output-folder out --quiet; ");
    const std::size_t n_results = results().size();
    EXPECT_GE(n_results, n - 2);
    EXPECT_EQ(redone("in").size(), n - n_results);
  }
}

// Which of the two comes second makes no difference.
TEST(Interrupt_guard_death, ends_the_program_at_the_second_signal)
{
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  for(const int first : {SIGINT, SIGTERM, SIGHUP})
    for(const int second : {SIGINT, SIGTERM})
      EXPECT_EXIT(
          {
            const Program::Interrupt_guard guard;
            std::raise(first);
            std::cerr << (Program::Interrupt_guard::is_interrupted() ? "interrupted" : "") << std::endl;
            std::raise(second);
            std::exit(EXIT_SUCCESS);
          },
          ::testing::KilledBySignal(second), "^interrupted");
}

TEST(Interrupt_guard, leaves_it_to_nohup_what_a_hangup_means)
{
  std::signal(SIGHUP, SIG_IGN);
  {
    const Program::Interrupt_guard guard;
    std::raise(SIGHUP);
    EXPECT_FALSE(Program::Interrupt_guard::is_interrupted());
  }
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
}

TEST(Interrupt_guard, tells_all_threads_of_a_signal) // as the sanitizer of threads can tell
{
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const Program::Interrupt_guard guard;
        std::thread other([] {
          while(!Program::Interrupt_guard::is_interrupted())
            std::this_thread::yield();
        });
        std::raise(SIGINT);
        other.join();
        std::exit(EXIT_SUCCESS);
      },
      ::testing::ExitedWithCode(EXIT_SUCCESS), "");
}

using Program::Batch_scheduler;
using Program::Thread_limit;

constexpr std::uintmax_t large = Batch_scheduler::large;

TEST(Batch_scheduling, starts_with_the_largest_mesh)
{
  const Thread_limit one_thread(1);
  std::vector<std::size_t> order;
  Batch_scheduler::for_each_mesh({5, large, 7, 5, 3 * large, 0, large - 1}, [&](std::size_t i) { order.push_back(i); });
  EXPECT_EQ(order, (std::vector<std::size_t>{4, 1, 6, 2, 0, 3, 5}));
  Batch_scheduler::for_each_mesh({}, [&](std::size_t) { FAIL(); });
}

#ifdef CGAL_LINKED_WITH_TBB

// What goes on at the same time, told by the meshes as they begin and end.
class Meshes_at_hand
{
public:
  void begin(std::uintmax_t size)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    ++(size < large ? m_small : m_large);
    m_max = (std::max)(m_max, m_small + m_large);
    m_is_large_alone = m_is_large_alone && (m_large == 0 || m_large + m_small == 1);
    m_changed.notify_all();
  }

  void end(std::uintmax_t size)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    --(size < large ? m_small : m_large);
  }

  // returns whether there are so many at once, at last
  bool wait_for(std::size_t n)
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    m_is_patient = m_is_patient && m_changed.wait_for(lock, std::chrono::minutes(2), [&] { return m_max >= n; });
    return m_is_patient;
  }

  std::size_t max_at_once() const { return m_max; }
  bool is_large_alone() const { return m_is_large_alone; }

private:
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::size_t m_small = 0, m_large = 0, m_max = 0;
  bool m_is_large_alone = true, m_is_patient = true;
};

TEST(Batch_scheduling, runs_small_meshes_on_a_core_each_and_large_ones_on_all)
{
  for(const int n_threads : {1, 2, 4})
  {
    SCOPED_TRACE(n_threads);
    const Thread_limit limit(static_cast<unsigned int>(n_threads));
    tbb::task_arena arena(n_threads); // on any machine
    const std::size_t n_at_once = static_cast<std::size_t>(n_threads);
    const std::size_t n_small = 40;
    std::vector<std::uintmax_t> sizes(n_small);
    std::iota(sizes.begin(), sizes.end(), std::uintmax_t(1));
    sizes.insert(sizes.end(), 3, large);
    std::vector<int> counts(sizes.size(), 0), concurrency(sizes.size(), 0);
    Meshes_at_hand at_hand;
    const auto run = [&](std::size_t i) {
      at_hand.begin(sizes[i]);
      ++counts[i];
      concurrency[i] = tbb::this_task_arena::max_concurrency();
      if(sizes[i] < large)
      {
        EXPECT_TRUE(at_hand.wait_for(n_at_once)); // the others come, however late
      }
      at_hand.end(sizes[i]);
    };
    arena.execute([&] { Batch_scheduler::for_each_mesh(sizes, run); });
    EXPECT_EQ(counts, std::vector<int>(sizes.size(), 1));
    EXPECT_EQ(at_hand.max_at_once(), n_at_once);
    EXPECT_TRUE(at_hand.is_large_alone());
    for(std::size_t i = 0; i < sizes.size(); ++i)
    {
      const bool is_alone = sizes[i] < large && sizes[i] > n_at_once; // the last ones, which are the smallest, get help
      EXPECT_EQ(concurrency[i], is_alone ? 1 : n_threads) << i;
    }
  }
}

#endif

} // namespace

#endif
