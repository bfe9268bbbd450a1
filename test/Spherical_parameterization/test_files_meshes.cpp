// Mesh files: all variants of a format are read alike; and what is wrong with one, and where.

#include "locale_of_commas.h"
#include "mesh_texts.h"
#include "test_meshes.h"

#include <CGAL/Spherical_parameterization/internal/files/read_mesh_file.h>

#include <gtest/gtest.h>

#include <cctype>
#include <cerrno>

namespace {

namespace SP = CGAL::Spherical_parameterization;

const test_meshes::Triangle_list corner = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

std::string binary_stl(const std::string& title, std::uint32_t number_of_facets, float first_coordinate = 0.f)
{
  Binary_file file(false);
  file << title + std::string(80 - title.size(), '\0') << number_of_facets;
  for(const test_meshes::Triangle& t : corner.triangles)
  {
    file << 0.f << 0.f << 0.f;
    for(const std::size_t v : t)
    {
      const test_meshes::Coordinates p = corner.points[v];
      file << (v == 0 ? first_coordinate : static_cast<float>(p[0])) << static_cast<float>(p[1])
           << static_cast<float>(p[2]);
    }
    file << std::int16_t(0);
  }
  return file.content;
}

std::string in_capitals(std::string text)
{
  for(char& c : text)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

const std::vector<std::string> ply_formats = {"ascii", "binary_little_endian", "binary_big_endian"};

const std::string corner_ts =
    "GOCAD TSurf 1\nHEADER {\nname:corner\n}\nTFACE\nVRTX 0 0 0 0\nVRTX 1 1 0 0\nVRTX 2 0 1 0\n"
    "VRTX 3 0 0 1\nTRGL 0 2 1\nTRGL 0 1 3\nTRGL 1 2 3\nTRGL 2 0 3\nEND\n";

void expect_same_mesh(const std::string& format, const std::string& text, const SP::internal::Polygon_soup& expected)
{
  SCOPED_TRACE(text);
  const SP::internal::Polygon_soup soup = SP::internal::read_mesh_file(format, text);
  EXPECT_EQ(soup.points, expected.points);
  EXPECT_EQ(soup.polygons, expected.polygons);
}

// also of a file whose values are kept
void expect_damaged(const std::string& format, const std::string& text, const std::string& part_of_message,
                    bool is_of_surface = true)
{
  for(const bool keeps_values : {false, true})
    if(keeps_values || is_of_surface)
      try
      {
        SP::internal::read_mesh_file(format, text, keeps_values);
        ADD_FAILURE() << text << "\nis read, although: " << part_of_message;
      }
      catch(const SP::internal::File_error& error)
      {
        EXPECT_NE(std::string(error.what()).find(part_of_message), std::string::npos)
            << error.what() << "\nhas not: " << part_of_message << "\nof\n"
            << text;
      }
}

TEST(Mesh_file, is_read_alike_in_every_format)
{
  const SP::internal::Polygon_soup expected = SP::internal::read_mesh_file(".off", corner_off);
  ASSERT_EQ(expected.points.size(), 4u);
  EXPECT_EQ(expected.points[1], (CGAL::Simple_cartesian<double>::Point_3(1, 0, 0)));
  ASSERT_EQ(expected.polygons.size(), 4u);
  EXPECT_EQ(expected.polygons[0], (SP::internal::Polygon{0, 2, 1}));
  const std::string homogeneous = "4 4 6\n0 0 0 2\n2 0 0 2\n0 0.5 0 0.5\n0 0 -1 -1\n", faces = corner_off.substr(34);
  const std::vector<std::pair<const char*, std::string>> table = {
      {".off", "OFF 4 4" + corner_off.substr(7)},
      {".off", "# a comment\n\n" + replaced(corner_off, "\n", " # another\r\n\r\n")},
      {".off", replaced(corner_off, "\n", "\r")}, // as Macs once wrote
      {".off", "\xEF\xBB\xBF" + corner_off + "\n# and more\n\n"},
      {".off", "4OFF\n" + homogeneous + faces},
      {".off", "nOFF\n3\n" + corner_off.substr(4)},
      {".off", "C4nOFF 3\n" + replaced(homogeneous, "2\n", "2 0.5 0.5 0.5 1\n") + faces},
      {".obj", corner_obj},
      {".obj", "mtllib a.mtl\no a\ng b\nvn 0 0 1\n" + replaced(corner_obj, "\n", " \r\n") + "l 1 2\n"},
      {".obj", replaced(corner_obj, " ", "\t")},
      {".obj", replaced(replaced(corner_obj, "f 1 3 2", "f 1 3 \\\n2"), "f 1 2 4", "f 1 \\\r\n\\\r\n2 4")},
      {".obj", replaced(corner_obj, "f 1 3 2", "f 1/1/1 -2//7 2/5")},
      {".obj", corner_obj.substr(32) + corner_obj.substr(0, 32)},
      {".ts", corner_ts},
      {".ts", replaced(replaced(corner_ts, "\n", "\r\n"), "VRTX", "PVRTX")},
      {".ts", replaced(replaced(corner_ts, "VRTX 3", "VRTX -7"), " 3\n", " -7\n")},
      {".ts", replaced(replaced(corner_ts, "TRGL 0 2 1", "ATOM 9 2\nTRGL 0 9 1"), "END\n", "END")},
      {".ply", corner_ply},
      {".ply", replaced(corner_ply, "\n", "\r\n")},
      {".ply", replaced(corner_ply, "\n", "\r")},
      {".ply", replaced(corner_ply.substr(0, corner_ply.find("3 0 2 1")), "element face 4", "element tristrips 2") +
                   "7 0 2 1 -1 0 1 3\n7 1 2 3 -1 2 0 3\n"},
      {".ply", replaced(replaced(corner_ply, "float", "int8"), "vertex_indices", "vertex_index")}};
  for(const auto& [format, text] : table)
    expect_same_mesh(format, text, expected);

  // every second triangle of a strip is oriented the other way round, and those with repeated corners are none
  const std::string header = replaced(corner_ply.substr(0, corner_ply.find("3 0 2 1")), "face 4", "tristrips 1");
  EXPECT_EQ(SP::internal::read_mesh_file(".ply", header + "8 0 2 1 3 0 2 2 2\n").polygons,
            (std::vector<SP::internal::Polygon>{{0, 2, 1}, {1, 2, 3}, {1, 3, 0}, {0, 3, 2}}));

  // the vertices of this format have the order in which the facets name them first
  const std::string other =
      replaced(replaced(replaced(corner_off, "1 0 0\n0 1 0", "0 1 0\n1 0 0"), "3 0 2 1", "3 0 1 2"),
               "3 0 1 3\n3 1 2 3\n3 2 0 3", "3 0 2 3\n3 2 1 3\n3 1 0 3");
  for(const std::string& text : {corner_stl, replaced(corner_stl, "\n", "\r\n"), in_capitals(corner_stl),
                                 binary_stl("a corner", 4), binary_stl("solid corner", 4)})
    expect_same_mesh(".stl", text, SP::internal::read_mesh_file(".off", other));
}

// A word is the number that the function of C has for it, in a program that sets no locale, or is refused.
template <class Read, class Convert>
void expect_as_in_C(const std::string& word, const Read& read, const Convert& convert)
{
  const std::string line = word + " 1";
  char* end = nullptr;
  errno = 0;
  const auto expected = convert(line.c_str(), &end);
  const bool is_number = end != line.c_str() && *end == ' ';
  const bool is_too_large = errno == ERANGE && std::abs(static_cast<double>(expected)) > 1.;
  std::string found;
  try
  {
    SP::internal::Text_scanner in(line);
    in.next_line();
    const auto x = read(in);
    EXPECT_EQ(in.word(), "1") << word;
    const bool is_none = x != x && expected != expected;
    found = is_none || std::memcmp(&x, &expected, sizeof x) == 0 ? "" : "is " + std::to_string(x);
  }
  catch(const SP::internal::File_error& error)
  {
    found = error.what();
  }
  const std::string part = is_number && !is_too_large ? "" : is_too_large && is_number ? "too large" : "not a number";
  EXPECT_EQ(found.empty(), part.empty()) << word << ": " << found;
  EXPECT_NE(found.find(std::is_integral_v<decltype(expected)> ? "" : part), std::string::npos) << word << ": " << found;
}

TEST(Text_scanner, reads_numbers_as_C_does)
{
  std::vector<std::string> words = {"0." + std::string(400, '0') + "1e401", "1" + std::string(400, '0') + "e-401",
                                    "1" + std::string(400, '0'), "-0." + std::string(400, '0') + '1'};
  for(const char* word : {"1.",
                          ".5",
                          "+.5e+1",
                          "-0",
                          "007",
                          "1e-400",
                          "-1e-400",
                          "4.9e-324",
                          "2.5e-310",
                          "1e308",
                          "1e309",
                          "-1e309",
                          "1e+999",
                          "1e-99999999999999999999",
                          "1e99999999999999999999",
                          "+1",
                          "-+1",
                          "+-1",
                          "++1",
                          "1e",
                          "e1",
                          ".",
                          "-",
                          "1,5",
                          "1.5.",
                          "0x1.8p1",
                          "-0XAp-1",
                          "0x",
                          "0x.p1",
                          "0x-1",
                          "0x.8",
                          "0x1p5000",
                          "0x1p-5000",
                          "0x1p1023",
                          "0x1p1024",
                          "inf",
                          "+iNf",
                          "infin",
                          "-Infinity",
                          "nan",
                          "-NaN",
                          "nan(12)",
                          "nan(",
                          "\v1",
                          "1\v",
                          "\f\v1",
                          "1f",
                          "1d5",
                          "1_0",
                          "9223372036854775807",
                          "9223372036854775808",
                          "-9223372036854775808",
                          "-9223372036854775809"})
    words.push_back(word);
  for(const std::string& word : words)
  {
    expect_as_in_C(
        word, [](auto& in) { return in.read_number("it"); }, &std::strtod);
    expect_as_in_C(
        word, [](auto& in) { return in.read_integer("it"); },
        [](const char* text, char** end) { return std::strtoll(text, end, 10); });
  }
}

TEST(Mesh_file, is_read_alike_in_every_locale)
{
  for(const auto& [format, text] : {std::pair(".off", corner_off),
                                    {".obj", corner_obj},
                                    {".stl", corner_stl},
                                    {".ts", corner_ts},
                                    {".ply", corner_ply}})
    expect_same_with_commas([&, format = format, text = text] {
      const SP::internal::Polygon_soup soup = SP::internal::read_mesh_file(
          format, replaced(replaced(text, " 0 1 0\n", " -0.125 1.5 0\n"), "\n0 1 0\n", "\n-0.125 1.5 0\n"));
      return std::pair(soup.points, soup.polygons);
    });
}

TEST(Mesh_file, that_is_damaged_says_where)
{
  const std::string huge = std::to_string(1ull << 60);
  const std::vector<std::array<std::string, 3>> table = {
      {".off", "", "the file is empty"},
      {".off", "ply\n", "line 1: an OFF file begins with OFF, not with 'ply'"},
      {".off", "OFF\n-4 4 0\n", "line 2: the number of vertices is negative"},
      {".off", corner_off.substr(0, 50), "the file ends after 2 of 4 faces: it is truncated"},
      {".off", replaced(corner_off, "1 0 0", "1,0 0 0"), "line 4: coordinate x of vertex 1 is not a number: '1,0'"},
      {".off", replaced(corner_off, "\n1 0 0\n", "\n1 0\n"), "line 4: coordinate z of vertex 1 is missing"},
      {".off", replaced(corner_off, "3 0 2 1", "-3 0 2 1"), "line 7: the number of corners of face 0 is negative"},
      {".off", replaced(corner_off, "3 0 2 1", "9 0 2 1"), "line 7: corner 3 of face 0 is missing"},
      {".off", corner_off + "3 0 1 2\n", "line 11: the file goes on after 4 faces with '3'"},
      {".off", corner_off + "\x1b[31m\n", "line 11: the file goes on after 4 faces with a byte that is no text"},
      {".off", replaced(corner_off, "3 0 2 1", "3 0 2 4"), "line 7: face 0 has the corner 4"},
      {".off", replaced(corner_off, "4 4 0", huge + " 4 0"), "too short for " + huge + " vertices"},
      {".off", replaced(corner_off, "4 4 0", "4 " + huge + " 0"), "too short for " + huge + " faces"},
      {".off", replaced(corner_off, "OFF", "nOFF\n4"), "line 2: the dimension is 4"},
      {".off", "OFF BINARY\n" + std::string(40, '\7'), "line 1: the binary variant is not read"},
      {".off", corner_off.substr(0, 20) + std::string(1, '\0') + corner_off.substr(20), "a byte that is no text"},
      {".off", "\x1F\x8B\x08" + corner_off, "compressed"},
      {".obj", corner_off, "line 1: no line of an OBJ file begins with 'OFF'"},
      {".obj", replaced(corner_obj, "v 1 0 0", "v 1 0"), "line 2: coordinate z of vertex 1 is missing"},
      {".obj", replaced(corner_obj, "f 1 3 2", "f 1 3 2.5"), "line 5: corner 2 of face 0 should be an integer"},
      {".obj", replaced(corner_obj, "f 1 3 2", "f 0 3 2"), "line 5: face 0 has the corner 0"},
      {".obj", replaced(corner_obj, "f 1 3 2", "f 1 3 -5"), "line 5: face 0 has the corner -5"},
      {".obj", replaced(corner_obj, "f 1 3 2", "f 1 3 7"),
       "line 5: a face has the corner 7, but the file has 4 vertices"},
      {".stl", corner_off, "this is no STL file"},
      {".stl", replaced(corner_stl, "solid facet", "Solid facet"), "this is no STL file"},
      {".stl", binary_stl("a corner", 5), "nor is it long enough for the 5 facets"},
      {".stl", binary_stl("a corner", 4000000000u), "for the 4000000000 facets"},
      {".stl", binary_stl("a corner", 4, NAN), "facet 0 has a coordinate that is infinite or not a number"},
      {".stl", replaced(corner_stl, "vertex 0 0 1", "vertex 0 inf 1"), "facet 1 has a coordinate that is infinite"},
      {".stl", replaced(corner_stl, "vertex 0 0 1\n", "vertex 0 x 1\n"), "coordinate y of facet 1 is not a number"},
      {".stl", replaced(corner_stl, "vertex 0 0 1\n", ""), "facet 1 has 2 vertices"},
      {".stl", replaced(corner_stl, "vertex 0 0 1", "vertex 0 0 1\nvertex 1 1 1"), "facet 1 has a fourth vertex"},
      {".stl", replaced(corner_stl, "endfacet\n", ""), "facet 0 does not end"},
      {".stl", replaced(corner_stl, "endsolid\n", ""), "ends without endsolid"},
      {".stl", replaced(corner_stl, "facet normal", "facette"), "line 2: no line of an STL file begins with"},
      {".ts", corner_off, "line 1: a surface of a GOCAD file begins with GOCAD, not with 'OFF'"},
      {".ts", replaced(corner_ts, "TRGL 0 2 1", "TRGL 0 2 7"), "line 10: corner 2 is the vertex 7"},
      {".ts", replaced(corner_ts, "VRTX 2", "VRTX 1"), "line 8: the vertex 1 exists already"},
      {".ts", replaced(corner_ts, "VRTX 2 0 1", "VRTX 2 0 y"), "line 8: coordinate y of vertex 2 is not a number"},
      {".ts", replaced(corner_ts, "END\n", ""), "ends without END"}};
  for(const auto& [format, text, message] : table)
    expect_damaged(format, text, message);
}

TEST(Ply_file, is_read_whatever_its_types_and_order_are)
{
  using namespace ply_files;
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
  const SP::internal::Polygon_soup expected = SP::internal::read_mesh_file(".ply", corner_ply);
  for(const std::string& format : ply_formats)
    for(const std::vector<Ply_element>& elements : variants)
    {
      const std::string file = ply_file(format, elements);
      expect_same_mesh(".ply", file, expected);
      const SP::internal::Polygon_soup soup = SP::internal::read_mesh_file(".ply", file, true);
      ASSERT_EQ(soup.values_of_vertices.size(), 1u);
      EXPECT_EQ(soup.values_of_vertices[0].numbers[2], 7.);
      ASSERT_EQ(soup.values_of_faces.size(), 1u);
      EXPECT_EQ(soup.values_of_faces[0].numbers, (std::vector<double>{7., 7., 7., 9.}));
      EXPECT_EQ(soup.left_out.size(), elements.size() - 2);
    }
}

TEST(Ply_file, that_is_damaged_says_where)
{
  using namespace ply_files;
  for(const std::string& format : ply_formats)
  {
    Ply_element twice = vertices;
    twice.push_back("float height");
    expect_damaged(".ply", ply_file(format, {twice, faces}), "line 8: the same property once more", false);
    expect_damaged(".ply", ply_file(format, {vertices, vertices, faces}), "line 8: the vertices once more");
    std::map<std::string, Numbers> numbers = usual_numbers;
    numbers["vertex_indices"][2] = {1, 2, 4};
    const std::string file = ply_file(format, {vertices, {"face", "list uchar uchar vertex_indices", "ushort label"}},
                                      numbers),
                      end = "end_header\n";
    const std::size_t byte = file.find(end) + end.size() + 4 * 16 + 2 * 6 + 3;
    expect_damaged(".ply", file,
                   (format == "ascii" ? "line 18" : "byte " + std::to_string(byte)) +
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
  const std::vector<std::pair<std::string, std::string>> table = {
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
      {replaced(corner_ply, "uchar int", "uchar float"), "line 8: the corners of a face have to be integers"},
      {replaced(corner_ply, "uchar int", "float int"), "line 8: the size of a list has to be an integer"},
      {replaced(corner_ply, "vertex_indices", "indices"), "no property vertex_indices that is a list"},
      {replaced(corner_ply, "3 0 2 1", "3 0 2"), "line 14: a number of 'face' 0 is missing"},
      {replaced(corner_ply, "3 0 2 1", "-3 0 2 1"), "'face' 0 has a list of negative length"},
      {replaced(corner_ply, "3 0 2 1", "3 0 2 -1"), "'face' 0 has a corner that does not exist"},
      {replaced(corner_ply, "1 0 0", "1 0.x 0"), "line 11: a number of 'vertex' 1 is not a number"},
      {little.substr(0, little.size() - 1), "ends in 'face' 3 of 4"},
      {replaced(little, "vertex 4", "vertex " + huge), "too short for " + huge + " 'vertex' elements"},
      {replaced(little, "list uchar uint", "list uint uint"), "'face' 0"},
      {with_row("property int a\n", "nan"), "line 12: a number of 'vertex' 1 should be an integer, not 'nan'"},
      {with_row("property double a\n", "-1e309"),
       "line 12: a number of 'vertex' 1 is too large, beyond 1.8e308: '-1e309'"},
      {with_row("property float a\n", ""), "line 12: a number of 'vertex' 1 is missing"},
      {with_row("property float a\n", "2\ncomment here"), "line 13: a number of 'vertex' 2 is not a number: 'comment'"},
      {with_row("property float\n", "2"), "line 7: a property without name"},
      {with_row("propertyfloat a\n", "2"), "line 7: no line in the header of a PLY file begins with 'propertyfloat'"}};
  for(const auto& [text, message] : table)
    expect_damaged(".ply", text, message);
  const std::vector<std::pair<std::string, std::string>> of_values = {
      {with_row("property uchar a\n", "256"), "line 12: a number of 'vertex' 1 is not in the range of its type: 256"},
      {with_row("property char a\n", "-129"), "line 12: a number of 'vertex' 1 is not in the range of its type: -129"},
      {with_row("property float a\n", "1e39"),
       "line 12: a number of 'vertex' 1 is not in the range of its type: 1e+39"},
      {with_row(many, "2"), "line 4100: there are more than 4096 properties of 'vertex'"}};
  for(const auto& [text, message] : of_values)
    expect_damaged(".ply", text, message, false);
  // elements that take no bytes, however many there are
  const std::string foo = with_row("property float height\n", "2\n\n# a comment\n")
                              .insert(corner_ply.find("element"), "comment one\n\nelement foo 4000000000000000000\n");
  EXPECT_EQ(SP::internal::read_mesh_file(".ply", foo, true).left_out, std::vector<std::string>{"the elements 'foo'"});
}

} // namespace
