#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_DECODED_IMAGES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_DECODED_IMAGES_H

// What others see in an image: decoded by the libraries of the formats, without the reader of the package.

#include "standard_library.h"

#ifdef TEST_PNG
#include <png.h>
#endif
#ifdef TEST_EXR
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#endif

#include <gtest/gtest.h>

namespace test {

// The channels one by one, row by row
struct Decoded_image
{
  std::size_t width = 0, height = 0;
  std::vector<std::vector<double>> channels;
};

#ifdef TEST_PNG
// A PNG file, with the functions of libpng that read a file at once
inline Decoded_image decode_png(const std::string& content)
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
#endif

#ifdef TEST_EXR
// An OpenEXR file, with the channels and the order of the rows that the file says
inline Decoded_image decode_exr(const std::string& content)
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
#endif

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_DECODED_IMAGES_H
