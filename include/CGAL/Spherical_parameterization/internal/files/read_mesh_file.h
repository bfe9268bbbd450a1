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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_READ_MESH_FILE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_READ_MESH_FILE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>
#include <CGAL/Spherical_parameterization/internal/files/Ply_reader.h>
#include <CGAL/Spherical_parameterization/internal/files/Polygon_soup.h>
#include <CGAL/Spherical_parameterization/internal/files/Stl_reader.h>
#include <CGAL/Spherical_parameterization/internal/files/Text_scanner.h>
#include <CGAL/Spherical_parameterization/internal/files/read_mesh_text.h>

#include <string>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

// Reads the content of a mesh file: .off, .obj, .ply, .stl or .ts. Of .ply, properties of vertices and faces may be kept.
// Files come from anywhere. The readers of CGAL do not say where a file is damaged, take some damaged files for other
// meshes than they are, and ask for any amount of memory; doc/upstreaming.md has examples.
inline Polygon_soup read_mesh_file(const std::string& format, std::string content, bool keeps_values = false)
{
  if(content.compare(0, 2, "\x1F\x8B") == 0)
    throw File_error("the file is compressed.\nUnpack it first.");
  Text_scanner in(std::move(content));
  try
  {
    if(format == ".off")
      return read_off(in);
    if(format == ".obj")
      return read_obj(in);
    if(format == ".ply")
      return Ply_reader(in, keeps_values)();
    if(format == ".stl")
      return Stl_reader(in)();
    return read_gocad(in);
  }
  catch(const File_error& error)
  {
    throw File_error(error.what(), ".\nRepair the file, or the program that wrote it.");
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_READ_MESH_FILE_H
