#include "Mesh_run.h"

#include "Interrupt_guard.h"
#include "write_mesh.h"

#include <CGAL/Spherical_parameterization/Cortex/rotate_to_surface.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>

#include <algorithm>
#include <chrono>
#include <limits>

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

Mesh_run::Mesh_run(const Options& options, const File_names& names)
  : m_options(options)
  , m_names(names)
  , m_files(names.outputs(), inputs_of(options, names),
            options.is_batch() ? Output_policy::replace : Output_policy::follow)
  , m_report(options, names.input)
{
  if(!options.is_batch()) // in a batch, the template has been read already
    for(const std::string& name : options.other_inputs())
      check_file(name);
  if(!names.page.empty())
    check_pages();
  m_report.input_stamp = File_stamp(names.input);
  if(!options.start_or_template().empty())
    m_report.start_stamp = File_stamp(options.start_or_template());
}

void Mesh_run::read()
{
  const double start = seconds_now();
  take(read_file_content(m_names.input));
  m_report.seconds_for_input = seconds_now() - start;
}

void Mesh_run::take(File_content part, const Run_report::Component& component)
{
  const double start = seconds_now();
  m_report.component = component;
  take(std::move(part));
  m_report.seconds_for_input = seconds_now() - start;
}

void Mesh_run::take(File_content soup)
{
  m_input.emplace(m_names.input, std::move(soup), m_options.repair);
  m_report.repair = m_input->repair() ? &*m_input->repair() : nullptr;
  m_report.hemisphere = m_input->hemispheres().front().second;
  m_report.mixed_hemispheres = mixed_hemispheres(m_input->hemispheres());
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
  const bool is_its_sphere = m_options.onto.empty() || m_options.is_onto_atlas; // and not that of the target
  // The result of a registration depends on the initial pose, which therefore must not depend on the written files.
  if(m_options.is_onto_atlas || (m_options.follows_convention(m_names.sphere) && is_its_sphere))
    rotate_sphere_to_surface(*m_input, m_sphere);
  m_report.written_radius = radius_of(m_names.sphere);
}

// Takes an arbitrary map from a file instead of computing one.
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
  write_repair();
  commit();
}

// Writes the files of the repair.
void Mesh_run::write_repair()
{
  m_files.write(m_names.handles,
                [&](std::ostream& out) { m_input->write_cycles(out, m_input->repair()->report().handle_cycles); });
  m_files.write(m_names.repaired,
                [&](std::ostream& out) { m_input->write_repaired(out, m_options.format_of(m_names.repaired)); });
}

bool Mesh_run::show_handles()
{
  const std::vector<Input_mesh::Handle> handles = m_input->find_handles((std::numeric_limits<std::size_t>::max)());
  if(handles.empty())
    return false;
  count_surface();
  m_files.write(m_names.page, [&](std::ostream& out) { write_page(out, page_of_handles(*m_input, handles)); });
  commit();
  return true;
}

