// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

// Makes a coarser mesh of the same shape, so that growth can be measured from small meshes on.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace SMS = CGAL::Surface_mesh_simplification;

// CGAL's own predicate on the number of edges has another name in CGAL 5.6 and later.
struct Stop_at_edges
{
  std::size_t n_edges;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t /* initial_count */, std::size_t count) const
  {
    return count <= n_edges;
  }
};

int main(int argc, char* argv[])
{
  const long n_vertices = argc == 4 ? std::atol(argv[2]) : 0;
  if(n_vertices < 4)
  {
    std::cerr << "usage: simplify_mesh INPUT VERTICES OUTPUT\n"
                 "Writes a closed triangle mesh of genus 0 with so many vertices, 4 or more, to an OFF file.\n";
    return EXIT_FAILURE;
  }
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << argv[1] << " cannot be read.\n";
    return EXIT_FAILURE;
  }
  // Euler: a closed triangle mesh of genus 0 has 3 (V - 2) edges.
  SMS::edge_collapse(mesh, Stop_at_edges{3 * static_cast<std::size_t>(n_vertices - 2)});
  mesh.collect_garbage();
  if(mesh.number_of_vertices() != static_cast<std::size_t>(n_vertices) || !CGAL::is_closed(mesh))
  {
    std::cerr << argv[1] << " cannot be simplified to " << n_vertices << " vertices; is it closed and of genus 0?\n";
    return EXIT_FAILURE;
  }
  if(!CGAL::IO::write_polygon_mesh(argv[3], mesh, CGAL::parameters::stream_precision(17)))
  {
    std::cerr << argv[3] << " cannot be written.\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
