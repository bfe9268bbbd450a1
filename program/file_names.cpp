#include "file_names.h"

#include <algorithm>

namespace Program {

bool is_gifti(const std::string& format)
{
  return format == ".gii" || format == ".gii.gz";
}

bool is_cortical(const std::string& format)
{
  return is_gifti(format) || format == freesurfer_format;
}

std::string file_format(const std::string& path)
{
  const std::filesystem::path name = path_of(path);
  const std::string extension = SP::internal::lower_case(name_of(name.extension()));
  return extension == ".gz" && file_format(name_of(name.stem())) == ".gii" ? ".gii.gz" : extension;
}

std::string structure_of(const std::string& path)
{
  const std::string begin = name_of(path_of(path).filename()).substr(0, 3);
  return begin == "lh." ? "CortexLeft" : begin == "rh." ? "CortexRight" : "";
}

std::string output_format(const std::string& path)
{
  const std::string format = file_format(path);
  if(is_among(format, output_formats))
    return format;
  return structure_of(path).empty() ? "" : freesurfer_format;
}

std::string format_of_values(const std::string& path)
{
  const std::string format = file_format(path);
  if(is_among(format, {".gii", ".gii.gz", ".mgh", ".mgz", ".annot"}))
    return format;
  return output_format(path) == freesurfer_format ? freesurfer_format : "";
}

std::string ending_of(const std::string& path)
{
  const std::string format = file_format(path);
  if(output_format(path) == freesurfer_format && !is_among(format, {".json", ".html", ".png", ".exr", ".stl"}))
    return "";
  const std::string beginning = path.substr(0, path.size() - format.size()),
                    before = name_of(path_of(beginning).extension());
  const bool is_double = is_gifti(format) && is_among(before, {".surf", ".shape", ".func", ".label"});
  return (is_double ? before : "") + path.substr(beginning.size());
}

std::string with_suffix(const std::string& path, const std::string& suffix)
{
  const std::string ending = ending_of(path);
  return path.substr(0, path.size() - ending.size()) + suffix + ending;
}

std::string File_names::image_of_normals() const
{
  const std::filesystem::path path = path_of(image);
  return image.empty() ? "" : name_of(path.parent_path() / path.stem()) + "_normals" + name_of(path.extension());
}

Words File_names::outputs() const
{
  return {sphere,
          handles,
          repaired,
          remesh,
          values,
          image,
          image_of_normals(),
          texture,
          colored_surface(),
          colored_sphere(),
          onto,
          target_sphere,
          overlay,
          morph,
          expected_errors,
          page,
          json};
}

File_names File_names::of_part(std::size_t part) const
{
  const std::string number = "_" + std::to_string(part + 1);
  File_names result = *this;
  for(std::string* name : {&result.sphere, &result.handles, &result.repaired, &result.remesh, &result.values,
                           &result.image, &result.texture, &result.page, &result.json, &result.onto,
                           &result.target_sphere, &result.overlay, &result.morph, &result.expected_errors})
    if(!name->empty())
      *name = with_suffix(*name, number);
  if(!result.colored.empty())
    result.colored += number;
  return result;
}

std::filesystem::path resolved(std::filesystem::path path, std::error_code& error)
{
  namespace fs = std::filesystem;
  constexpr int max_links = 40; // the limit of the system
  for(int k = 0; k < max_links && fs::is_symlink(fs::symlink_status(path, error)); ++k)
    path = path.parent_path() / fs::read_symlink(path, error);
  error.clear();
  path = fs::absolute(path, error);
  return error ? path : fs::weakly_canonical(path, error);
}

Hemispheres hemispheres_of(const std::string& path, const SP::IO::Surface_origin& origin)
{
  std::string by_metadata, by_name;
  for(const auto* metadata : {&origin.metadata, &origin.metadata_of_points})
    for(const auto& [name, value] : *metadata)
      if(name == "AnatomicalStructurePrimary")
        for(const char* side : {"Left", "Right"})
          if(value.find(side) != value.npos)
            by_metadata = side[0] == 'L' ? "left" : "right";
  const std::string name = '.' + name_of(path_of(path).filename());
  for(const auto& [left, right] :
      {std::pair(".lh.", ".rh."), std::pair("_hemi-L_", "_hemi-R_"), std::pair(".L.", ".R.")})
    if(by_name.empty())
      by_name = name.find(left) != name.npos ? "left" : name.find(right) != name.npos ? "right" : "";
  if(!by_metadata.empty() && !by_name.empty() && by_metadata != by_name)
    return {{path + " (metadata)", by_metadata}, {path + " (name)", by_name}};
  return {{path, by_metadata.empty() ? by_name : by_metadata}};
}

void add_structure(SP::IO::Metadata& metadata, const std::string& path)
{
  SP::IO::Surface_origin origin;
  origin.metadata = metadata;
  const auto is_known = [](const auto& pair) { return pair.first == "AnatomicalStructurePrimary"; };
  const std::string half = hemispheres_of(path, origin).front().second;
  if(!half.empty() && std::none_of(metadata.begin(), metadata.end(), is_known))
    metadata.emplace_back("AnatomicalStructurePrimary", half == "left" ? "CortexLeft" : "CortexRight");
}

std::string mixed_hemispheres(const Hemispheres& files)
{
  const std::pair<std::string, std::string>* first = nullptr;
  for(const auto& file : files)
    if(!file.second.empty())
    {
      if(first == nullptr)
        first = &file;
      else if(first->second != file.second)
        return printable(first->first) + " belongs to the " + first->second + " hemisphere, but " +
               printable(file.first) + " to the " + file.second + " one\n";
    }
  return "";
}

} // namespace Program
