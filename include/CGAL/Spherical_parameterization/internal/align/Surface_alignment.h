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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SURFACE_ALIGNMENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SURFACE_ALIGNMENT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Rotation_search.h>
#include <CGAL/Spherical_parameterization/internal/align/Sampled_surface.h>
#include <CGAL/Spherical_parameterization/internal/align/Sphere_bending.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Rotation_matrix.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// Where the vertices of the first surface start on the sphere of the second one.
struct Aligned_start
{
  std::vector<Vector_3d> directions;
  double agreement = 0., margin = 0.; // see Surface_map_report
  bool is_rotation = false;           // The spheres agree as they are.
  std::vector<Sphere_image> features; // of both surfaces, if they are to agree
};

template <class K>
std::vector<Vector_3d> rotated_directions(const Rotation_matrix& rotation, const Sphere_triangulation<K>& sphere)
{
  std::vector<Vector_3d> result;
  result.reserve(sphere.points().size());
  for(std::size_t v = 0; v < sphere.points().size(); ++v)
    result.push_back(normalized(rotated(rotation, sphere.direction(v))));
  return result;
}

// Two surfaces on the same grid, and how the sphere of the first is to be turned, or bent, onto that of the second. The
// control is asked between parts of the work; what is there when it says no is valid.
class Surface_alignment
{
public:
  Surface_alignment(const Sphere_grid& grid, Sampled_surface first, Sampled_surface second, Run_control& control,
                    const Execution& execution)
    : m_grid(grid)
    , m_surfaces{std::move(first), std::move(second)}
    , m_control(control)
    , m_execution(execution)
  {
    if(m_surfaces[0].features().empty())
      for(int feature = 0; feature < Sampled_surface::number_of_own_features && goes_on(); ++feature)
        in_parallel(2, [&](std::size_t k) { m_surfaces[k].add_own_feature(feature); });
  }

  // The ranks of the features of a surface, 0 or 1.
  Sphere_image features(std::size_t surface) const { return m_grid.image(m_surfaces[surface].features()); }

  // The best rotations, the best one first; at least one.
  std::vector<Scored_rotation> best_rotations(std::size_t n) const
  {
    return Rotation_search(m_grid, m_surfaces[0].features(), features(1), m_execution).best(n, m_control);
  }

  // The start of a map from the first sphere to the second one; both have grids. Poses of a body have spheres that differ by
  // more than a rotation: then they are bent onto each other from the two best rotations, and the better one is taken.
  template <class K>
  Aligned_start start(const Sphere_triangulation<K>& sphere1, const Sphere_triangulation<K>& sphere2)
  {
    // Copies of a surface with turned copies of its sphere have a score of nearly 1, poses of a body less. If it is larger,
    // copies are bent, to 1.3 degrees from each other where the rotation leaves 0.2; if it is smaller, poses are not bent.
    constexpr double min_score_of_same_shape = 0.97;
    Aligned_start result;
    const std::vector<Scored_rotation> candidates = best_rotations(2);
    result.is_rotation = candidates[0].score > min_score_of_same_shape;
    if(result.is_rotation || m_control.is_stopped())
    {
      result.agreement = candidates[0].score;
      result.margin = margin(candidates);
      result.directions = rotated_directions(polished(candidates[0].rotation, sphere1, sphere2), sphere1);
      return result;
    }
    const std::vector<Bent_grid> bent = this->bent(candidates);
    result.agreement = bent[0].score;
    result.margin = margin(bent);
    const auto directions = bent_directions(sphere1, m_grid, bent[0].directions, m_control, m_execution);
    result.directions = directions ? *directions : rotated_directions(bent[0].rotation, sphere1);
    return result;
  }

  // Where the vertices of the grid lead to, a bijection, and how well the features agree there.
  struct Bent_grid
  {
    Rotation_matrix rotation; // from which it has been bent
    std::vector<Vector_3d> directions;
    double score;
  };

