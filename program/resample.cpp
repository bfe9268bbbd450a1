#include "Input_mesh.h"
#include "commands.h"
#include "output_files.h"
#include "read_file.h"
#include "write_mesh.h"
#include "write_sphere.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_resampler_3.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

namespace Program {

namespace {

// Makes the folder of the outputs, if there is one, and returns their names.
Words names_of_outputs(const Options& options)
{
  const std::filesystem::path folder = options.output_folder;
  std::error_code error;
  if(options.is_batch() && !std::filesystem::create_directories(folder, error) && error)
    throw error_in(options.output_folder, "cannot be made: " + error.message());
  Words names;
  for(const std::string& input : options.inputs)
    names.push_back(options.is_batch() ? (folder / std::filesystem::path(input).filename()).string()
                                       : options.file_names.sphere);
  if(!options.valid_file.empty())
    names.push_back(options.valid_file);
  return names;
}

Words inputs_of(const Options& options)
{
  Words inputs = options.other_inputs();
  inputs.insert(inputs.end(), options.inputs.begin(), options.inputs.end());
  return inputs;
}

// Carries what the vertices of a sphere have to those of another one: columns of values, labels, or points.
class Resampling_run
{
public:
  explicit Resampling_run(const Options& options)
    : m_options(options)
    , m_names(names_of_outputs(options))
    , m_outputs(m_names, inputs_of(options), Output_policy::follow)
  {}

  // reads all files, resamples and writes. The files appear once all of them are complete. Returns the exit status.
  int run()
  {
    const std::string& from_name = m_options.spheres[0];
    const SP::IO::Surface_file from = read_sphere(from_name);
    if(m_options.carries_sphere)
      return carry_spheres(from);
    const std::string& to_name = m_options.spheres[1];
    const SP::IO::Surface_file to = read_sphere(to_name);
    m_resampler.method(m_options.method == "nearest"    ? SP::Resampling_method::nearest
                       : m_options.method == "largest"  ? SP::Resampling_method::largest
                       : m_options.method == "adaptive" ? SP::Resampling_method::adaptive
                                                        : SP::Resampling_method::barycentric);
    if(!m_options.area_files.empty())
    {
      std::vector<double> areas = read_areas(m_options.area_files[0], from.points.size(), from_name);
      m_resampler.areas(std::move(areas), read_areas(m_options.area_files[1], to.points.size(), to_name));
    }
    if(!m_options.mask_file.empty())
      m_resampler.mask(read_mask(m_options.mask_file, from.points.size(), from_name));
    std::vector<SP::IO::Surface_file> files;
    for(const std::string& name : m_options.inputs)
    {
      files.push_back(read_arrays(name));
      check_content(name, files.back(), from.points.size());
      check_output(m_names[files.size() - 1], files.back());
    }
    connect(from, from_name, to, to_name);
    for(std::size_t k = 0; k < files.size(); ++k)
    {
      resample(files[k], m_options.inputs[k], to);
      write(m_names[k], files[k], to.triangles.size());
    }
    const std::vector<bool> has_value = m_resampler.has_value();
    const auto n_valid = static_cast<std::size_t>(std::count(has_value.begin(), has_value.end(), true));
    if(!m_options.valid_file.empty())
    {
      SP::IO::Surface_file file;
      add_structure(file, m_options.inputs[0], to);
      file.columns.push_back({"valid", "NIFTI_INTENT_SHAPE", SP::IO::Vertex_values::Type::float32, {}, {}});
      file.columns[0].values.assign(has_value.begin(), has_value.end());
      check_output(m_names.back(), file);
      write(m_names.back(), file, to.triangles.size());
    }
    commit();
    if(!m_options.is_quiet)
      std::cout << "resampled by " << m_options.method << " weights: " << from.points.size() << " to "
                << to.points.size() << " vertices, of which " << to.points.size() - n_valid << " get nothing\n";
    return EXIT_SUCCESS;
  }

private:
  using Resampler = SP::Sphere_resampler_3<>;
  using Type = SP::IO::Vertex_values::Type;

