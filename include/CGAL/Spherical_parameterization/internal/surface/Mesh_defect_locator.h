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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MESH_DEFECT_LOCATOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MESH_DEFECT_LOCATOR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Finds the location of a defect that read_mesh() has reported, and describes it. This code does not run for valid
// meshes; only read_mesh() decides what a defect is. `Defect` is Mesh_defect<TriangleMesh>.
template <class Defect, class TriangleMesh>
class Mesh_defect_locator
{
public:
  explicit Mesh_defect_locator(const TriangleMesh& tmesh)
    : m_mesh(tmesh)
  {}

  template <class VertexPointMap>
  Defect locate(Error_code error, const VertexPointMap& vpm)
  {
    m_defect.error = error;
    switch(error)
    {
    case ERROR_NON_TRIANGULAR_MESH:
      locate_polygon();
      break;
    case ERROR_NON_CLOSED_MESH:
      locate_border();
      break;
    case ERROR_NON_FINITE_COORDINATE:
      locate_coordinate(vpm);
      break;
    case ERROR_NO_SIMPLICIAL_COMPLEX:
      locate_singularity();
      break;
    case ERROR_TOO_FEW_VERTICES:
      m_defect.count = number_of_used_vertices();
      say("only " + std::to_string(m_defect.count) + " vertices have a face",
          "The smallest closed surface is a tetrahedron, with four vertices.");
      break;
    case ERROR_SEVERAL_COMPONENTS:
      locate_components();
      break;
    case ERROR_NO_TOPOLOGICAL_SPHERE:
      measure_genus();
      break;
    default: // the defect concerns the mesh as a whole
      m_defect.message = get_error_message(error);
    }
    return m_defect;
  }

private:
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

  void say(const std::string& what, const std::string& advice)
  {
    m_defect.message = what + ".\n" + advice;
    if(m_defect.vertex != Traits::null_vertex() || m_defect.face != Traits::null_face())
      m_defect.message += "\n(Vertices and faces are counted from 0.)";
  }

  // The position of `element` in `range`.
  template <class Range, class Element>
  static std::string number_of(const Range& range, const Element& element)
  {
    return std::to_string(std::distance(range.begin(), std::find(range.begin(), range.end(), element)));
  }

  std::string name(vertex_descriptor v) const { return "vertex " + number_of(vertices(m_mesh), v); }
  std::string name(face_descriptor f) const { return "face " + number_of(faces(m_mesh), f); }
  std::string name_of_edge() const
  {
    return "the edge between the vertices " + number_of(vertices(m_mesh), m_defect.vertex) + " and " +
           number_of(vertices(m_mesh), m_defect.other_vertex);
  }

  // A note on the number of other occurrences.
  std::string in_total(const char* what) const
  {
    return m_defect.count > 1 ? " (" + std::to_string(m_defect.count) + " such " + what + " in total)" : "";
  }

  bool is_used(vertex_descriptor v) const { return halfedge(v, m_mesh) != Traits::null_halfedge(); }

  std::size_t number_of_used_vertices() const
  {
    const auto range = vertices(m_mesh);
    return static_cast<std::size_t>(
        std::count_if(range.begin(), range.end(), [&](vertex_descriptor v) { return is_used(v); }));
  }

  void locate_polygon()
  {
    for(const face_descriptor f : faces(m_mesh))
      if(!is_triangle(halfedge(f, m_mesh), m_mesh) && m_defect.count++ == 0)
        m_defect.face = f;
    say(name(m_defect.face) + " is not a triangle but has " + std::to_string(degree(m_defect.face, m_mesh)) +
            " corners" + in_total("faces"),
        "repair_surface() triangulates it.");
  }

  void locate_border()
  {
    std::size_t n_halfedges_without_face = 0; // of edges without any
    for(const halfedge_descriptor h : halfedges(m_mesh))
    {
      if(!is_border(h, m_mesh))
        continue;
      const bool has_face = !is_border(opposite(h, m_mesh), m_mesh);
      ++(has_face ? m_defect.count : n_halfedges_without_face);
      // An edge with one face is more informative than one without any.
      if(m_defect.vertex == Traits::null_vertex() || (has_face && m_defect.face == Traits::null_face()))
      {
        m_defect.vertex = source(h, m_mesh);
        m_defect.other_vertex = target(h, m_mesh);
        m_defect.face = face(opposite(h, m_mesh), m_mesh);
      }
    }
    m_defect.count += n_halfedges_without_face / 2;
    say("the mesh has a border: " + name_of_edge() + " belongs to " +
            (m_defect.face == Traits::null_face() ? "no face" : "one face only, " + name(m_defect.face)) +
            in_total("edges"),
        "repair_surface() fills holes, and joins faces that do not share their vertices.");
  }

  template <class VertexPointMap>
  void locate_coordinate(const VertexPointMap& vpm)
  {
    for(const vertex_descriptor v : vertices(m_mesh))
      if(is_used(v))
      {
        const auto& p = get(vpm, v);
        if(!is_finite({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}) &&
           m_defect.count++ == 0)
          m_defect.vertex = v;
      }
    say(name(m_defect.vertex) + " has a coordinate that is infinite or not a number" + in_total("vertices"),
        "Repair the file, or the program that wrote it.");
  }

