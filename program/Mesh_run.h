#ifndef PROGRAM_MESH_RUN_H
#define PROGRAM_MESH_RUN_H

#include "Input_mesh.h"
#include "Options.h"
#include "Page.h"
#include "Remesh.h"
#include "Run_report.h"
#include "Surface_match.h"
#include "output_files.h"

#include <cstddef>
#include <optional>
#include <string>

namespace Program {

/// returns the seconds of the monotonic clock.
double seconds_now();

/// All that is done with one mesh: it is read, mapped to a sphere and measured, and what is wanted is written.
class Mesh_run
{
public:
  /// checks that all files can be written, and those beside the mesh can be opened, before any work.
  ///
  /// \param options have to live longer
  ///
  /// \throws Program_error if one cannot, or the program was built without what it takes
  ///
  /// \param component the part of the surface that is mapped, if the options ask for one: 0 is the largest
  Mesh_run(const Options& options, const File_names& names, std::size_t component = 0);

  /// removes the files that an earlier run has left under the same names.
  ///
  /// \throws Program_error if that fails
  void remove_earlier_files() { m_files.remove_earlier(); }

  /// reads the mesh, and repairs it as the options say.
  ///
  /// \throws Program_error if a file is not in order
  void read();

  /// maps the mesh, or takes its map from a file.
  ///
  /// \pre `read()` has returned
  ///
  /// \throws Program_error if there is no map
  void map();

  /// samples the surface, if that is wanted.
  ///
  /// \pre `map()` has returned
  ///
  /// \throws Program_error if the map is not one-to-one, or what the options name is not in order
  void sample();

  /// maps the surface onto that of --onto, or a template onto it, if that is wanted.
  ///
  /// \pre `map()` has returned
  ///
  /// \throws Program_error if there is no such map
  void match(const Mapped_mesh* model = nullptr);

  /// measures the map, and writes all files. They appear once all of them are complete.
  ///
  /// \pre `map()` has returned
  ///
  /// \throws Program_error if a file cannot be written
  void write();

  /// writes the mesh as it has been repaired, if that is wanted, and counts what it has.
  ///
  /// \pre `read()` has returned
  ///
  /// \throws Program_error if a file cannot be written
  void repair();

  /// writes the page of the surface and another one with the same faces, which needs no map.
  void show_beside();

  /// returns what keeps the surface from being mapped, and what helps; empty if nothing does.
  std::string find_defect() const;

  const Run_report& report() const { return m_report; }

private:
  Mesh& mesh() { return m_input->mesh(); }
  Mesh& mesh_of_file() { return m_input->mesh_of_file(); }

  Page page_of_maps();
  void write_page_of(Page page);

  // Returns the radius of a sphere in its file, if it is not that of the map.
  std::optional<double> radius_of(const std::string& name) const;

  void take_map(const std::string& file);
  void count_surface();
  void show_handles();
  std::optional<SP::Distortion_summary> measure_balanced(double radius);
  void write_surfaces();
  void write_colors();

  const Options& m_options;
  File_names m_names;
  std::size_t m_component;
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
