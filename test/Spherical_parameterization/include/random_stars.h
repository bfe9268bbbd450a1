#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_RANDOM_STARS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_RANDOM_STARS_H

// Stars of vertices on the unit sphere, each with neighbours of its own, and faces whose shape on the surface is any, of
// about the size of their images.

#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include "indexed_meshes.h"
#include "random_meshes.h"

namespace test {

class Random_stars
{
public:
  using Rest_triangle = CGAL::Spherical_parameterization::internal::Rest_triangle;
  using Star_packets = CGAL::Spherical_parameterization::internal::Star_packets;

  // What Star_packets asks for.
  struct Star
  {
    std::vector<std::uint32_t> neighbors;
    std::vector<Rest_triangle> rests;

    std::size_t size() const { return neighbors.size(); }
    std::uint32_t neighbor(std::size_t j) const { return neighbors[j]; }
    Rest_triangle rest(std::size_t j) const { return rests[j]; }
  };

  Random_stars(Random& random, const std::vector<std::size_t>& degrees, double size)
  {
    for(const std::size_t degree : degrees)
    {
      const CGAL::Spherical_parameterization::internal::Tangent_frame frame(random.direction());
      vertices.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(frame.point_at(0., 0.));
      stars.push_back({});
      for(std::size_t j = 0; j < degree; ++j)
      {
        const double step = random.between(0., 0.4), r = size * random.between(0.6, 1.);
        const double angle = 2. * pi * (static_cast<double>(j) + step) / static_cast<double>(degree);
        stars.back().neighbors.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(frame.point_at(r * std::cos(angle), r * std::sin(angle)));
        std::array<Coordinates, 3> corners;
        for(Coordinates& p : corners)
          p = combination(size, random.in_cube(), 0., points[0]);
        stars.back().rests.push_back(Rest_triangle::from_points(corners[0], corners[1], corners[2]));
      }
    }
  }

  static std::vector<std::size_t> random_degrees(Random& random, std::size_t n)
  {
    std::vector<std::size_t> degrees;
    for(std::size_t k = 0; k < n; ++k)
      degrees.push_back(3 + random.below(9));
    return degrees;
  }

  const Star& star_of(std::uint32_t v) const
  {
    return stars[static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin())];
  }

  Star_packets packets(const std::vector<std::size_t>& first_of_set) const
  {
    Star_packets result;
    result.assign(vertices, first_of_set, [&](std::uint32_t v) { return star_of(v).size(); });
    for(std::size_t k = 0; k < result.number_of_packets(); ++k)
      result.fill_with_copies(k, [&](std::uint32_t v) { return star_of(v); });
    return result;
  }
  Star_packets packets() const { return packets({0, stars.size()}); }

  Images points; // the vertices and their neighbours
  std::vector<std::uint32_t> vertices;
  std::vector<Star> stars;
};

// Where the stars of the vertices of a mesh are in these packets.
inline std::vector<std::uint32_t> places_of(const Random_stars::Star_packets& stars, std::size_t n_vertices)
{
  std::vector<std::uint32_t> result(n_vertices);
  for(std::size_t place = stars.number_of_places(); place-- > 0;) // the first place of each is its own
    result[stars.vertex(place)] = static_cast<std::uint32_t>(place);
  return result;
}

// The stars of these vertices of a surface, as the engine lays them out in sets.
inline Random_stars::Star_packets stars_of(const Surface& mesh, const std::vector<std::uint32_t>& vertices,
                                           const std::vector<std::size_t>& first_of_set)
{
  const auto& points = mesh.points();
  Random_stars::Star_packets result;
  result.assign(vertices, first_of_set, [&](std::uint32_t v) { return mesh.rings().degree(v); });
  for(std::size_t k = 0; k < result.number_of_packets(); ++k)
    result.fill_with_copies(k, [&](std::uint32_t v) {
      const Vertex_rings::Ring ring = mesh.rings().ring(v);
      Random_stars::Star star;
      for(std::size_t j = 0; j < ring.size(); ++j)
      {
        star.neighbors.push_back(ring[j]);
        star.rests.push_back(
            Random_stars::Rest_triangle::from_points(points[v], points[ring[j]], points[ring.around(j + 1)]));
      }
      return star;
    });
  return result;
}

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_RANDOM_STARS_H
