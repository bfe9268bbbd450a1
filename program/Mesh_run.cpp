#include "Mesh_run.h"

#include "Colored_mesh.h"
#include "Components.h"
#include "Interrupt_guard.h"
#include "read_file.h"
#include "write_sphere.h"

#include <CGAL/Spherical_parameterization/Cortex/rotate_to_surface.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <ostream>

namespace Program {

namespace {

Words inputs_of(const Options& options, const File_names& names)
{
  Words inputs = options.other_inputs();
  inputs.push_back(names.input);
  return inputs;
}

} // namespace

double seconds_now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Mesh_run::Mesh_run(const Options& options, const File_names& names, std::size_t component)
  : m_options(options)
  , m_names(names)
  , m_component(component)
  , m_files(names.outputs(), inputs_of(options, names),
            options.is_batch() ? Output_policy::replace : Output_policy::follow)
  , m_report(options, names.input)
{
  if(!options.is_batch()) // there, a template has been read already
    for(const std::string& name : options.other_inputs())
      check_file(name);
  if(!names.page.empty())
    check_pages();
}

void Mesh_run::read()
{
  const double start = seconds_now();
  m_report.input_stamp = File_stamp(m_names.input);
  if(!m_options.start_or_template().empty())
    m_report.start_stamp = File_stamp(m_options.start_or_template());
  File_content soup = read_file_content(m_names.input);
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
  if(!m_names.handles.empty() || !m_names.page.empty())
    show_handles();
  m_report.subject = m_names.subject;
  m_report.hemisphere = m_input->hemispheres().front().second;
  m_report.mixed_hemispheres = mixed_hemispheres(m_input->hemispheres());
  m_report.seconds_for_input = seconds_now() - start;
}

void Mesh_run::map()
{
  // A vertex without a face stays at the origin.
  m_sphere = mesh().add_property_map<Vertex_index, Point_3>("v:sphere", Point_3(0, 0, 0)).first;
  if(!m_options.sphere_file.empty())
  {
    take_map(m_options.sphere_file);
    return;
  }
  m_report.result = run_method(m_options, *m_input, m_sphere);
  const bool is_its_sphere = m_options.onto.empty() || m_options.is_onto_atlas; // and not that of a target
  // What a registration finds depends on the start, so that has to be the same whatever is written.
  if(m_options.is_onto_atlas || (m_options.follows_convention(m_names.sphere) && is_its_sphere))
    turn_to_surface(*m_input, m_sphere);
  m_report.written_radius = radius_of(m_names.sphere);
}

// Takes the map of a file in place of one of a method, whatever it is.
void Mesh_run::take_map(const std::string& file)
{
  const Sphere_map images = m_input->read_images(file);
  for(const Vertex_index v : mesh().vertices())
    if(!mesh().is_isolated(v))
      m_sphere[v] = images[v];
  m_report.result.is_one_to_one = SP::is_bijective(mesh(), m_sphere);
  count_surface();
}

void Mesh_run::count_surface()
{
  SP::Parameterization_report& report = m_report.result.report;
  for(const Vertex_index v : mesh().vertices())
    ++(mesh().is_isolated(v) ? report.number_of_isolated_vertices : report.number_of_vertices);
  report.number_of_faces = mesh().number_of_faces();
}

void Mesh_run::repair()
{
  count_surface();
  m_files.write(m_names.filled,
                [&](std::ostream& out) { m_input->write_filled(out, m_options.format_of(m_names.filled)); });
  m_report.files = m_files.names();
  m_files.commit();
}

std::string Mesh_run::find_defect() const
{
  return m_input->find_defect();
}

void Mesh_run::sample()
{
  if(m_options.domain.empty() && m_options.image_size == 0)
    return;
  const double start = seconds_now();
  if(!m_report.result.is_one_to_one)
    throw error_in(m_names.input,
                   "the map is not one-to-one: the surface cannot be sampled by it.\n--method bld excludes that.");
  if(!m_options.domain.empty())
  {
    m_remesh.emplace(*m_input, m_sphere, m_options.domain, m_options.domain_size);
    if(m_options.max_hole_edges > 0)
      m_remesh->mark_filler(*m_input, m_sphere);
    if(!m_options.values_file.empty())
      m_remesh->carry_values(m_options, *m_input, m_sphere);
    m_report.remesh = m_remesh->figures(*m_input);
  }
  if(m_options.image_size > 0)
    m_image.emplace(*m_input, m_sphere, "octahedron", (m_options.image_size - 1) / 2);
  m_report.seconds_for_sampling = seconds_now() - start;
}

void Mesh_run::match(const Mapped_mesh* model)
{
  if(m_options.onto.empty() && model == nullptr)
    return;
  const double start = seconds_now();
  std::optional<Interrupt_guard> guard;
  if(!m_options.is_batch()) // which has one for all
    guard.emplace();
  if(!m_report.result.is_one_to_one)
    throw error_in(m_names.input,
                   "the map is not one-to-one: no surface can be mapped by it.\n--method bld excludes that.");
  const bool needs_overlay = !m_names.overlay.empty() || !m_names.morph.empty() || !m_names.page.empty();
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
      m_report.written_radius =
          m_options.follows_convention(m_names.onto) ? SP::cortical_sphere_radius : m_other->radius;
  }
  if(!m_match->distortion && needs_overlay)
    throw error_in(m_names.input, std::string("no --overlay, --morph or --page can be made. ") +
                                      SP::get_error_message(SP::ERROR_TOO_LARGE_OVERLAY));
  m_report.match = Run_report::Match_figures{model != nullptr ? m_options.template_file : m_options.onto,
                                             model != nullptr,
                                             m_other->input.mesh().number_of_vertices(),
                                             m_match->report,
                                             m_match->distortion,
                                             m_match->warnings(),
                                             m_match->energy_before,
                                             m_match->number_of_new_vertices,
                                             m_match->parents};
  m_report.seconds_for_matching = seconds_now() - start;
}

