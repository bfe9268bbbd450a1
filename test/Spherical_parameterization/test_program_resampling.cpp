// What the command line program resamples between spheres.

#include "Program_fixture.h"

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#ifdef TEST_GIFTI
#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#endif

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

// In CGAL's tree the examples are not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

class Resampling_program : public Program_fixture
{
protected:
  using Surface_file = CGAL::Spherical_parameterization::IO::Surface_file;
  using Vertex_values = CGAL::Spherical_parameterization::IO::Vertex_values;

  void SetUp() override
  {
    Program_fixture::SetUp();
    write_off("fine.off", test_meshes::icosphere(3));
    write_off("coarse.off", test_meshes::tilted(test_meshes::icosphere(1)));
    std::vector<double> heights;
    for(const auto& p : test_meshes::icosphere(3).points)
      heights.push_back(p[2]);
    write_curv("lh.height", heights);
  }

  template <class Write>
  void write_file(const std::string& name, const Write& write) const
  {
    std::ofstream out(path(name), std::ios::binary);
    ASSERT_EQ(write(out), CGAL::Spherical_parameterization::OK);
  }

  void write_curv(const std::string& name, const std::vector<double>& values) const
  {
    Vertex_values column;
    column.values = values;
    write_file(name, [&](std::ostream& out) {
      return CGAL::Spherical_parameterization::IO::write_FreeSurfer_curv(out, column, 2 * values.size() - 4);
    });
  }

  template <class Read>
  Surface_file read_file(const std::string& name, const Read& read) const
  {
    Surface_file file;
    std::string message;
    std::ifstream in(path(name), std::ios::binary);
    EXPECT_EQ(read(in, file, message), CGAL::Spherical_parameterization::OK) << message;
    return file;
  }

  std::vector<double> read_curv(const std::string& name) const
  {
    return read_file(name, CGAL::Spherical_parameterization::IO::read_FreeSurfer_curv).columns.at(0).values;
  }

  std::string expect_success(const std::string& arguments) const
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
};

TEST_F(Resampling_program, values_are_interpolated_or_averaged)
{
  EXPECT_EQ(expect_success("lh.height --resample fine.off coarse.off -o lh.coarse"),
            "resampled by barycentric weights: 642 to 42 vertices, of which 0 get nothing\n");
  expect_success("lh.height --resample fine.off coarse.off --areas fine.off coarse.off -o lh.adaptive --quiet");
  expect_success("lh.height --resample fine.off coarse.off --method nearest -o lh.nearest --threads 1");
  expect_success("lh.height --resample fine.off coarse.off --method largest --areas fine.off coarse.off -o lh.largest");
  const auto points = test_meshes::tilted(test_meshes::icosphere(1)).points;
  const std::vector<double> coarse = read_curv("lh.coarse"), adaptive = read_curv("lh.adaptive"),
                            nearest = read_curv("lh.nearest"), largest = read_curv("lh.largest");
  ASSERT_EQ(coarse.size(), points.size());
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    EXPECT_NEAR(coarse[v], points[v][2], 0.01);
    EXPECT_NEAR(adaptive[v], points[v][2], 0.1);
    EXPECT_NEAR(nearest[v], points[v][2], 0.1);
    EXPECT_NEAR(largest[v], points[v][2], 0.1);
  }
  EXPECT_NE(coarse, adaptive);
  // Areas may be given as values as well.
  write_curv("lh.areas", std::vector<double>(642, 1.));
  expect_success("lh.height --areas lh.areas coarse.off --resample fine.off coarse.off -o lh.even");
  EXPECT_NE(read_curv("lh.even"), adaptive);
}

TEST_F(Resampling_program, surfaces_and_many_files_are_resampled)
{
  write_curv("lh.other", std::vector<double>(642, 3.));
  expect_success("lh.height lh.other fine.off --resample fine.off coarse.off --output-folder results");
  EXPECT_EQ(names_of_files("results"), (std::set<std::string>{"fine.off", "lh.height", "lh.other"}));
  for(const double x : read_curv("results/lh.other"))
    EXPECT_FLOAT_EQ(static_cast<float>(x), 3.f);
  // The points of a sphere are interpolated to those of the other one, but below it.
  std::ifstream in(path("results/fine.off"));
  std::string word;
  std::size_t n_vertices = 0, n_faces = 0, n_edges = 0;
  in >> word >> n_vertices >> n_faces >> n_edges;
  EXPECT_EQ(n_vertices, 42u);
  EXPECT_EQ(n_faces, 80u);
  for(const auto& q : test_meshes::tilted(test_meshes::icosphere(1)).points)
    for(std::size_t i = 0; i < 3; ++i)
    {
      double x = 0.;
      in >> x;
      EXPECT_NEAR(x, q[i], 0.02);
    }
}

