#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_REPORT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_REPORT_H

#include "Interrupt_guard.h"
#include "Json_object.h"
#include "Output_file.h"
#include "Program_error.h"
#include "Program_options.h"
#include "mesh_files.h"
#include "run_method.h"

#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Repair/fill_holes.h>
#include <CGAL/Spherical_parameterization/Sampling/measure_distance.h>
#include <CGAL/Spherical_parameterization/Surface_maps/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/Surface_maps/measure_distortion_between.h>
#include <CGAL/version_macros.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace Program {

/// returns the name of the program, its version, and that of CGAL.
inline std::string program_version()
{
#ifdef SPHERICAL_PARAMETERIZATION_VERSION
  constexpr const char* version = SPHERICAL_PARAMETERIZATION_VERSION;
#else
  constexpr const char* version = "of CGAL"; // within which the package has no version of its own
#endif
  return std::string("spherical_parameterization ") + version + ", built with CGAL " + CGAL_VERSION_STR;
}

/// All that is told of a run: as a text for people, as JSON for programs.
class Run_report
{
public:
  /// \param options have to live longer
  Run_report(const Program_options& options, const std::string& input)
    : m_options(options)
    , m_input(input)
  {}

  /// The exit status of the program if a map was written that is not one-to-one.
  static constexpr int exit_status_folded = 2;

  /// The reason to stop, as JSON tells it, of a run that was asked for its map before the method had come to its end.
  static constexpr const char* stop_reason_interrupted = "interrupted";

  /// What is told of a remesh.
  struct Remesh_figures
  {
    std::size_t number_of_vertices, number_of_faces;
    SP::Surface_distance distance;
    std::string warnings; ///< of properties that are not carried over
  };

  /// What is told of a map between two surfaces.
  struct Match_figures
  {
    std::string other; ///< the file of the other surface
    bool is_template;  ///< whether the other one is mapped onto the input
    std::size_t number_of_vertices;
    SP::Surface_map_report report;
    std::optional<SP::Distortion_between> distortion; ///< as `Surface_match` has it
    std::string warnings;                             ///< of landmarks that are missed
    std::optional<double> energy_before;              ///< if the surface was refined
    std::size_t number_of_new_vertices;
    std::vector<std::size_t> parents; ///< of the faces of the refined surface, in the input
  };

  Run_result result;
  SP::Distortion_summary distortion;
  /// with the radius of eq. 11, if the map is to the unit sphere, whatever the size of the surface
  std::optional<SP::Distortion_summary> balanced;
  std::optional<double> written_radius; ///< of the sphere in its file, if it is not that of the map
  double seconds_for_input = 0.;        ///< reading and checking the file
  double seconds_for_measuring = 0.;
  double seconds_for_sampling = 0.;
  double seconds_for_matching = 0.;         ///< the other surface, and the map between both
  double seconds_for_output = 0.;           ///< writing all files but that with this report
  Words files;                              ///< that were written
  std::string subject, hemisphere;          ///< that the surface is of; empty if that is not known
  std::string mixed_hemispheres;            ///< a line, if the name and the metadata of the file disagree
  File_stamp input_stamp;                   ///< of the file, before it was read
  File_stamp start_stamp;                   ///< of the file with the map to start from; empty if there is none
  std::optional<Checksum> sphere_checksum;  ///< if it was written, and to an ordinary file
  std::vector<std::size_t> components;      ///< the numbers of their faces, if one was picked
  std::size_t component = 0;                ///< which
  std::vector<SP::Filled_hole<Mesh>> holes; ///< if they were to be filled
  std::optional<Remesh_figures> remesh;
  std::optional<Match_figures> match;
  /// the distortion with the darkest colour, and that with the lightest, if colours were written
  std::optional<std::array<double, 2>> color_range;

  const std::string& input() const { return m_input; }

