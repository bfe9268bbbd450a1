// The command line: commands, --help, options of earlier versions, completion, and the command `check`.

#include "Program_fixture.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

const std::vector<std::string> commands = {"map",   "match",  "register", "resample", "remesh",
                                           "check", "repair", "batch",    "show"};

struct Commands : Program_fixture
{
  Commands()
  {
    write("corner.off", corner_off);
    write_off("torus.off", test_meshes::torus(8, 5));
  }
};

// The help of a command is short, begins with the usage and ends with an example.
TEST_F(Commands, have_a_help)
{
  for(const std::string& command : commands)
  {
    const std::string help = expect_success(command + " --help");
    EXPECT_EQ(expect_success(command + " -h"), help);
    SCOPED_TRACE(command);
    EXPECT_LE(std::count(help.begin(), help.end(), '\n'), 60);
    std::istringstream lines(help);
    for(std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), 100u) << line;
    EXPECT_EQ(help.find("Usage: spherical_parameterization " + command + ' '), 0u) << help;
    expect_part(help, "\nOptions:\n  -");
    expect_part(help, "\n\nExample: spherical_parameterization " + command + ' ');
    for(const auto& [option, homes] : std::map<std::string, Names>{{"landmarks", {"match", "register"}},
                                                                   {"features", {"match", "register"}},
                                                                   {"transfer", {"remesh"}},
                                                                   {"areas", {"resample"}},
                                                                   {"output-folder", {"resample", "batch"}},
                                                                   {"resume", {"batch"}},
                                                                   {"handles", {"repair"}},
                                                                   {"beside", {"show"}}})
      EXPECT_EQ(std::regex_search(help, std::regex("--" + option + "[ \n]")), homes.count(command) > 0) << option;
  }
  const std::string help = expect_success("--help");
  EXPECT_EQ(expect_success("-h"), help);
  EXPECT_LE(std::count(help.begin(), help.end(), '\n'), 40) << help;
  for(const std::string& command : commands)
    expect_part(help, ' ' + command + ' ');
  expect_part(help.substr(0, help.find("\n\n")), "spherical_parameterization ");
  expect_part(help.substr(help.find("\n  2   ")), "resample --through"); // which may also have the exit status 2
  EXPECT_EQ(expect_success("--version").substr(0, 27), "spherical_parameterization ");
}

TEST_F(Commands, are_first_words)
{
  expect_success("map corner.off -o expected.off");
  expect_success("corner.off -o short.off");
  expect_success("-o last.off corner.off");
  expect_success("corner.off -o map --format freesurfer"); // a surface, as its first bytes show
  expect_success("./map -o file.off");
  expect_success("map map -o of_map.off");
  for(const char* name : {"short.off", "last.off"})
    EXPECT_EQ(content(path(name)), content(path("expected.off"))) << name;
  EXPECT_EQ(content(path("file.off")), content(path("of_map.off")));
  expect_success("corner.off --output-folder out"); // means batch
  EXPECT_EQ(names_of_files("out"), (Names{"corner.off", "corner.json"}));
  for(const std::string& command : commands)
    expect_message(command, "spherical_parameterization " + command + " --help");
  expect_messages("", {{"", "no file name is given"},
                       {"corner.off torus.off", "'corner.off' is not a command, and map takes one SURFACE"},
                       {"match corner.off", "TARGET"},
                       {"match corner.off torus.off corner.off", "TARGET"},
                       {"register corner.off corner.off", "--features"},
                       {"batch corner.off", "--output-folder"},
                       {"show corner.off", "-o"},
                       {"corner.off -o", "-o"},
                       {"corner.off -o a.off -o b.off", "-o"},
                       {"--no corner.off", "--no"}});
}

