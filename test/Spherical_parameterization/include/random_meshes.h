#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_RANDOM_MESHES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_RANDOM_MESHES_H

// Random meshes of the sphere, from a seed each, the same on every machine up to rounding: triangulations with 4 to 300
// vertices that are connected in many ways and placed in space in ways that have nothing to do with a sphere, and surfaces
// that are deformed beyond recognition.

#include "images.h"

namespace test {

// The standard specifies the engine, but not the distributions. As it does not specify the order in which arguments are
// evaluated either, only one of them may draw a number.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : m_engine(seed)
  {}

  // one of 0, ..., n - 1
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(m_engine() % n); }

  // one of low, ..., high
  int integer(int low, int high) { return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1))); }

  bool one_in(std::size_t n) { return below(n) == 0; }

  // in [0, 1)
  double unit() { return std::ldexp(static_cast<double>(m_engine() >> 11), -53); }

  // in [low, high)
  double between(double low, double high) { return low + (high - low) * unit(); }

  // in [1 / range, range), log-uniform
  double factor(double range) { return std::pow(range, between(-1., 1.)); }

  // in [2^low, 2^high), each power of two as likely as the others
  double magnitude(int low, int high)
  {
    const double mantissa = 1. + unit();
    return std::ldexp(mantissa, integer(low, high - 1));
  }

  // in [-1, 1) along each axis
  Coordinates in_cube()
  {
    const double x = between(-1., 1.), y = between(-1., 1.), z = between(-1., 1.);
    return {x, y, z};
  }

  // in the unit ball
  Coordinates in_ball()
  {
    for(;;)
    {
      const Coordinates p = in_cube();
      if(dot(p, p) <= 1.)
        return p;
    }
  }

  // on the unit sphere
  Coordinates direction()
  {
    for(;;)
    {
      const Coordinates p = in_ball();
      const double length = std::sqrt(dot(p, p));
      if(length > 0.1)
        return {p[0] / length, p[1] / length, p[2] / length};
    }
  }

private:
  std::mt19937_64 m_engine;
};

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

inline void grow_hubs(Growing_triangulation& t, std::size_t n, Random& random)
{
  const std::size_t n_hubs = 1 + random.below(6);
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
  if(random.one_in(2)) // the hubs need not be neighbours
    t.flip({0, t.place(0, 1)});
}

inline void flip_edges(Growing_triangulation& t, std::size_t n_flips, Random& random)
{
  for(std::size_t i = 0; i < n_flips; ++i)
    t.flip(t.random_corner(random));
}

inline void grow_mixture(Growing_triangulation& t, std::size_t n, Random& random)
{
  using Grow = void (*)(Growing_triangulation&, std::size_t, Random&);
  static constexpr Grow ways[] = {grow_stacked, grow_nested, grow_tube, grow_split, grow_low_degree, grow_hubs};
  while(t.size() < n)
  {
    const std::size_t step = 1 + random.below(30);
    ways[random.below(6)](t, (std::min)(n, t.size() + step), random);
    if(random.one_in(4))
      flip_edges(t, random.below(2 * t.size()), random);
  }
}

struct Connectivity
{
  const char* name;
  void (*grow)(Growing_triangulation&, std::size_t, Random&);
};

inline void grow_flipped(Growing_triangulation& t, std::size_t n, Random& random)
{
  grow_stacked(t, n, random);
  flip_edges(t, 5 * n, random);
}

constexpr std::array<Connectivity, 9> connectivities = {{{"stacked", grow_stacked}, // each vertex in a random face
                                                         {"nested", grow_nested},   // next to the last one
                                                         {"tube", grow_tube},       // triangles within triangles
                                                         {"flipped", grow_flipped}, // random edges flipped
                                                         {"split", grow_split},     // random vertices split in two
                                                         {"low degree", grow_low_degree}, // many of degree 3 and 4
                                                         {"hubs", grow_hubs}, // one or a few joined to most others
                                                         {"double wheel", grow_double_wheel}, // two joined to all
                                                         {"mixture", grow_mixture}}};         // a bit of each

