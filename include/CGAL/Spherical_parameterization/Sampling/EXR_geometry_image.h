// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_EXR_GEOMETRY_IMAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_EXR_GEOMETRY_IMAGE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Geometry_image.h>

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <istream>
#include <iterator>
#include <limits>
#include <new>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

constexpr std::array<const char*, 3> exr_channels = {"R", "G", "B"};

// Returns f(), or `failure` if OpenEXR throws an exception.
template <class Function>
Error_code without_exceptions(Error_code failure, const Function& f)
try
{
  return f();
}
catch(const std::bad_alloc&)
{
  throw;
}
catch(const std::exception&)
{
  return failure;
}

// Whether single precision can represent these values: the largest absolute value is neither out of range nor subnormal.
inline bool are_in_range_of_float(const std::vector<double>& values)
{
  double largest = 0.;
  for(const double x : values)
    largest = (std::max)(largest, std::abs(x));
  using Limits = std::numeric_limits<float>;
  return largest == 0. || (largest >= (Limits::min)() && largest <= (Limits::max)());
}

inline Error_code write_exr(std::ostream& out, const Geometry_image& image)
{
  std::vector<float> pixels(image.values.begin(), image.values.end());
  Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
  Imf::FrameBuffer buffer;
  for(std::size_t i = 0; i < image.number_of_components; ++i)
  {
    const char* const name = image.number_of_components == 3 ? exr_channels[i] : "Y";
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    const std::size_t stride = sizeof(float) * image.number_of_components;
    buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&pixels[i]), stride, stride * image.width));
  }
  Imf::StdOSStream stream; // OpenEXR seeks in its output, which not all streams support
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(buffer);
    file.writePixels(static_cast<int>(image.height));
  }
  return (out << stream.str()).fail() ? ERROR_CANNOT_WRITE_FILE : OK;
}

// Whether the bytes are exactly one list of channels in the OpenEXR format.
inline bool is_list_of_channels(const std::string& bytes)
{
  constexpr std::size_t size_of_channel = 16; // without its name, which is not empty and ends with 0
  std::size_t i = 0;
  while(i < bytes.size() && bytes[i] != '\0')
    i = (std::min)(bytes.find('\0', i), bytes.size()) + 1 + size_of_channel;
  return i + 1 == bytes.size();
}

// Prepares a file for OpenEXR. Returns false unless the file begins like one of a single image in scan lines, and its header
// ends within the file. OpenEXR allocates as much memory as the size fields of attributes, tiles and previews claim, and reads
// attributes of known types without checking their sizes. Hence the attributes that an image needs must have the correct size,
// and all others are given a type that is unknown to OpenEXR, which skips them.
inline bool prepare_exr(std::string& file)
{
  struct Attribute
  {
    const char *name, *type;
    std::size_t size;
  };
  constexpr std::array<Attribute, 7> attributes = {{{"compression", "compression", 1},
                                                    {"dataWindow", "box2i", 16},
                                                    {"displayWindow", "box2i", 16},
                                                    {"lineOrder", "lineOrder", 1},
                                                    {"pixelAspectRatio", "float", 4},
                                                    {"screenWindowCenter", "v2f", 8},
                                                    {"screenWindowWidth", "float", 4}}};
  constexpr std::size_t size_of_beginning = 8; // the magic number, the version 2, and flags
  constexpr char long_names = 4;               // the only flag that is accepted
  if(file.size() < size_of_beginning || file.compare(0, 5, "\x76\x2F\x31\x01\x02") != 0 || (file[5] & ~long_names) != 0)
    return false;
  std::size_t i = size_of_beginning;
  while(i < file.size() && file[i] != '\0')
  {
    const std::size_t end_of_name = file.find('\0', i),
                      end_of_type = file.find('\0', (std::min)(end_of_name, file.size() - 1) + 1);
    if(end_of_type >= file.size() || file.size() - end_of_type < 5)
      return false;
    const std::string name = file.substr(i, end_of_name - i),
                      type = file.substr(end_of_name + 1, end_of_type - end_of_name - 1);
    std::size_t size = 0;
    for(std::size_t k = 4; k > 0; --k)
      size = size << 8 | static_cast<unsigned char>(file[end_of_type + k]);
    i = end_of_type + 5;
    if(size > file.size() - i)
      return false;
    const auto needed =
        std::find_if(attributes.begin(), attributes.end(), [&](const Attribute& a) { return a.name == name; });
    if(name == "channels" ? type != "chlist" || !is_list_of_channels(file.substr(i, size))
                          : needed != attributes.end() && (type != needed->type || size != needed->size))
      return false;
    if(name != "channels" && needed == attributes.end())
      std::fill_n(file.begin() + static_cast<std::ptrdiff_t>(end_of_name + 1), type.size(), 'x');
    i += size;
  }
  return i < file.size();
}

