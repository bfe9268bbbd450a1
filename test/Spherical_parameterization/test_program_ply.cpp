// What the command line program does with properties of the vertices and faces of PLY files. How these are read:
// test_files_meshes.cpp.

#include "Program_fixture.h"

// In CGAL's tree the program is not built along with the tests.
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

class Ply_files : public Program_fixture
{
protected:
  void SetUp() override
  {
    Program_fixture::SetUp();
    write("corner.off", corner_off);
    std::map<std::string, Numbers> not_finite = usual_numbers;
    not_finite["height"][3] = {NAN};
    write("nan.ply", ply_file("ascii", {vertices, faces}, not_finite));
  }

  // reads a surface with its properties, also as features, which ends with the second file
  Outcome carry(const std::string& text)
  {
    write("values.ply", text);
    expect_message("match corner.off corner.off --method hierarchical --features values.ply nan.ply",
                   "nan.ply: the property height of vertex 3 is infinite or not a number");
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
    std::string of_vertices, of_faces, left_out_of_vertices, left_out_of_faces;
    std::multiset<std::string> written;
  };
  std::vector<Row> table = {
      {"float red,float green,float blue", "", "", "", {"vertex red", "vertex green", "vertex blue"}},
      {"uchar red,uchar green,uchar blue",
       "uchar red,uchar green,uchar blue,uchar alpha",
       "",
       "",
       {"vertex red", "vertex green", "vertex blue", "vertex alpha", "face red", "face green", "face blue",
        "face alpha"}},
      {"uchar red,uchar green,uchar blue,float alpha,int color",
       "",
       "alpha color",
       "",
       {"vertex red", "vertex green", "vertex blue", "vertex alpha"}},
      {"uchar red,int color", "float alpha", "", "", {"vertex red", "vertex color", "face alpha"}},
      {"float nx,float ny,float nz", "", "", "", {}},
      {"float nx", "float nx", "nx", "", {"face nx"}},
      {"double sphere,int initial", "", "", "", {"vertex sphere", "vertex initial"}},
      {"double point,float normal,uchar removed,int connectivity",
       "int vertex_index,uchar removed,int connectivity,float point",
       "point normal removed connectivity",
       "vertex_index removed connectivity",
       {"face point"}}};
  for(const std::string type : {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"})
    table.push_back({type + " new", type + " new", "", "", {"vertex new", "face new"}});
  std::map<std::string, Numbers> numbers = usual_numbers;
  numbers.erase("vertex_index");
  const std::string format = "binary_little_endian";
  {
    for(const Row& row : table)
    {
      const std::string file = ply_file(format, {with(row.of_vertices, vertices), with(row.of_faces, faces)}, numbers);
      SCOPED_TRACE(file.substr(0, file.find("end_header")));
      const Outcome outcome = carry(file);
      EXPECT_EQ(outcome.status, 0);
      std::string warnings;
      for(const auto& [names, elements] :
          Messages{{row.left_out_of_vertices, "vertices"}, {row.left_out_of_faces, "faces"}})
        for(const std::string& name : words_of(names))
          warnings += "values.ply: not carried over: the property '" + name + "' of the " + elements +
                      ", whose name is taken\n";
      EXPECT_EQ(outcome.err, warnings);
      std::multiset<std::string> expected = row.written;
      expected.insert({"vertex x", "vertex y", "vertex z", "vertex nx", "vertex ny", "vertex nz", "vertex height",
                       "face vertex_indices", "face label"});
      EXPECT_EQ(properties(), expected);
    }
    EXPECT_EQ(
        carry(ply_file(format, {with("list uchar float weights", vertices), with("list int uchar weights", faces)}))
            .err,
        "values.ply: not carried over: the list 'weights' of 'vertex'\n"
        "values.ply: not carried over: the list 'weights' of 'face'\n");
  }
  numbers["blue"] = Numbers(4, {255});
  EXPECT_EQ(carry(ply_file("ascii",
                           {vertices,
                            {"face", "list uchar int vertex_indices", "uchar alpha", "uchar blue", "uchar green",
                             "uchar red"}},
                           numbers))
                .status,
            0);
  const std::string result = content(path("result.ply"));
  EXPECT_EQ(result.substr(result.size() - 4, 3), "\x04\x04\xff"); // red, green, blue, alpha
}

TEST_F(Ply_files, tell_what_is_no_feature)
{
  write("values.ply",
        ply_file("binary_little_endian", {{"vertex", "float x", "float y", "float z", "float height",
                                           "list uchar float weights", "float nx", "uchar red", "double depth"},
                                          edges,
                                          faces}));
  write("other.ply",
        ply_file("ascii", {{"vertex", "float x", "float y", "float z", "float height", "float width"}, faces}));
  std::string warnings;
  for(const char* what :
      {"values.ply: not compared: the list 'weights' of 'vertex'", "values.ply: not compared: the elements 'edge'",
       "values.ply: not compared: the property 'nx' of the vertices, as normals turn with the surface",
       "values.ply: not compared: the property 'red' of the vertices, whose type is neither float nor double",
       "values.ply: not compared: the property 'label' of the faces",
       "values.ply: not compared: the property 'depth' of the vertices, which other.ply has not",
       "other.ply: not compared: the property 'label' of the faces",
       "other.ply: not compared: the property 'width' of the vertices, which values.ply has not"})
    warnings += what + std::string("\n");
  expect_success(
      "match corner.off corner.off --features values.ply other.ply -o result.off --method hierarchical --quiet",
      warnings + uncertain);
}

TEST_F(Ply_files, may_have_values_that_are_not_finite_and_undeclared_columns)
{
  const std::string file =
      "ply\nformat ascii 1.0\n\ncomment a\n# b\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nproperty double height\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0 nan 8\n1 0 0 inf\n0 1 0 -INF 9 9\n0 0 1 1\n3 0 2 1\n3 0 1 3 4 5\n# c\n\n3 1 2 3\n3 2 0 3\n";
  write("values.ply", file);
  expect_success("remesh values.ply cube=1 --transfer values.ply -o result.ply --quiet",
                 "values.ply: not carried over: what the header does not declare of 'vertex', as in line 14\n"
                 "values.ply: not carried over: what the header does not declare of 'face', as in line 19\n");
  EXPECT_EQ(properties().count("vertex height"), 1u);
}

} // namespace

#endif
