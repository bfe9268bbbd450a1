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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAP_SETTINGS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAP_SETTINGS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <boost/graph/graph_traits.hpp>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

/// \file Surface_map_settings.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// What is known of two surfaces before `map_surface()` maps one onto the other. What is left out, it finds itself.
///
/// \tparam TriangleMesh1 the type of the first surface
/// \tparam TriangleMesh2 the type of the second one
template <class TriangleMesh1, class TriangleMesh2>
struct Surface_map_settings
{
  /// Type of a vertex of the first surface
  using Vertex_1 = typename boost::graph_traits<TriangleMesh1>::vertex_descriptor;

  /// Type of a vertex of the second surface
  using Vertex_2 = typename boost::graph_traits<TriangleMesh2>::vertex_descriptor;

  /// Vertices that correspond. With two or more in different directions, they alone decide how the spheres are turned.
  std::vector<std::pair<Vertex_1, Vertex_2>> landmarks;

  /// If there is none, landmarks are met exactly, but where straight edges do not allow for it. With a weight, which has to
  /// be positive, they are soft: the mean of their squared distances, on a sphere of radius 1, is added to the mean energy,
  /// so many times. A weight of 10 is a strong one.
  std::optional<double> landmark_weight;

  /// Features of the surfaces that are to agree, each as two functions of a vertex. If there are none, the package has its
  /// own, unless landmarks turn the spheres. Only the order of their values counts, and they are seen through a grid of 4002
  /// directions.
  std::vector<std::pair<std::function<double(Vertex_1)>, std::function<double(Vertex_2)>>> features;

  /// Features align the spheres, and then the mean of the squared differences of their ranks, which are from -1 to 1, is
  /// added to the mean energy, so many times; for features of the package, times the fourth power of their agreement. With
  /// 0, features only align the spheres.
  double feature_weight = 4.;

  /// If it is not empty, it is called before each sweep over the first surface, by the thread that has called
  /// `map_surface()`. Once it returns `false`, there are no more sweeps: the map that has been reached is certified and
  /// returned. With a clock in it, it is a time limit, but for the alignment, which comes before the first sweep. Landmarks
  /// may be missed then that more sweeps would have met. Where the spheres agree as they are, there are no sweeps.
  std::function<bool()> go_further;
};

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAP_SETTINGS_H