// The header is checked before OpenEXR allocates memory for pixels, and rows are stored as they are read, so that memory is
// bounded by the size of the file.
inline Error_code read_exr(std::istream& in, Geometry_image& image)
{
  std::string content{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if(!prepare_exr(content))
    return ERROR_INVALID_IMAGE_FILE;
  Imf::StdISStream stream;
  stream.str(std::move(content));
  stream.seekg(8);
  Imf::Header header;
  int version = 2;
  header.readFrom(stream, version);
  const Imath::Box2i window = header.dataWindow();
  image.width = static_cast<std::size_t>(std::int64_t(window.max.x) - window.min.x + 1);
  image.height = static_cast<std::size_t>(std::int64_t(window.max.y) - window.min.y + 1);
  if(!Geometry_image_layout::is_size(image.width, image.height))
    return ERROR_INVALID_IMAGE_SIZE;
  std::size_t n_channels = 0;
  for(auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    ++n_channels;
  constexpr std::size_t max_channels = 4; // Each takes memory, and programs add only opacity.
  for(const char* const name : exr_channels)
    if(n_channels > max_channels || !header.channels().findChannel(name))
      return ERROR_INVALID_IMAGE_FILE;

  stream.seekg(0);
  Imf::InputFile file(stream);
  if(!file.isComplete())
    return ERROR_INVALID_IMAGE_FILE;
  std::vector<float> row(3 * image.width);
  for(int y = window.min.y; y <= window.max.y; ++y)
  {
    Imf::FrameBuffer buffer;
    for(std::size_t i = 0; i < 3; ++i)
    {
      constexpr std::size_t stride = 3 * sizeof(float);
      char* const base = reinterpret_cast<char*>(&row[i]) - window.min.x * static_cast<std::ptrdiff_t>(stride);
      buffer.insert(exr_channels[i], Imf::Slice(Imf::FLOAT, base, stride, 0));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(y);
    image.values.insert(image.values.end(), row.begin(), row.end());
  }
  return OK;
}

} // namespace internal

namespace IO {

/// \ingroup PkgSphericalParameterizationSampling
///
/// writes a property of the vertices of a remesh as a <em>geometry image</em>, as `write_PNG_geometry_image()` does, to an OpenEXR
/// file. Values are stored in single precision: points or vectors in the channels R, G and B, numbers in the channel Y.
///
/// This header requires the library OpenEXR, version 3, and is not included by `CGAL/spherical_parameterization.h`.
///
/// The parameters `out`, `remesh` and `map`, of types `TriangleMesh` and `VertexMap`, are those of `write_PNG_geometry_image()`.
///
/// \return the result of `write_PNG_geometry_image()`; or `ERROR_OUT_OF_FLOAT_RANGE` if the largest absolute value is outside the
///         normal range of `float`, unless all values are 0
template <class TriangleMesh, class VertexMap>
Error_code write_EXR_geometry_image(std::ostream& out, const TriangleMesh& remesh, VertexMap map)
{
  internal::Geometry_image image;
  if(const Error_code error = internal::make_geometry_image(remesh, map, image))
    return error;
  if(!internal::are_in_range_of_float(image.values))
    return ERROR_OUT_OF_FLOAT_RANGE;
  return internal::without_exceptions(ERROR_CANNOT_WRITE_FILE, [&] { return internal::write_exr(out, image); });
}

/// \ingroup PkgSphericalParameterizationSampling
///
/// reads a file written by `write_EXR_geometry_image()`, and adds the mesh with these points to `tmesh`. The mesh is closed, has
/// the connectivity of the domain, and has the written coordinates rounded to `float`.
///
/// The parameters `in` and `tmesh`, of a type `TriangleMesh`, are those of `read_PNG_geometry_image()`.
///
/// \return the result of `read_PNG_geometry_image()`; or `ERROR_INVALID_IMAGE_FILE` if the file is damaged, is not an image in
///         scan lines, lacks one of the channels R, G and B, or has more than one additional channel
template <class TriangleMesh>
Error_code read_EXR_geometry_image(std::istream& in, TriangleMesh& tmesh)
{
  internal::Geometry_image image;
  const Error_code error =
      internal::without_exceptions(ERROR_INVALID_IMAGE_FILE, [&] { return internal::read_exr(in, image); });
  return error == OK ? internal::add_mesh_of_geometry_image(image, tmesh) : error;
}

} // namespace IO
} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_EXR_GEOMETRY_IMAGE_H
