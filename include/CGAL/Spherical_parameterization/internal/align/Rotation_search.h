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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_ROTATION_SEARCH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_ROTATION_SEARCH_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/align/Sphere_grid.h>
#include <CGAL/Spherical_parameterization/internal/align/Sphere_image.h>
#include <CGAL/Spherical_parameterization/internal/run/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// A rotation by its matrix, row by row.
using Rotation_matrix = std::array<Vector_3d, 3>;

inline Vector_3d rotated(const Rotation_matrix& r, const Vector_3d& p)
{
  return {dot(r[0], p), dot(r[1], p), dot(r[2], p)};
}

inline Rotation_matrix product(const Rotation_matrix& a, const Rotation_matrix& b)
{
  Rotation_matrix result;
  for(std::size_t i = 0; i < 3; ++i)
    result[i] = a[i][0] * b[0] + a[i][1] * b[1] + a[i][2] * b[2];
  return result;
}

// a vector of any length, normalized without overflow; none for zero or what is not finite
inline std::optional<Vector_3d> direction_of(const Vector_3d& p)
{
  const double size = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if(!is_finite(p) || !(size > 0.))
    return std::nullopt;
  return normalized(Vector_3d{p[0] / size, p[1] / size, p[2] / size});
}

using Quaternion = std::array<double, 4>; // the scalar comes first

inline Rotation_matrix rotation_matrix(const Quaternion& q)
{
  const double s = 2. / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {Vector_3d{1. - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
          Vector_3d{s * (x * y + w * z), 1. - s * (x * x + z * z), s * (y * z - w * x)},
          Vector_3d{s * (x * z - w * y), s * (y * z + w * x), 1. - s * (x * x + y * y)}};
}

// the angle between two rotations, in radians
inline double angle_between(const Rotation_matrix& a, const Rotation_matrix& b)
{
  const double cosine = 0.5 * (dot(a[0], b[0]) + dot(a[1], b[1]) + dot(a[2], b[2]) - 1.);
  return std::acos((std::min)((std::max)(cosine, -1.), 1.));
}

// The rotation that brings directions nearest to others, by least squares: the eigenvector of Horn's symmetric matrix
// with the largest eigenvalue, by Jacobi's rotations. None if several rotations are equally good, or nearly so.
inline std::optional<Rotation_matrix> fitting_rotation(const std::vector<std::pair<Vector_3d, Vector_3d>>& pairs)
{
  std::array<Vector_3d, 3> s = {Vector_3d{0., 0., 0.}, Vector_3d{0., 0., 0.}, Vector_3d{0., 0., 0.}};
  for(const auto& [p, q] : pairs)
    for(std::size_t i = 0; i < 3; ++i)
      s[i] = s[i] + p[i] * q;
  std::array<Quaternion, 4> a = {
      Quaternion{s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]},
      Quaternion{s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]},
      Quaternion{s[2][0] - s[0][2], s[0][1] + s[1][0], s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1]},
      Quaternion{s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], s[2][2] - s[0][0] - s[1][1]}};
  std::array<Quaternion, 4> v = {Quaternion{1., 0., 0., 0.}, Quaternion{0., 1., 0., 0.}, Quaternion{0., 0., 1., 0.},
                                 Quaternion{0., 0., 0., 1.}}; // columns: the eigenvectors
  constexpr int n_sweeps = 20;                                // Six or so are enough.
  for(int sweep = 0; sweep < n_sweeps; ++sweep)
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = i + 1; j < 4; ++j)
        if(a[i][j] != 0.)
        {
          const double theta = (a[j][j] - a[i][i]) / (2. * a[i][j]);
          const double t = (theta < 0. ? -1. : 1.) / (std::abs(theta) + std::hypot(theta, 1.));
          const double c = 1. / std::hypot(t, 1.), d = t * c;
          for(std::size_t k = 0; k < 4; ++k)
            std::tie(a[k][i], a[k][j]) = std::pair(c * a[k][i] - d * a[k][j], d * a[k][i] + c * a[k][j]);
          for(std::size_t k = 0; k < 4; ++k)
            std::tie(a[i][k], a[j][k]) = std::pair(c * a[i][k] - d * a[j][k], d * a[i][k] + c * a[j][k]);
          for(std::size_t k = 0; k < 4; ++k)
            std::tie(v[k][i], v[k][j]) = std::pair(c * v[k][i] - d * v[k][j], d * v[k][i] + c * v[k][j]);
        }
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return a[i][i] > a[j][j]; });
  const std::size_t best = order[0];
  constexpr double min_gap = 1e-6;
  if(!(a[best][best] - a[order[1]][order[1]] > min_gap * static_cast<double>(pairs.size())))
    return std::nullopt;
  return rotation_matrix({v[0][best], v[1][best], v[2][best], v[3][best]});
}

// A rotation of one image of features against another one, and how well they agree: the correlation of their values.
struct Scored_rotation
{
  Rotation_matrix rotation;
  double score;
};

