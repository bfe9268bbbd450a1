// The command `match` of the command line program: the map, its landmarks, features and masks, and the faces that it splits.

#include "Program_fixture.h"
#include "images.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

using test_meshes::Coordinates;

struct Match_program : Program_fixture
{
  Match_program()
  {
    write_off("sphere.off", test_meshes::icosphere(2));
    write_off("target.off", test_meshes::scaled(test_meshes::icosphere(1), 1., 1.2, 0.9));
  }
};

TEST_F(Match_program, maps_a_surface_onto_another_one)
{
  const std::string map = "match sphere.off target.off";
  const std::string out = run(map + " -o mapped.off --sphere p.off --overlay overlay.ply --morph 0.25 morph.off "
                                    "--json mapped.json --expected-errors errors.ply")
                              .out;
  expect_part(out, "Onto:      target.off: 42 vertices");
  EXPECT_LT(json("mapped.json").get<double>("match.energy.average"), 2.2);
  const Mesh_file first = read_mesh("sphere.off"), mapped = read_mesh("mapped.off"), target = read_mesh("target.off"),
                  morph = read_mesh("morph.off");
  for(const char* name : {"p.off", "mapped.off"})
    EXPECT_EQ(read_mesh(name).faces, first.faces) << name;
  EXPECT_EQ(read_mesh("p_target.off").faces, target.faces);
  // The directions are a map of the first surface, the other file is one of the target, which has the points there.
  expect_success("sphere.off --initial p.off --iterations 0");
  expect_success("remesh target.off p.off --initial p_target.off --iterations 0 -o again.off");
  expect_near(read_mesh("again.off").points, mapped.points);

  const Mesh_file errors = read_mesh("errors.ply");
  expect_near(errors.points, first.points);
  double largest = 0.;
  for(const double error : errors.columns.at("vertex expected_error"))
  {
    EXPECT_GE(error, 0.);
    largest = (std::max)(largest, error);
  }
  EXPECT_GE(largest, json("mapped.json").get<double>("match.expected_error"));

  // The common refinement begins with the vertices of both.
  Mesh_file overlay = read_mesh("overlay.ply");
  const std::size_t n = overlay.points.size(), n_first = first.points.size(), n_target = target.points.size();
  ASSERT_GT(n, n_first + n_target);
  EXPECT_EQ(overlay.faces.size(), 2 * n - 4);
  EXPECT_EQ(morph.faces, overlay.faces);
  std::vector<Coordinates> on_target, aligned;
  for(std::size_t v = 0; v < n; ++v)
  {
    on_target.push_back({overlay.columns["vertex x_on_target"][v], overlay.columns["vertex y_on_target"][v],
                         overlay.columns["vertex z_on_target"][v]});
    aligned.push_back(test::combination(4., morph.points[v], -3., overlay.points[v]));
  }
  // The morph leads to a similar copy of the target.
  const auto size = [](const std::vector<Coordinates>& points, std::size_t v) {
    return test::distance(points[v], points[0]);
  };
  for(std::size_t v = 2; v < n; ++v)
    EXPECT_NEAR(size(aligned, v) * size(on_target, 1), size(on_target, v) * size(aligned, 1), 1e-11) << v;
  const auto part = [](const std::vector<Coordinates>& all, std::size_t begin, std::size_t end) {
    return std::vector<Coordinates>(all.data() + begin, all.data() + end);
  };
  expect_near(part(overlay.points, 0, n_first), first.points);
  expect_near(part(on_target, 0, n_first), mapped.points);
  expect_near(part(on_target, n_first, n_first + n_target), target.points);
  const auto used = [](const std::vector<double>& column) { return std::set<double>(column.begin(), column.end()); };
  EXPECT_EQ(used(overlay.columns["face face"]).size(), first.faces.size());
  EXPECT_EQ(used(overlay.columns["face face_of_target"]).size(), target.faces.size());

  Outcome outcome = run(map + " --time-limit 1e-9");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expect_part(outcome.out, "; time limit");
  expect_message(map + " --quiet -o result.off --time-limit 1e-9 --expected-errors e.ply",
                 "--expected-errors cannot be written");
  expect_messages(map + " -o result.off ", {{"--morph 2 m.off", "--morph must be a number from 0 to 1"},
                                            {"--overlay overlay.off", "the name of a .ply file"},
                                            {"--expected-errors e.off", "--expected-errors must be a file name"},
                                            {"--expected-errors e.ply --features a.ply b.ply", "cannot be combined"}});
  write_off("torus.off", test_meshes::torus(8, 5));
  expect_message("match sphere.off torus.off -o result.off", "genus");

  write_off("hubs.off", test_meshes::suspension(3000)); // with too many crossings to be refined in common
  EXPECT_EQ(run("match hubs.off hubs.off --quiet -o mapped.off --json mapped.json").status, 0);
  EXPECT_LT(json("mapped.json").get<double>("match.sampled_energy"), 2.1);
  expect_message("match hubs.off hubs.off --quiet -o result.off --overlay refined.ply",
                 "The common refinement of the two surfaces exceeds");
}

