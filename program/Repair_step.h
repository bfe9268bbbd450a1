#ifndef PROGRAM_REPAIR_STEP_H
#define PROGRAM_REPAIR_STEP_H

#include "read_file.h"

#include <CGAL/Spherical_parameterization/Repair/repair_surface.h>

namespace Program {

/// Settings of the repair of a surface.
struct Repair_settings
{
  SP::Repair_limits limits;
  double alpha = 0.; ///< of alpha wrapping, as a fraction of the bounding box diagonal; 0 without wrapping
};

/// The repair of a surface: what it has changed, and the sources of the vertices and faces of the result. By default, nothing.
class Repair_step
{
public:
  static constexpr std::size_t none = SP::Repaired_surface<Point_3>::none; ///< for new vertices and faces

  Repair_step() = default;

  /// repairs the surface of a file and replaces it by the result; see `SP::repair_surface()`.
  Repair_step(const Repair_settings& settings, File_content& surface);

  /// returns whether the surface is new. If not, all vertices and faces are those of the file.
  bool has_changed_surface() const { return !m_vertices.empty(); }

  /// returns whether the result is a wrapping of the surface of the file, with new vertices and faces.
  bool is_wrapped() const { return m_number_of_wrapping_faces > 0; }

  /// returns the report of the repair; of a wrapped surface, that of the wrapping.
  const SP::Repair_report& report() const { return m_report; }

  /// returns the report in words.
  Words descriptions() const;

  /// returns whether a face belongs to a hole patch: of a hole, or of one side of a cut handle.
  bool is_patch(std::size_t face) const { return face < m_faces.size() && m_faces[face] == none; }

  /// returns for each vertex and face of the result the vertex or face of the file that it is, or is part of, or `none`. They are empty
  /// without a new surface.
  const std::vector<std::size_t>& source_vertices() const { return m_vertices; }
  const std::vector<std::size_t>& source_faces() const { return m_faces; }

  /// returns the surface of the file; empty if it is unchanged.
  const SP::internal::Polygon_soup& file() const { return m_file; }

  /// returns the vertex of the result for a vertex of the file, the first if it was divided; or `none`.
  std::size_t vertex_of(std::size_t vertex_of_file) const;

  /// transfers values of the vertices and faces of the file to the result, if their number matches. On patches, floating-point values are
  /// interpolated, and integers are copied from a neighbour.
  ///
  /// \param triangles of the result
  void transfer(File_content& values, const std::vector<Polygon>& triangles) const;

  /// transfers points in the same way.
  std::vector<Point_3> transferred(const std::vector<Point_3>& points, const std::vector<Polygon>& triangles) const;

private:
  SP::Repair_report m_report;
  std::size_t m_number_of_wrapping_faces = 0;
  SP::internal::Polygon_soup m_file;
  std::vector<std::size_t> m_vertices, m_faces;
};

/// returns a closed surface around points and polygons, computed by `CGAL::alpha_wrap_3()`.
///
/// \param alpha as a fraction of the bounding box diagonal
File_content wrapping_of(const File_content& surface, double alpha);

} // namespace Program

#endif // PROGRAM_REPAIR_STEP_H
