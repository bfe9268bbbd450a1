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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_AREA_PRESERVING_RADIUS_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_AREA_PRESERVING_RADIUS_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_range_3.h>

#include <array>
#include <cmath>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationRadius
///
/// The class `Area_preserving_radius_3` preserves the total area: the flat image triangles have the same total area as
/// the faces.
///
/// It implements eq. 9 of \cgalCite{cgal:whfl-bspld-16}, \f$ r \leftarrow r \sqrt{\sum A / \sum a} \f$, where \f$ A \f$
/// is the area of a face and \f$ a \f$ the area of its flat image at the radius \f$ r \f$.
///
/// \cgalModels{SphereRadiusPolicy_3}
class Area_preserving_radius_3
{
public:
  /// returns the initial radius `equal_area_radius`, which gives the sphere the area of the surface.
  double initial_radius(double equal_area_radius) const { return equal_area_radius; }

  /// returns the radius that follows `radius`, for any energy, in linear time.
  template <class Energy>
  double operator()(const Energy& /* energy */, const Face_range_3& faces, double radius)
  {
    const auto [area, area_of_image] = faces.sums<2>([](const Face_invariants_3& face) {
      return std::array<double, 2>{face.area, face.area * face.flat_d};
    });
    return radius * std::sqrt(area / area_of_image);
  }
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_AREA_PRESERVING_RADIUS_3_H
