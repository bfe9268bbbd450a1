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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_DESCRIPTOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_DESCRIPTOR_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Surface_maps/internal/Sphere_mesh.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/alignment/Surface_spectrum.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/hierarchy/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface_diffusion.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/mesh_measures.h>
#include <CGAL/Spherical_parameterization/internal/surface/vertex_scalars.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Geodesic distances on a surface, which change little under bending: the lengths of shortest paths along edges and across pairs of
// triangles, accurate to 4 percent on regular triangles.
class Surface_paths
{
public:
  Surface_paths() = default;
  Surface_paths(const std::vector<Vector_3d>& points, const std::vector<Linked_triangle>& triangles)
    : m_joints(points.size())
  {
    const auto join = [&](std::uint32_t v, std::uint32_t w, double length) {
      m_joints[v].emplace_back(length, w);
      m_joints[w].emplace_back(length, v);
    };
    for(std::uint32_t t = 0; t < triangles.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        if(const std::uint32_t s = triangles[t].neighbors[i]; t < s)
        {
          const std::uint32_t a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
          const std::uint32_t c = triangles[t][i], d = triangles[s][triangles[s].side_of(t)];
          join(a, b, length(points[b] - points[a]));
          join(c, d, length_across(points[a], points[b], points[c], points[d]));
        }
  }

  using Joint = std::pair<double, std::uint32_t>; // the distance to a vertex, and the vertex

  Vertex_scalars distances_from(std::uint32_t source) const { return distances_from(std::vector<Joint>{{0., source}}); }

  // The distances from a point with the given distances to these vertices.
  Vertex_scalars distances_from(const std::vector<Joint>& corners) const
  {
    Vertex_scalars result(m_joints.size(), (std::numeric_limits<double>::max)());
    std::priority_queue<Joint, std::vector<Joint>, std::greater<Joint>> queue;
    for(const auto& [d, v] : corners)
    {
      result[v] = d;
      queue.emplace(d, v);
    }
    while(!queue.empty())
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d > result[v])
        continue;
      for(const auto& [step, w] : m_joints[v])
        if(const double x = d + step; x < result[w])
        {
          result[w] = x;
          queue.emplace(x, w);
        }
    }
    return result;
  }

private:
  // The distance from c to d across the edge from a to b.
  static double length_across(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& d)
  {
    const double edge = length(b - a);
    if(!(edge > 0.))
      return length(c - a) + length(d - a);
    const Vector_3d u = (1. / edge) * (b - a);
    const double cx = dot(c - a, u), cy = std::sqrt((std::max)(squared_length(c - a) - cx * cx, 0.));
    const double dx = dot(d - a, u), dy = std::sqrt((std::max)(squared_length(d - a) - dx * dx, 0.));
    const double x = cy + dy > 0. ? (cx * dy + dx * cy) / (cy + dy) : 0.; // where the straight line meets the edge
    return x >= 0. && x <= edge ? hypotenuse(cx - dx, cy + dy)
                                : (std::min)(length(c - a) + length(d - a), length(c - b) + length(d - b));
  }

  std::vector<std::vector<Joint>> m_joints; // the neighbors of each vertex, and the vertices opposite to them
};

// The representation of a surface for comparison: the coarsest level of a hierarchy, scaled to area 1. Its vertices are distributed
// over the surface instead of its sphere, on which extremities are small. All computed quantities change little when the surface is
// bent, and are invariant under rigid motions.
class Surface_descriptor
{
public:
  // Larger surfaces are simplified to this size, and compared in the same time. More vertices improve alignments, but the time of
  // each start grows in proportion.
  static constexpr std::size_t max_size = 2000;

