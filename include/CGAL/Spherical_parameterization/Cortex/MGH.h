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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_MGH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_MGH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Zlib.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/surface_file_checks.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

// The header of an MGH file.
struct Mgh_header
{
  static constexpr std::size_t size = 284; // in bytes

  enum Type : std::int32_t
  {
    uint8 = 0,
    int32 = 1,
    float32 = 3,
    int16 = 4
  };

  explicit Mgh_header(std::string_view content)
  {
    Byte_reader in(content);
    const auto version = in.read<std::int32_t>("the header");
    if(version != 1)
      throw File_error("This is no MGH file of FreeSurfer: its version is ", version, ", not 1.");
    constexpr std::uint64_t max_number = std::uint64_t(1) << 40; // of values in total
    std::array<std::uint64_t, 4> dimensions;
    std::uint64_t n = 1;
    for(std::uint64_t& d : dimensions)
    {
      const auto read = in.read<std::int32_t>("the header");
      d = static_cast<std::uint64_t>(read);
      if(read < 1 || n > max_number / d)
        throw File_error("Byte ", in.position() - sizeof read, ": a dimension is ", read,
                         ", which is not possible: the file is damaged, or no MGH file.");
      n *= d;
    }
    number_of_vertices = static_cast<std::size_t>(dimensions[0] * dimensions[1] * dimensions[2]);
    number_of_frames = static_cast<std::size_t>(dimensions[3]);
    check_number_of_columns(number_of_frames);
    type = in.read<std::int32_t>("the header");
    if(type != uint8 && type != int32 && type != float32 && type != int16)
      throw File_error("Byte 20: the type of the values is number ", type,
                       ", but 0, 1, 3 and 4 are read (uchar, int, float, short): convert the file with mri_convert.");
    in.read_bytes(size - in.position(), "the header");
  }

  std::size_t size_of_value() const { return type == uint8 ? 1 : type == int16 ? 2 : 4; }
  std::size_t size_of_data() const { return number_of_vertices * number_of_frames * size_of_value(); }

  std::size_t number_of_vertices, number_of_frames;
  std::int32_t type;
};

inline void read_mgh(const std::string& content, IO::Surface_file& file, std::string&)
{
  const bool is_packed = is_packed_by_gzip(content);
  const Mgh_header header(is_packed ? unpack(content, Mgh_header::size, true) : content.substr(0, Mgh_header::size));
  std::string unpacked;
  const std::size_t size = Mgh_header::size + header.size_of_data();
  if(is_packed)
  {
    constexpr std::size_t max_footer = std::size_t(1) << 22; // in bytes, for parameters and commands
    check_unpacked_size(header.number_of_vertices * header.number_of_frames * sizeof(double), content.size());
    unpacked = unpack(content, size + max_footer, true);
    if(unpacked.size() > size + max_footer)
      throw File_error("The data are longer than the header says, which are ", header.number_of_vertices,
                       " vertices and ", header.number_of_frames, " frames: it is damaged.");
  }
  Byte_reader in(is_packed ? unpacked : content);
  in.read_bytes(Mgh_header::size, "the header");
  if(in.remaining() < header.size_of_data())
    throw File_error("The file is too short for ", header.number_of_vertices, " vertices and ", header.number_of_frames,
                     " frames: ", truncated);
  const auto read = [&]() -> double {
    switch(header.type)
    {
    case Mgh_header::uint8:
      return in.read<std::uint8_t>("the values");
    case Mgh_header::int16:
      return in.read<std::int16_t>("the values");
    case Mgh_header::int32:
      return in.read<std::int32_t>("the values");
    default:
      return static_cast<double>(in.read<float>("the values"));
    }
  };
  using Type = IO::Vertex_values::Type;
  for(std::size_t k = 0; k < header.number_of_frames; ++k)
  {
    IO::Vertex_values& column = file.columns.emplace_back();
    column.type = header.type == Mgh_header::uint8     ? Type::uint8
                  : header.type == Mgh_header::float32 ? Type::float32
                                                       : Type::int32;
    column.values.reserve(header.number_of_vertices);
    while(column.values.size() < header.number_of_vertices)
      column.values.push_back(read());
  }
  constexpr std::size_t size_of_parameters = 20; // of the scan; may be missing
  if(in.remaining() >= size_of_parameters)
    in.read_bytes(size_of_parameters, "the parameters of the scan");
  check_footer(in);
}

} // namespace internal

