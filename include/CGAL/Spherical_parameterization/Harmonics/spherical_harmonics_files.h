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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_SPHERICAL_HARMONICS_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_SPHERICAL_HARMONICS_FILES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/internal/library.h>

#include <istream>
#include <ostream>
#include <string>

namespace CGAL::Spherical_parameterization::IO {

/// \ingroup PkgSphericalParameterizationHarmonicsFiles
///
/// reads the coefficients of a surface from a file `.coef` of SPHARM-PDM: `{` their number, and for each of them `{x, y, z}`, by the
/// degree, for each degree the order 0 first and then the cosine and the sine of each order. They are the factors of the real
/// and imaginary parts of complex orthonormal harmonics with the phase of Condon and Shortley; here they become those of real
/// orthonormal harmonics with that phase. Nothing in the file tells if other harmonics were meant.
///
/// \param in the file
/// \param harmonics receives the coefficients
/// \param message receives what is wrong with the file, where, and what helps, in one line; empty if nothing is
///
/// \return `OK`, or `ERROR_INVALID_HARMONICS_FILE` if the file is damaged, or of another kind; `harmonics` is as it was then
Error_code read_SPHARM_PDM(std::istream& in, Spherical_harmonics_3& harmonics, std::string& message);

/// \ingroup PkgSphericalParameterizationHarmonicsFiles
///
/// writes the coefficients of a surface as SPHARM-PDM does, with all digits.
///
/// \param out the file
/// \param harmonics three functions, with any normalization
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if there are not three functions; or `ERROR_CANNOT_WRITE_FILE`
Error_code write_SPHARM_PDM(std::ostream& out, const Spherical_harmonics_3& harmonics);

/// \ingroup PkgSphericalParameterizationHarmonicsFiles
///
/// reads coefficients from a table that `write_harmonics_table()` or another program has written: lines of fields between commas,
/// quoted or not, in any order, with the names of the columns in the first one.
///
/// \param in the file
/// \param harmonics receives the coefficients
/// \param message receives what is wrong with the file, where, and what helps, in one line; empty if nothing is
///
/// \return `OK`, or `ERROR_INVALID_HARMONICS_FILE` if the file is damaged, or of another kind; `harmonics` is as it was then
Error_code read_harmonics_table(std::istream& in, Spherical_harmonics_3& harmonics, std::string& message);

/// \ingroup PkgSphericalParameterizationHarmonicsFiles
///
/// writes coefficients as a table for R, pandas and spreadsheets: a line for each degree and order, the sines with negative orders.
/// Its columns are `degree` and `order`; one for each function, `x`, `y` and `z` if there are three and `f1`, `f2` and so on otherwise;
/// and, the same in all lines and in the words of pyshtools, `normalization`, which is `4pi`, `ortho` or `schmidt`, and `csphase`, -1
/// with the phase of Condon and Shortley and 1 without.
///
/// \param out the file
/// \param harmonics the coefficients, which are written as they are
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if there is no function; or `ERROR_CANNOT_WRITE_FILE`
Error_code write_harmonics_table(std::ostream& out, const Spherical_harmonics_3& harmonics);

} // namespace CGAL::Spherical_parameterization::IO

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Harmonics/internal/spherical_harmonics_files_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_SPHERICAL_HARMONICS_FILES_H
