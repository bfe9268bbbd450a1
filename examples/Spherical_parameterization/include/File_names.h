// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FILE_NAMES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FILE_NAMES_H

#include <string>

namespace Program {

/// The names of all files of a mesh.
struct File_names
{
  std::string input;
  std::string sphere, json; ///< empty if not wanted
  std::string colored;      ///< what the names of the coloured meshes begin with, empty if they are not wanted
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_FILE_NAMES_H
