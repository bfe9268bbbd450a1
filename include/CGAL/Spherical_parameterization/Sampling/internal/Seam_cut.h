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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_SEAM_CUT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_SEAM_CUT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Sampling/internal/Geographic_frame.h>
#include <CGAL/Spherical_parameterization/internal/locate/barycentric_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Splits the triangles of a mesh until no edge crosses the seam, the poles are vertices, and no texture triangle is inverted.
//
// In the first step, new vertices split the edges that cross the seam or pass through a pole, and the face with a pole in its
// interior. A face then has one of three forms. Either it has a pole, and is cut from the pole to all of its other vertices. Or it
// has two non-adjacent vertices on the seam, where the seam enters and leaves it, and is cut from one to the other. Or it is an
// unchanged triangle. Decisions are exact, so there are no other cases. In the result, if a triangle has a vertex on the seam, its
// vertices that are neither on the seam nor at a pole lie on the same side of the seam.
//
// The second step accounts for edges being arcs of great circles, which are curved in the image. If a triangle is narrower than the
// deviation of the arc along it from a straight line, its texture triangle is inverted. Splitting its longest edge at the midpoint
// divides the deviation by four. Only edges that are the longest ones of both of their triangles are split, because other splits
// create narrow triangles: if necessary, the longest edge of the neighbor is split first (Rivara's longest-edge propagation).
template <class K>
class Seam_cut
{
  using Point_3 = typename K::Point_3;
  using Frame = Geographic_frame<K>;
  using Triangle_location = typename Frame::Triangle_location;
  using Site = typename Frame::Site;
  using Crossing = typename Frame::Crossing;
  using Index = std::uint32_t;

public:
  using Coordinates = std::array<double, 2>;

  // `points` and `images` belong to the vertices.
  Seam_cut(const Frame& frame, const std::vector<Point_3>& images, const std::vector<Linked_triangle>& triangles,
           std::vector<Vector_3d> points)
    : m_points(std::move(points))
  {
    cut_at_seam(frame, images, triangles);
    // Maps with extremely narrow faces would need too many vertices; maps of typical surfaces need a few.
    m_max_vertices = m_points.size() + images.size() + 1000; // 1000 more for small meshes
    std::vector<Index> changed;
    for(Index t = 0; t < m_triangles.size(); ++t) // the loop also visits triangles that it adds
      for(changed = {t}; !changed.empty() && m_is_complete;)
      {
        const Index s = changed.back();
        if(is_to_be_refined(s))
          refine(s, changed);
        else
          changed.pop_back();
      }
  }

  // The points of all vertices; the vertices of the mesh come first.
  const std::vector<Vector_3d>& points() const { return m_points; }

  const std::vector<Linked_triangle>& triangles() const { return m_triangles; }

  // The coordinates of corner i of triangle t. The longitude at a pole is arbitrary: the mean of the other two is used.
  Coordinates coordinates(std::size_t t, std::size_t i) const
  {
    const std::array<Index, 3>& corners = m_triangles[t].vertices;
    const bool is_east = is_in_the_east(corners);
    Coordinates result = at_vertex(corners[i], is_east);
    if(is_pole(corners[i]))
      result[0] = 0.5 * (at_vertex(corners[(i + 1) % 3], is_east)[0] + at_vertex(corners[(i + 2) % 3], is_east)[0]);
    return result;
  }

  // Whether all texture triangles that had to be split have been split.
  bool is_complete() const { return m_is_complete; }

private:
  bool is_pole(Index v) const { return Frame::is_pole(m_sites[v].place); }

  Index add(const Vector_3d& point, const Site& site)
  {
    m_points.push_back(point);
    m_sites.push_back(site);
    return static_cast<Index>(m_points.size() - 1);
  }

  Index add_on_edge(Index a, Index b, const Crossing& crossing)
  {
    return add(m_points[a] + crossing.share * (m_points[b] - m_points[a]), crossing.site);
  }