  // The hierarchy is that of the mesh with its images on the unit sphere. Images, features of the caller, if any, and the mask are in
  // the order of the mesh. Vertices of the coarsest level receive local averages of the features.
  Surface_descriptor(const Mesh_hierarchy& hierarchy, const Surface& mesh, const std::vector<Vector_3d>& images,
                     const std::vector<Vertex_scalars>& features, const Mask& mask)
    : m_rings(hierarchy.rings(hierarchy.number_of_levels() - 1))
  {
    const Mesh_hierarchy::Level& level = hierarchy.level(hierarchy.number_of_levels() - 1);
    m_points = level.gathered(mesh.points());
    m_directions = level.gathered(images);
    m_is_bijective = are_safely_positive(m_rings, m_directions);
    const std::size_t n = m_points.size();
    Index_triangles triangles;
    m_rings.for_each_face([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles.push_back({a, b, c}); });
    m_sphere.assign(points_of(m_directions), link_triangles(triangles, n));
    m_areas = vertex_areas(m_rings, m_points);
    const double area = std::accumulate(m_areas.begin(), m_areas.end(), 0.);
    const double scale = area > 0. ? 1. / std::sqrt(area) : 1.;
    for(std::size_t v = 0; v < n; ++v)
    {
      m_points[v] = scale * m_points[v];
      m_areas[v] = (std::max)(scale * scale * m_areas[v], min_area);
    }
    m_paths = Surface_paths(m_points, m_sphere.triangles());
    for(const Vertex_scalars& feature : features)
      m_features.push_back(gathered(hierarchy, feature));
    if(!mask.empty())
      for(const double share : gathered(hierarchy, Vertex_scalars(mask.begin(), mask.end())))
        m_mask.push_back(share > 0.5);
    if(m_is_bijective)
      m_sphere.make_grid();
  }

  std::size_t size() const { return m_points.size(); }
  const Vertex_rings& rings() const { return m_rings; }
  const std::vector<Vector_3d>& points() const { return m_points; }
  const Vertex_scalars& areas() const { return m_areas; }

  // Whether the surroundings of a vertex are included.
  bool counts(std::size_t v) const { return m_mask.empty() || !m_mask[v]; }
  const Mask& mask() const { return m_mask; }
  const std::vector<Vector_3d>& directions() const { return m_directions; }

  // Whether the images are bijective in double precision, which all functions that use the sphere require.
  bool is_bijective() const { return m_is_bijective; }
  const Sphere_mesh& sphere() const { return m_sphere; }

  // The features; those of the package are ranks.
  const std::vector<Vertex_scalars>& features() const { return m_features; }

  // The weights of the features in the choice among maps; all equal if empty.
  const std::vector<double>& weights_in_choice() const { return m_weights_in_choice; }

  // Adds one of the features of the package: the ratio of areas on the surface and on the sphere; the average distance from the rest
  // of the surface; the signed mean curvature at two scales, which distinguishes front from back where the other features allow for a
  // half-turn; and the wave kernel signature, which distinguishes parts that distances do not distinguish. The first
  // `number_of_kept_features` are compared on finer levels as well; with the signature there, poses are matched less accurately.
  static constexpr int number_of_own_features = 5;
  static constexpr std::size_t number_of_kept_features = 4, index_of_fine_curvature = 2;
  void add_own_feature(int k)
  {
    if(k == number_of_own_features - 1)
    {
      add_wave_kernel_signature();
      return;
    }
    // The times of heat diffusion over 0.03, where the distance of vertices is 0.024, and over 0.09. With less time, the curvature
    // depends on the sampling; with more, it is that of the whole body, and small features are lost.
    constexpr double fine = 0.001, coarse = 0.008;
    // The fine curvature distinguishes front from back better than all other features. In the descent and in the search for rotations,
    // its weight must not exceed that of the other features: its structures are small, and maps are attracted to the nearest ones.
    constexpr double weight_of_fine_curvature = 3.;
    const bool is_fine = k == static_cast<int>(index_of_fine_curvature);
    add_ranks(k == 0   ? area_ratios()
              : k == 1 ? average_distance()
                       : mean_curvature(m_rings, m_points, is_fine ? fine : coarse, min_area));
    m_weights_in_choice.push_back(is_fine ? weight_of_fine_curvature : 1.);
  }

