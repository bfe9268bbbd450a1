#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_SURFACE_HINTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_SURFACE_HINTS_H

#include "Input_mesh.h"
#include "Polygon_soup.h"
#include "Program_error.h"
#include "mesh_files.h"
#include "readers/Scanner.h"

#include <CGAL/Spherical_parameterization/Cortex/compute_sulcal_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Program {

/// A vertex that corresponds to one of another surface, and the line of its file where it is.
struct Landmark
{
  std::size_t line;
  Vertex_index vertex;
};

/// reads the content of a file of landmarks: a vertex a line, counted from 0; what follows on the line is not looked at. Lines may
/// end with a carriage return alone.
///
/// \throws Program_error if one is no vertex of a face, or there twice
inline std::vector<Landmark> parse_landmarks(std::string content, const Mesh& mesh)
{
  std::vector<Landmark> result;
  std::map<std::size_t, std::size_t> lines; // of the vertices
  const std::size_t n = mesh.number_of_vertices();
  for(std::size_t k = 0; k < content.size(); ++k)
    if(content[k] == '\r' && (k + 1 == content.size() || content[k + 1] != '\n'))
      content[k] = '\n';
  Scanner in(std::move(content));
  while(in.next_line())
  {
    const std::string_view word = in.read_word();
    if(word.find_first_not_of("0123456789") != word.npos)
      in.fail(Scanner::quoted(word), " is no number of a vertex. (Vertices are counted from 0.)");
    std::size_t v = 0;
    for(const char c : word)
      v = v < n ? 10 * v + static_cast<std::size_t>(c - '0') : n;
    if(v >= n)
      in.fail("the mesh has no vertex ", Scanner::quoted(word), ", but those from 0 to ", n - 1);
    if(mesh.is_isolated(Vertex_index(static_cast<Mesh::size_type>(v))))
      in.fail("vertex ", v, " has no face");
    if(!lines.emplace(v, in.line_number()).second)
      in.fail("vertex ", v, " is a landmark already, in line ", lines[v]);
    result.push_back({in.line_number(), Vertex_index(static_cast<Mesh::size_type>(v))});
  }
  return result;
}

/// The `own_feature_names` of a surface.
class Own_features
{
public:
  /// \param n_vertices of the file of the surface, which are the first ones
  ///
  /// \pre the mesh lives longer
  Own_features(const Mesh& mesh, std::size_t n_vertices)
    : m_mesh(mesh)
    , m_n_vertices(n_vertices)
  {}

  /// returns the values of one of the names, as a file has them.
  ///
  /// \throws Program_error if there are none
  Polygon_soup operator()(const std::string& name)
  {
    if(m_folding.depth.empty())
      if(const SP::Error_code error = SP::compute_sulcal_measures(m_mesh, m_folding); error != SP::OK)
        throw Program_error(name, "cannot be measured. " + std::string(SP::get_error_message(error)));
    Polygon_soup soup;
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
  std::size_t m_n_vertices;
  SP::Sulcal_measures m_folding;
};

/// What surfaces can be aligned by of all that files of values hold.
struct File_features
{
  std::map<std::string, std::vector<double>> values; ///< of the vertices, by the name of the property
  Words left_out;                                    ///< in words, the rest
};

/// takes the features from files for a mesh: the properties of vertices of type float or double, but normals.
///
/// \throws Program_error if they are not those of as many vertices, or not finite
inline File_features features_of(Polygon_soup soup, std::size_t n_vertices)
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

/// takes from a file where a mesh counts: the vertices that a label has, or those whose one value is not 0.
///
/// \throws Program_error if there is none, or more than one, or they are not those of as many vertices
inline std::vector<char> mask_of(const Polygon_soup& soup, std::size_t n_vertices)
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

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_SURFACE_HINTS_H
