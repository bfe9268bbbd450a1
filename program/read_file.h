#ifndef PROGRAM_READ_FILE_H
#define PROGRAM_READ_FILE_H

#include "File_content.h"
#include "text.h"

#include <functional>
#include <string>

namespace Program {

/// What a file of a cortical surface is. Many have no extension, so that their first bytes decide.
enum class Surface_file_kind
{
  none, ///< something else
  freesurfer_surface,
  freesurfer_curv,
  freesurfer_annotation,
  freesurfer_label,
  mgh,
  gifti
};

/// checks that a file can be opened.
///
/// \throws Program_error with its name, if it is no ordinary file, or cannot be read
void check_file(const std::string& path);

/// reads a file as a whole.
///
/// \throws Program_error if it is no ordinary file, or cannot be read
std::string read_file(const std::string& path);

/// tells the kind of a file of a cortical surface by its name and its first bytes.
///
/// \throws Program_error if it is no ordinary file, or cannot be read
Surface_file_kind kind_of_file(const std::string& path);

/// returns what a file is called without its folder, the hemisphere and the end that tells its format.
std::string name_of_values(const std::string& path);

/// reads a file of this kind.
///
/// \param message receives what is said of a file that is in order otherwise, empty if nothing is
///
/// \throws Program_error with what is wrong, and what helps
SP::IO::Surface_file read_surface_file(Surface_file_kind kind, const std::string& path, std::string& message);

/// reads a mesh file, whose format is that of its name, or told by its first bytes.
///
/// \param keeps_values whether values of vertices and faces are wanted; then the file may have no mesh
///
/// \throws Program_error with the name of the file, what is wrong with it, and what helps
File_content read_file_content(const std::string& path, bool keeps_values = false);

inline File_content read_file_of_values(const std::string& path)
{
  return read_file_content(path, true);
}

/// reads a file with values of vertices, or several, whose names have commas between them. The mesh is that of the first.
///
/// \param read reads one of them
///
/// \throws Program_error if that fails, or they are values of surfaces that differ in the number of their vertices
File_content read_values(const std::string& paths,
                         const std::function<File_content(const std::string&)>& read = read_file_of_values);

} // namespace Program

#endif // PROGRAM_READ_FILE_H
