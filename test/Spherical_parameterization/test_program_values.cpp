// What the command line program does with values of vertices and faces: the properties of PLY files, and what is resampled between
// spheres. How PLY files are read: test_files_meshes.cpp.

#include "Program_fixture.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

using namespace ply_files;

// an element with more properties, which have commas between them, before its own ones
Ply_element with(const std::string& more, Ply_element element)
{
  std::istringstream in(more);
  std::size_t k = 1;
  for(std::string property; std::getline(in >> std::ws, property, ',');)
    element.insert(element.begin() + static_cast<std::ptrdiff_t>(k++), property);
  return element;
}

const std::string binary = "binary_little_endian";

struct Ply_files : Program_fixture
{
  // transfers the properties of a surface to its remesh
  Outcome transfer(const std::string& text)
  {
    write("values.ply", text);
    return run("remesh values.ply octahedron=2 --method stereographic --transfer values.ply -o result.ply --quiet");
  }

  // the properties of the result, as in its header
  std::multiset<std::string> properties() const
  {
    std::istringstream header(content(path("result.ply")));
    std::multiset<std::string> result;
    std::string element;
    for(std::string line; std::getline(header, line) && line != "end_header";)
      if(const std::vector<std::string> words = words_of(line); words[0] == "element")
        element = words[1] + ' ';
      else if(words[0] == "property")
        result.insert(element + words.back());
    return result;
  }
};

