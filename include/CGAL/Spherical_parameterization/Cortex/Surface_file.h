// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_SURFACE_FILE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_SURFACE_FILE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::IO {

/// \ingroup PkgSphericalParameterizationFiles
///
/// Names and values, in the order of the file, such as `AnatomicalStructurePrimary` and `CortexLeft`.
using Metadata = std::vector<std::pair<std::string, std::string>>;

/// \ingroup PkgSphericalParameterizationFiles
///
/// A system that the points of a surface can be in.
struct Coordinate_system
{
  std::string data_space;        ///< what the points are in, such as `NIFTI_XFORM_UNKNOWN`
  std::string transformed_space; ///< what the matrix leads to
  std::array<double, 16> matrix = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}; ///< row by row
};

/// \ingroup PkgSphericalParameterizationFiles
///
/// What a file tells of where its surface is from. A surface that is made of another one, such as its sphere, inherits it.
struct Surface_origin
{
  Metadata metadata;                                 ///< of the file
  Metadata metadata_of_points;                       ///< among them what part of the body the surface is of
  Metadata metadata_of_triangles;                    ///< of the array of triangles
  std::vector<Coordinate_system> coordinate_systems; ///< of the points
  std::string created_by;                            ///< the first line of a FreeSurfer surface
  std::string footer; ///< the bytes behind a FreeSurfer surface: the geometry of the volume that it is in, and commands
};

/// \ingroup PkgSphericalParameterizationFiles
///
/// A number for each vertex.
struct Vertex_values
{
  /// The type of the numbers.
  enum class Type
  {
    uint8,  ///< bytes
    int32,  ///< whole numbers, and keys of labels
    float32 ///< fractions
  };

  std::string name;           ///< which may be empty, as most FreeSurfer files have none
  std::string intent;         ///< what GIFTI files say that the numbers are, such as `NIFTI_INTENT_SHAPE`
  Type type = Type::float32;  ///< what they are written as
  std::vector<double> values; ///< as they are in the file, as a double can hold all of them
  Metadata metadata;          ///< but the name
};

/// \ingroup PkgSphericalParameterizationFiles
///
/// What a key of `Vertex_values` stands for.
struct Label
{
  std::int32_t key;            ///< in an annotation of FreeSurfer, the number of the structure
  std::string name;            ///< empty for a colour that an annotation uses, but does not name
  std::array<double, 4> color; ///< red, green, blue and alpha, from 0 to 1
};

/// \ingroup PkgSphericalParameterizationFiles
///
/// What a file of a cortical surface holds: a surface, or values of the vertices of one, or both.
struct Surface_file
{
  std::vector<std::array<double, 3>> points;           ///< in the order of the file; none in a file of values
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< by the indices of points
  std::vector<Vertex_values> columns;                  ///< of the same length all
  std::vector<std::uint32_t> vertices;                 ///< that the values are of; empty: those from 0 on
  std::vector<Label> labels;                           ///< of the columns that hold keys
  Surface_origin origin;                               ///< what else is known of the surface
};

} // namespace CGAL::Spherical_parameterization::IO

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_SURFACE_FILE_H