// A copy in another pose and size, far from the surface, with coordinates whose squares overflow.
TEST_F(Match_program, aligns_the_target_of_a_morph)
{
  const test_meshes::Triangle_list surface = test_meshes::bumpy_sphere(2);
  write_off("surface.off", surface);
  for(const double scale : {3., 1e200})
  {
    test_meshes::Triangle_list copy = test_meshes::scaled(test_meshes::tilted(surface), scale, scale, scale);
    for(Coordinates& p : copy.points)
      p = {p[0] + 40. * scale, p[1] - 20. * scale, p[2] + 10. * scale};
    write_off("copy.off", copy);
    for(const char* time : {"0", "0.5", "1"})
    {
      SCOPED_TRACE(time);
      expect_success(std::string("match surface.off copy.off --morph ") + time + " morph.off");
      std::vector<Coordinates> points = read_mesh("morph.off").points;
      points.resize(surface.points.size()); // those of the surface come first
      expect_near(points, surface.points, std::string(time) == "0" ? 0. : 1e-10);
    }
  }
}

TEST_F(Match_program, takes_landmarks)
{
  const std::string map = "match sphere.off target.off";
  write("b.txt", "7\n8\n11\n");
  for(const char* text : {"0 comment\n\n1\n5\n",
                          "\xEF\xBB\xBF"
                          "0\n1\n5\n", // the mark that some editors put before UTF-8
                          "0\r1\r5\r", "0\r\n1\r\n5", "0\r1 a\n5"})
  {
    write("a.txt", text);
    const Outcome outcome = run(map + " --landmarks a.txt b.txt --json mapped.json");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(json("mapped.json").get_child("match.landmark_distances").size(), 3u);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'),
              json("mapped.json").get<std::ptrdiff_t>("match.missed_landmarks"));
  }
  EXPECT_EQ(run("match --landmarks a.txt b.txt --soft-landmarks 2 sphere.off target.off").status, 0);
  EXPECT_EQ(run(map + " --quiet --landmarks a.txt b.txt").out, "");

  write("twice.txt", "3\n4\n3\n");
  write("outside.txt", "3\n42\n");
  write("word.txt", "one\n");
  write("few.txt", "0\n");
  write("row.txt", "3\n4 5\n");
  expect_messages(
      map + " -o result.off --landmarks ",
      {{"twice.txt b.txt", "twice.txt: line 3: vertex 3 is already a landmark, in line 1"},
       {"outside.txt outside.txt", "outside.txt: line 2: the mesh has no vertex '42'"},
       {"word.txt b.txt", "word.txt: line 1: 'one' is not a vertex index"},
       {"a.txt missing.txt", "missing.txt: No such file"},
       {"row.txt b.txt", "row.txt: line 2: '5' follows the vertex index '4'; write one vertex index per line"},
       {"few.txt b.txt", "has 3 landmarks, but few.txt has 1"},
       {"a.txt few.txt", "few.txt: has 1 landmark, but a.txt has 3"},
       {"a.txt", "--landmarks"},
       {"a.txt b.txt --soft-landmarks 0", "--soft-landmarks must be"}});
  expect_message(map + " --soft-landmarks 1", "--landmarks");
}

