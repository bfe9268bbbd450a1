#ifndef PROGRAM_RUN_REPORT_H
#define PROGRAM_RUN_REPORT_H

#include "Json.h"
#include "output_files.h"
#include "run_method.h"

#include <CGAL/Spherical_parameterization/Surface_maps/Surface_map_report.h>

namespace Program {

Json json_of(const SP::Distortion_statistics& of);

/// returns "12 vertices, 20 faces", say.
std::string sizes_of(std::size_t number_of_vertices, std::size_t number_of_faces);

/// The size of a file and when it was last changed: by which many build tools see whether it is as it was.
struct File_stamp
{
  File_stamp() = default;

  /// takes the stamp of a file; it is empty if there is no such file, or nothing is known of it.
  explicit File_stamp(const std::string& name);

  bool is_empty() const { return changed.empty(); }
  Json json() const { return {{"bytes", bytes}, {"changed", changed}}; }

  std::uintmax_t bytes = 0;
  std::string changed; ///< in ticks of the clock of the file system, of which nothing but equality is meant
};

/// All that is told of a run: as a text for people, as JSON for programs.
class Run_report
{
public:
  /// \param options have to live longer
  Run_report(const Options& options, const std::string& input)
    : m_options(options)
    , m_input(input)
  {}

  /// The reason to stop, as JSON tells it, of a run that was asked for its map before the method had come to its end.
  static constexpr const char* stop_reason_interrupted = "interrupted";

  /// The component of a surface that was picked, of several.
  struct Component
  {
    Component() = default;

    /// picks the first one.
    ///
    /// \param all the faces of each
    explicit Component(const std::vector<std::vector<std::size_t>>& all);

    std::size_t index = 0;
    std::shared_ptr<const std::vector<std::size_t>>
        sizes; ///< in faces, of all components; the reports of all of them share it
  };

  /// What is told of a remesh.
  struct Remesh_figures
  {
    std::size_t number_of_vertices, number_of_faces;
    std::array<double, 2> root_mean_square, maximum; ///< of the distances from the surface, and to it
    double diagonal, psnr;
    std::string warnings; ///< of properties that are not carried over
  };

  /// What is told of a map between two surfaces.
  struct Match_figures
  {
    std::string other;        ///< the file of the other surface
    bool is_template = false; ///< whether the other one is mapped onto the input
    std::size_t number_of_vertices = 0;
    SP::Surface_map_report report;
    std::optional<SP::Distortion_between> distortion; ///< none if the common refinement is too large to be made
    std::string warnings;                             ///< see `Surface_match`
    std::optional<double> energy_before;              ///< if the first surface has been refined
    std::size_t number_of_new_vertices = 0;           ///< that it has then
    std::vector<std::size_t> parents;                 ///< what its faces are parts of, as numbers in the file
  };

  Run_result result;
  SP::Distortion_summary distortion;
  /// with the radius of eq. 11, if the map is to the unit sphere, whatever the size of the surface
  std::optional<SP::Distortion_summary> balanced;
  std::optional<double> written_radius; ///< of the sphere in its file, if it is not that of the map
  double seconds_for_input = 0.;        ///< reading and checking the file
  double seconds_for_measuring = 0., seconds_for_sampling = 0.;
  double seconds_for_matching = 0.;        ///< the other surface, and the map between both
  double seconds_for_output = 0.;          ///< writing all files but that with this report
  Words files;                             ///< that were written
  std::string hemisphere;                  ///< that the surface is of; empty if that is not known
  std::string mixed_hemispheres;           ///< a line, if the name and the metadata of the file disagree
  File_stamp input_stamp;                  ///< of the file, before it was read, but for its parts
  File_stamp start_stamp;                  ///< of the file with the map to start from; empty if there is none
  std::optional<Checksum> sphere_checksum; ///< if it was written, and to an ordinary file
  std::optional<Component> component;      ///< none if all of the surface was taken
  const Surface_repair* repair = nullptr;  ///< what was repaired, null if that was not wanted
  std::optional<Remesh_figures> remesh;
  std::optional<Match_figures> match;
  /// the distortion with the darkest colour, and that with the lightest, if colours were written
  std::optional<std::array<double, 2>> color_range;

  const std::string& input() const { return m_input; }

  /// returns whether a signal has ended the method, or the map between surfaces.
  bool is_interrupted() const;

  double seconds() const;

  /// returns whether the method only cares for angles.
  bool shows_angles() const { return m_options.is_conformal(); }

  /// returns what the certificate has found.
  std::string verdict() const;

  /// returns the statistics of a measure, by their names: between the surfaces, if there are two.
  Json statistics(SP::Distortion_statistics SP::Distortion_summary::*of_sphere,
                  SP::Distortion_between::Statistics SP::Distortion_between::*of_surfaces) const;

  /// returns what the run was, as texts.
  Json summary() const;

  void print(std::ostream& out) const;

  /// prints what there is to say of the surface itself.
  void print_surface(std::ostream& out) const;

  /// returns what matters most in one line, without its end.
  std::string short_text() const;

  /// returns what is to be said of patches, of a name that disagrees with the metadata, and of the map between surfaces or the remesh,
  /// a line each, empty if there is nothing.
  std::string warnings() const;

  /// returns what is wrong with a map that is not one-to-one, and what helps.
  std::string explain_fault() const;

  std::string json() const;

  /// returns a report that lacks its end, with its checksum as the last member.
  static std::string sealed(const std::string& text);

  /// What comes between a report and the checksum of what is before.
  static constexpr const char* seal = ",\n  \"crc32\": ";

private:
  // The parts of the running time, by their names.
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
