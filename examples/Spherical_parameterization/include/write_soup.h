// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SOUP_H

#include "file_format.h"

#include <CGAL/IO/GOCAD.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/io.h>

#include <ostream>
#include <string>

namespace Program {

/// writes a polygon soup in one of the output formats, as `CGAL::IO::write_polygon_soup()` does for a file: a stream tells
/// whether the last byte has been written. Coordinates do not change if they are read again.
template <class PointRange, class PolygonRange>
void write_soup(std::ostream& out, const std::string& format, const PointRange& points, const PolygonRange& polygons)
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
