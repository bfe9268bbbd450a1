#include "Options.h"
#include "output_files.h"
#include "write_mesh.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_resampler_3.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

namespace Program {

namespace {

using SP::IO::Surface_file;

// Creates the output folder, if there is one, and returns the names of the outputs: for all inputs, and of --valid.
Words names_of_outputs(const Options& options)
{
  const std::filesystem::path folder = path_of(options.text("output-folder"));
  std::error_code error;
  if(options.is_batch() && !std::filesystem::create_directories(folder, error) && error)
    throw error_in(options.text("output-folder"), "cannot be created: ", error.message());
  Words names;
  for(const std::string& input : options.inputs)
    names.push_back(options.is_batch() ? name_of(folder / path_of(input).filename()) : options.file_names.sphere);
  names.push_back(options.text("valid"));
  return names;
}

Words all_inputs_of(const Options& options)
{
  Words inputs = options.other_inputs();
  inputs.insert(inputs.end(), options.inputs.begin(), options.inputs.end());
  return inputs;
}

// Checks that the format of an output file can store the data.
void check_holds(const std::string& name, const Surface_file& file)
{
  const std::string format = format_of_values(name);
  if(!file.points.empty() && output_format(name).empty())
    throw error_in(name, "the name of a surface file must end with ", output_names);
  if(file.points.empty() && format.empty())
    throw error_in(name,
                   "the name of a file of values must end with .gii, .mgh, .mgz or .annot, or begin with lh. or rh. "
                   "for the format of FreeSurfer");
  if(file.points.empty() && format == freesurfer_format && file.columns.size() > 1)
    throw error_in(name, "cannot store ", file.columns.size(), " columns; choose a name that ends with .gii or .mgh");
  if(!file.points.empty() && !file.columns.empty() && !is_gifti(output_format(name)))
    throw error_in(name, "cannot store the values of the surface; choose a name that ends with .gii");
  if(format == ".annot" && file.columns.size() > 1)
    throw error_in(name, "cannot store ", file.columns.size(), " columns; choose a name that ends with .gii");
  if(format == ".annot" && file.labels.empty())
    throw error_in(name, "cannot store values without a table of labels; choose another format");
}

void check_number(const std::string& name, std::size_t n, const std::string& sphere, std::size_t n_of_sphere)
{
  if(n != n_of_sphere)
    throw error_in(name, "has ", n, " vertices, but ", printable(sphere), " has ", n_of_sphere);
}

bool is_bijective(Input_mesh& mesh)
{
  return SP::is_bijective(mesh.mesh(), mesh.mesh().points());
}

// Adds the hemisphere to the metadata of values or points, from the metadata of the sphere or the file name.
void inherit_structure(SP::IO::Metadata& metadata, const std::string& name, const Surface_file& sphere)
{
  const auto is_structure = [](const auto& pair) { return pair.first == "AnatomicalStructurePrimary"; };
  const auto& known = sphere.origin.metadata_of_points;
  const auto found = std::find_if(known.begin(), known.end(), is_structure);
  if(std::any_of(metadata.begin(), metadata.end(), is_structure))
    return;
  if(found != known.end())
    metadata.push_back(*found);
  else
    add_structure(metadata, name);
}

// Transfers data of the vertices of a sphere to those of another one: columns of values, labels, or points; or applies a registration to
// spheres.
class Resampling_run
{
public:
  explicit Resampling_run(const Options& options)
    : m_options(options)
    , m_names(names_of_outputs(options))
    , m_outputs(m_names, all_inputs_of(options), Output_policy::follow)
    , m_from_name(options.spheres[0])
    , m_to_name(options.spheres[1])
    , m_from(read_sphere(m_from_name))
    , m_to(read_sphere(m_to_name))
  {}

