// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_RUNS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_RUNS_H

// Runs of parameterizers, with what every one of them promises checked on the way.

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include "test_maps.h"
#include "test_meshes.h"

#include <CGAL/Named_function_parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_runs {

using test_meshes::Coordinates;

struct Result
{
  CGAL::Spherical_parameterization::Error_code error;
  CGAL::Spherical_parameterization::Parameterization_report report;
  std::vector<Coordinates> images;
  CGAL::Spherical_parameterization::Distortion_summary distortion; // if a map has been written
};

// Runs the parameterizer on the mesh. Whatever comes out is sound: a bijection and OK, a map that folds and
// ERROR_NO_1_TO_1_MAPPING if the method `may_fold`, or another code and an untouched map.
template <class Point, class Mesh, class Parameterizer, class NamedParameters>
Result run(const Mesh& mesh, Parameterizer& parameterizer, bool may_fold, const NamedParameters& np)
{
  namespace SP = CGAL::Spherical_parameterization;
  const auto map = test_maps::make_sentinel_map<Point>(mesh);
  const std::vector<Coordinates> untouched = test_maps::images(mesh, map);
  Result result;
  result.error = parameterizer.parameterize(mesh, map, np);
  result.report = parameterizer.report();
  result.images = test_maps::images(mesh, map);
  if(result.error == SP::OK || (may_fold && result.error == SP::ERROR_NO_1_TO_1_MAPPING))
  {
    EXPECT_EQ(SP::is_bijective(mesh, map), result.error == SP::OK);
    result.distortion = SP::measure_distortion(mesh, map);
    EXPECT_EQ(result.distortion.number_of_inverted_faces == 0, result.error == SP::OK);
    // All vertices are on the sphere; those without a face stay where they are.
    const double radius = result.report.radius;
    std::size_t n_on_sphere = 0, n_untouched = 0;
    for(std::size_t v = 0; v < untouched.size(); ++v)
    {
      n_on_sphere += std::abs(test_maps::norm(result.images[v]) - radius) <= 1e-15 * radius;
      n_untouched += result.images[v] == untouched[v];
    }
    EXPECT_EQ(n_on_sphere, result.report.number_of_vertices);
    EXPECT_EQ(n_untouched, result.report.number_of_isolated_vertices);
    EXPECT_EQ(n_on_sphere + n_untouched, untouched.size());
  }
  else
  {
    EXPECT_NE(result.error, SP::ERROR_NO_1_TO_1_MAPPING);
    EXPECT_TRUE(test_maps::have_same_bits(result.images, untouched));
  }
  return result;
}

template <class Point, class Mesh, class Parameterizer>
Result run(const Mesh& mesh, Parameterizer& parameterizer, bool may_fold)
{
  return run<Point>(mesh, parameterizer, may_fold, CGAL::parameters::default_values());
}

// The largest difference of the distances of two points under two maps that may be turned against each other.
inline double largest_difference_up_to_rotation(const std::vector<Coordinates>& a, const std::vector<Coordinates>& b)
{
  double result = a.size() == b.size() ? 0. : HUGE_VAL;
  for(std::size_t v = 0; v < (std::min)(a.size(), b.size()); ++v)
  {
    for(std::size_t k = 1; k < 20; ++k)
    {
      const std::size_t w = (v + k * k * k) % a.size();
      const double d = std::abs(test_maps::distance(a[v], a[w]) - test_maps::distance(b[v], b[w]));
      result = d > result || d != d ? d : result;
    }
  }
  return result;
}

} // namespace test_runs

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_RUNS_H