TEST_F(Commands, say_where_options_went)
{
  const auto form = [](const std::string& text) { return ": spherical_parameterization " + text + " ..."; };
  expect_messages("corner.off ",
                  {{"--onto corner.off", form("match SURFACE TARGET")},
                   {"--onto-atlas corner.off --features a b", form("register SURFACE ATLAS --features A B")},
                   {"--remesh cube=2", form("remesh SURFACE DOMAIN=N")},
                   {"--resample a b", form("resample VALUES SPHERE_A SPHERE_B -o RESULT")},
                   {"--through a b", form("resample SPHERE SPHERE_A SPHERE_B --through -o RESULT")},
                   {"--filled a.ply", form("repair SURFACE -o RESULT")},
                   {"--fill-holes all", form("map SURFACE --repair")},
                   {"--components each", "or --each-component: spherical_parameterization map SURFACE --repair"},
                   {"--s-first 1", form("map SURFACE --schedule FIRST,LAST")},
                   {"--s-last=1", form("map SURFACE --schedule FIRST,LAST")},
                   {"--average-sweeps 1", form("map SURFACE --schedule FIRST,LAST,SWEEPS")}});
  // Other options are those of other commands.
  for(const auto& [command, options] : Messages{
          {"match", "landmarks soft-landmarks features feature-weights compare masks regularize split overlay morph"},
          {"remesh", "geometry-image image-size transfer values-sphere"},
          {"resample", "areas mask valid"},
          {"batch", "template resume"},
          {"repair", "handles"},
          {"show", "beside"}})
    for(const std::string& option : words_of(options))
      expect_message("map corner.off --" + option + " a b",
                     "--" + option + " is not an option of map, but of " + command);
  expect_messages("", {{"match corner.off corner.off --remesh cube=2", form("remesh SURFACE DOMAIN=N")},
                       {"batch corner.off --output-folder out -o a.off", "-o"},
                       {"batch corner.off --output-folder out --json a.json", "--json is not an option of batch"},
                       {"remesh corner.off cube=2 --unknown", "spherical_parameterization remesh --help"},
                       {"check corner.off --json r.json", "check SURFACE SPHERE --json FILE"},
                       {"corner.off --unknown", "--unknown"}});
}

TEST_F(Commands, suggest_what_may_be_meant)
{
  write("mach", "");
  expect_messages("", {{"corner.off --reapir", "unknown option --reapir; did you mean --repair?"},
                       {"check corner.off --jsn=a.json", "unknown option --jsn; did you mean --json?"},
                       {"batch corner.off --output-foldr out", "did you mean --output-folder?"},
                       {"map corner.off --unknown", "unknown option --unknown\nSee 'spherical_parameterization map"},
                       {"remsh corner.off cube=2", "'remsh' is not a command; did you mean 'remesh'?"},
                       {"remsh corner.off cube=2 --transfer a.ply", "'remsh' is not a command; did you mean 'remesh'?"},
                       {"mach corner.off", "'mach' is not a command, and map takes one SURFACE"}, // which is a file
                       {"a corner.off", "'a' is not a command, and map takes one SURFACE"},
                       {"-- --reapir", "--reapir: No such file"}});
}

