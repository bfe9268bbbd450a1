// What the command line program resamples between spheres.

#include "Program_fixture.h"

// In CGAL's tree the program is not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

class Resampling_program : public Program_fixture
{
protected:
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

  std::vector<double> read_curv(const std::string& name) const
  {
    return read_by(name, SP::IO::read_FreeSurfer_curv).columns.at(0).values;
  }

  const std::vector<test_meshes::Coordinates> directions = test_meshes::tilted(test_meshes::icosphere(1)).points;
};

TEST_F(Resampling_program, values_are_interpolated_or_averaged)
{
  const std::string spheres = "resample lh.height fine.off coarse.off ";
  EXPECT_EQ(expect_success(spheres + "-o lh.coarse"),
            "resampled by barycentric weights: 642 to 42 vertices, of which 0 get nothing\n");
  expect_success(spheres + "--areas fine.off coarse.off -o lh.adaptive --quiet");
  expect_success(spheres + "--method nearest -o lh.nearest --threads 1");
  expect_success(spheres + "--method largest --areas fine.off coarse.off -o lh.largest");
  for(const auto& [name, tolerance] :
      {std::pair("coarse", 0.01), {"adaptive", 0.1}, {"nearest", 0.1}, {"largest", 0.1}})
  {
    const std::vector<double> values = read_curv(std::string("lh.") + name);
    ASSERT_EQ(values.size(), directions.size());
    for(std::size_t v = 0; v < directions.size(); ++v)
      EXPECT_NEAR(values[v], directions[v][2], tolerance) << name;
  }
  EXPECT_NE(read_curv("lh.coarse"), read_curv("lh.adaptive"));
  // Areas may be given as values as well.
  write_curv("lh.areas", std::vector<double>(642, 1.));
  expect_success(spheres + "--areas lh.areas coarse.off -o lh.even");
  EXPECT_NE(read_curv("lh.even"), read_curv("lh.adaptive"));
}

TEST_F(Resampling_program, surfaces_and_many_files_are_resampled)
{
  write_curv("lh.other", std::vector<double>(642, 3.));
  expect_success("resample lh.height lh.other fine.off fine.off coarse.off --output-folder results");
  EXPECT_EQ(names_of_files("results"), (Names{"fine.off", "lh.height", "lh.other"}));
  for(const double x : read_curv("results/lh.other"))
    EXPECT_FLOAT_EQ(static_cast<float>(x), 3.f);
  // The points of a sphere are interpolated to those of the other one, but below it.
  EXPECT_EQ(read_mesh("results/fine.off").faces, read_mesh("coarse.off").faces);
  expect_near(read_mesh("results/fine.off").points, directions, 0.02);
}

TEST_F(Resampling_program, the_vertices_that_the_mask_leaves_without_values_are_reported)
{
  const auto points = test_meshes::icosphere(3).points;
  std::string rows;
  std::size_t n = 0;
  for(std::size_t v = 0; v < points.size(); ++v)
    if(points[v][2] > 0.)
    {
      rows += std::to_string(v) + " 0 0 0 0\n";
      ++n;
    }
  write("lh.north.label", "#!ascii label\n" + std::to_string(n) + '\n' + rows);
  const std::string text =
      expect_success("resample lh.height fine.off coarse.off --mask lh.north.label --valid lh.valid -o lh.north");
  const std::vector<double> north = read_curv("lh.north"), valid = read_curv("lh.valid");
  std::size_t n_empty = 0;
  for(std::size_t v = 0; v < directions.size(); ++v)
  {
    EXPECT_EQ(valid[v] == 0., north[v] == 0.);
    EXPECT_GE(north[v], 0.);
    EXPECT_TRUE(valid[v] == 1. || directions[v][2] < 0.);
    n_empty += valid[v] == 0.;
  }
  EXPECT_GT(n_empty, 10u);
  expect_part(text, "of which " + std::to_string(n_empty) + " get nothing");
  // The values are a mask as well.
  expect_success("resample lh.height fine.off coarse.off --mask lh.height -o lh.again");
  EXPECT_EQ(read_curv("lh.again"), north);
}

TEST_F(Resampling_program, spheres_are_carried_through_a_registration)
{
  // Through a rotation, it is rotated.
  write_off("turned.off", test_meshes::turned(test_meshes::icosphere(3), 0.5));
  EXPECT_EQ(expect_success("resample coarse.off fine.off turned.off --through -o result.off"),
            "carried through the registration: 1 sphere\n");
  expect_near(read_mesh("result.off").points,
              test_meshes::turned(test_meshes::tilted(test_meshes::icosphere(1)), 0.5).points, 1e-14);
  // a registration with inverted faces
  write_off("folded.off", test_meshes::scaled(test_meshes::icosphere(3), 1., 1., -1.));
  const Outcome outcome = run("resample coarse.off fine.off folded.off --through -o result.off");
  EXPECT_EQ(outcome.status, 2);
  expect_part(outcome.err, "result.off: folds");
  expect_messages(
      "resample ",
      {{"coarse.off fine.off coarse.off --through -o a.off", "coarse.off: is of 42 vertices, but fine.off has 642"},
       {"lh.height fine.off turned.off --through -o a.off", "lh.height: has values of vertices"},
       {"coarse.off fine.off fine.off --through --valid a -o a.off", "--valid"}});
}