  // reads all files, resamples and writes. The files appear after all of them are complete.
  void transfer_values()
  {
    m_resampler.method(m_options.method == "nearest"    ? SP::Resampling_method::nearest
                       : m_options.method == "largest"  ? SP::Resampling_method::largest
                       : m_options.method == "adaptive" ? SP::Resampling_method::adaptive
                                                        : SP::Resampling_method::barycentric);
    if(m_options.has("areas"))
    {
      std::vector<double> areas = read_areas(m_options.words("areas")[0], m_from.points.size(), m_from_name);
      m_resampler.areas(std::move(areas), read_areas(m_options.words("areas")[1], m_to.points.size(), m_to_name));
    }
    if(m_options.has("mask"))
      m_resampler.mask(read_mask(m_options.text("mask")));
    std::vector<Surface_file> files;
    for(const std::string& name : m_options.inputs)
    {
      files.push_back(read_arrays(name));
      check_content(name, files.back());
      check_holds(m_names[files.size() - 1], files.back());
    }
    connect(m_to, m_to_name);
    for(std::size_t k = 0; k < files.size(); ++k)
    {
      resample(files[k], m_options.inputs[k]);
      write(m_names[k], files[k], m_to.triangles.size());
    }
    const std::vector<bool> has_value = m_resampler.has_value();
    if(m_options.has("valid"))
    {
      Surface_file file;
      inherit_structure(file.origin.metadata, m_options.inputs[0], m_to);
      file.columns.push_back({"valid", "NIFTI_INTENT_SHAPE", Type::float32, {has_value.begin(), has_value.end()}, {}});
      check_holds(m_options.text("valid"), file);
      write(m_options.text("valid"), file, m_to.triangles.size());
    }
    commit();
    if(!m_options.has("quiet"))
      std::cout << "Resampled with " << m_options.method << " weights: " << m_from.points.size() << " to "
                << m_to.points.size() << " vertices, of which " << std::count(has_value.begin(), has_value.end(), false)
                << " receive no value\n";
  }

  // applies the registration that maps the first sphere to the second one, with the same faces, to spheres. Returns the exit status.
  int register_spheres()
  {
    check_number(m_to_name, m_to.points.size(), m_from_name, m_from.points.size());
    if(m_to.triangles != m_from.triangles)
      throw error_in(m_to_name, "has other faces than ", printable(m_from_name));
    check_finite(m_to_name, m_to);
    int status = EXIT_SUCCESS;
    for(std::size_t k = 0; k < m_options.inputs.size(); ++k)
    {
      const std::string& name = m_options.inputs[k];
      Surface_file file = read_sphere(name);
      check_holds(m_names[k], file);
      connect(file, name);
      if(const SP::Error_code error = m_resampler.resample_sphere(m_to.points, file.points);
         error != SP::ERROR_NO_1_TO_1_MAPPING)
        check(error, name);
      Input_mesh mesh(name, content_of(file));
      auto points = mesh.mesh().points();
      bool is_sphere = is_bijective(mesh);
      if(is_sphere && is_cortical(output_format(m_names[k])))
      {
        is_sphere = SP::round_to_float(mesh.mesh(), points, points) == SP::OK;
        for(const Vertex_index v : mesh.mesh().vertices())
          file.points[v] = {{points[v].x(), points[v].y(), points[v].z()}};
      }
      if(!is_sphere)
      {
        std::cerr << "spherical_parameterization: " << printable(m_names[k]) << ": the map is not bijective: faces of "
                  << printable(name) << " are too large for the registration, or the registration is not bijective\n";
        status = exit_status_folded;
      }
      file.origin = inherited(std::move(file.origin), true);
      write(m_names[k], file, file.triangles.size());
    }
    commit();
    if(!m_options.has("quiet"))
      std::cout << "Mapped through the registration: " << m_options.inputs.size()
                << (m_options.inputs.size() == 1 ? " sphere\n" : " spheres\n");
    return status;
  }

private:
  using Resampler = SP::Sphere_resampler_3<>;
  using Type = SP::IO::Vertex_values::Type;

  void add(const Hemispheres& files) { m_hemispheres.insert(m_hemispheres.end(), files.begin(), files.end()); }

