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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_ROTATION_SEARCH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_ROTATION_SEARCH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Sampling/internal/Subdivided_solid.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Surface_descriptor.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/map_score.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A rotation of the first sphere and its score; higher is better.
struct Scored_rotation
{
  Rotation_matrix rotation;
  double score;
};

// At most n rotations that are at least this angle apart, in the order of decreasing score.
template <class Rotation>
std::vector<Rotation> select_rotations(std::vector<Rotation> found, std::size_t n, double min_angle)
{
  std::stable_sort(found.begin(), found.end(), [](const Rotation& a, const Rotation& b) { return a.score > b.score; });
  const double max_cosine = cosine(min_angle);
  std::vector<Rotation> result;
  for(const Rotation& candidate : found)
    if(result.size() < n && std::all_of(result.begin(), result.end(), [&](const Rotation& other) {
         return cosine_between(candidate.rotation, other.rotation) <= max_cosine;
       }))
      result.push_back(candidate);
  return result;
}

// Searches all rotations: those of a grid, followed by local refinement of the best ones.
class Rotation_search
{
public:
  // The second surface is given by the image of its features.
  Rotation_search(const Surface_descriptor& first, const Sphere_image& second, const Execution& execution)
    : m_b(second)
    , m_row(Sphere_image::row_size(first.features().size()))
    , m_execution(execution)
    // The numbers of parts of an edge of the icosahedron: 492 directions that are 9 degrees apart, like the rotations of the grid,
    // and 4002 directions that are 3 degrees apart. Fewer directions take less time, but make the result less reliable.
    , m_few(first, 7, execution)
    , m_all(first, 20, execution)
  {}

  // The best rotations that are at least 20 degrees apart, in the order of decreasing score. If the control stops the search, the
  // best rotations that have been tried, or the identity.
  std::vector<Scored_rotation> best(std::size_t n, Run_control& control) const
  {
    // Refinements of the same local maximum end closer together; two poses of a body differ by more.
    constexpr double min_angle = CGAL_PI / 9.;
    constexpr std::size_t batch_size = 4; // between two calls of the control: for four threads, a few milliseconds
    std::vector<Scored_rotation> found = local_maxima(control);
    for(std::size_t k = 0; k < found.size() && control.go_further(0, 0.); k += batch_size)
      for_each_block(m_execution, k, (std::min)(k + batch_size, found.size()), 1,
                     [&](std::size_t i, std::size_t) { found[i] = refined(found[i].rotation); });
    return select_rotations(std::move(found), n, min_angle);
  }

private:
  // Alexa's super-Fibonacci spirals cover all rotations evenly: here to about 10 degrees.
  static std::vector<Quaternion> rotations_of_grid()
  {
    constexpr std::size_t n = 12000; // Halving the spacing requires eight times as many.
    constexpr double phi = 1.41421356237309504880,
                     psi = 1.533751168755204288118; // phi^2 = 2, psi^4 = psi + 4, from Alexa's paper
    std::vector<Quaternion> result;
    for(std::size_t i = 0; i < n; ++i)
    {
      const double s = static_cast<double>(i) + 0.5, t = s / n, d = 2. * CGAL_PI * s;
      const double r = std::sqrt(t), R = std::sqrt(1. - t);
      result.push_back({r * sine(d / phi), r * cosine(d / phi), R * sine(d / psi), R * cosine(d / psi)});
    }
    return result;
  }