TEST_F(Match_program, compares_features)
{
  const std::string map = "match sphere.off target.off", features = " --features a.ply b.ply";
  write("a.ply", ply_with_values(2));
  write("b.ply", ply_with_values(1));
  const std::string left_out =
      ".ply: not compared: the vertex property 'label', whose type is neither float nor double\n";
  const std::string warnings = "a" + left_out + "b" + left_out + uncertain;
  expect_part(expect_success(map + features, warnings), "Aligned:   by features");
  EXPECT_EQ(run(map + features + " --feature-weights height=2 --compare values").status, 0);
  write("a.txt", "0\n");
  write("nan.ply", ply_with_values(1, "float height", std::numeric_limits<double>::quiet_NaN()));
  write("plain.ply", ply_with_values(1, "uchar zero"));
  expect_messages(map + " -o result.off --features ",
                  {{"a.txt a.txt", "a.txt: it is not a file of vertex values"},
                   {"b.ply b.ply", "b.ply: does not match the mesh: it has values of 42 vertices"},
                   {"a.ply nan.ply", "the property height of vertex 0 is infinite or not"},
                   {"a.ply plain.ply", "plain.ply: has no vertex property"}});
  for(const char* weights : {"height", "height=x", "=1", "height=-1", "height=1,height=2"})
    expect_message(map + features + " --feature-weights " + weights, "--feature-weights must be a list such as sulc=2");
  expect_messages(map + features, {{" --feature-weights depth=2", "has no compared feature 'depth'"},
                                   {" --feature-weights height=0", "all features have the weight 0"},
                                   {" --compare shapes", "--compare must be"}});
  expect_message(map + " --compare values", "--features");
  write("a_mask.ply", ply_with_values(2, "uchar counts"));
  write("b_mask.ply", ply_with_values(1, "uchar counts"));
  write("nothing.ply", ply_with_values(1, "uchar zero"));
  EXPECT_EQ(run(map + features + " --masks a_mask.ply b_mask.ply").status, 0);
  expect_messages(map + " -o result.off --masks ",
                  {{"a_mask.ply nothing.ply", "nothing.ply: is 0 for all vertices"},
                   {"b_mask.ply b_mask.ply", "b_mask.ply: is not a mask of the mesh"},
                   {"a.ply b_mask.ply", "a.ply: is not a mask: it has 2 values per vertex"}});
}

// The vertices of the input come first, and the report says which face of the input each one is a part of.
TEST_F(Match_program, splits_faces_where_that_pays)
{
  write_off("target.off", test_meshes::scaled(test_meshes::icosphere(3), 1., 2., 0.5));
  write("a.txt", "0\n1\n2\n3\n");
  write("b.txt", "3\n1\n5\n20\n"); // not where the landmarks of the sphere are
  const std::string map = "match sphere.off target.off --landmarks a.txt b.txt --split";
  const std::string out = run(map + " -o mapped.off --sphere p.off --overlay overlay.ply --json split.json").out;
  expect_part(out, "Split:     ");
  const Mesh_file first = read_mesh("sphere.off"), mapped = read_mesh("mapped.off");
  const auto report = json("split.json");
  const std::size_t n = report.get<std::size_t>("match.split.new_vertices");
  EXPECT_GT(n, 0u);
  EXPECT_LE(n, first.points.size() / 2);
  EXPECT_EQ(report.get<std::size_t>("match.split.new_faces"), 2 * n);
  EXPECT_EQ(report.get_child("match.split.faces_of_input").size(), first.faces.size() + 2 * n);
  EXPECT_LT(report.get<double>("match.split.energy"), report.get<double>("match.split.energy_before"));
  EXPECT_EQ(mapped.points.size(), first.points.size() + n);
  EXPECT_EQ(mapped.faces.size(), first.faces.size() + 2 * n);
  EXPECT_EQ(mapped.faces, read_mesh("p.off").faces);
  expect_success("mapped.off --initial p.off --iterations 0"); // certified
  const std::vector<double> faces = read_mesh("overlay.ply").columns["face face"];
  EXPECT_LT(*std::max_element(faces.begin(), faces.end()), static_cast<double>(first.faces.size()));
}

} // namespace

#endif
