// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_READ_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_READ_SOUP_H

#include "Polygon_soup.h"
#include "Program_error.h"
#include "Text_off_reader.h"
#include "file_format.h"

#include <CGAL/IO/OFF/File_header_OFF.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <cerrno>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <string>
#include <system_error>

namespace Program {

/// checks that the counts in the header of an OFF file are no larger than the file, as CGAL reserves what they ask for.
///
/// \throws Program_error otherwise
inline void check_counts(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  CGAL::File_header_OFF header;
  in >> header;
  const std::uintmax_t size = std::filesystem::file_size(path);
  if(!in || header.size_of_vertices() > size || header.size_of_facets() > size)
    throw Program_error("the header is damaged: the numbers of vertices and faces are missing, negative or too large");
}

/// reads a mesh file of any format that CGAL reads.
///
/// \throws Program_error with the name of the file and what is wrong with it
inline Polygon_soup read_soup(const std::string& path)
{
  const std::string format = file_format(path);
  if(!is_among(format, input_formats))
    throw Program_error(path + ": the name of a mesh file has to end with one of " + list_of(input_formats));
  if(std::filesystem::is_directory(path))
    throw Program_error(path + ": this is a directory, not a file");
  std::ifstream in(path, std::ios::binary);
  if(!in)
    throw Program_error(path + ": " + std::generic_category().message(errno));

  Polygon_soup soup;
  try
  {
    if(format == ".off" && Text_off_reader(in)(soup))
      return soup;
    if(format == ".off")
      check_counts(path);
    in.close();
    if(!CGAL::IO::read_polygon_soup(path, soup.points, soup.polygons))
      throw Program_error("this is no valid file of the format " + format +
                          ": it is damaged or truncated, or has a wrong name");
  }
  catch(const std::bad_alloc&)
  {
    throw Program_error(path + ": the memory does not suffice; if the file is small, it is damaged");
  }
  catch(const std::exception& error)
  {
    throw Program_error(path + ": " + error.what());
  }
  return soup;
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_READ_SOUP_H
