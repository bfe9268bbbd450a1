// A geometry image has the layout of its documentation, other programs see the values in it, and it gives the mesh back that
// it was made of; what is damaged gives an error and no mesh.

#include "locale_of_commas.h"
#include "methods.h"

#include <CGAL/Spherical_parameterization/Sampling/remesh_through_sphere.h>

#ifdef TEST_PNG
#include <CGAL/Spherical_parameterization/Sampling/PNG_geometry_image.h>

#include <png.h>
#endif
#ifdef TEST_EXR
#include <CGAL/Spherical_parameterization/Sampling/EXR_geometry_image.h>

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#endif
#include <CGAL/Spherical_parameterization/Sampling/internal/Geometry_image.h>

#include <sys/resource.h>

using namespace test;

namespace {

using Layout = SP::internal::Geometry_image_layout;
using Vertex_index = Mesh::Vertex_index;

// Pixels that are next to each other show vertices with an edge, and each vertex is shown.
void expect_regular(const Layout& layout, const SP::Sphere_domain_3& domain, std::size_t tile_height)
{
  EXPECT_EQ(layout.triangles, domain.triangles());
  EXPECT_EQ(layout.number_of_vertices, domain.directions().size());
  std::set<std::array<std::uint32_t, 2>> edges;
  for(const auto& t : domain.triangles())
    for(std::size_t i = 0; i < 3; ++i)
      edges.insert({t[i], t[(i + 1) % 3]});
  const auto& v = layout.vertices;
  ASSERT_EQ(v.size(), layout.width * layout.height);
  for(std::size_t k = 0; k < v.size(); ++k)
  {
    EXPECT_TRUE((k + 1) % layout.width == 0 || edges.count({v[k], v[k + 1]}) > 0) << k;
    EXPECT_TRUE(k / layout.width % tile_height + 1 == tile_height || edges.count({v[k], v[k + layout.width]}) > 0) << k;
  }
  EXPECT_EQ(std::set<std::uint32_t>(v.begin(), v.end()).size(), domain.directions().size());
}

TEST(Layout, of_an_octahedron)
{
  for(const std::size_t n : {1u, 2u, 5u})
  {
    const std::size_t last = 2 * n;
    const SP::Sphere_domain_3 domain = SP::Sphere_domain_3::octahedron(static_cast<std::uint32_t>(n));
    const Layout layout = Layout::of_size(last + 1, last + 1).value();
    EXPECT_EQ(layout.height, layout.width);
    expect_regular(layout, domain, last + 1);
    const auto direction = [&](std::size_t column, std::size_t row) {
      return domain.directions()[layout.vertices[row * layout.width + column]];
    };
    EXPECT_LT(CGAL::squared_distance(direction(n, n), Point_3(0, 0, 1)), 1e-30);
    EXPECT_LT(CGAL::squared_distance(direction(last, n), Point_3(1, 0, 0)), 1e-30);
    EXPECT_LT(CGAL::squared_distance(direction(n, last), Point_3(0, 1, 0)), 1e-30);
    EXPECT_LT(CGAL::squared_distance(direction(last, 0), Point_3(0, 0, -1)), 1e-30);
    for(std::size_t i = 0; i <= last; ++i)
      for(const std::size_t side : {std::size_t(0), last})
      {
        EXPECT_EQ(direction(i, side), direction(last - i, side));
        EXPECT_EQ(direction(side, i), direction(side, last - i));
      }
  }
}

TEST(Layout, of_a_cube)
{
  for(const std::size_t n : {1u, 2u, 5u})
  {
    const SP::Sphere_domain_3 domain = SP::Sphere_domain_3::cube(static_cast<std::uint32_t>(n));
    const Layout layout = Layout::of_size(n + 1, 6 * (n + 1)).value();
    expect_regular(layout, domain, n + 1);
    for(std::size_t k = 0; k < layout.vertices.size(); ++k)
    {
      const Point_3 p = domain.directions()[layout.vertices[k]];
      const std::size_t face = k / (n + 1) / (n + 1), axis = 2 - face / 2;
      EXPECT_GE((face % 2 == 0 ? -1. : 1.) * p[static_cast<int>(axis)], 1. / std::sqrt(3.) - 1e-15) << k;
    }
  }
}

TEST(Layout, of_sizes_that_no_image_has)
{
  for(const auto& [width, height] : std::vector<std::pair<std::size_t, std::size_t>>{
          {0, 0}, {1, 1}, {1, 6}, {2, 2}, {4, 4}, {5, 6}, {3, 9}, {10003, 10003}, {5002, 6 * 5002}})
    EXPECT_FALSE(Layout::of_size(width, height)) << width << ' ' << height;
  for(const std::size_t n : {0u, 1u, 2u, 3u, 7u, 19u})
    EXPECT_FALSE(Layout::of_vertices(n)) << n;
}

// A surface over a domain: a sphere that is stretched and moved.
struct Sampled
{
  explicit Sampled(const SP::Sphere_domain_3& domain)
    : sphere(remesh.add_property_map<Vertex_index, Point_3>("v:sphere").first)
    , normals(remesh.add_property_map<Vertex_index, Kernel::Vector_3>("v:normal").first)
    , heights(remesh.add_property_map<Vertex_index, float>("v:height").first)
  {
    const Mesh surface = make(scaled(icosphere(3), 3., 2., 1e-3)), images = make(icosphere(3));
    EXPECT_EQ(SP::remesh_through_sphere(surface, images.points(), domain, remesh, sphere,
                                        CGAL::parameters::default_values(),
                                        CGAL::parameters::vertex_normal_map(normals)),
              SP::OK);
    for(const Vertex_index v : remesh.vertices())
    {
      remesh.point(v) = remesh.point(v) + Kernel::Vector_3(100., -5., 0.);
      heights[v] = static_cast<float>(remesh.point(v).y());
    }
  }

