#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_MESH_TEXTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_MESH_TEXTS_H

// Mesh files as texts.

#include "standard_library.h"
#include "Binary_file.h"

// A tetrahedron with a right angle, as text.
inline const std::string corner_off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
inline const std::string corner_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
inline const std::string corner_stl =
    "solid facet of a corner\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 1 0\nvertex 0 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "endsolid\n";

inline const std::string corner_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  for(std::size_t i = text.find(from); i != std::string::npos; i = text.find(from, i + to.size()))
    text.replace(i, from.size(), to);
  return text;
}

inline std::vector<std::string> words_of(const std::string& text)
{
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

namespace ply_files {

using Numbers = std::vector<std::vector<double>>; // of each vertex, say
using Ply_element = std::vector<std::string>; // its name and its properties, such as "list uchar int vertex_indices"

// a tetrahedron
inline const std::map<std::string, Numbers> usual_numbers = {
    {"x", {{0}, {1}, {0}, {0}}},
    {"y", {{0}, {0}, {1}, {0}}},
    {"z", {{0}, {0}, {0}, {1}}},
    {"height", {{0.5}, {-2}, {7}, {1e30}}},
    {"vertex1", {{0}, {1}, {9}}},
    {"vertex2", {{1}, {2}, {7}}},
    {"vertex_indices", {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
    {"vertex_index", {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
    {"label", {{7}, {7}, {7}, {9}}},
    {"weights", {{1, 2}, {}, {3}, {4, 5, 6}}}};

inline const Ply_element vertices = {"vertex", "float x", "float y", "float z", "float height"},
                         edges = {"edge", "int vertex1", "int vertex2"},
                         faces = {"face", "list uchar int vertex_indices", "ushort label"};

// numbers of properties of other names are 1, 2, 3, 4
inline std::string ply_file(const std::string& format, const std::vector<Ply_element>& elements,
                            std::map<std::string, Numbers> numbers = usual_numbers)
{
  std::string header = "ply\nformat " + format + " 1.0\n";
  Binary_file body(format == "binary_big_endian");
  const auto put = [&](const std::string& type, double x) {
    std::ostringstream text;
    text << x << ' ';
    if(format == "ascii")
      body << text.str();
    else if(type == "double" || type == "float64")
      body << x;
    else if(type.substr(0, 5) == "float")
      body << static_cast<float>(x);
    else if(type == "int" || type == "uint" || type == "int32")
      body << static_cast<std::uint32_t>(x);
    else if(type == "short" || type == "ushort" || type == "uint16")
      body << static_cast<std::int16_t>(x);
    else
      body << static_cast<std::uint8_t>(x);
  };
  for(const Ply_element& element : elements)
  {
    const std::size_t n = element[0] == "edge" ? 3 : 4;
    header += "element " + element[0] + ' ' + std::to_string(n) + '\n';
    for(std::size_t k = 1; k < element.size(); ++k)
      header += "property " + element[k] + '\n';
    for(std::size_t i = 0; i < n; ++i)
    {
      for(std::size_t k = 1; k < element.size(); ++k)
      {
        const std::vector<std::string> words = words_of(element[k]);
        const Numbers& x = numbers.emplace(words.back(), Numbers{{1}, {2}, {3}, {4}}).first->second;
        if(words[0] == "list")
          put(words[1], static_cast<double>(x[i].size()));
        for(const double y : x[i])
          put(words[words.size() - 2], y);
      }
      body << std::string(format == "ascii" ? "\n" : "");
    }
  }
  return header + "end_header\n" + body.content;
}

} // namespace ply_files

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_MESH_TEXTS_H
