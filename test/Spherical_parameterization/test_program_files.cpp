// What the command line program does with files, whatever is in them: names, links, pipes, streams; and with threads.

#include "Program_fixture.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

struct File_program : Program_fixture
{
  File_program() { write_off("sphere.off", test_meshes::icosphere(2)); }

  static std::string too_many_threads(unsigned int n_wanted, unsigned int n_had)
  {
    return "spherical_parameterization: --threads " + std::to_string(n_wanted) + ": only " + std::to_string(n_had) +
           (n_had == 1 ? " thread is available\n" : " threads are available\n");
  }
};

TEST_F(File_program, refuses_what_it_cannot_read_or_write)
{
  write("mesh.xyz", "0 0 0\n");
  write("bad.off", "ply\n");
  write("nothing.off", std::string(100000, '\0'));
  write("empty.off", "");
  fs::create_directory(path("folder.off"));
  fs::create_symlink("/dev/zero", path("zeros.off")); // which never ends
  expect_messages("", {{"missing.off -o result.off", "missing.off"},
                       {"mesh.xyz -o result.off", ".off"},
                       {"bad.off", "bad.off: line 1: an OFF file begins with OFF, not with 'ply'"},
                       {"nothing.off", "nothing.off: the file begins with zeros only"},
                       {"empty.off", "empty.off: the file is empty"},
                       {"folder.off -o result.off", "folder.off is a folder"},
                       {"folder.off", "folder.off is a folder"},
                       {"folder.off", "--output-folder"},
                       {"zeros.off -o result.off", "zeros.off: it is a pipe or a device"},
                       {"'' -o result.off", "No such file or directory"}});
  expect_messages("sphere.off ", {{"-o missing/result.off", "missing"},
                                  {"-o result.txt", ".off"},
                                  {"-o folder.off", "folder.off"},
                                  {"-o result.off --json missing/result.json", "missing"},
                                  {"-o result.off --colored missing/result", "missing"},
                                  {"-o result.off --page missing/result.html", "missing"},
                                  {"-o twice.off --json ./twice.off", "would be written twice"},
                                  {"-o ./twice.off --json twice.off", "would be written twice"},
                                  {"-o twice_sphere.ply --colored ./twice", "would be written twice"},
                                  {"-o twice.off --json twice.off", "would be written twice"}});
}

TEST_F(File_program, writes_through_a_link_or_a_pipe_that_is_named)
{
  write("elsewhere/target.off", "");
  fs::permissions(path("elsewhere/target.off"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("elsewhere/target.off", path("link.off"));
  expect_success("sphere.off -o link.off --quiet");
  EXPECT_TRUE(fs::is_symlink(path("link.off")));
  expect_success("sphere.off -o result.off --quiet");
  const std::string expected = content(path("result.off"));
  EXPECT_EQ(content(path("elsewhere/target.off")), expected);
  EXPECT_EQ(fs::status(path("elsewhere/target.off")).permissions(), fs::perms::owner_read | fs::perms::owner_write);

  fs::create_symlink("elsewhere/new.off", path("dangling.off"));
  expect_success("sphere.off -o dangling.off --quiet");
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

TEST_F(File_program, fails_where_its_output_cannot_be_written)
{
  for(const char* arguments :
      {"sphere.off", "sphere.off --json -", "--help", "--version", "batch sphere.off --output-folder out"})
  {
    const Outcome outcome = run(std::string(arguments) + " > /dev/full");
    EXPECT_EQ(outcome.status, 1) << arguments;
    EXPECT_EQ(outcome.err, "spherical_parameterization: cannot write to the standard output\n") << arguments;
  }
  // the map is not lost
  const Outcome full = run("sphere.off -o result.off > /dev/full");
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.err,
            "spherical_parameterization: cannot write to the standard output. All files have been written.\n");
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
  EXPECT_EQ(names_of_files(), (Names{"sphere.off", "out", "stdout.txt", "stderr.txt"}));
}

TEST_F(File_program, runs_on_one_thread_where_no_other_can_be_had)
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
TEST_F(File_program, uses_no_more_threads_than_there_are_cores)
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

TEST_F(File_program, takes_names_of_any_bytes)
{
  const std::string name = "a\xff\xc3\xa4\n\x1b[31m\xc2\x9b.off", shown = "a\\xff\xc3\xa4\\x0a\\x1b[31m\\xc2\\x9b.off";
  fs::create_directory(path("in"));
  fs::copy_file(path("sphere.off"), path("in/" + name));
  const Outcome outcome = run("batch in --output-folder out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 9 + shown.size()), "[1/1] in/" + shown) << outcome.out;
  EXPECT_EQ(json("out/" + name.substr(0, name.size() - 3) + "json").get<std::string>("input"),
            "in/a\\xff\xc3\xa4\n\x1b[31m\xc2\x9b.off");
  expect_part(run("batch in --output-folder out --resume").out, "skipped 1");
  const std::string single = run("'in/" + name + "' -o 'out/" + name + "'").out;
  expect_part(single, "Mesh      in/" + shown);
  expect_part(single, "Written:   out/" + shown);
  for(const std::string& arguments : {"'missing" + name + "'", "batch 'missing" + name + "' --output-folder out",
                                      "sphere.off --initial 'missing" + name + "'",
                                      "sphere.off -o 'missing" + name + "/x.off'", "sphere.off '--" + name + "'"})
    expect_message(arguments, shown.substr(0, shown.size() - 4));

  const std::string long_name = std::string(246, 'x') + ".off"; // there is room for .json, and for no more
  fs::copy_file(path("sphere.off"), path("in/" + long_name));
  EXPECT_EQ(run("batch in --output-folder out").status, 0);
  EXPECT_EQ(run("sphere.off -o " + std::string(251, 'y') + ".off").status, 0);
  fs::copy_file(path("sphere.off"), path("in/" + std::string(251, 'z') + ".off")); // whose report has no name
  expect_message("batch in --output-folder out --quiet", "zzz.json: cannot be written: File name too long");
}

} // namespace

#endif
