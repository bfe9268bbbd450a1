// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_RANDOM_TRIANGULATIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_RANDOM_TRIANGULATIONS_H

// Random triangulations of the sphere, from a seed each: simplicial, with 4 to 300 vertices, connected in many ways and
// placed in space in ways that have nothing to do with a sphere. What depends on no coordinate is the same on every
// machine; the coordinates are so too wherever products are rounded before they are added up.

#include "fuzzing.h"
#include "test_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace random_triangulations {

using fuzzing::Random;
using test_meshes::Coordinates;
using test_meshes::Triangle;
using test_meshes::Triangle_list;

// How the vertices are connected.
enum Connectivity
{
  STACKED,      // each new vertex in a random face
  NESTED,       // each new vertex next to the last one, in one of its faces
  TUBE,         // each new triangle within the last one
  FLIPPED,      // stacked, then random edges flipped
  SPLIT,        // random vertices split in two, at random places
  LOW_DEGREE,   // many vertices of degree 3 and 4 between others
  HUB,          // one vertex joined to all others
  HUBS,         // a few vertices joined to most others
  DOUBLE_WHEEL, // two vertices joined to all others
  MIXTURE,      // a bit of each, one after the other
  NUMBER_OF_CONNECTIVITIES
};

// Where the vertices are.
enum Placement
{
  BALL,          // anywhere in a ball
  CLUSTERED,     // in a few places, spread by 1e-12 to 1e-1 around them
  COLLINEAR,     // on a line, but for 1e-15 to 1e-9 or nothing
  COPLANAR,      // in a plane, but for the same
  SPHERE,        // on a sphere, near their neighbours
  SCALES,        // coordinates from 1e-100 to 1e100
  SOME_COINCIDE, // any of these, and some at the point of another
  ALL_COINCIDE,  // all at one point
  NUMBER_OF_PLACEMENTS
};

inline const char* to_string(Connectivity connectivity)
{
  static const char* const names[] = {"stacked",    "nested", "tube", "flipped",      "split",
                                      "low degree", "hub",    "hubs", "double wheel", "mixture"};
  return names[connectivity];
}

inline const char* to_string(Placement placement)
{
  static const char* const names[] = {"ball",   "clustered", "collinear",     "coplanar",
                                      "sphere", "scales",    "some coincide", "all coincide"};
  return names[placement];
}

// A triangulation of the sphere that is changed by steps which keep it simplicial. To start with, a tetrahedron.
class Growing_triangulation
{
public:
  // A vertex and a neighbour of it, by its place in the ring; or the face of both and the next neighbour.
  struct Corner
  {
    std::size_t vertex, place;
  };

  std::size_t size() const { return m_rings.size(); }
  std::size_t degree(std::size_t v) const { return m_rings[v].size(); }
  std::size_t neighbor(std::size_t v, std::size_t place) const { return m_rings[v][place % degree(v)]; }

  std::size_t place(std::size_t v, std::size_t neighbor) const
  {
    const std::vector<std::size_t>& ring = m_rings[v];
    return static_cast<std::size_t>(std::find(ring.begin(), ring.end(), neighbor) - ring.begin());
  }

  bool are_adjacent(std::size_t v, std::size_t w) const
  {
    return degree(v) <= degree(w) ? place(v, w) < degree(v) : place(w, v) < degree(w);
  }

  // each corner as likely as the others
  Corner random_corner(Random& random) const
  {
    std::size_t k = random.below(6 * size() - 12);
    std::size_t v = 0;
    for(; k >= degree(v); ++v)
      k -= degree(v);
    return {v, k};
  }

  Corner random_corner_at(std::size_t v, Random& random) const { return {v, random.below(degree(v))}; }

