#ifndef PROGRAM_SURFACE_HINTS_H
#define PROGRAM_SURFACE_HINTS_H

#include "Input_mesh.h"
#include "Options.h"

#include <array>

namespace Program {

/// A vertex that corresponds to one of another surface, and the line of its file where it is.
struct Landmark
{
  std::size_t line;
  Vertex_index vertex;
};

/// reads the content of a file of landmarks: a vertex a line, counted from 0 as in the file of the mesh; what follows on the line is
/// not looked at.
std::vector<Landmark> parse_landmarks(std::string content, const Input_mesh& input);

/// What surfaces can be aligned by of all that files of values hold.
struct File_features
{
  std::map<std::string, std::vector<double>> values; ///< of the vertices, by the name of the property
  Words left_out;                                    ///< in words, the rest
};

/// takes the features from files for a mesh: the properties of vertices of type float or double, but normals.
File_features features_of(File_content soup, std::size_t n_vertices);

/// takes from a file where a mesh counts: the vertices that a label has, or those whose one value is not 0.
std::vector<char> mask_of(const File_content& soup, std::size_t n_vertices);

/// What is known of two surfaces that are mapped onto each other, from files and by measuring.
struct Surface_hints
{
  struct Feature
  {
    std::array<std::vector<double>, 2> values; ///< of the vertices of both
    double weight;
  };

  std::vector<std::pair<Vertex_index, Vertex_index>> landmarks;
  Words landmark_names;
  std::vector<Feature> features;
  bool is_cortical = false;               ///< whether they are those by which cortical surfaces are aligned
  std::array<std::vector<char>, 2> masks; ///< whether vertices of both count; empty if all do
  std::string warnings; ///< of files of different hemispheres, and of properties that are no features, a line each
};

/// reads what the options name.
Surface_hints read_hints(const Options& options, const Input_mesh& first, const Input_mesh& second);

} // namespace Program

#endif // PROGRAM_SURFACE_HINTS_H