  // The local maxima of the score on the grid, because rotations near the highest maximum score higher than most other maxima. The
  // best one comes first.
  std::vector<Scored_rotation> local_maxima(Run_control& control) const
  {
    constexpr std::size_t batch_size = 2000,
                          block_size = 100; // between two calls of the control, a few milliseconds; and per thread
    // The neighborhood of a local maximum, slightly larger than the spacing of the grid. With a smaller radius, rotations near the
    // same maximum are found instead of other maxima; with a larger one, maxima near a higher one are lost.
    constexpr double max_radius = CGAL_PI / 12.;
    // The score of a maximum on the grid may be lower than the score after refinement, so several maxima are refined, at the cost of
    // time. Rotations below the best quarter are ignored, because the time grows with the square of their number.
    constexpr std::size_t n_examined = 3000, n_found = 16;
    const std::vector<Quaternion> starts = rotations_of_grid();
    std::vector<double> scores;
    while(scores.size() < starts.size() && control.go_further(0, 0.))
    {
      const std::size_t begin = scores.size();
      scores.resize((std::min)(begin + batch_size, starts.size()));
      for_each_block(m_execution, begin, scores.size(), block_size, [&](std::size_t first, std::size_t last) {
        for(std::size_t i = first; i < last; ++i)
          scores[i] = score(rotation_matrix(starts[i]), m_few);
      });
    }
    if(scores.empty())
      return {{rotation_matrix({1., 0., 0., 0.}), 0.}};
    std::vector<std::size_t> order(scores.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return scores[i] > scores[j]; });
    const double min_cosine = cosine(0.5 * max_radius);
    std::vector<Scored_rotation> found;
    for(std::size_t i = 0; i < (std::min)(n_examined, order.size()) && found.size() < n_found; ++i)
    {
      const Quaternion& q = starts[order[i]];
      const bool is_maximum =
          std::none_of(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(i), [&](std::size_t j) {
            const Quaternion& p = starts[j];
            return std::abs(p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3]) > min_cosine;
          });
      if(is_maximum)
        found.push_back({rotation_matrix(q), scores[order[i]]});
    }
    return found;
  }

  // The features of the first surface in directions that cover the sphere evenly, except excluded regions.
  struct Samples
  {
    Samples(const Surface_descriptor& surface, std::uint32_t n_steps, const Execution& execution)
    {
      const auto& triangles = surface.sphere().triangles();
      const std::vector<Vector_3d> all = subdivided_icosahedron(n_steps).directions;
      const auto locations = surface.sphere().locate(points_of(all), execution);
      for(std::size_t i = 0; i < all.size(); ++i)
        if(surface.counts(nearest_vertex(triangles, locations[i])))
        {
          ++size;
          for(std::size_t k = 0; k < 3; ++k)
            directions[k].push_back(all[i][k]);
          for(const Vertex_scalars& channel : surface.features())
          {
            values.push_back(interpolated(channel, triangles, locations[i]));
            squares += values.back() * values.back();
          }
          values.resize(size * Sphere_image::row_size(surface.features().size()), 0.);
        }
      for(std::vector<double>& coordinates : directions)
        coordinates.resize(size + max_lanes, 1.); // This many coordinates are loaded at once.
    }

    std::size_t size = 0;
    std::array<std::vector<double>, 3> directions; // one array per coordinate
    std::vector<double> values;                    // in rows as in the image
    double squares = 0.;                           // the sum of their squares
  };

  double score(const Rotation_matrix& r, const Samples& samples) const
  {
    using Sums = Four_lanes; // a single sum would wait for each addition
    Sums ab = 0., bb = 0.;
    run_in_lanes<max_lanes>([&](auto number_type) {
      using FT = typename decltype(number_type)::FT;
      constexpr std::size_t width = Lanes<FT>::width;
      Sums products = 0., squares = 0.;
      for(std::size_t i = 0; i < samples.size; i += width)
      {
        Vector_3<FT> p;
        for(std::size_t k = 0; k < 3; ++k)
          p[k] = Lanes<FT>::load(&samples.directions[k][i]);
        const auto nearest = m_b.nearest(rotated(r, p));
        for(std::size_t l = 0; l < width && i + l < samples.size; ++l)
          for(std::size_t k = 0; k < m_row; k += Lanes<Sums>::width)
          {
            const Sums a = Lanes<Sums>::load(&samples.values[(i + l) * m_row + k]),
                       b = Lanes<Sums>::load(nearest[l] + k);
            products += a * b;
            squares += b * b;
          }
      }
      ab = products;
      bb = squares;
    });
    return correlation(sum_of_lanes(ab), samples.squares, sum_of_lanes(bb));
  }

  // Hill climbing by rotations about three axes with decreasing angles; the last steps use all directions.
  Scored_rotation refined(const Rotation_matrix& start) const
  {
    // In radians. The first angle is a large part of the spacing of the grid, 10 degrees: larger steps leave the neighborhood of the
    // maximum. Below few_angle, steps are smaller than the resolution of the few directions. The last angle that is tried is 0.2
    // degrees, a tenth of the spacing of the images.
    constexpr double first_angle = 0.12, few_angle = 0.02, last_angle = 0.002;
    Scored_rotation result = {start, 0.};
    const Samples* samples = nullptr;
    for(double angle = first_angle; angle > last_angle;)
    {
      const auto* const needed = angle > few_angle ? &m_few : &m_all;
      if(samples != needed)
        result.score = score(result.rotation, *needed);
      samples = needed;
      Scored_rotation best = result;
      for(std::size_t axis = 1; axis < 4; ++axis)
        for(const double sign : {-1., 1.})
        {
          Quaternion q = {cosine(0.5 * angle), 0., 0., 0.};
          q[axis] = sign * sine(0.5 * angle);
          const Rotation_matrix r = product(rotation_matrix(q), result.rotation);
          if(const double s = score(r, *samples); s > best.score)
            best = {r, s};
        }
      if(best.score > result.score)
        result = best;
      else
        angle *= 0.5;
    }
    return result;
  }

  static constexpr std::size_t max_lanes = 4;

  const Sphere_image& m_b;
  std::size_t m_row;
  Execution m_execution;
  Samples m_few, m_all;
};

// The rotation that minimizes the distances between vertices and the closest vertices of the second sphere, computed in a few rounds
// from a rotation that is nearly correct. For copies of a sphere, it is exact up to rounding error.
inline Rotation_matrix closest_point_rotation(Rotation_matrix rotation, const Sphere_mesh& sphere1,
                                              const Sphere_mesh& sphere2, Run_control& control,
                                              const Execution& execution)
{
  // One round suffices if vertices are farther apart than the error of the rotation; for dense copies, further rounds match more
  // vertices.
  constexpr int n_rounds = 8;
  constexpr std::size_t block_size = 4096; // located between two calls of the control: exact signs take long on copies
  for(int round = 0; round < n_rounds; ++round)
  {
    const auto points = points_of(rotated_directions(rotation, directions_of(sphere1)));
    std::vector<std::pair<Vector_3d, Vector_3d>> pairs;
    for(std::size_t begin = 0; begin < points.size(); begin += block_size)
    {
      if(!control.go_further(0, 0.))
        return rotation;
      const auto end = static_cast<std::ptrdiff_t>((std::min)(begin + block_size, points.size()));
      const std::vector<Sphere_kernel::Point_3> block(points.begin() + static_cast<std::ptrdiff_t>(begin),
                                                      points.begin() + end);
      for(const auto& location : sphere2.locate(block, execution))
        pairs.emplace_back(sphere1.direction(pairs.size()),
                           sphere2.direction(nearest_vertex(sphere2.triangles(), location)));
    }
    if(const std::optional<Rotation_matrix> next = fitting_rotation(pairs))
      rotation = *next;
  }
  return rotation;
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_ROTATION_SEARCH_H