void Mesh_run::write()
{
  const double start = seconds_now();
  m_distortions = mesh_of_file().add_property_map<Mesh::Face_index, SP::Face_distortion>("f:distortion").first;
  m_report.distortion = measured_distortion(mesh_of_file(), m_sphere, m_distortions);
  if(!m_options.sphere_file.empty())
    m_report.result.report.radius = m_report.distortion.radius;
  if(m_options.is_unit_sphere)
    m_report.balanced = measure_balanced(m_report.distortion.radius);
  m_report.seconds_for_measuring = seconds_now() - start;
  write_surfaces();
  m_files.write(m_names.image, [&](std::ostream& out) { m_image->write_image(out, m_names.image, false); });
  m_files.write(m_names.image_of_normals(), [&](std::ostream& out) { m_image->write_image(out, m_names.image, true); });
  if(!m_names.colored.empty())
    write_colors();
  if(!m_names.page.empty())
    write_page_of(page_of_maps());
  m_report.seconds_for_output = seconds_now() - start - m_report.seconds_for_measuring;
  m_report.files = m_files.names();
  m_files.write(m_names.json, [&](std::ostream& out) { out << m_report.json(); });
  m_files.commit();
}

void Mesh_run::write_surfaces()
{
  const auto format_of = [&](const std::string& name) { return m_options.format_of(name); };
  m_files.write(m_names.sphere, [&](std::ostream& out) {
    const std::string format = format_of(m_names.sphere);
    if(m_match && m_options.onto.empty())
      m_match->write_positions(out, format);
    else if(m_match && !m_options.is_onto_atlas)
      m_match->write_directions(out, m_names.sphere, format, radius_of(m_names.sphere));
    else
      write_sphere(out, m_names.sphere, format, *m_input, m_sphere, radius_of(m_names.sphere));
  });
  if(!m_names.sphere.empty())
    m_report.sphere_checksum = m_files.checksum(m_names.sphere);
  m_files.write(m_names.remesh, [&](std::ostream& out) { m_remesh->write(out, format_of(m_names.remesh)); });
  m_files.write(m_names.values, [&](std::ostream& out) { m_remesh->write_values(out, file_format(m_names.values)); });
  m_files.write(m_names.onto, [&](std::ostream& out) {
    if(m_options.is_onto_atlas)
      m_match->write_directions(out, m_names.onto, format_of(m_names.onto), m_report.written_radius);
    else
      m_match->write_positions(out, format_of(m_names.onto));
  });
  m_files.write(m_names.target_sphere, [&](std::ostream& out) {
    write_sphere(out, m_names.target_sphere, format_of(m_names.target_sphere), m_other->input, m_other->sphere,
                 radius_of(m_names.target_sphere));
  });
  m_files.write(m_names.overlay, [&](std::ostream& out) { m_match->write_overlay(out); });
  m_files.write(m_names.morph,
                [&](std::ostream& out) { m_match->write_morph(out, format_of(m_names.morph), m_options.morph_time); });
}

