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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_SPHERE_CELLS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_SPHERE_CELLS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/locate/Cube_location.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A triangulation of the sphere with cells of about the same size: the squares of a cube's sides are halved, and their
// corners are projected to the sphere. A deformation of the sphere moves the nodes tangentially and is linear in the
// cells.
class Sphere_cells
{
public:
  struct Cell
  {
    std::array<std::uint32_t, 3> nodes = {};
    Vector_3d x = {}, y = {}; // a frame of its plane
    // For both coordinates of each node, the derivative of the deformation, in the frame, with respect to this
    // coordinate: the entries 00, 01, 10 and 11.
    std::array<std::array<double, 4>, 6> motions = {};

    bool is_empty() const { return nodes[0] == nodes[1]; }
  };

  // Each side of the cube has n x n squares.
  explicit Sphere_cells(std::size_t n)
    : m_n(n)
  {
    std::vector<std::pair<std::array<long, 3>, std::size_t>> places; // of the nodes, with integer coordinates
    std::vector<Vector_3d> directions;
    Cube_location::for_each_node(n, [&](std::size_t side, double u, double v) {
      const Vector_3d p = Cube_location::point(side, u, v);
      const auto coordinate = [&](double x) { return std::lround(x * static_cast<double>(n)); };
      places.push_back({{coordinate(p[0]), coordinate(p[1]), coordinate(p[2])}, places.size()});
      directions.push_back(normalized(p));
    });
    std::sort(places.begin(), places.end());
    m_node_at.resize(places.size());
    for(std::size_t k = 0; k < places.size(); ++k)
    {
      if(k == 0 || places[k].first != places[k - 1].first)
        m_frames.emplace_back(directions[places[k].second]);
      m_node_at[places[k].second] = static_cast<std::uint32_t>(m_frames.size() - 1);
    }
    m_cells.resize(2 * places.size());
    const std::size_t row = n + 1;
    for(std::size_t place = 0; place < places.size(); ++place)
      if(place % row < n && place / row % row < n)
      {
        m_cells[2 * place] = make_cell({place, place + 1, place + row + 1}, directions);
        m_cells[2 * place + 1] = make_cell({place, place + row, place + row + 1}, directions);
      }
  }

  const std::vector<Tangent_frame>& frames() const { return m_frames; } // of the nodes
  const std::vector<Cell>& cells() const { return m_cells; }            // some of them are empty

  // The index of the cell that contains direction p, in each lane.
  template <class FT>
  std::array<std::size_t, Lanes<FT>::width> cells_at(const Vector_3<FT>& p) const
  {
    return Basic_cube_location<FT>(p, m_n).half().index;
  }

  // The displacement of p by the deformation that moves each node by its step.
  template <class FT>
  Vector_3<FT> step_at(const Vector_3<FT>& p, const std::vector<Vector_3d>& steps) const
  {
    const typename Basic_cube_location<FT>::Half half = Basic_cube_location<FT>(p, m_n).half();
    Vector_3<FT> result = {FT(0.), FT(0.), FT(0.)};
    for(std::size_t k = 0; k < 3; ++k)
    {
      std::array<std::uint32_t, Lanes<FT>::width> nodes;
      for(std::size_t lane = 0; lane < nodes.size(); ++lane)
        nodes[lane] = m_node_at[half.nodes[k][lane]];
      result = result + half.weights[k] * points_in_lanes<FT>(nodes.data(), steps.data());
    }
    return result;
  }

private:
  Cell make_cell(const std::array<std::size_t, 3>& places, const std::vector<Vector_3d>& directions) const
  {
    Cell result;
    for(std::size_t k = 0; k < 3; ++k)
      result.nodes[k] = m_node_at[places[k]];
    const Vector_3d to_1 = directions[places[1]] - directions[places[0]],
                    to_2 = directions[places[2]] - directions[places[0]];
    result.x = normalized(to_1);
    const double a = length(to_1), b = dot(to_2, result.x);
    result.y = normalized(to_2 - b * result.x);
    const double c = dot(to_2, result.y);
    // The gradients of the basis functions, which are 1 at one node and 0 at the others.
    const std::array<double, 2> slope_1 = {1. / a, -b / (a * c)}, slope_2 = {0., 1. / c};
    const std::array<std::array<double, 2>, 3> slopes = {
        {{-slope_1[0] - slope_2[0], -slope_1[1] - slope_2[1]}, slope_1, slope_2}};
    for(std::size_t k = 0; k < 6; ++k)
    {
      const Vector_3d t = m_frames[result.nodes[k / 2]].vector_of(k % 2 == 0 ? 1. : 0., k % 2 == 0 ? 0. : 1.);
      const double x = dot(t, result.x), y = dot(t, result.y);
      const std::array<double, 2>& slope = slopes[k / 2];
      result.motions[k] = {x * slope[0], x * slope[1], y * slope[0], y * slope[1]};
    }
    return result;
  }

  std::size_t m_n;
  std::vector<std::uint32_t> m_node_at; // of the nodes of a Cube_location, which has nodes on edges more than once
  std::vector<Tangent_frame> m_frames;
  std::vector<Cell> m_cells;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_SPHERE_CELLS_H
