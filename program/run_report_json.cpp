#include "Run_report.h"

#include <CGAL/Spherical_parameterization/Target_area_parameterizer_3.h>

namespace Program {

namespace {

// With the index and the area ratio of each vertex whose prescribed area is missed.
Json json_of(const SP::Area_report& areas)
{
  std::vector<std::size_t> vertices;
  std::vector<double> ratios;
  for(std::size_t v = 0; v < areas.ratios.size(); ++v)
    if(std::abs(areas.ratios[v] - 1.) > 0.01)
    {
      vertices.push_back(v);
      ratios.push_back(areas.ratios[v]);
    }
  return {{"reached", areas.is_reached()},
          {"deviation", areas.deviation},
          {"largest_deviation", areas.largest_deviation},
          {"steps", areas.number_of_steps},
          {"raised_faces", areas.number_of_raised_faces},
          {"off_vertices", vertices},
          {"ratios_of_off_vertices", ratios}};
}

Json json_of(const Run_report::Match_figures& match, const Options& options)
{
  const auto between = [](const SP::Distortion_between::Statistics& of) {
    return Json{
        {"maximum", of.maximum}, {"average", of.average_over_first}, {"average_over_target", of.average_over_second}};
  };
  Json all = {{match.is_template ? "template" : "target", match.other},
              {"is_atlas", options.is_onto_atlas},
              {"features", options.words("features")},
              {"regularized", options.text("regularize") == "spheres" ? "spheres" : "surfaces"},
              {"vertices", match.number_of_vertices},
              {"agreement", match.report.agreement},
              {"margin", match.report.margin},
              {"is_uncertain", match.report.is_uncertain},
              {"stop_reason", SP::get_stop_message(match.report.stop_reason)},
              {"sweeps", match.report.number_of_sweeps}};
  if(match.report.expected_error)
    all.add("expected_error", *match.report.expected_error);
  if(const auto& distortion = match.distortion)
    all.add("energy", between(distortion->energy))
        .add("D_iso", between(distortion->isometric))
        .add("D_area", between(distortion->area))
        .add("D_angle", between(distortion->angle))
        .add("triangles", distortion->number_of_triangles)
        .add("slivers", distortion->number_of_slivers);
  else
    all.add("sampled_energy", match.report.energy);
  all.add("landmark_distances", match.report.landmark_distances)
      .add("missed_landmarks", match.report.number_of_missed_landmarks);
  if(match.energy_before)
    all.add("split", {{"new_vertices", match.number_of_new_vertices},
                      {"new_faces", 2 * match.number_of_new_vertices},
                      {"energy_before", *match.energy_before},
                      {"energy", match.report.energy},
                      {"faces_of_input", match.parents}});
  return all;
}

// The steps of a repair in their order.
Json json_of(const Repair_step& repair)
{
  const SP::Repair_report& r = repair.report();
  std::vector<Json> patches;
  for(const SP::Repair_patch& patch : r.patches)
    patches.push_back({{"of", patch.is_of_handle ? "handle" : "hole"},
                       {"vertex", patch.vertex},
                       {"edges", patch.number_of_edges},
                       {"length", patch.length},
                       {"share_of_area", patch.share}});
  return {{"wrapped", repair.is_wrapped()},
          {"triangulated_polygons", r.triangulated_polygons.number},
          {"degenerate_faces", r.degenerate_faces.number},
          {"repeated_faces", r.repeated_faces.number},
          {"merged_vertices", r.merged_vertices.number},
          {"reversed_faces", r.reversed_faces.number},
          {"non_manifold_edges", r.non_manifold_edges.number},
          {"divided_vertices", r.divided_vertices.number},
          {"components", r.number_of_components},
          {"removed_faces", r.removed_faces.number},
          {"handles", r.handle_cycles.size()},
          {"split_edges", r.split_edges.number},
          {"added_area", r.added_area},
          {"patches", patches}};
}

} // namespace

Json json_of(const SP::Distortion_statistics& of)
{
  return {{"maximum", of.maximum}, {"average", of.average}, {"deviation", of.deviation}};
}

File_stamp::File_stamp(const std::string& name)
{
  std::error_code size_error, time_error;
  const std::uintmax_t size = std::filesystem::file_size(path_of(name), size_error);
  const std::filesystem::file_time_type time = std::filesystem::last_write_time(path_of(name), time_error);
  if(size_error || time_error)
    return;
  bytes = size;
  changed = std::to_string(time.time_since_epoch().count());
}

std::string sizes_of(std::size_t number_of_vertices, std::size_t number_of_faces)
{
  return std::to_string(number_of_vertices) + " vertices, " + std::to_string(number_of_faces) + " faces";
}

Json Run_report::statistics(SP::Distortion_statistics SP::Distortion_summary::*of_sphere,
                            SP::Distortion_between::Statistics SP::Distortion_between::*of_surfaces) const
{
  if(!match)
    return json_of((balanced ? *balanced : distortion).*of_sphere);
  const SP::Distortion_between::Statistics& of = (*match->distortion).*of_surfaces;
  return {{"maximum", of.maximum},
          {"average over the left surface", of.average_over_first},
          {"average over the right surface", of.average_over_second}};
}

Json Run_report::summary() const
{
  const SP::Parameterization_report& run = result.report;
  Json texts = {{"Mesh", sizes_of(run.number_of_vertices, run.number_of_faces)},
                {"Method", m_options.description},
                {"Radius", fixed_text(run.radius, 10, false)}};
  if(match)
  {
    texts.add("Mapped onto", printable(name_of(path_of(match->other).filename())) + ": " +
                                 std::to_string(match->number_of_vertices) + " vertices");
    if(match->report.agreement != 0.)
      texts.add("Alignment", "by features, agreement " + fixed_text(match->report.agreement, 3) + ", margin " +
                                 fixed_text(match->report.margin, 3) +
                                 (match->report.is_uncertain ? ": ambiguous" : ""));
    if(match->report.expected_error)
      texts.add("Expected error", fixed_text(*match->report.expected_error, 3) +
                                      " on average, relative to the square root of the area of the right surface");
  }
  else if(balanced)
    texts.add("Radius for distortions", fixed_text(balanced->radius, 10, false) + ", which balances areas");
  return texts.add("Seconds", fixed_text(seconds(), 2)).add("Program", program_version());
}

std::string Run_report::json() const
{
  const SP::Parameterization_report& run = result.report;
  Json all = {{"program", program_version()}, {"input", m_input}};
  if(!hemisphere.empty())
    all.add("hemisphere", hemisphere);
  all.add("input_stamp", input_stamp.json())
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
      .add("sweeps", {{"levels", run.number_of_level_iterations},
                      {"average", run.number_of_average_iterations},
                      {"sharp", run.number_of_sharp_iterations}})
      .add("sharpness", run.sharpness)
      .add("radius", run.radius)
      .add("energy",
           {{"initial_average", run.initial_energy}, {"average", run.average_energy}, {"maximum", run.largest_energy}})
      .add("history", result.history)
      .add("distortion", {{"D_iso", json_of(distortion.isometric)},
                          {"D_area", json_of(distortion.area)},
                          {"D_angle", json_of(distortion.angle)},
                          {"inverted_faces", distortion.number_of_inverted_faces},
                          {"degenerate_faces", distortion.number_of_degenerate_faces}});
  if(written_radius)
    all.add("written_radius", *written_radius);
  if(result.areas)
    all.add("areas", json_of(*result.areas));
  if(component)
  {
    all.add("component", component->index + 1).add("components", component->sizes->size());
    if(component->index == 0) // only the first report of many parts lists all
      all.add("faces_of_components", *component->sizes);
  }
  if(repair != nullptr)
    all.add("repair", json_of(*repair));
  if(!start_stamp.is_empty())
    all.add("start_stamp", start_stamp.json());
  if(balanced)
    all.add(
        "balanced",
        {{"radius", balanced->radius}, {"D_iso", json_of(balanced->isometric)}, {"D_area", json_of(balanced->area)}});
  Json times;
  for(const auto& [name, time] : phases())
    times.add(name, time);
  all.add("seconds", times.add("total", seconds()));
  if(remesh)
  {
    const auto one_way = [&](std::size_t k) {
      return Json{{"root_mean_square", remesh->root_mean_square[k]}, {"maximum", remesh->maximum[k]}};
    };
    all.add("remesh", {{"vertices", remesh->number_of_vertices},
                       {"faces", remesh->number_of_faces},
                       {"distance_from_surface", one_way(0)},
                       {"distance_to_surface", one_way(1)},
                       {"diagonal", remesh->diagonal},
                       {"psnr", remesh->psnr}});
  }
  if(match)
    all.add("match", json_of(*match, m_options));
  if(color_range)
    all.add("colors", {{"measure", color_name()}, {"minimum", (*color_range)[0]}, {"maximum", (*color_range)[1]}});
  if(sphere_checksum)
    all.add("sphere_bytes", sphere_checksum->bytes).add("sphere_crc32", sphere_checksum->crc.checksum());
  std::string text = all.add("files", files).text();
  text.erase(text.rfind('\n')); // without the end of the object
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
  const auto percent = [](double x) { return fixed_text(100. * x, 2, false) + " %"; };
  out << "Areas of cells relative to the prescribed areas: deviation " << percent(areas.deviation) << ", maximum "
      << percent(areas.largest_deviation) << "; " << areas.number_of_off_vertices << " of "
      << result.report.number_of_vertices << " vertices differ by more than 1 %"
      << (areas.is_reached() ? "" : ": not all areas could be reached") << '\n';
  if(areas.number_of_raised_faces > 0)
    out << "The prescribed area of " << areas.number_of_raised_faces
        << (areas.number_of_raised_faces == 1 ? " face was" : " faces was")
        << " raised to a millionth of the mean area\n";
}

} // namespace Program