  Mesh remesh;
  Mesh::Property_map<Vertex_index, Point_3> sphere;
  Mesh::Property_map<Vertex_index, Kernel::Vector_3> normals;
  Mesh::Property_map<Vertex_index, float> heights;
};

// A format: how its files are written and read, and how far a coordinate may move, over the size of the box.
template <class Write, class Read>
struct Format
{
  Write write;
  Read read;
  Coordinates tolerance;
};
template <class Write, class Read>
Format(Write, Read, Coordinates) -> Format<Write, Read>;

template <class F>
void expect_round_trip(const F& format)
{
  for(const SP::Sphere_domain_3& domain : {SP::Sphere_domain_3::octahedron(1), SP::Sphere_domain_3::octahedron(8),
                                           SP::Sphere_domain_3::cube(1), SP::Sphere_domain_3::cube(5)})
  {
    const Sampled sampled(domain);
    std::stringstream file;
    ASSERT_EQ(format.write(file, sampled.remesh, sampled.remesh.points()), SP::OK);
    Mesh again = make(tetrahedron());
    ASSERT_EQ(format.read(file, again), SP::OK);
    ASSERT_EQ(again.number_of_vertices(), 4 + sampled.remesh.number_of_vertices());
    EXPECT_TRUE(CGAL::is_closed(again));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(again));
    std::vector<Triangle> expected = triangles(make(tetrahedron()));
    for(const Triangle& t : triangles(sampled.remesh))
      expected.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    EXPECT_EQ(triangles(again), expected);
    for(const Vertex_index v : sampled.remesh.vertices())
      for(int k = 0; k < 3; ++k)
        ASSERT_NEAR(again.point(Vertex_index(v + 4))[k], sampled.remesh.point(v)[k],
                    format.tolerance[static_cast<std::size_t>(k)]);
  }
}

// What others see in an image: decoded by the libraries of the formats, without the reader of the package.
// The channels are one by one, row by row.
struct Decoded_image
{
  std::size_t width = 0, height = 0;
  std::vector<std::vector<double>> channels;
};