  // Splits a vertex v: the new vertex is joined to v, to the neighbour of the corner and to the n_taken + 1 that
  // follow, and v loses the n_taken of them that are neither the first nor the last. With n_taken = 0 the new vertex is
  // in a face. Precondition: n_taken + 2 <= degree(v)
  void split(Corner c, std::size_t n_taken)
  {
    const std::size_t v = c.vertex, w = size(), d = degree(v);
    std::vector<std::size_t>& ring = m_rings[v];
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(c.place), ring.end());
    const std::size_t first = ring[0], last = ring[n_taken + 1];
    std::vector<std::size_t> new_ring(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(n_taken + 2));
    new_ring.push_back(v);
    for(std::size_t i = 1; i <= n_taken; ++i)
      m_rings[ring[i]][place(ring[i], v)] = w;
    std::vector<std::size_t> rest = {first, w};
    for(std::size_t i = n_taken + 1; i < d; ++i)
      rest.push_back(ring[i]);
    ring = std::move(rest);
    insert(first, place(first, v), w);
    insert(last, place(last, v) + 1, w);
    m_rings.push_back(std::move(new_ring));
  }

  // Flips the edge of a corner, unless there is an edge already where the new one would be.
  bool flip(Corner c)
  {
    const std::size_t v = c.vertex, w = neighbor(v, c.place);
    const std::size_t left = neighbor(v, c.place + 1), right = neighbor(v, c.place + degree(v) - 1);
    if(are_adjacent(left, right))
      return false;
    remove(v, w);
    remove(w, v);
    insert(left, place(left, v) + 1, right);
    insert(right, place(right, v), left);
    return true;
  }

  std::vector<Triangle> triangles() const
  {
    std::vector<Triangle> result;
    for(std::size_t v = 0; v < size(); ++v)
      for(std::size_t k = 0; k < degree(v); ++k)
        if(v < neighbor(v, k) && v < neighbor(v, k + 1))
          result.push_back({v, neighbor(v, k), neighbor(v, k + 1)});
    return result;
  }

private:
  void insert(std::size_t v, std::size_t place, std::size_t neighbor)
  {
    m_rings[v].insert(m_rings[v].begin() + static_cast<std::ptrdiff_t>(place), neighbor);
  }

  void remove(std::size_t v, std::size_t neighbor)
  {
    m_rings[v].erase(m_rings[v].begin() + static_cast<std::ptrdiff_t>(place(v, neighbor)));
  }

  std::vector<std::vector<std::size_t>> m_rings = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}}; // counterclockwise
};

// The ways to make a triangulation grow to n vertices.

inline void grow_stacked(Growing_triangulation& t, std::size_t n, Random& random)
{
  while(t.size() < n)
    t.split(t.random_corner(random), 0);
}

inline void grow_nested(Growing_triangulation& t, std::size_t n, Random& random)
{
  while(t.size() < n)
    t.split(t.random_corner_at(t.size() - 1, random), 0);
}

// Puts a triangle into a face, joined to its corners as in an octahedron, and then another into this triangle, and so
// on.
inline void grow_tube(Growing_triangulation& t, std::size_t n, Random& random)
{
  Growing_triangulation::Corner face = t.random_corner(random);
  while(t.size() + 3 <= n)
  {
    const std::size_t x = t.size(), y = x + 1, z = x + 2;
    const std::size_t b = t.neighbor(face.vertex, face.place), c = t.neighbor(face.vertex, face.place + 1);
    t.split(face, 0);
    t.split({x, t.place(x, b)}, 0);
    t.split({x, t.place(x, c)}, 0);
    t.flip({x, t.place(x, c)});
    face = {x, t.place(x, y)};
    if(t.neighbor(x, face.place + 1) != z)
      throw std::logic_error("The new triangle is no face.");
  }
  grow_stacked(t, n, random);
}

inline void grow_split(Growing_triangulation& t, std::size_t n, Random& random)
{
  while(t.size() < n)
  {
    const std::size_t v = random.below(t.size());
    const std::size_t n_taken = random.below(t.degree(v) - 1);
    t.split(t.random_corner_at(v, random), n_taken);
  }
}

inline void grow_low_degree(Growing_triangulation& t, std::size_t n, Random& random)
{
  grow_split(t, t.size() + (n - t.size()) / 3, random);
  const std::size_t n_old = t.size();
  while(t.size() < n)
  {
    // the faces between old vertices only, as long as they are easily found
    Growing_triangulation::Corner c = t.random_corner(random);
    for(int i = 0; i < 20 && (t.neighbor(c.vertex, c.place) >= n_old || t.neighbor(c.vertex, c.place + 1) >= n_old);
        ++i)
      c = t.random_corner_at(random.below(n_old), random);
    t.split(c, random.one_in(3) && t.degree(c.vertex) > 3 ? 1 : 0);
  }
}

inline void grow_hub(Growing_triangulation& t, std::size_t n, Random& random)
{
  while(t.size() < n)
    t.split(t.random_corner_at(0, random), 0);
}

