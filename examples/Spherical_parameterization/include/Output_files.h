#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILES_H

#include "Output_file.h"
#include "Program_error.h"
#include "mesh_files.h"

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace Program {

/// checks that no output would replace an input or another output.
///
/// \throws Program_error otherwise
inline void check_names(const std::vector<Output_file*>& outputs, const Words& inputs)
{
  std::error_code ignored;
  for(auto file = outputs.begin(); file != outputs.end(); ++file)
  {
    for(const std::string& input : inputs)
      if(!std::filesystem::is_symlink((*file)->path(), ignored) &&
         std::filesystem::equivalent((*file)->path(), input, ignored))
        throw Program_error((*file)->name(), "would replace the input; choose another name");
    for(auto other = outputs.begin(); other != file; ++other)
      if((*file)->path() == (*other)->path())
        throw Program_error((*file)->name(), "would be written twice; choose another name");
  }
}

/// All files that a run is to write. They appear together, once all of them are complete.
class Output_files
{
public:
  /// checks that all of them can be written, and that none of them would replace an input or another output.
  ///
  /// \throws Program_error otherwise
  ///
  /// \param other_inputs other files that are read
  Output_files(const File_names& names, const Words& other_inputs, Output_file::Policy policy)
  {
    const auto add = [&](std::optional<Output_file>& file, const std::string& name) {
      m_wanted.push_back(&file.emplace(name, policy));
    };
    if(!names.sphere.empty())
      add(sphere, names.sphere);
    if(!names.handles.empty())
      add(handles, names.handles);
    if(!names.filled.empty())
      add(filled, names.filled);
    if(!names.remesh.empty())
      add(remesh, names.remesh);
    if(!names.values.empty())
      add(values, names.values);
    if(!names.image.empty())
    {
      const std::filesystem::path path(names.image);
      add(image, names.image);
      add(image_of_normals, (path.parent_path() / path.stem()).string() + "_normals" + path.extension().string());
    }
    if(!names.colored.empty())
    {
      add(colored_surface, names.colored + "_surface.ply");
      add(colored_sphere, names.colored + "_sphere.ply");
    }
    if(!names.onto.empty())
      add(onto, names.onto);
    if(!names.target_sphere.empty())
      add(target_sphere, names.target_sphere);
    if(!names.overlay.empty())
      add(overlay, names.overlay);
    if(!names.morph.empty())
      add(morph, names.morph);
    if(!names.page.empty())
      add(page, names.page);
    if(!names.json.empty())
      add(json, names.json);

    Words inputs = other_inputs;
    inputs.push_back(names.input);
    check_names(m_wanted, inputs);
  }

  /// removes the files that have these names now, the report first: it is never beside the map of another run.
  ///
  /// \throws Program_error if that fails
  void remove_earlier()
  {
    for(auto file = m_wanted.rbegin(); file != m_wanted.rend(); ++file)
      (*file)->remove_earlier();
  }

  /// gives all files their names, once all of them are complete, the report last.
  void commit()
  {
    for(Output_file* file : m_wanted)
      file->commit();
  }

  Words names() const
  {
    Words result;
    for(const Output_file* file : m_wanted)
      result.push_back(file->name());
    return result;
  }

  std::optional<Output_file> sphere, handles, filled, remesh, values, image, image_of_normals, colored_surface,
      colored_sphere, onto, target_sphere, overlay, morph, page, json;

private:
  std::vector<Output_file*> m_wanted;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_OUTPUT_FILES_H