Page Mesh_run::page_of_maps()
{
  return m_match ? page_of_match(m_match->overlay(), m_report)
                 : page_of_sphere(*m_input, m_sphere, m_distortions, m_report);
}

void Mesh_run::write_page_of(Page page)
{
  if(m_input->is_of_cortical_format() || m_options.convention == "cortex" || !m_options.labels_file.empty())
    add_anatomy(page, *m_input, m_options.labels_file);
  m_files.write(m_names.page, [&](std::ostream& out) { write_page(out, page); });
}

void Mesh_run::show_beside()
{
  if(const std::string defect = find_defect(); !defect.empty())
    throw Program_error(defect);
  Input_mesh other(m_options.beside, read_file_content(m_options.beside));
  write_page_of(page_of_same_faces(*m_input, other));
  count_surface();
  m_report.files = m_files.names();
  m_files.commit();
}

std::optional<double> Mesh_run::radius_of(const std::string& name) const
{
  return !name.empty() && m_options.follows_convention(name) && !m_options.keeps_radius
             ? std::optional<double>(SP::cortical_sphere_radius)
             : std::nullopt;
}

// Writes where the handles are. Their files appear at once if there are any, as there is nothing else to wait for.
void Mesh_run::show_handles()
{
  const std::vector<Input_mesh::Handle> handles = m_input->find_handles((std::numeric_limits<std::size_t>::max)());
  m_files.write(m_names.handles, [&](std::ostream& out) { m_input->write_handles(out, handles); });
  if(handles.empty())
    return;
  if(!m_names.handles.empty())
    m_files.commit(m_names.handles);
  m_files.write(m_names.page, [&](std::ostream& out) { write_page(out, page_of_handles(*m_input, handles)); });
  if(!m_names.page.empty())
    m_files.commit(m_names.page);
}

// Measures the map, and each face, with the radius that balances the areas (eq. 11), at which maps are usually compared;
// does nothing if no number holds that radius. Faces where distortions are infinite are left out.
std::optional<SP::Distortion_summary> Mesh_run::measure_balanced(double radius)
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

void Mesh_run::write_colors()
{
  const bool is_conformal = m_options.is_conformal();
  std::vector<double> values;
  for(const SP::Face_distortion& distortion : m_distortions)
    values.push_back(is_conformal ? distortion.angle : distortion.isometric);
  const Colored_mesh colored(mesh_of_file().number_of_vertices(), m_input->triangles(), values, is_conformal ? 2. : 1.);
  m_report.color_range = colored.range();
  m_files.write(m_names.colored_surface(),
                [&](std::ostream& out) { colored.write(out, m_input->points_of(mesh_of_file().points())); });
  m_files.write(m_names.colored_sphere(), [&](std::ostream& out) { colored.write(out, m_input->points_of(m_sphere)); });
}

} // namespace Program