  // Bends the first sphere onto the second one from each of these rotations; the best result comes first. At first the
  // features guide it, from coarse to fine. Then the ends of limbs are known, and the distances from them, which no pose
  // changes, tell everywhere where to go.
  //
  // The stages start where what is smoothed is as wide as the grid of rotations, 12 degrees, and end with the steps of the
  // grid: a wider start takes different features for one, a narrower one misses what is farther away. The motion is always as
  // smooth as the images, or smoother. The distances are smooth by themselves, and known better.
  std::vector<Bent_grid> bent(const std::vector<Scored_rotation>& rotations)
  {
    std::vector<Feature_flow> flows;
    for(const Scored_rotation& candidate : rotations)
      flows.emplace_back(m_grid, candidate.rotation, m_execution);
    std::vector<Features> features(flows.size(), {m_surfaces[0].features(), m_surfaces[1].features()});
    run({{30, 30}, {15, 20}, {6, 12}}, features, flows);
    if(goes_on())
    {
      std::array<std::vector<Sampled_surface::Limb>, 2> limbs;
      in_parallel(2, [&](std::size_t k) { limbs[k] = m_surfaces[k].limbs(); });
      in_parallel(flows.size(),
                  [&](std::size_t k) { features[k] = distances_from_limbs(limbs, flows[k].directions()); });
      run({{6, 30}, {3, 20}, {1, 12}, {1, 6}}, features, flows);
    }
    const Sphere_image image = this->features(1);
    std::vector<Bent_grid> result(flows.size());
    in_parallel(flows.size(), [&](std::size_t k) {
      result[k] = {rotations[k].rotation, flows[k].directions(), agreement(flows[k].directions(), image)};
    });
    std::stable_sort(result.begin(), result.end(),
                     [](const Bent_grid& a, const Bent_grid& b) { return a.score > b.score; });
    return result;
  }

  // How much better the best candidate is than the next one, or than 0 if there is none.
  template <class Candidate>
  static double margin(const std::vector<Candidate>& candidates)
  {
    return candidates[0].score - (candidates.size() > 1 ? candidates[1].score : 0.);
  }

private:
  using Features = std::array<std::vector<Channel>, 2>; // of both surfaces

  bool goes_on() const { return m_control.go_further(0, 0.); }

  template <class Function>
  void in_parallel(std::size_t n, const Function& f) const
  {
    for_each_block(m_execution, 0, n, 1, [&](std::size_t k, std::size_t) { f(k); });
  }

  // Stages are how often the features, and how often the motion is smoothed. All flows step together, so that the control is
  // asked between short parts.
  void run(const std::vector<std::array<int, 2>>& stages, const std::vector<Features>& features,
           std::vector<Feature_flow>& flows)
  {
    constexpr int n_steps = 15; // 22 steps of the grid at most; more take more time, where most have settled
    for(const auto& [n_image, n_motion] : stages)
    {
      in_parallel(flows.size(), [&, n = n_image, m = n_motion](std::size_t k) {
        flows[k].set_features(features[k][0], features[k][1], n, m);
      });
      for(int step = 0; step < n_steps && goes_on(); ++step)
        in_parallel(flows.size(), [&](std::size_t k) { flows[k].step(); });
      if(m_control.is_stopped())
        return;
    }
  }

