#include "add_values.h"

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

namespace Program {

namespace {

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

} // namespace

Words add_values_of_vertices(Mesh& mesh, const std::vector<Values>& all)
{
  return add_values<Vertex_index>(mesh, all);
}

Words add_values_of_faces(Mesh& mesh, const std::vector<Values>& all)
{
  return add_values<Mesh::Face_index>(mesh, all);
}

} // namespace Program
