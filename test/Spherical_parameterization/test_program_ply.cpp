// PLY files as the command line program reads them, surfaces and properties of their vertices and faces: all types, orders and
// formats, and what is wrong with some of them.

#include "Program_fixture.h"

// In CGAL's tree the program is not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

using Numbers = std::vector<std::vector<double>>; // of each vertex, say
using Ply_element = std::vector<std::string>; // its name and its properties, such as "list uchar int vertex_indices"

// a tetrahedron
const std::map<std::string, Numbers> usual_numbers = {{"x", {{0}, {1}, {0}, {0}}},
                                                      {"y", {{0}, {0}, {1}, {0}}},
                                                      {"z", {{0}, {0}, {0}, {1}}},
                                                      {"height", {{0.5}, {-2}, {7}, {1e30}}},
                                                      {"vertex1", {{0}, {1}, {9}}},
                                                      {"vertex2", {{1}, {2}, {7}}},
                                                      {"vertex_indices", {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
                                                      {"vertex_index", {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
                                                      {"label", {{7}, {7}, {7}, {9}}},
                                                      {"weights", {{1, 2}, {}, {3}, {4, 5, 6}}}};

const Ply_element vertices = {"vertex", "float x", "float y", "float z", "float height"},
                  edges = {"edge", "int vertex1", "int vertex2"},
                  faces = {"face", "list uchar int vertex_indices", "ushort label"};

// numbers of properties of other names are 1, 2, 3, 4
std::string ply_file(const std::string& format, const std::vector<Ply_element>& elements,
                     std::map<std::string, Numbers> numbers = usual_numbers)
{
  std::string header = "ply\nformat " + format + " 1.0\n";
  Binary_file body(format == "binary_big_endian");
  const auto put = [&](const std::string& type, double x) {
    std::ostringstream text;
    text << x << ' ';
    if(format == "ascii")
      body << text.str();
    else if(type == "double" || type == "float64")
      body << x;
    else if(type.substr(0, 5) == "float")
      body << static_cast<float>(x);
    else if(type == "int" || type == "uint" || type == "int32")
      body << static_cast<std::uint32_t>(x);
    else if(type == "short" || type == "ushort" || type == "uint16")
      body << static_cast<std::int16_t>(x);
    else
      body << static_cast<std::uint8_t>(x);
  };
  for(const Ply_element& element : elements)
  {
    const std::size_t n = element[0] == "edge" ? 3 : 4;
    header += "element " + element[0] + ' ' + std::to_string(n) + '\n';
    for(std::size_t k = 1; k < element.size(); ++k)
      header += "property " + element[k] + '\n';
    for(std::size_t i = 0; i < n; ++i)
    {
      for(std::size_t k = 1; k < element.size(); ++k)
      {
        const std::vector<std::string> words = words_of(element[k]);
        const Numbers& x = numbers.emplace(words.back(), Numbers{{1}, {2}, {3}, {4}}).first->second;
        if(words[0] == "list")
          put(words[1], static_cast<double>(x[i].size()));
        for(const double y : x[i])
          put(words[words.size() - 2], y);
      }
      body << std::string(format == "ascii" ? "\n" : "");
    }
  }
  return header + "end_header\n" + body.content;
}

// an element with more properties, which have commas between them, before its own ones
Ply_element with(const std::string& more, Ply_element element)
{
  std::istringstream in(more);
  std::size_t k = 1;
  for(std::string property; std::getline(in >> std::ws, property, ',');)
    element.insert(element.begin() + static_cast<std::ptrdiff_t>(k++), property);
  return element;
}

const std::vector<std::string> formats = {"ascii", "binary_little_endian", "binary_big_endian"};

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

  void expect_refused(const std::string& text, const std::string& message, bool is_of_surface = true)
  {
    SCOPED_TRACE(text);
    write("values.ply", text);
    if(is_of_surface)
      expect_message("values.ply -o result.off", message);
    expect_messages("", {{"remesh corner.off cube=2 --transfer values.ply -o result.ply", message},
                         {"match corner.off corner.off --features values.ply values.ply", message}});
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

TEST_F(Ply_files, are_read_whatever_their_types_and_order_are)
{
  std::vector<std::vector<Ply_element>> variants = {
      {faces, vertices}, {edges, vertices, faces}, {vertices, edges, faces}};
  for(const char* types :
      {"char char char", "uchar uchar uchar", "short short short", "ushort ushort ushort", "int int int",
       "uint uint uint", "float float float", "double double double", "int8 uint16 int32", "float64 float32 float64",
       "float double float", "double double float", "int float double", "uchar short double"})
  {
    const std::vector<std::string> t = words_of(types);
    variants.push_back({{"vertex", t[0] + " x", t[1] + " y", t[2] + " z", "float height"}, faces});
  }
  for(const char* type :
      {"uchar char", "uchar uchar", "uchar short", "uchar ushort", "uchar int", "uchar uint", "short uint", "int char"})
    variants.push_back({vertices, {"face", std::string("list ") + type + " vertex_index", "ushort label"}});
  expect_success("remesh corner.off octahedron=2 --method stereographic -o plain.ply --quiet");
  std::string expected;
  for(const std::string& format : formats)
    for(const std::vector<Ply_element>& elements : variants)
    {
      const std::string file = ply_file(format, elements);
      SCOPED_TRACE(file.substr(0, file.find("end_header")));
      const Outcome outcome = carry(file);
      EXPECT_EQ(outcome.status, 0);
      EXPECT_EQ(outcome.err, elements.size() == 2 ? "" : "values.ply: not carried over: the elements 'edge'\n");
      const std::string result = content(path("result.ply"));
      expected = expected.empty() ? result : expected;
      EXPECT_TRUE(result == expected);
      fs::remove(path("result.ply"));
    }
  write("result.ply", expected);
  EXPECT_EQ(read_mesh("result.ply").points, read_mesh("plain.ply").points);
}

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
  for(const std::string& format : formats)
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

TEST_F(Ply_files, are_refused_with_the_place_and_the_reason)
{
  for(const std::string& format : formats)
  {
    expect_refused(ply_file(format, {with("float height", vertices), faces}), "line 8: the same property once more",
                   false);
    expect_refused(ply_file(format, {vertices, vertices, faces}), "line 8: the vertices once more");
    std::map<std::string, Numbers> numbers = usual_numbers;
    numbers["vertex_indices"][2] = {1, 2, 4};
    const std::string file = ply_file(format, {vertices, {"face", "list uchar uchar vertex_indices", "ushort label"}},
                                      numbers),
                      end = "end_header\n";
    const std::size_t byte = file.find(end) + end.size() + 4 * 16 + 2 * 6 + 3;
    expect_refused(file, (format == "ascii" ? "line 18" : "byte " + std::to_string(byte)) +
                             ": 'face' 2 has a corner that does not exist: there are 4 vertices");
  }
  const std::size_t faces_of_header = corner_ply.find("element face");
  const auto with_row = [&](const std::string& property, const std::string& number) { // of the vertex 1, say
    std::string text = replaced(corner_ply, "1 0 0\n", "1 0 0 " + number + '\n');
    for(const char* row : {"\n0 0 0", "\n0 1 0", "\n0 0 1"})
      text = replaced(text, row, row + std::string(" 3"));
    return text.insert(faces_of_header, property);
  };
  const std::string huge = std::to_string(1ull << 60);
  const std::string little =
      ply_file("binary_little_endian", {vertices, {"face", "list uchar uint vertex_indices", "ushort label"}});
  std::string many;
  for(int k = 0; k <= 4096; ++k)
    many += "property float p" + std::to_string(k) + '\n';
  const Messages table = {
      {corner_off, "line 1: a PLY file begins with ply, not with 'OFF'"},
      {replaced(corner_ply, "ascii", "text"), "line 2: the format is ascii, binary_little_endian or"},
      {replaced(corner_ply, "format", "comment"), "the header has no line that begins with format"},
      {corner_ply.substr(0, 38), "the file ends within its header"},
      {replaced(corner_ply, "vertex 4", "vertex " + huge), "too short for " + huge + " 'vertex' elements"},
      {replaced(corner_ply, "face 4", "face 5"), "ends in 'face' 4 of 5"},
      {replaced(corner_ply, "face 4", "face -4"), "line 7: the number of 'face' elements is negative"},
      {replaced(corner_ply, "float x", "list uchar float x"), "no properties x, y and z that are numbers"},
      {"ply\nformat ascii 1.0\nelement vertex " + huge + "\nend_header\n", "no properties x, y and z"},
      {replaced(corner_ply, "float y", "float x"), "line 5: the same property once more"},
      {replaced(corner_ply, "float x", "real x"), "line 4: the type of a property is unknown: 'real'"},
      {replaced(corner_ply, "uchar int", "uchar float"), "line 8: the corners of a face have to be whole"},
      {replaced(corner_ply, "uchar int", "float int"), "line 8: the size of a list has to be a whole number"},
      {replaced(corner_ply, "vertex_indices", "indices"), "no property vertex_indices that is a list"},
      {replaced(corner_ply, "3 0 2 1", "3 0 2"), "line 14: a number of 'face' 0 is missing"},
      {replaced(corner_ply, "3 0 2 1", "-3 0 2 1"), "'face' 0 has a list of negative length"},
      {replaced(corner_ply, "3 0 2 1", "3 0 2 -1"), "'face' 0 has a corner that does not exist"},
      {replaced(corner_ply, "1 0 0", "1 0.x 0"), "line 11: a number of 'vertex' 1 is not a number"},
      {little.substr(0, little.size() - 1), "ends in 'face' 3 of 4"},
      {replaced(little, "vertex 4", "vertex " + huge), "too short for " + huge + " 'vertex' elements"},
      {replaced(little, "list uchar uint", "list uint uint"), "'face' 0"},
      {with_row("property uchar a\n", "256"), "line 12: a number of 'vertex' 1 is not in the range of its type: 256"},
      {with_row("property char a\n", "-129"), "line 12: a number of 'vertex' 1 is not in the range of its type: -129"},
      {with_row("property int a\n", "nan"), "line 12: a number of 'vertex' 1 should be a whole number, not 'nan'"},
      {with_row("property float a\n", "1e39"),
       "line 12: a number of 'vertex' 1 is not in the range of its type: 1e+39"},
      {with_row("property double a\n", "-1e309"),
       "line 12: a number of 'vertex' 1 is too large, beyond 1.8e308: '-1e309'"},
      {with_row("property float a\n", ""), "line 12: a number of 'vertex' 1 is missing"},
      {with_row("property float a\n", "2\ncomment here"), "line 13: a number of 'vertex' 2 is not a number: 'comment'"},
      {with_row("property float\n", "2"), "line 7: a property without name"},
      {with_row("propertyfloat a\n", "2"), "line 7: no line in the header of a PLY file begins with 'propertyfloat'"},
      {with_row(many, "2"), "line 4100: there are more than 4096 properties of 'vertex'"}};
  for(const auto& [text, message] : table)
    expect_refused(text, message);
  // elements that take no bytes, however many there are
  write("values.ply", with_row("property float height\n", "2\n\n# a comment\n")
                          .insert(corner_ply.find("element"), "comment one\n\nelement foo 4000000000000000000\n"));
  expect_success("remesh values.ply cube=1 --transfer values.ply -o result.ply --quiet",
                 "values.ply: not carried over: the elements 'foo'\n");
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
