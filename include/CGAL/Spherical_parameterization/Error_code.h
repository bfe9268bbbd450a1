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
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ERROR_CODE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ERROR_CODE_H

#include <CGAL/license/Spherical_parameterization.h>

/// \file Error_code.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationEnums
///
/// List of the outcomes of a spherical parameterization. Every value but `OK` and `ERROR_WRONG_PARAMETER` describes a
/// property of the data, not a programming error; all are reported in Release mode as well. Whenever a value other than
/// `OK` and `ERROR_NO_1_TO_1_MAPPING` is returned, the output map holds what it held before, unless it rounds what it
/// is given and folds by that; see `parameterize()`.
enum Error_code
{
  OK = 0,                                 ///< The map is one-to-one, and this has been certified by exact predicates.
  ERROR_EMPTY_MESH,                       ///< The mesh has no face.
  ERROR_TOO_FEW_VERTICES,                 ///< Fewer than four vertices have a face.
  ERROR_NON_TRIANGULAR_MESH,              ///< A face is not a triangle.
  ERROR_NON_CLOSED_MESH,                  ///< The mesh has a border.
  ERROR_SEVERAL_COMPONENTS,               ///< The mesh has more than one connected component.
  ERROR_NO_TOPOLOGICAL_SPHERE,            ///< The mesh is closed and connected, but its genus is not 0.
  ERROR_NO_SIMPLICIAL_COMPLEX,            ///< Two edges join the same two vertices, or two fans of faces meet in one.
  ERROR_NON_FINITE_COORDINATE,            ///< A coordinate is infinite or not a number.
  ERROR_INVALID_INITIAL_PARAMETERIZATION, ///< The initial map is not one-to-one, or only just so.
  ERROR_NO_1_TO_1_MAPPING,                ///< The map that has been computed is not one-to-one.
  ERROR_INSUFFICIENT_PRECISION,           ///< No one-to-one map was found that the coordinates can hold.
  ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,       ///< The solver of a method that needs one has failed.
  ERROR_WRONG_PARAMETER,                  ///< A parameter is out of its range.
  ERROR_TOO_LARGE_MESH,                   ///< The mesh has 2<sup>31</sup> - 1 halfedges or more.
  ERROR_INVALID_DIRECTION,                ///< A direction is zero or not finite, or two are parallel.
  ERROR_INVALID_DOMAIN,                   ///< The domain is no triangulation of the sphere.
  ERROR_NO_GEOMETRY_IMAGE_MESH,           ///< The mesh has not the vertices of a geometry image.
  ERROR_CANNOT_WRITE_FILE,                ///< A file could not be written.
  ERROR_INVALID_IMAGE_FILE,               ///< A file is damaged, or no geometry image.
  ERROR_INVALID_IMAGE_SIZE,               ///< A geometry image has a size that none has.
  ERROR_NON_MATCHING_BOUNDARY,            ///< Pixels of a geometry image that are the same vertex differ.
  ERROR_UNDETERMINED_ROTATION,            ///< Landmarks do not determine a rotation.
  ERROR_INVALID_LANDMARK                  ///< A landmark is no vertex of a face, or a vertex has two.
};