inline void grow_hubs(Growing_triangulation& t, std::size_t n, Random& random)
{
  const std::size_t n_hubs = 2 + random.below(5);
  grow_split(t, (std::min)(n, n_hubs + 4), random);
  while(t.size() < n)
    t.split(t.random_corner_at(random.below(n_hubs), random), 0);
}

// A vertex other than the hubs 0 and 1 that is joined to both is split such that both parts are joined to both.
inline void grow_double_wheel(Growing_triangulation& t, std::size_t n, Random& random)
{
  while(t.size() < n)
  {
    std::size_t v = random.below(t.size());
    while(v < 2 || !t.are_adjacent(v, 0) || !t.are_adjacent(v, 1))
      v = t.neighbor(0, random.below(t.degree(0)));
    const std::size_t begin = t.place(v, 0), end = t.place(v, 1);
    t.split({v, begin}, (end + t.degree(v) - begin) % t.degree(v) - 1);
  }
}

inline void flip_edges(Growing_triangulation& t, std::size_t n_flips, Random& random)
{
  for(std::size_t i = 0; i < n_flips; ++i)
    t.flip(t.random_corner(random));
}

inline void grow_mixture(Growing_triangulation& t, std::size_t n, Random& random)
{
  using Grow = void (*)(Growing_triangulation&, std::size_t, Random&);
  static constexpr Grow ways[] = {grow_stacked,    grow_nested, grow_tube, grow_split,
                                  grow_low_degree, grow_hub,    grow_hubs};
  while(t.size() < n)
  {
    const std::size_t step = 1 + random.below(30);
    ways[random.below(7)](t, (std::min)(n, t.size() + step), random);
    if(random.one_in(4))
      flip_edges(t, random.below(2 * t.size()), random);
  }
}

inline std::vector<Triangle> random_triangles(Connectivity connectivity, std::size_t n, Random& random)
{
  Growing_triangulation t;
  switch(connectivity)
  {
  case STACKED:
    grow_stacked(t, n, random);
    break;
  case NESTED:
    grow_nested(t, n, random);
    break;
  case TUBE:
    grow_tube(t, n, random);
    break;
  case FLIPPED:
    grow_stacked(t, n, random);
    flip_edges(t, 5 * n, random);
    break;
  case SPLIT:
    grow_split(t, n, random);
    break;
  case LOW_DEGREE:
    grow_low_degree(t, n, random);
    break;
  case HUB:
    grow_hub(t, n, random);
    break;
  case HUBS:
    grow_hubs(t, n, random);
    break;
  case DOUBLE_WHEEL:
    grow_double_wheel(t, n, random);
    if(random.one_in(2)) // the hubs need not be neighbours
      t.flip({0, t.place(0, 1)});
    break;
  case MIXTURE:
  case NUMBER_OF_CONNECTIVITIES:
    grow_mixture(t, n, random);
    break;
  }
  return t.triangles();
}

// o + s u + t v
inline Coordinates combination(const Coordinates& o, double s, const Coordinates& u, double t, const Coordinates& v)
{
  return {o[0] + s * u[0] + t * v[0], o[1] + s * u[1] + t * v[1], o[2] + s * u[2] + t * v[2]};
}

// Moves the vertices of a random sphere to the means of their neighbours, again and again.
inline std::vector<Coordinates> smoothed_sphere(std::size_t n, const std::vector<Triangle>& triangles, Random& random)
{
  std::vector<Coordinates> points(n);
  for(Coordinates& p : points)
    p = random.direction();
  const std::size_t n_steps = random.below(20);
  for(std::size_t i = 0; i < n_steps; ++i)
  {
    std::vector<Coordinates> sums(n, Coordinates{0., 0., 0.});
    Coordinates center = {0., 0., 0.};
    for(const Triangle& t : triangles)
      for(std::size_t k = 0; k < 3; ++k)
        sums[t[k]] = combination(sums[t[k]], 1., points[t[(k + 1) % 3]], 1., points[t[(k + 2) % 3]]);
    for(std::size_t v = 0; v < n; ++v)
    {
      const Coordinates &s = sums[v], &p = points[v];
      const double length = std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
      points[v] = length > 0. ? combination(p, 1. / length, s, 0., s) : p;
      center = combination(center, 1. / static_cast<double>(n), points[v], 0., p);
    }
    for(Coordinates& p : points)
    {
      const Coordinates q = combination(p, -1., center, 0., center);
      const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
      p = length > 0. ? Coordinates{q[0] / length, q[1] / length, q[2] / length} : random.direction();
    }
  }
  return points;
}

