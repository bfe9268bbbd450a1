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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SPHERE_LOCATOR_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SPHERE_LOCATOR_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/certificate/Exact_predicates_kernel.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSampling
///
/// The class `Sphere_locator_3` is the inverse of a map to the sphere: for a direction, it finds the face whose image
/// contains it, and the point of this face.
///
/// A direction is a point other than the origin, at any finite distance from it: what counts is the ray from the origin
/// through it. A face \f$ (a, b, c) \f$ of images contains \f$ q \f$ if \f$ q = \alpha a + \beta b + \gamma c \f$ with
/// no negative coefficient; these, divided by their sum, are the barycentric coordinates of the point of the surface. So
/// a face of the surface is mapped linearly to the flat triangle of its vertices' images, and this triangle is projected
/// to the sphere along the rays from the origin.
///
/// - The face is exact for the points as they are in the map and the direction as it is given, whatever the kernel.
/// - Of the faces that share the edge or vertex that a direction meets, the first one in `faces(tmesh)` is its face: each
///   direction has exactly one location, which depends on nothing else. The coordinates of the vertices that are not on
///   this edge, or are not this vertex, are 0 then, and no other coordinate is, unless it is below the range of doubles.
/// - Coordinates are in [0, 1], and their sum is 1 up to rounding. If their type is `double`, each of them has a relative
///   error of some units in the last place over the angle between the direction and the opposite edge of the image, or
///   of 1e-6 if that is less; those of an exact number type are exact.
///
/// The locator keeps what it needs: some 42 bytes a face of an image with coordinates of type `double`, and a face
/// descriptor. It is valid as long as the mesh is as it was; the map may change or go. It is made in linear time, unless
/// long and narrow faces are crossed by many cells of its grid: `n` faces around a vertex take a time of
/// \f$ O(n^{3/2}) \f$. A query walks over the few faces between the direction and the centre of its cell. Simultaneous
/// queries are safe if the coordinates are of type `double` or `float`.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a
///         \cgal kernel; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
///
/// \sa `CGAL::Spherical_parameterization::parameterize()`
template <class TriangleMesh, class VertexSphereMap, class ConcurrencyTag = Parallel_if_available_tag>
class Sphere_locator_3
{
  static_assert(internal::check_mesh_and_readable_map<TriangleMesh, VertexSphereMap>());
  using Selection = internal::Exact_predicates_kernel_of_map<VertexSphereMap>;
  using Exact_kernel = typename Selection::type;
  using Triangulation = internal::Sphere_triangulation<Exact_kernel>;

public:
  /// Number type of the coordinates: `double` if those of the map are of type `double` or `float`, or else their exact
  /// number type
  using FT = typename Exact_kernel::FT;
  /// Face descriptor of the mesh
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  /// A face `f` and the barycentric coordinates of a point of it with respect to `source(halfedge(f, tmesh), tmesh)`,
  /// `target(halfedge(f, tmesh), tmesh)` and the third vertex: what the functions of `PMP_locate_grp`, such as
  /// `CGAL::Polygon_mesh_processing::construct_point()`, take.
  using Face_location = std::pair<face_descriptor, std::array<FT, 3>>;

  /// The place where a query has ended, from which the next one sets out if that is near.
  class Hint
  {
    friend class Sphere_locator_3;
    typename Triangulation::Hint m_hint;
  };

  /// makes the locator of a mesh and its map, and checks that the map is a bijection.
  ///
  /// \param tmesh the mesh
  /// \param vertex_sphere_map the images of the vertices, at any distance from the origin
  /// \param is_known_to_be_bijective whether to save this check, which takes some 40 ns a face, because
  ///        `parameterize()` has returned `OK` for the map, or `is_bijective()` has returned `true`
  Sphere_locator_3(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, bool is_known_to_be_bijective = false)
  {
    internal::Mesh_on_sphere<TriangleMesh, VertexSphereMap> mesh;
    m_error_code =
        mesh.read(tmesh, vertex_sphere_map, is_known_to_be_bijective, internal::execution_of<ConcurrencyTag>());
    if(m_error_code == OK)
    {
      m_triangulation.assign(std::move(mesh.images), std::move(mesh.triangles));
      if(!m_triangulation.make_grid())
        m_error_code = mesh.find_error(tmesh, vertex_sphere_map);
    }
    if(m_error_code == OK)
      m_faces = std::move(mesh.faces_of_mesh);
    else
      m_triangulation = Triangulation();
  }

