// The files of FreeSurfer: what is in them, what becomes of damaged ones, and what is written.

#include "locale_of_commas.h"
#include "surface_files.h"

#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#ifdef TEST_MGH
#include <CGAL/Spherical_parameterization/Cortex/MGH.h>
#endif

using namespace surface_files;

namespace {

Binary_file& operator<<(Binary_file& file, std::int32_t x)
{
  return file << static_cast<std::uint32_t>(x);
}

template <class... Parts>
std::string file_of(const Parts&... parts)
{
  Binary_file file(true);
  (file << ... << parts);
  return file.content;
}

const std::string first_line = "created by somebody on some day";
const std::string geometry =
    "valid = 1  # volume info valid\nfilename = ../mri/filled-pretess255.mgz\nvolume = 256 256 256\n"
    "voxelsize = 1.0 1.0 1.0\nxras   = -1.0 0.0 0.0\nyras   = 0.0 0.0 -1.0\nzras   = 0.0 1.0 0.0\n"
    "cras   = 5.4 18.0 0.0\n";

// the tag of real coordinates, the geometry of the volume, and a command
std::string footer()
{
  return file_of(2, 0, 20, geometry, 3, 0, 9, std::string("mris_warp"));
}

// A tetrahedron
std::string surface(const std::string& end = footer(), std::int32_t n_points = 4, std::int32_t n_triangles = 4,
                    std::int32_t last_corner = 3)
{
  Binary_file file(true);
  file << "\xFF\xFF\xFE" + first_line + "\n\n";
  file << n_points << n_triangles;
  for(const float x : {0.f, 0.f, -0.f, 1.f, 0.f, 0.f, 0.f, 0.1f, 0.f, 0.f, 1e-42f, 3e38f})
    file << x;
  for(const std::int32_t v : {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, last_corner})
    file << v;
  return file.content + end;
}

std::string write_surface(const Surface_file& file)
{
  return written([&](auto& out, auto& message) { return SP::IO::write_FreeSurfer_surface(out, file, message); });
}

std::string curv(const std::vector<float>& values, std::int32_t n, std::int32_t n_of_each = 1)
{
  Binary_file file(true);
  file << std::string("\xFF\xFF\xFF");
  file << n << 7 << n_of_each;
  for(const float x : values)
    file << x;
  return file.content;
}

struct Entry
{
  std::int32_t key;
  std::string name;
  std::array<std::int32_t, 4> color;
};

const std::vector<Entry> entries = {{0, "unknown", {{25, 5, 25, 0}}}, {3, "bankssts", {{25, 100, 40, 255}}}};

std::string annotation(std::int32_t version, const std::vector<Entry>& table = entries,
                       const std::vector<std::pair<std::int32_t, std::int32_t>>& vertices = {
                           {0, 25 + (100 << 8) + (40 << 16)},
                           {2, 25 + (5 << 8) + (25 << 16)},
                           {1, 25 + (5 << 8) + (25 << 16)}})
{
  const auto text = [](Binary_file& file, const std::string& word) {
    file << static_cast<std::int32_t>(word.size() + 1);
    file << word + '\0';
  };
  Binary_file file(true);
  file << static_cast<std::int32_t>(vertices.size());
  for(const auto& [v, color] : vertices)
    file << v << color;
  if(version == 0)
    return file.content;
  file << 1;
  if(version == 1)
    file << static_cast<std::int32_t>(table.size());
  else
    file << -version << 4;
  text(file, "colortable.txt");
  if(version == 2)
    file << static_cast<std::int32_t>(table.size());
  for(const Entry& entry : table)
  {
    if(version == 2)
      file << entry.key;
    text(file, entry.name);
    for(const std::int32_t x : entry.color)
      file << x;
  }
  return file.content;
}

std::string write_annotation(const Surface_file& file)
{
  return written([&](auto& out, auto& message) { return SP::IO::write_FreeSurfer_annotation(out, file, message); });
}

using Refusals = std::vector<std::pair<std::string, const char*>>;

void expect_all_refused(const Reader& reader, const Refusals& table)
{
  for(const auto& [content, message] : table)
    expect_refused(reader, content, message);
}

const Reader read_surface = SP::IO::read_FreeSurfer_surface, read_curv = SP::IO::read_FreeSurfer_curv,
             read_annotation = SP::IO::read_FreeSurfer_annotation, read_label = SP::IO::read_FreeSurfer_label;

} // namespace

