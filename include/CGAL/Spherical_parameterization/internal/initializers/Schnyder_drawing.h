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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_SCHNYDER_DRAWING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_SCHNYDER_DRAWING_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Theorem. Every simple triangulation T of the sphere with n >= 4 vertices has a bijective map to the sphere whose
// vertices lie in integer directions, with coordinates of absolute value at most 2 N, where N = 2 n - 7. For n <= 10^7,
// the unit vectors of these directions, rounded to nearest in double precision, define a bijective map as well, and so
// do their multiples by a radius of at least 2^-960.
//
// Proof. (1) Opening. By Euler's formula the mean degree is below 6, so there is a vertex s with a ring of d = 3, 4 or
// 5 vertices l1, ..., ld, counterclockwise. Remove s, and fill the hole by d - 2 triangles incident to l1. For a
// suitable choice of l1, the new edges are not edges of T: since no two edges of T cross outside the hole, T lacks one
// of the two diagonals of a hole with four vertices. Of the diagonals of a hole with five vertices, T has at most two.
// If it has two, they share a vertex, and a neighbor of that vertex on the ring has no diagonal. If it has one, the
// vertex between its ends has none. The result is a simple triangulation T' with n - 1 vertices. Let its outer face be
// (l1, l2, l3) for d = 3, or else (l1, l3, l4), and call the corners A = l1, B = ld or l4, and C = l2 or l3, so that
// the N inner faces are to the left of the path from A to B and C.
//
// (2) Drawing. A Schnyder wood of T' [Schnyder, Embedding planar graphs on the grid, 1990] gives each inner vertex
// three paths, to A, B and C, which share only that vertex. They divide the triangle into three regions. Let v1, v2 and
// v3 be the numbers of inner faces in the regions opposite to A, B and C, each at least 1, with v1 + v2 + v3 = N. With
// (N, 0, 0), (0, N, 0) and (0, 0, N) for A, B and C, these are the barycentric coordinates of a planar straight-line
// drawing without inverted faces. As points in space, they lie in the plane x + y + z = N, and the determinant of an
// inner face is N times an integer of at least 1. Seen from the origin, the inner faces tile the positive octant once.
//
// (3) Closing. Omit the faces inside the hole that are not faces of T, and map s to -c. The face (s, p, q) with the
// edge from p to q of the hole is positive if det(c, q, p) is. With c as below, these determinants are, for the inner
// vertices x = l2 and y = l5, which differ, up to factors of N or N^2:
//   d = 3, c = (1, 1, 1):                  1, 1, 1;
//   d = 4, c = x + B:                      x3, x1, x1, x3;
//   d = 5, c = (1, x2 + y2, x3 + y3):      c2 x3 - c3 x2 = y2 x3 - y3 x2,  c2 x1 - x2,  1,  c3 y1 - y3,  c3 y2 - c2 y3 = y2 x3 - y3 x2.
// These are positive integers, because x1, x3, y1 and y2 are at least 1, and y2 x3 > y3 x2: seen from A, going from C
// to B, the edge to x comes before the edge to y. The faces of T without s form a polygon in the octant with c inside,
// and all its sides have the same orientation around c: each half of a great circle from c to -c leaves the polygon
// once and continues in a face of s. So all faces are positive and cover each direction once.
//
// (4) Rounding. Since coordinates are not negative, no corner of an inner face is longer than N, and no c is longer
// than 2 N. So the determinant of the unit vectors is at least N / N^3 for a face of T', and for a face of s at least N
// / (2 N N^2), which is 1 / (2 N^2) > 1.25e-15 for n <= 10^7. The coordinates themselves are exact. The length that
// they are divided by is a common factor, whose error does not matter. The rounding of the quotient, of the product
// with the radius, and of one more product moves a unit vector by at most 3 * 2^-53. This changes the determinant by at
// most three times as much, 9 * 2^-53 < 1e-15, apart from second-order terms, which are below 1e-30. On the line
// segments from the exact vectors to the rounded ones, all determinants stay positive, so that each direction stays
// covered once.
//
// As an initial map it is poor: areas follow the numbers of faces, and most images are near B or A. Areas instead of
// these numbers would weaken the bound and hardly improve the map.
class Schnyder_drawing
{
public:
  // Of a simple triangulation of the sphere.
  explicit Schnyder_drawing(const Vertex_rings& rings)
    : m_rings(rings)
    , m_parents(rings.number_of_vertices(), {none, none, none})
  {
    open();
    peel();
  }

  // Returns the unit vectors of all vertices, in linear time.
  std::vector<Vector_3d> positions() const
  {
    const double n_faces = 2. * static_cast<double>(m_rings.number_of_vertices()) - 7.;
    std::vector<Vector_3d> result = region_sizes(n_faces);
    for(std::size_t i = 0; i < 3; ++i)
    {
      result[m_outer[i]] = {0., 0., 0.};
      result[m_outer[i]][i] = n_faces;
    }
    result[m_open] = -1. * closing_direction(result);
    for(Vector_3d& p : result)
    {
      const double norm = length(p);
      for(double& x : p)
        x /= norm;
    }
    return result;
  }

private:
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  // Step 1
  void open()
  {
    for(Index v = 0; v < m_rings.number_of_vertices(); ++v)
      if(m_open == none || m_rings.degree(v) < m_rings.degree(m_open))
        m_open = v;
    const Vertex_rings::Ring ring = m_rings.ring(m_open);
    const std::size_t d = ring.size();
    const auto has_edge = [&](Index a, Index b) { return m_rings.ring(a).position_of(b) < m_rings.degree(a); };
    std::size_t first = 0;
    while((d > 3 && has_edge(ring[first], ring.around(first + 2))) ||
          (d > 4 && has_edge(ring[first], ring.around(first + 3))))
      ++first;
    for(std::size_t k = 0; k < d; ++k)
      m_hole[k] = ring.around(first + k);
    m_outer = {m_hole[0], m_hole[d == 3 ? 2 : 3], m_hole[d == 3 ? 1 : 2]};
  }

