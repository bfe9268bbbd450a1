#ifndef PROGRAM_FILE_CONTENT_H
#define PROGRAM_FILE_CONTENT_H

#include "file_names.h"

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>
#include <CGAL/Spherical_parameterization/internal/files/Polygon_soup.h>

#include <CGAL/Simple_cartesian.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Program {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Polygon = SP::internal::Polygon;
using Values = SP::internal::Property_values;

/// What a file holds: a mesh, values of its vertices and faces, or both, and what is known of where they are from.
struct File_content : SP::internal::Polygon_soup
{
  std::vector<std::uint32_t> vertices = {}; ///< that the values are of, if not all
  std::vector<SP::IO::Label> labels = {};   ///< what whole numbers among the values stand for
  SP::IO::Surface_origin origin = {};       ///< what a file of a cortical surface tells of where that is from
  Hemispheres hemispheres = {};             ///< of the files that this is from
};

/// turns a mesh into what a file of a cortical surface holds, and back, without values.
///
/// \pre all polygons are triangles
SP::IO::Surface_file surface_file_of(const std::vector<Point_3>& points, const std::vector<Polygon>& triangles);
File_content content_of(const SP::IO::Surface_file& file);

} // namespace Program

#endif // PROGRAM_FILE_CONTENT_H