TEST_F(Ply_files, keep_the_properties_that_have_a_name_of_their_own)
{
  struct Row
  {
    std::string of_vertices, of_faces;
    std::multiset<std::string> written;
    std::string left_out_of_vertices, left_out_of_faces;
  };
  std::vector<Row> table = {
      {"float red,float green,float blue", "", {"vertex red", "vertex green", "vertex blue"}, "", ""},
      {"uchar red,uchar green,uchar blue,float alpha,int color",
       "uchar red,uchar green,uchar blue,uchar alpha",
       {"vertex red", "vertex green", "vertex blue", "vertex alpha", "face red", "face green", "face blue",
        "face alpha"},
       "alpha color",
       ""},
      {"uchar red,int color", "float alpha", {"vertex red", "vertex color", "face alpha"}, "", ""},
      {"float nx,float ny,float nz", "", {}, "", ""},
      {"float nx", "float nx", {"face nx"}, "nx", ""},
      {"double sphere,int initial", "", {"vertex sphere", "vertex initial"}, "", ""},
      {"double point,float normal,uchar removed,int connectivity",
       "int vertex_index,uchar removed,int connectivity,float point",
       {"face point"},
       "point normal removed connectivity",
       "vertex_index removed connectivity"}};
  for(const std::string type : {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"})
    table.push_back({type + " new", type + " new", {"vertex new", "face new"}, "", ""});
  std::map<std::string, Numbers> numbers = usual_numbers;
  numbers.erase("vertex_index");
  for(const Row& row : table)
  {
    SCOPED_TRACE(row.of_vertices + "; " + row.of_faces);
    std::string warnings;
    for(const auto& [names, elements] : Messages{{row.left_out_of_vertices, "vertex"}, {row.left_out_of_faces, "face"}})
      for(const std::string& name : words_of(names))
        warnings +=
            "values.ply: not transferred: the " + elements + " property '" + name + "', whose name is reserved\n";
    const Outcome outcome =
        transfer(ply_file(binary, {with(row.of_vertices, vertices), with(row.of_faces, faces)}, numbers));
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, warnings);
    std::multiset<std::string> expected = row.written;
    expected.insert({"vertex x", "vertex y", "vertex z", "vertex nx", "vertex ny", "vertex nz", "vertex height",
                     "face vertex_indices", "face label"});
    EXPECT_EQ(properties(), expected);
  }
  EXPECT_EQ(
      transfer(ply_file(binary, {with("list uchar float weights", vertices), with("list int uchar weights", faces)}))
          .err,
      "values.ply: not transferred: the list 'weights' of 'vertex'\n"
      "values.ply: not transferred: the list 'weights' of 'face'\n");
  numbers["blue"] = Numbers(4, {255});
  const Ply_element colors = {"face",     "list uchar int vertex_indices", "uchar alpha", "uchar blue", "uchar green",
                              "uchar red"};
  EXPECT_EQ(transfer(ply_file("ascii", {vertices, colors}, numbers)).status, 0);
  const std::string result = content(path("result.ply"));
  EXPECT_EQ(result.substr(result.size() - 4, 3), "\x04\x04\xff"); // red, green, blue, alpha
}

TEST_F(Ply_files, tell_what_is_no_feature)
{
  write("corner.off", corner_off);
  write("values.ply", ply_file(binary, {{"vertex", "float x", "float y", "float z", "float height",
                                         "list uchar float weights", "float nx", "uchar red", "double depth"},
                                        edges,
                                        faces}));
  write("other.ply",
        ply_file("ascii", {{"vertex", "float x", "float y", "float z", "float height", "float width"}, faces}));
  std::string warnings;
  for(const char* what :
      {"values.ply: not compared: the list 'weights' of 'vertex'", "values.ply: not compared: the elements 'edge'",
       "values.ply: not compared: the vertex property 'nx', because normals are not invariant under rotation",
       "values.ply: not compared: the vertex property 'red', whose type is neither float nor double",
       "values.ply: not compared: the face property 'label'",
       "values.ply: not compared: the vertex property 'depth', which is missing in other.ply",
       "other.ply: not compared: the face property 'label'",
       "other.ply: not compared: the vertex property 'width', which is missing in values.ply"})
    warnings += what + std::string("\n");
  expect_success(
      "match corner.off corner.off --features values.ply other.ply -o result.off --method hierarchical --quiet",
      warnings + uncertain);
}

TEST_F(Ply_files, may_have_values_that_are_not_finite_and_undeclared_columns)
{
  const Outcome outcome =
      transfer("ply\nformat ascii 1.0\n\ncomment a\n# b\nelement vertex 4\nproperty float x\nproperty float y\n"
               "property float z\nproperty double height\nelement face 4\n"
               "property list uchar int vertex_indices\nend_header\n"
               "0 0 0 nan 8\n1 0 0 inf\n0 1 0 -INF 9 9\n0 0 1 1\n3 0 2 1\n3 0 1 3 4 5\n# c\n\n3 1 2 3\n3 2 0 3\n");
  EXPECT_EQ(outcome.err, "values.ply: not transferred: what the header does not declare of 'vertex', as in line 14\n"
                         "values.ply: not transferred: what the header does not declare of 'face', as in line 19\n");
  EXPECT_EQ(properties().count("vertex height"), 1u);
}

struct Resampling_program : Program_fixture
{
  Resampling_program()
  {
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
  EXPECT_EQ(expect_success(spheres + "-o lh.barycentric"),
            "Resampled with barycentric weights: 642 to 42 vertices, of which 0 receive no value\n");
  write_curv("lh.areas", std::vector<double>(642, 1.)); // which may be given as values as well
  std::set<std::vector<double>> results;
  for(const auto& [options, tolerance] : {std::pair("-o lh.barycentric --method barycentric", 0.01),
                                          {"-o lh.adaptive --areas fine.off coarse.off", 0.1},
                                          {"-o lh.nearest --method nearest --threads 1", 0.1},
                                          {"-o lh.largest --method largest --areas fine.off coarse.off", 0.1},
                                          {"-o lh.even --areas lh.areas coarse.off", 0.1}})
  {
    expect_success(spheres + options);
    const std::vector<double> values = read_curv(words_of(options)[1]);
    ASSERT_EQ(values.size(), directions.size());
    for(std::size_t v = 0; v < directions.size(); ++v)
      EXPECT_NEAR(values[v], directions[v][2], tolerance) << options;
    EXPECT_TRUE(results.insert(values).second) << options;
  }
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
  std::size_t n = 0, n_empty = 0;
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
  for(std::size_t v = 0; v < directions.size(); ++v)
  {
    EXPECT_EQ(valid[v] == 0., north[v] == 0.);
    EXPECT_GE(north[v], 0.);
    EXPECT_TRUE(valid[v] == 1. || directions[v][2] < 0.);
    n_empty += valid[v] == 0.;
  }
  EXPECT_GT(n_empty, 10u);
  expect_part(text, "of which " + std::to_string(n_empty) + " receive no value");
  // The values are a mask as well.
  expect_success("resample lh.height fine.off coarse.off --mask lh.height -o lh.again");
  EXPECT_EQ(read_curv("lh.again"), north);
#ifdef TEST_GIFTI
  // So are those of a file that leaves out the last vertex, which is in the south.
  SP::IO::Surface_file some;
  some.columns = {{"", "NIFTI_INTENT_SHAPE", SP::IO::Vertex_values::Type::uint8, {}, {}}};
  std::size_t last = points.size();
  while(points[last - 1][2] > 0.)
    --last;
  for(std::size_t v = points.size(); v-- > 0;)
    if(v != last - 1)
    {
      some.vertices.push_back(static_cast<std::uint32_t>(v));
      some.columns[0].values.push_back(points[v][2] > 0.);
    }
  write_by("some.shape.gii", [&](auto& out, auto& message) { return SP::IO::write_GIFTI(out, some, message); });
  expect_success("resample lh.height fine.off coarse.off --mask some.shape.gii -o lh.again");
  EXPECT_EQ(read_curv("lh.again"), north);
  expect_message("resample lh.height fine.off coarse.off --areas some.shape.gii coarse.off --method adaptive -o lh.a",
                 "some.shape.gii: has areas of only some vertices of a surface");
#endif
}

TEST_F(Resampling_program, spheres_are_carried_through_a_registration)
{
  // Through a rotation, it is rotated.
  write_off("turned.off", test_meshes::turned(test_meshes::icosphere(3), 0.5));
  EXPECT_EQ(expect_success("resample coarse.off fine.off turned.off --through -o result.off"),
            "Mapped through the registration: 1 sphere\n");
  expect_near(read_mesh("result.off").points,
              test_meshes::turned(test_meshes::tilted(test_meshes::icosphere(1)), 0.5).points, 1e-14);
  // a registration with inverted faces
  write_off("folded.off", test_meshes::scaled(test_meshes::icosphere(3), 1., 1., -1.));
  const Outcome outcome = run("resample coarse.off fine.off folded.off --through -o result.off");
  EXPECT_EQ(outcome.status, 2);
  expect_part(outcome.err, "result.off: the map is not bijective");
  SP::IO::Surface_file sphere; // with a point that is none
  const test_meshes::Triangle_list fine = test_meshes::icosphere(3);
  sphere.points.assign(fine.points.begin(), fine.points.end());
  for(const auto& t : fine.triangles)
    sphere.triangles.push_back(
        {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  sphere.points[5][1] = NAN;
  write_surface("lh.nan", sphere);
  expect_messages(
      "resample ",
      {{"coarse.off fine.off coarse.off --through -o a.off", "coarse.off: has 42 vertices, but fine.off has 642"},
       {"lh.height fine.off turned.off --through -o a.off", "lh.height: contains vertex values"},
       {"coarse.off fine.off lh.nan --through -o a.off",
        "lh.nan: vertex 5 has a coordinate that is infinite or not a number"},
       {"coarse.off fine.off fine.off --through --valid a -o a.off", "--valid"}});
}

TEST_F(Resampling_program, errors_are_named)
{
  auto folded = test_meshes::icosphere(1);
  for(double& x : folded.points[20])
    x = -x;
  write_off("folded.off", folded);
  write_off("torus.off", test_meshes::torus(20, 30));
  std::vector<double> numbers(642, 0.);
  write_curv("lh.zero", numbers);
  numbers.back() = NAN;
  write_curv("lh.nan", numbers);
  expect_messages("resample lh.height fine.off coarse.off ",
                  {{"", "-o"},
                   {"-o lh.a --output-folder b", "--output-folder"},
                   {"--method bld -o lh.a", "barycentric, adaptive, nearest or largest"},
                   {"--method largest -o lh.a", "--method largest needs --areas"},
                   {"--method nearest --areas fine.off coarse.off -o lh.a", "--areas requires --method"},
                   {"-o lh.height", "lh.height: would replace an input"},
                   {"-o coarse.off", "coarse.off: would replace an input"},
                   {"-o a.off", "a.off: the name of a file of values must end with .gii, .mgh, .mgz or .annot"},
                   {"-o lh.annot", "lh.annot: cannot store values without a table of labels"},
                   {"-o lh.a --valid lh.a", "lh.a: would be written twice"},
                   {"--areas coarse.off fine.off -o lh.a", "coarse.off: has 42 vertices, but fine.off has 642"},
                   {"--areas lh.height coarse.off -o lh.a", "lh.height: the area of vertex "},
                   {"--areas lh.zero coarse.off -o lh.a --method adaptive", "lh.zero: all areas are 0"},
                   {"--mask lh.zero -o lh.a", "lh.zero: is not a mask: no vertex has a positive value"},
                   {"--mask lh.nan -o lh.a", "lh.nan: is not a mask: vertex 641 has a value that is not a number"},
                   {"--mask coarse.off -o lh.a", "coarse.off: is not a mask: it has no vertex values"}});
  expect_messages("resample ",
                  {{"lh.height coarse.off fine.off -o lh.a", "lh.height: has 642 vertices, but coarse.off has 42"},
                   {"fine.off fine.off coarse.off --mask lh.height -o a.off", "omit --mask"},
                   {"lh.height fine.off lh.height -o lh.a", "lh.height: contains vertex values, but no surface"},
                   {"missing fine.off coarse.off -o lh.a", "missing: No such file or directory"},
                   {"lh.height fine.off folded.off -o lh.a", "folded.off: is not a sphere"},
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
  const auto write = [&](auto& out, auto& message) { return SP::IO::write_GIFTI(out, file, message); };
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

  // Labels are not averaged, whatever their type.
  file.columns[0].type = SP::IO::Vertex_values::Type::float32;
  write_by("floats.label.gii", write);
  expect_success("resample floats.label.gii fine.off coarse.off -o again.label.gii");
  EXPECT_EQ(read_by("again.label.gii", SP::IO::read_GIFTI).columns.at(0).values, result.columns[0].values);
  file.columns[0].type = SP::IO::Vertex_values::Type::int32;

  // What a format cannot hold is named.
  SP::IO::Surface_file long_keys = file;
  for(double& x : long_keys.columns[0].values)
    x = x == 3. ? 3. : 16777217.;
  write_by("large.label.gii", [&](auto& out, auto& message) { return SP::IO::write_GIFTI(out, long_keys, message); });
  expect_messages("resample large.label.gii fine.off coarse.off ",
                  {{"-o lh.a", "lh.a: The integer 16777217 of vertex "},
                   {"-o lh.a.annot", "lh.a.annot: A vertex has the label 16777217, which is not in the table"}});
  expect_success("resample large.label.gii fine.off coarse.off -o a.mgh");

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

  // FreeSurfer's annotations have the color 0 there.
  const SP::IO::Surface_file annotation = read_by("lh.north.annot", SP::IO::read_FreeSurfer_annotation);
  EXPECT_EQ(annotation.labels.back().name, "");
  EXPECT_EQ(annotation.labels.back().color, (std::array<double, 4>{0., 0., 0., 1.}));
  // Where 0 is a region, another key is that of nothing.
  file.labels.push_back({0, "middle", {{0., 1., 0., 1.}}});
  write_by("halves.label.gii", write);
  expect_success("resample halves.label.gii fine.off coarse.off --mask lh.height -o north.label.gii");
  const SP::IO::Surface_file with_region = read_by("north.label.gii", SP::IO::read_GIFTI);
  EXPECT_EQ(with_region.labels.back().key, 8);
  for(std::size_t v = 0; v < directions.size(); ++v)
    EXPECT_EQ(with_region.columns[0].values[v], north.columns[0].values[v] == 3. ? 3. : 8.);

  // What FreeSurfer says by the name becomes metadata.
  expect_success("resample lh.height fine.off coarse.off -o height.shape.gii");
  const SP::IO::Surface_file values = read_by("height.shape.gii", SP::IO::read_GIFTI);
  EXPECT_EQ(values.columns.at(0).name, "height");
  EXPECT_EQ(values.origin.metadata, (SP::IO::Metadata{{"AnatomicalStructurePrimary", "CortexLeft"}}));
  file.columns.push_back(file.columns[0]);
  write_by("two.label.gii", write);
  SP::IO::Surface_file both = file;
  both.points.assign(directions.size(), {{1., 2., 3.}});
  both.columns = {{"a", "NIFTI_INTENT_SHAPE", SP::IO::Vertex_values::Type::float32, {}, {}}};
  both.columns[0].values.assign(directions.size(), 1.);
  write_by("both.surf.gii", [&](auto& out, auto& message) { return SP::IO::write_GIFTI(out, both, message); });
  SP::IO::Surface_file wrong = both;
  wrong.columns.clear();
  wrong.points[7][2] = NAN;
  write_by("nan.surf.gii", [&](auto& out, auto& message) { return SP::IO::write_GIFTI(out, wrong, message); });
  expect_messages("resample ", {{"two.label.gii fine.off coarse.off -o lh.a", "lh.a: cannot store 2 columns"},
                                {"two.label.gii fine.off coarse.off -o a.annot", "a.annot: cannot store 2 columns"},
                                {"both.surf.gii coarse.off fine.off -o a.off", "a.off: cannot store the values of"},
                                {"nan.surf.gii coarse.off fine.off -o a.off",
                                 "nan.surf.gii: vertex 7 has a coordinate that is infinite or not a number"},
                                {"lh.height fine.off coarse.off --mask two.label.gii -o lh.a",
                                 "two.label.gii: is not a mask: it has several values"},
                                {"lh.height fine.off coarse.off --mask lh.north.annot -o lh.a",
                                 "lh.north.annot: is an annotation"}});
}
#endif

} // namespace

#endif
