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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGES_SEAM_CUT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGES_SEAM_CUT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/surface/Added_triangles.h>
#include <CGAL/Spherical_parameterization/internal/images/Geographic_frame.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/locate/barycentric_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Cuts the triangles of a mesh until no edge crosses the seam, the poles are vertices, and no texture triangle is turned over.
//
// First, new vertices divide the edges that cross the seam or pass through a pole, and the face that has a pole inside. A
// face then has a pole, from which it is cut to all of its other vertices; or it has two vertices at the seam that are no
// neighbours, as the seam enters and leaves it, and is cut from one to the other; or it has been a triangle all the time.
// Decisions are exact, so there is no other case. In the end, if a triangle has a vertex at the seam, those that are neither
// there nor at a pole are all on the same side of it.
//
// Second, edges are arcs of great circles, which are curved in the image. If a triangle is narrower than the arc along it is
// bent, its texture triangle is turned over. Its longest edge is cut in the middle, which divides that bend by four. So that
// triangles do not become narrow by that, only edges that are the longest ones of both of their triangles are cut: the
// longest edge of the neighbour comes first (Rivara's longest-edge propagation).
template <class TriangleMesh, class K>
class Seam_cut
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using FT = typename K::FT;
  using Point_3 = typename K::Point_3;
  using Frame = Geographic_frame<K>;
  using Place = typename Frame::Place;
  using Site = typename Frame::Site;
  using Crossing = typename Frame::Crossing;

public:
  using Coordinates = std::array<double, 2>;

  // `added` are the triangles in the mesh, `points` and `images` those of its vertices.
  Seam_cut(const Frame& frame, const std::vector<Point_3>& images, const std::vector<Linked_triangle>& triangles,
           const std::vector<Vector_3d>& points, const Added_triangles<TriangleMesh>& added, TriangleMesh& tmesh)
    : m_tmesh(tmesh)
    , m_data(get(CGAL::dynamic_vertex_property_t<Vertex_data>(), tmesh))
    , m_vertices(added.vertices)
    , m_n_old_vertices(images.size())
  {
    cut_at_seam(frame, images, triangles, points, added);
    for(std::size_t v = m_n_old_vertices; v < m_vertices.size(); ++v)
      for(const auto h : halfedges_at(m_vertices[v]))
        cut_to_triangles(h);

    // Maps whose faces are needles would take too many; those of usual surfaces take a few.
    m_max_vertices = m_vertices.size() + m_n_old_vertices + 1000;
    for(const auto f : added.faces)
      refine(halfedge(f, m_tmesh));
    for(std::size_t v = m_n_old_vertices; v < m_vertices.size(); ++v) // further ones are added on the way
      for(const auto h : halfedges_at(m_vertices[v]))
        refine(h);
  }

  // Calls write(v, p) for each new vertex and its point.
  template <class Write>
  void for_each_new_vertex(const Write& write) const
  {
    for(std::size_t v = m_n_old_vertices; v < m_vertices.size(); ++v)
      write(m_vertices[v], get(m_data, m_vertices[v]).point);
  }

  // Calls write(h, c) for each corner: that of the target of the halfedge h in its face.
  template <class Write>
  void for_each_corner(const Write& write) const
  {
    for(const vertex_descriptor v : m_vertices)
      for(const auto h : halfedges_around_target(v, m_tmesh))
        write(h, coordinates(h));
  }

