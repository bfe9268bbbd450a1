#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_MESHES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_MESHES_H

// Meshes for the tests, made without a file and the same on every machine: plain lists of points and triangles first
// (Triangle_list), then a mesh of any type (make_mesh), and a map from its vertices to points (make_vertex_map).

#include "standard_library.h"

#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace test_meshes {

using CGAL::Spherical_parameterization::internal::cosine;
using CGAL::Spherical_parameterization::internal::exponential;
using CGAL::Spherical_parameterization::internal::hypotenuse;
using CGAL::Spherical_parameterization::internal::sine;

using Coordinates = std::array<double, 3>;
using Triangle = std::array<std::size_t, 3>;

struct Triangle_list
{
  std::vector<Coordinates> points;
  std::vector<Triangle> triangles;
};

constexpr double pi = 3.14159265358979323846;

// The point at distance 1 from the origin in the direction of p.
inline Coordinates normalized(const Coordinates& p)
{
  const double length = hypotenuse(p[0], p[1], p[2]);
  return {p[0] / length, p[1] / length, p[2] / length};
}

// The mesh, stretched along the axes by a factor each.
inline Triangle_list scaled(Triangle_list list, double x, double y, double z)
{
  for(Coordinates& p : list.points)
    p = {x * p[0], y * p[1], z * p[2]};
  return list;
}

// The mesh, turned about the axis of z.
inline Triangle_list turned(Triangle_list list, double angle)
{
  for(Coordinates& p : list.points)
    p = {cosine(angle) * p[0] - sine(angle) * p[1], sine(angle) * p[0] + cosine(angle) * p[1], p[2]};
  return list;
}

// The mesh, turned about two axes, so that nothing of it coincides with what it coincided with before.
inline Triangle_list tilted(Triangle_list list)
{
  list = turned(list, 0.1);
  for(Coordinates& p : list.points)
    p = {p[2], p[0], p[1]};
  return turned(list, 0.2);
}