TEST_F(Resampling_program, what_the_mask_leaves_out_is_told)
{
  write_file("lh.north.label", [&](std::ostream& out) {
    const auto points = test_meshes::icosphere(3).points;
    std::string rows;
    std::size_t n = 0;
    for(std::size_t v = 0; v < points.size(); ++v)
      if(points[v][2] > 0.)
      {
        rows += std::to_string(v) + " 0 0 0 0\n";
        ++n;
      }
    out << "#!ascii label\n" << n << '\n' << rows;
    return CGAL::Spherical_parameterization::OK;
  });
  const std::string text = expect_success("lh.height --resample fine.off coarse.off --mask lh.north.label "
                                          "--valid lh.valid -o lh.north");
  const std::vector<double> north = read_curv("lh.north"), valid = read_curv("lh.valid");
  const auto points = test_meshes::tilted(test_meshes::icosphere(1)).points;
  std::size_t n_empty = 0;
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    EXPECT_EQ(valid[v] == 0., north[v] == 0.);
    EXPECT_GE(north[v], 0.);
    EXPECT_TRUE(valid[v] == 1. || points[v][2] < 0.);
    n_empty += valid[v] == 0.;
  }
  EXPECT_GT(n_empty, 10u);
  EXPECT_NE(text.find("of which " + std::to_string(n_empty) + " get nothing"), std::string::npos) << text;
  // The values are a mask as well.
  expect_success("lh.height --resample fine.off coarse.off --mask lh.height -o lh.again");
  EXPECT_EQ(read_curv("lh.again"), north);
}

TEST_F(Resampling_program, spheres_are_carried_through_a_registration)
{
  // Through a rotation, it is turned.
  write_off("turned.off", test_meshes::turned(test_meshes::icosphere(3), 0.5));
  EXPECT_EQ(expect_success("coarse.off --through fine.off turned.off -o result.off"),
            "carried through the registration: 1 sphere\n");
  std::ifstream in(path("result.off"));
  std::string line;
  std::getline(in, line);
  std::getline(in, line);
  const auto expected = test_meshes::turned(test_meshes::tilted(test_meshes::icosphere(1)), 0.5);
  for(const auto& q : expected.points)
    for(std::size_t i = 0; i < 3; ++i)
    {
      double x = 0.;
      in >> x;
      EXPECT_NEAR(x, q[i], 1e-14);
    }
  // A registration that folds
  auto folded = test_meshes::icosphere(3);
  for(auto& p : folded.points)
    p[2] = -p[2];
  write_off("folded.off", folded);
  const Outcome outcome = run("coarse.off --through fine.off folded.off -o result.off");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("result.off: folds"), std::string::npos) << outcome.err;
  expect_message("coarse.off --through fine.off coarse.off -o result.off",
                 "coarse.off: is of 42 vertices, but fine.off has 642");
  expect_message("lh.height --through fine.off turned.off -o result.off", "lh.height: has values of vertices");
}

TEST_F(Resampling_program, what_is_wrong_is_told)
{
  const std::string spheres = "lh.height --resample fine.off coarse.off ";
  expect_message(spheres, "--resample needs -o or --output-folder");
  expect_message(spheres + "-o lh.a --output-folder b", "--resample needs one of -o and --output-folder");
  expect_message("lh.height --resample fine.off -o lh.a", "--resample needs two files");
  expect_message("lh.height --areas a b -o lh.a", "--areas goes with --resample");
  expect_message("lh.height --mask a -o lh.a", "--mask goes with --resample");
  expect_message("coarse.off --through fine.off fine.off --valid a -o a.off", "--valid goes with --resample");
  expect_message(spheres + "--through fine.off coarse.off -o lh.a", "--resample and --through contradict each other");
  expect_message(spheres + "--remesh cube=4 -o lh.a", "--remesh and --resample cannot be combined");
  expect_message(spheres + "--method bld -o lh.a",
                 "--method has to be barycentric, adaptive, nearest or largest, not 'bld'");
  expect_message(spheres + "--method largest -o lh.a", "--method largest needs --areas");
  expect_message(spheres + "--method nearest --areas fine.off coarse.off -o lh.a", "--areas goes with --method");
  expect_message(spheres + "-o lh.height", "lh.height: would replace the input");
  expect_message(spheres + "-o coarse.off", "coarse.off: would replace the input");
  expect_message(spheres + "-o a.off", "a.off: has to be a name that ends with .gii, .mgh, .mgz or .annot");
  expect_message(spheres + "-o lh.annot", "lh.annot: cannot hold values without a table of labels");
  expect_message(spheres + "-o lh.a --valid lh.a", "lh.a: would be written twice");
  expect_message("lh.height --resample coarse.off fine.off -o lh.a",
                 "lh.height: is of 642 vertices, but coarse.off has 42");
  expect_message(spheres + "--areas coarse.off fine.off -o lh.a",
                 "coarse.off: is of 42 vertices, but fine.off has 642");
  expect_message(spheres + "--areas lh.height coarse.off -o lh.a", "lh.height: has an area that is negative");
  expect_message(spheres + "--mask coarse.off -o lh.a", "coarse.off: has no values of vertices");
  expect_message("fine.off --resample fine.off coarse.off --mask lh.height -o a.off", "leave out --mask");
  expect_message("lh.height --resample fine.off lh.height -o lh.a",
                 "lh.height: has values of vertices, but no surface");
  expect_message("missing --resample fine.off coarse.off -o lh.a", "missing: No such file or directory");
  auto folded = test_meshes::icosphere(1);
  for(double& x : folded.points[20])
    x = -x;
  write_off("folded.off", folded);
  expect_message("lh.height --resample fine.off folded.off -o lh.a", "folded.off: is no one-to-one sphere");
  write_off("folded.off", test_meshes::torus(20, 30));
  expect_message("lh.height --resample fine.off folded.off -o lh.a", "folded.off: ");
  EXPECT_FALSE(std::filesystem::exists(path("lh.a")));
}

