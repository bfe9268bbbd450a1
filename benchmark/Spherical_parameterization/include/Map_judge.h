// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MAP_JUDGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MAP_JUDGE_H

// Whether something is a one-to-one map of a mesh onto a sphere, and how much it distorts. Nothing of the package is
// included here, because the package is what is being judged.

#include <CGAL/Exact_rational.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace benchmarks {

// A distortion over the faces. Faces of the mesh without area count nowhere; without any other face, the numbers are
// NaN.
struct Map_distortion
{
  double maximum, average;
};

class Map_judge
{
public:
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

  struct Soup
  {
    std::vector<Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
  };

  // By how much the radii may differ, relative: files may have few digits.
  static constexpr double default_deviation = 1e-6;

  // Reads the mesh and its map.
  // \throws std::runtime_error if `map_file` is no map of what is in `mesh_file`
  Map_judge(const std::filesystem::path& mesh_file, const std::filesystem::path& map_file)
    : Map_judge(read(mesh_file, "the mesh"), read(map_file, "the map"))
  {}

  // \throws std::runtime_error if `map` does not have the faces of `mesh`, or an image is not finite
  Map_judge(const Soup& mesh, const Soup& map)
  {
    check_corners(mesh, "the mesh");
    check_corners(map, "the map");
    if(map.points.size() != mesh.points.size() || map.polygons.size() != mesh.polygons.size())
    {
      throw std::runtime_error("the map has other numbers of vertices and faces than the mesh");
    }
    for(std::size_t f = 0; f < mesh.polygons.size(); ++f)
    {
      std::vector<std::size_t> corners = map.polygons[f];
      if(corners.size() != 3 || mesh.polygons[f].size() != 3)
      {
        throw std::runtime_error("face " + std::to_string(f) + " is no triangle");
      }
      std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), mesh.polygons[f][0]), corners.end());
      if(corners != mesh.polygons[f])
      {
        throw std::runtime_error("face " + std::to_string(f) + " of the map is not that of the mesh");
      }
      m_triangles.push_back({corners[0], corners[1], corners[2]});
    }
    m_points = scaled(mesh.points);
    m_images = scaled(map.points);
    check_finiteness();
    m_number_of_folded_faces = count_folded_faces();
  }

  std::size_t number_of_vertices() const { return m_points.size(); }

  // Those that are oriented unlike the most, or whose images have no area. A map may mirror the surface as a whole.
  std::size_t number_of_folded_faces() const { return m_number_of_folded_faces; }

  // Decides by a theorem: if the faces of a closed surface are mapped to spherical triangles that all have the same
  // orientation, then two faces that share an edge lie on different sides of it, so that each point of the sphere that
  // is on no edge is covered by the same number of faces. This number is the sum of the areas over that of the sphere;
  // and if it is 1, the map is one-to-one.
  //
  // \throws std::runtime_error if it is not, or if the images are on no sphere around the origin
  void check(double largest_deviation = default_deviation) const
  {
    check_closedness();
    check_radii(largest_deviation);
    if(m_number_of_folded_faces > 0)
    {
      throw std::runtime_error(std::to_string(m_number_of_folded_faces) + " of " + std::to_string(m_triangles.size()) +
                               " faces are folded over or have no area");
    }
    const double degree = total_solid_angle() / (4. * pi);
    if(!(std::abs(degree - 1.) < 0.01))
    {
      throw std::runtime_error("the faces cover the sphere " + std::to_string(std::lround(degree)) + " times");
    }
  }

  // D_iso (eq. 12 of the paper), at the radius that balances the areas of the faces and their images (eq. 11).
  Map_distortion isometric_distortion() const
  {
    const std::vector<Stretch> stretches = compute_stretches();
    double sum = 0., sum_of_inverses = 0.;
    for(const Stretch& stretch : stretches)
    {
      sum += stretch.smallest * stretch.largest;
      sum_of_inverses += 1. / (stretch.smallest * stretch.largest);
    }
    if(!stretches.empty() && !std::isfinite(sum_of_inverses)) // an image is so small that its area is lost to rounding
    {
      return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }
    const double scale = std::sqrt(std::sqrt(sum_of_inverses / sum));
    return summary(stretches, [scale](const Stretch& stretch) {
      return (std::max)(scale * stretch.largest, 1. / (scale * stretch.smallest));
    });
  }

  // D_angle, the sum of the ratio of the singular values and its inverse, whatever the radius; 2 without distortion.
  Map_distortion angle_distortion() const
  {
    return summary(compute_stretches(), [](const Stretch& stretch) {
      return stretch.smallest > 0. ? stretch.largest / stretch.smallest + stretch.smallest / stretch.largest
                                   : std::numeric_limits<double>::infinity();
    });
  }