TEST_F(Resampling_program, errors_are_named)
{
  auto folded = test_meshes::icosphere(1);
  for(double& x : folded.points[20])
    x = -x;
  write_off("folded.off", folded);
  write_off("torus.off", test_meshes::torus(20, 30));
  expect_messages("resample lh.height fine.off coarse.off ",
                  {{"", "-o"},
                   {"-o lh.a --output-folder b", "--output-folder"},
                   {"--method bld -o lh.a", "barycentric, adaptive, nearest or largest"},
                   {"--method largest -o lh.a", "--method largest needs --areas"},
                   {"--method nearest --areas fine.off coarse.off -o lh.a", "--areas goes with --method"},
                   {"-o lh.height", "lh.height: would replace the input"},
                   {"-o coarse.off", "coarse.off: would replace the input"},
                   {"-o a.off", "a.off: has to be a name that ends with .gii, .mgh, .mgz or .annot"},
                   {"-o lh.annot", "lh.annot: cannot hold values without a table of labels"},
                   {"-o lh.a --valid lh.a", "lh.a: would be written twice"},
                   {"--areas coarse.off fine.off -o lh.a", "coarse.off: is of 42 vertices, but fine.off has 642"},
                   {"--areas lh.height coarse.off -o lh.a", "lh.height: has an area that is negative"},
                   {"--mask coarse.off -o lh.a", "coarse.off: has no values of vertices"}});
  expect_messages("resample ",
                  {{"lh.height coarse.off fine.off -o lh.a", "lh.height: is of 642 vertices, but coarse.off has 42"},
                   {"fine.off fine.off coarse.off --mask lh.height -o a.off", "leave out --mask"},
                   {"lh.height fine.off lh.height -o lh.a", "lh.height: has values of vertices, but no surface"},
                   {"missing fine.off coarse.off -o lh.a", "missing: No such file or directory"},
                   {"lh.height fine.off folded.off -o lh.a", "folded.off: is no one-to-one sphere"},
                   {"lh.height fine.off torus.off -o lh.a", "torus.off: "},
                   {"lh.height fine.off", "resample"}});
}

#ifdef TEST_GIFTI
TEST_F(Resampling_program, names_labels_and_metadata_survive)
{
  SP::IO::Surface_file file;
  file.origin.metadata = {{"AnatomicalStructurePrimary", "CortexLeft"}};
  file.labels = {{0, "???", {0., 0., 0., 0.}}, {3, "north", {1., 0., 0., 1.}}, {7, "south", {0., 0., 1., 1.}}};
  file.columns.push_back({"halves", "NIFTI_INTENT_LABEL", SP::IO::Vertex_values::Type::int32, {}, {{"a", "b"}}});
  for(const auto& p : test_meshes::icosphere(3).points)
    file.columns[0].values.push_back(p[2] > 0. ? 3. : 7.);
  const auto write = [&](std::ostream& out) { return SP::IO::write_GIFTI(out, file); };
  write_by("halves.label.gii", write);
  expect_success("resample halves.label.gii fine.off coarse.off -o coarse.label.gii");
  const SP::IO::Surface_file result = read_by("coarse.label.gii", SP::IO::read_GIFTI);
  EXPECT_EQ(result.origin.metadata, file.origin.metadata);
  ASSERT_EQ(result.columns.size(), 1u);
  EXPECT_EQ(result.columns[0].name, "halves");
  EXPECT_EQ(result.columns[0].intent, "NIFTI_INTENT_LABEL");
  EXPECT_EQ(result.columns[0].metadata, file.columns[0].metadata);
  ASSERT_EQ(result.labels.size(), 3u);
  EXPECT_EQ(result.labels[2].name, "south");
  for(std::size_t v = 0; v < directions.size(); ++v)
    EXPECT_TRUE(std::abs(directions[v][2]) < 0.2 || result.columns[0].values[v] == (directions[v][2] > 0. ? 3. : 7.));

  // The table gets a label for what gets nothing.
  file.labels.erase(file.labels.begin());
  write_by("halves.label.gii", write);
  expect_success("resample halves.label.gii fine.off coarse.off --mask lh.height -o north.label.gii");
  expect_success("resample halves.label.gii fine.off coarse.off --mask lh.height -o lh.north.annot");
  const SP::IO::Surface_file north = read_by("north.label.gii", SP::IO::read_GIFTI);
  ASSERT_EQ(north.labels.size(), 3u);
  EXPECT_EQ(north.labels[2].key, 0);
  EXPECT_EQ(north.labels[2].name, "???");
  for(std::size_t v = 0; v < directions.size(); ++v)
    EXPECT_TRUE(north.columns[0].values[v] == 3. || (north.columns[0].values[v] == 0. && directions[v][2] < 0.));

  // What FreeSurfer says by the name becomes metadata.
  expect_success("resample lh.height fine.off coarse.off -o height.shape.gii");
  const SP::IO::Surface_file values = read_by("height.shape.gii", SP::IO::read_GIFTI);
  EXPECT_EQ(values.columns.at(0).name, "height");
  EXPECT_EQ(values.origin.metadata, (SP::IO::Metadata{{"AnatomicalStructurePrimary", "CortexLeft"}}));
  file.columns.push_back(file.columns[0]);
  write_by("two.label.gii", write);
  expect_message("resample two.label.gii fine.off coarse.off -o lh.a", "lh.a: cannot hold 2 columns");
}
#endif

#endif // SPHERICAL_PARAMETERIZATION_PROGRAM
