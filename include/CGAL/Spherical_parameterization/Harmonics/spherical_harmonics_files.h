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
/// reads the coefficients of a surface from a `.coef` file of SPHARM-PDM.
///
/// The file contains `{`, the number of coefficients, and a triple `{x, y, z}` for each coefficient, sorted by degree.
/// Within a degree, the order 0 comes first, followed by the cosine and the sine of each order. The coefficients in the
/// file multiply the real and imaginary parts of complex orthonormal harmonics with the Condon-Shortley phase. They are
/// converted to real orthonormal harmonics with this phase. The file does not record its convention, so files with
/// other conventions are not detected.
///
/// \param in the file
/// \param harmonics receives the coefficients
/// \param message receives one line that states the error, its location and a remedy; empty if there is no error
///
/// \return `OK`, or `ERROR_INVALID_HARMONICS_FILE` if the file is damaged or has another format; `harmonics` is then
///         unchanged
Error_code read_SPHARM_PDM(std::istream& in, Spherical_harmonics_3& harmonics, std::string& message);

/// \ingroup PkgSphericalParameterizationHarmonicsFiles
///
/// writes the coefficients of a surface to a `.coef` file of SPHARM-PDM, with all digits. See `read_SPHARM_PDM()` for
/// the format.
///
/// \param out the file
/// \param harmonics three functions, in any normalization
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if the number of functions is not three; or `ERROR_CANNOT_WRITE_FILE`
Error_code write_SPHARM_PDM(std::ostream& out, const Spherical_harmonics_3& harmonics);

/// \ingroup PkgSphericalParameterizationHarmonicsFiles
///
/// reads coefficients from a table, as written by `write_harmonics_table()` or another program. The fields of a line
/// are separated by commas and may be quoted. The first line has the names of the columns; the other lines may be in
/// any order.
///
/// \param in the file
/// \param harmonics receives the coefficients
/// \param message receives one line that states the error, its location and a remedy; empty if there is no error
///
/// \return `OK`, or `ERROR_INVALID_HARMONICS_FILE` if the file is damaged or has another format; `harmonics` is then
///         unchanged
Error_code read_harmonics_table(std::istream& in, Spherical_harmonics_3& harmonics, std::string& message);

/// \ingroup PkgSphericalParameterizationHarmonicsFiles
///
/// writes coefficients as a table for R, pandas and spreadsheets, one line for each degree and order; sines have
/// negative orders.
///
/// The columns are:
/// - `degree` and `order`,
/// - one for each function: `x`, `y` and `z` for three functions, otherwise `f1`, `f2` and so on,
/// - `normalization`: `4pi`, `ortho` or `schmidt`, the same in all lines,
/// - `csphase`: -1 with the Condon-Shortley phase and 1 without, the same in all lines.
///
/// The names and values of the last two columns are those of pyshtools.
///
/// \param out the file
/// \param harmonics the coefficients, which are written without conversion
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if there is no function; or `ERROR_CANNOT_WRITE_FILE`
Error_code write_harmonics_table(std::ostream& out, const Spherical_harmonics_3& harmonics);

} // namespace CGAL::Spherical_parameterization::IO

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Harmonics/internal/spherical_harmonics_files_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_SPHERICAL_HARMONICS_FILES_H
