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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Distortion_statistics.h>

#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The distortion of a map from a mesh to the sphere, summed up over its faces.
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
struct Distortion_summary
{
  Distortion_statistics isometric; ///< statistics of `Face_distortion::isometric`
  Distortion_statistics area;      ///< statistics of `Face_distortion::area`
  Distortion_statistics angle;     ///< statistics of `Face_distortion::angle`

  /// the radius of the sphere: the average distance of the images from the origin.
  double radius = 0.;

  /// all faces of the mesh.
  std::size_t number_of_faces = 0;

  /// faces whose isometric distortion is above the bound that was asked for; degenerate faces are not among them.
  std::size_t number_of_faces_above_bound = 0;

  /// faces whose image is not positively oriented about the origin; degenerate faces may be among them.
  std::size_t number_of_inverted_faces = 0;

  /// faces that are so thin that they have no distortion; they are left out of the statistics.
  std::size_t number_of_degenerate_faces = 0;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
