#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_RUN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_RUN_H

#include "Colored_mesh.h"
#include "Components.h"
#include "Input_mesh.h"
#include "Interrupt_guard.h"
#include "Output_file.h"
#include "Output_files.h"
#include "Page.h"
#include "Program_options.h"
#include "Remesh.h"
#include "Run_report.h"
#include "Surface_match.h"
#include "mesh_files.h"
#include "read_soup.h"
#include "run_method.h"
#include "write_sphere.h"

#include <CGAL/Spherical_parameterization/Sampling/measure_distance.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace Program {

/// returns the seconds of the monotonic clock.
inline double seconds_now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

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
  Mesh_run(const Program_options& options, const File_names& names, std::size_t component = 0)
    : m_options(options)
    , m_names(names)
    , m_component(component)
    , m_files(names, options.other_inputs(),
              options.is_batch() ? Output_file::Policy::replace : Output_file::Policy::follow)
    , m_report(options, names.input)
  {
    if(!options.is_batch()) // there, a template has been read already
      for(const std::string& name : options.other_inputs())
        read_named(name, [&] { open_file(name); });
    if(m_files.page)
      Page::check();
  }

  /// removes the files that an earlier run has left under the same names.
  ///
  /// \throws Program_error if that fails
  void remove_earlier_files() { m_files.remove_earlier(); }

  /// reads the mesh and maps it.
  ///
  /// \throws Program_error if there is no map
  void map()
  {
    const double start = seconds_now();
    m_report.input_stamp = File_stamp(m_names.input);
    if(!m_options.start_or_template().empty())
      m_report.start_stamp = File_stamp(m_options.start_or_template());
    Polygon_soup soup = read_soup(m_names.input);
    if(m_options.picks_component)
    {
      const Components components(soup.polygons);
      m_report.components = components.sizes();
      if(m_component < components.sizes().size())
        components.keep(m_component, soup.polygons);
      m_report.component = m_component;
    }
    m_input.emplace(m_names.input, std::move(soup));
    if(m_options.max_hole_edges > 0)
      m_report.holes = m_input->fill_holes(m_options.max_hole_edges);
    if(m_files.handles || m_files.page)
      show_handles();
    m_report.subject = m_names.subject;
    m_report.hemisphere = m_input->hemispheres().front().second;
    m_report.mixed_hemispheres = mixed_hemispheres(m_input->hemispheres());
    m_report.seconds_for_input = seconds_now() - start;

    // A vertex without a face stays at the origin.
    m_sphere = mesh().add_property_map<Vertex_index, Point_3>("v:sphere", Point_3(0, 0, 0)).first;
    m_report.result = run_method(m_options, *m_input, m_sphere);
    const bool is_its_sphere = m_options.onto.empty() || m_options.is_onto_atlas; // and not that of a target
    // What a registration finds depends on the start, so that has to be the same whatever is written.
    if(m_options.is_onto_atlas || (m_options.follows_convention(m_names.sphere) && is_its_sphere))
      turn_to_surface(*m_input, m_sphere, m_report.result.is_one_to_one);
    m_report.written_radius = radius_of(m_names.sphere);
  }

  /// samples the surface, if that is wanted.
  ///
  /// \pre `map()` has returned
  ///
  /// \throws Program_error if the map is not one-to-one, or what the options name is not in order
  void sample()
  {
    if(m_options.domain.empty() && m_options.image_size == 0)
      return;
    const double start = seconds_now();
    if(!m_report.result.is_one_to_one)
      throw Program_error(
          m_names.input,
          "the map is not one-to-one: the surface cannot be sampled by it.\n--method bld excludes that.");
    if(!m_options.domain.empty())
    {
      m_remesh.emplace(*m_input, m_sphere, Remesh::find_domain(m_options));
      if(m_options.max_hole_edges > 0)
        m_remesh->mark_filler(*m_input, m_sphere);
      if(!m_options.values_file.empty())
        m_remesh->carry_values(m_options, *m_input, m_sphere);
      SP::Surface_distance distance;
      const SP::Error_code error = SP::measure_distance(mesh(), m_remesh->mesh(), distance);
      if(error != SP::OK)
        throw Program_error(m_names.input, SP::get_error_message(error));
      m_report.remesh = Run_report::Remesh_figures{m_remesh->mesh().number_of_vertices(),
                                                   m_remesh->mesh().number_of_faces(), distance, m_remesh->warnings()};
    }
    if(m_options.image_size > 0)
      m_image.emplace(*m_input, m_sphere, SP::Sphere_domain_3::octahedron((m_options.image_size - 1) / 2));
    m_report.seconds_for_sampling = seconds_now() - start;
  }

  /// maps the surface onto that of --onto, or a template onto it, if that is wanted.
  ///
  /// \pre `map()` has returned
  ///
  /// \throws Program_error if there is no such map
  void match(const Mapped_mesh* model = nullptr)
  {
    if(m_options.onto.empty() && model == nullptr)
      return;
    const double start = seconds_now();
    std::optional<Interrupt_guard> guard;
    if(!m_options.is_batch()) // which has one for all
      guard.emplace();
    if(!m_report.result.is_one_to_one)
      throw Program_error(m_names.input,
                          "the map is not one-to-one: no surface can be mapped by it.\n--method bld excludes that.");
    const bool needs_overlay = m_files.overlay || m_files.morph || m_files.page;
    if(model != nullptr)
    {
      m_other.emplace(*model);
      m_match.emplace(m_options, m_other->input, m_other->sphere, *m_input, m_sphere, needs_overlay);
    }
    else
    {
      m_other.emplace(m_options, m_options.onto);
      m_match.emplace(m_options, *m_input, m_sphere, m_other->input, m_other->sphere, needs_overlay);
      if(m_options.is_onto_atlas)
        m_report.written_radius = m_options.follows_convention(m_names.onto) ? radius_of_convention : m_other->radius;
    }
    if(!m_match->distortion && needs_overlay)
      throw Program_error(m_names.input, std::string("no --overlay, --morph or --page can be made. ") +
                                             SP::get_error_message(SP::ERROR_TOO_LARGE_OVERLAY));
    m_report.match = Run_report::Match_figures{model != nullptr ? m_options.template_file : m_options.onto,
                                               model != nullptr,
                                               m_other->input.mesh().number_of_vertices(),
                                               m_match->report,
                                               m_match->distortion,
                                               m_match->warnings(),
                                               std::nullopt,
                                               0,
                                               {}};
    if(m_options.splits)
    {
      const Match_refinement& refinement = m_match->refinement();
      m_report.match->energy_before = refinement.energy_before();
      m_report.match->number_of_new_vertices = refinement.number_of_new_vertices();
      m_report.match->parents.assign(refinement.parents().begin(), refinement.parents().end());
    }
    m_report.seconds_for_matching = seconds_now() - start;
  }

  /// measures the map, and writes all files. They appear once all of them are complete.
  ///
  /// \pre `map()` has returned
  ///
  /// \throws Program_error if a file cannot be written
  void write()
  {
    const double start = seconds_now();
    m_distortions = mesh_of_file().add_property_map<Mesh::Face_index, SP::Face_distortion>("f:distortion").first;
    m_report.distortion = measured_distortion(mesh_of_file(), m_sphere, m_distortions);
    if(m_options.is_unit_sphere)
      m_report.balanced = measure_balanced(m_report.distortion.radius);
    m_report.seconds_for_measuring = seconds_now() - start;
    if(m_files.sphere)
    {
      m_files.sphere->write([&](std::ostream& out) {
        const std::string format = m_options.format_of(m_names.sphere);
        if(m_match && m_options.onto.empty())
          m_match->write_positions(out, format);
        else if(m_match && !m_options.is_onto_atlas)
          m_match->write_directions(out, m_names.sphere, format, radius_of(m_names.sphere));
        else
          write_sphere(out, m_names.sphere, format, *m_input, m_sphere, radius_of(m_names.sphere));
      });
      m_report.sphere_checksum = m_files.sphere->checksum();
    }
    if(m_files.filled)
      m_files.filled->write([&](std::ostream& out) { m_input->write_filled(out); });
    if(m_files.remesh)
      m_files.remesh->write([&](std::ostream& out) { m_remesh->write(out, m_options.format_of(m_names.remesh)); });
    if(m_files.values)
      m_files.values->write([&](std::ostream& out) { m_remesh->write_values(out, file_format(m_names.values)); });
    if(m_files.onto)
      m_files.onto->write([&](std::ostream& out) {
        const std::string format = m_options.format_of(m_names.onto);
        if(m_options.is_onto_atlas)
          m_match->write_directions(out, m_names.onto, format, m_report.written_radius);
        else
          m_match->write_positions(out, format);
      });
    if(m_files.target_sphere)
      m_files.target_sphere->write([&](std::ostream& out) {
        write_sphere(out, m_names.target_sphere, m_options.format_of(m_names.target_sphere), m_other->input,
                     m_other->sphere, radius_of(m_names.target_sphere));
      });
    if(m_files.overlay)
      m_files.overlay->write([&](std::ostream& out) { m_match->write_overlay(out); });
    if(m_files.morph)
      m_files.morph->write([&](std::ostream& out) {
        m_match->write_morph(out, m_options.format_of(m_names.morph), m_options.morph_time);
      });
    if(m_files.image)
    {
      m_files.image->write([&](std::ostream& out) { m_image->write_image(out, m_names.image, false); });
      m_files.image_of_normals->write([&](std::ostream& out) { m_image->write_image(out, m_names.image, true); });
    }
    if(m_files.colored_surface)
      write_colors();
    if(m_files.page)
    {
      Page page = page_of_maps();
      if(m_input->is_of_cortical_format() || m_options.convention == "cortex" || !m_options.labels_file.empty())
        page.add_anatomy(*m_input, m_options.labels_file);
      m_files.page->write([&](std::ostream& out) { page.write(out); });
    }
    m_report.seconds_for_output = seconds_now() - start - m_report.seconds_for_measuring;
    m_report.files = m_files.names();
    if(m_files.json)
      m_files.json->write([&](std::ostream& out) { out << m_report.json(); });
    m_files.commit();
  }

  const Run_report& report() const { return m_report; }

