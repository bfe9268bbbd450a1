// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_AREA_BALANCING_RADIUS_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_AREA_BALANCING_RADIUS_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <cmath>

/// \file Area_balancing_radius_3.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationRadius
///
/// The class `Area_balancing_radius_3` minimises the area distortion \f$ \sum (d + 1/d) \f$ of the flat image triangles
/// over the radius (eq. 11): \f$ r \leftarrow r \left( \sum (A/a) / \sum (a/A) \right)^{1/4} \f$. It is the radius at
/// which distortions of spherical parameterizations are usually compared.
///
/// \cgalModels{SphereRadiusPolicy_3}
class Area_balancing_radius_3
{
public:
  /// returns `true`: there is no parameter.
  bool is_valid() const { return true; }

  /// returns the radius to start with: that of the sphere which has the area of the surface (eq. 10).
  double initial_radius(double equal_area_radius) const { return equal_area_radius; }

  /// returns the radius that follows `radius`, given the faces as they are on the sphere of that radius.
  template <class Energy, class FaceRange>
  double operator()(const Energy& /* energy */, const FaceRange& faces, double radius)
  {
    double sum = 0., sum_of_inverses = 0.;
    for(const auto& face : faces)
    {
      sum += face.flat_d;
      sum_of_inverses += 1. / face.flat_d;
    }
    return radius * std::sqrt(std::sqrt(sum_of_inverses / sum));
  }
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_AREA_BALANCING_RADIUS_3_H
