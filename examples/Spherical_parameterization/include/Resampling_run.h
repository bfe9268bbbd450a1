#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RESAMPLING_RUN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RESAMPLING_RUN_H

#include "Input_mesh.h"
#include "Output_file.h"
#include "Output_files.h"
#include "Program_error.h"
#include "Program_options.h"
#include "Run_report.h"
#include "mesh_files.h"
#include "read_soup.h"
#include "write_soup.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_resampler_3.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace Program {

/// Carries what the vertices of a sphere have to those of another one: columns of values, labels, or points.
class Resampling_run
{
public:
  /// \param options have to live longer
  ///
  /// \throws Program_error if a file cannot be written
  explicit Resampling_run(const Program_options& options)
    : m_options(options)
  {
    const std::filesystem::path folder = options.output_folder;
    std::error_code error;
    if(options.is_batch() && !std::filesystem::create_directories(folder, error) && error)
      throw Program_error(options.output_folder, "cannot be made: " + error.message());
    std::vector<Output_file*> wanted;
    const auto add = [&](const std::string& name) {
      wanted.push_back(m_outputs.emplace_back(std::make_unique<Output_file>(name, Output_file::Policy::follow)).get());
    };
    for(const std::string& input : options.inputs)
      add(options.is_batch() ? (folder / std::filesystem::path(input).filename()).string() : options.file_names.sphere);
    if(!options.valid_file.empty())
      add(options.valid_file);
    Words inputs = options.other_inputs();
    inputs.insert(inputs.end(), options.inputs.begin(), options.inputs.end());
    check_names(wanted, inputs);
  }

