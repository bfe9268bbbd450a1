// PLY files whose properties the command line program is to carry over: all types, orders and formats, and what is wrong
// with some of them.

#include "Binary_file.h"
#include "Program_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// In CGAL's tree the examples are not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

struct Ply_property
{
  std::string type, name;                   // the type of a list is that of the statement, such as "list uchar int"
  std::vector<std::vector<double>> numbers; // of each vertex, say
};

struct Ply_element
{
  std::string name;
  std::vector<Ply_property> properties;
};

std::string ply_file(const std::string& format, const std::vector<Ply_element>& elements)
{
  const bool is_text = format == "ascii";
  std::string header = "ply\nformat " + format + " 1.0\n";
  Binary_file body(format == "binary_big_endian");
  const auto put = [&](const std::string& type, double x) {
    std::ostringstream text;
    text << x << ' ';
    if(is_text)
      body << text.str();
    else if(type == "double")
      body << x;
    else if(type == "float")
      body << static_cast<float>(x);
    else if(type == "int" || type == "uint")
      body << static_cast<std::uint32_t>(x);
    else if(type == "short" || type == "ushort")
      body << static_cast<std::int16_t>(x);
    else
      body << static_cast<std::uint8_t>(x);
  };
  for(const Ply_element& element : elements)
  {
    const std::size_t n = element.properties.front().numbers.size();
    header += "element " + element.name + ' ' + std::to_string(n) + '\n';
    for(const Ply_property& p : element.properties)
      header += "property " + p.type + ' ' + p.name + '\n';
    for(std::size_t i = 0; i < n; ++i)
    {
      for(const Ply_property& p : element.properties)
      {
        std::istringstream words(p.type);
        std::string type;
        words >> type;
        if(type == "list")
        {
          words >> type;
          put(type, static_cast<double>(p.numbers[i].size()));
          words >> type;
        }
        for(const double x : p.numbers[i])
          put(type, x);
      }
      if(is_text)
        body << std::string("\n");
    }
  }
  return header + "end_header\n" + body.content;
}

// the vertices, edges or faces of a tetrahedron
Ply_element vertices(const std::vector<std::string>& types = {"float", "float", "float"})
{
  return {"vertex",
          {{types[0], "x", {{0}, {1}, {0}, {0}}},
           {types[1], "y", {{0}, {0}, {1}, {0}}},
           {types[2], "z", {{0}, {0}, {0}, {1}}},
           {"float", "height", {{0.5}, {-2}, {7}, {1e30}}}}};
}

Ply_element edges()
{
  return {"edge", {{"int", "vertex1", {{0}, {1}, {9}}}, {"int", "vertex2", {{1}, {2}, {7}}}}};
}

Ply_element faces(const std::string& type = "list uchar int", const std::string& name = "vertex_indices")
{
  return {"face",
          {{type, name, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}, {"ushort", "label", {{7}, {7}, {7}, {9}}}}};
}

const std::vector<std::string> formats = {"ascii", "binary_little_endian", "binary_big_endian"};

class Ply_files : public Program_fixture
{
protected:
  void SetUp() override
  {
    Program_fixture::SetUp();
    write("corner.off", corner_off);
    Ply_element not_finite = vertices();
    not_finite.properties[3].numbers[3] = {NAN};
    write("nan.ply", ply_file("ascii", {not_finite, faces()}));
  }

  // carries the properties of a file over, and reads it for features, which ends with the second file
  Outcome carry(const std::string& text)
  {
    write("values.ply", text);
    expect_message("corner.off --onto corner.off --method hierarchical --features values.ply nan.ply",
                   "nan.ply: the property height of vertex 3 is infinite or not a number");
    return run("corner.off --method stereographic --remesh octahedron=2 --transfer values.ply -o result.ply --quiet");
  }

  void expect_refused(const std::string& text, const std::string& message)
  {
    SCOPED_TRACE(text);
    write("values.ply", text);
    for(const char* arguments : {"--remesh octahedron=2 --transfer values.ply -o result.ply",
                                 "--onto corner.off --features values.ply values.ply"})
      expect_message("corner.off --method hierarchical " + std::string(arguments), "values.ply: " + message);
  }

  // the properties of the result, as in its header
  std::multiset<std::string> properties() const
  {
    std::istringstream header(content(path("result.ply")));
    std::multiset<std::string> result;
    std::string element;
    for(std::string line; std::getline(header, line) && line != "end_header";)
    {
      std::istringstream words(line);
      std::string statement, name;
      words >> statement;
      if(statement == "element")
        words >> element;
      else if(statement == "property")
        while(words >> name)
          ;
      if(!name.empty())
        result.insert(element + ' ' + name);
    }
    return result;
  }
};

