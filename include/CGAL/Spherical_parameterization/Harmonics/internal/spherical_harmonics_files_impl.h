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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERICAL_HARMONICS_FILES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERICAL_HARMONICS_FILES_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/Coefficient_text.h>
#include <CGAL/Spherical_parameterization/Harmonics/spherical_harmonics_files.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <istream>
#include <ostream>
#include <string>

namespace CGAL::Spherical_parameterization::IO {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_SPHARM_PDM(std::istream& in, Spherical_harmonics_3& harmonics,
                                                                  std::string& message)
{
  return internal::read_or_tell(
      harmonics, message,
      [&](Spherical_harmonics_3& result, std::string&) { result = internal::read_coef(internal::read_all(in)); },
      ERROR_INVALID_HARMONICS_FILE);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_SPHARM_PDM(std::ostream& out,
                                                                   const Spherical_harmonics_3& harmonics)
{
  if(harmonics.number_of_functions() != 3)
    return ERROR_WRONG_PARAMETER;
  return internal::is_written(out, internal::coef_text(harmonics)) ? OK : ERROR_CANNOT_WRITE_FILE;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code read_harmonics_table(std::istream& in,
                                                                       Spherical_harmonics_3& harmonics,
                                                                       std::string& message)
{
  return internal::read_or_tell(
      harmonics, message,
      [&](Spherical_harmonics_3& result, std::string&) { result = internal::read_table(internal::read_all(in)); },
      ERROR_INVALID_HARMONICS_FILE);
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE Error_code write_harmonics_table(std::ostream& out,
                                                                        const Spherical_harmonics_3& harmonics)
{
  if(harmonics.number_of_functions() == 0)
    return ERROR_WRONG_PARAMETER;
  return internal::is_written(out, internal::table_text(harmonics)) ? OK : ERROR_CANNOT_WRITE_FILE;
}

} // namespace CGAL::Spherical_parameterization::IO

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_INTERNAL_SPHERICAL_HARMONICS_FILES_IMPL_H