// Each channel has its component of the value of the vertex that the pixel shows, up to a tolerance.
template <class Value>
void expect_values(const Decoded_image& image, const Layout& layout, const Mesh& mesh, const Value& value_of,
                   std::size_t n_channels, const Coordinates& tolerance)
{
  ASSERT_EQ(image.width, layout.width);
  ASSERT_EQ(image.height, layout.height);
  ASSERT_EQ(image.channels.size(), n_channels);
  ASSERT_EQ(mesh.number_of_vertices(), layout.number_of_vertices);
  for(std::size_t c = 0; c < n_channels; ++c)
    for(std::size_t k = 0; k < layout.vertices.size(); ++k)
      ASSERT_NEAR(image.channels[c].at(k), value_of(Vertex_index(layout.vertices[k]), c), tolerance[c])
          << c << ' ' << k;
}

// Of files that decode(content) takes apart: points, normals and numbers, over an octahedron and a cube.
template <class F, class Decode>
void expect_decoded(const F& format, const Decode& decode, double tolerance_of_normals)
{
  for(const bool is_cube : {false, true})
  {
    const Sampled sampled(is_cube ? SP::Sphere_domain_3::cube(3) : SP::Sphere_domain_3::octahedron(4));
    const Layout layout = is_cube ? Layout::of_cube(3) : Layout::of_octahedron(4);
    const Mesh& mesh = sampled.remesh;
    const auto expect = [&](const auto& map, const auto& value_of, std::size_t n, const Coordinates& tolerance) {
      std::stringstream file;
      ASSERT_EQ(format.write(file, mesh, map), SP::OK);
      expect_values(decode(file.str()), layout, mesh, value_of, n, tolerance);
    };
    const double t = tolerance_of_normals;
    expect(
        mesh.points(), [&](Vertex_index v, std::size_t c) { return mesh.point(v)[static_cast<int>(c)]; }, 3,
        format.tolerance);
    expect(sampled.normals, [&](Vertex_index v, std::size_t c) { return sampled.normals[v][static_cast<int>(c)]; }, 3,
           {t, t, t});
    expect(sampled.heights, [&](Vertex_index v, std::size_t) { return static_cast<double>(sampled.heights[v]); }, 1,
           {format.tolerance[1], 0., 0.});
  }
}

template <class F>
void expect_errors(const F& format)
{
  const Sampled sampled(SP::Sphere_domain_3::octahedron(3));
  Mesh mesh;
  std::stringstream file;
  ASSERT_EQ(format.write(file, sampled.remesh, sampled.remesh.points()), SP::OK);
  const std::string content = file.str();
  for(std::size_t n = 0; n + 20 < content.size(); n += 7) // what comes last need not be read
  {
    std::istringstream part(content.substr(0, n));
    EXPECT_EQ(format.read(part, mesh), SP::ERROR_INVALID_IMAGE_FILE) << n;
  }
  for(std::size_t n = 0; n < content.size(); ++n) // which may go unnoticed, or be a size
  {
    std::string damaged = content;
    damaged[n] = static_cast<char>(damaged[n] ^ 0x55);
    std::istringstream in(damaged);
    Mesh any;
    if(format.read(in, any) == SP::OK)
      EXPECT_TRUE(CGAL::is_closed(any)) << n;
    else
      EXPECT_EQ(any.number_of_vertices(), 0u) << n;
  }

  // Numbers alone are no surface.
  std::stringstream grey;
  ASSERT_EQ(format.write(grey, sampled.remesh, sampled.heights), SP::OK);
  EXPECT_NE(format.read(grey, mesh), SP::OK);
  EXPECT_EQ(mesh.number_of_vertices(), 0u);

  std::ofstream nowhere;
  EXPECT_EQ(format.write(nowhere, sampled.remesh, sampled.normals), SP::ERROR_CANNOT_WRITE_FILE);
  const Mesh other = make(icosphere(0));
  std::stringstream empty;
  EXPECT_EQ(format.write(empty, other, other.points()), SP::ERROR_NO_GEOMETRY_IMAGE_MESH);
  Sampled infinite(SP::Sphere_domain_3::octahedron(3));
  infinite.remesh.point(Vertex_index(5)) = Point_3(0., std::numeric_limits<double>::infinity(), 0.);
  EXPECT_EQ(format.write(empty, infinite.remesh, infinite.remesh.points()), SP::ERROR_NON_FINITE_COORDINATE);
  EXPECT_TRUE(empty.str().empty());
}

