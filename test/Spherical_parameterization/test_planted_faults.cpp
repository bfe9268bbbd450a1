// The certificate finds every fault that is planted into a map that is one-to-one, and finds none where none is: a
// thousand maps and more, of each of them nine faulty versions. What is a fault is decided by arithmetic of the test's
// own.

#include <CGAL/spherical_parameterization.h>

#include "independent_check.h"
#include "test_maps.h"
#include "test_meshes.h"
#include "test_scale.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <queue>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using test_meshes::Coordinates;
using test_meshes::Triangle;
using test_meshes::Triangle_list;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Rational = CGAL::Exact_rational;

using Triangles = std::vector<Triangle>;

template <class Number>
using Image = std::array<Number, 3>;

// A map from the vertices of a closed mesh to points around the origin.
template <class Number>
struct Map
{
  Triangles triangles;
  std::vector<Image<Number>> images;
};

// ---------------------------------------------------------------------------------------------------------------------
// The judge. It shares no code with the package, and it finds the degree in another way: by the Riemann-Hurwitz formula,
// from how often the faces at each vertex turn around its image.

template <class Number>
Number determinant(const Image<Number>& a, const Image<Number>& b, const Image<Number>& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

template <class Number>
Coordinates rounded(const Image<Number>& p)
{
  return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
}

// the exact sign of the determinant of finite points
template <class Number>
int sign_of_determinant(const Image<Number>& a, const Image<Number>& b, const Image<Number>& c)
{
  if constexpr(std::is_floating_point<Number>::value)
    return independent_check::sign_of_determinant(rounded(a), rounded(b), rounded(c));
  else
    return CGAL::sign(determinant(a, b, c));
}

template <class Number>
bool is_positive(const Map<Number>& map, const Triangle& t)
{
  return sign_of_determinant(map.images[t[0]], map.images[t[1]], map.images[t[2]]) > 0;
}

template <class Number>
bool is_positive(const Map<Number>& map)
{
  return std::all_of(map.triangles.begin(), map.triangles.end(),
                     [&](const Triangle& t) { return is_positive(map, t); });
}

// the faces at each vertex, turned so that the vertex comes first
template <class Number>
std::vector<std::vector<Triangle>> stars(const Map<Number>& map)
{
  std::vector<std::vector<Triangle>> result(map.images.size());
  for(const Triangle& t : map.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      result[t[i]].push_back({t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
  return result;
}

// How often the faces at a vertex, all of them positive, turn around its image: that many of them contain the direction
// to any of the neighbours.
template <class Number>
std::size_t number_of_turns(const Map<Number>& map, const std::vector<Triangle>& faces)
{
  const auto sign = [&](std::size_t a, std::size_t b, std::size_t c) {
    return sign_of_determinant(map.images[a], map.images[b], map.images[c]);
  };
  const std::size_t v = faces[0][0], w = faces[0][1];
  return static_cast<std::size_t>(std::count_if(
      faces.begin(), faces.end(), [&](const Triangle& t) { return sign(v, t[1], w) >= 0 && sign(v, w, t[2]) > 0; }));
}

// Precondition: all faces are positive, and the mesh is a topological sphere.
template <class Number>
std::size_t degree(const Map<Number>& map)
{
  std::size_t n_more_turns = 0; // than one
  for(const std::vector<Triangle>& faces : stars(map))
    n_more_turns += number_of_turns(map, faces) - 1;
  return 1 + n_more_turns / 2;
}

template <class Number>
bool is_one_to_one(const Map<Number>& map)
{
  return is_positive(map) && degree(map) == 1;
}

// ---------------------------------------------------------------------------------------------------------------------
// The faults. Each of them takes a map that is one-to-one and returns one that surely is not.

using Random = std::mt19937;

std::size_t one_of(std::size_t n, Random& random)
{
  return random() % n;
}

// the neighbours of the vertex whose star this is, counterclockwise
std::vector<std::size_t> ring(const std::vector<Triangle>& faces)
{
  std::map<std::size_t, std::size_t> successor;
  for(const Triangle& t : faces)
    successor[t[1]] = t[2];
  std::vector<std::size_t> result = {successor.begin()->first};
  while(result.size() < successor.size())
    result.push_back(successor[result.back()]);
  return result;
}

// A point across the opposite edge of a face, as seen from its first vertex: so near that edge as rounding allows.
template <class Number>
Image<Number> point_across(const Map<Number>& map, const Triangle& t)
{
  const Image<Number>&v = map.images[t[0]], &a = map.images[t[1]], &b = map.images[t[2]];
  for(int k = -10; k <= 10; ++k)
  {
    const Number factor = Number(std::ldexp(1., k));
    Image<Number> result;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Number middle = a[i] + b[i];
      result[i] = middle + factor * (middle - v[i]);
    }
    if(sign_of_determinant(result, a, b) < 0)
      return result;
  }
  return {-v[0], -v[1], -v[2]};
}

template <class Number>
Map<Number> with_fold(Map<Number> map, Random& random)
{
  const std::size_t v = one_of(map.images.size(), random);
  const std::vector<Triangle> faces = stars(map)[v];
  map.images[v] = point_across(map, faces[one_of(faces.size(), random)]);
  return map;
}

// The last map that is one-to-one and the first that is not when a vertex is moved straight across an edge. Of floating
// point numbers, a single coordinate differs, by one unit in the last place; of exact ones, all by 2^-100 of the way.
template <class Number>
std::array<Map<Number>, 2> around_fold(const Map<Number>& map, Random& random)
{
  const std::size_t v = one_of(map.images.size(), random);
  const std::vector<Triangle> faces = stars(map)[v];
  std::array<Map<Number>, 2> result = {map, map};
  Image<Number>&good = result[0].images[v], &bad = result[1].images[v];
  bad = point_across(map, faces[one_of(faces.size(), random)]);
  Map<Number> moved = map;
  const auto is_good = [&](const Image<Number>& p) {
    moved.images[v] = p;
    return std::all_of(faces.begin(), faces.end(), [&](const Triangle& t) { return is_positive(moved, t); });
  };
  const auto halve = [&] {
    Image<Number> middle;
    for(std::size_t i = 0; i < 3; ++i)
      middle[i] = good[i] / 2 + bad[i] / 2;
    const bool is_new = middle != good && middle != bad;
    (is_good(middle) ? good : bad) = middle;
    return is_new;
  };
  if constexpr(std::is_floating_point<Number>::value)
  {
    while(halve())
    {}
    for(std::size_t i = 0; i < 3; ++i)
    {
      Image<Number> next = good;
      next[i] = bad[i];
      if(!is_good(next))
      {
        bad = next;
        break;
      }
      good = next;
    }
  }
  else
    for(int k = 0; k < 100; ++k)
      halve();
  return result;
}

template <class Number>
Map<Number> with_swap(Map<Number> map, Random& random)
{
  const Triangle& t = map.triangles[one_of(map.triangles.size(), random)];
  std::swap(map.images[t[0]], map.images[t[1]]); // this face is turned over, whatever the others do
  return map;
}

// Two copies of the mesh, slit along a path between two vertices and glued crosswise: again a sphere, all of whose faces
// are positive. Only that it goes round twice about both ends of the path tells that it is no bijection.
// Precondition: some two vertices are no neighbours.
template <class Number>
Map<Number> with_double_cover(const Map<Number>& map, Random& random)
{
  const std::size_t n = map.images.size();
  const std::vector<std::vector<Triangle>> faces = stars(map);
  // A shortest path of at least two edges; with one edge only, the two ends would be joined by two edges afterwards.
  std::vector<std::size_t> from, path;
  while(path.size() < 3)
  {
    const std::size_t start = one_of(n, random);
    from.assign(n, n);
    from[start] = start;
    std::queue<std::size_t> queue;
    queue.push(start);
    std::vector<std::size_t> far_vertices;
    while(!queue.empty())
    {
      const std::size_t v = queue.front();
      queue.pop();
      if(v != start && from[v] != start)
        far_vertices.push_back(v);
      for(const std::size_t w : ring(faces[v]))
        if(from[w] == n)
        {
          from[w] = v;
          queue.push(w);
        }
    }
    if(far_vertices.empty())
      continue;
    path = {far_vertices[one_of(far_vertices.size(), random)]};
    while(path.back() != start)
      path.push_back(from[path.back()]);
  }

  // the neighbours that the faces to the right of the path start with, counterclockwise around its inner vertices
  std::map<std::size_t, std::vector<std::size_t>> right_of_path;
  for(std::size_t k = 1; k + 1 < path.size(); ++k)
  {
    std::vector<std::size_t> neighbors = ring(faces[path[k]]);
    std::rotate(neighbors.begin(), std::find(neighbors.begin(), neighbors.end(), path[k - 1]), neighbors.end());
    right_of_path[path[k]].assign(neighbors.begin(), std::find(neighbors.begin(), neighbors.end(), path[k + 1]));
  }
  std::vector<std::size_t> second(n); // number of the second copy of a vertex
  Map<Number> result;
  result.images = map.images;
  for(std::size_t v = 0; v < n; ++v)
  {
    const bool is_end = v == path.front() || v == path.back();
    second[v] = is_end ? v : result.images.size();
    if(!is_end)
      result.images.push_back(map.images[v]);
  }
  for(const bool is_second : {false, true})
    for(const Triangle& t : map.triangles)
    {
      Triangle copy;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const auto right = right_of_path.find(t[i]);
        const bool is_right = right != right_of_path.end() && std::find(right->second.begin(), right->second.end(),
                                                                        t[(i + 1) % 3]) != right->second.end();
        copy[i] = is_second != is_right ? second[t[i]] : t[i];
      }
      result.triangles.push_back(copy);
    }
  return result;
}

// A face without area as seen from the origin.
template <class Number>
Map<Number> with_collapsed_face(Map<Number> map, Random& random)
{
  const Triangle& t = map.triangles[one_of(map.triangles.size(), random)];
  Image<Number>&a = map.images[t[0]], &b = map.images[t[1]], &c = map.images[t[2]];
  switch(one_of(5, random))
  {
  case 0: // two corners at one point
    a = b;
    break;
  case 1: // two corners in one direction
    a = {b[0] / 2, b[1] / 2, b[2] / 2};
    break;
  case 2: // two corners in opposite directions
    a = {-b[0], -b[1], -b[2]};
    break;
  case 3: // three corners on a great circle; the sum is exact if the others are multiples of one power of two
    if constexpr(std::is_floating_point<Number>::value)
    {
      Number size = 0;
      for(std::size_t i = 0; i < 3; ++i)
        size = (std::max)({size, std::abs(b[i]), std::abs(c[i])});
      const Number unit = std::ldexp(Number(1), std::ilogb(size) - 20);
      for(std::size_t i = 0; i < 3; ++i)
      {
        b[i] = unit * std::nearbyint(b[i] / unit);
        c[i] = unit * std::nearbyint(c[i] / unit);
      }
    }
    a = {b[0] + c[0], b[1] + c[1], b[2] + c[2]};
    break;
  default: // no direction at all
    a = {Number(0), Number(0), Number(0)};
  }
  return map;
}

// Symmetric meshes have permutations that leave the map a bijection: then it is another one's turn.
template <class Number>
Map<Number> with_permutation(const Map<Number>& map, Random& random)
{
  Map<Number> result = map;
  do
  {
    const std::vector<std::size_t> permutation =
        test_meshes::random_permutation(map.images.size(), static_cast<std::uint32_t>(random()));
    for(std::size_t v = 0; v < map.images.size(); ++v)
      result.images[v] = map.images[permutation[v]];
  } while(is_one_to_one(result));
  return result;
}

// The images of the neighbours of a vertex, one further around it each. If that is a symmetry, as it is of an octahedron
// whatever the vertex, two of them change places instead.
template <class Number>
Map<Number> with_shifted_ring(const Map<Number>& map, Random& random)
{
  Map<Number> result;
  const std::vector<std::vector<Triangle>> faces = stars(map);
  std::vector<std::size_t> neighbors;
  for(int k = 0; k < 5; ++k)
  {
    neighbors = ring(faces[one_of(faces.size(), random)]);
    const std::size_t d = neighbors.size(), shift = 1 + one_of(d - 1, random);
    result = map;
    for(std::size_t j = 0; j < d; ++j)
      result.images[neighbors[j]] = map.images[neighbors[(j + shift) % d]];
    if(!is_one_to_one(result))
      return result;
  }
  std::swap(result.images[neighbors[0]], result.images[neighbors[1]]);
  return result;
}

template <class Number>
Map<Number> antipodal(Map<Number> map, Random&)
{
  for(Image<Number>& p : map.images)
    p = {-p[0], -p[1], -p[2]};
  return map;
}

// One coordinate that is no number, or one vertex, or all of them.
template <class Number>
Map<Number> with_non_finite_coordinate(Map<Number> map, Random& random)
{
  constexpr Number infinity = std::numeric_limits<Number>::infinity();
  const Number values[] = {std::numeric_limits<Number>::quiet_NaN(), infinity, -infinity};
  const Number value = values[one_of(3, random)];
  Image<Number>& p = map.images[one_of(map.images.size(), random)];
  switch(one_of(3, random))
  {
  case 0:
    p[one_of(3, random)] = value;
    break;
  case 1:
    p = {value, value, value};
    break;
  default:
    map.images.assign(map.images.size(), {value, value, value});
  }
  return map;
}

enum Fault
{
  FOLD,
  FOLD_BY_AN_ULP,
  SWAP,
  DOUBLE_COVER,
  COLLAPSED_FACE,
  PERMUTATION,
  SHIFTED_RING,
  ANTIPODAL,
  NON_FINITE,
  number_of_faults
};

const char* const fault_names[] = {"fold",        "fold by an ulp", "swap",      "double cover", "collapsed face",
                                   "permutation", "shifted ring",   "antipodal", "non-finite"};

// all faults that the number type can have
template <class Number, class Function>
void for_each_fault(const Map<Number>& map, Random& random, const Function& f)
{
  f(FOLD, with_fold(map, random));
  f(FOLD_BY_AN_ULP, around_fold(map, random)[1]);
  f(SWAP, with_swap(map, random));
  f(DOUBLE_COVER, with_double_cover(map, random));
  f(COLLAPSED_FACE, with_collapsed_face(map, random));
  f(PERMUTATION, with_permutation(map, random));
  f(SHIFTED_RING, with_shifted_ring(map, random));
  f(ANTIPODAL, antipodal(map, random));
  if constexpr(std::is_floating_point<Number>::value)
    f(NON_FINITE, with_non_finite_coordinate(map, random));
}

// ---------------------------------------------------------------------------------------------------------------------
// The maps that are one-to-one.

// the map that a parameterizer of the package makes
template <class Parameterizer>
Map<double> mapped(const Triangle_list& list, Parameterizer parameterizer)
{
  using Mesh = CGAL::Surface_mesh<Epick::Point_3>;
  const Mesh mesh = test_meshes::make_mesh<Mesh>(list);
  const auto map = test_maps::make_sentinel_map<Epick::Point_3>(mesh);
  EXPECT_EQ(SP::parameterize(mesh, parameterizer, map, CGAL::parameters::number_of_iterations(10u)), SP::OK);
  return {list.triangles, test_maps::images(mesh, map)};
}

// Maps of many meshes: the surface itself where the origin sees all of it, and what the package makes of it.
const std::vector<Map<double>>& original_maps()
{
  static const std::vector<Map<double>> maps = [] {
    std::vector<Map<double>> result;
    const auto add_itself = [&](const Triangle_list& list) { result.push_back({list.triangles, list.points}); };
    add_itself(test_meshes::octahedron());
    for(unsigned int subdivisions : {0u, 1u, 2u})
      add_itself(test_meshes::icosphere(subdivisions));
    for(std::size_t n : {3u, 4u, 7u, 16u, 50u})
      add_itself(test_meshes::suspension(n));
    for(std::size_t n : {1u, 3u, 10u, 30u, 100u})
      for(std::uint32_t seed : {1u, 2u, 3u})
        add_itself(test_meshes::random_stacked_sphere(n, seed));
    add_itself(test_meshes::bumpy_sphere(1));
    add_itself(test_meshes::bumpy_sphere(2));
    add_itself(test_meshes::ellipsoid(1e-3, 1., 1e3, 1));

    using Mesh = CGAL::Surface_mesh<Epick::Point_3>;
    const SP::Bijective_low_distortion_parameterizer_3<Mesh> usual;
    const SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, SP::Conformal_energy_3> conformal;
    for(const Triangle_list& list : {test_meshes::bumpy_sphere(1), test_meshes::random_stacked_sphere(80, 4),
                                     test_meshes::with_tentacle(10, 3.), test_meshes::ellipsoid(0.01, 1., 10., 1)})
    {
      result.push_back(mapped(list, usual));
      result.push_back(mapped(list, conformal));
      result.push_back(mapped(list, SP::Hierarchical_parameterizer_3<Mesh>()));
      result.push_back(mapped(list, SP::Stereographic_parameterizer_3<Mesh>()));
      result.push_back(mapped(list, SP::Harmonic_parameterizer_3<Mesh>()));
    }
    // a limb that is shrunk to a very small place
    result.push_back(mapped(test_meshes::with_tentacle(20, 4.), conformal));
    result.push_back(mapped(test_meshes::with_tentacle(20, 4.), SP::Harmonic_parameterizer_3<Mesh>()));
    return result;
  }();
  return maps;
}

template <class Mesh>
Triangle_list triangle_list(const Mesh& mesh)
{
  Triangle_list result;
  std::map<typename Mesh::Vertex_index, std::size_t> number;
  for(const auto v : mesh.vertices())
  {
    number[v] = result.points.size();
    result.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  }
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    result.triangles.push_back({number[mesh.source(h)], number[mesh.target(h)], number[mesh.target(mesh.next(h))]});
  }
  return result;
}

// A number from -1 to 1.
double random_number(Random& random)
{
  return static_cast<double>(random()) * 0x1p-31 - 1.;
}

// 2^k with k from -n to n
double random_power(int n, Random& random)
{
  return std::ldexp(1., static_cast<int>(one_of(static_cast<std::size_t>(2 * n + 1), random)) - n);
}

Map<double> rotated(Map<double> map, Random& random)
{
  for(std::size_t axis = 0; axis < 3; ++axis)
  {
    const double angle = test_meshes::pi * random_number(random), c = std::cos(angle), s = std::sin(angle);
    for(Coordinates& p : map.images)
    {
      double &x = p[axis], &y = p[(axis + 1) % 3];
      const double turned = c * x - s * y;
      y = s * x + c * y;
      x = turned;
    }
  }
  return map;
}

// A linear map of space, which leaves a map one-to-one but for rounding, by powers of two along the axes: needles.
Map<double> squeezed(Map<double> map, int largest_exponent, Random& random)
{
  const Coordinates factors = {random_power(largest_exponent, random), random_power(largest_exponent, random), 1.};
  for(Coordinates& p : map.images)
    for(std::size_t i = 0; i < 3; ++i)
      p[i] *= factors[i];
  return map;
}

template <class Number>
Map<Number> converted(const Map<double>& map)
{
  Map<Number> result;
  result.triangles = map.triangles;
  for(const Coordinates& p : map.images)
    result.images.push_back({static_cast<Number>(p[0]), static_cast<Number>(p[1]), static_cast<Number>(p[2])});
  return result;
}

// Another map of the same mesh. Rounding may have turned faces over.
template <class Number>
Map<Number> varied(Map<double> map, std::size_t kind, Random& random)
{
  constexpr bool is_float = std::is_same<Number, float>::value;
  if(kind > 0)
    map = rotated(map, random);
  switch(kind)
  {
  case 2:
  case 3:
    map = squeezed(map, is_float ? 8 : 30, random);
    if(kind == 3)
      for(Coordinates& p : map.images)
        p = test_meshes::normalized(p);
    break;
  case 4: // at any distance from the origin
    for(Coordinates& p : map.images)
    {
      const double factor = random_power(20, random);
      p = {factor * p[0], factor * p[1], factor * p[2]};
    }
    break;
  case 5: // where determinants underflow or overflow
  {
    const double factor = std::ldexp(1., (random() % 2 == 0 ? 1 : -1) * (is_float ? 100 : 400));
    for(Coordinates& p : map.images)
      p = {factor * p[0], factor * p[1], factor * p[2]};
    break;
  }
  default:
    break;
  }
  Map<Number> result = converted<Number>(map);
  if constexpr(!std::is_floating_point<Number>::value)
    for(Image<Number>& p : result.images) // to numbers that doubles cannot hold
    {
      const Number x = (3 * p[0] - 4 * p[1]) / 5, y = (4 * p[0] + 3 * p[1]) / 5;
      p = {x + p[2] / 3, y, p[2] / 7};
    }
  return result;
}

constexpr std::size_t number_of_kinds = 6;

// `n` maps that are one-to-one, no two of them equal.
template <class Number, class Function>
void for_each_map(std::size_t n, Random& random, const Function& f)
{
  const std::vector<Map<double>>& originals = original_maps();
  std::size_t n_tried = 0;
  for(std::size_t n_found = 0; n_found < n; ++n_tried)
  {
    const std::size_t kind = n_tried / originals.size() % number_of_kinds;
    if(kind == 0 && n_tried >= originals.size())
      continue; // the originals themselves once only
    const Map<Number> map = varied<Number>(originals[n_tried % originals.size()], kind, random);
    if(!is_one_to_one(map))
      continue;
    f(map);
    ++n_found;
  }
}

// ---------------------------------------------------------------------------------------------------------------------

// What the package says of a map.
template <class Kernel>
class Certificate
{
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Number = typename Kernel::FT;

public:
  explicit Certificate(const Map<Number>& map)
    : m_mesh(test_meshes::make_mesh<Mesh>({std::vector<Coordinates>(map.images.size()), map.triangles}))
  {}

  bool accepts(const Map<Number>& map) const
  {
    const auto points = get(CGAL::dynamic_vertex_property_t<typename Kernel::Point_3>(), m_mesh);
    auto p = map.images.begin();
    for(const auto v : vertices(m_mesh))
    {
      put(points, v, typename Kernel::Point_3((*p)[0], (*p)[1], (*p)[2]));
      ++p;
    }
    return SP::is_bijective(m_mesh, points);
  }

private:
  Mesh m_mesh;
};

struct Tally
{
  std::array<std::size_t, number_of_faults> planted = {}, found = {};
  std::size_t accepted = 0, accepted_by_an_ulp = 0;
  std::size_t invisible = 0;    // folds that rounded arithmetic does not see
  std::size_t seem_to_fold = 0; // maps that do not fold, but do so by rounded arithmetic
};

// what a check in double precision would say
template <class Number>
bool seems_positive(const Map<Number>& map)
{
  return std::all_of(map.triangles.begin(), map.triangles.end(), [&](const Triangle& t) {
    return determinant(rounded(map.images[t[0]]), rounded(map.images[t[1]]), rounded(map.images[t[2]])) > 0.;
  });
}

template <class Kernel>
Tally examine_maps(std::size_t n, std::uint32_t seed)
{
  using Number = typename Kernel::FT;
  Tally tally;
  Random random(seed);
  for_each_map<Number>(n, random, [&](const Map<Number>& map) {
    const Certificate<Kernel> certificate(map);
    tally.accepted += certificate.accepts(map);
    tally.seem_to_fold += !seems_positive(map);
    for_each_fault(map, random, [&](Fault fault, const Map<Number>& planted) {
      ++tally.planted[fault];
      if(fault == DOUBLE_COVER)
      {
        EXPECT_TRUE(is_positive(planted)); // nothing but the degree is wrong
        EXPECT_EQ(degree(planted), 2u);
        tally.found[fault] += !Certificate<Kernel>(planted).accepts(planted);
      }
      else
        tally.found[fault] += !certificate.accepts(planted);
    });
    // on both sides of the fold
    const std::array<Map<Number>, 2> pair = around_fold(map, random);
    EXPECT_TRUE(is_one_to_one(pair[0]));
    tally.accepted_by_an_ulp += certificate.accepts(pair[0]);
    EXPECT_FALSE(is_positive(pair[1]));
    EXPECT_FALSE(certificate.accepts(pair[1]));
    tally.invisible += seems_positive(pair[1]);
  });
  return tally;
}

constexpr std::size_t number_of_maps_of_doubles = 1000, number_of_maps_of_floats = 500, number_of_exact_maps = 200;

void expect_all_found(const Tally& tally, std::size_t n, bool is_floating_point)
{
  EXPECT_EQ(tally.accepted, n);
  EXPECT_EQ(tally.accepted_by_an_ulp, n);
  for(std::size_t fault = 0; fault < number_of_faults; ++fault)
  {
    SCOPED_TRACE(fault_names[fault]);
    EXPECT_EQ(tally.planted[fault], fault == NON_FINITE && !is_floating_point ? 0 : n);
    EXPECT_EQ(tally.found[fault], tally.planted[fault]);
    std::cout << "  " << fault_names[fault] << ": " << tally.found[fault] << " of " << tally.planted[fault] << '\n';
  }
  std::cout << "  of folds, not seen in double precision: " << tally.invisible << '\n'
            << "  of maps that do not fold, seem to in double precision: " << tally.seem_to_fold << std::endl;
}

TEST(Planted_faults, in_maps_of_doubles)
{
  const std::size_t n = test_scale::reduced(number_of_maps_of_doubles);
  const Tally tally = examine_maps<Epick>(n, 1);
  expect_all_found(tally, n, true);
  EXPECT_GT(tally.invisible, n / 20);
  EXPECT_GT(tally.seem_to_fold, n / 20);
}

TEST(Planted_faults, in_maps_of_floats)
{
  const std::size_t n = test_scale::reduced(number_of_maps_of_floats);
  expect_all_found(examine_maps<CGAL::Simple_cartesian<float>>(n, 2), n, true);
}

TEST(Planted_faults, in_exact_maps)
{
  const std::size_t n = test_scale::reduced(number_of_exact_maps);
  const Tally tally = examine_maps<CGAL::Simple_cartesian<Rational>>(n, 3);
  expect_all_found(tally, n, false);
  EXPECT_GT(tally.invisible, n / 20);
}

// Real surfaces, mapped by the package.
TEST(Planted_faults, in_maps_of_real_surfaces)
{
  using Mesh = CGAL::Surface_mesh<Epick::Point_3>;
  const SP::Bijective_low_distortion_parameterizer_3<Mesh> usual;
  const SP::Bijective_low_distortion_parameterizer_3<Mesh, CGAL::Default, SP::Conformal_energy_3> conformal;
  Random random(4);
  std::size_t n_meshes = 0;
  for(const char* name : {"tripod", "cross", "u", "part", "cactus", "spool", "handle", "hand", "triceratops", "homer"})
  {
    SCOPED_TRACE(name);
    Mesh mesh;
    std::ifstream in(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
    if(!in || !CGAL::IO::read_OFF(in, mesh))
      continue;
    ++n_meshes;
    const Triangle_list list = triangle_list(mesh);
    for(const Map<double>& map : {mapped(list, usual), mapped(list, conformal)})
    {
      ASSERT_TRUE(is_one_to_one(map));
      const Certificate<Epick> certificate(map);
      EXPECT_TRUE(certificate.accepts(map));
      for(std::size_t k = 0; k < test_scale::reduced(10); ++k)
        for_each_fault(map, random, [&](Fault fault, const Map<double>& planted) {
          EXPECT_FALSE(fault == DOUBLE_COVER ? Certificate<Epick>(planted).accepts(planted)
                                             : certificate.accepts(planted))
              << fault_names[fault];
        });
    }
  }
  if(n_meshes == 0)
    GTEST_SKIP() << "CGAL's meshes are not here.";
  EXPECT_EQ(n_meshes, 10u);
}

bool folds_clearly(const Map<double>& map)
{
  const auto direction = [&](std::size_t v) {
    const Coordinates& p = map.images[v];
    const double size = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    return test_meshes::normalized({p[0] / size, p[1] / size, p[2] / size});
  };
  return std::any_of(map.triangles.begin(), map.triangles.end(), [&](const Triangle& t) {
    return determinant(direction(t[0]), direction(t[1]), direction(t[2])) < -1e-12;
  });
}

// A faulty map is no start: it is refused, and nothing is written.
TEST(Planted_faults, in_maps_to_start_from)
{
  using Mesh = CGAL::Surface_mesh<Epick::Point_3>;
  using Sphere_map = decltype(test_maps::make_sentinel_map<Epick::Point_3>(Mesh()));
  using Precomputed = SP::Precomputed_parameterizer_3<Mesh, Sphere_map>;
  const auto np = CGAL::parameters::number_of_iterations(1u);
  const std::size_t n = test_scale::reduced(500);
  std::size_t n_accepted = 0;
  std::array<std::size_t, number_of_faults> refused = {};
  Random random(5);
  for_each_map<double>(n, random, [&](const Map<double>& map) {
    const auto error_with = [&](const Map<double>& start, bool is_improved) {
      // the surface may be any; that of a double cover is not the one that was mapped
      std::vector<Coordinates> points = start.images;
      for(Coordinates& p : points)
        p = {random_number(random), random_number(random), random_number(random)};
      const Mesh mesh = test_meshes::make_mesh<Mesh>({points, start.triangles});
      const Precomputed precomputed(test_meshes::make_vertex_map<Epick::Point_3>(mesh, start.images));
      const auto result = test_maps::make_sentinel_map<Epick::Point_3>(mesh);
      const std::vector<Coordinates> untouched = test_maps::images(mesh, result);
      const SP::Error_code error =
          is_improved
              ? SP::parameterize(mesh, SP::Bijective_low_distortion_parameterizer_3<Mesh, Precomputed>(precomputed),
                                 result, np)
              : SP::parameterize(mesh, Precomputed(precomputed), result, np);
      const std::vector<Coordinates> images = test_maps::images(mesh, result);
      if(error == SP::OK)
        EXPECT_TRUE(is_one_to_one(Map<double>{start.triangles, images}));
      else
      {
        EXPECT_EQ(error, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION);
        EXPECT_TRUE(test_maps::have_same_bits(images, untouched));
      }
      return error;
    };
    n_accepted += error_with(map, true) == SP::OK;
    for_each_fault(map, random, [&](Fault fault, const Map<double>& planted) {
      refused[fault] += error_with(planted, true) != SP::OK;
      // The parameterizer takes the map to the unit sphere first, which may mend what is as small as rounding.
      const SP::Error_code error = error_with(planted, false);
      if(fault == DOUBLE_COVER || fault == NON_FINITE || folds_clearly(planted))
      {
        EXPECT_EQ(error, SP::ERROR_INVALID_INITIAL_PARAMETERIZATION) << fault_names[fault];
      }
    });
  });
  EXPECT_GT(n_accepted, n / 2);
  for(std::size_t fault = 0; fault < number_of_faults; ++fault)
    EXPECT_EQ(refused[fault], n) << fault_names[fault];
}

} // namespace
