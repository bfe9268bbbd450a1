#include "Run_report.h"
#include "command_line.h"

#include <CGAL/Spherical_parameterization/Target_area_parameterizer_3.h>

#include <cmath>
#include <filesystem>

namespace Program {

namespace {

Json_object json_of(const File_stamp& stamp)
{
  return Json_object().add("bytes", stamp.bytes).add("changed", stamp.changed);
}

// With the number and the ratio of each vertex that is off, the place where areas could not be had.
Json_object json_of(const SP::Area_report& areas)
{
  std::vector<std::size_t> vertices;
  std::vector<double> ratios;
  for(std::size_t v = 0; v < areas.ratios.size(); ++v)
    if(std::abs(areas.ratios[v] - 1.) > 0.01)
    {
      vertices.push_back(v);
      ratios.push_back(areas.ratios[v]);
    }
  return Json_object()
      .add("reached", areas.is_reached())
      .add("deviation", areas.deviation)
      .add("largest_deviation", areas.largest_deviation)
      .add("steps", areas.number_of_steps)
      .add("raised_faces", areas.number_of_raised_faces)
      .add("off_vertices", vertices)
      .add("ratios_of_off_vertices", ratios);
}

} // namespace

Json_object json_of(const SP::Distortion_statistics& of)
{
  return Json_object().add("maximum", of.maximum).add("average", of.average).add("deviation", of.deviation);
}

Json_object Run_report::statistics(SP::Distortion_statistics SP::Distortion_summary::*of_sphere,
                                   SP::Distortion_between::Statistics SP::Distortion_between::*of_surfaces) const
{
  if(match)
  {
    const SP::Distortion_between::Statistics& of = (*match->distortion).*of_surfaces;
    return Json_object()
        .add("maximum", of.maximum)
        .add("average over the first", of.average_over_first)
        .add("average over the second", of.average_over_second);
  }
  return json_of((balanced ? *balanced : distortion).*of_sphere);
}

Json_object Run_report::summary() const
{
  const SP::Parameterization_report& run = result.report;
  Json_object texts;
  texts
      .add("Mesh",
           std::to_string(run.number_of_vertices) + " vertices, " + std::to_string(run.number_of_faces) + " faces")
      .add("Method", m_options.description)
      .add("Radius", fixed_text(run.radius, 10, false));
  if(match)
    texts.add("Mapped onto", printable(std::filesystem::path(match->other).filename().string()) + ": " +
                                 std::to_string(match->number_of_vertices) + " vertices");
  else if(balanced)
    texts.add("Radius of the distortions", fixed_text(balanced->radius, 10, false) + ", of balanced areas (eq. 11)");
  return texts.add("Seconds", fixed_text(seconds(), 2)).add("Program", program_version());
}

std::string Run_report::json() const
{
  const SP::Parameterization_report& run = result.report;
  Json_object all;
  all.add("program", program_version()).add("input", m_input);
  if(!subject.empty())
    all.add("subject", subject);
  if(!hemisphere.empty())
    all.add("hemisphere", hemisphere);
  all.add("input_stamp", json_of(input_stamp))
      .add("vertices", run.number_of_vertices)
      .add("faces", run.number_of_faces)
      .add("isolated_vertices", run.number_of_isolated_vertices)
      .add("flat_faces", run.number_of_flat_faces)
      .add("method", m_options.description)
      .add("one_to_one", result.is_one_to_one)
      .add("stop_reason", stop_reason())
      .add("levels", run.number_of_levels)
      .add("attempts", run.number_of_attempts)
      .add("used_last_resort", run.used_last_resort)
      .add("sweeps", Json_object()
                         .add("levels", run.number_of_level_iterations)
                         .add("average", run.number_of_average_iterations)
                         .add("sharp", run.number_of_sharp_iterations))
      .add("sharpness", run.sharpness)
      .add("radius", run.radius)
      .add("energy", Json_object()
                         .add("initial_average", run.initial_energy)
                         .add("average", run.average_energy)
                         .add("maximum", run.largest_energy))
      .add("history", result.history)
      .add("distortion", Json_object()
                             .add("D_iso", json_of(distortion.isometric))
                             .add("D_area", json_of(distortion.area))
                             .add("D_angle", json_of(distortion.angle))
                             .add("inverted_faces", distortion.number_of_inverted_faces)
                             .add("degenerate_faces", distortion.number_of_degenerate_faces));
  if(written_radius)
    all.add("written_radius", *written_radius);
  if(result.areas)
    all.add("areas", json_of(*result.areas));
  if(!components.empty())
    all.add("component", component + 1).add("faces_of_components", components);
  if(m_options.max_hole_edges > 0)
  {
    std::vector<Json_object> figures;
    for(const Input_mesh::Hole& hole : holes)
      figures.push_back(Json_object()
                            .add("vertex", hole.vertex)
                            .add("edges", hole.number_of_edges)
                            .add("perimeter", hole.perimeter)
                            .add("faces", hole.number_of_faces)
                            .add("share_of_area", hole.share));
    all.add("holes", figures);
  }
  if(!start_stamp.is_empty())
    all.add("start_stamp", json_of(start_stamp));
  if(balanced)
    all.add("balanced", Json_object()
                            .add("radius", balanced->radius)
                            .add("D_iso", json_of(balanced->isometric))
                            .add("D_area", json_of(balanced->area)));
  Json_object times;
  for(const auto& [name, time] : phases())
    times.add(name, time);
  all.add("seconds", times.add("total", seconds()));
  if(remesh)
  {
    const auto one_way = [&](std::size_t k) {
      return Json_object().add("root_mean_square", remesh->root_mean_square[k]).add("maximum", remesh->maximum[k]);
    };
    all.add("remesh", Json_object()
                          .add("vertices", remesh->number_of_vertices)
                          .add("faces", remesh->number_of_faces)
                          .add("distance_from_surface", one_way(0))
                          .add("distance_to_surface", one_way(1))
                          .add("diagonal", remesh->diagonal)
                          .add("psnr", remesh->psnr));
  }
  if(match)
  {
    const auto between = [](const SP::Distortion_between::Statistics& of) {
      return Json_object()
          .add("maximum", of.maximum)
          .add("average", of.average_over_first)
          .add("average_over_target", of.average_over_second);
    };
    Json_object figures;
    figures.add(match->is_template ? "template" : "target", match->other)
        .add("is_atlas", m_options.is_onto_atlas)
        .add("features", m_options.feature_files)
        .add("regularized", m_options.regularizes_spheres ? "spheres" : "surfaces")
        .add("vertices", match->number_of_vertices)
        .add("agreement", match->report.agreement)
        .add("margin", match->report.margin)
        .add("is_uncertain", match->report.is_uncertain)
        .add("stop_reason", SP::get_stop_message(match->report.stop_reason))
        .add("sweeps", match->report.number_of_sweeps);
    if(match->distortion)
      figures.add("energy", between(match->distortion->energy))
          .add("D_iso", between(match->distortion->isometric))
          .add("D_area", between(match->distortion->area))
          .add("D_angle", between(match->distortion->angle))
          .add("triangles", match->distortion->number_of_triangles)
          .add("slivers", match->distortion->number_of_slivers);
    else
      figures.add("sampled_energy", match->report.energy);
    figures.add("landmark_distances", match->report.landmark_distances)
        .add("missed_landmarks", match->report.number_of_missed_landmarks);
    if(match->energy_before)
      figures.add("split", Json_object()
                               .add("new_vertices", match->number_of_new_vertices)
                               .add("new_faces", 2 * match->number_of_new_vertices)
                               .add("energy_before", *match->energy_before)
                               .add("energy", match->report.energy)
                               .add("faces_of_input", match->parents));
    all.add("match", figures);
  }
  if(color_range)
    all.add(
        "colors",
        Json_object().add("measure", color_name()).add("minimum", (*color_range)[0]).add("maximum", (*color_range)[1]));
  if(sphere_checksum)
    all.add("sphere_bytes", sphere_checksum->bytes).add("sphere_crc32", sphere_checksum->crc.checksum());
  std::string text = all.add("files", files).text();
  text.erase(text.rfind('\n')); // the end of the object
  return sealed(text);
}

std::string Run_report::sealed(const std::string& text)
{
  Checksum checksum;
  checksum.add(text.data(), text.size());
  return text + seal + std::to_string(checksum.crc.checksum()) + "\n}\n";
}

void Run_report::print_areas(std::ostream& out) const
{
  const SP::Area_report& areas = *result.areas;
  constexpr int digits = 2;
  const auto percent = [](double x) { return fixed_text(100. * x, digits, false) + " %"; };
  out << "Areas of cells over what was wanted: deviation " << percent(areas.deviation) << ", "
      << percent(areas.largest_deviation) << " at most; " << areas.number_of_off_vertices << " of "
      << result.report.number_of_vertices << " vertices are off by more than 1 %"
      << (areas.is_reached() ? "" : ": not all areas could be had") << '\n';
  if(areas.number_of_raised_faces > 0)
    out << "A millionth of the mean area was wanted for " << areas.number_of_raised_faces
        << (areas.number_of_raised_faces == 1 ? " face that has" : " faces that have") << " less\n";
}

} // namespace Program
