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

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Reads the text variants of the format OFF in three dimensions. Colors, normals and texture coordinates are skipped.
inline Polygon_soup read_off(Text_scanner& in)
{
  const auto next_line = [&](const auto&... where) {
    if(in.next_line())
      return;
    throw File_error("the file ends ", where...);
  };
  const auto find_word = [&] {
    if(in.is_at_end_of_line())
      next_line("within its header");
  };

  if(!in.next_line())
    throw File_error("the file is empty");
  const std::string_view variant = in.word();
  const std::size_t prefix = (std::min)(variant.find_first_not_of("STCN4n"), variant.size());
  if(variant.compare(prefix, 3, "OFF") != 0)
    in.fail("an OFF file begins with OFF, not with ", Text_scanner::quoted(variant));
  const bool is_homogeneous = variant.find('4') < prefix, has_dimension = variant.find('n') < prefix;
  in.skip(prefix + 3); // some files have no blank between OFF and the first number
  find_word();
  if(in.word() == "BINARY")
    in.fail("the binary variant is not read: write the mesh as text, or as PLY");
  if(has_dimension)
  {
    const long long dimension = in.read_integer("the dimension");
    if(dimension != 3)
      in.fail("the dimension is ", dimension, ", not 3");
    find_word();
  }
  const std::size_t n_vertices = in.read_count("vertices"), n_faces = in.read_count("faces");
  const char* const damage = ": it is truncated, or the numbers in its first lines are wrong";

  Polygon_soup soup;
  constexpr std::size_t min_vertex = 6, min_face = 2; // bytes of a line: "0 0 0" or "0", and its end
  in.check_count(n_vertices, "vertices", min_vertex);
  soup.points.reserve(n_vertices);
  for(std::size_t i = 0; i < n_vertices; ++i)
  {
    next_line("after ", i, " of ", n_vertices, " vertices", damage);
    const Simple_cartesian<double>::Point_3 p = in.read_point("vertex ", i);
    const double w = is_homogeneous ? in.read_number("coordinate w of vertex ", i) : 1.;
    soup.points.emplace_back(p.x() / w, p.y() / w, p.z() / w);
  }
  in.check_count(n_faces, "faces", min_face);
  soup.polygons.resize(n_faces);
  for(std::size_t i = 0; i < n_faces; ++i)
  {
    next_line("after ", i, " of ", n_faces, " faces", damage);
    const long long size = in.read_integer("the number of corners of face ", i);
    if(size < 0)
      in.fail("the number of corners of face ", i, " is negative");
    for(long long k = 0; k < size; ++k)
    {
      const long long v = in.read_integer("corner ", k, " of face ", i);
      if(v < 0 || static_cast<std::size_t>(v) >= n_vertices)
        in.fail("face ", i, " has the corner ", v, ", but there are ", n_vertices, " vertices, counted from 0");
      soup.polygons[i].push_back(static_cast<std::size_t>(v));
    }
  }
  if(in.next_line())
    in.fail("the file goes on after ", n_faces, " faces with ", Text_scanner::quoted(in.word()),
            ": the numbers in its first lines are wrong, or it has been damaged");
  return soup;
}