  // Reads a surface or values from a file.
  Surface_file read_arrays(const std::string& path)
  {
    if(!is_among(file_format(path), input_formats))
    {
      Surface_file file = read_named(path, [&] {
        const Surface_file_kind kind = kind_of_file(path);
        if(kind == Surface_file_kind::none)
          throw Program_error("is neither a mesh nor a file of vertex values");
        std::string message;
        return read_surface_file(kind, path, message);
      });
      add(hemispheres_of(path, file.origin));
      return file;
    }
    const File_content content = read_file_content(path);
    add(content.hemispheres);
    for(const Polygon& polygon : content.polygons)
      check(polygon.size() == 3 ? SP::OK : SP::ERROR_NON_TRIANGULAR_MESH, path);
    return surface_file_of(content.points, content.polygons);
  }

  Surface_file read_sphere(const std::string& name)
  {
    Surface_file file = read_arrays(name);
    if(file.points.empty())
      throw error_in(name, "contains vertex values, but no surface; a sphere is required");
    return file;
  }

  static void check_finite(const std::string& name, const Surface_file& file)
  {
    for(std::size_t v = 0; v < file.points.size(); ++v)
      for(const double x : file.points[v])
        if(!std::isfinite(x))
          throw error_in(name, "vertex ", v,
                         " has a coordinate that is infinite or not a number. (Vertices are counted from 0.)");
  }

  // checks that the content of a file can be transferred
  void check_content(const std::string& name, const Surface_file& file) const
  {
    if(!has_all_vertices(file.vertices, file.points.size()))
      throw error_in(name, "has values of only some vertices of a surface");
    check_finite(name, file);
    if(file.points.empty() && file.columns.empty())
      throw error_in(name, "contains no vertex data");
    if(!file.points.empty() && m_options.has("mask"))
      throw error_in(name, "is a surface, whose vertices all have a point; omit --mask");
    check_number(name, file.points.empty() ? file.columns[0].values.size() : file.points.size(), m_from_name,
                 m_from.points.size());
  }

  std::vector<double> read_areas(const std::string& name, std::size_t n, const std::string& sphere)
  {
    const Surface_file file = read_arrays(name);
    if(!has_all_vertices(file.vertices, file.points.size()))
      throw error_in(name, "has areas of only some vertices of a surface");
    if(file.points.empty() && file.columns.size() > 1)
      throw error_in(name, "has ", file.columns.size(), " columns, but there is one area per vertex");
    for(const auto& t : file.triangles)
      if((std::max)({t[0], t[1], t[2]}) >= file.points.size())
        throw error_in(name, "has a triangle with an invalid vertex index");
    const std::vector<double> areas = !file.points.empty()    ? Resampler::vertex_areas(file.points, file.triangles)
                                      : !file.columns.empty() ? file.columns[0].values
                                                              : std::vector<double>();
    check_number(name, areas.size(), sphere, n);
    for(std::size_t v = 0; v < n; ++v)
      if(!(areas[v] >= 0. && std::isfinite(areas[v])))
        throw error_in(name, "the area of vertex ", v, " is negative or not finite. (Vertices are counted from 0.)");
    if(std::all_of(areas.begin(), areas.end(), [](double x) { return x == 0.; }))
      throw error_in(name, "all areas are 0");
    return areas;
  }

  std::vector<bool> read_mask(const std::string& name)
  {
    check_mask_file(name);
    const Surface_file file = read_arrays(name);
    const std::size_t n = m_from.points.size();
    std::vector<bool> mask(n, false);
    if(file.columns.size() != 1)
      throw error_in(name, file.columns.empty() ? "is not a mask: it has no vertex values"
                                                : "is not a mask: it has several values per vertex");
    const std::vector<double>& values = file.columns[0].values;
    if(file.vertices.empty())
      check_number(name, values.size(), m_from_name, n);
    for(std::size_t i = 0; i < values.size(); ++i)
    {
      const std::size_t v = file.vertices.empty() ? i : file.vertices[i];
      if(v >= n)
        check_number(name, v + 1, m_from_name, n);
      if(values[i] != values[i])
        throw error_in(name, "is not a mask: vertex ", v, " has a value that is not a number");
      mask[v] = values[i] > 0.;
    }
    if(std::find(mask.begin(), mask.end(), true) == mask.end())
      throw error_in(name, "is not a mask: no vertex has a positive value");
    return mask;
  }

