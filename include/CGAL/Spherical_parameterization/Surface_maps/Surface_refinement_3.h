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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_REFINEMENT_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_REFINEMENT_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_mapper_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/split_bent_faces.h>
#include <CGAL/Spherical_parameterization/Surface_maps/split_blocking_edges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// The class `Surface_refinement_3` refines a surface in order to improve its map onto another surface, as long as this lowers
/// the energy.
///
/// It repeats `split_blocking_edges()`, `split_bent_faces()` and `map_surface()`, and records the new vertices and faces.
///
/// \tparam Mesh `CGAL::Surface_mesh`, for both surfaces
template <class Mesh>
class Surface_refinement_3
{
public:
  /// Type of a vertex
  using Vertex_index = typename Mesh::Vertex_index;
  /// Type of a face
  using Face_index = typename Mesh::Face_index;
  /// Type of a map from vertices to points
  using Direction_map = typename Mesh::template Property_map<Vertex_index, typename Mesh::Point>;
  /// Type of the method
  using Mapper = Surface_mapper_3<Mesh>;

  /// returns the value at vertex `v` of a function that is given by its `values` at the original vertices. The value at a new
  /// vertex is the mean of the values at both ends of the edge that it splits.
  double value_at(const std::vector<double>& values, Vertex_index v) const
  {
    if(v.idx() < values.size())
      return values[v];
    const std::size_t k = v.idx() - values.size();
    return k < m_ends.size() ? 0.5 * (value_at(values, m_ends[k][0]) + value_at(values, m_ends[k][1])) : 0.;
  }

  /// returns whether vertex `v` is included, given `counts` for the original vertices. A new vertex is included if both ends
  /// of the edge that it splits are.
  bool counts_at(const std::vector<char>& counts, Vertex_index v) const
  {
    if(v.idx() < counts.size())
      return counts[v] != 0;
    const std::size_t k = v.idx() - counts.size();
    return k < m_ends.size() && counts_at(counts, m_ends[k][0]) && counts_at(counts, m_ends[k][1]);
  }

