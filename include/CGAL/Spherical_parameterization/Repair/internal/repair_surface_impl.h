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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_REPAIR_SURFACE_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_REPAIR_SURFACE_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Repair/internal/Border_closer.h>
#include <CGAL/Spherical_parameterization/Repair/internal/Glued_triangles.h>
#include <CGAL/Spherical_parameterization/Repair/internal/Handle_cycles.h>
#include <CGAL/Spherical_parameterization/Repair/internal/Soup_gluer.h>
#include <CGAL/Spherical_parameterization/Repair/repair_surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The steps of repair_surface(), in order.
class Surface_repair
{
public:
  using Index = Glued_triangles::Index;
  static constexpr Index none = Glued_triangles::none;

  Surface_repair(std::vector<Vector_3d> points, const Polygon_corners& polygons, const Repair_limits& limits,
                 Repair_report& report)
    : m_limits(limits)
    , m_report(report)
    , m_closer(m_mesh)
    , m_exponent(normalize(points, &m_origin))
  {
    Soup_gluer gluer(points, polygons, report);
    m_mesh = Repaired_triangles(std::move(gluer.surface), std::move(points));
    m_mesh.faces = std::move(gluer.faces);
  }

  Error_code run()
  {
    if(m_mesh.surface.number_of_triangles() == 0)
      return fail(ERROR_EMPTY_MESH, "there is no face with three different corners");
    keep_largest_component();
    if(const std::size_t n = m_mesh.separate_fans())
      m_report.divided_vertices = {n, std::size_t(m_mesh.vertices[m_mesh.vertices.size() - n])};
    m_unit = std::sqrt(area_of([](Index) { return true; }));
    close_holes();
    cut_handles(
        m_mesh, (std::numeric_limits<std::size_t>::max)(),
        [&](const Handle_cycles::Cycle& cycle, double) {
          m_report.handle_cycles.emplace_back();
          for(const Index side : cycle)
            m_report.handle_cycles.back().push_back(m_mesh.vertices[m_mesh.surface.source(side)]);
        },
        [&](const std::vector<Index>& border) { close(border, true); });
    if(const Error_code error = check_lengths())
      return error;
    if(m_limits.refines_patches)
      for(Index k = 0; k < m_report.patches.size(); ++k)
        m_closer.refine(k);
    measure_patches();
    if(const Error_code error = check_added_area())
      return error;
    split_repeated_edges(m_mesh, [&](Index side) { m_report.split_edges.add(vertex_of_input({side})); });
    return OK;
  }

  // Writes the surface, without isolated vertices unless it needed no repair.
  Error_code write(Repaired_arrays& result)
  {
    const std::size_t n = m_mesh.points.size();
    std::vector<Index> number(n, none);
    for(Index side = 0; side < m_mesh.surface.number_of_sides(); ++side)
      number[m_mesh.surface.source(side)] = 0;
    std::size_t n_used = 0;
    for(std::size_t v = 0; v < n; ++v)
    {
      n_used += number[v] == 0;
      if(number[v] != 0 && !m_report.is_empty())
        continue;
      number[v] = static_cast<Index>(result.points.size());
      const Vector_3d& p = m_mesh.points[v];
      result.points.push_back(m_origin + Vector_3d{std::ldexp(p[0], m_exponent), std::ldexp(p[1], m_exponent),
                                                   std::ldexp(p[2], m_exponent)});
      result.source_vertices.push_back(Index(m_mesh.vertices[v]));
    }
    if(n_used < 4)
      return fail(ERROR_TOO_FEW_VERTICES, "the surface has fewer than four vertices");
    for(Index t = 0; t < m_mesh.surface.number_of_triangles(); ++t)
    {
      const auto [a, b, c] = m_mesh.surface.triangle(t);
      result.triangles.push_back({number[a], number[b], number[c]});
    }
    result.source_faces = std::move(m_mesh.faces);
    return OK;
  }

private:
  template <class... Text>
  Error_code fail(Error_code error, const Text&... text)
  {
    std::ostringstream message;
    message.imbue(std::locale::classic());
    message.precision(4);
    (message << ... << text);
    m_report.message = message.str();
    return error;
  }

  template <class Function>
  double area_of(const Function& is_counted) const
  {
    double result = 0.;
    for(Index t = 0; t < m_mesh.surface.number_of_triangles(); ++t)
      if(is_counted(t))
        result += m_mesh.area_of(t);
    return result;
  }

  void keep_largest_component()
  {
    const std::vector<Index> component = m_mesh.surface.components();
    std::vector<double> areas(component.size(), -1.);
    for(Index t = 0; t < component.size(); ++t)
      areas[component[t]] = (std::max)(areas[component[t]], 0.) + m_mesh.area_of(t);
    m_report.number_of_components =
        static_cast<std::size_t>(std::count_if(areas.begin(), areas.end(), [](double area) { return area >= 0.; }));
    if(m_report.number_of_components == 1)
      return;
    const Index largest = static_cast<Index>(std::max_element(areas.begin(), areas.end()) - areas.begin());
    const auto is_kept = [&](std::size_t t) { return component[t] == largest; };
    for(std::size_t t = 0; t < component.size(); ++t)
      if(!is_kept(t))
        m_report.removed_faces.add(m_mesh.faces[t]);
    m_mesh.surface.keep(is_kept);
    std::size_t n = 0;
    for(std::size_t t = 0; t < component.size(); ++t)
      if(is_kept(t))
        m_mesh.faces[n++] = Index(m_mesh.faces[t]);
    m_mesh.faces.resize(n);
    m_mesh.patches.resize(n);
  }