  /// returns whether a signal has ended the method, or the map between surfaces.
  bool is_interrupted() const
  {
    return result.report.stop_reason == SP::STOPPED || (match && match->report.stop_reason == SP::STOPPED);
  }

  double seconds() const
  {
    return seconds_for_input + result.report.seconds() + seconds_for_measuring + seconds_for_sampling +
           seconds_for_matching + seconds_for_output;
  }

  /// returns whether the method only cares for angles.
  bool shows_angles() const { return m_options.is_conformal(); }

  /// returns what the certificate has found.
  std::string verdict() const
  {
    return !result.is_one_to_one ? "Not one-to-one: " + fault()
           : match && match->report.is_uncertain
               ? "Certified: the map is one-to-one. It is not clear that the surfaces lie well on each other."
               : "Certified: the map is one-to-one.";
  }

  /// returns the statistics of a measure, by their names: between the surfaces, if there are two.
  Json_object statistics(SP::Distortion_statistics SP::Distortion_summary::*of_sphere,
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
    const SP::Distortion_statistics& of = (balanced ? *balanced : distortion).*of_sphere;
    return Json_object().add("maximum", of.maximum).add("average", of.average).add("deviation", of.deviation);
  }

  /// returns what the run was, as texts.
  Json_object summary() const
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

  void print(std::ostream& out) const
  {
    const SP::Parameterization_report& run = result.report;
    out << "Mesh      " << printable(m_input) << ": " << run.number_of_vertices << " vertices, " << run.number_of_faces
        << " faces";
    if(run.number_of_isolated_vertices > 0)
      out << ", and " << run.number_of_isolated_vertices << " vertices without a face";
    if(run.number_of_flat_faces > 0)
      out << "; " << run.number_of_flat_faces << (run.number_of_flat_faces == 1 ? " face is" : " faces are")
          << " nearly flat";
    out << '\n';
    if(!components.empty())
      out << "Part      " << component + 1 << " of " << components.size() << ", with " << components[component]
          << " faces" << sizes_of_others() << '\n';
    if(!holes.empty())
      out << "Holes     " << describe_holes() << '\n';
    out << "Method    " << m_options.description << '\n';
    if(m_options.method == "hierarchical")
      out << "Sweeps    " << run.number_of_level_iterations << " over " << run.number_of_levels << " levels\n";
    else if(!is_among(m_options.method, {"stereographic", "schnyder"}))
      out << (m_options.method == "bld" ? "Sweeps    " : "Steps     ") << run.number_of_iterations() << " ("
          << stop_reason() << ")\n";
    out << "Radius    " << fixed_text(run.radius, 10, false);
    if(written_radius)
      out << "; the sphere is written with the radius " << fixed_text(*written_radius, 10, false);
    out << "\nSeconds   " << fixed_text(seconds(), 2) << " = " << fixed_text(seconds_for_input, 2) << " input + "
        << fixed_text(run.seconds_for_reading, 2) << " copy + " << fixed_text(run.seconds_for_hierarchy, 2)
        << " hierarchy + " << fixed_text(run.seconds_for_embedding, 2) << " initial map + "
        << fixed_text(run.seconds_for_optimization, 2) << " sweeps + " << fixed_text(run.seconds_for_certificate, 2)
        << " certificate + " << fixed_text(seconds_for_measuring, 2) << " measuring + "
        << (remesh ? fixed_text(seconds_for_sampling, 2) + " sampling + " : "")
        << (match ? fixed_text(seconds_for_matching, 2) + " matching + " : "") << fixed_text(seconds_for_output, 2)
        << " output\n\n            maximum     average   deviation\n";
    print_line(out, "D_iso  ", distortion.isometric);
    print_line(out, "D_area ", distortion.area);
    print_line(out, "D_angle", distortion.angle);
    if(balanced)
    {
      out << "with the radius " << fixed_text(balanced->radius, 10, false) << " of balanced areas (eq. 11):\n";
      print_line(out, "D_iso  ", balanced->isometric);
      print_line(out, "D_area ", balanced->area);
    }
    if(result.areas)
      print_areas(out, *result.areas);
    out << distortion.number_of_inverted_faces << " inverted faces, " << distortion.number_of_degenerate_faces
        << " degenerate faces" << (distortion.number_of_degenerate_faces > 0 ? ", which are left out" : "") << "\n\n"
        << verdict() << '\n';
    if(remesh)
      print_remesh(out);
    if(match)
      print_match(out);
    for(const std::string& file : files)
      out << "Written:   " << printable(file) << '\n';
    if(color_range)
      out << "Colours:   " << color_name() << " from " << fixed_text((*color_range)[0], 3) << " (violet) to "
          << fixed_text((*color_range)[1], 3) << " (yellow)\n";
    out << std::flush;
  }