// A regular tetrahedron on the unit sphere.
inline Triangle_list tetrahedron()
{
  const double s = 1. / std::sqrt(3.);
  return {{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

// A regular octahedron on the unit sphere.
inline Triangle_list octahedron()
{
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

// A regular icosahedron on the unit sphere, each face cut into four `subdivisions` times, new vertices on the sphere:
// 10 * 4^subdivisions + 2 vertices.
inline Triangle_list icosphere(unsigned int subdivisions)
{
  Triangle_list list;
  const double t = 0.5 * (1. + std::sqrt(5.));
  for(const Coordinates& p :
      {Coordinates{-1, t, 0}, Coordinates{1, t, 0}, Coordinates{-1, -t, 0}, Coordinates{1, -t, 0},
       Coordinates{0, -1, t}, Coordinates{0, 1, t}, Coordinates{0, -1, -t}, Coordinates{0, 1, -t},
       Coordinates{t, 0, -1}, Coordinates{t, 0, 1}, Coordinates{-t, 0, -1}, Coordinates{-t, 0, 1}})
    list.points.push_back(normalized(p));
  list.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};

  for(unsigned int i = 0; i < subdivisions; ++i)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
    const auto midpoint = [&](std::size_t a, std::size_t b) {
      const auto inserted =
          midpoints.emplace(std::pair<std::size_t, std::size_t>(std::minmax(a, b)), list.points.size());
      if(inserted.second)
      {
        const Coordinates p = list.points[a], q = list.points[b];
        list.points.push_back(normalized({p[0] + q[0], p[1] + q[1], p[2] + q[2]}));
      }
      return inserted.first->second;
    };

    std::vector<Triangle> finer;
    for(const Triangle& t0 : list.triangles)
    {
      const std::size_t a = midpoint(t0[0], t0[1]), b = midpoint(t0[1], t0[2]), c = midpoint(t0[2], t0[0]);
      finer.push_back({t0[0], a, c});
      finer.push_back({t0[1], b, a});
      finer.push_back({t0[2], c, b});
      finer.push_back({a, b, c});
    }
    list.triangles = std::move(finer);
  }
  return list;
}

// An ellipsoid with the given semi-axes: an icosphere, stretched.
inline Triangle_list ellipsoid(double x, double y, double z, unsigned int subdivisions)
{
  return scaled(icosphere(subdivisions), x, y, z);
}

// The suspension of a polygon with n corners: the corners on the equator, then the north pole and the south pole.
// Corner i has the longitude 2 pi i turns / n. With one turn this is a double pyramid; with two turns, n >= 5, it
// keeps the topology of one, and all its faces are positive, but it covers the sphere twice.
inline Triangle_list suspension(std::size_t n, unsigned int turns = 1)
{
  Triangle_list list;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double longitude = 2. * pi * static_cast<double>(turns) * static_cast<double>(i) / static_cast<double>(n);
    list.points.push_back({cosine(longitude), sine(longitude), 0.});
    list.triangles.push_back({i, (i + 1) % n, n});
    list.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  list.points.push_back({0., 0., 1.});
  list.points.push_back({0., 0., -1.});
  return list;
}

// Puts a vertex into the face, which keeps its first edge; the faces at the others are the last two then.
inline void split_face(Triangle_list& list, std::size_t face, Coordinates point)
{
  const Triangle t = list.triangles[face];
  const std::size_t v = list.points.size();
  list.points.push_back(point);
  list.triangles[face] = {t[0], t[1], v};
  list.triangles.push_back({t[1], t[2], v});
  list.triangles.push_back({t[2], t[0], v});
}

inline Coordinates centroid(const Triangle_list& list, const Triangle& t)
{
  Coordinates sum = {0., 0., 0.};
  for(const std::size_t v : t)
    for(std::size_t i = 0; i < 3; ++i)
      sum[i] += list.points[v][i] / 3.;
  return sum;
}

// A tetrahedron, then n times a vertex in the middle of the newest face: triangles within triangles.
inline Triangle_list nested_triangles(std::size_t n)
{
  Triangle_list list = tetrahedron();
  for(std::size_t k = 0; k < n; ++k)
    split_face(list, list.triangles.size() - 1, centroid(list, list.triangles.back()));
  return list;
}

// A tetrahedron, then n times a vertex in the middle of a face, put onto the unit sphere: vertices of degree 3 and
// of very high degree, big faces next to small ones. The engine is specified by the standard, and its numbers are used
// as they are, so that the mesh does not depend on the standard library.
inline Triangle_list random_stacked_sphere(std::size_t n, std::uint32_t seed)
{
  std::mt19937 random(seed);
  Triangle_list list = tetrahedron();
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t face = random() % list.triangles.size();
    split_face(list, face, normalized(centroid(list, list.triangles[face])));
  }
  return list;
}

// A sphere with an extremity, horns and dents, star-shaped about the origin and without any symmetry, so that no two of its
// vertices look alike: the stand-in for a scanned bunny. It has 10 * 4^subdivisions + 2 vertices.
inline Triangle_list bumpy_sphere(unsigned int subdivisions)
{
  Triangle_list list = icosphere(subdivisions);
  const auto bump = [](const Coordinates& p, const Coordinates& direction, double sharpness, double height) {
    const Coordinates c = normalized(direction);
    return height * exponential(sharpness * (p[0] * c[0] + p[1] * c[1] + p[2] * c[2] - 1.));
  };
  for(Coordinates& p : list.points)
  {
    const double r = 1. + bump(p, {1., 0.2, 0.3}, 4., 0.7) + bump(p, {-0.3, 1., -0.5}, 8., 1.2) +
                     bump(p, {0.1, -0.4, 1.}, 30., 2.5) + bump(p, {-1., -0.3, 0.8}, 20., 1.5) -
                     bump(p, {0.5, -1., -0.6}, 6., 0.4);
    p = {r * p[0], r * p[1], r * p[2]};
  }
  return list;
}

// A surface from the point `first` through m rings of n points each, point(k, angle), to the point `last`. Each ring is turned by half
// a step against the one before.
template <class Function>
Triangle_list surface_of_rings(const Coordinates& first, std::size_t m, std::size_t n, const Function& point,
                               const Coordinates& last)
{
  Triangle_list list;
  for(std::size_t k = 0; k < m; ++k)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t j = (i + 1) % n, a = n * k, b = a + n;
      const double turn = static_cast<double>(i) + 0.5 * static_cast<double>(k);
      list.points.push_back(point(k, 2. * pi * turn / static_cast<double>(n)));
      list.triangles.push_back({a + i, a + j, k + 1 < m ? b + i : n * m + 1});
      list.triangles.push_back(k + 1 < m ? Triangle{a + j, b + j, b + i} : Triangle{n * m, j, i});
    }
  list.points.push_back(first);
  list.points.push_back(last);
  return list;
}

// A sphere with a tentacle of `n_rings` rings of 8 vertices, `length` long and 0.2 thick. A conformal map shrinks it
// like exp(-2 pi length / circumference): beyond what doubles resolve.
inline Triangle_list with_tentacle(std::size_t n_rings, double length)
{
  const auto point = [&](std::size_t k, double angle) -> Coordinates {
    const double latitude = pi * (static_cast<double>(k + 1) / 12. - 0.5),
                 share = (static_cast<double>(k) - 11.) / static_cast<double>(n_rings),
                 r = k < 11 ? cosine(latitude) : 0.1, z = k < 11 ? sine(latitude) : 1. + length * share;
    return {r * cosine(angle), r * sine(angle), z};
  };
  return surface_of_rings({0., 0., -1.}, 11 + n_rings, 8, point, {0., 0., 1. + length});
}

