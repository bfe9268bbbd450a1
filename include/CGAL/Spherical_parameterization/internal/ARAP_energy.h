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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ARAP_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ARAP_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/Tangent_frame.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/for_each_block.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The as-rigid-as-possible energy of a map u to the sphere of radius r: the sum over the faces of sum cot |r e' - R e|^2 / 4 over the
// edges e of the face on the surface and e' of its image on the unit sphere, R being the rotation of the plane of the
// one onto the plane of the other that makes it least. It is that of (s1 - 1)^2 + (s2 - 1)^2, weighted with half the
// areas, in units of 4 pi, the area of the surface. The plane of the image is seen from outside the sphere, so that an
// inverted face costs what it should.
template <class ConcurrencyTag>
class ARAP_energy
{
public:
  ARAP_energy(const Vertex_rings& rings, const std::vector<Vector_3d>& points)
  {
    m_faces.reserve(rings.number_of_faces());
    rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      m_faces.push_back(Face({a, b, c}, Rest_triangle::from_points(points[a], points[b], points[c])));
    });
    m_partial.resize((m_faces.size() + block_size - 1) / block_size);
  }

  // Fits the rotations, then the radius, which is a linear problem of one variable; returns the energy.
  double fit(const std::vector<Vector_3d>& u)
  {
    for_each_block<ConcurrencyTag>(0, m_faces.size(), block_size, [&](std::size_t begin, std::size_t end) {
      Sums& sums = m_partial[begin / block_size] = Sums();
      for(std::size_t f = begin; f < end; ++f)
        m_faces[f].fit_rotation(u, sums);
    });
    Sums sums;
    for(const Sums& part : m_partial)
    {
      sums.fitted += part.fitted;
      sums.image += part.image;
      sums.surface += part.surface;
    }
    m_radius = sums.fitted / sums.image;
    return 0.25 * 0.25 / 3.14159265358979323846 * (sums.surface - m_radius * sums.fitted);
  }

  // the radius as it was last fitted, in the unit of length of the mesh
  double radius() const { return m_radius; }

  // Half the gradient of the energy in all positions at the last fit, in space and up to the unit, with the sign of a
  // descent: what the rotated edges would have the edges change by, summed up at each vertex.
  void forces(const std::vector<Vector_3d>& u, std::vector<Vector_3d>& b) const
  {
    for(Vector_3d& x : b)
      x = {0., 0., 0.};
    for(const Face& face : m_faces)
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Vector_3d force = (0.5 * face.cotangents[i]) * (face.rotated[i] - m_radius * face.edge(u, i));
        Vector_3d &from = b[face.corners[(i + 1) % 3]], &to = b[face.corners[(i + 2) % 3]];
        from = from - force;
        to = to + force;
      }
  }

private:
  struct Sums // of cotangents times products of edges
  {
    double fitted = 0., image = 0., surface = 0.;
  };

  // Edge i is opposite to corner i, and runs from corner i + 1 to corner i + 2.
  struct Face
  {
    std::array<std::uint32_t, 3> corners;
    std::array<double, 3> cotangents;
    std::array<std::array<double, 2>, 3> edges; // of the face on the surface, in its plane
    std::array<Vector_3d, 3> rotated;           // the same in the plane of the image

    Face(const std::array<std::uint32_t, 3>& c, const Rest_triangle& rest)
      : corners(c)
    {
      const double area = 1. / rest.inverse_area;
      cotangents = {rest.opposite_0 * area, rest.opposite_1 * area, rest.opposite_2 * area};
      // Corner 0 is the origin, corner 1 on the x-axis; the square of the edge between them is area (cot 0 + cot 1).
      const double x1 = std::sqrt(area * (cotangents[0] + cotangents[1]));
      const double y2 = area / x1, x2 = cotangents[0] * y2;
      edges = {{{x2 - x1, y2}, {-x2, -y2}, {x1, 0.}}};
      rotated = {};
    }

    Vector_3d edge(const std::vector<Vector_3d>& u, std::size_t i) const
    {
      return u[corners[(i + 2) % 3]] - u[corners[(i + 1) % 3]];
    }

    void fit_rotation(const std::vector<Vector_3d>& u, Sums& sums)
    {
      const std::array<Vector_3d, 3> image = {edge(u, 0), edge(u, 1), edge(u, 2)};
      const Vector_3d center = u[corners[0]] + (u[corners[1]] + u[corners[2]]);
      Vector_3d normal = cross(image[0], image[1]);
      const double area = length(normal);
      if(!(area > 0.)) // no plane: the tangential one
        normal = normalized(center);
      else
        normal = (dot(normal, center) < 0. ? -1. / area : 1. / area) * normal;
      const Tangent_frame frame(normal);
      double cosine = 0., sine = 0.; // of the rotation that makes the sum of cot e' R e largest, up to a factor
      std::array<Vector_3d, 3> local;
      for(std::size_t i = 0; i < 3; ++i)
      {
        local[i] = frame.coordinates_of(image[i]);
        cosine += cotangents[i] * (edges[i][0] * local[i][0] + edges[i][1] * local[i][1]);
        sine += cotangents[i] * (edges[i][0] * local[i][1] - edges[i][1] * local[i][0]);
      }
      const double norm = std::sqrt(cosine * cosine + sine * sine);
      cosine = norm > 0. ? cosine / norm : 1.;
      sine = norm > 0. ? sine / norm : 0.;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const double x = cosine * edges[i][0] - sine * edges[i][1], y = sine * edges[i][0] + cosine * edges[i][1];
        rotated[i] = frame.vector_of(x, y);
        sums.fitted += cotangents[i] * (x * local[i][0] + y * local[i][1]);
        sums.image += cotangents[i] * squared_length(image[i]);
        sums.surface += cotangents[i] * (x * x + y * y);
      }
    }
  };

  static constexpr std::size_t block_size = 1024;

  std::vector<Face> m_faces;
  std::vector<Sums> m_partial;
  double m_radius = 1.;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ARAP_ENERGY_H
