#ifndef PROGRAM_MESH_RUN_H
#define PROGRAM_MESH_RUN_H

#include "Page.h"
#include "Remesh.h"

namespace Program {

/// returns the seconds of the monotonic clock.
double seconds_now();

/// All that is done with one mesh: it is read, mapped to a sphere and measured, and what is wanted is written. What fails throws a
/// `Program_error`.
class Mesh_run
{
public:
  /// checks that all files can be written, and those beside the mesh can be opened, before any work.
  ///
  /// \param options have to live longer
  Mesh_run(const Options& options, const File_names& names);

  /// reads the mesh, or takes a component of it, and repairs it as the options say. This comes before all that follows.
  void read();
  void take(File_content part, const Run_report::Component& component);

  /// writes the mesh as it has been repaired, and where its handles were, if that is wanted, and counts what it has.
  void repair();

  /// writes a page that shows where the handles of the mesh are; returns whether it has any.
  bool show_handles();

  /// writes the page of the surface and another one with the same faces, which needs no map.
  void show_beside();

  /// maps the mesh, or takes its map from a file. This comes before all that follows.
  void map();

  /// samples the surface, if that is wanted.
  void sample();

  /// maps the surface onto another one, or a template onto it, if that is wanted.
  void match(const Mapped_mesh* model = nullptr);

  /// measures the map, and writes all files. They appear once all of them are complete.
  void write();

  /// returns what keeps the surface from being mapped, and what helps; empty if nothing does.
  std::string find_defect() const { return m_input->find_defect(m_names.handles.empty() && m_names.page.empty()); }

  const Run_report& report() const { return m_report; }

private:
  Mesh& mesh() { return m_input->mesh(); }

  void write_page_of(Page page);

  // Returns the radius of a sphere in its file, if it is not that of the map.
  std::optional<double> radius_of(const std::string& name) const;

  // Throws an error if the map is not one-to-one, so that something cannot be done.
  void check_map(const std::string& what) const;

  void take(File_content soup);
  void take_map(const std::string& file);
  void count_surface();
  void measure_balanced();
  void write_repair();
  void write_surfaces();
  void write_colors();
  void commit();

  const Options& m_options;
  File_names m_names;
  Output_files m_files;
  Run_report m_report;
  std::optional<Input_mesh> m_input;
  std::optional<Remesh> m_remesh, m_image;
  std::optional<Mapped_mesh> m_other; // the target, or the template
  std::optional<Surface_match> m_match;
  Sphere_map m_sphere;
  Distortion_map m_distortions;
};

} // namespace Program

#endif // PROGRAM_MESH_RUN_H
