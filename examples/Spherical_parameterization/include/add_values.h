#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ADD_VALUES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ADD_VALUES_H

#include "Input_mesh.h"
#include "Polygon_soup.h"
#include "mesh_files.h"

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace Program {

/// gives a mesh properties of its vertices or of its faces, as an `Index` says. The bytes red, green and blue become a
/// colour, with alpha if that is a byte as well. Normals are left out: a remesh has its own.
///
/// \returns the names of the other ones that are left out: CGAL's writer of PLY files uses them itself, or forgets them
template <class Index>
Words add_values(Mesh& mesh, const std::vector<Values>& all)
{
  constexpr bool is_of_vertices = std::is_same_v<Index, Vertex_index>;
  const std::string prefix = is_of_vertices ? "v:" : "f:";
  const auto find = [&all](const std::string& name) -> const Values* {
    const auto is_it = [&name](const Values& values) { return values.name == name; };
    const auto found = std::find_if(all.begin(), all.end(), is_it);
    return found == all.end() ? nullptr : &*found;
  };
  const auto find_bytes = [&find](const std::string& name) {
    const Values* found = find(name);
    return found != nullptr && std::holds_alternative<std::uint8_t>(found->type) ? found : nullptr;
  };
  const Values *red = find_bytes("red"), *green = find_bytes("green"), *blue = find_bytes("blue"),
               *alpha = find_bytes("alpha");
  const bool has_color = red != nullptr && green != nullptr && blue != nullptr;
  const bool has_normals = is_of_vertices && find("nx") != nullptr && find("ny") != nullptr && find("nz") != nullptr;
  Words used = is_of_vertices ? Words{"nx", "ny", "nz", "point", "normal", "removed", "connectivity"}
                              : Words{"vertex_indices", "vertex_index", "removed", "connectivity"};
  if(has_color)
  {
    used.insert(used.end(), {"color", "alpha"});
    auto map = mesh.add_property_map<Index, CGAL::IO::Color>(prefix + "color").first;
    for(std::size_t i = 0; i < red->numbers.size(); ++i)
    {
      const auto byte = [i](const Values* values) { return static_cast<unsigned char>(values->numbers[i]); };
      map[Index(static_cast<Mesh::size_type>(i))] =
          CGAL::IO::Color(byte(red), byte(green), byte(blue), alpha != nullptr ? byte(alpha) : 255);
    }
  }

  Words left_out;
  for(const Values& values : all)
  {
    const Values* p = &values;
    if((has_color && (p == red || p == green || p == blue || p == alpha)) ||
       (has_normals && is_among(p->name, {"nx", "ny", "nz"})))
      continue;
    if(is_among(p->name, used))
      left_out.push_back(p->name);
    else
      std::visit(
          [&](auto number) {
            using T = decltype(number);
            auto map = mesh.add_property_map<Index, T>(prefix + p->name).first;
            for(std::size_t i = 0; i < p->numbers.size(); ++i)
              map[Index(static_cast<Mesh::size_type>(i))] = static_cast<T>(p->numbers[i]);
          },
          p->type);
  }
  return left_out;
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ADD_VALUES_H