template <class F, class Write_image>
void expect_errors_of_images(const F& format, const Write_image& write_image)
{
  const auto expect = [&](const SP::internal::Geometry_image& image, SP::Error_code error) {
    std::stringstream file;
    ASSERT_TRUE(write_image(file, image));
    Mesh mesh;
    EXPECT_EQ(format.read(file, mesh), error);
    EXPECT_EQ(mesh.number_of_vertices(), 0u);
  };
  expect({4, 4, 3, std::vector<double>(48, 1.)}, SP::ERROR_INVALID_IMAGE_SIZE);
  expect({3, 5, 3, std::vector<double>(45, 1.)}, SP::ERROR_INVALID_IMAGE_SIZE);
  SP::internal::Geometry_image image = {3, 3, 3, std::vector<double>(27, 1.)};
  image.values[1] = 0.;
  expect(image, SP::ERROR_NON_MATCHING_BOUNDARY);
}

#ifdef TEST_PNG
// A PNG file, with the functions of libpng that read a file at once
Decoded_image decode_png(const std::string& content)
{
  Decoded_image result;
  png_structp reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(reader);
  std::istringstream in(content);
  png_set_read_fn(reader, &in, [](png_structp p, png_bytep data, std::size_t n) {
    static_cast<std::istream*>(png_get_io_ptr(p))->read(reinterpret_cast<char*>(data), static_cast<std::streamsize>(n));
  });
  png_read_png(reader, info, PNG_TRANSFORM_IDENTITY, nullptr);
  EXPECT_EQ(png_get_bit_depth(reader, info), 16);
  result.width = png_get_image_width(reader, info);
  result.height = png_get_image_height(reader, info);
  result.channels.resize(png_get_channels(reader, info));

  std::map<std::string, std::vector<double>> ranges;
  png_textp texts = nullptr;
  const int n_texts = png_get_text(reader, info, &texts, nullptr);
  for(int i = 0; i < n_texts; ++i)
  {
    std::istringstream text(texts[i].text);
    for(double x = 0.; text >> x;)
      ranges[texts[i].key].push_back(x);
  }
  for(std::size_t c = 0; c < result.channels.size(); ++c)
    for(std::size_t row = 0; row < result.height; ++row)
      for(std::size_t column = 0; column < result.width; ++column)
      {
        const png_bytep bytes = png_get_rows(reader, info)[row] + 2 * (column * result.channels.size() + c);
        const double code = 256. * bytes[0] + bytes[1], min = ranges["Minimum"].at(c), max = ranges["Maximum"].at(c);
        result.channels[c].push_back(min + (max - min) * code / 65535.);
      }
  png_destroy_read_struct(&reader, &info, nullptr);
  return result;
}

const Format png = {
    [](auto& out, const auto&... arguments) { return SP::IO::write_PNG_geometry_image(out, arguments...); },
    [](auto& in, Mesh& mesh) { return SP::IO::read_PNG_geometry_image(in, mesh); },
    Coordinates{6.01 / 65535. / 2., 4.01 / 65535. / 2., 2.01e-3 / 65535. / 2.}};

TEST(Png_image, shows_the_values_to_others)
{
  expect_decoded(png, decode_png, 2.01 / 65535. / 2.);
}

TEST(Png_image, gives_the_mesh_back)
{
  expect_round_trip(png);
}

