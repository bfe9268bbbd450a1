#include "Run_report.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Program {

namespace {

constexpr std::size_t max_listed = 5; // of components

void print_line(std::ostream& out, const std::string& name, const SP::Distortion_statistics& statistics)
{
  constexpr double too_long = 1e6;
  out << name;
  for(const double x : {statistics.maximum, statistics.average, statistics.deviation})
    out << std::setw(12) << fixed_text(x, 4, x < too_long);
  out << '\n';
}

std::string sizes_of_others(const Run_report::Component& component)
{
  const std::vector<std::size_t>& all = *component.sizes;
  Words sizes;
  for(std::size_t k = 0; k < all.size() && sizes.size() < max_listed; ++k)
    if(k != component.index)
      sizes.push_back(std::to_string(all[k]));
  const std::size_t n_rest = all.size() - 1 - sizes.size();
  return sizes.empty() ? ""
                       : joined("; the others have ", list_of(sizes, " and "),
                                n_rest > 0 ? joined(", and ", n_rest, " more have fewer") : "");
}

void print_remesh(std::ostream& out, const Run_report::Remesh_figures& remesh)
{
  const auto larger = [&](const std::array<double, 2>& distances) {
    return fixed_text((std::max)(distances[0], distances[1]) / remesh.diagonal, 2, false);
  };
  out << "Remesh:    " << sizes_of(remesh.number_of_vertices, remesh.number_of_faces)
      << "; distance from the surface, relative to its diagonal: root mean square " << larger(remesh.root_mean_square)
      << " (" << fixed_text(remesh.psnr, 2) << " dB), maximum " << larger(remesh.maximum) << '\n';
}

} // namespace

Run_report::Component::Component(const std::vector<std::vector<std::size_t>>& all)
{
  std::vector<std::size_t> sizes_of_all;
  for(const std::vector<std::size_t>& faces : all)
    sizes_of_all.push_back(faces.size());
  sizes = std::make_shared<const std::vector<std::size_t>>(std::move(sizes_of_all));
}

std::vector<std::pair<std::string, double>> Run_report::phases() const
{
  const SP::Parameterization_report& run = result.report;
  return {{"input", seconds_for_input},
          {"copy", run.seconds_for_reading},
          {"hierarchy", run.seconds_for_hierarchy},
          {"initial_map", run.seconds_for_embedding},
          {"sweeps", run.seconds_for_optimization},
          {"certificate", run.seconds_for_certificate},
          {"measuring", seconds_for_measuring},
          {"sampling", seconds_for_sampling},
          {"matching", seconds_for_matching},
          {"output", seconds_for_output}};
}

double Run_report::seconds() const
{
  return seconds_for_input + result.report.seconds() + seconds_for_measuring + seconds_for_sampling +
         seconds_for_matching + seconds_for_output;
}

bool Run_report::is_interrupted() const
{
  return result.report.stop_reason == SP::STOPPED || (match && match->report.stop_reason == SP::STOPPED);
}

std::string Run_report::verdict() const
{
  return !result.is_one_to_one ? "Not bijective: " + fault() : "Certified: the map is bijective.";
}

void Run_report::print_surface(std::ostream& out) const
{
  const SP::Parameterization_report& run = result.report;
  const bool is_repaired = repair != nullptr && repair->has_changed_surface();
  out << "Mesh      " << printable(m_input) << (is_repaired ? ", repaired: " : ": ")
      << sizes_of(run.number_of_vertices, run.number_of_faces);
  if(run.number_of_isolated_vertices > 0)
    out << ", and " << run.number_of_isolated_vertices << " isolated vertices";
  if(run.number_of_flat_faces > 0)
    out << "; " << run.number_of_flat_faces << (run.number_of_flat_faces == 1 ? " face is" : " faces are")
        << " nearly flat";
  out << '\n';
  if(component)
    out << "Component " << component->index + 1 << " of " << component->sizes->size() << ", with "
        << (*component->sizes)[component->index] << " faces" << sizes_of_others(*component) << '\n';
  if(repair != nullptr)
  {
    const char* name = "Repaired  ";
    for(const std::string& line : repair->descriptions())
      out << std::exchange(name, "          ") << line << '\n';
    // The removed components may be needed.
    if(20 * repair->report().removed_faces.number > run.number_of_faces && !m_options.has("each-component"))
      out << "          map --each-component maps each component\n";
  }
}

