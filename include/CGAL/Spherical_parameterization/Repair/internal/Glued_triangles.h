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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_GLUED_TRIANGLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_GLUED_TRIANGLES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Triangles with pairs of sides that are glued together. Any two sides can be glued, whatever their vertices are, so
// that a surface can be cut and glued by changing sides only. Every state is a manifold: a side has at most one mate,
// and the corners connected by glued sides form one vertex with a single fan of triangles.
//
// Corner i of triangle t has the number 3 t + i, as has the side from this corner to the next one. Glued sides have
// opposite directions.
class Glued_triangles
{
public:
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  Glued_triangles() = default;
  explicit Glued_triangles(const Index_triangles& triangles)
  {
    for(const auto& t : triangles)
      add(t);
  }

  Glued_triangles(const Index_triangles& triangles, std::vector<Index> mates)
    : Glued_triangles(triangles)
  {
    m_mates = std::move(mates);
  }

  // A closed mesh, in which all sides are glued.
  Glued_triangles(const Index_triangles& triangles, const std::vector<Linked_triangle>& linked)
    : Glued_triangles(triangles)
  {
    for(Index t = 0; t < linked.size(); ++t)
      for(Index i = 0; i < 3; ++i)
      {
        const Index other = linked[t].neighbors[(i + 2) % 3]; // opposite to corner i + 2
        m_mates[3 * t + i] = 3 * other + static_cast<Index>(linked[other].corner_of(target(3 * t + i)));
      }
  }

  // Adds a triangle without mates. Returns its first side.
  Index add(const std::array<Index, 3>& triangle)
  {
    m_vertices.insert(m_vertices.end(), triangle.begin(), triangle.end());
    m_mates.insert(m_mates.end(), 3, none);
    return number_of_sides() - 3;
  }

  Index number_of_sides() const { return static_cast<Index>(m_mates.size()); }
  Index number_of_triangles() const { return number_of_sides() / 3; }

