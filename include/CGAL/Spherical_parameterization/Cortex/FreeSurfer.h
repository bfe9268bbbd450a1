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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_FREESURFER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_FREESURFER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/library.h>

#include <cstddef>
#include <istream>
#include <ostream>
#include <string>

namespace CGAL::Spherical_parameterization::IO {

/// \ingroup PkgSphericalParameterizationFiles
///
/// reads a triangle surface of FreeSurfer, such as `lh.white`.
///
/// The function reads the points, the triangles, the first line, and the footer with the geometry of the volume.
/// Coordinates that are not finite are kept. Memory is bounded by the size of the file, even if the numbers in it are
/// wrong.
///
/// \param in the file, in binary mode
/// \param file receives the contents
/// \param message receives one line that states the error, its location and a remedy; empty if there is no error
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged or has another format, such as the old
///         quadrangle format; `file` is then unchanged
Error_code read_FreeSurfer_surface(std::istream& in, Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// writes a triangle surface of FreeSurfer: points, rounded to single precision, triangles, the first line, and the
/// footer.
///
/// A file that is read and written again has the same bytes.
///
/// \param out the file, in binary mode
/// \param file the surface; values at vertices are not written
/// \param message receives one line that states the error; empty with `OK`
///
/// \return `OK`; `ERROR_OUT_OF_FLOAT_RANGE` if a finite coordinate is outside the range of single precision; or
///         `ERROR_CANNOT_WRITE_FILE`
Error_code write_FreeSurfer_surface(std::ostream& out, const Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// reads a curv file of FreeSurfer, which has one number per vertex, such as `lh.sulc`. Both the current format and the
/// old one, in which numbers are integers in units of 0.01, are supported. The values become a column without a name.
///
/// \param in the file, in binary mode
/// \param file receives the contents
/// \param message receives one line that states the error, its location and a remedy; empty if there is no error
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged or has another format; `file` is then unchanged
Error_code read_FreeSurfer_curv(std::istream& in, Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// writes a curv file of FreeSurfer, which has one number per vertex, such as `lh.sulc`. The numbers are rounded to
/// single precision.
///
/// \param out the file, in binary mode
/// \param values the numbers
/// \param number_of_triangles the number of triangles of the surface, which is stored in the file
/// \param message receives one line that states the error; empty with `OK`
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if a number does not have the type of `values`; `ERROR_OUT_OF_FLOAT_RANGE` if
///         a number is outside the range of single precision, or an integer would lose digits; or
///         `ERROR_CANNOT_WRITE_FILE`
Error_code write_FreeSurfer_curv(std::ostream& out, const Vertex_values& values, std::size_t number_of_triangles,
                                 std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// reads an annotation of FreeSurfer, such as `lh.aparc.annot`, with a color table of version 1 or 2, or without one.
///
/// The annotation becomes a column without a name, whose numbers are the keys of the labels. A color that is used by
/// vertices but missing in the table becomes a label without a name. If two structures have the same color, the color
/// denotes the first one.
///
/// \param in the file, in binary mode
/// \param file receives the contents
/// \param message receives one line. On an error, it states the error, its location and a remedy. With `OK`, it states
///         the number of vertices whose color is missing in the table; it is empty if there are none.
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged or has another format; `file` is then unchanged
Error_code read_FreeSurfer_annotation(std::istream& in, Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// writes the first column of a file as an annotation of FreeSurfer with a color table of version 2. Labels without a
/// name are not in the table, but vertices have their colors.
///
/// \param out the file, in binary mode
/// \param file the column and the labels
/// \param message receives one line that states the error; empty with `OK`
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if the reader would reject the file or return other labels: there is no
///         column, `vertices` is neither empty nor 0, 1, 2 and so on, a vertex has a key without a label, two labels
///         have the same key, the key of a label with a name is negative or larger than 2<sup>24</sup>, a color
///         component is not between 0 and 1, or a label that is used by a vertex has the same color as an earlier
///         label; or `ERROR_CANNOT_WRITE_FILE`
Error_code write_FreeSurfer_annotation(std::ostream& out, const Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// reads a label file of FreeSurfer, such as `lh.cortex.label`: a text with a subset of the vertices of a surface and a
/// number for each of them.
///
/// \param in the file
/// \param file receives the vertices, and the numbers as a column without a name
/// \param message receives one line that states the error, its location and a remedy; empty if there is no error
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged or has another format; `file` is then unchanged
Error_code read_FreeSurfer_label(std::istream& in, Surface_file& file, std::string& message);

} // namespace CGAL::Spherical_parameterization::IO

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Cortex/internal/FreeSurfer_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_FREESURFER_H