TEST(FreeSurfer_surface, keeps_all_that_is_in_the_file)
{
  const std::string content = surface();
  const Surface_file file = read(read_surface, content);
  EXPECT_EQ(file.origin.created_by, first_line);
  EXPECT_EQ(file.origin.footer, footer());
  ASSERT_EQ(file.points.size(), 4u);
  ASSERT_EQ(file.triangles.size(), 4u);
  EXPECT_EQ(file.points[2][1], static_cast<double>(0.1f));
  EXPECT_TRUE(std::signbit(file.points[0][2]));
  EXPECT_EQ(file.triangles[3], (std::array<std::uint32_t, 3>{2, 0, 3}));
  EXPECT_EQ(write_surface(file), content);
}

TEST(FreeSurfer_surface, reads_variants)
{
  std::string content = surface("");
  EXPECT_EQ(write_surface(read(read_surface, content)), content);
  content.erase(3 + first_line.size(), 1); // one end of a line
  EXPECT_EQ(read(read_surface, content).points.size(), 4u);
  // Coordinates that are no numbers are kept: they are a defect of the mesh, which others report.
  Surface_file file = read(read_surface, surface());
  file.points[0] = {{NAN, HUGE_VAL, -HUGE_VAL}};
  file.origin = {};
  const Surface_file again = read(read_surface, write_surface(file));
  EXPECT_TRUE(std::isnan(again.points[0][0]) && again.points[0][1] == HUGE_VAL);
  EXPECT_EQ(again.origin.created_by, "created by Spherical_parameterization");
  file.origin.created_by = "one\ntwo"; // one first line only
  EXPECT_EQ(read(read_surface, write_surface(file)).origin.created_by, "one");
  file.points[0][0] = 1e39;
  const auto write = [&](auto& out, auto& message) { return SP::IO::write_FreeSurfer_surface(out, file, message); };
  expect_not_written(write, SP::ERROR_OUT_OF_FLOAT_RANGE, "Vertex 0 has the coordinate 1e+39");
}

TEST(FreeSurfer_surface, refuses_what_is_wrong)
{
  expect_all_refused(read_surface,
                     {{"", "ends within the magic number, at byte 0: it is truncated"},
                      {"OFF\n4 4 0\n", "does not begin with the bytes FF FF FE"},
                      {"\xFF\xFF\xFD" + surface().substr(3), "an old quadrangle file of FreeSurfer, which is not read"},
                      {curv({1.f}, 1), "no surface but values of vertices, or an old quadrangle file"},
                      {surface("").substr(0, 3 + first_line.size()), "ends within its first line"},
                      {surface(footer(), -1), "Byte 36: the number of vertices is negative, -1"},
                      {surface(footer(), 4, -5), "Byte 40: the number of triangles is negative, -5"},
                      {surface(footer(), 2000000000), "too short for 2000000000 vertices"},
                      {surface(footer(), 4, 2000000000), "too short for 2000000000 triangles"},
                      {surface(footer(), 4, 4, 4), "Triangle 3 has the corner 4, but there are 4 vertices"},
                      {surface(footer(), 4, 4, -2), "Triangle 3 has the corner -2"},
                      {surface("rubbish"), "goes on after its data, at byte 140 of 143, with what is no footer"},
                      {surface(std::string(3, '\0')), "goes on after its data"},
                      {surface(footer() + "abc"), "goes on after its data"},
                      {surface(file_of(3, 0x7FFFFFFF, -1)), "bytes of the footer"}});
}

TEST(FreeSurfer_surface, is_robust)
{
  const std::size_t data = surface("").size(), tag = 4;
  const std::size_t command = surface().size() - 3 * tag - 9;
  expect_robust(read_surface, surface(), {data, data + 2 * tag, command});
}