  // A vertex, and the distances from it along the surface, divided by the mean of all distances.
  struct Origin
  {
    std::uint32_t vertex;
    Vertex_scalars distances;
  };

  // The tips of extremities: local maxima of the average distance above its mean.
  std::vector<Origin> extremities()
  {
    // Between two tips, in units of the mean distance, which is about half of the square root of the area. With a smaller value, a
    // blunt tip is counted twice; with a larger one, an extremity next to a longer one is missed.
    constexpr double min_distance = 0.45;
    const Vertex_scalars& average = average_distance();
    std::vector<std::uint32_t> tips;
    for(std::uint32_t v = 0; v < size(); ++v)
      if(const auto& ring = m_rings.ring(v);
         average[v] > 1. && counts(v) &&
         std::all_of(ring.begin(), ring.end(), [&](std::uint32_t w) { return average[w] <= average[v]; }))
        tips.push_back(v);
    std::stable_sort(tips.begin(), tips.end(),
                     [&](std::uint32_t v, std::uint32_t w) { return average[v] > average[w]; });
    std::vector<Origin> result;
    for(const std::uint32_t v : tips)
      if(std::all_of(result.begin(), result.end(),
                     [&](const Origin& extremity) { return extremity.distances[v] > min_distance; }))
      {
        result.push_back({v, m_paths.distances_from(v)});
        scale(result.back().distances);
      }
    return result;
  }

  // Computes the unit of distances_from(), the mean distance.
  void measure_distances() { static_cast<void>(average_distance()); }

  // The distances from the surface point in a direction of the sphere, in the same units.
  Vertex_scalars distances_from(const Vector_3d& direction) const
  {
    Sphere_mesh::Hint hint;
    const auto location = m_sphere.locate(point_of(direction), hint);
    const Vector_3d p = interpolated(m_points, m_sphere.triangles(), location);
    std::vector<Surface_paths::Joint> corners;
    for(const std::uint32_t v : m_sphere.triangles()[location.triangle].vertices)
      corners.emplace_back(length(p - m_points[v]), v);
    Vertex_scalars result = m_paths.distances_from(corners);
    scale(result);
    return result;
  }

  // Computes the data for spectrum(), unless the wave kernel signature has been added.
  void find_spectrum()
  {
    if(!m_spectrum)
      m_spectrum.emplace(m_rings, Surface_diffusion(m_rings, m_points, min_area, {}));
  }
  const Surface_spectrum& spectrum() const { return *m_spectrum; }

private:
  // Far below the mean, 1 / 2000, but larger than 0 where points coincide, see mean_curvature(). Smaller areas have the same rank.
  static constexpr double min_area = 1e-12;

  // The means of the values around the remaining vertices: the value of a removed vertex is distributed to its neighbors, like its
  // area.
  static Vertex_scalars gathered(const Mesh_hierarchy& hierarchy, const Vertex_scalars& values)
  {
    const std::size_t n_levels = hierarchy.number_of_levels();
    Vertex_scalars sums = values;
    for(std::size_t v = 0; v < sums.size(); ++v)
      sums[v] *= hierarchy.level(0).areas[v];
    for(std::size_t k = 0; k + 1 < n_levels; ++k)
    {
      const Mesh_hierarchy::Level& level = hierarchy.level(k);
      for(const auto& removed : level.removed)
      {
        const Vertex_rings::Ring ring = hierarchy.rings(k).ring(removed.vertex);
        for(const std::uint32_t w : ring)
          sums[level.vertices[w]] += sums[level.vertices[removed.vertex]] / static_cast<double>(ring.size());
      }
    }
    const Mesh_hierarchy::Level& coarsest = hierarchy.level(n_levels - 1);
    Vertex_scalars result;
    for(std::size_t v = 0; v < coarsest.vertices.size(); ++v)
    {
      const std::uint32_t number = coarsest.vertices[v];
      result.push_back(coarsest.areas[v] > 0. ? sums[number] / coarsest.areas[v] : values[number]);
    }
    return result;
  }

