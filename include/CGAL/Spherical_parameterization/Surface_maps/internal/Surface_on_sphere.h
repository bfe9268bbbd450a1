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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_ON_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_ON_SPHERE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The kernel of all images on spheres that are compared with other spheres.
using Sphere_kernel = Exact_predicates_inexact_constructions_kernel;

// A surface and its map to the sphere as read, in the order of the caller.
struct Surface_on_sphere
{
  std::vector<Vector_3d> points;
  std::vector<Sphere_kernel::Point_3> images;
  std::vector<Linked_triangle> triangles;
};

// A surface, the directions of its images, and optional features, in the order of the caller.
struct Surface_to_align
{
  std::vector<Vector_3d> points, directions;
  std::vector<Linked_triangle> triangles;
  std::vector<std::vector<double>> features;
};

// The triangulated common refinement of two surfaces, with the points of its vertices on both surfaces.
struct Overlay_arrays
{
  std::array<std::vector<Vector_3d>, 2> points; // on each surface
  Index_triangles triangles;
  std::vector<std::array<std::uint32_t, 2>> parents; // the face of each surface that contains each triangle
};

// The settings of Surface_mapper_3: all information about two surfaces except their shapes.
struct Surface_map_settings
{
  std::optional<double> landmark_weight; // without a weight, landmarks are hard: they are to be met exactly
  double feature_weight = 4.;
  std::vector<double> feature_weights; // of each feature; empty if all are equal
  bool compares_values = false;        // compares values of these features instead of ranks
  bool keeps_alignment = false;        // keeps the current rotations of the spheres

  // The values at the vertices of both surfaces. Each run reads them in the order of the caller; prepare_features() converts
  // features and masks to the internal order of the surfaces. Landmarks stay in the order of the caller.
  std::array<std::vector<std::vector<double>>, 2> features; // if empty, the features of the package are used
  std::array<std::vector<char>, 2> masks;                   // nonzero at excluded vertices; empty if none is excluded
  std::vector<std::array<std::uint32_t, 2>> landmarks;

  bool has_hard_landmarks() const { return !landmark_weight; }

  bool are_valid(std::size_t n_features) const
  {
    const bool are_weights =
        std::all_of(feature_weights.begin(), feature_weights.end(), [](double w) { return w >= 0. && is_finite(w); });
    const double sum = std::accumulate(feature_weights.begin(), feature_weights.end(), 0.);
    return (!landmark_weight || is_positive_and_finite(*landmark_weight)) && feature_weight >= 0. &&
           is_finite(feature_weight) &&
           (feature_weights.empty() ||
            (feature_weights.size() == n_features && are_weights && is_positive_and_finite(sum)));
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_SURFACE_ON_SPHERE_H
