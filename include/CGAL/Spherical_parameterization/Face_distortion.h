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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FACE_DISTORTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FACE_DISTORTION_H

#include <CGAL/license/Spherical_parameterization.h>

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The distortion of a face of a mesh by a map to the sphere. The map sends the face to a flat triangle by a linear map
/// with singular values \f$ s_1 \leq s_2 \f$. Each of the measures is invariant under inversion, that is, stretching a
/// length, an area or a ratio of lengths by a factor is as bad as shrinking it by the same factor.
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
struct Face_distortion
{
  /// \f$ \max(s_2, 1 / s_1) \f$: the largest factor by which a length is stretched or shrunk. At least 1, and 1 for an
  /// isometry.
  double isometric;

  /// \f$ s_1 s_2 + 1 / (s_1 s_2) \f$: how the area changes. At least 2, and 2 if it stays the same.
  double area;

  /// \f$ s_1 / s_2 + s_2 / s_1 \f$: how the angles change. At least 2, and 2 for a similarity.
  double angle;

  /// whether the image is not positively oriented about the origin, by an exact predicate on the points in the map.
  bool is_inverted;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FACE_DISTORTION_H