// The mesh with `n` slivers, spread over it: as many new vertices on edges, at this share of their length from an end, which
// have slivers on both sides of the short part.
inline Triangle_list with_slivers(Triangle_list list, std::size_t n, double share)
{
  const std::size_t n_faces = list.triangles.size();
  for(std::size_t k = 0; k < n; ++k)
  {
    const Triangle t = list.triangles[k * n_faces / n];
    const Coordinates p = list.points[t[0]], q = list.points[t[1]];
    const std::size_t v = list.points.size();
    list.points.push_back({p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]), p[2] + share * (q[2] - p[2])});
    for(std::size_t f = 0, end = list.triangles.size(); f < end; ++f)
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Triangle s = list.triangles[f];
        const std::size_t a = s[i], b = s[(i + 1) % 3], c = s[(i + 2) % 3];
        if((a == t[0] && b == t[1]) || (a == t[1] && b == t[0]))
        {
          list.triangles[f] = {a, v, c};
          list.triangles.push_back({v, b, c});
          break;
        }
      }
  }
  return list;
}

// A random order of 0, ..., n - 1, the same on every machine.
inline std::vector<std::size_t> random_permutation(std::size_t n, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::vector<std::size_t> permutation(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = random() % (i + 1);
    permutation[i] = permutation[j];
    permutation[j] = i;
  }
  return permutation;
}

// The same mesh with vertex v called number[v], the faces in random order, and each of them starting anywhere.
inline Triangle_list renumbered(const Triangle_list& list, const std::vector<std::size_t>& number, std::uint32_t seed)
{
  std::mt19937 random(seed);
  Triangle_list result;
  result.points.resize(list.points.size());
  for(std::size_t v = 0; v < number.size(); ++v)
    result.points[number[v]] = list.points[v];
  for(const std::size_t f : random_permutation(list.triangles.size(), seed))
  {
    const Triangle& t = list.triangles[f];
    const std::size_t k = random() % 3;
    result.triangles.push_back({number[t[k]], number[t[(k + 1) % 3]], number[t[(k + 2) % 3]]});
  }
  return result;
}

// A torus around the z-axis, of m times n quadrangles, each cut in two.
inline Triangle_list torus(std::size_t m, std::size_t n)
{
  Triangle_list list;
  for(std::size_t i = 0; i < m; ++i)
  {
    const double longitude = 2. * pi * static_cast<double>(i) / static_cast<double>(m);
    for(std::size_t j = 0; j < n; ++j)
    {
      const double angle = 2. * pi * static_cast<double>(j) / static_cast<double>(n);
      const double r = 2. + cosine(angle);
      list.points.push_back({r * cosine(longitude), r * sine(longitude), sine(angle)});
      const std::size_t i1 = (i + 1) % m, j1 = (j + 1) % n;
      list.triangles.push_back({i * n + j, i1 * n + j, i1 * n + j1});
      list.triangles.push_back({i * n + j, i1 * n + j1, i * n + j1});
    }
  }
  return list;
}

// Both lists as one, side by side in memory, not in space.
inline Triangle_list disjoint_union(Triangle_list first, const Triangle_list& second)
{
  const std::size_t n = first.points.size();
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for(const Triangle& t : second.triangles)
    first.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return first;
}

// A mesh with these vertices and faces, in this order. `Mesh` is a model of MutableFaceGraph with a vertex point map.
template <class Mesh>
Mesh make_mesh(const Triangle_list& list)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Point =
      typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;

  Mesh mesh;
  auto point_map = get(CGAL::vertex_point, mesh);
  std::vector<Vertex> vertex;
  for(const Coordinates& p : list.points)
  {
    vertex.push_back(add_vertex(mesh));
    put(point_map, vertex.back(), Point(FT(p[0]), FT(p[1]), FT(p[2])));
  }
  std::vector<std::array<Vertex, 3>> faces;
  for(const Triangle& t : list.triangles)
    faces.push_back({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
  CGAL::Euler::add_faces(faces, mesh); // one by one takes a time that is quadratic in the degrees
  if(num_faces(mesh) != faces.size())
    throw std::logic_error("The triangles are no manifold mesh.");
  return mesh;
}

// A map from the vertices of `mesh`, in their order, to these points.
template <class Point, class Mesh>
auto make_vertex_map(const Mesh& mesh, const std::vector<Coordinates>& points)
{
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;

  auto map = get(CGAL::dynamic_vertex_property_t<Point>(), mesh);
  auto p = points.begin();
  for(const auto v : vertices(mesh))
  {
    put(map, v, Point(FT((*p)[0]), FT((*p)[1]), FT((*p)[2])));
    ++p;
  }
  return map;
}

} // namespace test_meshes

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_MESHES_H
