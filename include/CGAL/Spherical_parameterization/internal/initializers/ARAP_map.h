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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_ARAP_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_ARAP_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Laplacian_system.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>

#include <CGAL/number_type_basic.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The as-rigid-as-possible energy of a map u to the sphere of radius r: the sum over the faces of sum cot |r e' - R
// e|^2 / 4 over the edges e of the face on the surface and e' of its image on the unit sphere. R is the rotation from
// the plane of the face to the plane of the image that minimizes this sum. The energy equals that of (s1 - 1)^2 + (s2 -
// 1)^2, weighted by half the areas, in units in which the area of the surface is 4 pi. The plane of the image is seen
// from outside the sphere, so that the energy penalizes an inverted face.
class ARAP_energy
{
public:
  ARAP_energy(const Vertex_rings& rings, const std::vector<Vector_3d>& points, Execution execution)
    : m_execution(execution)
  {
    m_faces.reserve(rings.number_of_faces());
    rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      m_faces.push_back(Face({a, b, c}, Rest_triangle::from_points(points[a], points[b], points[c])));
    });
  }

  // Fits the rotations, then the radius, a linear problem in one variable. Returns the energy.
  double fit(const std::vector<Vector_3d>& u)
  {
    std::vector<Vector_3d> partial((m_faces.size() + usual_block_size - 1) / usual_block_size, Vector_3d{0., 0., 0.});
    for_each_block(m_execution, 0, m_faces.size(), usual_block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t f = begin; f < end; ++f)
        m_faces[f].fit_rotation(u, partial[begin / usual_block_size]);
    });
    Vector_3d sums = {0., 0., 0.};
    for(const Vector_3d& part : partial)
      sums = sums + part;
    const auto [fitted, image, surface] = sums;
    m_radius = fitted / image;
    return 0.25 * 0.25 / CGAL_PI * (surface - m_radius * fitted);
  }

  // The radius of the last fit, in the unit of length of the mesh.
  double radius() const { return m_radius; }

  // Half the negative gradient of the energy with respect to all positions at the last fit, in space and up to the
  // unit: the differences between rotated and actual edges, summed up at each vertex.
  void forces(const std::vector<Vector_3d>& u, std::vector<Vector_3d>& b) const
  {
    b.assign(b.size(), Vector_3d{0., 0., 0.});
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
  // Edge i is opposite to corner i, and runs from corner i + 1 to corner i + 2.
  struct Face
  {
    std::array<std::uint32_t, 3> corners;
    std::array<double, 3> cotangents;
    std::array<std::array<double, 2>, 3> edges; // of the face on the surface, in its plane
    std::array<Vector_3d, 3> rotated;           // the same edges in the plane of the image

    Face(const std::array<std::uint32_t, 3>& c, const Rest_triangle& rest)
      : corners(c)
    {
      const double a = 1. / rest.inverse_doubled_area;
      cotangents = {rest.opposite_0 * a, rest.opposite_1 * a, rest.opposite_2 * a};
      // Corner 0 is the origin and corner 1 is on the x-axis; the squared edge between them is a (cot 0 + cot 1).
      const double x1 = std::sqrt(a * (cotangents[0] + cotangents[1]));
      const double y2 = a / x1, x2 = cotangents[0] * y2;
      edges = {{{x2 - x1, y2}, {-x2, -y2}, {x1, 0.}}};
      rotated = {};
    }

    Vector_3d edge(const std::vector<Vector_3d>& u, std::size_t i) const
    {
      return u[corners[(i + 2) % 3]] - u[corners[(i + 1) % 3]];
    }

    // Adds the cotangents times products of edges: fitted times image edges, and the squares of both.
    void fit_rotation(const std::vector<Vector_3d>& u, Vector_3d& sums)
    {
      const std::array<Vector_3d, 3> image = {edge(u, 0), edge(u, 1), edge(u, 2)};
      const Vector_3d center = u[corners[0]] + (u[corners[1]] + u[corners[2]]);
      Vector_3d normal = cross(image[0], image[1]);
      const double size = length(normal);
      normal = size > 0. ? (dot(normal, center) < 0. ? -1. / size : 1. / size) * normal
                         : normalized(center); // no plane: the tangent plane
      const Tangent_frame frame(normal);
      double cosine = 0., sine = 0.; // of the rotation that maximizes the sum of cot e' R e, up to a factor
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
        sums = sums +
               cotangents[i] * Vector_3d{x * local[i][0] + y * local[i][1], squared_length(image[i]), x * x + y * y};
      }
    }
  };

  Execution m_execution;
  std::vector<Face> m_faces;
  double m_radius = 1.;
};

// Minimizes the as-rigid-as-possible energy of a map to the sphere by alternating local and global steps: rotations and
// radius are fitted, then all vertices are moved by the solution of a linear system with the Laplacian, which is
// factorized once. Forces and moves are restricted to the tangent planes of the sphere. A step that would increase the
// energy is shortened, so the energy decreases monotonically.
class ARAP_map
{
public:
  ARAP_map(const Surface& mesh, Execution execution)
    : m_mesh(mesh)
    , m_energy(mesh.rings(), mesh.points(), execution)
    , m_step(mesh.number_of_vertices())
  {}

  // Required by lower_energy(); the radius is in the caller's unit of length.
  static constexpr double tolerance = 1e-6;  // of the energy; the gain decreases from step to step
  static constexpr double max_increase = 0.; // both steps decrease the energy, unless it has converged
  static constexpr int max_halvings = 12;    // down to 1/2048 of the step, as for a vertex

  std::vector<double> weights() const
  {
    return cotangent_weights(m_mesh.rings(), m_mesh.points(), std::numeric_limits<double>::lowest());
  }
  double energy_of(const std::vector<Vector_3d>& positions) { return m_energy.fit(positions); }
  double radius() const { return m_energy.radius() * m_mesh.equal_area_radius(); }

  template <class System>
  bool find_step(const std::vector<Vector_3d>& positions, System& system)
  {
    m_energy.forces(positions, m_step);
    make_tangential(positions);
    if(!system.solve(m_step))
      return false;
    make_tangential(positions);
    for(Vector_3d& x : m_step)
      x = (1. / m_energy.radius()) * x;
    return true;
  }

  bool move(const std::vector<Vector_3d>& positions, double t, std::vector<Vector_3d>& candidate) const
  {
    for(std::size_t v = 0; v < positions.size(); ++v)
      candidate[v] = normalized(positions[v] + t * m_step[v]);
    return true;
  }

private:
  void make_tangential(const std::vector<Vector_3d>& positions)
  {
    for(std::size_t v = 0; v < positions.size(); ++v)
      m_step[v] = m_step[v] - dot(m_step[v], positions[v]) * positions[v];
  }

  const Surface& m_mesh;
  ARAP_energy m_energy;
  std::vector<Vector_3d> m_step;
};

#if defined(CGAL_SPHERICAL_PARAMETERIZATION_USE_LIBRARY) && defined(CGAL_EIGEN3_ENABLED)
extern template Error_code lower_energy<Default>(ARAP_map, std::size_t, Run&);
#endif

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_ARAP_MAP_H
