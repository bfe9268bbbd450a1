// The command `batch`: what is written for each of many meshes, what stops none of the others, and where nothing is written.

#include "Program_fixture.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

using Batch = Batch_fixture;

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
  write("more/last one.OFF", corner_off);

  const auto said = run_batch("in 'more/last one.OFF' --output-folder new/out", 1);
  ASSERT_EQ(said.size(), 7u);
  EXPECT_EQ(said.at("in/bumpy.off").substr(0, 20), "162 vertices, D_iso ");
  EXPECT_EQ(said.at("in/torus.off").substr(0, 35), "failed: the surface has the genus 1");
  EXPECT_EQ(said.at("in/empty.ply").substr(0, 8), "failed: ");
  EXPECT_EQ(said.at("in/text.ts").substr(0, 8), "failed: ");
  for(const char* message :
      {"in/torus.off: the surface has the genus 1", "The command repair, or --repair, cuts handles",
       "in/empty.ply: ", "in/text.ts: line 1: a surface of a GOCAD file begins with GOCAD"})
    expect_part(m_outcome.err, message);
  expect_part(m_outcome.out, "\nMapped 4, skipped 0, not bijective 0, failed 3; ");

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
  expect_part(m_outcome.out, "skipped 2");
  write_off("model.off", test_meshes::scaled(test_meshes::icosphere(1), 1., 1.3, 0.85)); // then all are done again
  run_batch("in --template model.off --output-folder out --resume", 0);
  expect_part(m_outcome.out, "Mapped 2, skipped 0");
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
  fs::create_directories(path("empty"));
  write("other/a.off", corner_off);
  write("other/b.obj", corner_obj);
  write("other/c.obj", corner_obj);
  write("file", "");
  fs::create_directories(path("linked"));
  fs::create_symlink("../in/a.off", path("linked/a.off"));
  fs::create_symlink("in/a.off", path("bare.off"));
  const Messages table = {
      {"in other/a.off --output-folder out", "out/a.json: would be written for both in/a.off and other/a.off"},
      {"in other/b.obj --output-folder out", "out/b.json: would be written for both in/b.off and other/b.obj"},
      {"in in/b.off --output-folder out", "in/b.off: is given twice"},
      {"in ./in/b.off --output-folder out", "./in/b.off: is given twice"},
      {"in missing.off --output-folder out", "missing.off: no such file"},
      {"in missing --output-folder out", "missing: no such file"},
      {"in file --output-folder out", "file: the name of a mesh file must end with one of .off"},
      {"empty --output-folder out", "empty: this folder contains no file whose name ends with one of .off"},
      {"in '' --output-folder out", ": no such file"},
      {"in --output-folder in", "in: the results would be written among the meshes"},
      {"in --output-folder ./in/../in --format ply", "the results would be written among the meshes"},
      {"in/a.off --output-folder in", "in/a.off: would replace an input"},
      {"linked/a.off --output-folder linked", "linked/a.off: would replace an input"},
      {"bare.off --output-folder .", "bare.off: would replace an input"},
      {"other/c.obj --format off --output-folder in --initial in/c.off", "in/c.off: would replace an input"},
      {"in --output-folder file", "file: cannot be created"},
      {"in --output-folder file/out", "file/out: cannot be created"},
      {"in --output-folder /proc", "cannot be written"},
      {"in --output-folder ''", "--output-folder needs a file name"},
      {"in --output-folder out --format stl", "--format must be off, obj, ply, ts, gifti or freesurfer"},
      {"--output-folder out", "usage: batch INPUT"},
      {"in/a.off in/b.off", "--output-folder"},
      {"in --output-folder out --each-component", "but of map, remesh and repair"},
      {"in/a.off --density in/a.off --output-folder out", "--density"},
      {"in/a.off --template in/b.off --initial in/b.off --output-folder out", "--template"},
  };
  write("in/c.off", corner_off);
  const Names before = names_of_files("in");
  for(const auto& [arguments, message] : table)
    expect_message("batch " + arguments, message);
  EXPECT_EQ(names_of_files("in"), before);
  EXPECT_EQ(names_of_files("linked").size(), 1u);
}

