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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_PNG_GEOMETRY_IMAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_PNG_GEOMETRY_IMAGE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Geometry_image.h>

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <ios>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

// The state of libpng. Its functions report errors by longjmp(). A function that calls them must not construct an object with a
// destructor, so all objects are members.
class Png_file
{
public:
  ~Png_file()
  {
    if(m_out)
      png_destroy_write_struct(&m_png, &m_info);
    else
      png_destroy_read_struct(&m_png, &m_info, nullptr);
  }
  Png_file(const Png_file&) = delete;
  Png_file& operator=(const Png_file&) = delete;

  explicit Png_file(std::ostream& out)
    : m_out(&out)
    , m_png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, ignore))
  {}
  explicit Png_file(std::istream& in)
    : m_in(&in)
    , m_png(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, ignore))
  {}

  // Returns false if the stream fails.
  bool write(const Geometry_image& image)
  {
    const std::size_t n = image.number_of_components;
    m_ranges[0].assign(image.values.begin(), image.values.begin() + static_cast<std::ptrdiff_t>(n));
    m_ranges[1] = m_ranges[0];
    for(std::size_t k = 0; k < image.values.size(); ++k)
    {
      m_ranges[0][k % n] = (std::min)(m_ranges[0][k % n], image.values[k]);
      m_ranges[1][k % n] = (std::max)(m_ranges[1][k % n], image.values[k]);
    }
    for(std::size_t i = 0; i < 2; ++i)
    {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text.precision(std::numeric_limits<double>::max_digits10);
      for(std::size_t k = 0; k < n; ++k)
        text << (k == 0 ? "" : " ") << m_ranges[i][k];
      m_texts[i] = text.str();
    }
    m_row.resize(2 * image.width * n);
    return m_info && is_done([&] { write_all(image); }) && m_out->good();
  }

  // Reads a file. The header is checked before any pixels are read.
  Error_code read(Geometry_image& image)
  {
    const auto read_header = [&] {
      constexpr png_uint_32 max_width = 2 * Sphere_domain_3::max_subdivision + 1;
      png_set_read_fn(m_png, this, get);
      png_set_user_limits(m_png, max_width, 6 * max_width);
      png_set_chunk_malloc_max(m_png, 100000); // bytes; the texts are short
      png_set_chunk_cache_max(m_png, 100);     // texts; each may be compressed by a factor of 1000
      png_set_benign_errors(m_png, 0);         // otherwise, exceeding these limits is only a warning
      png_read_info(m_png, m_info);
    };
    if(!m_info || !is_done(read_header))
      return ERROR_INVALID_IMAGE_FILE;
    image.width = png_get_image_width(m_png, m_info);
    image.height = png_get_image_height(m_png, m_info);
    const std::size_t n = image.number_of_components = png_get_channels(m_png, m_info);
    if(png_get_bit_depth(m_png, m_info) != 16 || png_get_interlace_type(m_png, m_info) != PNG_INTERLACE_NONE ||
       !read_range(0, n) || !read_range(1, n))
      return ERROR_INVALID_IMAGE_FILE;
    if(n != 3 || !Geometry_image_layout::is_size(image.width, image.height))
      return ERROR_INVALID_IMAGE_SIZE;
    m_row.resize(2 * image.width * n);
    for(std::size_t row = 0; row < image.height; ++row) // so that memory is bounded by the size of the stream
    {
      if(!is_done([&] { png_read_row(m_png, m_row.data(), nullptr); }))
        return ERROR_INVALID_IMAGE_FILE;
      for(std::size_t k = 0; k < m_row.size(); k += 2)
      {
        const double t = (256. * m_row[k] + m_row[k + 1]) / max_code;
        image.values.push_back((1. - t) * m_ranges[0][k / 2 % n] + t * m_ranges[1][k / 2 % n]);
      }
    }
    return OK;
  }