// Whether two vertices are at the same point.
inline bool has_coincident(std::vector<Coordinates> points)
{
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) != points.end();
}

inline std::vector<Coordinates> random_points(Placement placement, std::size_t n,
                                              const std::vector<Triangle>& triangles, Random& random)
{
  const Coordinates o = random.in_ball(), u = random.direction(), v = random.direction(); // origin and axes
  const double noise = random.one_in(4) ? 0. : random.magnitude(-50, -29);
  std::vector<Coordinates> points(n);
  switch(placement)
  {
  case BALL:
    for(Coordinates& p : points)
      p = random.in_ball();
    break;
  case CLUSTERED: {
    std::vector<Coordinates> centers(1 + random.below(6));
    std::vector<double> sizes;
    for(Coordinates& c : centers)
    {
      c = random.in_ball();
      sizes.push_back(random.magnitude(-40, -3));
    }
    const bool is_orderly = random.one_in(2); // vertices of one cluster are near each other in the mesh too
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t k = is_orderly ? i * centers.size() / n : random.below(centers.size());
      points[i] = combination(centers[k], sizes[k], random.in_ball(), 0., o);
    }
    break;
  }
  case COLLINEAR:
  case COPLANAR:
    for(Coordinates& p : points)
    {
      const double s = random.between(-1., 1.), t = placement == COLLINEAR ? 0. : random.between(-1., 1.);
      p = combination(combination(o, s, u, t, v), noise, random.in_ball(), 0., o);
    }
    break;
  case SPHERE:
    do
      points = smoothed_sphere(n, triangles, random);
    while(has_coincident(points));
    break;
  case SCALES:
    for(Coordinates& p : points)
      for(double& x : p)
      {
        x = random.magnitude(-332, 332);
        x = random.one_in(2) ? x : -x;
      }
    break;
  case SOME_COINCIDE: {
    points = random_points(static_cast<Placement>(random.below(SOME_COINCIDE)), n, triangles, random);
    const std::size_t n_moved = 1 + random.below(n - 1);
    for(std::size_t i = 0; i < n_moved; ++i)
    {
      // half of them to a neighbour, the last one in any case
      const Triangle& t = triangles[random.below(triangles.size())];
      points[t[0]] = points[i + 1 == n_moved || random.one_in(2) ? t[1] : random.below(n)];
    }
    break;
  }
  case ALL_COINCIDE:
  case NUMBER_OF_PLACEMENTS:
    points.assign(n, o);
    break;
  }
  return points;
}

struct Random_triangulation
{
  Connectivity connectivity;
  Placement placement;
  Triangle_list list;

  std::string kind() const
  {
    return std::string(to_string(connectivity)) + ", " + to_string(placement) + ", " +
           std::to_string(list.points.size()) + " vertices";
  }
};

// From 4 to 300, as many between 4 and 8 as between 128 and 256, and even more: small ones are as likely to go wrong as
// large ones, and faster.
inline std::size_t random_size(Random& random)
{
  const auto draw = [&] {
    std::size_t n = 301;
    while(n > 300)
      n = static_cast<std::size_t>(random.magnitude(2, 9));
    return n;
  };
  const std::size_t n = draw();
  return random.one_in(2) ? n : (std::min)(n, draw());
}

// The triangulation of this seed. Its vertices are numbered in random order.
inline Random_triangulation random_triangulation(std::uint64_t seed)
{
  Random random(seed);
  Random_triangulation result;
  result.connectivity = static_cast<Connectivity>(random.below(NUMBER_OF_CONNECTIVITIES));
  result.placement = static_cast<Placement>(random.below(NUMBER_OF_PLACEMENTS));
  const std::size_t n = random_size(random);
  Triangle_list list;
  list.triangles = random_triangles(result.connectivity, n, random);
  list.points = random_points(result.placement, n, list.triangles, random);
  const std::uint32_t order = static_cast<std::uint32_t>(random.below(std::size_t(1) << 31));
  result.list = test_meshes::renumbered(list, test_meshes::random_permutation(n, order), order);
  return result;
}

} // namespace random_triangulations

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_RANDOM_TRIANGULATIONS_H