private:
  struct Vertex_data
  {
    Vector_3d point;
    Site site;
  };

  Site site(halfedge_descriptor h) const { return get(m_data, target(h, m_tmesh)).site; }

  // A copy, as cutting changes them.
  std::vector<halfedge_descriptor> halfedges_at(vertex_descriptor v) const
  {
    const auto range = halfedges_around_target(v, m_tmesh);
    return {range.begin(), range.end()};
  }

  void cut_at_seam(const Frame& frame, const std::vector<Point_3>& images,
                   const std::vector<Linked_triangle>& triangles, const std::vector<Vector_3d>& points,
                   const Added_triangles<TriangleMesh>& added)
  {
    std::vector<Place> places;
    places.reserve(images.size());
    bool has_north_pole = false, has_south_pole = false;
    const auto look_for_poles = [&](Place place) {
      has_north_pole = has_north_pole || place == Place::north_pole;
      has_south_pole = has_south_pole || place == Place::south_pole;
    };
    for(std::size_t v = 0; v < images.size(); ++v)
    {
      const Site site = frame.site(images[v]);
      put(m_data, m_vertices[v], Vertex_data{points[v], site});
      places.push_back(site.place);
      look_for_poles(site.place);
    }

    // All crossings are found before the first edge is cut.
    std::vector<std::pair<halfedge_descriptor, Crossing>> crossings;
    for(std::uint32_t t = 0; t < triangles.size(); ++t)
    {
      auto h = halfedge(added.faces[t], m_tmesh);
      for(std::size_t i = 0; i < 3; ++i, h = next(h, m_tmesh))
      {
        const std::uint32_t a = triangles[t][i], b = triangles[t][(i + 1) % 3];
        if(t > triangles[t].neighbors[(i + 2) % 3])
          continue; // it has been looked at
        if(const auto crossing = frame.crossing(images[a], places[a], images[b], places[b]))
        {
          crossings.emplace_back(h, *crossing);
          look_for_poles(crossing->site.place);
        }
      }
    }
    for(const auto& [h, crossing] : crossings)
      cut_edge(h, crossing);

    const auto cut_face_around = [&](const Point_3& pole) {
      const auto t = std::find_if(triangles.begin(), triangles.end(), [&](const Linked_triangle& s) {
        return frame.orientation(images[s[0]], images[s[1]], pole) == POSITIVE &&
               frame.orientation(images[s[1]], images[s[2]], pole) == POSITIVE &&
               frame.orientation(images[s[2]], images[s[0]], pole) == POSITIVE;
      });
      const auto xyz = [](const Point_3& p) { return Vector_3<FT>{p.x(), p.y(), p.z()}; };
      const auto w = barycentric_coordinates<FT>({xyz(images[(*t)[0]]), xyz(images[(*t)[1]]), xyz(images[(*t)[2]])},
                                                 xyz(pole), {true, true, true});
      Vector_3d point = {0., 0., 0.}, image = {0., 0., 0.};
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Site corner = get(m_data, m_vertices[(*t)[i]]).site;
        point = point + CGAL::to_double(w[i]) * points[(*t)[i]];
        image = image + (CGAL::to_double(w[i]) * corner.distance) * corner.direction;
      }
      Site site = frame.site(pole);
      site.distance = length(image); // and not that of the direction
      const auto f = added.faces[static_cast<std::size_t>(t - triangles.begin())];
      add(target(Euler::add_center_vertex(halfedge(f, m_tmesh), m_tmesh), m_tmesh), {point, site});
    };
    if(!has_north_pole)
      cut_face_around(frame.north_pole());
    if(!has_south_pole)
      cut_face_around(frame.south_pole());
  }

  void add(vertex_descriptor v, const Vertex_data& data)
  {
    m_vertices.push_back(v);
    put(m_data, v, data);
  }

  // Returns the halfedge to the new vertex.
  halfedge_descriptor cut_edge(halfedge_descriptor h, const Crossing& crossing)
  {
    const Vector_3d p = get(m_data, source(h, m_tmesh)).point, q = get(m_data, target(h, m_tmesh)).point;
    const auto to_new = Euler::split_edge(h, m_tmesh);
    add(target(to_new, m_tmesh), {p + crossing.share * (q - p), crossing.site});
    return to_new;
  }

  void cut_to_triangles(halfedge_descriptor h)
  {
    if(next(next(next(h, m_tmesh), m_tmesh), m_tmesh) == h)
      return;
    std::vector<halfedge_descriptor> at_seam;
    for(const auto g : halfedges_around_face(h, m_tmesh))
    {
      const Place place = site(g).place;
      if(Frame::is_pole(place))
        return cut_from(g);
      if(place == Place::seam)
        at_seam.push_back(g);
    }
    const auto along_seam = Euler::split_face(at_seam[0], at_seam[1], m_tmesh);
    cut_quadrangle(along_seam);
    cut_quadrangle(opposite(along_seam, m_tmesh));
  }

  // Cuts a face to triangles from the target of h.
  void cut_from(halfedge_descriptor h)
  {
    for(auto g = next(next(h, m_tmesh), m_tmesh); next(g, m_tmesh) != h;)
    {
      const auto next_g = next(g, m_tmesh);
      Euler::split_face(h, g, m_tmesh);
      g = next_g;
    }
  }

  // Cuts a face, if it is a quadrangle, by the diagonal that leaves the larger texture triangles.
  void cut_quadrangle(halfedge_descriptor h)
  {
    const auto h1 = next(h, m_tmesh), h2 = next(h1, m_tmesh), h3 = next(h2, m_tmesh);
    if(h3 == h)
      return;
    const bool is_east = is_in_the_east(h);
    const Coordinates a = coordinates(h, is_east), b = coordinates(h1, is_east), c = coordinates(h2, is_east),
                      d = coordinates(h3, is_east);
    const double from_a = (std::min)(area(a, b, c), area(a, c, d)), from_b = (std::min)(area(b, c, d), area(b, d, a));
    cut_from(from_a >= from_b ? h : h1);
  }

  // Cuts edges until the texture triangle is not turned over.
  void refine(halfedge_descriptor h)
  {
    while(m_vertices.size() < m_max_vertices && is_to_be_refined(h))
    {
      auto e = longest_edge(h);
      for(auto g = longest_edge(opposite(e, m_tmesh)); squared_length_of(g) > squared_length_of(e);
          g = longest_edge(opposite(e, m_tmesh)))
        e = g;
      const auto to_new = cut_edge(e, Frame::middle(site(opposite(e, m_tmesh)), site(e)));
      cut_from(to_new);
      cut_from(opposite(e, m_tmesh));
    }
  }

  bool is_to_be_refined(halfedge_descriptor h) const
  {
    const auto h1 = next(h, m_tmesh), h2 = next(h1, m_tmesh);
    const Site s = site(h), s1 = site(h1), s2 = site(h2);
    if(Frame::is_pole(s.place) || Frame::is_pole(s1.place) || Frame::is_pole(s2.place))
      return false;
    const double signed_area = area(coordinates(h), coordinates(h1), coordinates(h2));
    if(signed_area > 0.)
      return false;
    // What is smaller or narrower may be turned over by rounding. If it would take many pieces, it stays if nobody sees it.
    constexpr double min_length = 1e-9, min_aspect = 1e-6, max_area = 1e-10;
    const double longest = squared_length_of(longest_edge(h));
    return longest > min_length * min_length &&
           (signed_area < -max_area ||
            dot(s.direction, cross(s1.direction - s.direction, s2.direction - s.direction)) > min_aspect * longest);
  }

  double squared_length_of(halfedge_descriptor h) const
  {
    return squared_length(site(h).direction - site(opposite(h, m_tmesh)).direction);
  }

  halfedge_descriptor longest_edge(halfedge_descriptor h) const
  {
    const auto h1 = next(h, m_tmesh), h2 = next(h1, m_tmesh);
    const auto longest = squared_length_of(h1) > squared_length_of(h) ? h1 : h;
    return squared_length_of(h2) > squared_length_of(longest) ? h2 : longest;
  }

  // Twice the area of a texture triangle.
  static double area(const Coordinates& a, const Coordinates& b, const Coordinates& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  // Whether the seam is at the east end of the image for a face.
  bool is_in_the_east(halfedge_descriptor h) const
  {
    for(const auto g : halfedges_around_face(h, m_tmesh))
      if(site(g).place == Place::east)
        return true;
    return false;
  }

  Coordinates coordinates(halfedge_descriptor h, bool is_in_the_east) const
  {
    const Site s = site(h);
    return {s.place != Place::seam ? s.u : is_in_the_east ? 1. : 0., s.v};
  }

  // The coordinates in a triangle. A pole has any longitude: the one in the middle of the others.
  Coordinates coordinates(halfedge_descriptor h) const
  {
    const bool is_east = is_in_the_east(h);
    Coordinates result = coordinates(h, is_east);
    if(Frame::is_pole(site(h).place))
    {
      const auto g = next(h, m_tmesh);
      result[0] = 0.5 * (coordinates(g, is_east)[0] + coordinates(next(g, m_tmesh), is_east)[0]);
    }
    return result;
  }

  using Data_map = typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Vertex_data>>::type;

  TriangleMesh& m_tmesh;
  Data_map m_data;
  std::vector<vertex_descriptor> m_vertices; // all that have been added
  std::size_t m_n_old_vertices, m_max_vertices;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_IMAGES_SEAM_CUT_H