TEST_F(Ply_files, are_read_whatever_their_types_and_order_are)
{
  const std::vector<std::string> types = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  std::vector<std::pair<Ply_element, Ply_element>> variants; // of vertices and faces
  for(const std::string& type : types)
    variants.emplace_back(vertices({type, type, type}), faces());
  variants.emplace_back(vertices({"float", "double", "float"}), faces());
  variants.emplace_back(vertices({"double", "double", "float"}), faces());
  variants.emplace_back(vertices({"int", "float", "double"}), faces());
  variants.emplace_back(vertices({"uchar", "short", "double"}), faces());
  for(std::size_t k = 0; k < 6; ++k)
    variants.emplace_back(vertices(), faces("list uchar " + types[k], "vertex_index"));
  variants.emplace_back(vertices(), faces("list short uint"));
  variants.emplace_back(vertices(), faces("list int char"));
  std::string expected;
  for(const std::string& format : formats)
    for(const auto& [v, f] : variants)
      for(const std::vector<Ply_element>& elements :
          {std::vector{v, f}, std::vector{f, v}, std::vector{edges(), v, f}, std::vector{v, edges(), f}})
      {
        const std::string file = ply_file(format, elements);
        SCOPED_TRACE(file.substr(0, file.find("end_header")));
        const Outcome outcome = carry(file);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.err, elements.size() == 2 ? "" : "values.ply: not carried over: the elements 'edge'\n");
        const std::string result = content(path("result.ply"));
        EXPECT_GT(result.size(), 1000u);
        expected = expected.empty() ? result : expected;
        EXPECT_TRUE(result == expected);
        std::filesystem::remove(path("result.ply"));
      }
}