  void cut_at_seam(const Frame& frame, const std::vector<Point_3>& images,
                   const std::vector<Linked_triangle>& triangles)
  {
    constexpr Index none = (std::numeric_limits<Index>::max)();
    m_sites.reserve(images.size());
    for(const Point_3& p : images)
      m_sites.push_back(frame.site(p));
    std::vector<std::array<Index, 3>> cuts(triangles.size(), {none, none, none}); // the new vertices on the edges
    for(Index t = 0; t < triangles.size(); ++t)
      for(const std::size_t i : {2u, 0u, 1u})
      {
        const Index s = triangles[t].neighbors[i], a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
        if(t < s) // each edge is processed once
          if(const auto crossing = frame.crossing(images[a], m_sites[a].place, images[b], m_sites[b].place))
            cuts[t][i] = cuts[s][triangles[s].side_of(t)] = add_on_edge(a, b, *crossing);
      }
    std::vector<std::pair<Index, Index>> centers; // triangles with a pole in their interior, and the pole
    for(const auto& [place, pole] : {std::pair(Triangle_location::north_pole, frame.north_pole()),
                                     std::pair(Triangle_location::south_pole, frame.south_pole())})
      if(std::none_of(m_sites.begin(), m_sites.end(), [at = place](const Site& site) { return site.place == at; }))
      {
        const Index t = add_pole(frame, pole, images, triangles);
        centers.emplace_back(t, static_cast<Index>(m_points.size() - 1));
      }

    std::vector<std::array<Index, 3>> pieces;
    std::vector<Index> corners;
    for(Index t = 0; t < triangles.size(); ++t)
    {
      corners.clear();
      for(std::size_t i = 0; i < 3; ++i)
      {
        corners.push_back(triangles[t][i]);
        if(cuts[t][(i + 2) % 3] != none)
          corners.push_back(cuts[t][(i + 2) % 3]);
      }
      const auto center = std::find_if(centers.begin(), centers.end(), [&](const auto& c) { return c.first == t; });
      if(center == centers.end())
        cut_to_triangles(corners, pieces);
      else
        for(std::size_t k = 0; k < corners.size(); ++k)
          pieces.push_back({center->second, corners[k], corners[(k + 1) % corners.size()]});
    }
    m_triangles = link_triangles(pieces, m_points.size());
  }

