// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BALANCED_RADIUS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BALANCED_RADIUS_H

#include "Input_mesh.h"

#include <CGAL/Spherical_parameterization/Area_balancing_radius_3.h>
#include <CGAL/Spherical_parameterization/Face_distortion.h>
#include <CGAL/Spherical_parameterization/Face_invariants_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Program {

using Distortion_map = Mesh::Property_map<Mesh::Face_index, CGAL::Spherical_parameterization::Face_distortion>;

/// returns the radius that balances the areas of a map (eq. 11), at which maps are usually compared; 0 if no number
/// holds it.
///
/// \param radius that of `sphere`
/// \param distortions those of `sphere`; faces where they are infinite are left out
inline double balanced_radius(const Mesh& mesh, const Sphere_map& sphere, double radius,
                              const Distortion_map& distortions)
{
  // Scaling by a power of two is exact, and keeps all products away from infinity and 0.
  const auto exponent_of = [&](const auto& points) {
    double largest = 0.;
    for(const Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v))
        for(int k = 0; k < 3; ++k)
          largest = (std::max)(largest, std::abs(points[v][k]));
    return largest > 0. ? std::ilogb(largest) : 0;
  };
  const auto area = [&](const auto& points, Mesh::Face_index f, int exponent) {
    const auto point = [&](Mesh::Halfedge_index h) {
      const Point_3& p = points[mesh.target(h)];
      return Point_3(std::scalbn(p.x(), -exponent), std::scalbn(p.y(), -exponent), std::scalbn(p.z(), -exponent));
    };
    const auto h = mesh.halfedge(f);
    const Point_3 p = point(h), q = point(mesh.next(h)), r = point(mesh.prev(h));
    return std::sqrt(CGAL::cross_product(q - p, r - p).squared_length());
  };

  const int exponent = exponent_of(mesh.points()), exponent_of_sphere = exponent_of(sphere);
  std::vector<CGAL::Spherical_parameterization::Face_invariants_3> faces; // i is of no use to eq. 11
  for(const Mesh::Face_index f : mesh.faces())
    if(std::isfinite(distortions[f].isometric))
    {
      const double area_of_face = area(mesh.points(), f, exponent);
      const double d = area(sphere, f, exponent_of_sphere) / area_of_face;
      faces.push_back({area_of_face, 0., d, d});
    }
  CGAL::Spherical_parameterization::Area_balancing_radius_3 rule;
  const double scaled =
      rule(CGAL::Spherical_parameterization::Isometric_energy_3(), faces, std::scalbn(radius, -exponent_of_sphere));
  const double balanced = std::scalbn(scaled, exponent);
  return balanced > 0. && std::isfinite(balanced) ? balanced : 0.;
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_BALANCED_RADIUS_H
