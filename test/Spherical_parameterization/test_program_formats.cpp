// Mesh files that the command line program reads: all variants of a format alike; and what is wrong with one, and where. PLY
// files: test_program_ply.cpp.

#include "Program_fixture.h"

#include <cctype>

// In CGAL's tree the program is not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

using Format_program = Program_fixture;

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

const std::string corner_ts =
    "GOCAD TSurf 1\nHEADER {\nname:corner\n}\nTFACE\nVRTX 0 0 0 0\nVRTX 1 1 0 0\nVRTX 2 0 1 0\n"
    "VRTX 3 0 0 1\nTRGL 0 2 1\nTRGL 0 1 3\nTRGL 1 2 3\nTRGL 2 0 3\nEND\n";

TEST_F(Format_program, reads_every_format_alike)
{
  write("corner.off", corner_off);
  expect_success("corner.off -o expected.off --quiet");
  const std::string expected = content(path("expected.off"));
  const std::string homogeneous = "4 4 6\n0 0 0 2\n2 0 0 2\n0 0.5 0 0.5\n0 0 -1 -1\n", faces = corner_off.substr(34);
  const std::vector<std::pair<const char*, std::string>> table = {
      {"variant.off", "OFF 4 4" + corner_off.substr(7)},
      {"variant.off", "# a comment\n\n" + replaced(corner_off, "\n", " # another\r\n\r\n")},
      {"variant.off", "\xEF\xBB\xBF" + corner_off + "\n# and more\n\n"},
      {"variant.off", "4OFF\n" + homogeneous + faces},
      {"variant.off", "nOFF\n3\n" + corner_off.substr(4)},
      {"variant.off", "C4nOFF 3\n" + replaced(homogeneous, "2\n", "2 0.5 0.5 0.5 1\n") + faces},
      {"variant.obj", corner_obj},
      {"variant.obj", "mtllib a.mtl\no a\ng b\nvn 0 0 1\n" + replaced(corner_obj, "\n", " \r\n") + "l 1 2\n"},
      {"variant.obj", replaced(corner_obj, " ", "\t")},
      {"variant.obj", replaced(corner_obj, "f 1 3 2", "f 1/1/1 -2//7 2/5")},
      {"variant.obj", corner_obj.substr(32) + corner_obj.substr(0, 32)},
      {"variant.ts", corner_ts},
      {"variant.ts", replaced(replaced(corner_ts, "\n", "\r\n"), "VRTX", "PVRTX")},
      {"variant.ts", replaced(replaced(corner_ts, "VRTX 3", "VRTX -7"), " 3\n", " -7\n")},
      {"variant.ts", replaced(replaced(corner_ts, "TRGL 0 2 1", "ATOM 9 2\nTRGL 0 9 1"), "END\n", "END")}};
  for(const auto& [name, text] : table)
  {
    SCOPED_TRACE(text);
    write(name, text);
    expect_success(name + std::string(" -o result.off --quiet"));
    EXPECT_EQ(content(path("result.off")), expected);
    fs::remove(path("result.off"));
  }

  // the vertices of this format have the order in which the facets name them first
  write("other.off", replaced(replaced(replaced(corner_off, "1 0 0\n0 1 0", "0 1 0\n1 0 0"), "3 0 2 1", "3 0 1 2"),
                              "3 0 1 3\n3 1 2 3\n3 2 0 3", "3 0 2 3\n3 2 1 3\n3 1 0 3"));
  expect_success("other.off -o expected.off --quiet");
  for(const std::string& text : {corner_stl, replaced(corner_stl, "\n", "\r\n"), in_capitals(corner_stl),
                                 binary_stl("a corner", 4), binary_stl("solid corner", 4)})
  {
    write("variant.stl", text);
    expect_success("variant.stl -o result.off --quiet");
    EXPECT_EQ(content(path("result.off")), content(path("expected.off")));
    fs::remove(path("result.off"));
  }
}

