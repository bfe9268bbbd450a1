#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_ARRAYS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_ARRAYS_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/internal/files/Soup_defect.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace Module {

namespace py = pybind11;
namespace SP = CGAL::Spherical_parameterization;

// The Python part has checked their shapes and made them contiguous.
using Points = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::int64_t, py::array::c_style>;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex_index = Mesh::Vertex_index;
using Face_index = Mesh::Face_index;

/// The exception that is translated to `spherical_parameterization.Error`.
struct Error
{
  SP::internal::Soup_defect defect;
};

[[noreturn]] inline void fail(SP::Error_code code, const std::string& message)
{
  throw Error{{code, message, {}, {}, {}}};
}

inline std::size_t number_of_rows(const py::array& array)
{
  return static_cast<std::size_t>(array.shape(0));
}
inline Points new_points(std::size_t n)
{
  return Points({static_cast<py::ssize_t>(n), py::ssize_t(3)});
}

/// The rows of an array with three columns as points. `Number` is `double`, or `const double` if they are only read.
template <class Number>
class Row_map
{
public:
  using key_type = Vertex_index;
  using value_type = Point_3;
  using reference = Point_3;
  using category = std::conditional_t<std::is_const<Number>::value, boost::readable_property_map_tag,
                                      boost::read_write_property_map_tag>;

  explicit Row_map(Number* rows)
    : m_rows(rows)
  {}

  friend Point_3 get(const Row_map& map, Vertex_index v)
  {
    const Number* const row = map.m_rows + 3 * std::size_t(v);
    return Point_3(row[0], row[1], row[2]);
  }
  template <class Point>
  friend void put(const Row_map& map, Vertex_index v, const Point& p)
  {
    std::copy(p.cartesian_begin(), p.cartesian_end(), map.m_rows + 3 * std::size_t(v));
  }

private:
  Number* m_rows;
};
using Const_row_map = Row_map<const double>;

inline Const_row_map rows_of(const Points& points)
{
  return Const_row_map(points.data());
}

/// builds a mesh from two arrays. Where no surface is needed, the points are those of the map to the sphere. As in the readers of
/// files, `halfedge(f, mesh)` leads from the last corner of a face to the first one.
///
/// \param name the prefix of messages, such as "target: "; empty if there is only one mesh
///
/// \throws Error if an index is out of range, or no halfedge data structure can represent the faces
Mesh make_mesh(const std::string& name, const Points& points, const Indices& faces);

/// throws the defect that prevents a parameterization of the mesh, if any.
void check_surface(const std::string& name, const Mesh& mesh);

/// throws the first vertex with a face whose point is not finite, if any.
void check_points(const std::string& name, const Mesh& mesh, const std::string& name_of_points, const Points& points);

/// throws the defect of the mesh or of its map, if any.
void check_map(const std::string& name, const Mesh& mesh, const std::string& name_of_map, const Points& sphere);

inline Indices to_array(const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  Indices result({static_cast<py::ssize_t>(triangles.size()), py::ssize_t(3)});
  std::int64_t* corner = result.mutable_data();
  for(const auto& triangle : triangles)
    corner = std::copy(triangle.begin(), triangle.end(), corner);
  return result;
}

} // namespace Module

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PYTHON_ARRAYS_H