TEST_F(Ply_files, keep_the_properties_that_have_a_name_of_their_own)
{
  const std::multiset<std::string> usual = {"vertex x",  "vertex y",  "vertex z",      "vertex nx",
                                            "vertex ny", "vertex nz", "vertex height", "face vertex_indices",
                                            "face label"};
  // more properties, what is said of them, and which are written
  struct Row
  {
    std::vector<Ply_property> of_vertices, of_faces;
    std::vector<std::string> left_out, written;
  };
  const std::vector<std::vector<double>> n = {{1}, {2}, {3}, {4}};
  const std::string of_vertices = "' of the vertices, whose name is taken",
                    of_faces = "' of the faces, whose name is taken";
  std::vector<Row> table = {
      {{{"float", "red", n}, {"float", "green", n}, {"float", "blue", n}},
       {},
       {},
       {"vertex red", "vertex green", "vertex blue"}},
      {{{"uchar", "red", n}, {"uchar", "green", n}, {"uchar", "blue", n}},
       {{"uchar", "red", n}, {"uchar", "green", n}, {"uchar", "blue", n}, {"uchar", "alpha", n}},
       {},
       {"vertex red", "vertex green", "vertex blue", "vertex alpha", "face red", "face green", "face blue",
        "face alpha"}},
      {{{"uchar", "red", n}, {"uchar", "green", n}, {"uchar", "blue", n}, {"float", "alpha", n}, {"int", "color", n}},
       {},
       {"the property 'alpha" + of_vertices, "the property 'color" + of_vertices},
       {"vertex red", "vertex green", "vertex blue", "vertex alpha"}},
      {{{"uchar", "red", n}, {"int", "color", n}},
       {{"float", "alpha", n}},
       {},
       {"vertex red", "vertex color", "face alpha"}},
      {{{"float", "nx", n}, {"float", "ny", n}, {"float", "nz", n}}, {}, {}, {}},
      {{{"float", "nx", n}}, {{"float", "nx", n}}, {"the property 'nx" + of_vertices}, {"face nx"}},
      {{{"double", "sphere", n}, {"int", "initial", n}}, {}, {}, {"vertex sphere", "vertex initial"}},
      {{{"double", "point", n}, {"float", "normal", n}, {"uchar", "removed", n}, {"int", "connectivity", n}},
       {{"int", "vertex_index", n}, {"uchar", "removed", n}, {"int", "connectivity", n}, {"float", "point", n}},
       {"the property 'point" + of_vertices, "the property 'normal" + of_vertices,
        "the property 'removed" + of_vertices, "the property 'connectivity" + of_vertices,
        "the property 'vertex_index" + of_faces, "the property 'removed" + of_faces,
        "the property 'connectivity" + of_faces},
       {"face point"}},
      {{{"list uchar float", "weights", {{1, 2}, {}, {3}, {4, 5, 6}}}},
       {{"list int uchar", "texture", {{1, 2}, {}, {3}, {4, 5, 6}}}},
       {"the list 'weights' of 'vertex'", "the list 'texture' of 'face'"},
       {}}};
  for(const char* type : {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"})
    table.push_back({{{type, "new", n}}, {{type, "new", n}}, {}, {"vertex new", "face new"}});
  for(const std::string& format : formats)
    for(const Row& row : table)
    {
      Ply_element v = vertices(), f = faces();
      v.properties.insert(v.properties.begin(), row.of_vertices.begin(), row.of_vertices.end());
      f.properties.insert(f.properties.begin(), row.of_faces.begin(), row.of_faces.end());
      const std::string file = ply_file(format, {v, f});
      SCOPED_TRACE(file.substr(0, file.find("end_header")));
      const Outcome outcome = carry(file);
      EXPECT_EQ(outcome.status, 0);
      std::string warnings;
      for(const std::string& what : row.left_out)
        warnings += "values.ply: not carried over: " + what + '\n';
      EXPECT_EQ(outcome.err, warnings);
      std::multiset<std::string> expected = usual;
      expected.insert(row.written.begin(), row.written.end());
      EXPECT_EQ(properties(), expected);
    }

  const auto everywhere = [](double x) { return std::vector<std::vector<double>>(4, {x}); };
  Ply_element f = faces();
  f.properties = {f.properties[0],
                  {"uchar", "alpha", everywhere(4)},
                  {"uchar", "blue", everywhere(3)},
                  {"uchar", "green", everywhere(255)},
                  {"uchar", "red", everywhere(1)}};
  EXPECT_EQ(carry(ply_file("ascii", {vertices(), f})).status, 0);
  const std::string result = content(path("result.ply"));
  EXPECT_EQ(result.substr(result.size() - 4), "\x01\xff\x03\x04");
}

TEST_F(Ply_files, tell_what_is_no_feature)
{
  const std::vector<std::vector<double>> n(4, {3});
  Ply_element v = vertices(), f = faces();
  v.properties.insert(
      v.properties.end(),
      {{"list uchar float", "weights", n}, {"float", "nx", n}, {"uchar", "red", n}, {"double", "depth", n}});
  write("values.ply", ply_file("binary_little_endian", {v, edges(), faces()}));
  v = vertices();
  v.properties.push_back({"float", "width", n});
  write("other.ply", ply_file("ascii", {v, faces()}));
  const Outcome outcome =
      run("corner.off --onto corner.off --features values.ply other.ply -o result.off --method hierarchical --quiet");
  EXPECT_EQ(outcome.status, 0);
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
  EXPECT_EQ(outcome.err, warnings + uncertain);
}

TEST_F(Ply_files, are_refused_with_the_place_and_the_reason)
{
  for(const std::string& format : formats)
  {
    Ply_element v = vertices();
    v.properties.push_back(v.properties[3]);
    expect_refused(ply_file(format, {v, faces()}), "line 8: the same property once more");
    expect_refused(ply_file(format, {vertices(), vertices(), faces()}), "line 8: the vertices once more");
    Ply_element f = faces("list uchar uchar");
    f.properties[0].numbers[2] = {1, 2, 4};
    const std::string header = ply_file(format, {vertices(), f}), end = "end_header\n";
    const std::size_t byte = header.find(end) + end.size() + 4 * 16 + 2 * 6 + 3;
    expect_refused(header, (format == "ascii" ? "line 18" : "byte " + std::to_string(byte)) +
                               ": 'face' 2 has a corner that does not exist: there are 4 vertices");
  }
  const std::string
      head = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n",
      rest = "element face 4\nproperty list uchar int vertex_indices\nend_header\n",
      corners = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const auto with = [&](const std::string& property, const std::string& number) {
    return head + property + rest + "0 0 0 1\n1 0 0 " + number + "\n0 1 0 3\n0 0 1 4\n" + corners;
  };
  expect_refused(with("property uchar a\n", "256"),
                 "line 12: a number of 'vertex' 1 is not in the range of its type: 256");
  expect_refused(with("property char a\n", "-129"),
                 "line 12: a number of 'vertex' 1 is not in the range of its type: -129");
  expect_refused(with("property int a\n", "nan"),
                 "line 12: a number of 'vertex' 1 should be a whole number, not 'nan'");
  expect_refused(with("property float a\n", "1e39"),
                 "line 12: a number of 'vertex' 1 is not in the range of its type: 1e+39");
  expect_refused(with("property double a\n", "-1e309"),
                 "line 12: a number of 'vertex' 1 is too large, beyond 1.8e308: '-1e309'");
  expect_refused(with("property float a\n", ""), "line 12: a number of 'vertex' 1 is missing");
  expect_refused(with("property float a\n", "2\ncomment here"),
                 "line 13: a number of 'vertex' 2 is not a number: 'comment'");
  expect_refused(with("property float\n", "2"), "line 7: a property without name");
  expect_refused(with("propertyfloat a\n", "2"),
                 "line 7: no line in the header of a PLY file begins with 'propertyfloat'");
  std::string many;
  for(int k = 0; k <= 4096; ++k)
    many += "property float p" + std::to_string(k) + '\n';
  expect_refused(with(many, "2"), "line 4100: there are more than 4096 properties of 'vertex'");
  // elements that take no bytes, however many there are
  write("values.ply", with("property float height\n", "2\n\n# a comment\n")
                          .insert(head.find("element"), "comment one\n\nelement foo 4000000000000000000\n"));
  EXPECT_EQ(run("corner.off --remesh cube=1 --transfer values.ply -o result.ply --quiet").err,
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
  const Outcome outcome = run("corner.off --remesh cube=1 --transfer values.ply -o result.ply --quiet");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "values.ply: not carried over: what the header does not declare of 'vertex', as in line 14\n"
                         "values.ply: not carried over: what the header does not declare of 'face', as in line 19\n");
  EXPECT_EQ(properties().count("vertex height"), 1u);
}

} // namespace

#endif