// Reads the vertices and faces of the format OBJ; all other valid statements are skipped.
inline Polygon_soup read_obj(Text_scanner& in)
{
  constexpr std::string_view others = " vt vn vp g s mg o p l usemtl mtllib usemap maplib bevel c_interp d_interp lod "
                                      "shadow_obj trace_obj ctech stech cstype deg bmat step curv curv2 surf parm trim "
                                      "hole scrv sp end con call csh bsp bzp cdc cdp res ";
  Polygon_soup soup;
  std::size_t n_needed = 0, needing_line = 0; // a face may precede its vertices
  while(in.next_line())
  {
    const std::string_view statement = in.read_word();
    const std::size_t f = soup.polygons.size();
    if(statement == "v")
      soup.points.push_back(in.read_point("vertex ", soup.points.size()));
    else if(statement == "f" || statement == "fo")
    {
      // A corner is a vertex, counted from 1, or backwards from the last one so far, -1. Texture and normal may follow.
      Polygon face;
      const long long n = static_cast<long long>(soup.points.size());
      while(!in.is_at_end_of_line())
      {
        const long long v = in.read_integer_before('/', "corner ", face.size(), " of face ", f);
        if(v == 0 || v < -n)
          in.fail("face ", f, " has the corner ", v,
                  ", but an OBJ file counts its vertices from 1, or from -1 backwards");
        face.push_back(static_cast<std::size_t>(v > 0 ? v - 1 : n + v));
        if(face.back() >= n_needed)
        {
          n_needed = face.back() + 1;
          needing_line = in.line_number();
        }
      }
      soup.polygons.push_back(face);
    }
    else if(others.find(" " + std::string(statement) + " ") == others.npos)
      in.fail("no line of an OBJ file begins with ", Text_scanner::quoted(statement));
  }
  if(n_needed > soup.points.size())
    throw File_error("line ", needing_line, ": a face has the corner ", n_needed, ", but the file has ",
                     soup.points.size(), " vertices, counted from 1");
  return soup;
}

// Reads the triangulated surfaces of the format GOCAD TSurf as one mesh.
inline Polygon_soup read_gocad(Text_scanner& in)
{
  Polygon_soup soup;
  std::map<long long, std::size_t> vertices; // by their numbers
  const auto add_vertex = [&](long long number, std::size_t v) {
    if(!vertices.emplace(number, v).second)
      in.fail("the vertex ", number, " exists already");
  };
  const auto read_reference = [&](const char* what) {
    const long long number = in.read_integer(what);
    const auto vertex = vertices.find(number);
    if(vertex == vertices.end())
      in.fail(what, " is the vertex ", number, ", which no line before has defined");
    return vertex->second;
  };

  bool is_within_surface = false;
  while(in.next_line())
  {
    const std::string_view statement = in.read_word();
    if(statement == "GOCAD")
    {
      is_within_surface = true;
      vertices.clear(); // each surface has its own numbers
    }
    else if(!is_within_surface)
      in.fail("a surface of a GOCAD file begins with GOCAD, not with ", Text_scanner::quoted(statement));
    else if(statement == "VRTX" || statement == "PVRTX")
    {
      const long long number = in.read_integer("the number of the vertex");
      add_vertex(number, soup.points.size());
      soup.points.push_back(in.read_point("vertex ", number));
    }
    else if(statement == "ATOM" || statement == "PATOM") // another number for the same vertex
    {
      const long long number = in.read_integer("the number of the atom");
      add_vertex(number, read_reference("what the atom stands for"));
    }
    else if(statement == "TRGL")
    {
      Polygon triangle;
      for(const char* corner : {"corner 0", "corner 1", "corner 2"})
        triangle.push_back(read_reference(corner));
      soup.polygons.push_back(triangle);
    }
    else if(statement == "END")
      is_within_surface = false;
  }
  if(is_within_surface)
    throw File_error("the file ends without END: it is truncated");
  return soup;
}

// Reads the content of a mesh file: .off, .obj, .ply, .stl or .ts. From .ply, properties of vertices and faces may be
// kept. Files are untrusted. The readers of CGAL do not report where a file is damaged, read some damaged files as
// other meshes, and may allocate any amount of memory; doc/upstreaming.md has examples.
inline Polygon_soup read_mesh_file(const std::string& format, std::string content, bool keeps_values = false)
{
  if(content.compare(0, 2, "\x1F\x8B") == 0)
    throw File_error("the file is compressed.\nUnpack it first.");
  Text_scanner in(std::move(content), format == ".obj");
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
    if(format == ".ts")
      return read_gocad(in);
    throw File_error("no mesh is read from files in ", format);
  }
  catch(const File_error& error)
  {
    throw File_error(error.what(), ".\nRepair the file, or the program that wrote it.");
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FILES_READ_MESH_FILE_H
