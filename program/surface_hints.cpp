#include "surface_hints.h"

#include "read_file.h"

#include <CGAL/Spherical_parameterization/Cortex/compute_sulcal_measures.h>
#include <CGAL/Spherical_parameterization/internal/files/Text_scanner.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string_view>

namespace Program {

using SP::internal::Text_scanner;

namespace {

// Compared by their values and with the weight 2, they have areas of the cortex agree best by a probabilistic atlas, on two pairs of
// human hemispheres; see the manual.
constexpr const char* features_of_cortex = "depth,inflated";

// The `own_feature_names` of a surface.
class Own_features
{
public:
  Own_features(const Mesh& mesh, std::size_t n_vertices)
    : m_mesh(mesh)
    , m_n_vertices(n_vertices)
  {}

  // Returns the values of one of the names, as a file has them.
  File_content operator()(const std::string& name)
  {
    if(m_folding.depth.empty())
      if(const SP::Error_code error = SP::compute_sulcal_measures(m_mesh, m_folding); error != SP::OK)
        throw error_in(name, "cannot be measured. " + std::string(SP::get_error_message(error)));
    File_content soup;
    std::vector<double> values = name == "depth" || name == "height" ? m_folding.depth
                                 : name == "curvature"               ? m_folding.curvature
                                                                     : m_folding.inflated_curvature;
    if(name == "height")
      std::transform(values.begin(), values.end(), values.begin(), std::negate<>());
    values.resize(m_n_vertices);
    soup.values_of_vertices.push_back({name, double(), std::move(values)});
    return soup;
  }

private:
  const Mesh& m_mesh;
  std::size_t m_n_vertices; // of its file, which are the first ones
  SP::Sulcal_measures m_folding;
};

class Hint_reader
{
public:
  Hint_reader(Input_mesh& first, Input_mesh& second)
    : m_meshes{&first, &second}
    , m_numbers{first.mesh_of_file().number_of_vertices(), second.mesh().number_of_vertices()}
  {}

  Surface_hints hints;
  Hemispheres hemispheres;

  void add(const Hemispheres& files) { hemispheres.insert(hemispheres.end(), files.begin(), files.end()); }

  void read_landmarks(const Options& options);
  void read_masks(const Options& options);