  void add(const Hemispheres& files) { m_hemispheres.insert(m_hemispheres.end(), files.begin(), files.end()); }

  // Reads a surface, or values, as they are in a file.
  SP::IO::Surface_file read_arrays(const std::string& path)
  {
    if(!is_among(file_format(path), input_formats))
    {
      const Surface_file_kind kind = read_named(path, [&] { return kind_of_file(path); });
      if(kind == Surface_file_kind::none)
        throw error_in(path, "is neither a mesh nor a file with values of vertices");
      SP::IO::Surface_file file = read_named(path, [&] {
        std::string message;
        return read_surface_file(kind, path, message);
      });
      add(hemispheres_of(path, file.origin));
      return file;
    }
    const File_content content = read_file_content(path);
    add(content.hemispheres);
    for(const Polygon& polygon : content.polygons)
      if(polygon.size() != 3)
        throw error_in(path, SP::get_error_message(SP::ERROR_NON_TRIANGULAR_MESH));
    return surface_file_of(content.points, content.polygons);
  }

  SP::IO::Surface_file read_sphere(const std::string& name)
  {
    SP::IO::Surface_file file = read_arrays(name);
    if(file.points.empty())
      throw error_in(name, "has values of vertices, but no surface: a sphere is needed");
    return file;
  }

  static void check_number(const std::string& name, std::size_t n, const std::string& sphere, std::size_t n_of_sphere)
  {
    if(n != n_of_sphere)
      throw error_in(name, "is of " + std::to_string(n) + " vertices, but " + printable(sphere) + " has " +
                               std::to_string(n_of_sphere));
  }

  // checks that a file has what can be carried over
  void check_content(const std::string& name, const SP::IO::Surface_file& file, std::size_t n) const
  {
    if(!file.vertices.empty())
      throw error_in(name, "has values of some vertices of a surface, not of all");
    if(file.points.empty() && file.columns.empty())
      throw error_in(name, "has nothing that vertices have");
    if(!file.points.empty() && !m_options.mask_file.empty())
      throw error_in(name, "is a surface, all of whose vertices have a point: leave out --mask");
    check_number(name, file.points.empty() ? file.columns[0].values.size() : file.points.size(), m_options.spheres[0],
                 n);
  }

  std::vector<double> read_areas(const std::string& name, std::size_t n, const std::string& sphere)
  {
    SP::IO::Surface_file file = read_arrays(name);
    for(const auto& t : file.triangles)
      if((std::max)({t[0], t[1], t[2]}) >= file.points.size())
        throw error_in(name, "has a triangle with a vertex that is none");
    const std::vector<double> areas = !file.points.empty()    ? Resampler::vertex_areas(file.points, file.triangles)
                                      : !file.columns.empty() ? file.columns[0].values
                                                              : std::vector<double>();
    check_number(name, areas.size(), sphere, n);
    for(std::size_t v = 0; v < n; ++v)
      if(!(areas[v] >= 0. && std::isfinite(areas[v])))
        throw error_in(name, "has an area that is negative or not finite, of vertex " + std::to_string(v) +
                                 ". (Vertices are counted from 0.)");
    return areas;
  }

  std::vector<bool> read_mask(const std::string& name, std::size_t n, const std::string& sphere)
  {
    const SP::IO::Surface_file file = read_arrays(name);
    std::vector<bool> mask(n, false);
    for(const std::uint32_t v : file.vertices)
    {
      if(v >= n)
        check_number(name, v + std::size_t(1), sphere, n);
      mask[v] = true;
    }
    if(!file.vertices.empty())
      return mask;
    if(file.columns.empty())
      throw error_in(name, "has no values of vertices, which a mask is told by");
    check_number(name, file.columns[0].values.size(), sphere, n);
    std::transform(file.columns[0].values.begin(), file.columns[0].values.end(), mask.begin(),
                   [](double x) { return x > 0.; });
    return mask;
  }

