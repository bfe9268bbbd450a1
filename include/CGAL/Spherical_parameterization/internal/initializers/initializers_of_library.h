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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_INITIALIZERS_OF_LIBRARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_INITIALIZERS_OF_LIBRARY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/initializers/ARAP_map.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Harmonic_map.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Stereographic_embedding.h>
#include <CGAL/Spherical_parameterization/internal/surface/Run.h>

#include <CGAL/Default.h>

#include <cstddef>

namespace CGAL::Spherical_parameterization::internal {

// The methods that solve linear systems that are in the library, by the default solver, see descents_of_library.h.

#define CGAL_SPHERICAL_PARAMETERIZATION_INITIALIZERS(EXTERN)                                                           \
  EXTERN template Error_code embed_stereographically<Default>(Run&, bool);                                             \
  EXTERN template Error_code map_harmonically<Default>(Run&, bool, std::size_t);                                       \
  EXTERN template Error_code lower_energy<Default>(ARAP_map, std::size_t, Run&);

CGAL_SPHERICAL_PARAMETERIZATION_INITIALIZERS(extern)

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INITIALIZERS_INITIALIZERS_OF_LIBRARY_H