TEST(FreeSurfer_curv, reads_and_writes_values)
{
  const std::vector<float> values = {0.1f, -0.f, std::numeric_limits<float>::infinity(), NAN};
  const std::string content = curv(values, 4);
  const Surface_file file = read(read_curv, content);
  ASSERT_EQ(file.columns.size(), 1u);
  EXPECT_TRUE(are_same(file.columns[0].values, std::vector<double>(values.begin(), values.end())));
  EXPECT_EQ(written([&](auto& out, auto& message) {
              return SP::IO::write_FreeSurfer_curv(out, file.columns[0], 7, message);
            }),
            content);
  expect_robust(read_curv, content);

  using Type = Vertex_values::Type;
  for(const auto& [type, value, part] :
      {std::tuple(Type::float32, -1e300, "The value -1e+300 of vertex 0 in column 'name' is too large"),
       {Type::int32, 16777217., "The integer 16777217 of vertex 0 in column 'name' would lose digits"}})
  {
    const Vertex_values column{"name", "", type, {value}, {}};
    const auto write = [&](auto& out, auto& message) { return SP::IO::write_FreeSurfer_curv(out, column, 7, message); };
    expect_not_written(write, SP::ERROR_OUT_OF_FLOAT_RANGE, part);
  }
}

TEST(FreeSurfer_curv, reads_the_old_format)
{
  const std::string content =
      file_of(std::string("\0\0\3\0\0\2", 6), std::int16_t(123), std::int16_t(-1), std::int16_t(-32768));
  EXPECT_TRUE(are_same(read(read_curv, content).columns[0].values, {1.23, -0.01, -327.68}));
  expect_robust(read_curv, content);
}

TEST(FreeSurfer_curv, refuses_what_is_wrong)
{
  expect_all_refused(read_curv, {{"", "ends within the magic number"},
                                 {surface(), "This is a surface of FreeSurfer, not a file of values"},
                                 {curv({1.f}, 1, 2), "has 2 values for each vertex, not 1"},
                                 {curv({1.f}, 2000000000), "too short for 2000000000 vertices"},
                                 {curv({1.f}, -3), "the number of vertices is negative, -3"},
                                 {curv({1.f, 2.f, 3.f}, 2), "goes on for 4 bytes after its 2 values"},
                                 {"OFF\n4 4 0\n0 0 0\n", "too short for 5195334 values"}}); // O, F, F
}

TEST(FreeSurfer_annotation, reads_both_versions)
{
  for(const std::int32_t version : {1, 2})
  {
    const Surface_file file = read(read_annotation, annotation(version));
    ASSERT_EQ(file.labels.size(), 2u);
    EXPECT_EQ(file.labels[1].name, "bankssts");
    EXPECT_EQ(file.labels[1].key, version == 2 ? 3 : 1);
    EXPECT_EQ(file.labels[1].color, (std::array<double, 4>{25 / 255., 100 / 255., 40 / 255., 0.}));
    ASSERT_EQ(file.columns.size(), 1u);
    const double key = file.labels[1].key;
    EXPECT_TRUE(are_same(file.columns[0].values, {key, 0., 0.})); // the vertices may be in any order
    const Surface_file again = read(read_annotation, write_annotation(file));
    EXPECT_TRUE(are_same(again.columns[0].values, file.columns[0].values));
    EXPECT_EQ(again.labels[1].key, file.labels[1].key);
    EXPECT_EQ(again.labels[1].color, file.labels[1].color);
    expect_robust(read_annotation, write_annotation(file), {28});
  }
}

TEST(FreeSurfer_annotation, keeps_colors_without_name)
{
  const std::vector<std::pair<std::int32_t, std::int32_t>> vertices = {
      {0, 0}, {1, 25 + (5 << 8) + (25 << 16)}, {2, -2}, {3, 7}, {4, 0}};
  const std::string content = annotation(2, entries, vertices);
  const std::string message = "4 vertices have 3 colors that the table of 2 does not name, such as 0 0 0: they are "
                              "labels without name.\n";
  const Surface_file file = read(read_annotation, content, message);
  ASSERT_EQ(file.labels.size(), 5u);
  EXPECT_EQ(file.labels[2].name, "");
  EXPECT_TRUE(are_same(file.columns[0].values, {4., 0., 5., 6., 4.}));
  const Surface_file again = read(read_annotation, write_annotation(file), message);
  EXPECT_TRUE(are_same(again.columns[0].values, file.columns[0].values));
  // but for the name of the table, nothing has changed
  const std::size_t size_of_vertices = 4 + 8 * vertices.size();
  EXPECT_EQ(write_annotation(file).substr(0, size_of_vertices), content.substr(0, size_of_vertices));
  const Surface_file without = read(read_annotation, annotation(0, {}, vertices),
                                    "5 vertices have 4 colors that the table of 0 does not name, such as 0 0 0: they "
                                    "are labels without name.\n");
  EXPECT_EQ(without.labels.size(), 4u);
}

