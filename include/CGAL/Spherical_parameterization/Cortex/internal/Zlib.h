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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_ZLIB_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_ZLIB_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <new>
#include <string>
#include <string_view>

namespace CGAL::Spherical_parameterization::internal {

// Returns the number of bytes to which a file of this size may unpack, so that it cannot fill the memory. zlib can
// compress a thousand zeros to a byte, but measurements are less repetitive. Values count as doubles.
inline std::size_t max_unpacked_size(std::size_t file_size)
{
  constexpr std::size_t usual_size = std::size_t(1) << 25, usual_factor = 250;
  return (std::max)(usual_size, usual_factor * file_size);
}

// Throws if a file of this size is to be unpacked to more bytes than that.
inline void check_unpacked_size(std::size_t size, std::size_t file_size)
{
  if(size > max_unpacked_size(file_size))
    throw File_error(file_size, " bytes are to be unpacked to ", size,
                     ", which no measurements are: the numbers in the header are wrong, or the file is there to fill "
                     "the memory.");
}

// Returns whether the bytes begin as gzip data do.
inline bool is_packed_by_gzip(std::string_view bytes)
{
  return bytes.substr(0, 2) == "\x1F\x8B";
}

// zlib has 32-bit lengths.
inline uInt length_of_block(std::size_t size)
{
  return static_cast<uInt>((std::min)(size, std::size_t((std::numeric_limits<uInt>::max)())));
}

// A zlib stream, released by `end`.
template <int (*end)(z_streamp)>
struct Zlib_stream : z_stream
{
  Zlib_stream()
    : z_stream()
  {}
  ~Zlib_stream() { end(this); }
  Zlib_stream(const Zlib_stream&) = delete;
  Zlib_stream& operator=(const Zlib_stream&) = delete;
};

// Unpacks data of zlib or gzip, in one stream or, with `has_members`, several. Returns `max_size` + 1 bytes if there
// are more than `max_size`.
inline std::string unpack(std::string_view packed, std::size_t max_size, bool has_members)
{
  constexpr int any_header = 32;
  Zlib_stream<inflateEnd> stream;
  if(inflateInit2(&stream, MAX_WBITS + any_header) != Z_OK)
    throw std::bad_alloc();
  std::string result;
  std::array<char, 1 << 16> block;
  std::size_t position = 0;
  while(result.size() <= max_size)
  {
    const uInt size_in = length_of_block(packed.size() - position),
               size_out = static_cast<uInt>((std::min)(block.size(), max_size + 1 - result.size()));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + position));
    stream.avail_in = size_in;
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = size_out;
    const int status = inflate(&stream, Z_NO_FLUSH);
    position += size_in - stream.avail_in;
    result.append(block.data(), size_out - stream.avail_out);
    if(status == Z_STREAM_END)
    {
      if(position == packed.size())
        return result;
      if(!has_members)
        throw File_error(packed.size() - position, " bytes follow the packed data: the file is damaged.");
      inflateReset(&stream);
    }
    else if(status == Z_BUF_ERROR)
      throw File_error("The packed data end too early: ", truncated);
    else if(status == Z_MEM_ERROR)
      throw std::bad_alloc();
    else if(status != Z_OK)
      throw File_error("The packed data are damaged (", stream.msg != nullptr ? stream.msg : "in an unknown way",
                       "): copy the file again from where it is from.");
  }
  return result;
}

// Compresses bytes by zlib, or by gzip.
inline std::string pack(std::string_view bytes, bool is_gzip)
{
  constexpr int gzip_header = 16, usual_memory = 8;
  Zlib_stream<deflateEnd> stream;
  if(deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS + (is_gzip ? gzip_header : 0), usual_memory,
                  Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string result;
  std::array<char, 1 << 16> block;
  std::size_t position = 0;
  int status = Z_OK;
  while(status != Z_STREAM_END)
  {
    const uInt size_in = length_of_block(bytes.size() - position);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + position));
    stream.avail_in = size_in;
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    status = deflate(&stream, position + size_in == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    position += size_in - stream.avail_in;
    result.append(block.data(), block.size() - stream.avail_out);
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_ZLIB_H
