#include "surface_hints.h"

#include <CGAL/Spherical_parameterization/Cortex/compute_sulcal_measures.h>
#include <CGAL/Spherical_parameterization/internal/files/Text_scanner.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace Program {

using SP::internal::Text_scanner;

namespace {

constexpr const char* from_0 = ". (Vertices are counted from 0.)";

// With these features, compared by values with the weight 2, cortical areas of a probabilistic atlas agree best on two pairs of human
// hemispheres; see the manual.
constexpr const char* features_of_cortex = "depth,inflated";

unsigned int measure_named(const std::string& name)
{
  return name == "curvature"  ? SP::Sulcal_measures::CURVATURE
         : name == "inflated" ? SP::Sulcal_measures::INFLATED_CURVATURE
                              : SP::Sulcal_measures::DEPTH;
}

// Reads features from files, or computes those among `own_feature_names`.
File_content read_features_of(const std::string& list, const Input_mesh& input)
{
  unsigned int selection = 0;
  for(const std::string& name : split_list(list))
    if(is_among(name, own_feature_names))
      selection |= measure_named(name);
  SP::Sulcal_measures measures;
  if(selection != 0)
    if(const SP::Error_code error = SP::compute_sulcal_measures(input.mesh(), measures, selection); error != SP::OK)
      throw error_in(list, "the features cannot be computed. ", SP::get_error_message(error));
  return read_values(list, [&](const std::string& name) {
    if(!is_among(name, own_feature_names))
      return input.transferred(read_file_of_values(name));
    const unsigned int measure = measure_named(name);
    std::vector<double> values = measure == SP::Sulcal_measures::CURVATURE ? measures.curvature
                                 : measure == SP::Sulcal_measures::DEPTH   ? measures.depth
                                                                           : measures.inflated_curvature;
    if(name == "height")
      std::transform(values.begin(), values.end(), values.begin(), std::negate<>());
    File_content soup;
    soup.values_of_vertices.push_back({name, double(), std::move(values)});
    return soup;
  });
}

class Hint_reader
{
public:
  Hint_reader(const Input_mesh& first, const Input_mesh& second)
    : m_inputs{&first, &second}
    , m_hemispheres(first.hemispheres())
  {
    add(second.hemispheres());
  }

  Surface_hints hints;

  void read_landmarks(const Words& names)
  {
    std::array<std::vector<Landmark>, 2> landmarks;
    for(std::size_t k = 0; k < 2; ++k)
      landmarks[k] = read_named(names[k], [&] { return parse_landmarks(read_file(names[k]), *m_inputs[k]); });
    const auto& [first, second] = landmarks;
    if(first.size() != second.size())
      throw error_in(names[1], "has ", second.size(), second.size() == 1 ? " landmark, but " : " landmarks, but ",
                     printable(names[0]), " has ", first.size());
    if(first.empty())
      throw error_in(names[0], "has no landmarks");
    for(std::size_t k = 0; k < first.size(); ++k)
    {
      hints.landmarks.emplace_back(first[k].vertex, second[k].vertex);
      hints.landmark_names.push_back("vertex " + std::to_string(first[k].vertex) + " in line " +
                                     std::to_string(first[k].line) + " of " + printable(names[0]));
    }
  }

  // Features are not compared on hole patches.
  void read_masks(const Words& names)
  {
    for(std::size_t k = 0; k < 2; ++k)
    {
      if(k < names.size())
      {
        check_mask_file(names[k]);
        const File_content content = read_file_content(names[k], true);
        add(content.hemispheres);
        hints.masks[k] = read_named(names[k], [&] { return mask_for(*m_inputs[k], content); });
      }
      else if(!names.empty() || m_inputs[0]->has_patches() || m_inputs[1]->has_patches())
        hints.masks[k].assign(m_inputs[k]->mesh().number_of_vertices(), 1);
      if(m_inputs[k]->has_patches())
      {
        const std::vector<std::size_t>& sources = m_inputs[k]->repair()->source_vertices();
        for(std::size_t v = 0; v < sources.size(); ++v)
          hints.masks[k][v] = hints.masks[k][v] != 0 && sources[v] != Repair_step::none;
      }
    }
  }