// Moves the vertices of a random sphere to the means of their neighbours, again and again.
inline Images smoothed_sphere(std::size_t n, const std::vector<Triangle>& triangles, Random& random)
{
  Images points(n);
  for(Coordinates& p : points)
    p = random.direction();
  for(std::size_t n_steps = random.below(20); n_steps > 0; --n_steps)
  {
    Images sums = points;
    Coordinates center = {0., 0., 0.};
    for(const Triangle& t : triangles)
      for(std::size_t k = 0; k < 3; ++k)
        sums[t[k]] = combination(1., sums[t[k]], 1., points[t[(k + 1) % 3]]);
    for(const Coordinates& p : sums)
      center = combination(1., center, 1. / (static_cast<double>(n) * norm(p)), p);
    for(std::size_t v = 0; v < n; ++v)
    {
      const Coordinates p = combination(1. / norm(sums[v]), sums[v], -1., center);
      points[v] = norm(p) > 0. ? test_meshes::normalized(p) : random.direction();
    }
  }
  return points;
}

constexpr std::array<const char*, 8> placements = {{"ball",      // anywhere in a ball
                                                    "clustered", // in a few places, spread by 1e-12 to 1e-1 around them
                                                    "collinear", // on a line, but for 1e-15 to 1e-9 or nothing
                                                    "coplanar",  // in a plane, but for the same
                                                    "sphere",    // on a sphere, near their neighbours
                                                    "scales",    // coordinates from 1e-100 to 1e100
                                                    "some coincide", // any of these, and some at the point of another
                                                    "all coincide"}};

inline Images random_points(std::size_t placement, std::size_t n, const std::vector<Triangle>& triangles,
                            Random& random)
{
  const Coordinates o = random.in_ball(), u = random.direction(), v = random.direction(); // origin and axes
  const double noise = random.one_in(4) ? 0. : random.magnitude(-50, -29);
  Images points(n);
  switch(placement)
  {
  case 0:
    for(Coordinates& p : points)
      p = random.in_ball();
    break;
  case 1: {
    Images centers(1 + random.below(6));
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
      points[i] = combination(1., centers[k], sizes[k], random.in_ball());
    }
    break;
  }
  case 2:
  case 3:
    for(Coordinates& p : points)
    {
      const double s = random.between(-1., 1.), t = placement == 2 ? 0. : random.between(-1., 1.);
      p = combination(1., combination(1., o, s, u), 1., combination(t, v, noise, random.in_ball()));
    }
    break;
  case 4:
    points = smoothed_sphere(n, triangles, random);
    break;
  case 5:
    for(Coordinates& p : points)
      for(double& x : p)
      {
        x = random.magnitude(-332, 332);
        x = random.one_in(2) ? x : -x;
      }
    break;
  case 6: {
    points = random_points(random.below(6), n, triangles, random);
    const std::size_t n_moved = 1 + random.below(n - 1);
    for(std::size_t i = 0; i < n_moved; ++i)
    {
      // half of them to a neighbour, the last one in any case
      const Triangle& t = triangles[random.below(triangles.size())];
      points[t[0]] = points[i + 1 == n_moved || random.one_in(2) ? t[1] : random.below(n)];
    }
    break;
  }
  default:
    points.assign(n, o);
  }
  return points;
}

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

constexpr std::array<const char*, 7> deformations = {
    {"scaled",    // along the axes, each by its own factor: a needle or a disc
     "noisy",     // each vertex by 1e-6 to 10 lengths of an edge
     "stretched", // by 1e-6 to 1e6 along any direction
     "sheared",
     "twisted",     // around the z-axis, by up to 30 turns
     "spiked",      // some vertices far away from the center
     "collapsed"}}; // a region to a point or a line, or nearly so