  void connect(const SP::IO::Surface_file& from, const std::string& from_name, const SP::IO::Surface_file& to,
               const std::string& to_name)
  {
    const SP::Error_code error = m_resampler.connect(from.points, from.triangles, to.points, to.triangles);
    if(error == SP::OK)
      return;
    check_sphere(from_name, from);
    check_sphere(to_name, to);
    throw error_in(from_name, SP::get_error_message(error));
  }

  static bool is_one_to_one(Input_mesh& mesh) { return SP::is_bijective(mesh.mesh(), mesh.mesh().points()); }

  static Input_mesh mesh_of(const std::string& name, const SP::IO::Surface_file& file)
  {
    return Input_mesh(name, content_of(file));
  }

  // tells what is wrong with a sphere, if anything is
  static void check_sphere(const std::string& name, const SP::IO::Surface_file& sphere)
  {
    Input_mesh mesh = mesh_of(name, sphere);
    const std::string defect = mesh.find_defect();
    if(!defect.empty())
      throw Program_error(defect);
    if(!is_one_to_one(mesh))
      throw error_in(name, no_sphere);
  }

  // Replaces what the vertices of the first sphere have by what those of the second one get.
  void resample(SP::IO::Surface_file& file, const std::string& name, const SP::IO::Surface_file& to) const
  {
    const auto carry = [&](const auto& values, auto& result) {
      if(const SP::Error_code error = m_resampler.resample(values, result))
        throw error_in(name, SP::get_error_message(error));
    };
    for(SP::IO::Vertex_values& column : file.columns)
      if(column.type == Type::float32)
        carry(column.values, column.values);
      else
      {
        std::vector<std::int32_t> labels(column.values.begin(), column.values.end());
        carry(labels, labels);
        column.values.assign(labels.begin(), labels.end());
      }
    if(!file.points.empty())
    {
      carry(file.points, file.points);
      file.triangles = to.triangles;
      file.origin = inherited(std::move(file.origin), false);
      return;
    }
    const auto is_of_nothing = [](const SP::IO::Label& label) { return label.key == 0; };
    if(!file.labels.empty() && std::none_of(file.labels.begin(), file.labels.end(), is_of_nothing))
      file.labels.push_back({0, "", {{0., 0., 0., 0.}}}); // which what gets nothing has
    add_structure(file, name, to);
    if(file.columns.size() == 1 && file.columns[0].name.empty())
      file.columns[0].name = name_of_values(name);
  }

  // says in the metadata which half of the brain values are of
  static void add_structure(SP::IO::Surface_file& file, const std::string& name, const SP::IO::Surface_file& sphere)
  {
    const std::string key = "AnatomicalStructurePrimary", file_name = std::filesystem::path(name).filename().string();
    const auto is_structure = [&](const auto& pair) { return pair.first == key; };
    SP::IO::Metadata& metadata = file.origin.metadata;
    const auto& known = sphere.origin.metadata_of_points;
    const auto found = std::find_if(known.begin(), known.end(), is_structure);
    if(std::any_of(metadata.begin(), metadata.end(), is_structure))
      return;
    if(found != known.end())
      metadata.push_back(*found);
    else if(has_hemisphere(file_name))
      metadata.emplace_back(key, file_name[0] == 'l' ? "CortexLeft" : "CortexRight");
  }

