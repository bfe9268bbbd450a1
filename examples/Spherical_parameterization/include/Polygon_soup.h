#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H

#include <CGAL/Simple_cartesian.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Program {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Polygon = boost::container::small_vector<std::size_t, 3>; // a triangle needs no memory elsewhere

/// What a mesh file holds, in the order of the file. All corners are indices of points.
struct Polygon_soup
{
  std::vector<Point_3> points;
  std::vector<Polygon> polygons;
};

/// What the user has to be told before the program ends with exit status 1.
class Program_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H