// Deforms a surface around the origin.
inline void deform(Triangle_list& list, std::size_t deformation, Random& random)
{
  double extent = 0., edge = 0.; // the largest distance from the origin, the average length of an edge
  for(const Coordinates& p : list.points)
    extent = (std::max)(extent, norm(p));
  for(const Triangle& t : list.triangles)
    edge += distance(list.points[t[0]], list.points[t[1]]) / static_cast<double>(list.triangles.size());
  const auto for_each_point = [&](const auto& move) {
    for(Coordinates& p : list.points)
      move(p);
  };
  const Coordinates d = random.direction(), e = random.direction();
  switch(deformation)
  {
  case 0: {
    Coordinates factors;
    for(double& f : factors)
      f = random.one_in(3) ? 1. : random.magnitude(-20, 0);
    list = test_meshes::scaled(list, factors[0], factors[1], factors[2]);
    break;
  }
  case 1: {
    const double length = edge * random.magnitude(-20, 3) * 1.25;
    for_each_point([&](Coordinates& p) { p = combination(1., p, length, random.in_ball()); });
    break;
  }
  case 2: {
    const double factor = random.magnitude(-20, 20);
    for_each_point([&](Coordinates& p) { p = combination(1., p, (factor - 1.) * dot(p, d), d); });
    break;
  }
  case 3: {
    const double factor = random.magnitude(-1, 14);
    for_each_point([&](Coordinates& p) { p = combination(1., p, factor * dot(p, d), e); });
    break;
  }
  case 4: {
    const double turns = random.between(0.1, 30.);
    for_each_point([&](Coordinates& p) {
      const double angle = pi * turns * p[2] / extent, c = std::cos(angle), s = std::sin(angle);
      p = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
    });
    break;
  }
  case 5: {
    const double factor = random.magnitude(1, 13);
    for(std::size_t n = 1 + random.below(50); n > 0; --n)
    {
      Coordinates& p = list.points[random.below(list.points.size())];
      p = combination(1., p, factor * random.unit(), p);
    }
    break;
  }
  default: { // from a few vertices up to all of them
    const Coordinates c = list.points[random.below(list.points.size())];
    const double radius = (std::max)(extent * random.between(0.05, 2.), 2. * edge);
    const double rest = random.one_in(2) ? 0. : random.magnitude(-50, -4);
    const bool is_line = random.one_in(2);
    for_each_point([&](Coordinates& p) {
      if(distance(p, c) >= radius)
        return;
      const Coordinates q = is_line ? combination(1., c, dot(p, d) - dot(c, d), d) : c;
      p = combination(1., q, rest, difference(p, q));
    });
  }
  }
}

struct Random_mesh
{
  std::string kind;
  Triangle_list list;
};

// The mesh of this seed. Its vertices are numbered in random order.
inline Random_mesh random_mesh(std::uint64_t seed)
{
  Random random(seed);
  Random_mesh result;
  Triangle_list list;
  if(random.one_in(10))
  {
    static const std::array<Triangle_list, 3> surfaces = {bumpy_sphere(2), with_tentacle(20, 3.),
                                                          random_stacked_sphere(150, 1)};
    list = surfaces[random.below(surfaces.size())];
    Coordinates center = {0., 0., 0.};
    for(const Coordinates& p : list.points)
      center = combination(1., center, 1. / static_cast<double>(list.points.size()), p);
    for(Coordinates& p : list.points)
      p = difference(p, center);
    for(std::size_t n = random.one_in(4) ? 2 : 1; n > 0; --n)
    {
      const std::size_t k = random.below(deformations.size());
      deform(list, k, random);
      result.kind += (result.kind.empty() ? "" : " and ") + std::string(deformations[k]);
    }
  }
  else
  {
    const Connectivity& connectivity = connectivities[random.below(connectivities.size())];
    const std::size_t placement = random.below(placements.size());
    const std::size_t n = random_size(random);
    Growing_triangulation triangulation;
    connectivity.grow(triangulation, n, random);
    list.triangles = triangulation.triangles();
    list.points = random_points(placement, n, list.triangles, random);
    result.kind = std::string(connectivity.name) + ", " + placements[placement];
  }
  result.kind += ", " + std::to_string(list.points.size()) + " vertices";
  const std::uint32_t order = static_cast<std::uint32_t>(random.below(std::size_t(1) << 31));
  result.list = renumbered(list, random_permutation(list.points.size(), order), order);
  return result;
}

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_RANDOM_MESHES_H