void Run_report::print(std::ostream& out) const
{
  const SP::Parameterization_report& run = result.report;
  print_surface(out);
  out << "Method    " << m_options.description << '\n';
  if(m_options.method == "hierarchical")
    out << "Sweeps    " << run.number_of_level_iterations << " over " << run.number_of_levels << " levels\n";
  else if(!is_among(m_options.method, {"stereographic", "schnyder", "none"}))
    out << (m_options.method == "bld" ? "Sweeps    " : "Steps     ") << run.number_of_iterations() << " ("
        << stop_reason() << ")\n";
  out << "Radius    " << fixed_text(run.radius, 10, false);
  if(written_radius)
    out << "; the sphere is written with the radius " << fixed_text(*written_radius, 10, false);
  const char* separator = " = ";
  out << "\nSeconds   " << fixed_text(seconds(), 2);
  for(auto [name, time] : phases())
    if((name != "sampling" || remesh) && (name != "matching" || match))
    {
      std::replace(name.begin(), name.end(), '_', ' ');
      out << std::exchange(separator, " + ") << fixed_text(time, 2) << ' ' << name;
    }
  out << "\n\n            maximum     average   deviation\n";
  print_line(out, "D_iso  ", distortion.isometric);
  print_line(out, "D_area ", distortion.area);
  print_line(out, "D_angle", distortion.angle);
  if(balanced)
  {
    out << "with the radius " << fixed_text(balanced->radius, 10, false) << ", which balances areas:\n";
    print_line(out, "D_iso  ", balanced->isometric);
    print_line(out, "D_area ", balanced->area);
  }
  if(result.areas)
    print_areas(out);
  out << distortion.number_of_inverted_faces << " inverted faces, " << distortion.number_of_degenerate_faces
      << " degenerate faces"
      << (distortion.number_of_degenerate_faces > 0 ? ", which are excluded from the statistics" : "") << "\n\n";
  if(!match || !result.is_one_to_one) // the map between surfaces has its own certificate
    out << verdict() << '\n';
  if(remesh)
    print_remesh(out, *remesh);
  if(match)
    print_match(out);
  for(const std::string& file : files)
    out << "Written:   " << printable(file) << '\n';
  if(color_range)
    out << "Colors:    " << color_name() << " from " << fixed_text((*color_range)[0], 3) << " (violet) to "
        << fixed_text((*color_range)[1], 3) << " (yellow)\n";
  out << std::flush;
}

std::string Run_report::short_text() const
{
  const SP::Distortion_statistics& isometric = (balanced ? *balanced : distortion).isometric;
  return joined(result.report.number_of_vertices, " vertices, D_iso ", fixed_text(isometric.maximum, 4, false), " / ",
                fixed_text(isometric.average, 4, false), ", ", fixed_text(seconds(), 2), " s",
                result.is_one_to_one ? "" : ", not bijective: " + fault());
}

std::string Run_report::warnings() const
{
  const std::string others = match ? match->warnings : remesh ? remesh->warnings : "";
  return joined(repair != nullptr && repair->report().added_area > 0.5
                    ? printable(m_input) + ": hole patches are more than half of the mapped area, so that they "
                                           "determine most of the map\n"
                    : "",
                others.find(mixed_hemispheres) == others.npos ? mixed_hemispheres : "", others, texture_warning);
}

std::string Run_report::explain_fault() const
{
  return printable(m_input) + ": the map is not bijective: " + fault() +
         (m_options.sphere_file.empty()
              ? "\n--method " + m_options.method + " does not guarantee bijectivity; --method bld does."
              : "");
}

void Run_report::print_match(std::ostream& out) const
{
  const auto number = [](double x) { return fixed_text(x, 3); };
  const auto& [other, is_template, n, report, d, warnings, energy_before, n_new, parents] = *match;
  out << (is_template ? "Template:  " : "Onto:      ") << printable(other) << ": " << n
      << " vertices; symmetric Dirichlet energy ";
  if(d)
    out << number(d->energy.average_over_first) << " / " << number(d->energy.average_over_second)
        << " averaged over both surfaces, D_iso " << number(d->isometric.average_over_first) << " / "
        << number(d->isometric.average_over_second) << ", maximum " << number(d->isometric.maximum);
  else
    out << "about " << number(report.energy) << ", sampled, because the common refinement has too many vertices";
  if(energy_before)
    out << "\nSplit:     " << n_new << " edges, which adds " << 2 * n_new << " faces; energy " << number(*energy_before)
        << " before, " << number(report.energy) << " after";
  out << "\nAligned:   by ";
  const std::size_t n_landmarks = report.landmark_distances.size();
  if(n_landmarks == 0 || report.agreement != 0.)
    out << "features, agreement " << number(report.agreement) << ", margin " << number(report.margin)
        << (report.expected_error
                ? ", expected error " + number(*report.expected_error) + " of the square root of the area"
                : "")
        << (report.is_uncertain ? " (ambiguous: check the map)" : "");
  else
    out << "landmarks";
  if(n_landmarks > 0)
    out << "; " << n_landmarks - report.number_of_missed_landmarks << " of " << n_landmarks << " landmarks "
        << (m_options.landmark_weight > 0. ? "are soft" : "are met");
  out << "; " << SP::get_stop_message(report.stop_reason)
      << "\nCertified: the map between the surfaces is bijective.\n";
}

std::string Run_report::fault() const
{
  const std::size_t n = distortion.number_of_inverted_faces;
  return n == 0   ? "the faces cover the sphere more than once."
         : n == 1 ? "1 face is inverted."
                  : joined(n, " faces are inverted.");
}

std::string Run_report::stop_reason() const
{
  return is_interrupted() ? stop_reason_interrupted : SP::get_stop_message(result.report.stop_reason);
}

const char* Run_report::color_name() const
{
  return m_options.is_conformal() ? "D_angle" : (balanced ? "balanced D_iso" : "D_iso");
}

} // namespace Program