  void add_ranks(const Vertex_scalars& channel)
  {
    m_features.push_back(ranks_by_area(channel, areas_outside(m_mask, m_areas)));
    continue_over(m_mask, m_rings, m_features.back());
  }

  // Its values are half of those of other features in the search for rotations and in the descent. As large as these, poses are rotated
  // by a half-turn more often; with a third, a gorilla and a person agree less. In the choice among maps, each counts as much as another.
  void add_wave_kernel_signature()
  {
    constexpr int n = 8;
    constexpr double factor = 0.5;
    // The logarithms of 8 and 400: the lowest eigenvalue of a body with extremities is about 6, the sixtieth about 700.
    constexpr double lowest = 2.0794415416798357, highest = 5.9914645471079817, width = 0.22 * (highest - lowest);
    find_spectrum();
    for(int k = 0; k < n; ++k)
    {
      add_ranks(m_spectrum->wave_kernel_signature(lowest + (highest - lowest) * (k + 0.5) / n, width));
      for(double& x : m_features.back())
        x *= factor;
      m_weights_in_choice.push_back(1. / (factor * factor));
    }
  }

  void scale(Vertex_scalars& distances) const
  {
    for(double& d : distances)
      d *= m_inverse_mean_distance;
  }

  Vertex_scalars area_ratios() const
  {
    Vertex_scalars sphere_areas(size(), 0.), result(size());
    const auto& q = m_directions;
    for(const Linked_triangle& t : m_sphere.triangles())
      for(const std::uint32_t v : t.vertices)
        sphere_areas[v] += length(cross(q[t[1]] - q[t[0]], q[t[2]] - q[t[0]]));
    std::transform(m_areas.begin(), m_areas.end(), sphere_areas.begin(), result.begin(), std::divides<>());
    return result;
  }

  // The average distance of each vertex from the whole surface, divided by its mean. It is computed once, from sources that are
  // distributed by farthest point sampling.
  const Vertex_scalars& average_distance()
  {
    if(!m_average_distance.empty())
      return m_average_distance;
    // Each source represents 1 / 48 of the area, a disk of radius 0.08, which limits the accuracy of the average. The time is
    // proportional to the number of sources.
    constexpr std::size_t n_sources = 48;
    auto source = static_cast<std::uint32_t>(std::max_element(m_areas.begin(), m_areas.end()) - m_areas.begin());
    std::vector<std::size_t> nearest(size(), 0);
    std::vector<Vertex_scalars> distances;
    for(std::size_t k = 0; k < n_sources; ++k)
    {
      distances.push_back(m_paths.distances_from(source));
      double largest = -1.;
      for(std::uint32_t v = 0; v < size(); ++v)
      {
        if(distances[k][v] < distances[nearest[v]][v])
          nearest[v] = k;
        if(const double d = distances[nearest[v]][v]; d > largest)
        {
          largest = d;
          source = v;
        }
      }
    }
    Vertex_scalars weights(n_sources, 0.);
    for(std::size_t v = 0; v < size(); ++v)
      weights[nearest[v]] += m_areas[v];
    m_average_distance.assign(size(), 0.);
    for(std::size_t k = 0; k < n_sources; ++k)
      for(std::size_t v = 0; v < size(); ++v)
        m_average_distance[v] += weights[k] * distances[k][v];
    const double mean = inner_product(m_areas, m_average_distance);
    m_inverse_mean_distance = mean > 0. ? 1. / mean : 1.;
    scale(m_average_distance);
    return m_average_distance;
  }

  Vertex_rings m_rings;
  Sphere_mesh m_sphere;
  bool m_is_bijective = false;
  std::vector<Vector_3d> m_directions, m_points;
  Vertex_scalars m_areas; // the areas of the vertices
  Mask m_mask;            // empty if no vertex is excluded
  std::vector<Vertex_scalars> m_features;
  std::vector<double> m_weights_in_choice;
  Surface_paths m_paths;
  std::optional<Surface_spectrum> m_spectrum;
  Vertex_scalars m_average_distance;
  double m_inverse_mean_distance = 1.;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_DESCRIPTOR_H
