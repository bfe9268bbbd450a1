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
/// List of the outcomes of the functions of the package; the compiler warns if one is ignored. Every value but `OK` and
/// `ERROR_WRONG_PARAMETER` describes a property of the data or of the run, not a programming error; all are reported in
/// Release mode as well. Unless the function says otherwise, whatever it was to write to is left as it was by all values but
/// `OK`.
enum [[nodiscard]] Error_code
{
  OK = 0,                                 ///< Success. Maps are one-to-one, which exact predicates have certified.
  ERROR_EMPTY_MESH,                       ///< The mesh has no face.
  ERROR_TOO_FEW_VERTICES,                 ///< Fewer than four vertices have a face.
  ERROR_NON_TRIANGULAR_MESH,              ///< A face is not a triangle.
  ERROR_NON_CLOSED_MESH,                  ///< The mesh has a border.
  ERROR_SEVERAL_COMPONENTS,               ///< The mesh has more than one connected component.
  ERROR_NO_TOPOLOGICAL_SPHERE,            ///< The mesh is closed and connected, but its genus is not 0.
  ERROR_NO_SIMPLICIAL_COMPLEX,            ///< Two edges join the same two vertices, or two fans of faces meet in one.
  ERROR_NON_FINITE_COORDINATE,            ///< A coordinate is infinite or not a number.
  ERROR_INVALID_INITIAL_PARAMETERIZATION, ///< The initial map is not one-to-one, or only just so.
  ERROR_NO_1_TO_1_MAPPING,                ///< A map, given or computed, is not one-to-one.
  ERROR_INSUFFICIENT_PRECISION,           ///< No one-to-one map was found that the coordinates can hold.
  ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,       ///< The solver of a method that needs one has failed.
  ERROR_WRONG_PARAMETER,                  ///< A parameter is out of its range.
  ERROR_TOO_LARGE_MESH,                   ///< The mesh has 2<sup>31</sup> - 1 halfedges or more.
  ERROR_TOO_LARGE_OVERLAY,                ///< The common refinement of two surfaces has more vertices than it may.
  ERROR_INVALID_DIRECTION,                ///< A direction is zero or not finite, or two are parallel.
  ERROR_INVALID_DOMAIN,                   ///< The domain is empty.
  ERROR_FOLDED_TEXTURE,                   ///< Texture triangles of extreme needles are turned over.
  ERROR_NO_GEOMETRY_IMAGE_MESH,           ///< The number of vertices is that of no geometry image.
  ERROR_OUT_OF_FLOAT_RANGE,               ///< Values are too large, or all too small, for numbers of 32 bits.
  ERROR_CANNOT_WRITE_FILE,                ///< A file could not be written.
  ERROR_INVALID_IMAGE_FILE,               ///< A file is damaged, or no geometry image.
  ERROR_INVALID_IMAGE_SIZE,               ///< An image has not as many rows, columns or channels as a geometry image.
  ERROR_INVALID_SURFACE_FILE,             ///< A file is damaged, or none of the kind of surfaces or values that is read.
  ERROR_INVALID_HARMONICS_FILE,           ///< A file is damaged, or none of coefficients of spherical harmonics.
  ERROR_NON_MATCHING_BOUNDARY,            ///< Pixels of a geometry image that are the same vertex differ.
  ERROR_UNDETERMINED_ROTATION,            ///< Landmarks, or the axes of an ellipsoid, do not determine a rotation.
  ERROR_TOO_HIGH_DEGREE,                  ///< An expansion has more coefficients than there are vertices.
  ERROR_INVALID_DENSITY,                  ///< A density is negative, infinite or not a number, or all are 0.
  ERROR_INVALID_LANDMARK,                 ///< A landmark is no vertex of a face, or a vertex has two.
  ERROR_STOPPED                           ///< The visitor or the time limit ended the run before there was a result.
};
// clang-format on

