// The command `batch` once more: what --resume leaves out, and what an interruption leaves.

#include "Program_fixture.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

#include <boost/crc.hpp>

namespace {

struct Resumed_batch : Batch_fixture
{
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
};

TEST_F(Resumed_batch, leaves_out_exactly_what_is_done)
{
  write_meshes({"a.off", "b.off", "c.off", "d.off", "e.off", "f.off"});
  const Names all = names_of_files("in");
  EXPECT_EQ(redone("in"), all);
  const fs::file_time_type time = fs::last_write_time(path("out/a.off"));
  EXPECT_EQ(redone("in"), Names());
  expect_part(m_outcome.out, "Mapped 0, skipped 6, not bijective 0, failed 0");
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
  write("out/f.json", std::string(1000000, '['));
  EXPECT_EQ(redone("in"), all);
  std::string rows;
  for(int i = 0; i < 50000; ++i)
    rows += "\n    [1, 2.5e-3, null],";
  replace_in("out/a.json", "\"history\": [", "\"history\": [" + rows);        // as of a run with many sweeps
  fs::resize_file(path("out/c.json"), fs::file_size(path("out/c.json")) / 2); // within the history
  std::string report = content(path("out/d.json"));
  report.erase(report.find("],", report.find("history")), 1); // damage where nothing is read
  write("out/d.json", report);
  EXPECT_EQ(redone("in"), (Names{"c.off", "d.off"}));
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
  // without --resume nothing is skipped
  EXPECT_EQ(run_batch("in --output-folder out", 0).size(), rest.size());
  EXPECT_EQ(run_batch("in --output-folder out", 0).size(), rest.size());
}

TEST_F(Resumed_batch, starts_again_if_the_start_is_another_one)
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

TEST_F(Resumed_batch, keeps_no_result_of_a_mesh_that_fails)
{
  write_meshes({"a.off", "b.off"});
  run_batch("in --output-folder out", 0);
  write_off("in/a.off", test_meshes::torus(8, 5));
  EXPECT_EQ(redone("in", 1), Names{"a.off"});
  EXPECT_EQ(names_of_files("out"), (Names{"b.off", "b.json"}));
  EXPECT_EQ(redone("in", 1), Names{"a.off"}); // tried again
}

// Interrupts runs on two threads as soon as there is a map.
struct Interrupted_batch : Batch_fixture
{
  static constexpr std::size_t n = 30;

  Interrupted_batch()
  {
    write_off("in/0.off", test_meshes::bumpy_sphere(4));
    for(std::size_t i = 1; i < n; ++i)
      fs::copy_file(path("in/0.off"), path("in/" + std::to_string(i) + ".off"));
  }

  // returns the names without endings of the meshes that are reported as mapped, which are not all. A busy machine may let
  // the signal come after the last mesh: then all is repeated.
  Names interrupt_by(const std::string& signal, const std::string& preparation, const std::string& options = "") const
  {
    Names mapped;
    Outcome outcome;
    for(int attempt = 0; attempt == 0 || (attempt < 20 && mapped.size() == n); ++attempt)
    {
      // A shell makes its background processes deaf to Ctrl-C, unless they have an ear for it of their own.
      outcome = run_script(preparation + "\"$PROGRAM\" batch in --output-folder out --threads 2 " + options +
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
    expect_part(outcome.err, missed);
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

TEST_F(Interrupted_batch, keeps_the_earlier_results)
{
  for(const char* signal : {"INT", "HUP"})
  {
    interrupt_by(signal, "\"$PROGRAM\" batch in --output-folder out --quiet; ");
    EXPECT_EQ(results().size(), n);
    EXPECT_EQ(redone("in"), Names());
  }
}

} // namespace

#endif