  // Computes the weights for a sphere; reports its defect, or that of the first sphere, on failure.
  void connect(const Surface_file& to, const std::string& to_name)
  {
    const SP::Error_code error = m_resampler.connect(m_from.points, m_from.triangles, to.points, to.triangles);
    for(const auto& [name, sphere] : {std::pair(m_from_name, std::cref(m_from)), {to_name, std::cref(to)}})
      if(error != SP::OK)
      {
        Input_mesh mesh(name, content_of(sphere));
        mesh.check();
        if(!is_bijective(mesh))
          throw error_in(name, no_sphere);
      }
    check(error, m_from_name);
  }

  // Returns the key of vertices without a label: 0, unless it is that of a region.
  static std::int32_t find_key_of_nothing(const std::vector<SP::IO::Label>& labels)
  {
    std::int32_t next = 1;
    bool is_0_free = true;
    for(const SP::IO::Label& label : labels)
    {
      if(label.key == 0)
        is_0_free = is_among(label.name, {"", "???", "unknown", "Unknown"});
      if(label.key >= next && label.key < (std::numeric_limits<std::int32_t>::max)())
        next = label.key + 1;
    }
    return is_0_free ? 0 : next;
  }

  // Replaces the data of the vertices of the first sphere by those of the second one.
  void resample(Surface_file& file, const std::string& name) const
  {
    file.vertices.clear(); // all vertices have values
    const std::int32_t key_of_nothing = find_key_of_nothing(file.labels);
    const std::vector<bool> has_value = m_resampler.has_value();
    for(SP::IO::Vertex_values& column : file.columns)
      if(column.type == Type::float32)
        check(m_resampler.resample(column.values, column.values), name);
      else
      {
        std::vector<std::int32_t> labels(column.values.begin(), column.values.end());
        check(m_resampler.resample(labels, labels), name);
        column.values.assign(labels.begin(), labels.end());
        if(!file.labels.empty())
          for(std::size_t v = 0; v < has_value.size(); ++v)
            if(!has_value[v])
              column.values[v] = key_of_nothing;
      }
    if(!file.points.empty())
    {
      check(m_resampler.resample(file.points, file.points), name);
      file.triangles = m_to.triangles;
      file.origin = inherited(std::move(file.origin), false);
      inherit_structure(file.origin.metadata_of_points, name, m_to);
      return;
    }
    if(!file.labels.empty() && std::none_of(file.labels.begin(), file.labels.end(),
                                            [&](const SP::IO::Label& label) { return label.key == key_of_nothing; }))
      file.labels.push_back({key_of_nothing, "", {{0., 0., 0., 0.}}});
    inherit_structure(file.origin.metadata, name, m_to);
    if(file.columns.size() == 1 && file.columns[0].name.empty())
      file.columns[0].name = name_of_values(name);
  }

  void write(const std::string& name, const Surface_file& file, std::size_t n_triangles)
  {
    m_outputs.write(name, [&](std::ostream& out) {
      const std::string format = file.points.empty() ? format_of_values(name) : output_format(name);
      if(file.points.empty() || is_cortical(format))
        return read_named(name, [&] { write_surface_file(out, format, file, n_triangles); });
      const File_content content = content_of(file);
      write_mesh(out, format, content.points, content.polygons, file.origin);
    });
  }

  void commit()
  {
    std::cerr << mixed_hemispheres(m_hemispheres) << std::flush;
    m_outputs.commit();
  }

  const Options& m_options;
  Words m_names;
  Output_files m_outputs;
  Hemispheres m_hemispheres; // of all input files
  std::string m_from_name, m_to_name;
  Surface_file m_from, m_to;
  Resampler m_resampler;
};

} // namespace

int run_resample(const Options& options)
{
  Resampling_run run(options);
  if(options.has("through"))
    return run.register_spheres();
  run.transfer_values();
  return EXIT_SUCCESS;
}

} // namespace Program