  // Reads or computes the features of both surfaces.
  void read_features(const Words& names, std::map<std::string, double> weights)
  {
    std::array<File_content, 2> soups;
    for(std::size_t k = 0; k < 2; ++k)
    {
      soups[k] = read_features_of(names[k], *m_inputs[k]);
      add(soups[k].hemispheres);
    }
    if(soups[0].points.empty() && soups[1].points.empty())
    {
      // File names of cortical surfaces often contain the subject.
      const std::vector<Values>& first = soups[0].values_of_vertices;
      std::vector<Values>& second = soups[1].values_of_vertices;
      if(second.size() != first.size())
        throw error_in(names[1], "has ", second.size(), " features, but ", printable(names[0]), " has ", first.size());
      for(std::size_t k = 0; k < first.size(); ++k)
        second[k].name = first[k].name;
    }
    std::array<File_features, 2> features;
    for(std::size_t k = 0; k < 2; ++k)
      features[k] = read_named(
          names[k], [&] { return features_of(std::move(soups[k]), m_inputs[k]->mesh().number_of_vertices()); });
    for(std::size_t k = 0; k < 2; ++k)
      for(const auto& pair : features[k].values)
        if(features[1 - k].values.count(pair.first) == 0)
          features[k].left_out.push_back("the vertex property '" + printable(pair.first) + "', which is missing in " +
                                         printable(names[1 - k]));
    for(auto& [name, values] : features[0].values)
      if(const auto other = features[1].values.find(name); other != features[1].values.end())
      {
        check_feature(names[0], name, values);
        check_feature(names[1], name, other->second);
        const double weight = weights.count(name) > 0 ? weights[name] : 1.;
        weights.erase(name);
        hints.features.push_back({{std::move(values), std::move(other->second)}, weight});
      }
    if(hints.features.empty())
      throw error_in(names[1], "has no vertex property of type float or double with the name of a property in ",
                     printable(names[0]));
    for(std::size_t k = 0; k < 2; ++k)
      for(const std::string& what : features[k].left_out)
        hints.warnings += printable(names[k]) + ": not compared: " + what + '\n';
    if(!weights.empty())
      throw error_in(names[0], "has no compared feature '", printable(weights.begin()->first),
                     "', which is in --feature-weights");
    const auto is_of_no_weight = [](const Surface_hints::Feature& feature) { return feature.weight == 0.; };
    if(std::all_of(hints.features.begin(), hints.features.end(), is_of_no_weight))
      throw error_in(names[0], "all features have the weight 0 in --feature-weights");
  }

  std::string warning_of_hemispheres() const { return mixed_hemispheres(m_hemispheres); }

private:
  void add(const Hemispheres& files) { m_hemispheres.insert(m_hemispheres.end(), files.begin(), files.end()); }

  static void check_feature(const std::string& file, const std::string& name, const std::vector<double>& values)
  {
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    if(*least == *largest)
      throw error_in(file, "the property ", printable(name), " is constant, so that it cannot align the surfaces");
  }

  // Returns the mask of the mesh from a mask of its vertices or of those of its file.
  static std::vector<char> mask_for(const Input_mesh& input, const File_content& content)
  {
    const std::size_t n = input.mesh().number_of_vertices(), n_of_file = input.number_of_vertices_of_file();
    if(!input.repair() || !input.repair()->has_changed_surface() ||
       (content.vertices.empty() && content.number_of_vertices() == n && n != n_of_file))
      return mask_of(content, n);
    const std::vector<char> of_file = mask_of(content, n_of_file);
    std::vector<char> result;
    for(const std::size_t source : input.repair()->source_vertices())
      result.push_back(source == Repair_step::none ? 0 : of_file[source]);
    return result;
  }

  std::array<const Input_mesh*, 2> m_inputs;
  Hemispheres m_hemispheres;
};

} // namespace