// Searches all rotations.
class Rotation_search
{
public:
  // `a` has the channels of one image at the vertices of the grid; all channels consist of ranks.
  Rotation_search(const Sphere_grid& grid, const std::vector<std::vector<double>>& a, const Sphere_image& b,
                  const Execution& execution)
    : m_grid(grid)
    , m_b(b)
    , m_n(a.size())
    , m_execution(execution)
  {
    m_a.reserve(grid.size() * m_n);
    for(std::size_t v = 0; v < grid.size(); ++v)
      for(const auto& channel : a)
        m_a.push_back(channel[v]);
    // Every k-th vertex of a grid is next to others that are left out; those of a coarser grid are spread evenly.
    const Sphere_grid coarse(7);
    Sphere_grid::Triangulation::Hint hint;
    for(const auto& q : coarse.triangulation().points())
    {
      const auto place = grid.triangulation().locate(q, hint);
      const auto& w = place.coordinates;
      m_few.push_back(grid.triangles()[place.triangle][w[0] >= w[1] && w[0] >= w[2] ? 0 : w[1] >= w[2] ? 1 : 2]);
    }
    m_all.resize(grid.size());
    std::iota(m_all.begin(), m_all.end(), std::uint32_t(0));
  }

  // The best rotations that are at least `min_angle` apart, the best one first.
  std::vector<Scored_rotation> best(std::size_t n, double min_angle) const
  {
    constexpr double max_radius = CGAL_PI / 12.; // within which a maximum is one, a bit more than the grid's spacing
    const std::vector<Quaternion> starts = rotations_of_grid();
    std::vector<double> scores(starts.size());
    for_each_block(m_execution, 0, starts.size(), 100, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        scores[i] = score(rotation_matrix(starts[i]), m_few);
    });
    std::vector<std::size_t> order(starts.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return scores[i] > scores[j]; });
    // Local maxima: the flank of the highest peak is higher than most other peaks.
    constexpr std::size_t n_looked_at = 3000, n_refined = 16;
    const double min_cosine = std::cos(0.5 * max_radius);
    std::vector<Scored_rotation> found;
    for(std::size_t i = 0; i < n_looked_at && found.size() < n_refined; ++i)
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
    for_each_block(m_execution, 0, found.size(), 1,
                   [&](std::size_t i, std::size_t) { found[i] = refined(found[i].rotation); });
    std::stable_sort(found.begin(), found.end(),
                     [](const Scored_rotation& a, const Scored_rotation& b) { return a.score > b.score; });
    std::vector<Scored_rotation> result;
    for(const Scored_rotation& candidate : found)
      if(result.size() < n)
        add_if_distinct(candidate, min_angle, result);
    return result;
  }

private:
  static void add_if_distinct(const Scored_rotation& candidate, double min_angle, std::vector<Scored_rotation>& list)
  {
    for(const Scored_rotation& other : list)
      if(angle_between(candidate.rotation, other.rotation) < min_angle)
        return;
    list.push_back(candidate);
  }

  // The super-Fibonacci spirals of Alexa cover all rotations evenly: these, to about 10 degrees.
  static std::vector<Quaternion> rotations_of_grid()
  {
    constexpr std::size_t n = 12000;
    constexpr double phi = 1.41421356237309504880, psi = 1.533751168755204288118;
    std::vector<Quaternion> result;
    for(std::size_t i = 0; i < n; ++i)
    {
      const double s = static_cast<double>(i) + 0.5, t = s / n, d = 2. * CGAL_PI * s;
      const double r = std::sqrt(t), R = std::sqrt(1. - t);
      result.push_back({r * std::sin(d / phi), r * std::cos(d / phi), R * std::sin(d / psi), R * std::cos(d / psi)});
    }
    return result;
  }

  double score(const Rotation_matrix& r, const std::vector<std::uint32_t>& vertices) const
  {
    double ab = 0., aa = 0., bb = 0.;
    for(const std::uint32_t v : vertices)
    {
      const double* const a = &m_a[v * m_n];
      const double* const b = m_b.nearest(rotated(r, m_grid.directions()[v]));
      for(std::size_t k = 0; k < m_n; ++k)
      {
        ab += a[k] * b[k];
        aa += a[k] * a[k];
        bb += b[k] * b[k];
      }
    }
    return aa > 0. && bb > 0. ? ab / std::sqrt(aa * bb) : 0.;
  }

  // Climbs by turns about three axes, of angles that become smaller; the last ones with all vertices.
  Scored_rotation refined(const Rotation_matrix& start) const
  {
    constexpr double first_angle = 0.12, few_angle = 0.02, last_angle = 0.002;
    Scored_rotation result = {start, 0.};
    const std::vector<std::uint32_t>* vertices = nullptr;
    for(double angle = first_angle; angle > last_angle;)
    {
      const auto* const needed = angle > few_angle ? &m_few : &m_all;
      if(vertices != needed)
        result.score = score(result.rotation, *needed);
      vertices = needed;
      Scored_rotation best = result;
      for(std::size_t axis = 1; axis < 4; ++axis)
        for(const double sign : {-1., 1.})
        {
          Quaternion q = {std::cos(0.5 * angle), 0., 0., 0.};
          q[axis] = sign * std::sin(0.5 * angle);
          const Rotation_matrix r = product(rotation_matrix(q), result.rotation);
          if(const double s = score(r, *vertices); s > best.score)
            best = {r, s};
        }
      if(best.score > result.score)
        result = best;
      else
        angle *= 0.5;
    }
    return result;
  }

  const Sphere_grid& m_grid;
  const Sphere_image& m_b;
  std::size_t m_n;
  Execution m_execution;
  std::vector<double> m_a;
  std::vector<std::uint32_t> m_few, m_all;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALIGN_ROTATION_SEARCH_H