  /// returns what matters most in one line, without its end.
  std::string short_text() const
  {
    constexpr int digits = 4;
    const SP::Distortion_statistics& isometric = (balanced ? *balanced : distortion).isometric;
    return std::to_string(result.report.number_of_vertices) + " vertices, D_iso " +
           fixed_text(isometric.maximum, digits, false) + " / " + fixed_text(isometric.average, digits, false) + ", " +
           fixed_text(seconds(), 2) + " s" + (result.is_one_to_one ? "" : ", folds: " + fault());
  }

  /// returns what is to be said of filler, of a name that disagrees with the metadata, and of the map between surfaces or the remesh,
  /// a line each, empty if there is nothing.
  std::string warnings() const
  {
    const std::string others = match ? match->warnings : remesh ? remesh->warnings : "";
    return (share_of_filler() > 0.5 ? printable(m_input) + ": more than half of the area that is mapped is filler: the "
                                                           "surface has little to say of its sphere\n"
                                    : "") +
           (others.find(mixed_hemispheres) == others.npos ? mixed_hemispheres : "") + others;
  }

  /// returns what is wrong with a map that is not one-to-one, and what helps.
  std::string explain_fault() const
  {
    return printable(m_input) + ": the map is not one-to-one: " + fault() + "\n--method " + m_options.method +
           " does not exclude that; --method bld does.";
  }

  std::string json() const
  {
    const SP::Parameterization_report& run = result.report;
    const auto stamp_of = [](const File_stamp& stamp) {
      return Json_object().add("bytes", stamp.bytes).add("changed", stamp.changed);
    };
    const auto statistics = [](const SP::Distortion_statistics& of) {
      return Json_object().add("maximum", of.maximum).add("average", of.average).add("deviation", of.deviation);
    };
    Json_object all;
    all.add("program", program_version()).add("input", m_input);
    if(!subject.empty())
      all.add("subject", subject);
    if(!hemisphere.empty())
      all.add("hemisphere", hemisphere);
    all.add("input_stamp", stamp_of(input_stamp))
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
                               .add("D_iso", statistics(distortion.isometric))
                               .add("D_area", statistics(distortion.area))
                               .add("D_angle", statistics(distortion.angle))
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
      for(const SP::Filled_hole<Mesh>& hole : holes)
        figures.push_back(Json_object()
                              .add("vertex", std::size_t(hole.vertex))
                              .add("edges", hole.number_of_edges)
                              .add("perimeter", hole.perimeter)
                              .add("faces", hole.faces.size())
                              .add("share_of_area", hole.share));
      all.add("holes", figures);
    }
    if(!start_stamp.is_empty())
      all.add("start_stamp", stamp_of(start_stamp));
    if(balanced)
      all.add("balanced", Json_object()
                              .add("radius", balanced->radius)
                              .add("D_iso", statistics(balanced->isometric))
                              .add("D_area", statistics(balanced->area)));
    all.add("seconds", Json_object()
                           .add("input", seconds_for_input)
                           .add("copy", run.seconds_for_reading)
                           .add("hierarchy", run.seconds_for_hierarchy)
                           .add("initial_map", run.seconds_for_embedding)
                           .add("sweeps", run.seconds_for_optimization)
                           .add("certificate", run.seconds_for_certificate)
                           .add("measuring", seconds_for_measuring)
                           .add("sampling", seconds_for_sampling)
                           .add("matching", seconds_for_matching)
                           .add("output", seconds_for_output)
                           .add("total", seconds()));
    if(remesh)
    {
      const auto one_way = [](const SP::Surface_distance::One_way& of) {
        return Json_object().add("root_mean_square", of.root_mean_square).add("maximum", of.maximum);
      };
      all.add("remesh", Json_object()
                            .add("vertices", remesh->number_of_vertices)
                            .add("faces", remesh->number_of_faces)
                            .add("distance_from_surface", one_way(remesh->distance.from_first))
                            .add("distance_to_surface", one_way(remesh->distance.from_second))
                            .add("diagonal", remesh->distance.diagonal)
                            .add("psnr", remesh->distance.psnr()));
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
      all.add("colors", Json_object()
                            .add("measure", color_name())
                            .add("minimum", (*color_range)[0])
                            .add("maximum", (*color_range)[1]));
    if(sphere_checksum)
      all.add("sphere_bytes", sphere_checksum->bytes).add("sphere_crc32", sphere_checksum->crc.checksum());
    std::string text = all.add("files", files).text();
    text.erase(text.rfind('\n')); // the end of the object
    return sealed(text);
  }