  /// splits edges that block landmarks and faces that bend over large parts of the second surface, and maps the first surface
  /// again.
  ///
  /// The loop ends after two consecutive rounds without success, after six rounds, if the number of vertices has grown by half,
  /// if no edge is left to split, or if the run is stopped or its energy sampled. A round is successful if fewer landmarks are
  /// missed, or if as many are missed and the difference between the energy and 2, the energy of an isometry, is reduced by
  /// more than one percent. The result of the last successful round is kept. A single round may raise the energy, because a
  /// face next to a landmark is stretched.
  ///
  /// \tparam VertexSphereMap2 a model of `ReadablePropertyMap` from the vertices of `tmesh2` to their images
  /// \tparam Map a function object
  ///
  /// \param tmesh1 the first surface, which has been mapped by `mapper`; it is refined
  /// \param directions the map returned by `directions_of()` for `tmesh1`, with the directions found by the mapper; it receives
  ///        the directions of the refined surface
  /// \param tmesh2,sphere2 the second surface and its map to the sphere
  /// \param first_mapper the method. Its features and masks must be defined at new vertices, for example by `value_at()` and
  ///        `counts_at()`
  /// \param landmarks the landmarks of the method
  /// \param report the report of the method; it is updated
  /// \param map a function object: `map(mesh, directions, mapper)` computes new directions for the vertices of `mesh` from the
  ///        given ones with `mapper`, as `map_surface()` does, and returns an error code
  ///
  /// \return `OK`, or the first error of these functions
  template <class VertexSphereMap2, class Map>
  Error_code refine(Mesh& tmesh1, Direction_map& directions, const Mesh& tmesh2, VertexSphereMap2 sphere2,
                    const Mapper& first_mapper, const std::vector<typename Mapper::Landmark>& landmarks,
                    Surface_map_report& report, const Map& map)
  {
    constexpr int max_rounds = 6, max_failures = 2;
    constexpr double min_gain = 0.01;
    m_energy_before = report.energy;
    const std::size_t max_vertices = tmesh1.number_of_vertices() + tmesh1.number_of_vertices() / 2;
    m_parents.assign(tmesh1.faces().begin(), tmesh1.faces().end());
    std::size_t n_missed = report.number_of_missed_landmarks;
    Mapper mapper = first_mapper.keep_alignment();
    Mesh trial = tmesh1;
    Surface_refinement_3 best = *this;
    for(int round = 0, n_failures = 0; round < max_rounds && n_failures < max_failures &&
                                       trial.number_of_vertices() < max_vertices && !is_at_end(report);
        ++round)
    {
      Direction_map moved = directions_of(trial);
      std::vector<Split_edge<Mesh>> blocking, bent;
      Error_code error = OK;
      if(n_missed > 0)
        error = split_blocking_edges(trial, moved, moved, sphere2, landmarks, blocking);
      add(blocking);
      if(const std::size_t n = trial.number_of_vertices(); error == OK && n < max_vertices)
        error = split_bent_faces(trial, moved, tmesh2, sphere2, max_vertices - n, bent);
      if(error != OK)
        return error;
      add(bent);
      if(blocking.empty() && bent.empty())
        break;
      if(const Error_code failure = map(trial, moved, mapper))
        return failure;
      const Surface_map_report& next = mapper.report();
      n_missed = next.number_of_missed_landmarks;
      report.number_of_sweeps += next.number_of_sweeps;
      const bool is_lower = next.energy > 0. && next.energy - 2. < (1. - min_gain) * (report.energy - 2.);
      ++n_failures;
      if(n_missed < report.number_of_missed_landmarks || (is_lower && n_missed == report.number_of_missed_landmarks))
      {
        n_failures = 0;
        tmesh1 = trial;
        best = *this;
        report.energy = next.energy;
        report.distortion = next.distortion;
        report.landmark_distances = next.landmark_distances;
        report.number_of_missed_landmarks = n_missed;
      }
      report.stop_reason = next.stop_reason;
    }
    directions = directions_of(tmesh1);
    *this = std::move(best);
    return OK;
  }

  /// returns a map for the directions of the vertices of `mesh`; it is added to the mesh with all points at the origin if it
  /// does not exist.
  static Direction_map directions_of(Mesh& mesh)
  {
    using Point_3 = typename Mesh::Point;
    return mesh.template add_property_map<Vertex_index, Point_3>("v:directions", Point_3(0, 0, 0)).first;
  }

  /// returns the number of new vertices.
  std::size_t number_of_new_vertices() const { return m_ends.size(); }

  /// returns the energy of the map of the original surface.
  double energy_before() const { return m_energy_before; }

  /// returns the original face that contains each face of the refined surface; the range is empty if `refine()` has not been
  /// called.
  const std::vector<Face_index>& parents() const { return m_parents; }

private:
  // Returns whether the loop must end, because the run was stopped or because sampled energies cannot be compared.
  static bool is_at_end(const Surface_map_report& report)
  {
    return report.stop_reason == STOPPED || report.stop_reason == TIME_LIMIT || report.is_energy_sampled;
  }

  void add(const std::vector<Split_edge<Mesh>>& edges)
  {
    for(const Split_edge<Mesh>& edge : edges)
    {
      m_ends.push_back(edge.ends);
      for(std::size_t k = 0; k < 2; ++k)
      {
        m_parents.resize((std::max)(m_parents.size(), std::size_t(edge.faces[k]) + 1));
        m_parents[edge.faces[k]] = m_parents[edge.halved_faces[k]];
      }
    }
  }

  std::vector<std::array<Vertex_index, 2>> m_ends; // the ends of the edge that each new vertex splits
  std::vector<Face_index> m_parents;
  double m_energy_before = 0.;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_SURFACE_REFINEMENT_3_H
