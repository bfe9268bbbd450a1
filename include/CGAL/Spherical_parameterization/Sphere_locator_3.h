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
/// The class `Sphere_locator_3` is the inverse of a map to the sphere: it finds the face whose image contains a given
/// direction, and the corresponding point of the face.
///
/// A direction is a point other than the origin, at any finite distance from it; it stands for the ray from the origin
/// through the point. The face with the images \f$ (a, b, c) \f$ contains the direction \f$ q \f$ if
/// \f$ q = \alpha a + \beta b + \gamma c \f$ with non-negative coefficients. The coefficients divided by their sum are
/// the barycentric coordinates of the surface point. This means that each face of the surface is mapped linearly to the
/// flat triangle of its vertices' images, and this triangle is projected to the sphere along the rays from the origin.
///
/// - The face is exact for the points in the map and for the given direction, with any kernel.
/// - If a direction meets an edge or a vertex, the result is the first of the incident faces in `faces(tmesh)`. Hence
///   each direction corresponds to exactly one location. The coordinates of the vertices that do not belong to this
///   edge, or differ from this vertex, are then 0. No other coordinate is 0, unless it is below the range of type
///   `double`.
/// - Coordinates are in [0, 1], and their sum is 1 up to rounding error. Coordinates of type `double` have a relative
///   error of a few units in the last place divided by the angle between the direction and the opposite edge of the
///   image, but by at least 1e-6. Coordinates of an exact number type are exact.
///
/// <b>Complexity.</b> The locator stores about 42 bytes per face if the images have coordinates of type `double`, and a
/// face descriptor per face. Construction takes linear time, unless long and narrow faces cross many cells of the grid:
/// \f$ n \f$ faces around a vertex take \f$ O(n^{3/2}) \f$ time. A query walks across the few faces between the center
/// of its cell and the direction.
///
/// <b>Validity.</b> The locator is valid as long as the mesh does not change; the map may be changed or destroyed.
/// Concurrent queries are safe if the coordinates are of type `double` or `float`.
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
  /// Number type of the coordinates: `double` if the coordinates of the map are of type `double` or `float`, and
  /// otherwise their exact number type
  using FT = typename Exact_kernel::FT;
  /// Face descriptor of the mesh
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  /// A face `f` and the barycentric coordinates of one of its points with respect to
  /// `source(halfedge(f, tmesh), tmesh)`, `target(halfedge(f, tmesh), tmesh)` and the third vertex. The functions of
  /// `PMP_locate_grp` use the same type, for example `CGAL::Polygon_mesh_processing::construct_point()`.
  using Face_location = std::pair<face_descriptor, std::array<FT, 3>>;

  /// The class `Hint` stores the location at which a query has ended, from which a query nearby starts.
  class Hint
  {
    friend class Sphere_locator_3;
    typename Triangulation::Hint m_hint;
  };

  /// constructs the locator of a mesh and its map, and checks that the map is bijective.
  ///
  /// \param tmesh the mesh
  /// \param vertex_sphere_map the images of the vertices, at any distance from the origin
  /// \param is_known_to_be_bijective whether to skip this check, which takes about 40 ns per face, because
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

  /// returns `OK`, or a defect of the mesh, see `find_defect()`; `ERROR_NON_FINITE_COORDINATE` if an image is infinite
  /// or not a number; `ERROR_NO_1_TO_1_MAPPING` if the map is not bijective.
  Error_code error_code() const { return m_error_code; }

  /// returns the location of `direction`. If the direction is zero, infinite or not a number, or if `error_code()` is
  /// not `OK`, the face is `boost::graph_traits<TriangleMesh>::%null_face()` and all coordinates are 0.
  ///
  /// \tparam Point `%Point_3` of a \cgal kernel with coordinates of type `double` or `float`; if the coordinates of the
  ///         map are of an exact number type, the value type of the map
  template <class Point>
  Face_location locate(const Point& direction) const
  {
    Hint hint;
    return locate(direction, hint);
  }

  /// returns the same location, in less time if the previous query was for a direction nearby.
  ///
  /// \param direction the direction
  /// \param hint the location at which the previous query of this locator ended, or a default-constructed hint; it
  ///        receives the location at which this query ends. Each thread needs its own hint.
  template <class Point>
  Face_location locate(const Point& direction, Hint& hint) const
  {
    if(m_error_code != OK)
      return location({});
    return location(m_triangulation.locate(converted(direction), hint.m_hint));
  }

  /// locates all directions of a range, in parallel unless the coordinates are of an exact number type.
  ///
  /// In a mesh of 100,000 faces or more, queries follow a space-filling curve on the sphere, which is two or three
  /// times as fast if the faces are in no cache of the processor. Only the calling thread uses the range and the output
  /// iterator, and it reads the whole range before it writes anything.
  ///
  /// \tparam DirectionRange a model of `ConstRange` whose value type is a direction type
  /// \tparam OutputIterator a model of `OutputIterator` for values of type `Face_location`
  ///
  /// \param directions the directions
  /// \param locations receives the location of each direction, in the order of the range
  ///
  /// \return `OK`; `ERROR_INVALID_DIRECTION` if a direction is zero, infinite or not a number: the face of its location
  ///         is the null face, and all other locations are valid; or `error_code()` if that is not `OK`, and nothing is
  ///         written
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
