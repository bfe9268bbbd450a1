#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H

#include <CGAL/Simple_cartesian.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
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

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_POLYGON_SOUP_H