#ifdef TEST_GIFTI
TEST_F(Resampling_program, names_labels_and_metadata_survive)
{
  Surface_file file;
  file.origin.metadata = {{"AnatomicalStructurePrimary", "CortexLeft"}};
  file.labels = {{0, "???", {0., 0., 0., 0.}}, {3, "north", {1., 0., 0., 1.}}, {7, "south", {0., 0., 1., 1.}}};
  file.columns.push_back({"halves", "NIFTI_INTENT_LABEL", Vertex_values::Type::int32, {}, {{"a", "b"}}});
  const auto points = test_meshes::icosphere(3).points;
  for(const auto& p : points)
    file.columns[0].values.push_back(p[2] > 0. ? 3. : 7.);
  const auto write = [&](std::ostream& out) { return CGAL::Spherical_parameterization::IO::write_GIFTI(out, file); };
  write_file("halves.label.gii", write);
  expect_success("halves.label.gii --resample fine.off coarse.off -o coarse.label.gii");
  const Surface_file result = read_file("coarse.label.gii", CGAL::Spherical_parameterization::IO::read_GIFTI);
  EXPECT_EQ(result.origin.metadata, file.origin.metadata);
  ASSERT_EQ(result.columns.size(), 1u);
  EXPECT_EQ(result.columns[0].name, "halves");
  EXPECT_EQ(result.columns[0].intent, "NIFTI_INTENT_LABEL");
  EXPECT_EQ(result.columns[0].metadata, file.columns[0].metadata);
  ASSERT_EQ(result.labels.size(), 3u);
  EXPECT_EQ(result.labels[2].name, "south");
  const auto directions = test_meshes::tilted(test_meshes::icosphere(1)).points;
  for(std::size_t v = 0; v < directions.size(); ++v)
    EXPECT_TRUE(std::abs(directions[v][2]) < 0.2 || result.columns[0].values[v] == (directions[v][2] > 0. ? 3. : 7.));

  // The table gets a label for what gets nothing.
  file.labels.erase(file.labels.begin());
  write_file("halves.label.gii", write);
  expect_success("halves.label.gii --resample fine.off coarse.off --mask lh.height -o north.label.gii");
  expect_success("halves.label.gii --resample fine.off coarse.off --mask lh.height -o lh.north.annot");
  const Surface_file north = read_file("north.label.gii", CGAL::Spherical_parameterization::IO::read_GIFTI);
  ASSERT_EQ(north.labels.size(), 3u);
  EXPECT_EQ(north.labels[2].key, 0);
  EXPECT_EQ(north.labels[2].name, "???");
  for(std::size_t v = 0; v < directions.size(); ++v)
    EXPECT_TRUE(north.columns[0].values[v] == 3. || (north.columns[0].values[v] == 0. && directions[v][2] < 0.));

  // What FreeSurfer says by the name becomes metadata.
  expect_success("lh.height --resample fine.off coarse.off -o height.shape.gii");
  const Surface_file values = read_file("height.shape.gii", CGAL::Spherical_parameterization::IO::read_GIFTI);
  EXPECT_EQ(values.columns.at(0).name, "height");
  EXPECT_EQ(values.origin.metadata,
            (CGAL::Spherical_parameterization::IO::Metadata{{"AnatomicalStructurePrimary", "CortexLeft"}}));
  file.columns.push_back(file.columns[0]);
  write_file("two.label.gii", write);
  expect_message("two.label.gii --resample fine.off coarse.off -o lh.a", "lh.a: cannot hold 2 columns");
}
#endif

#endif // SPHERICAL_PARAMETERIZATION_PROGRAM
