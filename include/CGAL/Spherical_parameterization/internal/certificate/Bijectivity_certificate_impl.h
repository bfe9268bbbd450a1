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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_BIJECTIVITY_CERTIFICATE_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_BIJECTIVITY_CERTIFICATE_IMPL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <vector>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INLINE bool are_bijective(const Index_triangles& triangles,
                                                          const std::vector<Vector_3d>& points,
                                                          const Execution& execution)
{
  return certify_bijectivity<Double_points>(points, triangles, execution).is_bijective();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_BIJECTIVITY_CERTIFICATE_IMPL_H
