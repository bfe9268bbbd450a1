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

/// The formats that are read and told by the end of the name. Those of cortical surfaces are told by what is in the file.
inline const Words input_formats = {".off", ".obj", ".ply", ".stl", ".ts"};

/// The formats that are written and told by the end of the name. An STL file is not among them: it repeats the vertices and
/// forgets their order.
inline const Words output_formats = {".off", ".obj", ".ply", ".ts", ".gii", ".gii.gz"};

/// What a surface can be compared by without a file: how it is folded.
inline const Words own_feature_names = {"depth", "height", "curvature", "inflated"};

/// The format of FreeSurfer, whose files are called `lh.sphere`, say.
inline const std::string freesurfer_format = "freesurfer";

/// returns whether a format is GIFTI, perhaps packed by gzip.
bool is_gifti(const std::string& format);

/// returns whether a format is one of cortical surfaces; the numbers of these have 32 bits.
bool is_cortical(const std::string& format);

/// What the names of meshes that are read, and written, have to be like.
inline const std::string input_names =
    ".off, .obj, .ply, .stl, .ts, .gii or .gii.gz, or the file has to be a surface of FreeSurfer";
inline const std::string output_names =
    ".off, .obj, .ply, .ts, .gii or .gii.gz, or begins with lh. or rh. for the format of FreeSurfer";

/// returns the end of a file's name in lower case, with the dot, and with `.gii` before `.gz`.
std::string file_format(const std::string& path);

/// returns `CortexLeft` or `CortexRight` for a file whose name begins with what FreeSurfer calls the half of the brain, as GIFTI has
/// it; empty for others.
std::string structure_of(const std::string& path);

/// returns the format that a mesh with this name is written in; empty if the name does not tell.
std::string output_format(const std::string& path);

/// returns the format that values of vertices with this name are written in, or labels; empty if it does not follow from the name.
std::string format_of_values(const std::string& path);

/// returns the end of a name that tells what is in the file: the extension; that and `.surf`, say, of a GIFTI file; nothing of a file
/// of FreeSurfer.
std::string ending_of(const std::string& path);

/// returns the name with something put before its end.
std::string with_suffix(const std::string& path, const std::string& suffix);

/// The names of all files of a mesh.
struct File_names
{
  std::string input;
  std::string sphere, handles, repaired, remesh, values, image, page, json; ///< empty if not wanted
  std::string onto, target_sphere, overlay, morph,
      expected_errors; ///< of a map onto another surface, empty if not wanted
  std::string colored; ///< what the names of the coloured meshes begin with, empty if they are not wanted

  /// returns the names of all files that are written, in the order in which they appear, with those that are made of others.
  Words outputs() const;

  std::string image_of_normals() const;
  std::string colored_surface() const { return colored.empty() ? "" : colored + "_surface.ply"; }
  std::string colored_sphere() const { return colored.empty() ? "" : colored + "_sphere.ply"; }

  /// returns the names for a part of a surface: all that are written get its number, from 1 on.
  File_names of_part(std::size_t part) const;
};

/// returns the absolute path behind dots and links, those that lead to nothing yet included, which `weakly_canonical()` takes as
/// they are; and so it does with paths that are not absolute, if they begin with what is not there.
std::filesystem::path place_of(std::filesystem::path path, std::error_code& error);

/// The names of files, each with the half of the brain that it is of: `left`, `right`, or nothing if that is not known.
using Hemispheres = std::vector<std::pair<std::string, std::string>>;

/// returns which half of the brain a file is of, as its metadata say, or else its name as FreeSurfer, BIDS or the Human Connectome
/// Project has it; or as both say, if they disagree.
Hemispheres hemispheres_of(const std::string& path, const SP::IO::Surface_origin& origin);

/// says in the metadata of a surface which half of the brain it is, if its name says so and the metadata do not: programs for cortical
/// surfaces ask for that.
void add_structure(SP::IO::Metadata& metadata, const std::string& path);

/// returns what is to be said of files that are used together, if they are of different halves of the brain: a line; empty otherwise.
std::string mixed_hemispheres(const Hemispheres& files);

} // namespace Program

#endif // PROGRAM_FILE_NAMES_H