TEST_F(Batch, goes_on_where_a_file_cannot_be_written)
{
  write_meshes({"a.off", "b.off", "c.off"});
  write_off("in/long.off", test_meshes::icosphere(4));
  fs::create_directories(path("out/b.json"));
  ASSERT_EQ(run_script("mkfifo out/c.off").status, 0);
  // a pipe without a reader would wait for one
  m_outcome = run_script("ulimit -f 100; timeout 60 \"$PROGRAM\" batch in --output-folder out");
  EXPECT_EQ(m_outcome.status, 1);
  for(const char* message : {"in/long.off: failed: out/long.off: cannot be written: File too large\n",
                             "in/b.off: failed: out/b.json: cannot be written: it is a directory\n",
                             "in/c.off: failed: out/c.off: cannot be written: it is a pipe or a device"})
    expect_part(m_outcome.out, message);
  EXPECT_EQ(names_of_files("out"), (Names{"a.off", "a.json", "b.json", "c.off"}));
  fs::remove(path("out/b.json"));
  fs::remove(path("out/c.off"));
  EXPECT_EQ(redone("in"), (Names{"b.off", "c.off", "long.off"}));
  // what was there is as good as what could not be written
  EXPECT_EQ(run_script("ulimit -f 100; \"$PROGRAM\" batch in --output-folder out").status, 1);
  EXPECT_EQ(redone("in"), Names());
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

TEST_F(Batch, removes_no_file_of_others_before_there_is_another_one)
{
  write_meshes({"a.off"});
  write_off("in/torus.off", test_meshes::torus(8, 5));
  for(const char* name : {"out/a.off", "out/torus.off", "out/torus.json"})
    write(name, "of somebody else\n");
  run_batch("in --output-folder out", 1);
  EXPECT_NE(content(path("out/a.off")), "of somebody else\n");
  EXPECT_EQ(content(path("out/torus.off")), "of somebody else\n");
  EXPECT_EQ(content(path("out/torus.json")), "of somebody else\n");
}

TEST_F(Batch, goes_on_if_nobody_reads_what_it_tells)
{
  write_meshes({"a.off", "b.off", "c.off"});
  m_outcome = run_script("{ \"$PROGRAM\" batch in --output-folder out --threads 1; echo $? >&2; } | true");
  EXPECT_EQ(m_outcome.err, "spherical_parameterization: cannot write to the standard output\n1\n");
  EXPECT_EQ(names_of_files("out").size(), 6u);
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
  const auto said = run_batch("in --output-folder out", 1);
  EXPECT_EQ(said.size(), 3u);
  EXPECT_EQ(said.at("in/broken.off"), "failed: No such file or directory");
  EXPECT_EQ(said.at("in/loop.off"), "failed: Too many levels of symbolic links");
  EXPECT_EQ(names_of_files("out"), (Names{"a.off", "a.json"}));
}

TEST_F(Batch, sweeps_what_killed_runs_have_left)
{
  write_meshes({"a.off"});
  fs::create_directory(path("out"));
  // of a process that is no more, of one that is, of another computer, and of another container on this one
  const Outcome outcome =
      run_script("host=.spherical_parameterization.$(uname -n); "
                 "name=$host.$(stat -L -c %i /proc/self/ns/pid || echo 0); sh -c : & wait $!; "
                 "touch out/$name.$!.1 out/$name.$$.2 out/.spherical_parameterization.other.1.$!.3 "
                 "out/$host.1.$!.4; "
                 "\"$PROGRAM\" batch in --output-folder out; cd out && \"$PROGRAM\" a.off -o b.off");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(names_of_files("out").size(), 6u); // two maps, a report, and what may still be written
  ASSERT_EQ(run("out/a.off -o out/b.off").status, 0);
  EXPECT_EQ(names_of_files("out").size(), 5u); // the shell of the first run is no more
}

TEST_F(Batch, tells_by_its_exit_status_what_has_become_of_the_meshes)
{
  write_meshes({"a.off", "b.off"});
  run_batch("in --output-folder out --method conformal", 0);
  write_off("in/spiky.off", test_meshes::random_stacked_sphere(300, 7));
  auto said = run_batch("in --output-folder out --method conformal", 2);
  expect_part(said.at("in/spiky.off"), ", not bijective: ");
  expect_part(m_outcome.err, "in/spiky.off: the map is not bijective");
  expect_part(m_outcome.out, "Mapped 3, skipped 0, not bijective 1, failed 0");
  EXPECT_TRUE(fs::exists(path("out/spiky.off")));
  EXPECT_EQ(redone("in --method conformal", 2), Names());
  expect_part(m_outcome.out, "Mapped 0, skipped 3, not bijective 1, failed 0");
  EXPECT_EQ(m_outcome.err, "spherical_parameterization: in/spiky.off: the map of an earlier run is not bijective\n");
  write("in/bad.off", "");
  run_batch("in --output-folder out --method conformal", 1);
  EXPECT_EQ(redone("in --method conformal", 1), Names{"bad.off"});
}

TEST_F(Batch, is_quiet)
{
  write_meshes({"a.off", "b.off"});
  write("in/bad.off", "");
  const Outcome outcome = run("batch in --output-folder out --quiet");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  EXPECT_EQ(outcome.err.find("spherical_parameterization: in/bad.off: the file is empty"), 0u) << outcome.err;
  EXPECT_EQ(names_of_files("out"), (Names{"a.off", "a.json", "b.off", "b.json"}));
}

} // namespace

#endif
