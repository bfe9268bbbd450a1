// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MESH_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MESH_FILES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmarks {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Sphere_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>;

// The files among `inputs`, and the meshes directly in the folders among them by name. Throws if a file is not there, or
// if there is none at all.
inline std::vector<std::filesystem::path> find_mesh_files(const std::vector<std::string>& inputs)
{
  namespace fs = std::filesystem;
  static const std::array<const char*, 7> extensions = {".off", ".ply", ".obj", ".stl", ".ts", ".vtp", ".wrl"};

  std::vector<fs::path> files;
  for(const fs::path input : inputs)
  {
    if(fs::is_regular_file(input))
    {
      files.push_back(input);
      continue;
    }
    if(!fs::is_directory(input))
    {
      throw std::runtime_error(input.string() + ": there is no such file");
    }
    std::vector<fs::path> meshes;
    for(const fs::directory_entry& entry : fs::directory_iterator(input))
    {
      if(entry.is_regular_file() &&
         std::find(extensions.begin(), extensions.end(), entry.path().extension()) != extensions.end())
      {
        meshes.push_back(entry.path());
      }
    }
    std::sort(meshes.begin(), meshes.end());
    files.insert(files.end(), meshes.begin(), meshes.end());
  }
  if(files.empty())
  {
    throw std::runtime_error("There is no mesh.");
  }
  return files;
}

// The mesh in `file`, in any format of CGAL.
inline Mesh read_mesh(const std::filesystem::path& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file.string(), mesh))
  {
    throw std::runtime_error("cannot be read as a polygon mesh");
  }
  return mesh;
}

// Where the images of the vertices of `mesh` go.
inline Sphere_map add_sphere_map(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:sphere").first;
}

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MESH_FILES_H