  /// returns `OK`, or what is wrong with the mesh, see `find_defect()`; `ERROR_NON_FINITE_COORDINATE` if an image is
  /// infinite or not a number; `ERROR_NO_1_TO_1_MAPPING` if the map is no bijection.
  Error_code error_code() const { return m_error_code; }

  /// returns the location of `direction`: that of no face, `boost::graph_traits<TriangleMesh>::%null_face()`, with
  /// coordinates of 0, if the direction is zero, infinite or not a number, and always unless `error_code()` is `OK`.
  ///
  /// \tparam Point `%Point_3` of a \cgal kernel with coordinates of type `double` or `float`, or, if those of the map
  ///         are of an exact number type, the value type of the map
  template <class Point>
  Face_location locate(const Point& direction) const
  {
    Hint hint;
    return locate(direction, hint);
  }

  /// returns the same, and in less time if the query before was for a direction next to this one.
  ///
  /// \param direction the direction
  /// \param hint the place where the query before of this locator has ended, or that of no query; the place where this
  ///        one ends is written to it. Each thread needs its own.
  template <class Point>
  Face_location locate(const Point& direction, Hint& hint) const
  {
    if(m_error_code != OK)
      return location({});
    return location(m_triangulation.locate(converted(direction), hint.m_hint));
  }

  /// locates all directions of a range, in parallel unless the coordinates are of an exact number type. In a mesh with
  /// 100,000 faces or more, whose faces are not all in the caches of a processor, it takes them in the order of a curve
  /// on the sphere, which is two or three times as fast if they are in none. The range and the output iterator are used
  /// by the calling thread alone, and all of the range is read before anything is written.
  ///
  /// \tparam DirectionRange a model of `ConstRange` whose value type is a type of directions
  /// \tparam OutputIterator a model of `OutputIterator` that takes `Face_location`
  ///
  /// \param directions the directions
  /// \param locations receives the location of each direction, in the order of the range
  ///
  /// \return `OK`; `ERROR_INVALID_DIRECTION` if a direction is zero, infinite or not a number: its location, and no
  ///         other one, is that of no face; or `error_code()` if that is not `OK`: nothing is written then
  template <class DirectionRange, class OutputIterator>
  Error_code locate(const DirectionRange& directions, OutputIterator locations) const
  {
    if(m_error_code != OK)
      return m_error_code;
    std::vector<typename Exact_kernel::Point_3> points;
    points.reserve(static_cast<std::size_t>(std::distance(std::begin(directions), std::end(directions))));
    for(const auto& direction : directions)
      points.push_back(converted(direction));
    Error_code result = OK;
    for(const typename Triangulation::Triangle_location& place :
        m_triangulation.locate(points, internal::execution_of<ConcurrencyTag>()))
    {
      if(place.triangle == Triangulation::none)
        result = ERROR_INVALID_DIRECTION;
      *locations++ = location(place);
    }
    return result;
  }

private:
  template <class Point>
  static auto converted(const Point& direction)
  {
    using Conversion = internal::Exact_predicates_kernel<typename Kernel_traits<Point>::Kernel>;
    static_assert(std::is_same<typename Conversion::type, Exact_kernel>::value,
                  "A direction has to be a Point_3 with coordinates of type double or float, or, if those of the map "
                  "are of an exact number type, of the same type as the images.");
    return Conversion::convert(direction);
  }

  Face_location location(const typename Triangulation::Triangle_location& place) const
  {
    return {place.triangle == Triangulation::none ? boost::graph_traits<TriangleMesh>::null_face()
                                                  : m_faces[place.triangle],
            place.coordinates};
  }

  Error_code m_error_code = OK;
  Triangulation m_triangulation;
  std::vector<face_descriptor> m_faces;
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SPHERE_LOCATOR_3_H