  // Reads the features of both surfaces, and takes those that these have themselves.
  void read_features(const Words& lists, std::map<std::string, double> wanted);

private:
  std::array<Input_mesh*, 2> m_meshes;
  std::array<std::size_t, 2> m_numbers; // of vertices of their files
};

void check_feature(const std::string& file, const std::string& name, const std::vector<double>& values)
{
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  if(*least == *largest)
    throw error_in(file, "the property " + printable(name) +
                             " is the same for all vertices, so that it tells no places apart");
}

void Hint_reader::read_landmarks(const Options& options)
{
  const auto read = [](const std::string& name, const Mesh& mesh) {
    return read_named(name, [&] { return parse_landmarks(read_file(name), mesh); });
  };
  const std::vector<Landmark> first = read(options.landmark_files[0], m_meshes[0]->mesh()),
                              second = read(options.landmark_files[1], m_meshes[1]->mesh());
  if(first.size() != second.size())
    throw error_in(options.landmark_files[1], "has " + std::to_string(second.size()) + " landmarks, but " +
                                                  printable(options.landmark_files[0]) + " has " +
                                                  std::to_string(first.size()));
  if(first.empty())
    throw error_in(options.landmark_files[0], "has no landmark");
  for(std::size_t k = 0; k < first.size(); ++k)
  {
    hints.landmarks.emplace_back(first[k].vertex, second[k].vertex);
    hints.landmark_names.push_back("vertex " + std::to_string(first[k].vertex) + " in line " +
                                   std::to_string(first[k].line) + " of " + printable(options.landmark_files[0]));
  }
}

// The filler of holes does not count.
void Hint_reader::read_masks(const Options& options)
{
  if(options.mask_files.empty() && m_meshes[0]->mesh().number_of_vertices() == m_numbers[0])
    return;
  for(std::size_t k = 0; k < 2; ++k)
    hints.masks[k].assign(m_numbers[k], 1);
  for(std::size_t k = 0; k < options.mask_files.size(); ++k)
  {
    const std::string& name = options.mask_files[k];
    const File_content content = read_file_of_values(name);
    add(content.hemispheres);
    hints.masks[k] = read_named(name, [&] { return mask_of(content, m_numbers[k]); });
  }
}

void Hint_reader::read_features(const Words& lists, std::map<std::string, double> wanted)
{
  const std::string &name1 = lists[0], &name2 = lists[1];
  const auto read_list = [](const std::string& list, const Mesh& mesh, std::size_t n_vertices) {
    Own_features own(mesh, n_vertices);
    return read_values(list, [&](const std::string& name) {
      return is_among(name, own_feature_names) ? own(name) : read_file_of_values(name);
    });
  };
  File_content soup1 = read_list(name1, m_meshes[0]->mesh(), m_numbers[0]),
               soup2 = read_list(name2, m_meshes[1]->mesh(), m_numbers[1]);
  add(soup1.hemispheres);
  add(soup2.hemispheres);
  // The names that files of cortical surfaces have often tell the subject.
  const std::size_t n = soup1.values_of_vertices.size();
  if(soup1.points.empty() && soup2.points.empty() && soup2.values_of_vertices.size() != n)
    throw error_in(name2, "has " + std::to_string(soup2.values_of_vertices.size()) + " of the features, but " +
                              printable(name1) + " has " + std::to_string(n));
  if(soup1.points.empty() && soup2.points.empty())
    for(std::size_t k = 0; k < n; ++k)
      soup2.values_of_vertices[k].name = soup1.values_of_vertices[k].name;
  const auto take = [](const std::string& name, File_content& soup, std::size_t n_vertices) {
    return read_named(name, [&] { return features_of(std::move(soup), n_vertices); });
  };
  File_features first = take(name1, soup1, m_numbers[0]), second = take(name2, soup2, m_numbers[1]);
  for(auto& [name, values] : first.values)
    if(const auto other = second.values.find(name); other != second.values.end())
    {
      check_feature(name1, name, values);
      check_feature(name2, name, other->second);
      const auto weight = wanted.find(name);
      hints.features.push_back(
          {{std::move(values), std::move(other->second)}, weight != wanted.end() ? weight->second : 1.});
      if(weight != wanted.end())
        wanted.erase(weight);
      second.values.erase(other);
    }
    else
      first.left_out.push_back("the property '" + printable(name) + "' of the vertices, which " + printable(name2) +
                               " has not");
  for(const auto& property : second.values)
    second.left_out.push_back("the property '" + printable(property.first) + "' of the vertices, which " +
                              printable(name1) + " has not");
  if(hints.features.empty())
    throw error_in(name2, "has no property of vertices, of type float or double, that has the name of one in " +
                              printable(name1));
  for(const auto& [name, left_out] : {std::pair(name1, first.left_out), std::pair(name2, second.left_out)})
    for(const std::string& what : left_out)
      hints.warnings += printable(name) + ": not compared: " + what + '\n';
  if(!wanted.empty())
    throw error_in(name1, "has no feature of the name '" + printable(wanted.begin()->first) +
                              "' of --feature-weights that is compared");
  const auto is_of_no_weight = [](const Surface_hints::Feature& feature) { return feature.weight == 0.; };
  if(std::all_of(hints.features.begin(), hints.features.end(), is_of_no_weight))
    throw error_in(name1, "has no feature left: all of --feature-weights are 0");
}

} // namespace

std::vector<Landmark> parse_landmarks(std::string content, const Mesh& mesh)
{
  std::vector<Landmark> result;
  std::map<std::size_t, std::size_t> lines; // of the vertices
  const std::size_t n = mesh.number_of_vertices();
  for(std::size_t k = 0; k < content.size(); ++k)
    if(content[k] == '\r' && (k + 1 == content.size() || content[k + 1] != '\n'))
      content[k] = '\n';
  Text_scanner in(std::move(content));
  while(in.next_line())
  {
    const std::string_view word = in.read_word();
    if(word.find_first_not_of("0123456789") != word.npos)
      in.fail(Text_scanner::quoted(word), " is no number of a vertex. (Vertices are counted from 0.)");
    std::size_t v = 0;
    for(const char c : word)
      v = v < n ? 10 * v + static_cast<std::size_t>(c - '0') : n;
    if(v >= n)
      in.fail("the mesh has no vertex ", Text_scanner::quoted(word), ", but those from 0 to ", n - 1);
    if(mesh.is_isolated(Vertex_index(static_cast<Mesh::size_type>(v))))
      in.fail("vertex ", v, " has no face");
    if(!lines.emplace(v, in.line_number()).second)
      in.fail("vertex ", v, " is a landmark already, in line ", lines[v]);
    result.push_back({in.line_number(), Vertex_index(static_cast<Mesh::size_type>(v))});
  }
  return result;
}

File_features features_of(File_content soup, std::size_t n_vertices)
{
  if(soup.number_of_vertices() != n_vertices)
    throw Program_error("has no features for the mesh: it has " + std::to_string(soup.number_of_vertices()) +
                        " vertices, the mesh has " + std::to_string(n_vertices));
  File_features result;
  result.left_out = std::move(soup.left_out);
  for(Values& values : soup.values_of_vertices)
  {
    const std::string name = "the property '" + printable(values.name) + "' of the vertices";
    const bool is_of_normals = is_among(values.name, {"nx", "ny", "nz"});
    if(is_of_normals || !values.has_fractions())
    {
      result.left_out.push_back(
          name + (is_of_normals ? ", as normals turn with the surface" : ", whose type is neither float nor double"));
      continue;
    }
    for(std::size_t v = 0; v < values.numbers.size(); ++v)
      if(!std::isfinite(values.numbers[v]))
        throw Program_error("the property " + printable(values.name) + " of vertex " + std::to_string(v) +
                            " is infinite or not a number. (Vertices are counted from 0.)");
    result.values[values.name] = std::move(values.numbers);
  }
  for(const Values& values : soup.values_of_faces)
    result.left_out.push_back("the property '" + printable(values.name) + "' of the faces");
  return result;
}

std::vector<char> mask_of(const File_content& soup, std::size_t n_vertices)
{
  std::vector<char> result;
  if(!soup.vertices.empty())
  {
    result.assign(n_vertices, 0);
    for(const std::uint32_t v : soup.vertices)
    {
      if(v >= n_vertices)
        throw Program_error("is no mask for the mesh: it has a vertex " + std::to_string(v) + ", the mesh has " +
                            std::to_string(n_vertices) + " vertices. (Vertices are counted from 0.)");
      result[v] = 1;
    }
    return result;
  }
  if(soup.values_of_vertices.size() != 1)
    throw Program_error("is no mask: it has " + std::to_string(soup.values_of_vertices.size()) +
                        " values for each vertex, not one, which is 0 where the surface does not count");
  if(soup.number_of_vertices() != n_vertices)
    throw Program_error("is no mask for the mesh: it has " + std::to_string(soup.number_of_vertices()) +
                        " vertices, the mesh has " + std::to_string(n_vertices));
  for(const double x : soup.values_of_vertices.front().numbers)
  {
    if(x != x)
      throw Program_error("is no mask: vertex " + std::to_string(result.size()) +
                          " has a value that is not a number. (Vertices are counted from 0.)");
    result.push_back(x != 0.);
  }
  if(std::find(result.begin(), result.end(), 1) == result.end())
    throw Program_error("is 0 for all vertices: nothing of the surface counts");
  return result;
}

Surface_hints read_hints(const Options& options, Input_mesh& first, Input_mesh& second)
{
  Hint_reader reader(first, second);
  reader.add(first.hemispheres());
  reader.add(second.hemispheres());
  if(!options.landmark_files.empty())
    reader.read_landmarks(options);
  const bool is_cortex =
      options.convention == "cortex" ||
      (options.convention.empty() && first.is_of_cortical_format() && second.is_of_cortical_format());
  if(!options.feature_files.empty())
    reader.read_features(options.feature_files, options.feature_weights);
  else if(is_cortex)
  {
    reader.read_features({features_of_cortex, features_of_cortex}, {});
    reader.hints.is_cortical = true;
  }
  reader.read_masks(options);
  reader.hints.warnings = mixed_hemispheres(reader.hemispheres) + reader.hints.warnings;
  return std::move(reader.hints);
}

} // namespace Program