/// \ingroup PkgSphericalParameterizationEnums
///
/// returns one English sentence that says what `error_code` means and what to do about it. The text is a constant; it
/// is never a null pointer, and a different one for each value.
///
/// \param error_code a value returned by `CGAL::Spherical_parameterization::parameterize()`
inline const char* get_error_message(Error_code error_code)
{
  switch(error_code)
  {
  case OK:
    return "Success: the map is one-to-one.";
  case ERROR_EMPTY_MESH:
    return "The mesh has no face: there is nothing to parameterize.";
  case ERROR_TOO_FEW_VERTICES:
    return "The mesh has fewer than four vertices with a face: the smallest closed surface is a tetrahedron.";
  case ERROR_NON_TRIANGULAR_MESH:
    return "The mesh has a face that is not a triangle: triangulate it first, for example with "
           "CGAL::Polygon_mesh_processing::triangulate_faces().";
  case ERROR_NON_CLOSED_MESH:
    return "The mesh has a border: close its holes first, for example with "
           "CGAL::Polygon_mesh_processing::triangulate_hole().";
  case ERROR_SEVERAL_COMPONENTS:
    return "The mesh has several connected components: parameterize each of them on its own, for example after "
           "CGAL::Polygon_mesh_processing::split_connected_components().";
  case ERROR_NO_TOPOLOGICAL_SPHERE:
    return "The mesh is no topological sphere (its genus is not 0): remove its handles first, for example with "
           "CGAL::alpha_wrap_3().";
  case ERROR_NO_SIMPLICIAL_COMPLEX:
    return "The mesh is no simplicial complex: two edges join the same two vertices, or two fans of faces meet in one "
           "vertex; split an edge or duplicate the vertex first.";
  case ERROR_NON_FINITE_COORDINATE:
    return "The mesh has a coordinate that is infinite or not a number: repair the file or the program that wrote it.";
  case ERROR_INVALID_INITIAL_PARAMETERIZATION:
    return "The initial map is not one-to-one: every face has to be positively oriented as seen from the centre of the "
           "sphere, by more than rounding can change, and the faces have to cover the sphere once.";
  case ERROR_NO_1_TO_1_MAPPING:
    return "The map that was computed is not one-to-one: use a parameterizer that guarantees a bijection.";
  case ERROR_INSUFFICIENT_PRECISION:
    return "No one-to-one map was found that the coordinates can hold: parts of the surface would have to be smaller "
           "than their resolution; use coordinates of type double, or an energy that also preserves areas.";
  case ERROR_CANNOT_SOLVE_LINEAR_SYSTEM:
    return "The linear system of the method could not be solved: try another solver, or a method without one, such as "
           "Hierarchical_parameterizer_3.";
  case ERROR_WRONG_PARAMETER:
    return "A parameter is out of its range: see the documentation of the function or class for the values it accepts.";
  case ERROR_TOO_LARGE_MESH:
    return "The mesh has more than 700 million faces, which is what 32-bit indices can hold: simplify it first.";
  case ERROR_INVALID_DIRECTION:
    return "A direction is zero, infinite or not a number, so that it leads nowhere, or a zero meridian is parallel to "
           "the axis of the poles: of those that are located, the ones without a face are meant; leave them out, or "
           "repair what computes them.";
  case ERROR_INVALID_DOMAIN:
    return "The domain is no triangulation of the sphere: its error_code() says what is wrong with what it was made "
           "of.";
  case ERROR_NO_GEOMETRY_IMAGE_MESH:
    return "The mesh has not the vertices of a geometry image: it has to be a remesh over an octahedron or a cube "
           "whose "
           "edges are divided.";
  case ERROR_CANNOT_WRITE_FILE:
    return "The file cannot be written: perhaps there is no space left.";
  case ERROR_INVALID_IMAGE_FILE:
    return "The file is damaged, or no geometry image of this package: a PNG file has to have 16 bits per component "
           "and "
           "the texts Minimum and Maximum, an OpenEXR file the channels R, G and B.";
  case ERROR_INVALID_IMAGE_SIZE:
    return "The image has not the size of a geometry image: it has to be a square with an odd number of pixels in each "
           "row, or six squares in a column, with three components.";
  case ERROR_NON_MATCHING_BOUNDARY:
    return "The boundary of the geometry image does not match: pixels that are the same vertex of the mesh differ, so "
           "that the surface would not be closed.";
  case ERROR_UNDETERMINED_ROTATION:
    return "The landmarks do not determine a rotation: at least two are needed whose directions are neither the same "
           "nor "
           "opposite, on both spheres.";
  case ERROR_INVALID_LANDMARK:
    return "A landmark is no vertex of a face of its mesh, or a vertex has two landmarks: each is to be given once.";
  }
  return "Unknown error code: it was not returned by this package.";
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ERROR_CODE_H