std::vector<Landmark> parse_landmarks(std::string content, const Input_mesh& input)
{
  std::vector<Landmark> result;
  std::map<std::size_t, std::size_t> lines; // of the vertices
  const std::size_t n = input.number_of_vertices_of_file();
  Text_scanner in(std::move(content));
  while(in.next_line())
  {
    const std::string_view word = in.read_word();
    if(word.find_first_not_of("0123456789") != word.npos)
      in.fail(Text_scanner::quoted(word), " is not a vertex index. (Vertices are counted from 0.)");
    std::size_t v = 0;
    for(const char c : word)
      v = v < n ? 10 * v + static_cast<std::size_t>(c - '0') : n;
    double other = 0.;
    if(const std::string_view next = in.read_word(); is_number(std::string(next), other))
      in.fail(Text_scanner::quoted(next), " follows the vertex index ", Text_scanner::quoted(word),
              "; write one vertex index per line, counted from 0");
    if(v >= n)
      in.fail("the mesh has no vertex ", Text_scanner::quoted(word), ": its vertices are 0 to ", n - 1);
    const Vertex_index vertex = input.vertex_of(v);
    if(vertex == Mesh::null_vertex())
      in.fail("vertex ", v, " has no face", input.repair() ? " after the repair" : "");
    if(!lines.emplace(vertex, in.line_number()).second)
      in.fail("vertex ", v, " is already a landmark, in line ", lines[vertex]);
    result.push_back({in.line_number(), vertex});
  }
  return result;
}

File_features features_of(File_content soup, std::size_t n_vertices)
{
  if(soup.number_of_vertices() != n_vertices)
    throw Program_error("does not match the mesh: it has values of ", soup.number_of_vertices(),
                        " vertices, the mesh has ", n_vertices);
  File_features result;
  result.left_out = std::move(soup.left_out);
  for(Values& values : soup.values_of_vertices)
  {
    const std::string name = "the vertex property '" + printable(values.name) + "'";
    if(is_among(values.name, {"nx", "ny", "nz"}))
      result.left_out.push_back(name + ", because normals are not invariant under rotation");
    else if(!values.has_fractions())
      result.left_out.push_back(name + ", whose type is neither float nor double");
    else
    {
      for(std::size_t v = 0; v < values.numbers.size(); ++v)
        if(!std::isfinite(values.numbers[v]))
          throw Program_error("the property ", printable(values.name), " of vertex ", v, " is infinite or not a number",
                              from_0);
      result.values[values.name] = std::move(values.numbers);
    }
  }
  for(const Values& values : soup.values_of_faces)
    result.left_out.push_back("the face property '" + printable(values.name) + "'");
  return result;
}

std::vector<char> mask_of(const File_content& soup, std::size_t n_vertices)
{
  if(soup.values_of_vertices.size() != 1)
    throw Program_error("is not a mask: it has ", soup.values_of_vertices.size(),
                        " values per vertex, but a mask has one, which is 0 for excluded vertices");
  const std::vector<double>& numbers = soup.values_of_vertices.front().numbers;
  if(soup.vertices.empty() && numbers.size() != n_vertices)
    throw Program_error("is not a mask of the mesh: it has ", numbers.size(), " vertices, the mesh has ", n_vertices);
  std::vector<char> result(n_vertices, 0);
  for(std::size_t i = 0; i < numbers.size(); ++i)
  {
    const std::size_t v = soup.vertices.empty() ? i : soup.vertices[i];
    if(v >= n_vertices)
      throw Program_error("is not a mask of the mesh: it has a vertex ", v, ", the mesh has ", n_vertices, " vertices",
                          from_0);
    if(numbers[i] != numbers[i])
      throw Program_error("is not a mask: vertex ", v, " has a value that is not a number", from_0);
    result[v] = numbers[i] != 0.;
  }
  if(std::find(result.begin(), result.end(), 1) == result.end())
    throw Program_error("is 0 for all vertices: the mask excludes the whole surface");
  return result;
}

Surface_hints read_hints(const Options& options, const Input_mesh& first, const Input_mesh& second)
{
  Hint_reader reader(first, second);
  Surface_hints& hints = reader.hints;
  if(options.has("landmarks"))
    reader.read_landmarks(options.words("landmarks"));
  hints.is_cortical = !options.has("features") &&
                      (options.text("convention") == "cortex" ||
                       (!options.has("convention") && first.is_of_cortical_format() && second.is_of_cortical_format()));
  if(hints.is_cortical)
    reader.read_features({features_of_cortex, features_of_cortex}, {});
  else if(options.has("features"))
    reader.read_features(options.words("features"), options.feature_weights);
  reader.read_masks(options.words("masks"));
  hints.warnings = reader.warning_of_hemispheres() + hints.warnings;
  return std::move(hints);
}

} // namespace Program
