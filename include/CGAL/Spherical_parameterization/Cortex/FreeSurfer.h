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
/// reads a triangle surface of FreeSurfer, such as `lh.white`: points, triangles, the first line, and the footer with the geometry
/// of the volume. Memory is bounded by the size of the file, whatever the numbers in it say.
///
/// \param in the file, in binary mode
/// \param file receives what is in it
/// \param message receives what is wrong with the file, where, and what helps, in one line; empty if nothing is
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged, or of another kind, such as the old quadrangle
///         files; `file` is left as it was then. Coordinates that are not finite are kept.
Error_code read_FreeSurfer_surface(std::istream& in, Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// writes a triangle surface of FreeSurfer: points, rounded to numbers of 32 bits, triangles, the first line, and the
/// footer. Reading and writing a file gives the same bytes.
///
/// \param out the file, in binary mode
/// \param file what is written; values are left out
/// \param message receives why nothing is written, in one line; empty with `OK`
///
/// \return `OK`; `ERROR_OUT_OF_FLOAT_RANGE` if a coordinate is finite but beyond 32-bit numbers; or
///         `ERROR_CANNOT_WRITE_FILE`
Error_code write_FreeSurfer_surface(std::ostream& out, const Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// reads a file of FreeSurfer with one number for each vertex, such as `lh.sulc`, in the present format or the old one, whose
/// numbers are hundredths. It becomes a column without name.
///
/// \param in the file, in binary mode
/// \param file receives what is in it
/// \param message receives what is wrong with the file, where, and what helps, in one line; empty if nothing is
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged, or of another kind; `file` is left as it was then
Error_code read_FreeSurfer_curv(std::istream& in, Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// writes a file of FreeSurfer with one number for each vertex, such as `lh.sulc`, rounded to numbers of 32 bits.
///
/// \param out the file, in binary mode
/// \param values the numbers
/// \param number_of_triangles of the surface, which the file has as well
/// \param message receives why nothing is written, in one line; empty with `OK`
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if a number is not of the type of `values`; `ERROR_OUT_OF_FLOAT_RANGE` if one is too
///         large for 32 bits, or an integer that would lose digits; or `ERROR_CANNOT_WRITE_FILE`
Error_code write_FreeSurfer_curv(std::ostream& out, const Vertex_values& values, std::size_t number_of_triangles,
                                 std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// reads an annotation of FreeSurfer, such as `lh.aparc.annot`, with a colour table of version 1 or 2, or none. It becomes a column
/// without name, whose numbers are the keys of the labels. A colour that vertices have, but not the table, becomes a label without
/// name, of which the message tells; where two structures have the same colour, the first one is meant.
///
/// \param in the file, in binary mode
/// \param file receives what is in it
/// \param message receives what is wrong with the file, where, and what helps, in one line; or, with `OK`, how many
///        vertices have a colour without name, empty if none has
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged, or of another kind; `file` is left as it was then
Error_code read_FreeSurfer_annotation(std::istream& in, Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// writes the first column of a file as an annotation of FreeSurfer, with a colour table of version 2. Labels without
/// name are in no table, but vertices have their colours.
///
/// \param out the file, in binary mode
/// \param file the column and the labels
/// \param message receives why nothing is written, in one line; empty with `OK`
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if the reader would refuse the file or find other labels: there is no column, `vertices` are not those from 0 on, a vertex
///         has a key without label, two labels have the same key, the key of a label with a name is negative or above
///         2<sup>24</sup>, a component of a colour is not from 0 to 1, or a label that a vertex has is of the same colour as one
///         before it; or `ERROR_CANNOT_WRITE_FILE`
Error_code write_FreeSurfer_annotation(std::ostream& out, const Surface_file& file, std::string& message);

/// \ingroup PkgSphericalParameterizationFiles
///
/// reads a label of FreeSurfer, a text such as `lh.cortex.label`: some of the vertices of a surface, and a number for each.
///
/// \param in the file
/// \param file receives the vertices and a column without name
/// \param message receives what is wrong with the file, where, and what helps, in one line; empty if nothing is
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged, or of another kind; `file` is left as it was then
Error_code read_FreeSurfer_label(std::istream& in, Surface_file& file, std::string& message);

} // namespace CGAL::Spherical_parameterization::IO

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Cortex/internal/FreeSurfer_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_FREESURFER_H
