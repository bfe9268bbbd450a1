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
/// Pairs of a name and a value, in the order of the file, such as `AnatomicalStructurePrimary` and `CortexLeft`.
using Metadata = std::vector<std::pair<std::string, std::string>>;

/// \ingroup PkgSphericalParameterizationFiles
///
/// A coordinate system to which the points of a surface can be transformed.
struct Coordinate_system
{
  std::string data_space;        ///< the space of the points, such as `NIFTI_XFORM_UNKNOWN`
  std::string transformed_space; ///< the space after the transformation
  std::array<double, 16> matrix = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}; ///< the transformation, by rows
};

/// \ingroup PkgSphericalParameterizationFiles
///
/// Information in a file about the origin of a surface. A surface computed from another one, such as its sphere,
/// inherits it.
struct Surface_origin
{
  Metadata metadata;                                 ///< metadata of the file
  Metadata metadata_of_points;                       ///< metadata of the points, which include the anatomical structure
  Metadata metadata_of_triangles;                    ///< metadata of the triangles
  std::vector<Coordinate_system> coordinate_systems; ///< coordinate systems of the points
  std::string created_by;                            ///< the first line of a FreeSurfer surface
  std::string footer; ///< the footer of a FreeSurfer surface: the geometry of its volume, and commands
};

/// \ingroup PkgSphericalParameterizationFiles
///
/// Values at the vertices, one number for each vertex.
struct Vertex_values
{
  /// Number types
  enum class Type
  {
    uint8,  ///< 8-bit unsigned integers
    int32,  ///< 32-bit integers, such as keys of labels
    float32 ///< single precision
  };

  std::string name;           ///< may be empty, as in most FreeSurfer files
  std::string intent;         ///< the GIFTI intent, such as `NIFTI_INTENT_SHAPE`
  Type type = Type::float32;  ///< the number type in a file
  std::vector<double> values; ///< the numbers; doubles represent all types exactly
  Metadata metadata;          ///< metadata other than the name
};

/// \ingroup PkgSphericalParameterizationFiles
///
/// The meaning of a key in `Vertex_values`.
struct Label
{
  std::int32_t key;            ///< in an annotation of FreeSurfer, the structure number
  std::string name;            ///< empty for a color that an annotation uses without naming it
  std::array<double, 4> color; ///< red, green, blue and alpha, from 0 to 1
};

/// \ingroup PkgSphericalParameterizationFiles
///
/// Contents of a file of a cortical surface: a surface, values at its vertices, or both.
struct Surface_file
{
  std::vector<std::array<double, 3>> points;           ///< points in the order of the file; empty in a file of values
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of points
  std::vector<Vertex_values> columns;                  ///< columns, all of the same length
  std::vector<std::uint32_t> vertices;                 ///< the vertices of the values; if empty, 0, 1, 2 and so on
  std::vector<Label> labels;                           ///< labels of the columns that contain keys
  Surface_origin origin;                               ///< further information about the surface
};

} // namespace CGAL::Spherical_parameterization::IO

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_SURFACE_FILE_H