TEST_F(Format_program, says_where_a_file_is_damaged)
{
  const std::string huge = std::to_string(1ull << 60);
  const std::vector<std::array<std::string, 3>> table = {
      {"bad.off", "", "the file is empty"},
      {"bad.off", "ply\n", "line 1: an OFF file begins with OFF, not with 'ply'"},
      {"bad.off", "OFF\n-4 4 0\n", "line 2: the number of vertices is negative"},
      {"bad.off", corner_off.substr(0, 50), "the file ends after 2 of 4 faces: it is truncated"},
      {"bad.off", replaced(corner_off, "1 0 0", "1,0 0 0"), "line 4: coordinate x of vertex 1 is not a number: '1,0'"},
      {"bad.off", replaced(corner_off, "\n1 0 0\n", "\n1 0\n"), "line 4: coordinate z of vertex 1 is missing"},
      {"bad.off", replaced(corner_off, "3 0 2 1", "-3 0 2 1"), "line 7: the number of corners of face 0 is negative"},
      {"bad.off", replaced(corner_off, "3 0 2 1", "9 0 2 1"), "line 7: corner 3 of face 0 is missing"},
      {"bad.off", corner_off + "3 0 1 2\n", "line 11: the file goes on after 4 faces with '3'"},
      {"bad.off", corner_off + "\x1b[31m\n", "line 11: the file goes on after 4 faces with a byte that is no text"},
      {"bad.off", replaced(corner_off, "3 0 2 1", "3 0 2 4"), "line 7: face 0 has the corner 4"},
      {"bad.off", replaced(corner_off, "4 4 0", huge + " 4 0"), "too short for " + huge + " vertices"},
      {"bad.off", replaced(corner_off, "4 4 0", "4 " + huge + " 0"), "too short for " + huge + " faces"},
      {"bad.off", replaced(corner_off, "OFF", "nOFF\n4"), "line 2: the dimension is 4"},
      {"bad.off", "OFF BINARY\n" + std::string(40, '\7'), "line 1: the binary variant is not read"},
      {"bad.off", corner_off.substr(0, 20) + std::string(1, '\0') + corner_off.substr(20), "a byte that is no text"},
      {"bad.off", "\x1F\x8B\x08" + corner_off, "compressed"},
      {"bad.off", std::string(100000, '\0'), "begins with nothing but zeros"},
      {"bad.obj", corner_off, "line 1: no line of an OBJ file begins with 'OFF'"},
      {"bad.obj", replaced(corner_obj, "v 1 0 0", "v 1 0"), "line 2: coordinate z of vertex 1 is missing"},
      {"bad.obj", replaced(corner_obj, "f 1 3 2", "f 1 3 2.5"), "line 5: corner 2 of face 0 should be a whole number"},
      {"bad.obj", replaced(corner_obj, "f 1 3 2", "f 0 3 2"), "line 5: face 0 has the corner 0"},
      {"bad.obj", replaced(corner_obj, "f 1 3 2", "f 1 3 -5"), "line 5: face 0 has the corner -5"},
      {"bad.obj", replaced(corner_obj, "f 1 3 2", "f 1 3 7"),
       "line 5: a face has the corner 7, but the file has 4 vertices"},
      {"bad.stl", corner_off, "this is no STL file"},
      {"bad.stl", replaced(corner_stl, "solid facet", "Solid facet"), "this is no STL file"},
      {"bad.stl", binary_stl("a corner", 5), "nor is it long enough for the 5 facets"},
      {"bad.stl", binary_stl("a corner", 4000000000u), "for the 4000000000 facets"},
      {"bad.stl", binary_stl("a corner", 4, NAN), "facet 0 has a coordinate that is infinite or not a number"},
      {"bad.stl", replaced(corner_stl, "vertex 0 0 1", "vertex 0 inf 1"), "facet 1 has a coordinate that is infinite"},
      {"bad.stl", replaced(corner_stl, "vertex 0 0 1\n", "vertex 0 x 1\n"), "coordinate y of facet 1 is not a number"},
      {"bad.stl", replaced(corner_stl, "vertex 0 0 1\n", ""), "facet 1 has 2 vertices"},
      {"bad.stl", replaced(corner_stl, "vertex 0 0 1", "vertex 0 0 1\nvertex 1 1 1"), "facet 1 has a fourth vertex"},
      {"bad.stl", replaced(corner_stl, "endfacet\n", ""), "facet 0 does not end"},
      {"bad.stl", replaced(corner_stl, "endsolid\n", ""), "ends without endsolid"},
      {"bad.stl", replaced(corner_stl, "facet normal", "facette"), "line 2: no line of an STL file begins with"},
      {"bad.ts", corner_off, "line 1: a surface of a GOCAD file begins with GOCAD, not with 'OFF'"},
      {"bad.ts", replaced(corner_ts, "TRGL 0 2 1", "TRGL 0 2 7"), "line 10: corner 2 is the vertex 7"},
      {"bad.ts", replaced(corner_ts, "VRTX 2", "VRTX 1"), "line 8: the vertex 1 exists already"},
      {"bad.ts", replaced(corner_ts, "VRTX 2 0 1", "VRTX 2 0 y"), "line 8: coordinate y of vertex 2 is not a number"},
      {"bad.ts", replaced(corner_ts, "END\n", ""), "ends without END"}};
  for(const auto& [name, text, message] : table)
  {
    write(name, text);
    expect_message(name + " -o result.off --json result.json --colored result", message);
  }
}

TEST_F(Format_program, says_what_is_wrong_with_a_mesh)
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

TEST_F(Format_program, counts_the_faces_of_an_edge_that_has_many)
{
  const std::size_t n = 50000;
  std::string points = "0 0 0\n1 0 0\n", faces;
  for(std::size_t i = 0; i < n; ++i)
  {
    points += "0 1 " + std::to_string(i) + "\n";
    faces += "3 0 1 " + std::to_string(i + 2) + "\n";
  }
  const std::string text = "OFF\n" + std::to_string(n + 2) + " " + std::to_string(n + 1) + " 0\n" + points + faces;
  write("book.off", text + "3 0 1 2\n");
  expect_message("book.off -o result.off", "the faces 0 and 50000 have the same corners");
  write("book.off", text + "3 0 2 3\n");
  expect_message("book.off -o result.off", "the edge between the vertices 0 and 1 has 50000 faces");
}

TEST_F(Format_program, refuses_every_invalid_mesh_of_the_corpus)
{
  const fs::path folder = fs::path(SPHERICAL_PARAMETERIZATION_SHARED_DATA_DIR) / "nasty";
  if(!fs::exists(folder))
    GTEST_SKIP() << "The corpus is not there.";
  std::size_t number_of_meshes = 0;
  for(const fs::directory_entry& entry : fs::directory_iterator(folder))
    if(entry.path().filename().string().rfind("invalid_", 0) == 0)
    {
      expect_message("'" + entry.path().string() + "' -o result.off", entry.path().filename().string());
      ++number_of_meshes;
    }
  EXPECT_GT(number_of_meshes, 20u);
}

} // namespace

#endif