TEST(FreeSurfer_annotation, refuses_what_is_wrong)
{
  const auto with = [](std::int32_t key, std::int32_t green) {
    return annotation(2, {{3, "a", {}}, {key, "b", {{0, green, 0, 0}}}});
  };
  expect_all_refused(
      read_annotation,
      {{"", "ends within vertices"},
       {std::string("\x7F\0\0\0", 4), "too short for 2130706432 vertices"},
       {annotation(2, entries, {{0, 1}, {2, 1}}), "vertex 2 of 2 does not exist"},
       {annotation(2, entries, {{1, 1}, {-1, 1}}), "vertex -1 of 2 does not exist"},
       {annotation(2, entries, {{1, 1}, {1, 1}}), "vertex 1 of 2 is there twice"},
       {annotation(3), "the color table has the version 3, but 1 and 2 are known"},
       {with(3, 0), "entry 1 of the color table has the number 3, as another one has"},
       {with(-3, 0), "the number -3, which is out of range"},
       {with(1, 256), "entry 1 of the color table has a component 256"},
       {annotation(2) + "rest", "goes on after its data"},
       {file_of(0, 2), "the number of color tables is 2, not 0 or 1"},
       {file_of(0, 1, -2, 4, 1, std::string(1, '\0'), 100000000), "too short for 100000000 entries of the color table"},
       {file_of(0, 1, -2, 4, 0x7FFFFFFF), "the name of the color table has 2147483647 bytes, but 0 follow"}});
}

TEST(FreeSurfer_annotation, is_not_written_if_labels_would_be_lost)
{
  Surface_file right = read(read_annotation, annotation(2));
  right.labels.push_back({7, "as the first", right.labels[0].color});
  write_annotation(right);
  const auto expect = [&](const char* part, const auto& change) {
    Surface_file file = right;
    change(file);
    const auto write = [&](auto& out, auto& message) {
      return SP::IO::write_FreeSurfer_annotation(out, file, message);
    };
    expect_not_written(write, SP::ERROR_WRONG_PARAMETER, part);
  };
  expect("There is no column", [](Surface_file& file) { file.columns.clear(); });
  expect("of 3 vertices of a surface, not of all from 0 on", [](Surface_file& file) { file.vertices = {0, 1, 3}; });
  expect("the label 7, whose color is that of a label before it", [](auto& file) { file.columns[0].values[0] = 7.; });
  expect("the label 8, which is not in the table", [](Surface_file& file) { file.columns[0].values[0] = 8.; });
  expect("the label 0.5, which is not in the table", [](Surface_file& file) { file.columns[0].values[0] = 0.5; });
  expect("Two labels have the key 7", [](Surface_file& file) { file.labels[1].key = 7; });
  for(const std::int32_t key : {-1, (1 << 24) + 1, (std::numeric_limits<std::int32_t>::max)()})
    expect(("The key " + std::to_string(key) + " of a label is not from 0 to 16777216").c_str(),
           [&](Surface_file& file) { file.labels[2].key = key; });
  for(const auto& [component, part] :
      {std::pair(1.5, "component 1.5"), {-0.1, "component -0.1"}, {NAN, "component nan"}})
    for(const std::size_t k : {std::size_t(0), std::size_t(3)})
      expect(part, [&, x = component](Surface_file& file) { file.labels[1].color[k] = x; });
  right.labels[2].key = 1 << 24;
  EXPECT_EQ(read(read_annotation, write_annotation(right)).labels[2].key, 1 << 24);
}