  /// returns a report that lacks its end, with its checksum as the last member.
  static std::string sealed(const std::string& text)
  {
    Checksum checksum;
    checksum.add(text.data(), text.size());
    return text + seal + std::to_string(checksum.crc.checksum()) + "\n}\n";
  }

  /// What comes between a report and the checksum of what is before.
  static constexpr const char* seal = ",\n  \"crc32\": ";

private:
  double share_of_filler() const
  {
    double share = 0.;
    for(const SP::Filled_hole<Mesh>& hole : holes)
      share += hole.share;
    return share;
  }

  std::string sizes_of_others() const
  {
    constexpr std::size_t max_named = 5;
    std::vector<std::string> sizes;
    for(std::size_t k = 0; k < components.size() && sizes.size() < max_named; ++k)
      if(k != component)
        sizes.push_back(std::to_string(components[k]));
    if(sizes.empty())
      return "";
    return std::string("; the others have ") + list_of(sizes, " and ") +
           (components.size() > max_named + 1 ? ", and " + std::to_string(components.size() - 1 - max_named) + " less"
                                              : "");
  }

  // the largest ones, and how many there are
  std::string describe_holes() const
  {
    constexpr std::size_t max_named = 5;
    constexpr int digits = 2;
    std::vector<SP::Filled_hole<Mesh>> sorted = holes;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.number_of_edges > b.number_of_edges; });
    std::size_t n_filled = 0;
    for(const SP::Filled_hole<Mesh>& hole : sorted)
      n_filled += !hole.faces.empty();
    std::string text =
        std::to_string(n_filled) + " filled, " + fixed_text(100. * share_of_filler(), digits) + " % of the area";
    for(std::size_t k = 0; k < sorted.size() && k < max_named; ++k)
      text += (k == 0 ? ": " : "; ") + std::to_string(sorted[k].number_of_edges) + " edges at vertex " +
              std::to_string(std::size_t(sorted[k].vertex)) + ", perimeter " +
              fixed_text(sorted[k].perimeter, 6, false) +
              (sorted[k].faces.empty() ? ", left open" : ", " + fixed_text(100. * sorted[k].share, digits) + " %");
    return text + (sorted.size() > max_named
                       ? "; and " + std::to_string(sorted.size() - max_named) + " with fewer edges"
                       : "");
  }

  void print_match(std::ostream& out) const
  {
    constexpr int digits = 3;
    const auto& [other, is_template, n, report, d, warnings, energy_before, n_new, parents] = *match;
    out << (is_template ? "Template:  " : "Onto:      ") << printable(other) << ": " << n
        << " vertices; symmetric Dirichlet energy ";
    if(d)
      out << fixed_text(d->energy.average_over_first, digits) << " / "
          << fixed_text(d->energy.average_over_second, digits) << " over both surfaces, D_iso "
          << fixed_text(d->isometric.average_over_first, digits) << " / "
          << fixed_text(d->isometric.average_over_second, digits) << ", " << fixed_text(d->isometric.maximum, digits)
          << " at most";
    else
      out << "about " << fixed_text(report.energy, digits)
          << ", by samples: the common refinement has too many vertices to be made";
    if(energy_before)
      out << "\nSplit:     " << n_new << " edges, with " << 2 * n_new << " more faces; energy "
          << fixed_text(*energy_before, digits) << " before, " << fixed_text(report.energy, digits) << " now";
    out << "\nAligned:   by ";
    const std::size_t n_landmarks = report.landmark_distances.size();
    if(n_landmarks == 0 || report.agreement != 0.)
    {
      out << "features, which agree by " << fixed_text(report.agreement, digits) << ", with a margin of "
          << fixed_text(report.margin, digits) << (report.is_uncertain ? ": look whether the map is right" : "");
    }
    else
      out << "landmarks";
    if(n_landmarks > 0)
      out << "; " << n_landmarks - report.number_of_missed_landmarks << " of " << n_landmarks << " landmarks "
          << (m_options.landmark_weight > 0. ? "are soft" : "are met");
    out << "; " << SP::get_stop_message(report.stop_reason);
    out << "\nCertified: the map between the surfaces is one-to-one.\n";
  }

  void print_areas(std::ostream& out, const SP::Area_report& areas) const
  {
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

  // with the number and the ratio of each vertex that is off, the place where areas could not be had
  static Json_object json_of(const SP::Area_report& areas)
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

  void print_remesh(std::ostream& out) const
  {
    constexpr int digits = 2;
    const SP::Surface_distance& d = remesh->distance;
    const auto larger = [&](double SP::Surface_distance::One_way::*value) {
      return fixed_text((std::max)(d.from_first.*value, d.from_second.*value) / d.diagonal, digits, false);
    };
    out << "Remesh:    " << remesh->number_of_vertices << " vertices, " << remesh->number_of_faces
        << " faces; it is off the surface by " << larger(&SP::Surface_distance::One_way::root_mean_square)
        << " of its diagonal in the root mean square, " << fixed_text(d.psnr(), digits) << " dB, and by "
        << larger(&SP::Surface_distance::One_way::maximum) << " at most\n";
  }

  std::string fault() const
  {
    const std::size_t n = distortion.number_of_inverted_faces;
    if(n == 0)
      return "the faces cover the sphere more than once.";
    return n == 1 ? "1 face is inverted." : std::to_string(n) + " faces are inverted.";
  }

  std::string stop_reason() const
  {
    return is_interrupted() ? stop_reason_interrupted : SP::get_stop_message(result.report.stop_reason);
  }

  const char* color_name() const
  {
    return m_options.is_conformal() ? "D_angle" : (balanced ? "balanced D_iso" : "D_iso");
  }

  static std::string fixed_text(double x, int digits, bool is_fixed = true)
  {
    std::ostringstream text;
    if(is_fixed)
      text << std::fixed;
    text << std::setprecision(digits) << x;
    return text.str();
  }

  static void print_line(std::ostream& out, const char* name, const SP::Distortion_statistics& statistics)
  {
    constexpr double too_long = 1e6;
    constexpr int width = 12, digits = 4;
    out << name;
    for(const double x : {statistics.maximum, statistics.average, statistics.deviation})
      out << std::setw(width) << fixed_text(x, digits, x < too_long);
    out << '\n';
  }

  const Program_options& m_options;
  std::string m_input;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RUN_REPORT_H
