#ifndef PROGRAM_MATCH_REFINEMENT_H
#define PROGRAM_MATCH_REFINEMENT_H

#include "Input_mesh.h"

#include <CGAL/Spherical_parameterization/Surface_maps/Surface_mapper_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/map_surface.h>
#include <CGAL/Spherical_parameterization/Surface_maps/split_bent_faces.h>
#include <CGAL/Spherical_parameterization/Surface_maps/split_blocking_edges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace Program {

/// How a surface is refined on another one, as long as that pays.
class Match_refinement
{
public:
  using Mapper = SP::Surface_mapper_3<Mesh>;

  /// returns the value of a vertex from those of the first ones: a new one has the mean of the ends of its edge.
  double value_at(const std::vector<double>& values, Vertex_index v) const
  {
    if(v.idx() < values.size())
      return values[v];
    const std::size_t k = v.idx() - values.size();
    return k < m_ends.size() ? 0.5 * (value_at(values, m_ends[k][0]) + value_at(values, m_ends[k][1])) : 0.;
  }

  /// returns whether a vertex counts, where the first ones say so: a new one does if both ends of its edge do.
  bool counts_at(const std::vector<char>& counts, Vertex_index v) const
  {
    if(v.idx() < counts.size())
      return counts[v] != 0;
    const std::size_t k = v.idx() - counts.size();
    return k < m_ends.size() && counts_at(counts, m_ends[k][0]) && counts_at(counts, m_ends[k][1]);
  }

  /// splits edges that block landmarks, and faces that bend over much of the second surface, and maps the first one again, until
  /// two rounds have not lowered the energy by a hundredth of what it has above that of an isometry, or vertices are half as many
  /// again. (One round alone often raises it, where a face next to a landmark is stretched.)
  ///
  /// \param map maps the mesh that it is given, from the directions that its vertices have to new ones, by a mapper
  template <class Map>
  void run(Mesh& mesh, Sphere_map& directions, const Mesh& target, const Sphere_map& sphere2,
           const Mapper& first_mapper, const std::vector<Mapper::Landmark>& landmarks, SP::Surface_map_report& report,
           const Map& map)
  {
    constexpr int max_rounds = 6, max_failures = 2;
    constexpr double min_gain = 0.01;
    m_energy_before = report.energy;
    const std::size_t max_vertices = mesh.number_of_vertices() + mesh.number_of_vertices() / 2;
    m_parents.assign(mesh.faces().begin(), mesh.faces().end());
    std::size_t n_missed = report.number_of_missed_landmarks;
    Mapper mapper = first_mapper.keep_alignment();
    Mesh trial = mesh;
    Match_refinement best = *this;
    for(int round = 0, n_failures = 0; round < max_rounds && n_failures < max_failures &&
                                       trial.number_of_vertices() < max_vertices && !is_at_end(report);
        ++round)
    {
      Sphere_map moved = directions_of(trial);
      std::vector<SP::Split_edge<Mesh>> blocking, bent;
      if(n_missed > 0)
        check(SP::split_blocking_edges(trial, moved, moved, sphere2, landmarks, blocking));
      add(blocking);
      if(const std::size_t n = trial.number_of_vertices(); n < max_vertices)
        check(SP::split_bent_faces(trial, moved, target, sphere2, max_vertices - n, bent));
      add(bent);
      if(blocking.empty() && bent.empty())
        break;
      map(trial, moved, mapper);
      const SP::Surface_map_report& next = mapper.report();
      n_missed = next.number_of_missed_landmarks;
      report.number_of_sweeps += next.number_of_sweeps;
      const bool is_lower = next.energy > 0. && next.energy - 2. < (1. - min_gain) * (report.energy - 2.);
      ++n_failures;
      if(n_missed < report.number_of_missed_landmarks || (is_lower && n_missed == report.number_of_missed_landmarks))
      {
        n_failures = 0;
        mesh = trial;
        best = *this;
        report.energy = next.energy;
        report.distortion = next.distortion;
        report.landmark_distances = next.landmark_distances;
        report.number_of_missed_landmarks = n_missed;
      }
      report.stop_reason = next.stop_reason;
    }
    directions = directions_of(mesh);
    *this = std::move(best);
  }

  /// returns the directions of the vertices of a mesh; a vertex without a face stays at the origin.
  static Sphere_map directions_of(Mesh& mesh)
  {
    return mesh.add_property_map<Vertex_index, Point_3>("v:directions", Point_3(0, 0, 0)).first;
  }

  std::size_t number_of_new_vertices() const { return m_ends.size(); }
  double energy_before() const { return m_energy_before; }

  /// returns for each face of the refined surface the one that it is a part of; empty if nothing was to be refined.
  const std::vector<Mesh::Face_index>& parents() const { return m_parents; }

private:
  // Whether no further round may be made, or its energy could not be compared.
  static bool is_at_end(const SP::Surface_map_report& report)
  {
    return report.stop_reason == SP::STOPPED || report.stop_reason == SP::TIME_LIMIT || report.is_energy_sampled;
  }

  static void check(SP::Error_code error)
  {
    if(error != SP::OK)
      throw Program_error(SP::get_error_message(error));
  }

  void add(const std::vector<SP::Split_edge<Mesh>>& edges)
  {
    for(const SP::Split_edge<Mesh>& edge : edges)
    {
      m_ends.push_back(edge.ends);
      for(std::size_t k = 0; k < 2; ++k)
      {
        m_parents.resize((std::max)(m_parents.size(), std::size_t(edge.faces[k]) + 1));
        m_parents[edge.faces[k]] = m_parents[edge.halved_faces[k]];
      }
    }
  }

  std::vector<std::array<Vertex_index, 2>> m_ends; // of the edges that the new vertices have split
  std::vector<Mesh::Face_index> m_parents;
  double m_energy_before = 0.;
};

} // namespace Program

#endif // PROGRAM_MATCH_REFINEMENT_H
