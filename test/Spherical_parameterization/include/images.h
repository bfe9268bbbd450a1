#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_IMAGES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_IMAGES_H

// The images of vertices as plain points: read from a property map, compared, and the arithmetic of vectors.

#include "test_meshes.h"

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

namespace test {

using namespace test_meshes;

using Images = std::vector<Coordinates>;

inline Coordinates combination(double s, const Coordinates& p, double t, const Coordinates& q)
{
  return {s * p[0] + t * q[0], s * p[1] + t * q[1], s * p[2] + t * q[2]};
}

inline Coordinates difference(const Coordinates& p, const Coordinates& q)
{
  return combination(1., p, -1., q);
}

inline double dot(const Coordinates& p, const Coordinates& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

inline Coordinates cross(const Coordinates& p, const Coordinates& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

inline double norm(const Coordinates& p)
{
  return std::hypot(p[0], p[1], p[2]);
}

inline double distance(const Coordinates& p, const Coordinates& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

inline double area(const Coordinates& a, const Coordinates& b, const Coordinates& c)
{
  return 0.5 * norm(cross(difference(b, a), difference(c, a)));
}

inline Images scaled(Images images, double factor)
{
  for(Coordinates& p : images)
    p = {factor * p[0], factor * p[1], factor * p[2]};
  return images;
}

inline Images directions_of(Images points)
{
  for(Coordinates& p : points)
    p = test_meshes::normalized(p);
  return points;
}

// Rings of n points around a direction, each nearer to it by the factor `ratio` than the one before, m of them, with its opposite on
// the other side: a map of a tube. The direction is that of no axis, next to which floats are dense.
inline Triangle_list tube(std::size_t n, std::size_t m, double ratio, double radius)
{
  const Coordinates u = test_meshes::normalized({0.6, -0.5, 0.8}), s = test_meshes::normalized(cross(u, {1., 0., 0.})),
                    t = cross(u, s);
  return surface_of_rings(
      scaled({u}, -radius)[0], m, n,
      [&](std::size_t k, double turn) {
        const double angle = 2. * std::atan(2. * std::pow(ratio, static_cast<double>(k)));
        const Coordinates side = combination(std::cos(turn), s, std::sin(turn), t);
        return combination(radius * std::cos(angle), u, radius * std::sin(angle), side);
      },
      scaled({u}, radius)[0]);
}

// The images of all vertices in the order of the mesh.
template <class Mesh, class VertexPointMap>
Images images(const Mesh& mesh, const VertexPointMap& map)
{
  Images result;
  for(const auto v : vertices(mesh))
  {
    const auto& p = get(map, v);
    result.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  return result;
}

// Points that no parameterizer would write, so that every write shows.
inline Images sentinels(std::size_t n)
{
  Images result;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double x = static_cast<double>(i);
    result.push_back({1e9 + x, -1e-9 * x, 1e6 * x});
  }
  return result;
}

template <class Point, class Mesh>
auto make_sentinel_map(const Mesh& mesh)
{
  return make_vertex_map<Point>(mesh, sentinels(num_vertices(mesh)));
}

inline bool is_finite(const Images& images)
{
  return std::all_of(images.begin(), images.end(), [](const Coordinates& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  });
}

// Whether two maps are the same to the last bit; unlike ==, this distinguishes 0 from -0, and a NaN is equal to itself.
inline bool have_same_bits(const Images& a, const Images& b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Coordinates)) == 0);
}

// The largest distance between the images of a vertex under two maps.
inline double largest_distance(const Images& a, const Images& b)
{
  double result = a.size() == b.size() ? 0. : HUGE_VAL;
  for(std::size_t v = 0; v < (std::min)(a.size(), b.size()); ++v)
  {
    const double d = distance(a[v], b[v]);
    result = d > result || d != d ? d : result;
  }
  return result;
}

// The largest difference of the distances of two points under two maps that may be turned against each other.
inline double largest_difference_up_to_rotation(const Images& a, const Images& b)
{
  double result = a.size() == b.size() ? 0. : HUGE_VAL;
  for(std::size_t v = 0; v < (std::min)(a.size(), b.size()); ++v)
    for(std::size_t k = 1; k < 20; ++k)
    {
      const std::size_t w = (v + k * k * k) % a.size();
      const double d = std::abs(distance(a[v], a[w]) - distance(b[v], b[w]));
      result = d > result || d != d ? d : result;
    }
  return result;
}

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_IMAGES_H
