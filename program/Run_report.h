#ifndef PROGRAM_RUN_REPORT_H
#define PROGRAM_RUN_REPORT_H

#include "Json.h"
#include "output_files.h"
#include "run_method.h"

#include <CGAL/Spherical_parameterization/Surface_maps/Surface_map_report.h>

namespace Program {

Json json_of(const SP::Distortion_statistics& of);

/// returns a text such as "12 vertices, 20 faces".
std::string sizes_of(std::size_t number_of_vertices, std::size_t number_of_faces);

/// The size and modification time of a file, to detect changes, as in many build tools.
struct File_stamp
{
  File_stamp() = default;

  /// takes the stamp of a file; empty if the file does not exist or cannot be examined.
  explicit File_stamp(const std::string& name);

  bool is_empty() const { return changed.empty(); }
  Json json() const { return {{"bytes", bytes}, {"changed", changed}}; }

  std::uintmax_t bytes = 0;
  std::string changed; ///< in ticks of the clock of the file system; only compared for equality
};

/// The report of a run, as text and as JSON.
class Run_report
{
public:
  /// \param options must outlive the report
  Run_report(const Options& options, const std::string& input)
    : m_options(options)
    , m_input(input)
  {}

  /// The value of `stop_reason` in JSON of a run that was interrupted before the method ended.
  static constexpr const char* stop_reason_interrupted = "interrupted";

  /// The component of a surface that is mapped, of several.
  struct Component
  {
    Component() = default;

    /// selects the first component.
    ///
    /// \param all the faces of each component
    explicit Component(const std::vector<std::vector<std::size_t>>& all);

    std::size_t index = 0;
    std::shared_ptr<const std::vector<std::size_t>> sizes; ///< in faces, of all components; shared by their reports
  };

  /// Figures of a remesh.
  struct Remesh_figures
  {
    std::size_t number_of_vertices, number_of_faces;
    std::array<double, 2> root_mean_square, maximum; ///< of the distances from the surface and to it
    double diagonal, psnr;
    std::string warnings; ///< about properties that are not transferred
  };

  /// Figures of a map between two surfaces.
  struct Match_figures
  {
    std::string other;        ///< the file of the other surface
    bool is_template = false; ///< whether the other surface is mapped onto the input
    std::size_t number_of_vertices = 0;
    SP::Surface_map_report report;
    std::optional<SP::Distortion_between> distortion; ///< none if the common refinement is too large
    std::string warnings;                             ///< see `Surface_match`
    std::optional<double> energy_before;              ///< if the first surface has been refined
    std::size_t number_of_new_vertices = 0;           ///< of the refined surface
    std::vector<std::size_t> parents;                 ///< for each of its faces, the face of the file that contains it
  };

  Run_result result;
  SP::Distortion_summary distortion;
  /// with the radius of eq. 11, if the map is to the unit sphere, independently of the size of the surface
  std::optional<SP::Distortion_summary> balanced;
  std::optional<double> written_radius; ///< of the sphere in its file, if it differs from that of the map
  double seconds_for_input = 0.;        ///< reading and checking the file
  double seconds_for_measuring = 0., seconds_for_sampling = 0.;
  double seconds_for_matching = 0.;        ///< reading the other surface, and mapping between both
  double seconds_for_output = 0.;          ///< writing all files except this report
  Words files;                             ///< written files
  std::string hemisphere;                  ///< of the surface; empty if unknown
  std::string mixed_hemispheres;           ///< a warning, one line, if name and metadata of the file disagree
  File_stamp input_stamp;                  ///< of the input file, before it was read
  File_stamp start_stamp;                  ///< of the file with the initial map; empty if there is none
  std::optional<Checksum> sphere_checksum; ///< if it was written to a regular file
  std::optional<Component> component;      ///< none if the whole surface is mapped
  const Repair_step* repair = nullptr;     ///< null if no repair was requested
  std::optional<Remesh_figures> remesh;
  std::optional<Match_figures> match;
  std::string texture_warning; ///< one line; empty if there is none
  /// the distortions with the darkest and the lightest color, if colors were written
  std::optional<std::array<double, 2>> color_range;

  const std::string& input() const { return m_input; }

  /// returns whether a signal has stopped the method, or the map between surfaces.
  bool is_interrupted() const;

  double seconds() const;

  /// returns whether the method preserves only angles.
  bool shows_angles() const { return m_options.is_conformal(); }

  /// returns the result of the certificate in words.
  std::string verdict() const;

  /// returns the statistics of a measure by name: between the surfaces, if there are two.
  Json statistics(SP::Distortion_statistics SP::Distortion_summary::*of_sphere,
                  SP::Distortion_between::Statistics SP::Distortion_between::*of_surfaces) const;

  /// returns the settings and sizes of the run as texts by name.
  Json summary() const;

  void print(std::ostream& out) const;

  /// prints the part of the report about the surface itself.
  void print_surface(std::ostream& out) const;

  /// returns the most important figures in one line, without a line break.
  std::string short_text() const;

  /// returns the warnings about patches, hemispheres, and the map between surfaces or the remesh, one per line; empty if there are none.
  std::string warnings() const;

  /// returns why a map is not bijective, and what helps.
  std::string explain_fault() const;

  std::string json() const;

  /// completes a report without its end by its checksum, as the last member.
  static std::string sealed(const std::string& text);

  /// The text between a report and the checksum of the text before.
  static constexpr const char* seal = ",\n  \"crc32\": ";

private:
  // The parts of the running time by name.
  std::vector<std::pair<std::string, double>> phases() const;

  void print_match(std::ostream& out) const;
  void print_areas(std::ostream& out) const;
  std::string fault() const;
  std::string stop_reason() const;
  const char* color_name() const;

  const Options& m_options;
  std::string m_input;
};

} // namespace Program

#endif // PROGRAM_RUN_REPORT_H
