#ifndef PROGRAM_SURFACE_REPAIR_H
#define PROGRAM_SURFACE_REPAIR_H

#include "read_file.h"

#include <CGAL/Spherical_parameterization/Repair/repair_surface.h>

namespace Program {

/// What is done to a surface before it is mapped.
struct Repair_settings
{
  SP::Repair_limits limits;
  double alpha = 0.; ///< of a wrapping, as a share of the diagonal of the surface; 0 if it is not wrapped
};

/// What the repair of a surface has done, and where the vertices and faces of the result are from. By default, nothing.
class Surface_repair
{
public:
  static constexpr std::size_t none = SP::Repaired_surface<Point_3>::none; ///< no vertex or face of the file

  Surface_repair() = default;

  /// repairs the surface of a file, which is replaced by the result; see `SP::repair_surface()`.
  Surface_repair(const Repair_settings& settings, File_content& surface);

  /// returns whether there is a new surface. If not, all vertices and faces are those of the file.
  bool has_changed_surface() const { return !m_vertices.empty(); }

  /// returns whether the result was wrapped around the surface of the file, so that nothing of that is left.
  bool is_wrapped() const { return m_number_of_wrapping_faces > 0; }

  /// returns what the repair has found and done; of a wrapped surface, with the wrapping.
  const SP::Repair_report& report() const { return m_report; }

  /// returns the same in words.
  Words descriptions() const;

  /// returns whether a face is new, as it closes a hole, or one side of a cut through a handle.
  bool is_patch(std::size_t face) const { return face < m_faces.size() && m_faces[face] == none; }

  /// returns which vertex and which face of the file those of the result are, or parts of, or `none`. Without a new surface, they are
  /// empty.
  const std::vector<std::size_t>& source_vertices() const { return m_vertices; }
  const std::vector<std::size_t>& source_faces() const { return m_faces; }

  /// returns the surface of the file. It is empty if that has not been changed.
  const SP::internal::Polygon_soup& file() const { return m_file; }

  /// returns which vertex of the result one of the file is, the first if it was divided; or `none`.
  std::size_t vertex_of(std::size_t vertex_of_file) const;

  /// turns values of the vertices and faces of the file into those of the result, if they are so many. On patches, numbers with
  /// fractions are interpolated, others are those of a neighbour.
  ///
  /// \param triangles of the result
  void carry(File_content& values, const std::vector<Polygon>& triangles) const;

  /// does the same with points.
  std::vector<Point_3> carried(const std::vector<Point_3>& points, const std::vector<Polygon>& triangles) const;

private:
  SP::Repair_report m_report;
  std::size_t m_number_of_wrapping_faces = 0;
  SP::internal::Polygon_soup m_file;
  std::vector<std::size_t> m_vertices, m_faces;
};

/// wraps a closed surface around points and polygons, by `CGAL::alpha_wrap_3()`.
///
/// \param alpha as a share of the diagonal
File_content wrapping_of(const File_content& surface, double alpha);

} // namespace Program

#endif // PROGRAM_SURFACE_REPAIR_H