  // Adds a pole, which lies in the interior of a face; returns the face.
  Index add_pole(const Frame& frame, const Point_3& pole, const std::vector<Point_3>& images,
                 const std::vector<Linked_triangle>& triangles)
  {
    const auto t = std::find_if(triangles.begin(), triangles.end(), [&](const Linked_triangle& s) {
      return frame.orientation(images[s[0]], images[s[1]], pole) == POSITIVE &&
             frame.orientation(images[s[1]], images[s[2]], pole) == POSITIVE &&
             frame.orientation(images[s[2]], images[s[0]], pole) == POSITIVE;
    });
    const auto corner = [&](std::size_t i) { return Frame::coordinates(images[(*t)[i]]); };
    const auto w = barycentric_coordinates<typename K::FT>({corner(0), corner(1), corner(2)}, Frame::coordinates(pole),
                                                           {true, true, true});
    double size = 0.; // not squared, because squares may overflow
    for(const Index v : t->vertices)
      size = (std::max)(size, m_sites[v].distance);
    Vector_3d point = {0., 0., 0.}, image = {0., 0., 0.};
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Site& site = m_sites[(*t)[i]];
      point = point + CGAL::to_double(w[i]) * m_points[(*t)[i]];
      image = image + (CGAL::to_double(w[i]) * (site.distance / size)) * site.direction;
    }
    Site site = frame.site(pole);
    site.distance = size * length(image); // instead of the distance of the pole as given
    add(point, site);
    return static_cast<Index>(t - triangles.begin());
  }

  void cut_to_triangles(const std::vector<Index>& corners, std::vector<std::array<Index, 3>>& pieces) const
  {
    const std::size_t n = corners.size();
    std::vector<std::size_t> at_seam;
    for(std::size_t k = 0; k < n; ++k)
    {
      if(n == 3 || is_pole(corners[k]))
        return cut_from(k, corners, pieces);
      if(m_sites[corners[k]].place == Triangle_location::seam)
        at_seam.push_back(k);
    }
    const auto k = corners.begin() + static_cast<std::ptrdiff_t>(at_seam[0]),
               l = corners.begin() + static_cast<std::ptrdiff_t>(at_seam[1]);
    cut_quadrangle(std::vector<Index>(k, l + 1), pieces);
    std::vector<Index> others(l, corners.end());
    others.insert(others.end(), corners.begin(), k + 1);
    cut_quadrangle(others, pieces);
  }

  static void cut_from(std::size_t k, const std::vector<Index>& corners, std::vector<std::array<Index, 3>>& pieces)
  {
    const std::size_t n = corners.size();
    for(std::size_t i = 1; i + 1 < n; ++i)
      pieces.push_back({corners[k], corners[(k + i) % n], corners[(k + i + 1) % n]});
  }

  // Cuts a face by the diagonal whose smaller texture triangle is larger, if the face is a quadrangle.
  void cut_quadrangle(const std::vector<Index>& corners, std::vector<std::array<Index, 3>>& pieces) const
  {
    const bool is_east = is_in_the_east(corners);
    std::array<Coordinates, 4> c;
    for(std::size_t k = 0; k < corners.size(); ++k)
      c[k] = at_vertex(corners[k], is_east);
    const bool is_second = corners.size() == 4 && (std::min)(area(c[1], c[2], c[3]), area(c[1], c[3], c[0])) >
                                                      (std::min)(area(c[0], c[1], c[2]), area(c[0], c[2], c[3]));
    cut_from(is_second ? 1 : 0, corners, pieces);
  }

  // Splits the longest edge of a triangle at its midpoint, or an edge that must be split before, and appends the pieces to
  // `changed`.
  void refine(Index t, std::vector<Index>& changed)
  {
    if(m_points.size() >= m_max_vertices)
    {
      m_is_complete = false;
      return;
    }
    std::size_t i = longest_side(t);
    for(Index s = m_triangles[t].neighbors[i]; squared_length_of(s, longest_side(s)) > squared_length_of(t, i);
        s = m_triangles[t].neighbors[i])
    {
      t = s;
      i = longest_side(s);
    }
    const Index s = m_triangles[t].neighbors[i], a = m_triangles[t][(i + 1) % 3], b = m_triangles[t][(i + 2) % 3];
    const Index m = add_on_edge(a, b, Frame::middle(m_sites[a], m_sites[b]));
    // Triangle t keeps vertex a and s keeps vertex b; the new triangles have the other ends.
    const Index new_t = static_cast<Index>(m_triangles.size()), new_s = new_t + 1;
    cut(t, i, m, new_t, s, new_s);
    cut(s, m_triangles[s].side_of(t), m, new_s, t, new_t);
    changed.insert(changed.end(), {t, new_t, s, new_s});
  }

  // Cuts triangle t from vertex m on its side i, which is the side from a to b, to the opposite corner. The piece at b is new.
  // The pieces on the other side of the edge are `at_b`, an old triangle, and `at_a`.
  void cut(Index t, std::size_t i, Index m, Index piece, Index at_b, Index at_a)
  {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    Linked_triangle& old = m_triangles[t];
    const Linked_triangle added = {{old[i], m, old[k]}, {at_b, old.neighbors[j], t}};
    Linked_triangle& neighbor = m_triangles[old.neighbors[j]];
    neighbor.neighbors[neighbor.side_of(t)] = piece;
    old = {{old[i], old[j], m}, {at_a, piece, old.neighbors[k]}};
    m_triangles.push_back(added);
  }

  bool is_to_be_refined(Index t) const
  {
    const auto [a, b, c] = m_triangles[t].vertices;
    if(is_pole(a) || is_pole(b) || is_pole(c))
      return false;
    const double signed_area = area(coordinates(t, 0), coordinates(t, 1), coordinates(t, 2));
    if(signed_area > 0.)
      return false;
    // Smaller or narrower triangles may be inverted by rounding. If splitting would need many pieces, they are left as they are,
    // because their area is too small to be visible.
    constexpr double min_length = 1e-9, min_aspect = 1e-6, max_area = 1e-10;
    const double longest = squared_length_of(t, longest_side(t));
    const Vector_3d &p = m_sites[a].direction, &q = m_sites[b].direction, &r = m_sites[c].direction;
    return longest > min_length * min_length &&
           (signed_area < -max_area || dot(p, cross(q - p, r - p)) > min_aspect * longest);
  }

  double squared_length_of(Index t, std::size_t i) const
  {
    const Linked_triangle& s = m_triangles[t];
    return squared_length(m_sites[s[(i + 1) % 3]].direction - m_sites[s[(i + 2) % 3]].direction);
  }

  std::size_t longest_side(Index t) const
  {
    const std::size_t i = squared_length_of(t, 1) > squared_length_of(t, 0) ? 1 : 0;
    return squared_length_of(t, 2) > squared_length_of(t, i) ? 2 : i;
  }

  // Twice the signed area of a texture triangle.
  static double area(const Coordinates& a, const Coordinates& b, const Coordinates& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  // Whether the seam is at the east end of the image for a face.
  template <class Corners>
  bool is_in_the_east(const Corners& corners) const
  {
    return std::any_of(corners.begin(), corners.end(),
                       [&](Index v) { return m_sites[v].place == Triangle_location::east; });
  }

  Coordinates at_vertex(Index v, bool is_in_the_east) const
  {
    const Site& s = m_sites[v];
    return {s.place != Triangle_location::seam ? s.u : is_in_the_east ? 1. : 0., s.v};
  }

  std::vector<Vector_3d> m_points;
  std::vector<Site> m_sites; // of the vertices
  std::vector<Linked_triangle> m_triangles;
  std::size_t m_max_vertices;
  bool m_is_complete = true;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SAMPLING_INTERNAL_SEAM_CUT_H