  // Repeated edges take precedence: the faces at their ends may look like several fans as well.
  void locate_singularity()
  {
    const auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), m_mesh);
    std::size_t n = 0;
    for(const vertex_descriptor v : vertices(m_mesh))
      put(index, v, n++);
    std::vector<std::size_t> last_seen_at(n, n), last_counted_at(n, n);
    // Walking around a vertex may not reach all of its halfedges.
    std::vector<std::vector<halfedge_descriptor>> halfedges_at(n);
    for(const halfedge_descriptor h : halfedges(m_mesh))
      halfedges_at[get(index, target(h, m_mesh))].push_back(h);

    std::size_t n_pinches = 0, fan_size = 0, i = 0;
    vertex_descriptor first_pinch = Traits::null_vertex();
    for(const vertex_descriptor v : vertices(m_mesh))
    {
      for(const halfedge_descriptor h : halfedges_at[i])
      {
        const vertex_descriptor w = source(h, m_mesh);
        const std::size_t j = get(index, w);
        const bool is_repeated = last_seen_at[j] == i || w == v;
        last_seen_at[j] = i;
        if(!is_repeated || last_counted_at[j] == i || j < i) // counted already, here or at its other end
          continue;
        last_counted_at[j] = i;
        if(m_defect.count++ == 0)
        {
          m_defect.vertex = v;
          m_defect.other_vertex = w;
        }
      }
      std::size_t size = 0;
      if(!halfedges_at[i].empty())
        size = halfedges_around_target(halfedges_at[i].front(), m_mesh).size();
      if(size < halfedges_at[i].size() && n_pinches++ == 0)
      {
        first_pinch = v;
        fan_size = size;
      }
      ++i;
    }
    if(m_defect.count > 0)
    {
      say(name_of_edge() + " occurs more than once" + in_total("edges"),
          "repair_surface() divides all but one of them.");
      return;
    }
    m_defect.vertex = first_pinch;
    m_defect.count = n_pinches;
    say("the surface touches itself in " + name(m_defect.vertex) + ": a fan of " + std::to_string(fan_size) +
            " faces and others meet in nothing but this vertex" + in_total("vertices"),
        "repair_surface() makes several vertices of it.");
  }

  void locate_components()
  {
    const auto is_seen = get(CGAL::dynamic_face_property_t<bool>(), m_mesh);
    for(const face_descriptor f : faces(m_mesh))
      put(is_seen, f, false);
    std::vector<std::size_t> sizes;
    std::vector<face_descriptor> firsts, stack;
    for(const face_descriptor first : faces(m_mesh))
    {
      if(get(is_seen, first))
        continue;
      firsts.push_back(first);
      sizes.push_back(0);
      const auto visit = [&](face_descriptor f) {
        if(get(is_seen, f))
          return;
        put(is_seen, f, true);
        stack.push_back(f);
        ++sizes.back();
      };
      visit(first);
      while(!stack.empty())
      {
        const halfedge_descriptor border = halfedge(stack.back(), m_mesh);
        stack.pop_back();
        for(const halfedge_descriptor h : halfedges_around_face(border, m_mesh))
          visit(face(opposite(h, m_mesh), m_mesh));
      }
    }
    CGAL_assertion(sizes.size() > 1);
    m_defect.count = sizes.size();
    m_defect.vertex = target(halfedge(firsts[0], m_mesh), m_mesh);
    m_defect.other_vertex = target(halfedge(firsts[1], m_mesh), m_mesh);
    say("the mesh consists of " + std::to_string(sizes.size()) + " parts: " + name(firsts[0]) + " belongs to one of " +
            std::to_string(sizes[0]) + " faces, " + name(firsts[1]) + " to another one of " + std::to_string(sizes[1]),
        "Map each of them on its own; or repair_surface() keeps the largest.");
  }

  void measure_genus()
  {
    // Euler: V - E + F = 2 - 2 g, with E = 3 F / 2
    const auto range = faces(m_mesh); // num_faces() may count removed ones
    const auto f = static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    const std::size_t v = number_of_used_vertices(), e = f / 2 * 3, g = (2 + e - v - f) / 2;
    m_defect.count = g;
    say("the surface has the genus " + std::to_string(g) + ", that is, " + std::to_string(g) +
            (g == 1 ? " handle" : " handles") + ", as on a torus (Euler characteristic " +
            (g == 1 ? "0" : "-" + std::to_string(2 * g - 2)) + ": " + std::to_string(v) + " vertices, " +
            std::to_string(e) + " edges, " + std::to_string(f) + " faces); a sphere has none",
        "repair_surface() cuts handles, and find_handles() finds them.");
  }

  const TriangleMesh& m_mesh;
  Defect m_defect;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MESH_DEFECT_LOCATOR_H
