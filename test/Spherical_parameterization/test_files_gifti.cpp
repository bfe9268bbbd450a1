// GIFTI files: every encoding, what becomes of damaged ones, and what is written.

#include "locale_of_commas.h"
#include "surface_files.h"

#ifdef TEST_GIFTI

#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Gifti_data.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Zlib.h>

using namespace surface_files;
using CGAL::Spherical_parameterization::internal::from_base64;
using CGAL::Spherical_parameterization::internal::pack;
using CGAL::Spherical_parameterization::internal::to_base64;

namespace {

const Reader read_gifti = SP::IO::read_GIFTI;

std::string write_gifti(const Surface_file& file)
{
  return written([&](auto& out, auto& message) { return SP::IO::write_GIFTI(out, file, message); });
}

// An array with these attributes, and the text of its data
std::string array(const std::string& intent, const std::string& type, const std::string& dimensions,
                  const std::string& encoding, const std::string& data,
                  const std::string& orders = R"(ArrayIndexingOrder="RowMajorOrder" Endian="LittleEndian")",
                  const std::string& metadata = "<MetaData/>")
{
  return "<DataArray Intent=\"NIFTI_INTENT_" + intent + "\" DataType=\"NIFTI_TYPE_" + type + "\" " + dimensions +
         " Encoding=\"" + encoding + "\" " + orders + ">" + metadata + "<Data>" + data + "</Data></DataArray>\n";
}

std::string gifti(
    const std::string& arrays, int n = 1,
    const std::string& type = R"(<!DOCTYPE GIFTI SYSTEM "http://www.nitrc.org/frs/download.php/115/gifti.dtd">)")
{
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + type + "\n<GIFTI Version=\"1.0\" NumberOfDataArrays=\"" +
         std::to_string(n) + "\">\n" + arrays + "</GIFTI>\n";
}

const std::string points_dimensions = R"(Dimensionality="2" Dim0="4" Dim1="3")",
                  values_dimensions = R"(Dimensionality="1" Dim0="4")";

std::string points(const std::string& data = "0 0 0  1 0 0  0 1 0\n0 0 .1e1")
{
  return array("POINTSET", "FLOAT32", points_dimensions, "ASCII", data);
}
std::string triangles(const std::string& data = "0 2 1  0 1 3  1 2 3  2 0 3")
{
  return array("TRIANGLE", "INT32", points_dimensions, "ASCII", data);
}
std::string values(const std::string& type, const std::string& data, const std::string& encoding = "ASCII")
{
  return array("SHAPE", type, values_dimensions, encoding, data);
}

// The bytes of numbers in the order of a file, of the type
std::string bytes_of(const std::vector<double>& numbers, const std::string& type, bool is_big_endian)
{
  Binary_file file(is_big_endian);
  for(const double x : numbers)
    if(type == "FLOAT32")
      file << static_cast<float>(x);
    else if(type == "FLOAT64")
      file << x;
    else if(type == "INT32")
      file << static_cast<std::uint32_t>(static_cast<std::int32_t>(x));
    else if(type == "INT16" || type == "UINT16")
      file << static_cast<std::int16_t>(static_cast<std::int32_t>(x));
    else
      file << static_cast<std::uint8_t>(static_cast<std::int32_t>(x));
  return file.content;
}

std::string in_lines(const std::string& text)
{
  std::string result;
  for(std::size_t k = 0; k < text.size(); ++k)
    result += (k % 7 == 6 ? "\r\n\t" : "") + text.substr(k, 1);
  return result;
}

} // namespace

TEST(GIFTI, reads_each_encoding_type_and_order)
{
  const std::map<std::string, std::vector<double>> cases = {
      {"UINT8", {0., 255., 7., 1., 2., 3.}},
      {"INT8", {-128., 127., 7., 1., 2., 3.}},
      {"INT16", {-32768., 32767., 7., 1., 2., 3.}},
      {"UINT16", {0., 65535., 7., 1., 2., 3.}},
      {"INT32", {-2147483648., 2147483647., 7., 1., 2., 3.}},
      {"FLOAT32", {static_cast<double>(0.1f), -0., static_cast<double>(1e-42f), 3e38f, 2., 3.}},
      {"FLOAT64", {0.1, -0., 1e-310, 1e300, 2., 3.}},
  };
  for(const auto& [type, numbers] : cases)
    for(const bool is_by_column : {false, true})
      for(const bool is_big_endian : {false, true})
        for(const std::string encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
        {
          SCOPED_TRACE(type + (is_by_column ? " by column " : " by row ") + (is_big_endian ? "big " : "little ") +
                       encoding);
          std::vector<double> in_file = numbers; // three vertices, two columns
          if(is_by_column)
            in_file = {numbers[0], numbers[2], numbers[4], numbers[1], numbers[3], numbers[5]};
          std::ostringstream text;
          text.precision(17);
          for(const double x : in_file)
            text << x << ' ';
          const std::string bytes = bytes_of(in_file, type, is_big_endian);
          const std::string data = encoding == "ASCII"          ? text.str()
                                   : encoding == "Base64Binary" ? to_base64(bytes)
                                                                : in_lines(to_base64(pack(bytes, false)));
          const std::string orders = std::string("ArrayIndexingOrder=\"") + (is_by_column ? "Column" : "Row") +
                                     "MajorOrder\" Endian=\"" + (is_big_endian ? "Big" : "Little") + "Endian\"";
          const Surface_file file =
              read(read_gifti,
                   gifti(array("SHAPE", type, R"(Dimensionality="2" Dim0="3" Dim1="2")", encoding, data, orders)));
          ASSERT_EQ(file.columns.size(), 2u);
          EXPECT_EQ(file.columns[0].intent, "NIFTI_INTENT_SHAPE");
          EXPECT_EQ(file.columns[0].name, "1");
          using Type = Vertex_values::Type;
          EXPECT_EQ(file.columns[1].type, type == "UINT8" ? Type::uint8 : type[0] == 'F' ? Type::float32 : Type::int32);
          EXPECT_TRUE(are_same(file.columns[0].values, {numbers[0], numbers[2], numbers[4]}));
          EXPECT_TRUE(are_same(file.columns[1].values, {numbers[1], numbers[3], numbers[5]}));
        }
}

TEST(GIFTI, reads_a_surface)
{
  const Surface_file file = read(read_gifti, gifti(triangles() + points(), 2)); // in any order
  ASSERT_EQ(file.points.size(), 4u);
  EXPECT_EQ(file.points[3], (std::array<double, 3>{0., 0., 1.}));
  EXPECT_EQ(file.triangles.at(3), (std::array<std::uint32_t, 3>{2, 0, 3}));
  EXPECT_TRUE(std::isnan(read(read_gifti, gifti(points("nan inf -Infinity 0 0 0 0 0 0 0 0 0"))).points[0][0]));
  // gzip's header instead of zlib's, Latin letters, and no document type
  const std::string packed = to_base64(pack(bytes_of({1., 2., 3., 4.}, "UINT8", false), true));
  EXPECT_EQ(read(read_gifti, gifti(values("UINT8", packed, "GZipBase64Binary"), 1, "")).columns.at(0).values.at(3), 4.);
  std::string latin = gifti("<MetaData><MD><Name>a</Name><Value>\xE9</Value></MD></MetaData>", 0);
  latin.replace(latin.find("UTF-8"), 5, "ISO-8859-1");
  EXPECT_EQ(read(read_gifti, latin).origin.metadata.at(0).second, "\xC3\xA9");
  // the words that some programs have written
  EXPECT_EQ(read(read_gifti, gifti(array("SHAPE", "INT16", R"(Dimensionality="1" Dim0="1")", "GIFTI_ENCODING_B64BIN",
                                         to_base64(bytes_of({258.}, "INT16", true)),
                                         "Endian=\"GIFTI_ENDIAN_BIG\" ArrayIndexingOrder=\"RowMajorOrder\"")))
                .columns.at(0)
                .values.at(0),
            258.);
  EXPECT_EQ(read(read_gifti, gifti(points(), 3), "The header announces 3 arrays, but there are 1.\n").points.size(),
            4u);
}

std::string indices(const std::string& data)
{
  return array("NODE_INDEX", "INT32", values_dimensions, "ASCII", data);
}

TEST(GIFTI, sorts_values_by_the_indices_of_their_vertices)
{
  for(const auto& [data, vertices] :
      {std::pair("9 8 7 6", std::vector<std::uint32_t>{6, 7, 8, 9}), {"3 2 1 0", {0, 1, 2, 3}}})
    for(const std::string& content :
        {indices(data) + values("UINT8", "1 2 3 4"), values("UINT8", "1 2 3 4") + indices(data)})
    {
      const Surface_file file = read(read_gifti, gifti(content, 2));
      EXPECT_EQ(file.vertices, vertices);
      EXPECT_TRUE(are_same(file.columns.at(0).values, {4., 3., 2., 1.}));
    }
  expect_refused(read_gifti, gifti(indices("1 2 3 1") + values("UINT8", "1 2 3 4"), 2),
                 "The indices of vertices have 1 twice");
  expect_refused(read_gifti, gifti(indices("0 1 2 3") + indices("0 1 2 3"), 2), "line 5): the file has two of them");
  expect_refused(read_gifti, gifti(points() + indices("0 1 2 4"), 2), "have 4, but there are 4 vertices");
  expect_refused(
      read_gifti,
      gifti(array("NODE_INDEX", "INT32", R"(Dimensionality="1" Dim0="0")", "ASCII", "") + values("UINT8", "1 2 3 4"),
            2),
      "it has no index");
}

TEST(GIFTI, takes_labels_for_whole_numbers)
{
  const auto labels = [](const std::string& data) {
    return gifti(array("LABEL", "FLOAT32", values_dimensions, "ASCII", data));
  };
  const Surface_file file = read(read_gifti, labels("3 -7 16777216 0"));
  EXPECT_EQ(file.columns.at(0).type, Vertex_values::Type::int32);
  EXPECT_TRUE(are_same(file.columns[0].values, {3., -7., 16777216., 0.}));
  for(const char* wrong : {"1 2 2.5 3", "1 2 nan 3", "1 2 3e9 3"})
    expect_refused(read_gifti, labels(wrong), "but the keys of labels are 32-bit integers");
}

TEST(GIFTI, writes_all_that_it_reads)
{
  Surface_file file;
  file.points = {
      {{0., 0., 0.}}, {{1., 0., 0.}}, {{0., static_cast<double>(0.1f), 0.}}, {{0., 0., static_cast<double>(1e-42f)}}};
  file.triangles = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};
  file.origin.metadata = {{"Provenance", "a < b && \"c\" ]]> d\n\xC3\xA9"},
                          {"AnatomicalStructurePrimary", "CortexLeft"}};
  file.origin.metadata_of_points = {{"GeometricType", "Spherical"}, {"GeometricType", "twice"}};
  file.origin.metadata_of_triangles = {{"TopologicalType", "Closed"}};
  SP::IO::Coordinate_system system;
  system.data_space = "NIFTI_XFORM_UNKNOWN";
  system.transformed_space = "NIFTI_XFORM_TALAIRACH";
  system.matrix[3] = 0.1;
  system.matrix[7] = -1e-300;
  file.origin.coordinate_systems = {system, {"NIFTI_XFORM_SCANNER_ANAT", "", {}}};
  file.labels = {{0, "???", {{1., 1., 1., 0.}}}, {-7, "a & b", {{1. / 3., 0., 25 / 255., 1.}}}};
  using Type = Vertex_values::Type;
  file.columns = {{"sulc", "NIFTI_INTENT_SHAPE", Type::float32, {0.5, NAN, -HUGE_VAL, 1e-42f}, {{"Date", "today"}}},
                  {"", "NIFTI_INTENT_LABEL", Type::int32, {-7., 0., -7., 2147483647.}, {}},
                  {"mask", "NIFTI_INTENT_NONE", Type::uint8, {0., 1., 255., 1.}, {}}};
  const std::string content = write_gifti(file);
  const Surface_file again = read(read_gifti, content);
  EXPECT_EQ(again.points, file.points);
  EXPECT_EQ(again.triangles, file.triangles);
  EXPECT_EQ(again.origin.metadata, file.origin.metadata);
  EXPECT_EQ(again.origin.metadata_of_points, file.origin.metadata_of_points);
  EXPECT_EQ(again.origin.metadata_of_triangles, file.origin.metadata_of_triangles);
  ASSERT_EQ(again.origin.coordinate_systems.size(), 2u);
  EXPECT_EQ(again.origin.coordinate_systems[0].transformed_space, system.transformed_space);
  EXPECT_EQ(again.origin.coordinate_systems[0].matrix, system.matrix);
  ASSERT_EQ(again.labels.size(), 2u);
  EXPECT_EQ(again.labels[1].key, -7);
  EXPECT_EQ(again.labels[1].name, "a & b");
  EXPECT_EQ(again.labels[1].color, file.labels[1].color);
  ASSERT_EQ(again.columns.size(), 3u);
  for(std::size_t k = 0; k < 3; ++k)
  {
    EXPECT_TRUE(are_same(again.columns[k].values, file.columns[k].values));
    EXPECT_EQ(again.columns[k].name, file.columns[k].name);
    EXPECT_EQ(again.columns[k].intent, file.columns[k].intent);
    EXPECT_EQ(again.columns[k].type, file.columns[k].type);
    EXPECT_EQ(again.columns[k].metadata, file.columns[k].metadata);
  }
  EXPECT_EQ(write_gifti(again), content);
}

TEST(GIFTI, writes_what_XML_can_hold)
{
  Surface_file file;
  file.origin.metadata = {{"controls \1\x7F", "no UTF-8: \xFF \xC0\x80 \xED\xA0\x80 \xE2\x82"}, {"]]>]]>", "]]"}};
  file.columns = {{"a", "\" Encoding=\"", Vertex_values::Type::uint8, {1.}, {}}};
  const Surface_file again = read(read_gifti, write_gifti(file));
  EXPECT_EQ(again.origin.metadata[0].first, "controls ?\x7F");
  EXPECT_EQ(again.origin.metadata[0].second, "no UTF-8: ? ?? ??? ??");
  EXPECT_EQ(again.origin.metadata[1].first, "]]>]]>");
  EXPECT_EQ(again.columns[0].intent, "NIFTI_INTENT_NONE");

  const auto write = [&](auto& out, auto& message) { return SP::IO::write_GIFTI(out, file, message); };
  file.columns[0].values[0] = -1.;
  expect_not_written(write, SP::ERROR_WRONG_PARAMETER,
                     "The value -1 of vertex 0 in column 'a' is no integer from 0 to 255");
  file.columns[0].type = Vertex_values::Type::float32;
  file.columns[0].values[0] = 1e39;
  expect_not_written(write, SP::ERROR_OUT_OF_FLOAT_RANGE, "The value 1e+39 of vertex 0 in column 'a' is too large");
  file.columns[0].values[0] = 1.;
  const Surface_file right = file;
  file.vertices = {7, 7};
  file.columns[0].values = {1., 2.};
  expect_not_written(write, SP::ERROR_WRONG_PARAMETER, "The values are of vertex 7 twice");
  file = right;
  file.labels = {{1, "a", {}}, {1, "b", {}}};
  expect_not_written(write, SP::ERROR_WRONG_PARAMETER, "Two labels have the key 1");
  file.labels = {{1, "a", {{NAN, 0., 0., 0.}}}};
  expect_not_written(write, SP::ERROR_WRONG_PARAMETER, "Label 1 has a color that is not finite");
  file.labels.clear();
  file.columns.clear();
  file.points = {{{1e39, 0., 0.}}};
  expect_not_written(write, SP::ERROR_OUT_OF_FLOAT_RANGE, "Vertex 0 has the coordinate 1e+39");
}

TEST(GIFTI, is_read_and_written_alike_in_every_locale)
{
  Surface_file file = read(read_gifti, gifti(points() + triangles(), 2));
  file.labels = {{1234567, "a", {{0.25, 0.5, 0.75, 1.}}}};
  file.origin.coordinate_systems = {{"a", "b", {}}};
  file.origin.coordinate_systems[0].matrix.fill(1234.5);
  expect_same_with_commas([&] { return write_gifti(file); });
  expect_same_with_commas([&] {
    const Surface_file again = read(read_gifti, write_gifti(file));
    return std::tuple(again.labels.at(0).color, again.origin.coordinate_systems.at(0).matrix,
                      read(read_gifti, gifti(points())).points);
  });
}

TEST(GIFTI, refuses_what_is_wrong)
{
  const auto expect = [](const std::string& content, const std::string& message) {
    SCOPED_TRACE(content);
    expect_refused(read_gifti, content, message);
  };
  const auto of = [](const std::string& dimensions, const std::string& type = "UINT8",
                     const std::string& data = "1 2 3 4", const std::string& encoding = "ASCII") {
    return gifti(array("SHAPE", type, dimensions, encoding, data));
  };
  const auto dimension = [](const std::string& n) { return "Dimensionality=\"1\" Dim0=\"" + n + '"'; };
  const auto in_base64 = [&](const std::string& data, const std::string& encoding = "Base64Binary") {
    return of(values_dimensions, "UINT8", data, encoding);
  };
  const auto in_zlib = [&](const std::string& bytes) { return in_base64(to_base64(bytes), "GZipBase64Binary"); };
  const std::string &four = values_dimensions, two_values = array("SHAPE", "UINT8", dimension("2"), "ASCII", "1 2");
  expect("", "this is no XML that can be read: no element found");
  expect("OFF\n4 4 0\n", "Line 1, column 0: this is no XML");
  expect("<html></html>", "This is an XML file, but no GIFTI file");
  expect(gifti(points() + triangles(), 2).substr(0, 600), "no XML that can be read");
  expect(gifti(points()) + "rest", "junk after document element");
  expect(gifti("", 0) + gifti("", 0), "no XML that can be read");
  expect("<GIFTI NumberOfDataArrays=\"-1\"/>", "Line 1: NumberOfDataArrays is '-1'");
  expect(gifti("<MetaData><MD>"), "mismatched tag");
  // numbers
  expect(gifti(points() + triangles("0 2 1  0 1 3  1 2 3  2 0 4"), 2),
         "Triangle 3 has the corner 4, but there are 4 vertices");
  expect(gifti(points() + triangles("0 2 1  0 1 3  1 2 3  2 0 -1"), 2),
         "Array 1 ('NIFTI_INTENT_TRIANGLE', line 6): it has the index -1, but vertices are counted from 0");
  expect(gifti(triangles()), "Triangle 0 has the corner 0, but there are 0 vertices");
  expect(gifti(points() + points(), 2), "Array 1 ('NIFTI_INTENT_POINTSET', line 6): the file has two of them");
  expect(gifti(array("POINTSET", "FLOAT32", four, "ASCII", "1 2 3 4")), "it has 1 columns, not 3");
  expect(gifti(array("NODE_INDEX", "FLOAT32", four, "ASCII", "1 2 3 4.5")), "it has the index 4.5");
  for(const std::string& others : {points(), values("UINT8", "1 2 3 4")})
    expect(gifti(others + two_values, 2),
           "The values '' are those of 2 vertices, but other arrays of the file are of 4");
  // attributes
  expect(of(R"(Dimensionality="0")"), "Dimensionality is 0, not 1 to 6");
  expect(of(R"(Dimensionality="1")"), "Dim0 is ''");
  expect(of(dimension("-4")), "Dim0 is '-4', which is no number of things");
  expect(of(dimension("4.5")), "Dim0 is '4.5'");
  expect(of(dimension("1e300")), "Dim0 is '1e300'");
  expect(of(R"(Dimensionality="2" Dim0="1000000000" Dim1="1000000000")"), "the dimensions are too large");
  expect(of(R"(Dimensionality="3" Dim0="1" Dim1="2" Dim2="2")"), "it has 3 dimensions");
  expect(of(R"(Dimensionality="2" Dim0="0" Dim1="1000000000000")", "UINT8", ""),
         "has 1000000000000 values for each vertex");
  for(const char* type : {"INT64", "UINT32", "UINT64", "COMPLEX64", "RGB24", ""})
    expect(of(four, type), "the type 'NIFTI_TYPE_" + std::string(type) + "' is not read");
  expect(of(four, "UINT8", "", "ExternalFileBinary"), "another file (ExternalFileBinary), which is not read");
  expect(of(four, "UINT8", "1 2 3 4", "Base85"), "the encoding 'Base85' is unknown");
  expect(gifti(array("SHAPE", "INT32", four, "Base64Binary", to_base64(std::string(16, '\0')),
                     R"(ArrayIndexingOrder="RowMajorOrder" Endian="MiddleEndian")")),
         "an order is 'MiddleEndian', not LittleEndian or BigEndian");
  // texts
  expect(of(four, "UINT8", "1 2 3"), "there are 3 numbers, but the dimensions say 4");
  expect(of(four, "UINT8", "1 2 3 4 5"), "the text goes on after 4 numbers with '5'");
  expect(of(four, "UINT8", "1 2 3 256"), "number 3 is '256', which is none of the type 'NIFTI_TYPE_UINT8'");
  expect(of(four, "INT32", "1 2 3 4.5"), "number 3 is '4.5'");
  expect(of(four, "FLOAT32", "1 2 3 1e39"), "number 3 is '1e39'");
  expect(of(four, "FLOAT32", "1 2 3 0x4"), "number 3 is '0x4'");
  expect(of(dimension("1000000000000")), "the text is too short for 1000000000000 numbers");
  // base 64 and packed data
  const std::string packed = pack(std::string(4, 'x'), false);
  expect(in_base64("AAE*AA=="), "the data have '*' where a digit of base 64 is expected");
  expect(in_base64("AA=AAA=="), "where a digit of base 64 is expected");
  expect(in_base64("AAAAAAA"), "the data in base 64 end too early");
  expect(in_base64("AAAA"), "the data are 3 bytes, but the dimensions say 4");
  expect(in_base64(to_base64("12345")), "the data are more than 4 bytes");
  expect(of(dimension("1000000000000"), "UINT8", "AAAA", "Base64Binary"), "the data are 3 bytes, but");
  expect(in_zlib(pack("123", false)), "the data are 3 bytes, but");
  expect(in_zlib(pack(std::string(1000000, '\0'), false)), "more than 4 bytes");
  expect(of(dimension("100000000"), "UINT8", to_base64(pack(std::string(100000, '\0'), false)), "GZipBase64Binary"),
         "are to be unpacked to 800000000, which no measurements are");
  expect(in_zlib(packed.substr(0, packed.size() - 2)), "packed data end too early");
  expect(in_zlib(packed + "rest"), "4 bytes follow the packed data");
  expect(in_zlib("no data of zlib"), "packed data are damaged");
  // each array is in order, all of them fill the memory
  const std::string zeros = to_base64(pack(std::string(1000000, '\0'), false));
  std::string many;
  for(int k = 0; k < 5; ++k)
    many += array("SHAPE", "UINT8", R"(Dimensionality="1" Dim0="1000000")", "GZipBase64Binary", zeros);
  expect_refused(read_gifti, gifti(many, 5), "Array 4 ('NIFTI_INTENT_SHAPE', line 8): ");
  expect_refused(read_gifti, pack(gifti(many, 5), true), "Array 4 ('NIFTI_INTENT_SHAPE', line 8): ");
  // elements
  expect(gifti("<DataArray Intent=\"a\" Dimensionality=\"1\" Dim0=\"1\"/>"), "Array 0 ('a', line 4): it has no data");
  std::string twice = of(four);
  twice.insert(twice.find("</DataArray>"), "<Data>1 2 3 4</Data>");
  expect(twice, "it has data twice");
  expect(gifti("<DataArray Dimensionality=\"1\" Dim0=\"1\">" + values("UINT8", "1 2 3 4") + "</DataArray>"),
         "an array is within another one");
  std::string deep;
  for(int k = 0; k < 1000000; ++k)
    deep += "<a>";
  expect(gifti(deep), "nested deeper than in any GIFTI file");
  expect(gifti("<LabelTable><Label Key=\"x\">a</Label></LabelTable>", 0), "the key of a label is 'x'");
  for(const std::string color : {"x", "nan", "inf"})
    expect(gifti("<LabelTable><Label Key=\"1\" Red=\"" + color + "\">a</Label></LabelTable>", 0),
           "the color of a label is '" + color + "'");
  expect(gifti("<LabelTable><Label Key=\"1\">a</Label><Label Key=\"1\">b</Label></LabelTable>", 0),
         "two labels have the key 1");
  expect(gifti(array("SHAPE", "UINT8", four, "ASCII", "1 2 3 4",
                     "ArrayIndexingOrder=\"GIFTI_ENDIAN_BIG\" Endian=\"LittleEndian\"")),
         "an order is 'GIFTI_ENDIAN_BIG', not RowMajorOrder or ColumnMajorOrder");
  // what is short in the file, and long in memory
  const auto repeated = [](const std::string& text, int n) {
    std::string result;
    for(int k = 0; k < n; ++k)
      result += text;
    return result;
  };
  std::string many_columns =
      array("SHAPE", "UINT8", R"(Dimensionality="2" Dim0="1" Dim1="10000")", "ASCII", repeated("0 ", 10000),
            R"(ArrayIndexingOrder="RowMajorOrder" Endian="LittleEndian")",
            "<MetaData><MD><Name>a</Name><Value>" + std::string(10000, 'b') + "</Value></MD></MetaData>");
  for(const std::string& content : {many_columns, "<MetaData>" + repeated("<MD/>", 1000000) + "</MetaData>"})
    expect_refused(read_gifti, pack(gifti(content), true), "which no measurements are");
  expect(
      gifti(array("POINTSET", "FLOAT32", points_dimensions, "ASCII", "", "",
                  "<CoordinateSystemTransformMatrix><MatrixData>1 0 0</MatrixData></CoordinateSystemTransformMatrix>")),
      "the matrix has '' instead of one of its 16 numbers");
  // entities that the document type, which is elsewhere, may declare
  expect(of(four, "UINT8", "1&foo;2 2 3 4"),
         "Array 0 ('NIFTI_INTENT_SHAPE', line 4): the entity 'foo' is not declared");
  expect(of(dimension("4&foo;")), "the entity 'foo' is not declared");
  expect(gifti("<LabelTable><Label Key=\"1&amp;&#49;&bar;\">a</Label></LabelTable>", 0),
         "the entity 'bar' is not declared");
  expect(gifti("<MetaData a=\"&quot;&lt;&gt;&apos;&#x41;\"><MD><Name>&lt;&foo;</Name></MD></MetaData>", 0),
         "'foo' is not declared");
  // a document type that declares entities, each of which is ten of the one before
  std::string laughs = "<!DOCTYPE GIFTI [<!ENTITY a0 \"ha\">";
  for(int k = 1; k < 12; ++k)
  {
    laughs += "<!ENTITY a" + std::to_string(k) + " \"";
    for(int i = 0; i < 10; ++i)
      laughs += "&a" + std::to_string(k - 1) + ";";
    laughs += "\">";
  }
  for(const std::string& type : {laughs + "]>", std::string("<!DOCTYPE GIFTI [<!ENTITY a11 SYSTEM \"/etc/passwd\">]>")})
    expect(gifti("<MetaData><MD><Name>&a11;</Name></MD></MetaData>", 0, type),
           "the document type has declarations of its own");
}

TEST(GIFTI, is_robust)
{
  const std::string packed = to_base64(pack(bytes_of({1., 2., 3., 4.}, "FLOAT32", false), false));
  std::string content = gifti(points() + triangles() + values("FLOAT32", packed, "GZipBase64Binary"), 3);
  content.pop_back(); // or the file would be complete without its last byte
  expect_robust(read_gifti, content);
}

#endif
