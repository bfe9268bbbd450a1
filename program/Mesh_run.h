#ifndef PROGRAM_MESH_RUN_H
#define PROGRAM_MESH_RUN_H

#include "Page.h"
#include "Remesh.h"

namespace Program {

/// returns the time of the monotonic clock in seconds.
double seconds_now();

/// The run of one mesh: it is read, mapped to a sphere and measured, and the requested files are written. Functions throw a
/// `Program_error` on failure.
class Mesh_run
{
public:
  /// checks that all output files can be written, and that other input files can be opened.
  ///
  /// \param options must outlive the run
  Mesh_run(const Options& options, const File_names& names);

  /// reads the mesh, or takes a component of it, and repairs it according to the options. Must be called first.
  void read();
  void take(File_content part, const Run_report::Component& component);

  /// writes the repaired mesh, and if requested its handle cycles, and counts its elements.
  void repair();

  /// writes a page that shows the handles of the mesh; returns whether there are any.
  bool show_handles();

  /// writes the page of the surface and another one with the same faces; this needs no map.
  void show_beside();

  /// maps the mesh, or reads its map from a file. Must be called before the functions below.
  void map();

  /// samples the surface, if requested.
  void sample();

  /// maps the surface onto another one, or a template onto it, if requested.
  void match(const Mapped_mesh* model = nullptr);

  /// measures the map, and writes all files. They appear after all of them are complete.
  void write();

  /// returns the defect that prevents a map, and what helps; empty if there is none.
  std::string find_defect() const { return m_input->find_defect(m_names.handles.empty() && m_names.page.empty()); }

  const Run_report& report() const { return m_report; }

private:
  Mesh& mesh() { return m_input->mesh(); }

  void write_page_of(Page page);

  // Returns the radius of a sphere in its file, if it differs from that of the map.
  std::optional<double> radius_of(const std::string& name) const;

  // Throws an error if the map is not bijective.
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
