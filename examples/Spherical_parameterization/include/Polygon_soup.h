#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H

#include "hemispheres.h"

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace Program {

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Polygon = boost::container::small_vector<std::size_t, 3>; // a triangle needs no memory elsewhere

/// A number of one of the types that files have, all of which a double can hold.
using Number =
    std::variant<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t, float, double>;

/// A property of the vertices, or of the faces, that is neither a coordinate nor the corners.
struct Values
{
  std::string name;
  Number type; ///< in the file, by any number of that type
  std::vector<double> numbers;

  bool has_fractions() const { return std::holds_alternative<float>(type) || std::holds_alternative<double>(type); }
};

/// What a mesh file holds, in the order of the file. All corners are indices of points. A file of values has neither.
struct Polygon_soup
{
  std::vector<Point_3> points;
  std::vector<Polygon> polygons;
  std::vector<Values> values_of_vertices, values_of_faces; ///< if they were asked for; their names are different
  std::vector<std::uint32_t> vertices;                     ///< that the values are of, if not all
  std::vector<SP::IO::Label> labels;                       ///< what whole numbers among the values stand for
  std::vector<std::string> left_out;                       ///< in words, what there is beside them
  SP::IO::Surface_origin origin; ///< what a file of a cortical surface tells of where that is from
  Hemispheres hemispheres;       ///< of the files that this is from

  std::size_t number_of_vertices() const
  {
    return points.empty() && !values_of_vertices.empty() ? values_of_vertices.front().numbers.size() : points.size();
  }
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H
