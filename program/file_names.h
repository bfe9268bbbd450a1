#ifndef PROGRAM_FILE_NAMES_H
#define PROGRAM_FILE_NAMES_H

#include "text.h"

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

namespace Program {

/// Input formats that are recognized by the file name extension. Formats of cortical surfaces are recognized by the content.
inline const Words input_formats = {".off", ".obj", ".ply", ".stl", ".ts"};

/// Output formats that are recognized by the file name extension. STL is not one of them: it repeats vertices and loses their order.
inline const Words output_formats = {".off", ".obj", ".ply", ".ts", ".gii", ".gii.gz"};

/// Features that are computed from a surface: measures of its sulci and gyri.
inline const Words own_feature_names = {"depth", "height", "curvature", "inflated"};

/// The format of FreeSurfer, for files such as `lh.sphere`.
inline const std::string freesurfer_format = "freesurfer";

/// returns whether a format is GIFTI, optionally compressed by gzip.
bool is_gifti(const std::string& format);

/// returns whether a format is one of cortical surfaces, which store single precision coordinates.
bool is_cortical(const std::string& format);

/// Descriptions of valid names of input and output meshes, for messages.
inline const std::string input_names =
    ".off, .obj, .ply, .stl, .ts, .gii or .gii.gz, or the file must be a FreeSurfer surface";
inline const std::string output_names =
    ".off, .obj, .ply, .ts, .gii or .gii.gz, or begins with lh. or rh. for the format of FreeSurfer";

/// returns the file name extension in lower case, with the dot, and with `.gii` before `.gz`.
std::string file_format(const std::string& path);

/// returns the hemisphere in the notation of GIFTI, `CortexLeft` or `CortexRight`, for a file name that begins with `lh.` or `rh.`; empty for
/// others.
std::string structure_of(const std::string& path);

/// returns the format of a mesh that is written to this file; empty if it does not follow from the name.
std::string output_format(const std::string& path);

/// returns the format of vertex values or labels that are written to this file; empty if it does not follow from the name.
std::string format_of_values(const std::string& path);

/// returns the part of the name that describes the content: the extension; for GIFTI files with a part such as `.surf` before it; empty
/// for FreeSurfer files.
std::string ending_of(const std::string& path);

/// returns the name with a suffix inserted before its ending.
std::string with_suffix(const std::string& path, const std::string& suffix);

/// The names of all files of a mesh.
struct File_names
{
  std::string input;
  std::string sphere, handles, repaired, remesh, values, image, texture, page, json; ///< empty if not requested
  std::string onto, target_sphere, overlay, morph,
      expected_errors; ///< of a map onto another surface, empty if not requested
  std::string colored; ///< prefix of the names of the colored meshes; empty if not requested

  /// returns the names of all output files, in the order in which they appear, including derived names.
  Words outputs() const;

  std::string image_of_normals() const;
  std::string colored_surface() const { return colored.empty() ? "" : colored + "_surface.ply"; }
  std::string colored_sphere() const { return colored.empty() ? "" : colored + "_sphere.ply"; }

  /// returns the names for a part of a surface: its number, from 1, is inserted in the names of output files.
  File_names of_part(std::size_t part) const;
};

/// returns the absolute path with dots and links resolved. Unlike `weakly_canonical()`, it also resolves dangling links, and relative
/// paths that begin with a missing component.
std::filesystem::path resolved(std::filesystem::path path, std::error_code& error);

/// File names, each with its hemisphere: `left`, `right`, or empty if unknown.
using Hemispheres = std::vector<std::pair<std::string, std::string>>;

/// returns the hemisphere of a file according to its metadata or, without those, to its name by the conventions of FreeSurfer, BIDS or
/// the Human Connectome Project; both, if they disagree.
Hemispheres hemispheres_of(const std::string& path, const SP::IO::Surface_origin& origin);

/// adds the hemisphere to the metadata of a surface if it follows from the name and is missing: programs for cortical surfaces
/// require it.
void add_structure(SP::IO::Metadata& metadata, const std::string& path);

/// returns a warning, one line, if files that are used together belong to different hemispheres; empty otherwise.
std::string mixed_hemispheres(const Hemispheres& files);

} // namespace Program

#endif // PROGRAM_FILE_NAMES_H