TEST(FreeSurfer_label, reads_some_of_the_vertices)
{
  const std::string content = "#!ascii label  , from subject bert vox2ras=TkReg\n2\n17 -1.5 2 3e1 0.25\n4 0 0 0 nan\n";
  const Surface_file file = read(read_label, content);
  EXPECT_EQ(file.vertices, (std::vector<std::uint32_t>{17, 4}));
  EXPECT_EQ(file.columns.at(0).values.at(0), 0.25);
  expect_same_with_commas([&] { return read(read_label, content).columns.at(0).values.at(0); });
  EXPECT_TRUE(std::isnan(file.columns[0].values.at(1)));
  EXPECT_EQ(read(read_label, "0\n").columns.at(0).values.size(), 0u);

  expect_all_refused(read_label, {{"", "ends before the number of vertices of line 1"},
                                  {"#!ascii label\nmany\n", "Line 2: the number of vertices is 'many'"},
                                  {"#!ascii label\n-2\n", "Line 2: the number of vertices is '-2'"},
                                  {"2000000000\n1 0 0 0 0\n", "too short for 2000000000 vertices"},
                                  {"1\n1.5 0 0 0 0 \n", "Line 2: the vertex is '1.5', which is no integer from 0 on"},
                                  {"1\n-1 0 0 0 0 \n", "Line 2: the vertex is '-1'"},
                                  {"1\n1 0 x 0 0 \n", "Line 2: coordinate y is 'x', which is no number"},
                                  {"1\n1 0 1e999 0 \n", "coordinate y is '1e999'"},
                                  {"1\n1 0 0 0  \n", "ends before the value of line 2"},
                                  {content + "5 0 0 0 0\n", "goes on after 2 vertices with '5'"}});
}

#ifdef TEST_MGH

namespace {

const Reader read_mgh = SP::IO::read_MGH;

std::string mgh_header(std::int32_t type, const std::array<std::int32_t, 4>& dimensions, std::int32_t version = 1)
{
  std::string header = file_of(version, dimensions[0], dimensions[1], dimensions[2], dimensions[3], type);
  header.resize(284);
  return header;
}

Vertex_values column(Vertex_values::Type type, const std::vector<double>& values)
{
  return {"", "", type, values, {}};
}

std::string write_mgh(const Surface_file& file, bool is_packed)
{
  return written([&](auto& out, auto& message) { return SP::IO::write_MGH(out, file, message, is_packed); });
}

} // namespace

TEST(MGH, reads_and_writes_frames_of_each_type)
{
  using Type = Vertex_values::Type;
  const std::vector<std::vector<Vertex_values>> cases = {
      {column(Type::uint8, {0., 255., 7.})},
      {column(Type::int32, {-2147483648., 2147483647., 7.}), column(Type::int32, {1., 2., 3.})},
      {column(Type::float32, {0.5, NAN, -HUGE_VAL}), column(Type::float32, {-0., 1e-40f, 3.})},
  };
  for(const auto& columns : cases)
    for(const bool is_packed : {false, true})
    {
      Surface_file file;
      file.columns = columns;
      const std::string content = write_mgh(file, is_packed);
      EXPECT_EQ(content.substr(0, 2), is_packed ? "\x1F\x8B" : std::string(2, '\0'));
      const Surface_file again = read(read_mgh, content);
      ASSERT_EQ(again.columns.size(), columns.size());
      for(std::size_t k = 0; k < columns.size(); ++k)
      {
        EXPECT_TRUE(are_same(again.columns[k].values, columns[k].values));
        EXPECT_EQ(again.columns[k].type, columns[k].type);
      }
      expect_robust(read_mgh, content);
    }
}

TEST(MGH, reads_short_numbers_and_what_follows)
{
  std::string content = mgh_header(4, {{1, 3, 1, 2}});
  for(const std::int16_t x : std::array<std::int16_t, 6>{1, -2, 3, 4, 5, -32768})
    content += file_of(x);
  const std::size_t end_of_data = content.size();
  content += file_of(1.f, 2.f, 3.f, 4.f, 5.f); // the parameters of the scan
  const std::size_t end_of_parameters = content.size();
  content += file_of(3, 0, 4, std::string("exit"));
  const Surface_file found = read(read_mgh, content);
  ASSERT_EQ(found.columns.size(), 2u);
  EXPECT_TRUE(are_same(found.columns[0].values, {1., -2., 3.}));
  EXPECT_TRUE(are_same(found.columns[1].values, {4., 5., -32768.}));
  EXPECT_EQ(found.columns[0].type, Vertex_values::Type::int32);
  expect_robust(read_mgh, content, {end_of_data, end_of_parameters});
}