  static Index next(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index previous(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

  Index source(Index side) const { return m_vertices[side]; }
  Index target(Index side) const { return m_vertices[next(side)]; }
  Index apex(Index side) const { return m_vertices[previous(side)]; } // opposite to the side
  Index mate(Index side) const { return m_mates[side]; }
  bool is_border(Index side) const { return m_mates[side] == none; }
  std::array<Index, 3> triangle(Index t) const
  {
    return {m_vertices[3 * t], m_vertices[3 * t + 1], m_vertices[3 * t + 2]};
  }

  void set_vertex(Index corner, Index vertex) { m_vertices[corner] = vertex; }

  void glue(Index side, Index other)
  {
    m_mates[side] = other;
    m_mates[other] = side;
  }
  void cut(Index side)
  {
    m_mates[m_mates[side]] = none;
    m_mates[side] = none;
  }

  // The border side that begins at the end of this one.
  Index next_on_border(Index side) const
  {
    Index result = next(side);
    while(!is_border(result))
      result = next(m_mates[result]);
    return result;
  }

  // Calls f(corner) for all corners at the vertex of this corner, counterclockwise.
  template <class Function>
  void for_each_corner(Index corner, const Function& f) const
  {
    Index first = corner;
    while(!is_border(first))
    {
      first = next(m_mates[first]);
      if(first == corner)
        break;
    }
    Index k = first;
    do
    {
      f(k);
      k = m_mates[previous(k)];
    } while(k != none && k != first);
  }

  // Gives each fan of triangles its own vertex: the first fan at a vertex keeps it, the others get new vertices.
  // Returns the original vertex of each new one.
  std::vector<Index> separate_fans(Index n_vertices)
  {
    std::vector<char> is_visited(m_vertices.size(), 0), is_taken(n_vertices, 0);
    std::vector<Index> sources;
    for(Index corner = 0; corner < number_of_sides(); ++corner)
    {
      if(is_visited[corner])
        continue;
      const Index vertex = m_vertices[corner];
      const bool is_first = !is_taken[vertex];
      is_taken[vertex] = 1;
      const Index number = is_first ? vertex : n_vertices + static_cast<Index>(sources.size());
      if(!is_first)
        sources.push_back(vertex);
      for_each_corner(corner, [&](Index k) {
        m_vertices[k] = number;
        is_visited[k] = 1;
      });
    }
    return sources;
  }

  // The connected component of each triangle, given by the smallest index of its triangles.
  std::vector<Index> components() const
  {
    std::vector<Index> result(number_of_triangles(), none), stack;
    for(Index t = 0; t < number_of_triangles(); ++t)
    {
      if(result[t] != none)
        continue;
      result[t] = t;
      stack = {t};
      while(!stack.empty())
      {
        const Index first = 3 * stack.back();
        stack.pop_back();
        for(Index side = first; side < first + 3; ++side)
          if(!is_border(side) && result[m_mates[side] / 3] == none)
          {
            result[m_mates[side] / 3] = t;
            stack.push_back(m_mates[side] / 3);
          }
      }
    }
    return result;
  }

  // Keeps the triangles t with keeps(t), in order. The others must not be glued to them.
  template <class Function>
  void keep(const Function& keeps)
  {
    std::vector<Index> number(number_of_triangles(), none);
    Index n = 0;
    for(Index t = 0; t < number_of_triangles(); ++t)
      if(keeps(t))
        number[t] = n++;
    for(Index t = 0; t < number_of_triangles(); ++t)
      for(Index i = 0; i < 3 && number[t] != none; ++i)
      {
        const Index mate = m_mates[3 * t + i];
        m_vertices[3 * number[t] + i] = Index(m_vertices[3 * t + i]);
        m_mates[3 * number[t] + i] = mate == none ? none : 3 * number[mate / 3] + mate % 3;
      }
    m_vertices.resize(3 * n);
    m_mates.resize(3 * n);
  }

  // The border side that ends at the beginning of this one.
  Index previous_on_border(Index side) const
  {
    Index result = previous(side);
    while(!is_border(result))
      result = previous(m_mates[result]);
    return result;
  }

  // The sides of each border, in order along it.
  std::vector<std::vector<Index>> borders() const
  {
    std::vector<std::vector<Index>> result;
    std::vector<char> is_seen(m_mates.size(), 0);
    for(Index first = 0; first < number_of_sides(); ++first)
    {
      if(!is_border(first) || is_seen[first])
        continue;
      result.emplace_back();
      Index side = first;
      do
      {
        is_seen[side] = 1;
        result.back().push_back(side);
        side = next_on_border(side);
      } while(side != first);
    }
    return result;
  }

  // Splits a glued side and both of its triangles by a vertex. The part that begins at the source of the side keeps its
  // number. Adds the triangle (vertex, target, apex) and the triangle opposite to it, with consecutive numbers. Returns
  // the first side of the former.
  Index split(Index side, Index vertex)
  {
    const Index other = m_mates[side], right = next(side), left_of_other = previous(other);
    const Index first = add({vertex, target(side), apex(side)}), second = add({target(side), vertex, apex(other)});
    m_vertices[right] = vertex;
    m_vertices[other] = vertex;
    glue_if_any(first + 1, m_mates[right]);
    glue_if_any(second + 2, m_mates[left_of_other]); // the new mate, if the target has only these two triangles
    glue(first + 2, right);
    glue(second + 1, left_of_other);
    glue(first, second);
    return first;
  }

  // Replaces a glued side by the side between the apexes of its triangles.
  void flip(Index side)
  {
    const Index other = m_mates[side], a = source(side), b = target(side), c = apex(side), d = apex(other);
    const Index bc = m_mates[next(side)], ca = m_mates[previous(side)], ad = m_mates[next(other)],
                db = m_mates[previous(other)];
    // (a, b, c) and (b, a, d) become (d, c, a), whose first side is the new one, and (c, d, b).
    const auto set = [&](Index first, Index p, Index q, Index r) {
      m_vertices[first] = p;
      m_vertices[next(first)] = q;
      m_vertices[previous(first)] = r;
    };
    set(side, d, c, a);
    set(other, c, d, b);
    glue_if_any(next(side), ca);
    glue_if_any(previous(side), ad);
    glue_if_any(next(other), db);
    glue_if_any(previous(other), bc);
  }

private:
  void glue_if_any(Index side, Index other)
  {
    m_mates[side] = other;
    if(other != none)
      m_mates[other] = side;
  }

  std::vector<Index> m_vertices; // for each corner
  std::vector<Index> m_mates;    // for each side
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_GLUED_TRIANGLES_H
