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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>

#include <cstddef>

/// \file Distortion_summary.h

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

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The statistics of one measure of distortion over the faces of a mesh, each face counting the same whatever its area.
///
/// If the distortion of a face is infinite, all three numbers are. They are 0 if there is no face.
///
/// \sa `CGAL::Spherical_parameterization::Distortion_summary`
struct Distortion_statistics
{
  double maximum = 0.;   ///< the largest value
  double average = 0.;   ///< the arithmetic mean
  double deviation = 0.; ///< the standard deviation, the square root of the mean squared difference from the average
};

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The distortion of a map from a mesh to the sphere, summed up over its faces.
///
/// \sa `CGAL::Spherical_parameterization::measure_distortion()`
struct Distortion_summary
{
  /// `OK`, or `ERROR_NON_TRIANGULAR_MESH` if a face is no triangle; nothing has been measured then.
  Error_code error = OK;

  Distortion_statistics isometric; ///< statistics of `Face_distortion::isometric`
  Distortion_statistics area;      ///< statistics of `Face_distortion::area`
  Distortion_statistics angle;     ///< statistics of `Face_distortion::angle`

  /// the radius of the sphere: the average distance of the images from the origin.
  double radius = 0.;

  /// all faces of the mesh.
  std::size_t number_of_faces = 0;

  /// faces whose image is not positively oriented about the origin; degenerate faces may be among them.
  std::size_t number_of_inverted_faces = 0;

  /// faces that are so thin that they have no distortion; they are left out of the statistics.
  std::size_t number_of_degenerate_faces = 0;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
