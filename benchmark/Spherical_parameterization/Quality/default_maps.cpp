// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

// Maps the meshes that are named by the default method, in one thread, and prints for each of them the shorter time of two runs,
// the sweeps, and the maximum and the average of the isometric distortion. See measure_ablation.py.

#include <CGAL/spherical_parameterization.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace SP = CGAL::Spherical_parameterization;

int main(int argc, char* argv[])
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  for(int k = 1; k < argc; ++k)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(argv[k], mesh))
      return std::fprintf(stderr, "%s cannot be read.\n", argv[k]), 1;
    const auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point>("v:sphere").first;
    double seconds = std::numeric_limits<double>::infinity();
    SP::Bijective_low_distortion_parameterizer_3<> method;
    for(int repetition = 0; repetition < 2; ++repetition)
    {
      if(const SP::Error_code error = SP::parameterize<CGAL::Sequential_tag>(mesh, method, sphere); error != SP::OK)
        return std::fprintf(stderr, "%s: %s\n", argv[k], SP::get_error_message(error)), 1;
      seconds = (std::min)(seconds, method.report().seconds());
    }
    SP::Distortion_summary distortion;
    if(const SP::Error_code error = SP::measure_distortion(mesh, sphere, distortion); error != SP::OK)
      return std::fprintf(stderr, "%s: %s\n", argv[k], SP::get_error_message(error)), 1;
    std::printf("%s %.9g %zu %.9g %.9g\n", argv[k], seconds, method.report().number_of_iterations(),
                distortion.isometric.maximum, distortion.isometric.average);
    std::fflush(stdout);
  }
  return 0;
}