  // Carries spheres through the registration of the first sphere.
  int carry_spheres(const SP::IO::Surface_file& from)
  {
    const std::string& registered_name = m_options.spheres[1];
    const SP::IO::Surface_file registered = read_sphere(registered_name);
    check_number(registered_name, registered.points.size(), m_options.spheres[0], from.points.size());
    if(registered.triangles != from.triangles)
      throw error_in(registered_name, "has other faces than " + printable(m_options.spheres[0]));
    int status = EXIT_SUCCESS;
    for(std::size_t k = 0; k < m_options.inputs.size(); ++k)
    {
      const std::string& name = m_options.inputs[k];
      SP::IO::Surface_file file = read_sphere(name);
      check_output(m_names[k], file);
      connect(from, m_options.spheres[0], file, name);
      const SP::Error_code error = m_resampler.resample_sphere(registered.points, file.points);
      if(error != SP::OK && error != SP::ERROR_NO_1_TO_1_MAPPING)
        throw error_in(name, SP::get_error_message(error));
      Input_mesh mesh = mesh_of(name, file);
      auto points = mesh.mesh().points();
      bool is_sphere = is_one_to_one(mesh);
      if(is_sphere && is_cortical(output_format(m_names[k])))
      {
        is_sphere = SP::round_to_float(mesh.mesh(), points, points) == SP::OK;
        for(const Vertex_index v : mesh.mesh().vertices())
          file.points[v] = {{points[v].x(), points[v].y(), points[v].z()}};
      }
      if(!is_sphere)
      {
        std::cerr << "spherical_parameterization: " << printable(m_names[k]) << ": folds, as faces of "
                  << printable(name) << " are too large for the registration, or that folds itself\n";
        status = exit_status_folded;
      }
      file.origin = inherited(std::move(file.origin), true);
      write(m_names[k], file, file.triangles.size());
    }
    commit();
    if(!m_options.is_quiet)
      std::cout << "carried through the registration: " << m_options.inputs.size()
                << (m_options.inputs.size() == 1 ? " sphere\n" : " spheres\n");
    return status;
  }

  // refuses the name of a file that cannot hold what is to be written
  static void check_output(const std::string& name, const SP::IO::Surface_file& file)
  {
    if(!file.points.empty() && output_format(name).empty())
      throw error_in(name, "has to be a name that ends with one of " + output_names + ", as a surface is written");
    if(file.points.empty() && format_of_values(name).empty())
      throw error_in(name, "has to be a name that ends with .gii, .mgh, .mgz or .annot, or begins with lh. or rh. "
                           "for the format of FreeSurfer, as values are written");
    if(file.points.empty() && format_of_values(name) == freesurfer_format && file.columns.size() > 1)
      throw error_in(name, "cannot hold " + std::to_string(file.columns.size()) +
                               " columns: choose a name that ends with .gii or .mgh");
    if(format_of_values(name) == ".annot" && file.labels.empty())
      throw error_in(name, "cannot hold values without a table of labels: choose another format");
  }

  static std::string format_of_values(const std::string& name)
  {
    const std::string format = file_format(name);
    if(is_among(format, {".gii", ".gii.gz", ".mgh", ".mgz", ".annot"}))
      return format;
    return has_hemisphere(std::filesystem::path(name).filename().string()) && !is_among(format, output_formats)
               ? freesurfer_format
               : "";
  }

  void write(const std::string& name, const SP::IO::Surface_file& file, std::size_t n_triangles)
  {
    const std::string format = output_format(name);
    m_outputs.write(name, [&](std::ostream& out) {
      if(file.points.empty())
        write_surface_file(out, format_of_values(name), file, n_triangles);
      else if(is_cortical(format))
        write_surface_file(out, format, file);
      else
      {
        const File_content content = content_of(file);
        write_mesh(out, format, content.points, content.polygons, file.origin);
      }
    });
  }

  void commit()
  {
    if(const std::string warning = mixed_hemispheres(m_hemispheres); !warning.empty())
      std::cerr << warning << std::flush;
    m_outputs.commit();
  }

  const Options& m_options;
  Words m_names; // of the inputs, and of the vertices that get something
  Output_files m_outputs;
  Resampler m_resampler;
  Hemispheres m_hemispheres; // of all that is read
};

} // namespace

int run_resample(const Options& options)
{
  return Resampling_run(options).run();
}

} // namespace Program
