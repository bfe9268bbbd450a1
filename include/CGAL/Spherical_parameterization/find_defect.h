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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FIND_DEFECT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FIND_DEFECT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mesh_defect_locator.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// The class `Mesh_defect` describes why a mesh cannot be parameterized, and where the defect is. The message is for
/// people; the descriptors are for programs that show or repair the defect.
///
/// | `error`                       | `vertex`          | `other_vertex` | `face`                 | `count`                |
/// | :---------------------------- | :---------------- | :------------- | :--------------------- | :--------------------- |
/// | `ERROR_EMPTY_MESH`            | -                 | -              | -                      | 0                      |
/// | `ERROR_TOO_FEW_VERTICES`      | -                 | -              | -                      | vertices with a face   |
/// | `ERROR_NON_TRIANGULAR_MESH`   | -                 | -              | the first such face    | such faces             |
/// | `ERROR_NON_CLOSED_MESH`       | one end of an edge on the border | its other end | the face at that edge | such edges |
/// | `ERROR_SEVERAL_COMPONENTS`    | one of a component | one of another component | -           | components             |
/// | `ERROR_NO_TOPOLOGICAL_SPHERE` | -                 | -              | -                      | handles, the genus     |
/// | `ERROR_NO_SIMPLICIAL_COMPLEX` | where fans of faces meet, or an end of a repeated edge | its other end | - | such edges or vertices |
/// | `ERROR_TOO_LARGE_MESH`        | -                 | -              | -                      | 0                      |
/// | `ERROR_NON_FINITE_COORDINATE` | the first such vertex | -          | -                      | such vertices          |
///
/// Members that do not apply are null descriptors.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <class TriangleMesh>
struct Mesh_defect
{
  /// Vertex descriptor type
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// Face descriptor type
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  Error_code error = OK;                                                       ///< the defect; `OK` if there is none
  vertex_descriptor vertex = boost::graph_traits<TriangleMesh>::null_vertex(); ///< its location, see above
  vertex_descriptor other_vertex = boost::graph_traits<TriangleMesh>::null_vertex(); ///< its location, see above
  face_descriptor face = boost::graph_traits<TriangleMesh>::null_face();             ///< its location, see above
  std::size_t count = 0; ///< the number of defects of this kind, see above

  /// English sentences that state the defect, its location, and a remedy. Vertices and faces are identified by their
  /// positions in the ranges `vertices(tmesh)` and `faces(tmesh)`, counted from 0. For a mesh without removed elements,
  /// these are the indices in the mesh and in the file it was read from.
  std::string message;
};

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// finds the first defect that keeps a mesh from being parameterized.
///
/// The checks are those of `parameterize()`: if no defect is found, `parameterize()` with default parameters returns
/// `OK`, within the limits stated there. The running time is linear in the size of the mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a mesh that is a valid halfedge data structure; it need not be closed, connected or triangulated
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the first defect that is found; its `error` is `OK` if there is none
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Mesh_defect<TriangleMesh> find_defect(const TriangleMesh& tmesh, const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto vpm = internal::vertex_point_map_of(tmesh, np);
  internal::Mesh_arrays<TriangleMesh> arrays;
  internal::Surface surface;
  const Error_code error = internal::read_surface(tmesh, vpm, arrays, surface);
  return internal::Mesh_defect_locator<Mesh_defect<TriangleMesh>, TriangleMesh>(tmesh).locate(error, vpm);
}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FIND_DEFECT_H
