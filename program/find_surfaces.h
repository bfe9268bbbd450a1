#ifndef PROGRAM_FIND_SURFACES_H
#define PROGRAM_FIND_SURFACES_H

#include "text.h"

#include <filesystem>
#include <string>
#include <vector>

namespace Program {

/// returns the path behind links and dots, as far as it can be told.
std::filesystem::path true_place(const std::filesystem::path& path);

/// returns whether a file, or a folder that leads to one, is called as a pattern of the shell says: by its name, or, if the pattern
/// has a slash, by its path.
bool matches(const std::string& pattern, const std::filesystem::path& path, bool is_folder);

/// The surfaces of a study: files in the folders below one, such as those of the subjects of FreeSurfer, which have the same names.
struct Found_surfaces
{
  std::vector<std::filesystem::path> paths;          ///< of the surfaces within the folder, sorted
  std::vector<std::filesystem::path> links_left_out; ///< to other folders
};

/// finds the files that match a pattern, each by its path within the folder; the files of values among them are left out.
///
/// \param results where the results go; what is there is none of the surfaces, unless it is the folder itself. Then links to other
///        folders are left out, as results would be written through them.
///
/// \throws Program_error if a folder cannot be read, or there are no such files
Found_surfaces find_surfaces(const std::filesystem::path& folder, const Words& patterns,
                             const std::filesystem::path& results);

/// returns whose surface this is: the name of the last folder that begins with `sub-`, with the session if there is one, or that
/// has a folder `surf`; or else the first one in the folder of the study, or that itself.
///
/// \param study absolute
/// \param path of the file, within the study
std::string subject_of(const std::filesystem::path& study, const std::filesystem::path& path);

/// returns what the sphere of a surface is called: `lh.sphere` for `lh.white`, `sub-1_hemi-L_sphere.surf.gii` for
/// `sub-1_hemi-L_white.surf.gii`, and `NAME_sphere` for names that do not tell which surface it is.
std::string name_of_sphere(const std::string& name);

} // namespace Program

#endif // PROGRAM_FIND_SURFACES_H