TEST(MGH, refuses_what_is_wrong)
{
  using CGAL::Spherical_parameterization::internal::pack;
  const std::string one = mgh_header(3, {{1, 1, 1, 1}}), value(4, '\0'), packed = pack(one + value, true);
  EXPECT_EQ(read(read_mgh, packed).columns.size(), 1u);
  std::string damaged = packed;
  damaged[damaged.size() - 6] = static_cast<char>(damaged[damaged.size() - 6] ^ 1); // of the checksum
  const std::string bomb = mgh_header(3, {{100000000, 1, 1, 1}}) + std::string(100000, '\0');
  expect_all_refused(
      read_mgh, {{"", "ends within the header"},
                 {mgh_header(3, {{1, 1, 1, 1}}, 2), "its version is 2, not 1"},
                 {mgh_header(3, {{0, 1, 1, 1}}) + value, "Byte 4: a dimension is 0"},
                 {mgh_header(3, {{1, -7, 1, 1}}) + value, "Byte 8: a dimension is -7"},
                 {mgh_header(3, {{2147483647, 2147483647, 2, 1}}) + value, "a dimension is 2147483647"},
                 {mgh_header(0, {{1, 1, 1, 70000}}) + std::string(70000, '\0'), "has 70000 values for each vertex"},
                 {mgh_header(6, {{1, 1, 1, 1}}) + value, "the type of the values is number 6"},
                 {one, "too short for 1 vertices and 1 frames"},
                 {mgh_header(3, {{2000000000, 1, 1, 1}}) + value, "too short for 2000000000 vertices"},
                 {one + value + std::string(7, '\0'), "goes on after its data"},
                 {pack(bomb, true), "are to be unpacked to 800000000, which no measurements are"},
                 {pack(one + std::string(5000000, '\0'), true), "The data are longer than the header says"},
                 {packed.substr(0, packed.size() - 1), "The packed data end too early"},
                 {packed + "rest", "The packed data are damaged"},
                 {damaged, "The packed data are damaged"}});
}

TEST(MGH, is_not_written_if_values_would_be_lost)
{
  using Type = Vertex_values::Type;
  const std::vector<std::tuple<std::vector<Vertex_values>, SP::Error_code, const char*>> cases = {
      {{}, SP::ERROR_WRONG_PARAMETER, "There are no values"},
      {{column(Type::float32, {})}, SP::ERROR_WRONG_PARAMETER, "There are no values"},
      {{column(Type::float32, {1.}), column(Type::float32, {1., 2.})}, SP::ERROR_WRONG_PARAMETER, "has 2 values, but"},
      {{column(Type::uint8, {256.})}, SP::ERROR_WRONG_PARAMETER, "The value 256 of vertex 0"},
      {{column(Type::int32, {0.5})}, SP::ERROR_WRONG_PARAMETER, "no integer from -2147483648 to 2147483647"},
      {{column(Type::int32, {NAN})}, SP::ERROR_WRONG_PARAMETER, "The value nan of vertex 0"},
      {{column(Type::float32, {1e39})}, SP::ERROR_OUT_OF_FLOAT_RANGE, "The value 1e+39 of vertex 0"},
      {{column(Type::int32, {16777216.}), column(Type::float32, {0.5}), column(Type::int32, {-16777217.})},
       SP::ERROR_OUT_OF_FLOAT_RANGE,
       "The integer -16777217 of vertex 0 in column '' would lose digits"}};
  for(const auto& [columns, error, part] : cases)
  {
    Surface_file file;
    file.columns = columns;
    const auto write = [&](auto& out, auto& message) { return SP::IO::write_MGH(out, file, message, false); };
    expect_not_written(write, error, part);
  }
  Surface_file some;
  some.columns = {column(Type::float32, {1., 2.})};
  some.vertices = {0, 2};
  const auto write = [&](auto& out, auto& message) { return SP::IO::write_MGH(out, some, message, false); };
  expect_not_written(write, SP::ERROR_WRONG_PARAMETER, "of 2 vertices of a surface, not of all from 0 on");
  some.vertices = {0, 1};
  write_mgh(some, false);
}

#endif
