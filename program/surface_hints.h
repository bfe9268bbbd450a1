#ifndef PROGRAM_SURFACE_HINTS_H
#define PROGRAM_SURFACE_HINTS_H

#include "Input_mesh.h"
#include "Options.h"

#include <array>

namespace Program {

/// A vertex with a corresponding vertex of another surface, and the line of the file that contains it.
struct Landmark
{
  std::size_t line;
  Vertex_index vertex;
};

/// reads the content of a file of landmarks: one vertex per line, counted from 0 in the file of the mesh; the rest of the line is
/// ignored.
std::vector<Landmark> parse_landmarks(std::string content, const Input_mesh& input);

/// The features in files of values.
struct File_features
{
  std::map<std::string, std::vector<double>> values; ///< of the vertices, by the name of the property
  Words left_out;                                    ///< descriptions of the other content
};

/// returns the features of a mesh in the content of files: vertex properties of type float or double, except normals.
File_features features_of(File_content soup, std::size_t n_vertices);

/// returns the mask of a mesh in the content of a file: the vertices of a label, or those whose only value is not 0.
std::vector<char> mask_of(const File_content& soup, std::size_t n_vertices);

/// Landmarks, features and masks of two surfaces, from files or computed.
struct Surface_hints
{
  struct Feature
  {
    std::array<std::vector<double>, 2> values; ///< of the vertices of both surfaces
    double weight;
  };

  std::vector<std::pair<Vertex_index, Vertex_index>> landmarks;
  Words landmark_names;
  std::vector<Feature> features;
  bool is_cortical = false; ///< whether these are the default features of cortical surfaces
  std::array<std::vector<char>, 2>
      masks;            ///< whether features are compared at the vertices of each; empty for all vertices
  std::string warnings; ///< about files of different hemispheres and properties that are not features, one per line
};

/// reads the files that the options name.
Surface_hints read_hints(const Options& options, const Input_mesh& first, const Input_mesh& second);

} // namespace Program

#endif // PROGRAM_SURFACE_HINTS_H