/// \ingroup PkgSphericalParameterizationEnums
///
/// returns one English sentence that says what `error_code` means and what to do about it. The text is a constant; it
/// is never a null pointer, and a different one for each value.
///
/// \param error_code a value returned by a function of the package
inline const char* get_error_message(Error_code error_code)
{
  // clang-format off
  constexpr std::pair<Error_code, const char*> messages[] = {
    {OK, "Success: the result is valid."},
    {ERROR_EMPTY_MESH, "The mesh has no face, so that there is nothing to map or to measure: check what it was read "
     "from."},
    {ERROR_TOO_FEW_VERTICES, "The mesh has fewer than four vertices with a face, and no closed surface has less than a "
     "tetrahedron: check what it was read from."},
    {ERROR_NON_TRIANGULAR_MESH, "The mesh has a face that is not a triangle: repair_surface() triangulates it."},
    {ERROR_NON_CLOSED_MESH, "The mesh has a border: repair_surface() fills its holes."},
    {ERROR_SEVERAL_COMPONENTS, "The mesh has several connected components: parameterize each of them on its own; "
     "or repair_surface() keeps the largest."},
    {ERROR_NO_TOPOLOGICAL_SPHERE, "The surface has a handle, as a torus has (its genus is not 0): repair_surface() "
     "cuts handles."},
    {ERROR_NO_SIMPLICIAL_COMPLEX, "The mesh is no simplicial complex, as two edges join the same two vertices, or two "
     "fans of faces meet in one vertex: repair_surface() divides it."},
    {ERROR_NON_FINITE_COORDINATE, "A coordinate is infinite or not a number: repair the file or the program that wrote "
     "it."},
    {ERROR_INVALID_INITIAL_PARAMETERIZATION, "The map to start from is not one-to-one by more than rounding can "
     "change: every face has to be positively oriented as seen from the centre of the sphere, and the faces have to "
     "cover the sphere once; start from another map, such as that of Hierarchical_parameterizer_3."},
    {ERROR_NO_1_TO_1_MAPPING, "The map to the sphere is not one-to-one: compute it by a method that guarantees this, "
     "such as Bijective_low_distortion_parameterizer_3."},
    {ERROR_INSUFFICIENT_PRECISION, "No one-to-one map was found that the coordinates can hold, as parts of the surface "
     "would be smaller on the sphere than what these tell apart: use coordinates of type double, or an energy that "
     "also preserves areas."},
    {ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, "The linear system of the method could not be solved: try another solver, or a "
     "method without one, such as Hierarchical_parameterizer_3."},
    {ERROR_WRONG_PARAMETER, "A parameter is out of its range: see the documentation of the function or class for the "
     "values it accepts."},
    {ERROR_TOO_LARGE_MESH, "The mesh has more than 700 million faces, which is more than 32-bit indices can count: "
     "simplify it first."},
    {ERROR_TOO_LARGE_OVERLAY, "The common refinement of the two surfaces has more vertices than are allowed, as where "
     "vertices of high degree meet, or long and narrow faces: allow more if there is memory for them, or remesh one of "
     "the surfaces."},
    {ERROR_INVALID_DIRECTION, "A direction is zero, infinite or not a number, or two directions are parallel that must "
     "not be: leave it out, or repair what computes it."},
    {ERROR_INVALID_DOMAIN, "The domain is empty: divide the edges of solids into 1 to 5000 parts, and see what "
     "make_sphere_domain() says of a mesh."},
    {ERROR_FOLDED_TEXTURE, "Some texture triangles are turned over, as the map has needles that would take too many "
     "new vertices; the mesh and its texture coordinates have been written."},
    {ERROR_NO_GEOMETRY_IMAGE_MESH, "The mesh has not the vertices of a geometry image: make it by remeshing over an "
     "octahedron or a cube whose edges are divided."},
    {ERROR_OUT_OF_FLOAT_RANGE, "The values are too large, or all too small, for the numbers of 32 bits of the file, "
     "which reach from 1.2e-38 to 3.4e38: scale the surface first, or write a file of another format, such as PNG or "
     "OFF."},
    {ERROR_CANNOT_WRITE_FILE, "The file could not be written to its end: check that its folder is there and may be "
     "written to, and that there is space left."},
    {ERROR_INVALID_IMAGE_FILE, "The file is damaged, or no geometry image of this package: a PNG file has to have 16 "
     "bits per channel and the texts Minimum and Maximum, an OpenEXR file the channels R, G and B."},
    {ERROR_INVALID_IMAGE_SIZE, "The image has not the size of a geometry image: it has to be a square with an odd "
     "number of pixels in each row, or six squares in a column, with three channels."},
    {ERROR_INVALID_SURFACE_FILE, "The file is damaged, or of another kind than the function reads: see the message "
     "that the function gives beside this code."},
    {ERROR_INVALID_HARMONICS_FILE, "The file is damaged, or none of coefficients of spherical harmonics: see the "
     "message that the function gives beside this code."},
    {ERROR_NON_MATCHING_BOUNDARY, "Pixels of the geometry image differ that are the same vertex of the mesh, so that "
     "the surface would not be closed: write the image anew, and let no program smooth, scale or compress it with "
     "losses."},
    {ERROR_UNDETERMINED_ROTATION, "There is no rotation that is determined: give at least two landmarks whose "
     "directions are neither the same nor opposite, on both spheres, or a surface whose ellipsoid of degree 1 is "
     "neither a point nor a line."},
    {ERROR_TOO_HIGH_DEGREE, "The vertices do not hold as many coefficients as the degree has: take a degree below the "
     "root of their number, or areas of the surface or the sphere as weights."},
    {ERROR_INVALID_DENSITY, "A density is negative, infinite or not a number, or all of them are 0, so that they do "
     "not say how much of the sphere each part of the surface is to get: repair what computes them, or replace them by "
     "small numbers."},
    {ERROR_INVALID_LANDMARK, "A landmark is no vertex of a face of its mesh, or a vertex has two landmarks: leave it "
     "out."},
    {ERROR_STOPPED, "The run was ended by its visitor or its time limit before there was a result: give it more time."},
  };
  // clang-format on
  static_assert(std::size(messages) == ERROR_STOPPED + 1, "Each code has a message.");
  for(const auto& [code, message] : messages)
    if(code == error_code)
      return message;
  return "Unknown error code: it was not returned by this package.";
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ERROR_CODE_H