namespace IO {

/// \ingroup PkgSphericalParameterizationFiles
///
/// reads values at vertices from an MGH file of FreeSurfer, compressed by gzip (`.mgz`) or not (`.mgh`).
///
/// Each frame becomes a column without a name. All number types are supported: bytes, 16-bit and 32-bit integers, and
/// single precision. Memory is bounded by the size of the file: a compressed file may unpack to at most 32 MB of
/// doubles or 250 times its size, whichever is larger.
///
/// This header requires zlib. It is not included by `CGAL/spherical_parameterization.h`.
///
/// \param in the file, in binary mode
/// \param file receives the contents
/// \param message receives one line that states the error, its location and a remedy; empty if there is no error
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged or has another format; `file` is then unchanged
inline Error_code read_MGH(std::istream& in, Surface_file& file, std::string& message)
{
  return internal::read_or_report(in, file, message, internal::read_mgh);
}

/// \ingroup PkgSphericalParameterizationFiles
///
/// writes values at vertices as an MGH file of FreeSurfer, one frame for each column. The numbers are bytes or 32-bit
/// integers if the types of all columns allow it, and single precision otherwise.
///
/// \param out the file, in binary mode
/// \param file the columns
/// \param message receives one line that states the error; empty with `OK`
/// \param is_packed whether the file is compressed by gzip, as a file with the extension `.mgz` must be
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if there is no column, the columns are empty or of different lengths, a number
///         does not have the type of its column, or `vertices` is neither empty nor 0, 1, 2 and so on;
///         `ERROR_OUT_OF_FLOAT_RANGE` if a number is outside the range of single precision, or an integer that is
///         written in single precision would lose digits; or `ERROR_CANNOT_WRITE_FILE`
inline Error_code write_MGH(std::ostream& out, const Surface_file& file, std::string& message, bool is_packed)
{
  message.clear();
  using Type = Vertex_values::Type;
  const std::size_t n = file.columns.empty() ? 0 : file.columns.front().values.size();
  bool is_whole = true, is_byte = true;
  for(const Vertex_values& column : file.columns)
  {
    if(column.values.size() != n)
      return internal::refuse(message, ERROR_WRONG_PARAMETER, "Column ", internal::in_quotes(column.name), " has ",
                              column.values.size(), " values, but the first one ", n, ".");
    is_whole = is_whole && column.type != Type::float32;
    is_byte = is_byte && column.type == Type::uint8;
  }
  if(n == 0)
    return internal::refuse(message, ERROR_WRONG_PARAMETER, "There are no values, which an MGH file holds.");
  if(const Error_code error = internal::check_consecutive(file.vertices, message); error != OK)
    return error;
  if(const Error_code error = internal::check_columns(file.columns, !is_whole, message); error != OK)
    return error;
  using Header = internal::Mgh_header;
  internal::Byte_writer bytes;
  for(const std::size_t x : {std::size_t(1), n, std::size_t(1), std::size_t(1), file.columns.size()})
    bytes.write(static_cast<std::int32_t>(x)); // version and dimensions
  bytes.write<std::int32_t>(is_byte ? Header::uint8 : is_whole ? Header::int32 : Header::float32);
  bytes.write(std::int32_t(0)); // degrees of freedom
  bytes.write(std::int16_t(1)); // the geometry is valid: spacing, and the default axes of FreeSurfer
  for(const float x : {1.f, 1.f, 1.f, -1.f, 0.f, 0.f, 0.f, 0.f, -1.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f})
    bytes.write(x);
  bytes.content.resize(Header::size);
  for(const Vertex_values& column : file.columns)
    for(const double x : column.values)
      if(is_byte)
        bytes.write(static_cast<std::uint8_t>(x));
      else if(is_whole)
        bytes.write(static_cast<std::int32_t>(x));
      else
        bytes.write(static_cast<float>(x));
  return internal::write_bytes(out, is_packed ? internal::pack(bytes.content, true) : bytes.content, message);
}

} // namespace IO
} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_MGH_H
