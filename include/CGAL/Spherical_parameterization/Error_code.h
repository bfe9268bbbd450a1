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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ERROR_CODE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ERROR_CODE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <iterator>
#include <utility>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

// clang-format off
/// \ingroup PkgSphericalParameterizationEnums
///
/// List of the outcomes of the functions of the package; the compiler warns if one is ignored. Every value except `OK` and
/// `ERROR_WRONG_PARAMETER` describes a property of the data or of the run, not a programming error; all are also reported in
/// Release mode. For all values except `OK`, outputs are unchanged, unless the documentation of a function says otherwise.
enum [[nodiscard]] Error_code
{
  OK = 0,                                 ///< Success. Maps are bijective, certified by exact predicates.
  ERROR_EMPTY_MESH,                       ///< The mesh has no faces.
  ERROR_TOO_FEW_VERTICES,                 ///< Fewer than four vertices have a face.
  ERROR_NON_TRIANGULAR_MESH,              ///< A face is not a triangle.
  ERROR_NON_CLOSED_MESH,                  ///< The mesh has a border.
  ERROR_SEVERAL_COMPONENTS,               ///< The mesh has more than one connected component.
  ERROR_NO_TOPOLOGICAL_SPHERE,            ///< The mesh is closed and connected, but its genus is not 0.
  ERROR_NO_SIMPLICIAL_COMPLEX,            ///< Two edges join the same two vertices, or two fans of faces share a vertex.
  ERROR_NON_FINITE_COORDINATE,            ///< A coordinate is infinite or not a number.
  ERROR_INVALID_INITIAL_PARAMETERIZATION, ///< The initial map is not bijective, or not robustly against rounding errors.
  ERROR_NO_1_TO_1_MAPPING,                ///< A given or computed map is not bijective.
  ERROR_INSUFFICIENT_PRECISION,           ///< No bijective map was found that the coordinates can represent.
  ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,       ///< The linear solver of a method has failed.
  ERROR_WRONG_PARAMETER,                  ///< A parameter is out of its range.
  ERROR_TOO_LARGE_MESH,                   ///< The mesh has 2<sup>31</sup> - 1 halfedges or more.
  ERROR_TOO_LARGE_OVERLAY,                ///< The common refinement of two surfaces exceeds the maximum number of vertices.
  ERROR_INVALID_DIRECTION,                ///< A direction is zero or not finite, or two directions are parallel.
  ERROR_INVALID_DOMAIN,                   ///< The domain is empty.
  ERROR_INVERTED_TEXTURE,                   ///< Texture triangles of extreme needles are inverted.
  ERROR_NO_GEOMETRY_IMAGE_MESH,           ///< The number of vertices does not match a geometry image.
  ERROR_OUT_OF_FLOAT_RANGE,               ///< Values are too large, or all too small, for single precision.
  ERROR_CANNOT_WRITE_FILE,                ///< A file could not be written.
  ERROR_INVALID_IMAGE_FILE,               ///< A file is damaged, or not a geometry image.
  ERROR_INVALID_IMAGE_SIZE,               ///< The rows, columns or channels of an image are not those of a geometry image.
  ERROR_INVALID_SURFACE_FILE,             ///< A file is damaged, or not a supported file of surfaces or values.
  ERROR_INVALID_HARMONICS_FILE,           ///< A file is damaged, or not a file of spherical harmonic coefficients.
  ERROR_NON_MATCHING_BOUNDARY,            ///< Pixels of a geometry image that represent the same vertex differ.
  ERROR_UNDETERMINED_ROTATION,            ///< Landmarks, or the axes of an ellipsoid, do not determine a rotation.
  ERROR_TOO_HIGH_DEGREE,                  ///< An expansion has more coefficients than vertices.
  ERROR_INVALID_DENSITY,                  ///< A density is negative, infinite or not a number, or all are 0.
  ERROR_INVALID_LANDMARK,                 ///< A landmark is not a vertex of a face, or a vertex has two landmarks.
  ERROR_STOPPED                           ///< The visitor or the time limit stopped the run before there was a result.
};
// clang-format on