private:
  Mesh& mesh() { return m_input->mesh(); }
  Mesh& mesh_of_file() { return m_input->mesh_of_file(); }

  Page page_of_maps()
  {
    if(m_match)
      return Page(m_match->overlay(), m_report);
    if(m_options.beside.empty())
      return Page(*m_input, m_sphere, m_distortions, m_report);
    Input_mesh other(m_options.beside, read_soup(m_options.beside));
    return Page(*m_input, other);
  }

  // returns the radius of a sphere in its file, if it is not that of the map
  std::optional<double> radius_of(const std::string& name) const
  {
    return !name.empty() && m_options.follows_convention(name) && !m_options.keeps_radius
               ? std::optional<double>(radius_of_convention)
               : std::nullopt;
  }

  // Writes where the handles are. Their files appear at once if there are any, as there is nothing else to wait for.
  void show_handles()
  {
    const std::vector<SP::Handle<Mesh>> handles = m_input->find_handles((std::numeric_limits<std::size_t>::max)());
    if(m_files.handles)
    {
      m_files.handles->write([&](std::ostream& out) { m_input->write_handles(out, handles); });
      if(!handles.empty())
        m_files.handles->commit();
    }
    if(m_files.page && !handles.empty())
    {
      m_files.page->write([&](std::ostream& out) { Page(*m_input, handles).write(out); });
      m_files.page->commit();
    }
  }

  // Measures the map, and each face, with the radius that balances the areas (eq. 11), at which maps are usually compared;
  // does nothing if no number holds that radius. Faces where distortions are infinite are left out.
  std::optional<SP::Distortion_summary> measure_balanced(double radius)
  {
    // Scaling by a power of two is exact, and keeps all products away from infinity and 0.
    const auto exponent_of = [&](const auto& points) {
      double max = 0.;
      for(const Vertex_index v : mesh_of_file().vertices())
        if(!mesh_of_file().is_isolated(v))
          for(int k = 0; k < 3; ++k)
            max = (std::max)(max, std::abs(points[v][k]));
      return max > 0. ? std::ilogb(max) : 0;
    };
    const auto area = [&](const auto& points, Mesh::Face_index f, int exponent) {
      const auto point = [&](Mesh::Halfedge_index h) {
        const Point_3& p = points[mesh_of_file().target(h)];
        return Point_3(std::scalbn(p.x(), -exponent), std::scalbn(p.y(), -exponent), std::scalbn(p.z(), -exponent));
      };
      const Mesh::Halfedge_index h = mesh_of_file().halfedge(f);
      return std::sqrt(CGAL::squared_area(point(h), point(mesh_of_file().next(h)), point(mesh_of_file().prev(h))));
    };
    const int exponent = exponent_of(mesh_of_file().points()), exponent_of_sphere = exponent_of(m_sphere);
    double sum = 0., sum_of_inverses = 0.;
    for(const Mesh::Face_index f : mesh_of_file().faces())
      if(std::isfinite(m_distortions[f].isometric))
      {
        const double d = area(m_sphere, f, exponent_of_sphere) / area(mesh_of_file().points(), f, exponent);
        sum += d;
        sum_of_inverses += 1. / d;
      }
    const double balanced =
        std::scalbn(std::scalbn(radius, -exponent_of_sphere) * std::pow(sum_of_inverses / sum, 0.25), exponent);
    if(!(balanced > 0. && std::isfinite(balanced)))
      return std::nullopt;

    const Sphere_map scaled =
        mesh_of_file().add_property_map<Vertex_index, Point_3>("v:balanced", Point_3(0, 0, 0)).first;
    for(const Vertex_index v : mesh_of_file().vertices())
      scaled[v] = Point_3(balanced * (m_sphere[v].x() / radius), balanced * (m_sphere[v].y() / radius),
                          balanced * (m_sphere[v].z() / radius));
    return measured_distortion(mesh_of_file(), scaled, m_distortions);
  }

  void write_colors()
  {
    const bool is_conformal = m_options.is_conformal();
    std::vector<double> values;
    for(const SP::Face_distortion& distortion : m_distortions)
      values.push_back(is_conformal ? distortion.angle : distortion.isometric);
    const Colored_mesh colored(mesh_of_file().number_of_vertices(), m_input->triangles(), values,
                               is_conformal ? 2. : 1.);
    m_report.color_range = colored.range();
    m_files.colored_surface->write(
        [&](std::ostream& out) { colored.write(out, m_input->points_of(mesh_of_file().points())); });
    m_files.colored_sphere->write([&](std::ostream& out) { colored.write(out, m_input->points_of(m_sphere)); });
  }

  const Program_options& m_options;
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_MESH_RUN_H