  // The distances from ends of limbs that are found on both surfaces, each the nearest one of the other, and the features
  // with a small weight; nothing if these ends are too few to tell a place.
  Features distances_from_limbs(const std::array<std::vector<Sampled_surface::Limb>, 2>& limbs,
                                const std::vector<Vector_3d>& directions) const
  {
    constexpr std::size_t min_limbs = 3; // Two distances are the same at two places, or along a line.
    // Ends that agree are less than 45 degrees apart. With more, limbs of which one is missing pass for each other; with less,
    // limbs that the features have not brought together are left out.
    constexpr double min_cosine = 0.7;
    // Distances have the mean 1, features are ranks from -1 to 1. Larger weights bring back what the features have got wrong;
    // without any, what is between the limbs, such as a face, has nothing to go by.
    constexpr double weight_of_features = 0.2;
    const auto cosine = [&](const auto& a, const auto& b) {
      return dot(directions[a.end], m_grid.directions()[b.end]);
    };
    Features result;
    for(const auto& a : limbs[0])
      for(const auto& b : limbs[1])
      {
        const double c = cosine(a, b);
        const auto is_b_nearest = [&](const auto& other) { return &other == &b || cosine(a, other) < c; };
        const auto is_a_nearest = [&](const auto& other) { return &other == &a || cosine(other, b) < c; };
        if(c > min_cosine && std::all_of(limbs[1].begin(), limbs[1].end(), is_b_nearest) &&
           std::all_of(limbs[0].begin(), limbs[0].end(), is_a_nearest))
        {
          result[0].push_back(a.distances);
          result[1].push_back(b.distances);
        }
      }
    if(result[0].size() < min_limbs)
      return {};
    const auto multiply = [](Channel& channel, double factor) {
      for(double& x : channel)
        x *= factor;
    };
    for(std::size_t k = 0; k < 2; ++k)
    {
      double sum = 0.;
      for(const Channel& channel : result[k])
        sum = std::accumulate(channel.begin(), channel.end(), sum);
      const double scale = sum > 0. ? static_cast<double>(result[k].size() * m_grid.size()) / sum : 1.;
      for(Channel& channel : result[k])
        multiply(channel, scale);
      for(const Channel& channel : m_surfaces[k].features())
        multiply(result[k].emplace_back(channel), weight_of_features);
    }
    return result;
  }

  // The correlation of the features where the vertices of the grid lead to; `image` is that of the second surface.
  double agreement(const std::vector<Vector_3d>& directions, const Sphere_image& image) const
  {
    Correlation result;
    std::vector<double> b(image.number_of_channels());
    for(std::size_t v = 0; v < m_grid.size(); ++v)
    {
      image.interpolate(directions[v], b.data());
      for(std::size_t k = 0; k < b.size(); ++k)
        result.add(m_surfaces[0].features()[k][v], b[k]);
    }
    return result();
  }

  // The rotation that brings each vertex nearest to one of the second sphere, in a few rounds from a rotation that is nearly
  // so. For copies of a sphere it is exact but for rounding.
  template <class K>
  Rotation_matrix polished(Rotation_matrix rotation, const Sphere_triangulation<K>& sphere1,
                           const Sphere_triangulation<K>& sphere2) const
  {
    // One is enough where vertices are farther apart than the rotation is off; of dense copies, more meet in each further one.
    constexpr int n_rounds = 8;
    constexpr std::size_t block_size =
        4096; // that is located until the control is asked: exact signs take long on copies
    for(int round = 0; round < n_rounds; ++round)
    {
      const auto points = points_of<K>(rotated_directions(rotation, sphere1));
      std::vector<std::pair<Vector_3d, Vector_3d>> pairs;
      for(std::size_t begin = 0; begin < points.size(); begin += block_size)
      {
        if(!goes_on())
          return rotation;
        const auto end = static_cast<std::ptrdiff_t>((std::min)(begin + block_size, points.size()));
        const std::vector<typename K::Point_3> block(points.begin() + static_cast<std::ptrdiff_t>(begin),
                                                     points.begin() + end);
        for(const auto& place : sphere2.locate(block, m_execution))
          pairs.emplace_back(sphere1.direction(pairs.size()),
                             sphere2.direction(nearest_vertex(sphere2.triangles(), place)));
      }
      if(const std::optional<Rotation_matrix> next = fitting_rotation(pairs))
        rotation = *next;
    }
    return rotation;
  }

  const Sphere_grid& m_grid;
  std::array<Sampled_surface, 2> m_surfaces;
  Run_control& m_control;
  Execution m_execution;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_SURFACE_ALIGNMENT_H
