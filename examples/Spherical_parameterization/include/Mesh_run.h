// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_RUN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_RUN_H

#include "Colored_mesh.h"
#include "File_names.h"
#include "File_stamp.h"
#include "Input_mesh.h"
#include "Method_runner.h"
#include "Output_files.h"
#include "Program_options.h"
#include "Run_report.h"
#include "Stopwatch.h"
#include "balanced_radius.h"
#include "file_format.h"
#include "read_soup.h"
#include "write_soup.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace Program {

/// All that is done with one mesh: it is read, mapped to a sphere and measured, and what is wanted is written.
class Mesh_run
{
public:
  /// checks that all files can be written, before any work.
  ///
  /// \param options have to live longer
  ///
  /// \throws Program_error if one cannot
  Mesh_run(const Program_options& options, const File_names& names)
    : m_options(options)
    , m_names(names)
    , m_files(names, options.start_file)
    , m_report(options, names.input)
  {}

  /// removes the files that an earlier run has left under the same names.
  ///
  /// \throws Program_error if that fails
  void remove_earlier_files() { m_files.remove_earlier(); }

  /// reads the mesh and maps it.
  ///
  /// \throws Program_error if there is no map
  void map()
  {
    m_stopwatch.lap();
    m_report.input_stamp = File_stamp(m_names.input);
    if(!m_options.start_file.empty())
      m_report.start_stamp = File_stamp(m_options.start_file);
    m_input.emplace(m_names.input, read_soup(m_names.input));
    m_report.seconds_for_input = m_stopwatch.lap();

    // A vertex without a face stays at the origin.
    m_sphere = mesh().add_property_map<Vertex_index, Point_3>("v:sphere", Point_3(0, 0, 0)).first;
    m_report.result = Method_runner(*m_input, m_sphere, m_options).run();
  }

  /// measures the map, and writes all files. They appear once all of them are complete.
  ///
  /// \pre `map()` has returned
  ///
  /// \throws Program_error if a file cannot be written
  void write()
  {
    m_stopwatch.lap();
    measure();
    m_report.seconds_for_measuring = m_stopwatch.lap();
    if(m_files.sphere)
    {
      m_files.sphere->write([&](std::ostream& out) {
        write_soup(out, file_format(m_names.sphere), points_of(m_sphere), m_input->triangles());
      });
      m_report.sphere_bytes = m_files.sphere->size();
    }
    if(m_files.colored_surface)
      write_colors();
    m_report.seconds_for_output = m_stopwatch.lap();
    m_report.files = m_files.names();
    if(m_files.json)
      m_files.json->write([&](std::ostream& out) { out << m_report.json(); });
    m_files.commit();
  }

  const Run_report& report() const { return m_report; }

private:
  Mesh& mesh() { return m_input->mesh(); }

  template <class Map>
  static std::vector<Point_3> points_of(const Map& map)
  {
    return std::vector<Point_3>(map.begin(), map.end());
  }

  void measure()
  {
    m_distortions = mesh().add_property_map<Mesh::Face_index, SP::Face_distortion>("f:distortion").first;
    m_report.distortion = SP::measure_distortion(mesh(), m_sphere, m_distortions);
    if(m_options.is_unit_sphere)
      m_report.balanced = measure_balanced(m_report.distortion.radius);
  }

  // measures the map, and each face, with the radius of eq. 11; does nothing if no number holds that radius
  std::optional<SP::Distortion_summary> measure_balanced(double radius)
  {
    const double balanced = balanced_radius(mesh(), m_sphere, radius, m_distortions);
    if(balanced == 0.)
      return std::nullopt;
    const Sphere_map scaled = mesh().add_property_map<Vertex_index, Point_3>("v:balanced", Point_3(0, 0, 0)).first;
    for(const Vertex_index v : mesh().vertices())
      scaled[v] = Point_3(balanced * (m_sphere[v].x() / radius), balanced * (m_sphere[v].y() / radius),
                          balanced * (m_sphere[v].z() / radius));
    return SP::measure_distortion(mesh(), scaled, m_distortions);
  }

  void write_colors()
  {
    const bool is_conformal = m_options.is_conformal();
    std::vector<double> values;
    for(const SP::Face_distortion& distortion : m_distortions)
      values.push_back(is_conformal ? distortion.angle : distortion.isometric);
    const Colored_mesh colored(mesh().number_of_vertices(), m_input->triangles(), values, is_conformal ? 2. : 1.);
    m_report.color_range = {colored.least(), colored.largest()};
    m_files.colored_surface->write([&](std::ostream& out) { colored.write(out, points_of(mesh().points())); });
    m_files.colored_sphere->write([&](std::ostream& out) { colored.write(out, points_of(m_sphere)); });
  }

  const Program_options& m_options;
  File_names m_names;
  Output_files m_files;
  Run_report m_report;
  Stopwatch m_stopwatch;
  std::optional<Input_mesh> m_input;
  Sphere_map m_sphere;
  Distortion_map m_distortions;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_RUN_H
