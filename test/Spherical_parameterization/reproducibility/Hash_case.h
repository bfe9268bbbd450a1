#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_HASH_CASE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_HASH_CASE_H

// What the table of hashes, hashes.txt, consists of. A case computes something from a mesh and adds its bits to a hash.

#include "test_meshes.h"

#include <CGAL/Spherical_parameterization/Error_code.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace reproducibility {

namespace SP = CGAL::Spherical_parameterization;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Sphere = Mesh::Property_map<Vertex, Point_3>;

// FNV-1a of 64-bit words, the lowest byte first: the same on every machine.
class Hash
{
public:
  void add(std::uint64_t word)
  {
    for(unsigned int shift = 0; shift < 64; shift += 8)
      m_value = (m_value ^ ((word >> shift) & 0xffu)) * 0x100000001b3u;
  }
  void add(double x)
  {
    std::uint64_t word;
    std::memcpy(&word, &x, sizeof word);
    add(x == x ? word : ~std::uint64_t(0)); // there are many NaNs
  }
  void add(const Point_3& p)
  {
    for(int i = 0; i < 3; ++i)
      add(static_cast<double>(p[i]));
  }
  void add(const std::string& text)
  {
    for(const char c : text)
      add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  template <class T>
  void add(const std::vector<T>& values)
  {
    add(static_cast<std::uint64_t>(values.size()));
    for(const auto& x : values)
      add(x);
  }
  template <class T, std::size_t N>
  void add(const std::array<T, N>& values)
  {
    for(const auto& x : values)
      add(x);
  }
  void add(std::uint32_t word) { add(static_cast<std::uint64_t>(word)); }
  void add(bool b) { add(static_cast<std::uint64_t>(b)); }

  // the vertices of a mesh, or their images
  void add(const Mesh& mesh, const Sphere& map)
  {
    add(static_cast<std::uint64_t>(mesh.number_of_vertices()));
    for(const Vertex v : mesh.vertices())
      add(map[v]);
  }

  std::string text() const
  {
    std::string result(16, '0');
    for(std::size_t k = 0; k < 16; ++k)
      result[k] = "0123456789abcdef"[(m_value >> (60 - 4 * k)) & 0xfu];
    return result;
  }

private:
  std::uint64_t m_value = 0xcbf29ce484222325u;
};

// What is computed from a mesh, by the name that the table has for it. It throws if there is no result.
using Hash_cases = std::map<std::string, std::function<void(const Mesh& mesh, Hash& hash)>>;

void add_spheres(Hash_cases& cases); // take less to compile than the others
void add_operations(Hash_cases& cases);

// A mesh by the name that the table has for it: that of a file in one of the folders, or of a mesh that is made. Empty if there is no
// such file here.
Mesh find_mesh(const std::string& name);

inline void check(SP::Error_code error)
{
  if(error != SP::OK)
    throw std::runtime_error(SP::get_error_message(error));
}

inline Sphere sphere_of(Mesh& mesh, const char* name = "v:sphere")
{
  return mesh.add_property_map<Vertex, Point_3>(name).first;
}

} // namespace reproducibility

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_HASH_CASE_H