  /// reads all files, resamples and writes. The files appear once all of them are complete. Returns the exit status.
  ///
  /// \throws Program_error if a file is not in order, or cannot be written
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
      check_output(*m_outputs[files.size() - 1], files.back());
    }
    connect(from, from_name, to, to_name);
    for(std::size_t k = 0; k < files.size(); ++k)
    {
      resample(files[k], m_options.inputs[k], to);
      write(*m_outputs[k], files[k], to.triangles.size());
    }
    const std::vector<bool> has_value = m_resampler.has_value();
    const auto n_valid = static_cast<std::size_t>(std::count(has_value.begin(), has_value.end(), true));
    if(!m_options.valid_file.empty())
    {
      SP::IO::Surface_file file;
      add_structure(file, m_options.inputs[0], to);
      file.columns.push_back({"valid", "NIFTI_INTENT_SHAPE", SP::IO::Vertex_values::Type::float32, {}, {}});
      file.columns[0].values.assign(has_value.begin(), has_value.end());
      check_output(*m_outputs.back(), file);
      write(*m_outputs.back(), file, to.triangles.size());
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
        throw Program_error(path, "is neither a mesh nor a file with values of vertices");
      SP::IO::Surface_file file = read_named(path, [&] {
        std::ifstream in = open_file(path);
        std::string message;
        return read_surface_file(kind, in, message);
      });
      add(hemispheres_of(path, file.origin));
      return file;
    }
    const Polygon_soup soup = read_soup(path);
    add(soup.hemispheres);
    SP::IO::Surface_file file;
    for(const Point_3& p : soup.points)
      file.points.push_back({{p.x(), p.y(), p.z()}});
    for(const Polygon& polygon : soup.polygons)
    {
      if(polygon.size() != 3)
        throw Program_error(path, SP::get_error_message(SP::ERROR_NON_TRIANGULAR_MESH));
      file.triangles.emplace_back();
      std::transform(polygon.begin(), polygon.end(), file.triangles.back().begin(),
                     [](std::size_t v) { return static_cast<std::uint32_t>(v); });
    }
    return file;
  }

  SP::IO::Surface_file read_sphere(const std::string& name)
  {
    SP::IO::Surface_file file = read_arrays(name);
    if(file.points.empty())
      throw Program_error(name, "has values of vertices, but no surface: a sphere is needed");
    return file;
  }

  static void check_number(const std::string& name, std::size_t n, const std::string& sphere, std::size_t n_of_sphere)
  {
    if(n != n_of_sphere)
      throw Program_error(name, "is of " + std::to_string(n) + " vertices, but " + printable(sphere) + " has " +
                                    std::to_string(n_of_sphere));
  }

  // checks that a file has what can be carried over
  void check_content(const std::string& name, const SP::IO::Surface_file& file, std::size_t n) const
  {
    if(!file.vertices.empty())
      throw Program_error(name, "has values of some vertices of a surface, not of all");
    if(file.points.empty() && file.columns.empty())
      throw Program_error(name, "has nothing that vertices have");
    if(!file.points.empty() && !m_options.mask_file.empty())
      throw Program_error(name, "is a surface, all of whose vertices have a point: leave out --mask");
    check_number(name, file.points.empty() ? file.columns[0].values.size() : file.points.size(), m_options.spheres[0],
                 n);
  }

  std::vector<double> read_areas(const std::string& name, std::size_t n, const std::string& sphere)
  {
    SP::IO::Surface_file file = read_arrays(name);
    for(const auto& t : file.triangles)
      if((std::max)({t[0], t[1], t[2]}) >= file.points.size())
        throw Program_error(name, "has a triangle with a vertex that is none");
    const std::vector<double> areas = !file.points.empty()    ? Resampler::vertex_areas(file.points, file.triangles)
                                      : !file.columns.empty() ? file.columns[0].values
                                                              : std::vector<double>();
    check_number(name, areas.size(), sphere, n);
    for(std::size_t v = 0; v < n; ++v)
      if(!(areas[v] >= 0. && std::isfinite(areas[v])))
        throw Program_error(name, "has an area that is negative or not finite, of vertex " + std::to_string(v) +
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
      throw Program_error(name, "has no values of vertices, which a mask is told by");
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
    throw Program_error(from_name, SP::get_error_message(error));
  }

  static bool is_one_to_one(Input_mesh& mesh) { return SP::is_bijective(mesh.mesh(), mesh.mesh().points()); }

  static Input_mesh mesh_of(const std::string& name, const SP::IO::Surface_file& file)
  {
    Polygon_soup soup;
    for(const auto& p : file.points)
      soup.points.emplace_back(p[0], p[1], p[2]);
    for(const auto& t : file.triangles)
      soup.polygons.emplace_back(t.begin(), t.end());
    return Input_mesh(name, std::move(soup));
  }

  // tells what is wrong with a sphere, if anything is
  static void check_sphere(const std::string& name, const SP::IO::Surface_file& sphere)
  {
    Input_mesh mesh = mesh_of(name, sphere);
    const std::string defect = mesh.find_defect();
    if(!defect.empty())
      throw Program_error(defect);
    if(!is_one_to_one(mesh))
      throw Program_error(name, no_sphere);
  }

  // Replaces what the vertices of the first sphere have by what those of the second one get.
  void resample(SP::IO::Surface_file& file, const std::string& name, const SP::IO::Surface_file& to) const
  {
    const auto carry = [&](const auto& values, auto& result) {
      if(const SP::Error_code error = m_resampler.resample(values, result))
        throw Program_error(name, SP::get_error_message(error));
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
      throw Program_error(registered_name, "has other faces than " + printable(m_options.spheres[0]));
    int status = EXIT_SUCCESS;
    for(std::size_t k = 0; k < m_options.inputs.size(); ++k)
    {
      const std::string& name = m_options.inputs[k];
      SP::IO::Surface_file file = read_sphere(name);
      check_output(*m_outputs[k], file);
      connect(from, m_options.spheres[0], file, name);
      const SP::Error_code error = m_resampler.resample_sphere(registered.points, file.points);
      if(error != SP::OK && error != SP::ERROR_NO_1_TO_1_MAPPING)
        throw Program_error(name, SP::get_error_message(error));
      Input_mesh mesh = mesh_of(name, file);
      auto points = mesh.mesh().points();
      bool is_sphere = is_one_to_one(mesh);
      if(is_sphere && is_cortical(output_format(m_outputs[k]->name())))
      {
        is_sphere = SP::round_to_float(mesh.mesh(), points, points) == SP::OK;
        for(const Vertex_index v : mesh.mesh().vertices())
          file.points[v] = {{points[v].x(), points[v].y(), points[v].z()}};
      }
      if(!is_sphere)
      {
        std::cerr << "spherical_parameterization: " << printable(m_outputs[k]->name()) << ": folds, as faces of "
                  << printable(name) << " are too large for the registration, or that folds itself\n";
        status = Run_report::exit_status_folded;
      }
      file.origin = inherited(std::move(file.origin), true);
      write(*m_outputs[k], file, file.triangles.size());
    }
    commit();
    if(!m_options.is_quiet)
      std::cout << "carried through the registration: " << m_options.inputs.size()
                << (m_options.inputs.size() == 1 ? " sphere\n" : " spheres\n");
    return status;
  }

  // refuses the name of a file that cannot hold what is to be written
  static void check_output(const Output_file& output, const SP::IO::Surface_file& file)
  {
    const std::string& name = output.name();
    if(!file.points.empty() && output_format(name).empty())
      throw Program_error(name, "has to be a name that ends with one of " + output_names + ", as a surface is written");
    if(file.points.empty() && format_of_values(name).empty())
      throw Program_error(name, "has to be a name that ends with .gii, .mgh, .mgz or .annot, or begins with lh. or rh. "
                                "for the format of FreeSurfer, as values are written");
    if(file.points.empty() && format_of_values(name) == freesurfer_format && file.columns.size() > 1)
      throw Program_error(name, "cannot hold " + std::to_string(file.columns.size()) +
                                    " columns: choose a name that ends with .gii or .mgh");
    if(format_of_values(name) == ".annot" && file.labels.empty())
      throw Program_error(name, "cannot hold values without a table of labels: choose another format");
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

  static void write(Output_file& output, const SP::IO::Surface_file& file, std::size_t n_triangles)
  {
    const std::string format = output_format(output.name());
    output.write([&](std::ostream& out) {
      if(file.points.empty())
        write_surface_file(out, format_of_values(output.name()), file, n_triangles);
      else if(is_cortical(format))
        write_surface_file(out, format, file);
      else
      {
        std::vector<Point_3> points;
        for(const auto& p : file.points)
          points.emplace_back(p[0], p[1], p[2]);
        std::vector<Polygon> polygons;
        for(const auto& t : file.triangles)
          polygons.emplace_back(t.begin(), t.end());
        write_soup(out, format, points, polygons, file.origin);
      }
    });
  }

  void commit()
  {
    if(const std::string warning = mixed_hemispheres(m_hemispheres); !warning.empty())
      std::cerr << warning << std::flush;
    for(const auto& output : m_outputs)
      output->commit();
  }

  const Program_options& m_options;
  std::vector<std::unique_ptr<Output_file>> m_outputs; // of the inputs, and of the vertices that get something
  Resampler m_resampler;
  Hemispheres m_hemispheres; // of all that is read
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_RESAMPLING_RUN_H