TEST(Png_image, is_read_and_written_alike_in_every_locale)
{
  const Sampled sampled(SP::Sphere_domain_3::octahedron(4));
  expect_same_with_commas([&] {
    std::stringstream file;
    EXPECT_EQ(png.write(file, sampled.remesh, sampled.remesh.points()), SP::OK);
    const std::string bytes = file.str();
    Mesh mesh;
    EXPECT_EQ(png.read(file, mesh), SP::OK);
    return std::pair(bytes, std::vector<Point_3>(mesh.points().begin(), mesh.points().end()));
  });
}

TEST(Png_image, is_refused_if_it_is_none)
{
  expect_errors(png);
  expect_errors_of_images(png, [](std::ostream& out, const SP::internal::Geometry_image& image) {
    return SP::internal::Png_file(out).write(image);
  });
}

// Before the pixels, which a small file may have many of.
TEST(Png_image, is_refused_by_its_header)
{
  std::ostringstream out;
  SP::internal::Geometry_image image = {40, 41, 3, {}};
  for(std::size_t k = 0; k < 3 * image.width * image.height; ++k)
    image.values.push_back(std::sin(static_cast<double>(k * k))); // which does not compress
  ASSERT_TRUE(SP::internal::Png_file(out).write(image));
  std::istringstream in(out.str().substr(0, out.str().size() / 2)); // the other half is pixels as well
  Mesh mesh;
  EXPECT_EQ(png.read(in, mesh), SP::ERROR_INVALID_IMAGE_SIZE);
}

// A file that the functions of libpng write with three channels, each pixel the same, and the texts
std::string any_png(int bit_depth, int color_type, int interlace, int n_more_texts = 0)
{
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(writer);
  std::ostringstream out;
  png_set_write_fn(
      writer, &out,
      [](png_structp p, png_bytep data, std::size_t n) {
        static_cast<std::ostream*>(png_get_io_ptr(p))->write(reinterpret_cast<char*>(data), std::streamsize(n));
      },
      [](png_structp) {});
  png_set_IHDR(writer, info, 3, 3, bit_depth, color_type, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if(color_type == PNG_COLOR_TYPE_PALETTE)
  {
    const png_color black = {0, 0, 0};
    png_set_PLTE(writer, info, &black, 1);
  }
  char keys[2][8] = {"Minimum", "Maximum"}, range[] = "1 2 3 4";
  std::string long_text(99000, 'x'), key = "Comment";
  std::vector<png_text> texts(2 + static_cast<std::size_t>(n_more_texts), png_text());
  for(std::size_t k = 0; k < texts.size(); ++k)
  {
    texts[k].compression = k < 2 ? PNG_TEXT_COMPRESSION_NONE : PNG_TEXT_COMPRESSION_zTXt;
    texts[k].key = k < 2 ? keys[k] : &key[0];
    texts[k].text = k < 2 ? range : &long_text[0];
    texts[k].text_length = k < 2 ? 7 : long_text.size();
  }
  png_set_text(writer, info, texts.data(), static_cast<int>(texts.size()));
  png_write_info(writer, info);
  std::vector<png_byte> row(3 * 8, 0);
  for(int pass = png_set_interlace_handling(writer); pass > 0; --pass)
    for(int y = 0; y < 3; ++y)
      png_write_row(writer, row.data());
  png_write_end(writer, nullptr);
  png_destroy_write_struct(&writer, &info);
  return out.str();
}

// Only one kind of file is no other program's.
TEST(Png_image, has_three_channels_of_16_bits)
{
  const auto read = [](const std::string& content) {
    std::istringstream in(content);
    Mesh mesh;
    return png.read(in, mesh);
  };
  EXPECT_EQ(read(any_png(16, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE)), SP::OK);
  EXPECT_EQ(read(any_png(16, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, 20)), SP::OK);
  EXPECT_EQ(read(any_png(8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE)), SP::ERROR_INVALID_IMAGE_FILE);
  EXPECT_EQ(read(any_png(16, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_ADAM7)), SP::ERROR_INVALID_IMAGE_FILE);
  EXPECT_EQ(read(any_png(16, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE)), SP::ERROR_INVALID_IMAGE_SIZE);
  EXPECT_EQ(read(any_png(16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE)), SP::ERROR_INVALID_IMAGE_SIZE);
  EXPECT_EQ(read(any_png(8, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE)), SP::ERROR_INVALID_IMAGE_FILE);
  const std::string packed = any_png(16, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, 900); // 89 MB of texts
  EXPECT_LT(packed.size(), 300000u);
  EXPECT_EQ(read(packed), SP::ERROR_INVALID_IMAGE_FILE);
}

// The width of the range is beyond that of numbers.
TEST(Png_image, holds_the_largest_numbers)
{
  Sampled sampled(SP::Sphere_domain_3::octahedron(1));
  constexpr double max = (std::numeric_limits<double>::max)();
  for(const Vertex_index v : sampled.remesh.vertices())
    sampled.remesh.point(v) = Point_3(v == Vertex_index(0) ? -max : max, 0., 0.);
  std::stringstream file;
  ASSERT_EQ(png.write(file, sampled.remesh, sampled.remesh.points()), SP::OK);
  Mesh again;
  ASSERT_EQ(png.read(file, again), SP::OK);
  EXPECT_EQ(points(again), points(sampled.remesh));
}
#endif

#ifdef TEST_EXR
// An OpenEXR file, with the channels and the order of the rows that the file says
Decoded_image decode_exr(const std::string& content)
{
  const char* const name = "decoded.exr";
  std::ofstream(name, std::ios::binary) << content;
  Imf::InputFile file(name);
  const Imath::Box2i window = file.header().dataWindow();
  Decoded_image result;
  result.width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  result.height = static_cast<std::size_t>(window.max.y - window.min.y + 1);
  const bool is_grey = file.header().channels().findChannel("Y") != nullptr;
  for(const char* const channel : is_grey ? std::vector<const char*>{"Y"} : std::vector<const char*>{"R", "G", "B"})
  {
    EXPECT_NE(file.header().channels().findChannel(channel), nullptr);
    std::vector<float> pixels(result.width * result.height);
    Imf::FrameBuffer buffer;
    buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, pixels.data(), window));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    result.channels.emplace_back(pixels.begin(), pixels.end());
  }
  return result;
}