private:
  static constexpr double max_code = 65535.; // the largest code of 16 bits

  // Calls f(); returns false if libpng has left it by longjmp().
  template <class Function>
  bool is_done(const Function& f)
  {
    if(setjmp(png_jmpbuf(m_png)))
      return false;
    f();
    return true;
  }

  bool read_range(std::size_t i, std::size_t n)
  {
    png_textp texts = nullptr;
    const int n_texts = png_get_text(m_png, m_info, &texts, nullptr);
    for(int k = 0; k < n_texts; ++k)
      if(std::string(m_keys[i]) == texts[k].key)
      {
        std::istringstream text(texts[k].text);
        text.imbue(std::locale::classic());
        for(double x = 0.; m_ranges[i].size() < n && text >> x;)
          m_ranges[i].push_back(x);
        return m_ranges[i].size() == n;
      }
    return false;
  }

  void write_all(const Geometry_image& image)
  {
    png_set_write_fn(m_png, this, put, flush);
    png_set_IHDR(m_png, m_info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 16,
                 image.number_of_components == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_text texts[2] = {};
    for(std::size_t i = 0; i < 2; ++i)
    {
      texts[i].compression = PNG_TEXT_COMPRESSION_NONE;
      texts[i].key = m_keys[i];
      texts[i].text = &m_texts[i][0];
      texts[i].text_length = m_texts[i].size();
    }
    png_set_text(m_png, m_info, texts, 2);
    png_write_info(m_png, m_info);
    const std::size_t n = image.number_of_components, length = m_row.size() / 2;
    for(std::size_t row = 0; row < image.height; ++row)
    {
      for(std::size_t k = 0; k < length; ++k)
      {
        const double min = m_ranges[0][k % n], max = m_ranges[1][k % n], x = image.values[row * length + k];
        const double t = max > min ? (0.5 * x - 0.5 * min) / (0.5 * max - 0.5 * min) : 0.; // without overflow
        const auto code = static_cast<std::uint32_t>(std::lround(max_code * (std::min)((std::max)(t, 0.), 1.)));
        m_row[2 * k] = static_cast<png_byte>(code >> 8);
        m_row[2 * k + 1] = static_cast<png_byte>(code & 0xFF);
      }
      png_write_row(m_png, m_row.data());
    }
    png_write_end(m_png, nullptr);
  }

  [[noreturn]] static void leave(png_structp png, png_const_charp) { png_longjmp(png, 1); }
  static void ignore(png_structp, png_const_charp) {}
  // A stream that throws has set its state before.
  static void put(png_structp png, png_bytep data, std::size_t n)
  try
  {
    static_cast<Png_file*>(png_get_io_ptr(png))
        ->m_out->write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(n));
  }
  catch(const std::ios_base::failure&)
  {}
  static void flush(png_structp) {}
  static void get(png_structp png, png_bytep data, std::size_t n)
  {
    std::istream& in = *static_cast<Png_file*>(png_get_io_ptr(png))->m_in;
    try
    {
      in.read(reinterpret_cast<char*>(data), static_cast<std::streamsize>(n));
    }
    catch(const std::ios_base::failure&)
    {}
    if(in.fail())
      png_error(png, "");
  }

  std::ostream* m_out = nullptr;
  std::istream* m_in = nullptr;
  png_structp m_png;
  png_infop m_info = m_png ? png_create_info_struct(m_png) : nullptr;
  std::vector<png_byte> m_row;
  char m_keys[2][8] = {"Minimum", "Maximum"};  // the keys of the texts
  std::array<std::string, 2> m_texts;          // the ranges of the values of the image
  std::array<std::vector<double>, 2> m_ranges; // the same, for each component
};

} // namespace internal

namespace IO {

/// \ingroup PkgSphericalParameterizationSampling
///
/// writes a property of the vertices of a remesh as a <em>geometry image</em> \cgalCite{cgal:ggh-gi-02}, a PNG file with
/// 16 bits per component: points or vectors as red, green and blue, numbers as gray.
///
/// - A mesh over `Sphere_domain_3::octahedron(n)` yields \f$ 2 n + 1 \f$ times \f$ 2 n + 1 \f$ pixels: the octahedron is cut open
///   at its lowest vertex, and unfolded to a square \cgalCite{cgal:ph-spr-03}. The highest vertex is at the center, the lowest
///   one at all four corners, x increases to the right, and y increases downwards. The halves of each side represent the same
///   edge, so pixels at the same distance from the middle of a side are equal.
/// - A mesh over `Sphere_domain_3::cube(n)` yields six tiles of \f$ n + 1 \f$ times \f$ n + 1 \f$ pixels, one below the other:
///   the faces at the lowest and highest z, y and x.
///
/// The code \f$ c \f$ of a component represents the value \f$ m + (M - m) c / 65535 \f$. The numbers \f$ m \f$ and \f$ M \f$, one
/// for each component, are stored as texts of the file with the keys `Minimum` and `Maximum`, with all digits. For points, they
/// are the corners of the bounding box.
///
/// This header requires libpng, and is not included by `CGAL/spherical_parameterization.h`.
///
/// \tparam TriangleMesh a model of `VertexListGraph`
/// \tparam VertexMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and as value type `%Point_3` or `%Vector_3` of a
///         \cgal kernel, or a number type
///
/// \param out the output stream, in binary mode
/// \param remesh a mesh computed by `remesh_through_sphere()` with one of these domains
/// \param map the property to write, for example points or normals
///
/// \return `OK`; `ERROR_NO_GEOMETRY_IMAGE_MESH` if no such domain has as many vertices as the mesh;
///         `ERROR_NON_FINITE_COORDINATE` if a value is not finite; or `ERROR_CANNOT_WRITE_FILE` if the stream fails
template <class TriangleMesh, class VertexMap>
Error_code write_PNG_geometry_image(std::ostream& out, const TriangleMesh& remesh, VertexMap map)
{
  internal::Geometry_image image;
  if(const Error_code error = internal::make_geometry_image(remesh, map, image))
    return error;
  return internal::Png_file(out).write(image) ? OK : ERROR_CANNOT_WRITE_FILE;
}

/// \ingroup PkgSphericalParameterizationSampling
///
/// reads a file written by `write_PNG_geometry_image()`, and adds the mesh with these points to `tmesh`. The mesh is closed, has
/// the connectivity of the domain, and each coordinate differs from the written one by at most half a code.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph` with an internal vertex point property map
///
/// \param in the input stream, in binary mode
/// \param tmesh receives the mesh
///
/// \return `OK`; `ERROR_INVALID_IMAGE_FILE` if the file is damaged, is not a PNG file with 16 bits, or lacks the texts;
///         `ERROR_INVALID_IMAGE_SIZE` if it has the size of no such image, or does not have three components;
///         `ERROR_NON_FINITE_COORDINATE` if a coordinate is not finite; or `ERROR_NON_MATCHING_BOUNDARY` if pixels that
///         represent the same vertex differ. Nothing is added if an error is returned.
template <class TriangleMesh>
Error_code read_PNG_geometry_image(std::istream& in, TriangleMesh& tmesh)
{
  internal::Geometry_image image;
  const Error_code error = internal::Png_file(in).read(image);
  return error == OK ? internal::add_mesh_of_geometry_image(image, tmesh) : error;
}

} // namespace IO
} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_PNG_GEOMETRY_IMAGE_H