void Mesh_run::sample()
{
  if(!m_names.texture.empty())
    check_map("it has no texture coordinates");
  if(m_options.domain.empty() && m_options.image_size == 0)
    return;
  const double start = seconds_now();
  check_map("the surface cannot be sampled");
  if(!m_options.domain.empty())
  {
    m_remesh.emplace(*m_input, m_sphere, m_options.domain, m_options.domain_size);
    if(m_input->has_patches())
      m_remesh->mark_patches(*m_input, m_sphere);
    if(m_options.has("transfer"))
      m_remesh->transfer_values(m_options, *m_input, m_sphere);
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
  if(!m_options.is_batch()) // a batch has one for all
    guard.emplace();
  check_map("the surfaces cannot be matched");
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
  if(!m_match->figures.distortion && needs_overlay)
    throw error_in(m_names.input, std::string("--overlay, --morph and --page cannot be written. "),
                   SP::get_error_message(SP::ERROR_TOO_LARGE_OVERLAY));
  if(!m_names.expected_errors.empty() && m_match->expected_errors().empty())
    throw error_in(
        m_names.input,
        "--expected-errors cannot be written: only landmarks have aligned the surfaces, or the run was stopped.");
  m_report.match = m_match->figures;
  m_report.match->other = model != nullptr ? m_options.text("template") : m_options.onto;
  m_report.match->is_template = model != nullptr;
  m_report.match->number_of_vertices = m_other->input.mesh().number_of_vertices();
  m_report.seconds_for_matching = seconds_now() - start;
}

void Mesh_run::check_map(const std::string& what) const
{
  if(!m_report.result.is_one_to_one)
    throw error_in(m_names.input, "the map is not bijective: ", what, ".\n--method bld guarantees bijectivity.");
}

void Mesh_run::commit()
{
  m_report.files = m_files.names();
  m_files.write(m_names.json, [&](std::ostream& out) { out << m_report.json(); });
  m_files.commit();
}

void Mesh_run::write()
{
  const double start = seconds_now();
  m_distortions = mesh().add_property_map<Mesh::Face_index, SP::Face_distortion>("f:distortion").first;
  m_report.distortion = m_input->measured(m_sphere, m_distortions);
  if(!m_options.sphere_file.empty())
    m_report.result.report.radius = m_report.distortion.radius;
  if(m_options.is_unit_sphere)
    measure_balanced();
  m_report.seconds_for_measuring = seconds_now() - start;
  write_repair();
  write_surfaces();
  if(!m_names.colored.empty())
    write_colors();
  if(!m_names.page.empty())
    write_page_of(m_match ? page_of_match(*m_match, m_report)
                          : page_of_sphere(*m_input, m_sphere, m_distortions, m_report));
  m_report.seconds_for_output = seconds_now() - start - m_report.seconds_for_measuring;
  commit();
}

void Mesh_run::write_surfaces()
{
  using Out = std::ostream&;
  const auto write = [&](const std::string& name, const auto& write_to) {
    m_files.write(name, [&](Out out) { write_to(out, m_options.format_of(name)); });
  };
  const auto write_map = [&](const std::string& name, Input_mesh& input, const Sphere_map& map,
                             const std::optional<double>& radius) {
    write(name, [&](Out out, const std::string& format) { write_sphere(out, name, format, input, map, radius); });
  };
  const bool has_template = m_match && m_options.onto.empty();
  if(m_match)
    write(has_template              ? m_names.sphere
          : m_options.is_onto_atlas ? ""
                                    : m_names.onto,
          [&](Out out, const std::string& format) { m_match->write_positions(out, format); });
  if(m_match && !has_template)
    write_map(m_options.is_onto_atlas ? m_names.onto : m_names.sphere, m_match->input(), m_match->directions(),
              m_options.is_onto_atlas ? m_report.written_radius : radius_of(m_names.sphere));
  if(!m_match || m_options.is_onto_atlas)
    write_map(m_names.sphere, *m_input, m_sphere, radius_of(m_names.sphere));
  if(m_other)
    write_map(m_names.target_sphere, m_other->input, m_other->sphere, radius_of(m_names.target_sphere));
  if(!m_names.sphere.empty())
    m_report.sphere_checksum = m_files.checksum(m_names.sphere);
  write(m_names.remesh, [&](Out out, const std::string& format) { m_remesh->write(out, format); });
  write(m_names.morph, [&](Out out, const std::string& f) { m_match->write_morph(out, f, m_options.morph_time); });
  const std::string& values = m_names.values;
  m_files.write(values,
                [&](Out out) { read_named(values, [&] { m_remesh->write_values(out, file_format(values)); }); });
  const std::string& errors = m_names.expected_errors;
  m_files.write(errors, [&](Out out) {
    read_named(errors, [&] {
      m_match->write_expected_errors(out, file_format(errors) == ".ply" ? ".ply" : format_of_values(errors));
    });
  });
  m_files.write(m_names.overlay, [&](Out out) { m_match->write_overlay(out); });
  m_files.write(m_names.image, [&](Out out) { m_image->write_image(out, m_names.image, false); });
  m_files.write(m_names.image_of_normals(), [&](Out out) { m_image->write_image(out, m_names.image, true); });
  m_files.write(m_names.texture, [&](Out out) { m_report.texture_warning = write_texture(out, *m_input, m_sphere); });
}

void Mesh_run::write_page_of(Page page)
{
  add_repair(page, *m_input);
  if(m_input->is_of_cortical_format() || m_options.text("convention") == "cortex" || m_options.has("labels"))
    add_anatomy(page, *m_input, m_options.text("labels"));
  m_files.write(m_names.page, [&](std::ostream& out) { write_page(out, page); });
}

void Mesh_run::show_beside()
{
  m_input->check();
  Input_mesh other(m_options.text("beside"), read_file_content(m_options.text("beside")), m_options.repair);
  write_page_of(page_of_same_faces(*m_input, other));
  count_surface();
  commit();
}

std::optional<double> Mesh_run::radius_of(const std::string& name) const
{
  return !name.empty() && m_options.follows_convention(name) && !m_options.has("radius")
             ? std::optional<double>(SP::cortical_sphere_radius)
             : std::nullopt;
}

// Measures the map and each face with the radius that balances the areas, at which maps are usually compared; does nothing if this
// radius is out of the range of double.
void Mesh_run::measure_balanced()
{
  const double radius = m_report.distortion.radius, balanced = m_report.distortion.balanced_radius;
  if(!(balanced > 0. && std::isfinite(balanced)))
    return;
  const Sphere_map scaled = mesh().add_property_map<Vertex_index, Point_3>("v:balanced", Point_3(0, 0, 0)).first;
  for(const Vertex_index v : mesh().vertices())
    scaled[v] = Point_3(balanced * (m_sphere[v].x() / radius), balanced * (m_sphere[v].y() / radius),
                        balanced * (m_sphere[v].z() / radius));
  m_report.balanced = m_input->measured(scaled, m_distortions);
}

void Mesh_run::write_colors()
{
  const bool is_conformal = m_options.is_conformal();
  std::vector<double> values;
  for(const SP::Face_distortion& distortion : m_distortions)
    values.push_back(is_conformal ? distortion.angle : distortion.isometric);
  const std::vector<Polygon>& faces = m_input->triangles();
  const Colored_distortion colored(mesh().number_of_vertices(), faces, values, is_conformal ? 2. : 1.);
  m_report.color_range = colored.range;
  for(const auto& [name, points] :
      {std::pair(m_names.colored_surface(), mesh().points()), std::pair(m_names.colored_sphere(), m_sphere)})
    m_files.write(name, [&, points = points](std::ostream& out) {
      write_colored_mesh(out, {points.begin(), points.end()}, faces, colored);
    });
}

} // namespace Program
