#ifndef PROGRAM_SURFACE_MATCH_H
#define PROGRAM_SURFACE_MATCH_H

#include "Run_report.h"
#include "surface_hints.h"

namespace CGAL::Spherical_parameterization {
template <class TriangleMesh1, class TriangleMesh2>
struct Surface_overlay_3;
template <class Mesh>
class Surface_refinement_3;
} // namespace CGAL::Spherical_parameterization

namespace Program {

using Overlay = SP::Surface_overlay_3<Mesh, Mesh>;

/// A mesh and its bijective map to the sphere.
struct Mapped_mesh
{
  /// reads a mesh and maps it according to the options.
  Mapped_mesh(const Options& options, const std::string& name);

  /// copies the mesh, so that several threads can use it concurrently.
  Mapped_mesh(const Mapped_mesh& other);
  Mapped_mesh& operator=(const Mapped_mesh&) = delete;

  Input_mesh input;
  Sphere_map sphere;
  double radius = 1.; ///< of an atlas

private:
  void take_own_sphere();
  Sphere_map add_sphere();
};

/// The map of one surface onto another one.
class Surface_match
{
public:
  /// finds the map.
  ///
  /// \param needs_overlay whether `overlay()` will be called
  Surface_match(const Options& options, Input_mesh& first, const Sphere_map& sphere1, Input_mesh& second,
                const Sphere_map& sphere2, bool needs_overlay);

  ~Surface_match();

  /// Figures of the map. Its warnings, one per line, are about files of different hemispheres, properties that are not features, an
  /// ambiguous alignment, and missed landmarks.
  Run_report::Match_figures figures;

  const Overlay& overlay() const { return *m_overlay; }

  /// returns the first surface after refinement, and the directions of its vertices on the sphere of the second one.
  Input_mesh& input() const { return m_input; }
  const Sphere_map& directions() const { return m_directions; }

  /// writes the faces of the first surface with its vertices on the second one.
  void write_positions(std::ostream& out, const std::string& format) const;

  /// returns the expected distance of the image of each vertex of the first surface from the corresponding point, relative to the square
  /// root of the area of the second one; empty if there is no estimate.
  const std::vector<double>& expected_errors() const { return m_expected_errors; }

  /// writes the expected errors: in a PLY file with the first surface, in other formats as vertex values.
  void write_expected_errors(std::ostream& out, const std::string& format) const;

  /// writes the common refinement as a PLY file: with its points on the first surface, and as properties the corresponding points on the
  /// second one and the indices of both faces.
  void write_overlay(std::ostream& out) const;

  /// writes the common refinement with vertices interpolated between the first surface (0) and the second one (1), aligned to the first
  /// one by rotation, translation and uniform scale.
  void write_morph(std::ostream& out, const std::string& format, double t) const;

private:
  void add_warnings();

  std::optional<Input_mesh> m_copy; // of the first surface, if it is refined
  Input_mesh& m_input;              // the first surface
  Mesh& m_first;
  Mesh& m_second;
  SP::IO::Surface_origin m_target_origin;
  Sphere_map m_sphere2;
  Sphere_map m_directions;
  std::unique_ptr<SP::Surface_refinement_3<Mesh>> m_refinement;
  Surface_hints m_hints;
  bool m_is_soft; // whether landmarks are soft
  std::vector<double> m_expected_errors;
  std::unique_ptr<Overlay> m_overlay;
};

} // namespace Program

#endif // PROGRAM_SURFACE_MATCH_H