  // Computes the Schnyder wood: removes vertices of T' one by one, starting at C, so that the rest is bounded by a path
  // from A to B and the edge between them. A vertex can be removed if its only neighbors on the path are the previous
  // and the next one; unless only A and B are left, such a vertex exists. Its first two parents are then these
  // neighbors, and it becomes the third parent of all its other neighbors, which replace it on the path.
  void peel()
  {
    const std::size_t n = m_rings.number_of_vertices();
    std::vector<Index> before(n, none), behind(n, none), n_chords(n, 0); // on the path; edges across it
    std::vector<char> is_on_path(n, 0);
    std::vector<Index> candidates;
    m_order.reserve(n - 4);

    const Index a = m_outer[0], b = m_outer[1], c = m_outer[2];
    const auto take_off = [&](Index v, Index first, Index last) {
      const Vertex_rings::Ring ring = m_rings.ring(v);
      is_on_path[v] = 0;
      // Counterclockwise around v, the rest extends from the previous to the next vertex. The outer face may be in this
      // range between A and B, and around C between the other two.
      Index end = first;
      std::size_t n_new = 0;
      for(std::size_t j = ring.position_of(v == c ? m_open : first) + 1; ring.around(j) != last; ++j)
      {
        const Index w = ring.around(j);
        if(w == m_open || w == first)
          continue;
        m_parents[w][2] = v;
        behind[end] = w;
        before[w] = end;
        is_on_path[w] = 1;
        end = w;
        ++n_new;
      }
      behind[end] = last;
      before[last] = end;
      if(n_new == 0) // The edge between the neighbors was an edge across the path.
        for(const Index w : {first, last})
          if(--n_chords[w] == 0)
            candidates.push_back(w);
      for(Index w = behind[first]; w != last; w = behind[w])
      {
        for(const Index x : m_rings.ring(w))
          if(is_on_path[x] && x != before[w] && x != behind[w])
          {
            ++n_chords[w];
            n_chords[x] += m_parents[x][2] != v; // If both are new, each counts its own.
          }
        if(n_chords[w] == 0)
          candidates.push_back(w);
      }
    };

    is_on_path[a] = is_on_path[b] = 1;
    n_chords[a] = n_chords[b] = 1; // the edge between them
    take_off(c, a, b);
    while(!candidates.empty())
    {
      const Index v = candidates.back();
      candidates.pop_back();
      if(!is_on_path[v] || n_chords[v] > 0 || v == a || v == b)
        continue;
      m_parents[v][0] = before[v];
      m_parents[v][1] = behind[v];
      m_order.push_back(v);
      take_off(v, before[v], behind[v]);
    }
  }

  // Step 2. The vertices of the region opposite to A, including its boundary, are those from which a vertex of the
  // paths to B and C is reached by first parents; so their number is the sum of the sizes of subtrees over the paths.
  // Euler's formula gives the number of faces: 2 r - e - 3, for r vertices and paths with e edges.
  std::vector<Vector_3d> region_sizes(double n_faces) const
  {
    const std::size_t n = m_rings.number_of_vertices();
    std::vector<Vector_3d> result(n);
    for(std::size_t i = 0; i < 2; ++i)
    {
      // First and second parents were removed later.
      std::vector<Index> subtree(n, 1);
      for(const Index v : m_order)
        subtree[m_parents[v][i]] += subtree[v];
      for(const Index v : m_outer)
        subtree[v] = 1;
      for(const Index v : m_order)
        result[v][i] = -2. * subtree[v] - 3.; // v is on both paths
      for(const std::size_t path : {1 - i, std::size_t(2)})
      {
        // Of a path from a vertex to its end: the sum of 2 r - e.
        std::vector<std::int64_t> sums(n, 2);
        const auto add = [&](Index v) {
          sums[v] = sums[m_parents[v][path]] + 2 * static_cast<std::int64_t>(subtree[v]) - 1;
          result[v][i] += static_cast<double>(sums[v]);
        };
        if(path < 2)
          std::for_each(m_order.rbegin(), m_order.rend(), add);
        else
          std::for_each(m_order.begin(), m_order.end(), add);
      }
    }
    for(const Index v : m_order)
      result[v][2] = n_faces - result[v][0] - result[v][1];
    return result;
  }

  // Step 3
  Vector_3d closing_direction(const std::vector<Vector_3d>& points) const
  {
    const Vector_3d x = points[m_hole[1]];
    switch(m_rings.degree(m_open))
    {
    case 3:
      return {1., 1., 1.};
    case 4:
      return x + points[m_outer[1]];
    default:
      const Vector_3d y = points[m_hole[4]];
      return {1., x[1] + y[1], x[2] + y[2]};
    }
  }

  const Vertex_rings& m_rings;
  Index m_open = none;           // s
  std::array<Index, 5> m_hole{}; // its ring, starting at l1
  std::array<Index, 3> m_outer;  // A, B, C
  std::vector<std::array<Index, 3>> m_parents;
  std::vector<Index> m_order; // in which inner vertices are removed
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_SCHNYDER_DRAWING_H