  void close(const std::vector<Index>& border, bool is_of_handle)
  {
    if(m_closer.close(border) == none)
      return;
    double length = 0.;
    for(const Index side : border)
      length += std::sqrt(m_mesh.squared_length_of(side));
    m_report.patches.push_back(
        {is_of_handle, vertex_of_input(border), border.size(), std::ldexp(length, m_exponent), 0.});
    m_relative_lengths.push_back(m_unit > 0. ? length / m_unit : 0.);
  }

  // a border vertex that comes from the input, if any
  std::size_t vertex_of_input(const std::vector<Index>& border) const
  {
    for(const Index side : border)
      if(m_mesh.vertices[m_mesh.surface.source(side)] != none)
        return m_mesh.vertices[m_mesh.surface.source(side)];
    return 0;
  }

  void close_holes()
  {
    for(const std::vector<Index>& border : m_mesh.surface.borders())
      close(border, false);
  }

  void measure_patches()
  {
    for(Repair_patch& patch : m_report.patches)
      patch.share = 0.;
    const double area = area_of([](Index) { return true; });
    for(Index t = 0; t < m_mesh.surface.number_of_triangles() && area > 0.; ++t)
      if(m_mesh.patches[t] != none)
        m_report.patches[m_mesh.patches[t]].share += m_mesh.area_of(t) / area;
    m_report.added_area = 0.;
    for(const Repair_patch& patch : m_report.patches)
      m_report.added_area += patch.share;
  }

  Error_code check_lengths()
  {
    const std::vector<Repair_patch>& patches = m_report.patches;
    for(std::size_t k = 0; k < patches.size(); ++k)
    {
      const bool is_handle = patches[k].is_of_handle;
      const double limit = is_handle ? m_limits.maximum_handle : m_limits.maximum_hole;
      if(m_relative_lengths[k] > limit)
        return fail(is_handle ? ERROR_NO_TOPOLOGICAL_SPHERE : ERROR_NON_CLOSED_MESH,
                    is_handle ? "a handle is cut along a cycle of " : "a hole has a border of ",
                    patches[k].number_of_edges, " edges at vertex ", patches[k].vertex, ", whose length is ",
                    m_relative_lengths[k], " times the square root of the area, beyond the limit of ", limit);
    }
    return OK;
  }

  Error_code check_added_area()
  {
    if(m_report.added_area <= m_limits.maximum_added_area)
      return OK;
    const std::vector<Repair_patch>& patches = m_report.patches;
    const Repair_patch& largest = *std::max_element(patches.begin(), patches.end(),
                                                    [](const auto& a, const auto& b) { return a.share < b.share; });
    return fail(largest.is_of_handle ? ERROR_NO_TOPOLOGICAL_SPHERE : ERROR_NON_CLOSED_MESH,
                "closing the surface would add ", 100. * m_report.added_area, " % of its final area, and the limit is ",
                100. * m_limits.maximum_added_area, " %; the largest patch, ", 100. * largest.share, " %, fills a ",
                largest.is_of_handle ? "cut through a handle" : "hole", " of ", largest.number_of_edges,
                " edges at vertex ", largest.vertex);
  }

  const Repair_limits& m_limits;
  Repair_report& m_report;
  Repaired_triangles m_mesh;
  Border_closer m_closer;
  Vector_3d m_origin; // the origin of the coordinates of the repair, and its scale as a power of two
  int m_exponent;
  double m_unit = 0.;                     // the square root of the area without patches
  std::vector<double> m_relative_lengths; // for each patch
};

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code repair_arrays(std::vector<Vector_3d> points,
                                                                const Polygon_corners& polygons,
                                                                const Repair_limits& limits, Repaired_arrays& result,
                                                                Repair_report& report)
{
  if(!(limits.maximum_hole >= 0. && limits.maximum_handle >= 0. && limits.maximum_added_area >= 0.))
  {
    report.message = "a limit of the repair is negative or not a number";
    return ERROR_WRONG_PARAMETER;
  }
  for(const std::uint32_t v : polygons.corners)
    if(!is_finite(points[v]))
    {
      report.message = "vertex " + std::to_string(v) + " has a coordinate that is infinite or not a number";
      return ERROR_NON_FINITE_COORDINATE;
    }
  for(Vector_3d& p : points)
    if(!is_finite(p))
      p = {0., 0., 0.}; // an isolated vertex
  Surface_repair repair(std::move(points), polygons, limits, report);
  if(const Error_code error = repair.run())
    return error;
  return repair.write(result);
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REPAIR_INTERNAL_REPAIR_SURFACE_IMPL_H