private:
  using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;
  using Triangle = std::array<std::size_t, 3>;

  // The singular values of the linear map of a face.
  struct Stretch
  {
    double smallest, largest;
  };

  static constexpr double pi = 3.14159265358979323846;

  static Soup read(const std::filesystem::path& file, const std::string& what)
  {
    Soup soup;
    if(!CGAL::IO::read_polygon_soup(file.string(), soup.points, soup.polygons))
    {
      throw std::runtime_error(what + " cannot be read");
    }
    return soup;
  }

  static void check_corners(const Soup& soup, const std::string& what)
  {
    for(const std::vector<std::size_t>& polygon : soup.polygons)
    {
      for(const std::size_t v : polygon)
      {
        if(v >= soup.points.size())
        {
          throw std::runtime_error(what + " has a corner that is no vertex");
        }
      }
    }
  }

  // The points times a power of two that makes the coordinates about 1: exact, and no product of them overflows.
  static std::vector<Point_3> scaled(const std::vector<Point_3>& points)
  {
    double largest = 0.;
    for(const Point_3& p : points)
    {
      for(int i = 0; i < 3; ++i)
      {
        largest = std::isfinite(p[i]) ? (std::max)(largest, std::abs(p[i])) : largest;
      }
    }
    const int exponent = largest > 0. ? std::ilogb(largest) : 0;
    std::vector<Point_3> result;
    for(const Point_3& p : points)
    {
      result.emplace_back(std::scalbn(p.x(), -exponent), std::scalbn(p.y(), -exponent), std::scalbn(p.z(), -exponent));
    }
    return result;
  }

  void check_closedness() const
  {
    using Edge = std::pair<std::size_t, std::size_t>;

    std::vector<Edge> edges, opposites;
    for(const Triangle& t : m_triangles)
    {
      for(std::size_t i = 0; i < 3; ++i)
      {
        edges.emplace_back(t[i], t[(i + 1) % 3]);
        opposites.emplace_back(t[(i + 1) % 3], t[i]);
      }
    }
    std::sort(edges.begin(), edges.end());
    std::sort(opposites.begin(), opposites.end());
    if(edges.empty() || edges != opposites || std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    {
      throw std::runtime_error("the mesh is no closed surface, so nothing is a map of it");
    }
  }

  void check_finiteness() const
  {
    for(const Triangle& t : m_triangles)
    {
      for(const std::size_t v : t)
      {
        const Point_3& p = m_images[v];
        if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
        {
          throw std::runtime_error("vertex " + std::to_string(v) + " has no finite image");
        }
      }
    }
  }

  void check_radii(double largest_deviation) const
  {
    double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
    for(const Triangle& t : m_triangles)
    {
      for(const std::size_t v : t)
      {
        const Point_3& p = m_images[v];
        const double radius = std::hypot(p.x(), p.y(), p.z());
        smallest = (std::min)(smallest, radius);
        largest = (std::max)(largest, radius);
      }
    }
    if(!(smallest > (1. - largest_deviation) * largest))
    {
      throw std::runtime_error("the images are on no sphere around the origin");
    }
  }

  // The sign of det(a, b, c), without any rounding.
  CGAL::Sign orientation(const Triangle& t) const
  {
    using FT = CGAL::Exact_rational;

    FT m[3][3];
    for(std::size_t i = 0; i < 3; ++i)
    {
      for(int k = 0; k < 3; ++k)
      {
        m[i][k] = FT(m_images[t[i]][k]);
      }
    }
    const FT x = m[1][1] * m[2][2] - m[1][2] * m[2][1];
    const FT y = m[1][2] * m[2][0] - m[1][0] * m[2][2];
    const FT z = m[1][0] * m[2][1] - m[1][1] * m[2][0];
    const FT determinant = m[0][0] * x + m[0][1] * y + m[0][2] * z;
    return CGAL::sign(determinant);
  }

  std::size_t count_folded_faces() const
  {
    std::size_t number_of_positive = 0, number_of_negative = 0;
    for(const Triangle& t : m_triangles)
    {
      const CGAL::Sign sign = orientation(t);
      number_of_positive += sign == CGAL::POSITIVE;
      number_of_negative += sign == CGAL::NEGATIVE;
    }
    return m_triangles.size() - (std::max)(number_of_positive, number_of_negative);
  }

  // The sum of the areas of the spherical triangles on the unit sphere, by the formula of Van Oosterom and Strackee. No
  // determinant is 0, but rounding may have changed the sign of one, hence the absolute value.
  double total_solid_angle() const
  {
    double sum = 0.;
    for(const Triangle& t : m_triangles)
    {
      std::array<Vector_3, 3> u;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Vector_3 p = m_images[t[i]] - Point_3(0., 0., 0.);
        u[i] = p / std::sqrt(p * p);
      }
      const double determinant = std::abs(u[0] * CGAL::cross_product(u[1], u[2]));
      sum += 2. * std::atan2(determinant, 1. + u[0] * u[1] + u[1] * u[2] + u[2] * u[0]);
    }
    return sum;
  }

  // Those of the faces that have an area.
  std::vector<Stretch> compute_stretches() const
  {
    std::vector<Stretch> stretches;
    for(const Triangle& t : m_triangles)
    {
      Stretch stretch;
      if(compute_stretch(t, stretch))
      {
        stretches.push_back(stretch);
      }
    }
    return stretches;
  }

  template <class Measure>
  static Map_distortion summary(const std::vector<Stretch>& stretches, const Measure& measure)
  {
    if(stretches.empty())
    {
      return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    }
    Map_distortion result = {0., 0.};
    for(const Stretch& stretch : stretches)
    {
      const double distortion = measure(stretch);
      result.maximum = (std::max)(result.maximum, distortion);
      result.average += distortion / static_cast<double>(stretches.size());
    }
    return result;
  }

  // Returns false if the face has no area. With the longest edge of the face on the x-axis, and its image as well, the
  // map is a triangular matrix.
  bool compute_stretch(Triangle t, Stretch& stretch) const
  {
    const auto squared_length = [&](std::size_t i) {
      return (m_points[t[(i + 1) % 3]] - m_points[t[i]]).squared_length();
    };
    const std::size_t first = squared_length(0) >= (std::max)(squared_length(1), squared_length(2)) ? 0
                              : squared_length(1) >= squared_length(2)                              ? 1
                                                                                                    : 2;
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(first), t.end());

    struct Shape
    {
      double base, foot, height; // the longest edge, and where the third corner lies over it
    };
    const auto shape = [&](const std::vector<Point_3>& points) {
      const Vector_3 e = points[t[1]] - points[t[0]], g = points[t[2]] - points[t[0]];
      const double base = std::hypot(e.x(), e.y(), e.z()); // which does not underflow
      return Shape{base, e * g / base, std::sqrt(CGAL::cross_product(e, g).squared_length()) / base};
    };
    const Shape face = shape(m_points), image = shape(m_images);
    constexpr double least_height = 1e-12;
    if(!(face.height > least_height * face.base))
    {
      return false;
    }
    const double a = image.base / face.base, b = (image.foot - a * face.foot) / face.height;
    const double c = image.height / face.height;
    const double sum = a * a + b * b + c * c, product = a * c; // of the squares and of the singular values
    stretch.largest = 0.5 * (std::sqrt(sum + 2. * product) + std::sqrt((std::max)(sum - 2. * product, 0.)));
    stretch.smallest = product / stretch.largest;
    return true;
  }

  std::vector<Triangle> m_triangles;
  std::vector<Point_3> m_points, m_images;
  std::size_t m_number_of_folded_faces = 0;
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MAP_JUDGE_H