// How many more bytes of memory the program has had at once by the end of f() than before it, in rough
template <class F>
double additional_memory(const F& f)
{
  const auto peak = [] {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return 1024. * static_cast<double>(usage.ru_maxrss); // it is in kilobytes, but on macOS, where it is more then
  };
  const double before = peak();
  f();
  return peak() - before;
}

const Format exr = {
    [](auto& out, const auto&... arguments) { return SP::IO::write_EXR_geometry_image(out, arguments...); },
    [](auto& in, Mesh& mesh) { return SP::IO::read_EXR_geometry_image(in, mesh); },
    Coordinates{103. * 6e-8, 7. * 6e-8, 1e-3 * 6e-8}};

TEST(Exr_image, shows_the_values_to_others)
{
  expect_decoded(exr, decode_exr, 6e-8);
}

TEST(Exr_image, gives_the_mesh_back)
{
  expect_round_trip(exr);
}

TEST(Exr_image, is_refused_if_it_is_none)
{
  expect_errors(exr);
  expect_errors_of_images(exr, [](std::ostream& out, const SP::internal::Geometry_image& image) {
    return SP::internal::write_exr(out, image) == SP::OK;
  });

  // What is only claimed costs no memory.
  const Sampled sampled(SP::Sphere_domain_3::octahedron(3));
  std::stringstream file;
  ASSERT_EQ(exr.write(file, sampled.remesh, sampled.remesh.points()), SP::OK);
  const auto bytes = [](const std::vector<std::int32_t>& numbers) {
    return std::string(reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size());
  };
  const auto attribute = [&](const std::string& name, const std::string& type, std::int32_t size) {
    return name + '\0' + type + '\0' + bytes({size});
  };
  const auto changed = [&](const std::string& beginning, const std::string& values) {
    std::string content = file.str();
    return content.replace(content.find(beginning) + beginning.size(), values.size(), values);
  };
  const auto with_first = [&](const std::string& more) { return file.str().insert(8, more); };
  const auto expect_read = [&](const std::string& content, SP::Error_code error) {
    Mesh mesh;
    std::istringstream in(content);
    EXPECT_LT(additional_memory([&] { EXPECT_EQ(exr.read(in, mesh), error); }), 5e7);
  };
  // OpenEXR reads four bytes of this attribute, whatever its length, and would take the others for one of 1.9 GB.
  const std::string hidden = attribute("b", "unknown", 1900000000);
  const std::string longer =
      attribute("a", "float", static_cast<std::int32_t>(4 + hidden.size())) + bytes({0}) + hidden;
  std::string prepared = with_first(longer);
  EXPECT_TRUE(SP::internal::prepare_exr(prepared));
  EXPECT_EQ(prepared.substr(8, 8), std::string("a\0xxxxx\0", 8));
  expect_read(changed("pixelAspectRatio" + std::string(1, '\0'), "v2f" + std::string(3, '\0')),
              SP::ERROR_INVALID_IMAGE_FILE);
  const std::string window = attribute("dataWindow", "box2i", 16);
  expect_read(changed(window, bytes({0, 0, 10000, 10000})), SP::ERROR_INVALID_IMAGE_FILE);
  expect_read(changed(window, bytes({0, 0, 100000000, 4})), SP::ERROR_INVALID_IMAGE_SIZE);
  expect_read(changed(window, bytes({-2147483647, -2147483647, 2147483647, 2147483647})), SP::ERROR_INVALID_IMAGE_SIZE);
  expect_read(with_first(attribute("preview", "preview", 4 * 300000000 + 8) + bytes({30000, 10000})),
              SP::ERROR_INVALID_IMAGE_FILE);
  expect_read(with_first(attribute("other", "mine", 2000000000)), SP::ERROR_INVALID_IMAGE_FILE);
  std::string channels;
  for(const char* const name : {"A", "B", "G", "R", "Z"})
    channels += name + ('\0' + bytes({2, 0, 1, 1}));
  std::string content = file.str();
  const std::string old_channels = attribute("channels", "chlist", 3 * 18 + 1);
  content.replace(content.find(old_channels), old_channels.size() + 3 * 18,
                  attribute("channels", "chlist", 5 * 18 + 1) + channels);
  expect_read(content, SP::ERROR_INVALID_IMAGE_FILE);
  content = file.str();
  content[5] = 2; // tiles
  expect_read(content, SP::ERROR_INVALID_IMAGE_FILE);
}

// Silently, the surface would become a point, or be elsewhere.
TEST(Exr_image, has_no_values_that_a_float_cannot_hold)
{
  const auto write = [](double scale) {
    Sampled sampled(SP::Sphere_domain_3::octahedron(1));
    for(const Vertex_index v : sampled.remesh.vertices())
      sampled.remesh.point(v) = CGAL::ORIGIN + scale * (sampled.remesh.point(v) - CGAL::ORIGIN);
    std::stringstream file;
    const SP::Error_code error = exr.write(file, sampled.remesh, sampled.remesh.points());
    EXPECT_EQ(error == SP::OK, !file.str().empty());
    return error;
  };
  for(const double scale : {0., 1e-39, 1e-30, 1e30, 1e36})
    EXPECT_EQ(write(scale), SP::OK) << scale;
  for(const double scale : {1e-300, 1e-41, 1e37, 1e300})
    EXPECT_EQ(write(scale), SP::ERROR_OUT_OF_FLOAT_RANGE) << scale;
}
#endif

} // namespace