TEST_F(Commands, are_completed_by_bash)
{
  write("completion", expect_success("--completion bash"));
  const auto completions = [&](const std::string& words) { // of the last one
    const Outcome outcome =
        run_script("bash -c 'source ./completion; COMP_WORDS=(spherical_parameterization " + words +
                   "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); "
                   "f=$(complete -p spherical_parameterization | sed \"s/.*-F \\([^ ]*\\).*/\\1/\"); "
                   "$f spherical_parameterization; printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    Names names;
    for(std::string line; std::getline(lines, line);)
      names.insert(line.substr(0, line.find_last_not_of(' ') + 1));
    return names;
  };
  EXPECT_EQ(completions("rem"), Names{"remesh"});
  EXPECT_EQ(completions("re"), (Names{"register", "remesh", "repair", "resample"}));
  EXPECT_EQ(completions("match a.off b.off --soft"), Names{"--soft-landmarks"});
  EXPECT_EQ(completions("resample --are"), Names{"--areas"});
  EXPECT_EQ(completions("map --are"), Names{""});
}

TEST_F(Commands, check_surfaces_and_their_spheres)
{
  expect_success("corner.off -o sphere.off --json made.json");
  expect_part(expect_success("check corner.off"), "can be mapped");
  const std::string out = expect_success("check corner.off sphere.off --json checked.json");
  expect_part(out, "Certified");
  expect_part(out, "D_iso");
  for(const char* key : {"vertices", "distortion.D_angle.maximum", "distortion.D_angle.average"})
    EXPECT_NEAR(json("checked.json").get<double>(key), json("made.json").get<double>(key), 1e-9) << key;
  write("checked.json", expect_success("check corner.off sphere.off --json - --quiet"));
  EXPECT_TRUE(json("checked.json").get<bool>("one_to_one"));

  write_off("ball.off", test_meshes::icosphere(1));
  write_off("mirrored.off", test_meshes::scaled(test_meshes::icosphere(1), -1., 1., 1.));
  expect_success("check ball.off ball.off");
  const Outcome outcome = run("check ball.off mirrored.off");
  EXPECT_NE(outcome.status, 0);
  EXPECT_EQ(outcome.out.find("Certified"), std::string::npos) << outcome.out;
  expect_part(outcome.err, "not bijective");
  expect_messages("check ", {{"torus.off", "the surface has the genus 1"},
                             {"torus.off sphere.off", "the surface has the genus 1"},
                             {"ball.off sphere.off", "vertices"},
                             {"ball.off --method arap", "--method"}});
}

TEST_F(Commands, says_what_is_wrong_with_a_mesh)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", begin = "4 4 0\n" + points, rest = "3 1 2 3\n3 2 0 3\n";
  const Messages table = {
      {"0 0 0\n", "no faces"},
      {"4 4 0\n0 0 0\n1 nan 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n" + rest, "vertex 1 has a coordinate"},
      {"4 4 0\n0 0 0\n1 inf 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n" + rest, "vertex 1 has a coordinate"},
      {begin + "3 0 2 1\n3 0 1 1\n" + rest, "face 1 has the vertex 1 twice"},
      {begin + "3 0 2 1\n2 0 1\n" + rest, "face 1 is not a triangle but has 2 corners"},
      {"4 3 0\n" + points + "4 0 2 1 3\n" + rest, "face 0 is not a triangle but has 4 corners"},
      {"4 3 0\n" + points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n", "the mesh has a border"},
      {begin + "3 0 1 2\n3 0 1 3\n" + rest,
       "the faces 0 and 1 are oriented against each other: both use the edge between the vertices 0 and 1 in the same"},
      {"4 5 0\n" + points + "3 0 2 1\n3 0 1 3\n" + rest + "3 1 0 2\n", "the faces 0 and 4 have the same corners"},
      {"3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n", "only 3 vertices have a face"},
      {"7 8 0\n" + points + "-1 0 0\n0 -1 0\n0 0 -1\n3 0 2 1\n3 0 1 3\n" + rest +
           "3 0 4 5\n3 0 6 4\n3 4 6 5\n3 5 6 0\n",
       "the surface touches itself in vertex 0"},
      {"12 4 0\n0 0 0\n0 1 0\n1 0 0\n0 0 0\n1 0 0\n0 0 1\n1 0 0\n0 1 0\n0 0 1\n0 1 0\n0 0 0\n0 0 1\n"
       "3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n",
       "8 vertices repeat the position of another one"}};
  write("start.off", "");
  for(const auto& [text, message] : table)
  {
    write("bad.off", "OFF\n" + text);
    expect_messages("", {{"bad.off -o result.off --json result.json --colored result", message},
                         {"bad.off --initial start.off", message}, // before the map to start from
                         {"check bad.off", message}});
  }
}

TEST_F(Commands, counts_the_faces_of_an_edge_that_has_many)
{
  std::ostringstream points, faces;
  for(int i = 0; i < 50000; ++i)
  {
    points << "0 1 " << i << '\n';
    faces << "3 0 1 " << i + 2 << '\n';
  }
  const std::string text = "OFF\n50002 50001 0\n0 0 0\n1 0 0\n" + points.str() + faces.str();
  for(const auto& [last_face, message] :
      Messages{{"3 0 1 2\n", "the faces 0 and 50000 have the same corners"},
               {"3 0 2 3\n", "the edge between the vertices 0 and 1 has 50000 faces"}})
  {
    write("book.off", text + last_face);
    expect_message("book.off -o result.off", message);
  }
}

} // namespace

#endif
