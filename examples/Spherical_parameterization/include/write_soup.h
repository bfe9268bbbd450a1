#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SOUP_H

#include "Polygon_soup.h"

#include <CGAL/IO/GOCAD.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/io.h>

#include <ostream>
#include <string>
#include <vector>

namespace Program {

/// writes a mesh in one of the output formats. Coordinates do not change if they are read again.
///
/// To a stream, since a stream tells whether the last byte has been written.
inline void write_soup(std::ostream& out, const std::string& format, const std::vector<Point_3>& points,
                       const std::vector<Polygon>& polygons)
{
  constexpr int digits = 17;
  const auto np = CGAL::parameters::stream_precision(digits);
  out.precision(digits);
  if(format == ".off")
    CGAL::IO::write_OFF(out, points, polygons, np);
  else if(format == ".obj")
    CGAL::IO::write_OBJ(out, points, polygons, np);
  else if(format == ".ts")
    CGAL::IO::write_GOCAD(out, points, polygons, np);
  else
  {
    CGAL::IO::set_binary_mode(out);
    CGAL::IO::write_PLY(out, points, polygons, np);
  }
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SOUP_H
