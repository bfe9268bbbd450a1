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

// A rotation of the first sphere, and how well the surfaces agree by it, the more the better.
struct Scored_rotation
{
  Rotation_matrix rotation;
  double score;
};

// At most n rotations that are at least this angle apart, the best one first.
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

// Searches all rotations: those of a grid, and around the best of them.
class Rotation_search
{
public:
  // The second surface is given by the image of its features.
  Rotation_search(const Surface_descriptor& first, const Sphere_image& second, const Execution& execution)
    : m_b(second)
    , m_row(Sphere_image::row_size(first.features().size()))
    , m_execution(execution)
    // Along an edge of the icosahedron: 492 directions that are 9 degrees apart, as far as the rotations that are tried, and
    // 4002 that are 3 degrees apart. Fewer take less time, but leave more to chance.
    , m_few(first, 7, execution)
    , m_all(first, 20, execution)
  {}

  // The best rotations that are at least 20 degrees apart, the best one first. Once the control has said no, they are the
  // best of those that have been tried, or the identity.
  std::vector<Scored_rotation> best(std::size_t n, Run_control& control) const
  {
    // Refinements of the same peak end less than this apart; two poses of a body differ by more.
    constexpr double min_angle = CGAL_PI / 9.;
    constexpr std::size_t batch_size =
        4; // between two questions to the control: for four threads, and some milliseconds
    std::vector<Scored_rotation> found = local_maxima(control);
    for(std::size_t k = 0; k < found.size() && control.go_further(0, 0.); k += batch_size)
      for_each_block(m_execution, k, (std::min)(k + batch_size, found.size()), 1,
                     [&](std::size_t i, std::size_t) { found[i] = refined(found[i].rotation); });
    return select_rotations(std::move(found), n, min_angle);
  }

private:
  // The super-Fibonacci spirals of Alexa cover all rotations evenly: these, to about 10 degrees.
  static std::vector<Quaternion> rotations_of_grid()
  {
    constexpr std::size_t n = 12000; // The spacing goes with the cube root: half of it takes eight times as many.
    constexpr double phi = 1.41421356237309504880,
                     psi = 1.533751168755204288118; // phi^2 = 2, psi^4 = psi + 4: as Alexa has it
    std::vector<Quaternion> result;
    for(std::size_t i = 0; i < n; ++i)
    {
      const double s = static_cast<double>(i) + 0.5, t = s / n, d = 2. * CGAL_PI * s;
      const double r = std::sqrt(t), R = std::sqrt(1. - t);
      result.push_back({r * sine(d / phi), r * cosine(d / phi), R * sine(d / psi), R * cosine(d / psi)});
    }
    return result;
  }

  // The rotations of the grid that are better than all around: the flank of the highest peak is higher than most other
  // peaks. The best one comes first.
  std::vector<Scored_rotation> local_maxima(Run_control& control) const
  {
    constexpr std::size_t batch_size = 2000,
                          block_size = 100; // between two questions, some milliseconds; and for a thread
    // Within which a maximum is one, a bit more than the grid's spacing. If it is less, rotations on the same flank are found
    // instead of other peaks; if it is more, peaks near a higher one are lost.
    constexpr double max_radius = CGAL_PI / 12.;
    // A peak of the grid may be lower than the real one, and the best of those that are found be none but that: more of them
    // take more time to refine. Those below the best quarter are not looked at, as the time grows with the square.
    constexpr std::size_t n_looked_at = 3000, n_found = 16;
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
    for(std::size_t i = 0; i < (std::min)(n_looked_at, order.size()) && found.size() < n_found; ++i)
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

  // The features of the first surface in directions that cover the sphere evenly, where it counts.
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
        coordinates.resize(size + max_lanes, 1.); // As many are loaded at once.
    }

    std::size_t size = 0;
    std::array<std::vector<double>, 3> directions; // by coordinates
    std::vector<double> values;                    // in rows of the image
    double squares = 0.;                           // their sum
  };

  double score(const Rotation_matrix& r, const Samples& samples) const
  {
    using Sums = Four_lanes; // one would wait for each addition
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
    const auto sum = [](const Sums& x) { return (lane(x, 0) + lane(x, 1)) + (lane(x, 2) + lane(x, 3)); };
    return correlation(sum(ab), samples.squares, sum(bb));
  }

  // Climbs by turns about three axes, of angles that become smaller; the last ones with all directions.
  Scored_rotation refined(const Rotation_matrix& start) const
  {
    // In radians. The first one is most of the grid's spacing, 10 degrees: a larger one leaves the peak. Below few_angle, turns
    // are finer than a few directions can resolve. The last one that is tried is 0.2 degrees, a tenth of the spacing of the images.
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

// The rotation that brings each vertex nearest to one of the second sphere, in a few rounds from a rotation that is nearly
// so. For copies of a sphere it is exact but for rounding.
inline Rotation_matrix closest_point_rotation(Rotation_matrix rotation, const Sphere_mesh& sphere1,
                                              const Sphere_mesh& sphere2, Run_control& control,
                                              const Execution& execution)
{
  // One is enough where vertices are farther apart than the rotation is off; of dense copies, more meet in each further one.
  constexpr int n_rounds = 8;
  constexpr std::size_t block_size =
      4096; // that is located until the control is asked: exact signs take long on copies
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