/// \ingroup PkgSphericalParameterizationEnums
///
/// returns one English sentence that explains `error_code` and suggests a remedy. The text is a constant, never a null pointer, and
/// different for each value.
///
/// \param error_code a value returned by a function of the package
inline const char* get_error_message(Error_code error_code)
{
  // clang-format off
  constexpr std::pair<Error_code, const char*> messages[] = {
    {OK, "Success: the result is valid."},
    {ERROR_EMPTY_MESH, "The mesh has no faces, so that there is nothing to map or to measure: check the source of the "
     "mesh."},
    {ERROR_TOO_FEW_VERTICES, "The mesh has fewer than four vertices with a face, but a closed surface has at least "
     "those of a tetrahedron: check the source of the mesh."},
    {ERROR_NON_TRIANGULAR_MESH, "The mesh has a face that is not a triangle: repair_surface() triangulates it."},
    {ERROR_NON_CLOSED_MESH, "The mesh has a border: repair_surface() fills its holes."},
    {ERROR_SEVERAL_COMPONENTS, "The mesh has several connected components: parameterize each of them separately; "
     "or repair_surface() keeps the largest."},
    {ERROR_NO_TOPOLOGICAL_SPHERE, "The surface has a handle, like a torus (its genus is not 0): repair_surface() "
     "cuts handles."},
    {ERROR_NO_SIMPLICIAL_COMPLEX, "The mesh is not a simplicial complex: two edges join the same two vertices, or two "
     "fans of faces share a vertex; repair_surface() separates them."},
    {ERROR_NON_FINITE_COORDINATE, "A coordinate is infinite or not a number: correct the file or the program that "
     "wrote it."},
    {ERROR_INVALID_INITIAL_PARAMETERIZATION, "The initial map is not bijective, or not robustly against rounding "
     "errors: every face must be positively oriented as seen from the center of the sphere, and the faces must cover "
     "the sphere exactly once; use another initial map, such as that of Hierarchical_parameterizer_3."},
    {ERROR_NO_1_TO_1_MAPPING, "The map to the sphere is not bijective: compute it with a method that guarantees "
     "bijectivity, such as Bijective_low_distortion_parameterizer_3."},
    {ERROR_INSUFFICIENT_PRECISION, "No bijective map was found that the coordinates can represent: on the sphere, "
     "parts of the surface would be smaller than their resolution; use coordinates of type double, or an energy that "
     "also preserves areas."},
    {ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, "The linear system of the method could not be solved: use another solver, or a "
     "method without linear systems, such as Hierarchical_parameterizer_3."},
    {ERROR_WRONG_PARAMETER, "A parameter is out of its range: see the documentation of the function or class for the "
     "accepted values."},
    {ERROR_TOO_LARGE_MESH, "The mesh has more than 700 million faces, too many for 32-bit indices: simplify it "
     "first."},
    {ERROR_TOO_LARGE_OVERLAY, "The common refinement of the two surfaces exceeds the maximum number of vertices, "
     "usually because of vertices of high degree or long and narrow faces: increase the maximum if there is enough "
     "memory, or remesh one of the surfaces."},
    {ERROR_INVALID_DIRECTION, "A direction is zero, infinite or not a number, or two directions are parallel that must "
     "not be: omit it, or correct its computation."},
    {ERROR_INVALID_DOMAIN, "The domain is empty: divide the edges of solids into 1 to 5000 segments; for a mesh, see "
     "the error of make_sphere_domain()."},
    {ERROR_INVERTED_TEXTURE, "Some texture triangles are inverted, because the map has needles that need too many new "
     "vertices; the mesh and its texture coordinates have been written."},
    {ERROR_NO_GEOMETRY_IMAGE_MESH, "The vertices of the mesh are not those of a geometry image: create the mesh by "
     "remeshing with an octahedron or a cube whose edges are divided."},
    {ERROR_OUT_OF_FLOAT_RANGE, "The values are too large, or all too small, for single precision numbers, which range "
     "from 1.2e-38 to 3.4e38: scale the surface first, or write another format, such as PNG or OFF."},
    {ERROR_CANNOT_WRITE_FILE, "The file could not be written completely: check that its folder exists and is "
     "writable, and that there is enough disk space."},
    {ERROR_INVALID_IMAGE_FILE, "The file is damaged, or not a geometry image of this package: a PNG file must have 16 "
     "bits per channel and the texts Minimum and Maximum, an OpenEXR file the channels R, G and B."},
    {ERROR_INVALID_IMAGE_SIZE, "The size of the image is not that of a geometry image: it must be a square with an odd "
     "number of pixels per row, or six squares in a column, with three channels."},
    {ERROR_INVALID_SURFACE_FILE, "The file is damaged, or of a kind that the function does not read: see the message "
     "that the function returns with this code."},
    {ERROR_INVALID_HARMONICS_FILE, "The file is damaged, or not a file of spherical harmonic coefficients: see the "
     "message that the function returns with this code."},
    {ERROR_NON_MATCHING_BOUNDARY, "Pixels of the geometry image that represent the same vertex of the mesh differ, so "
     "that the surface would not be closed: write the image again, and do not smooth, scale or lossily compress it."},
    {ERROR_UNDETERMINED_ROTATION, "The rotation is not determined: use at least two landmarks whose directions are "
     "neither equal nor opposite, on both spheres, or a surface whose ellipsoid of degree 1 is neither a point nor a "
     "line."},
    {ERROR_TOO_HIGH_DEGREE, "The expansion has more coefficients than there are vertices: use a degree below the "
     "square root of their number, or areas of the surface or the sphere as weights."},
    {ERROR_INVALID_DENSITY, "A density is negative, infinite or not a number, or all densities are 0, so that they do "
     "not define areas on the sphere: correct their computation, or replace them by small positive numbers."},
    {ERROR_INVALID_LANDMARK, "A landmark is not a vertex of a face of its mesh, or a vertex has two landmarks: omit "
     "it."},
    {ERROR_STOPPED, "The run was stopped by its visitor or its time limit before there was a result: allow more "
     "time."},
  };
  // clang-format on
  static_assert(std::size(messages) == ERROR_STOPPED + 1, "Each code has a message.");
  for(const auto& [code, message] : messages)
    if(code == error_code)
      return message;
  return "Unknown error code: it is not an error code of this package.";
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ERROR_CODE_H
