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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_EXPAND_IN_SPHERICAL_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_EXPAND_IN_SPHERICAL_HARMONICS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Harmonics/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/run/Mesh_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/run/Visitor_control.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// The class `Harmonic_expansion_3` holds the parameters of an expansion: the degree, and the weights of the minimized
/// squared error. An integer converts to an expansion of that degree with the default weights.
///
/// \sa `CGAL::Spherical_parameterization::expand_in_spherical_harmonics()`
class Harmonic_expansion_3
{
public:
  /// constructs an expansion of the degree `degree`, from 0 to `Spherical_harmonics_3::max_degree`.
  Harmonic_expansion_3(int degree)
    : m_degree(degree)
  {}

  /// sets the weights of the squared error, `Harmonic_weights::surface` by default, and returns the expansion.
  ///
  /// - `surface`: minimizes the integral of the squared error over the surface. The result is the surface of this
  ///   degree that is closest to the given one. Use it to compare shapes.
  /// - `sphere`: minimizes the integral over the sphere. The coefficients are the integrals of the product of function
  ///   and harmonic, as for a field whose domain is the sphere itself. Parts of the surface that are small on the
  ///   sphere have little weight.
  /// - `vertices`: minimizes the sum of the squared errors at the vertices, each weighted by a third of the area of its
  ///   faces, as other programs for shape analysis do. The error at the vertices is smaller than with the other
  ///   weights. Between the vertices, the functions are not controlled: with three to ten vertices per coefficient, the
  ///   error over the surface was up to twelve times that of `surface`. Use it only where vertices are dense.
  Harmonic_expansion_3& weights(Harmonic_weights weights)
  {
    m_weights = weights;
    return *this;
  }

  /// returns the degree.
  int degree() const { return m_degree; }

  /// returns the weights.
  Harmonic_weights weights() const { return m_weights; }

private:
  int m_degree;
  Harmonic_weights m_weights = Harmonic_weights::surface;
};

namespace internal {

// A sample of functions on the vertices: a weighted mean of three vertices.
struct Vertex_mean
{
  std::array<std::uint32_t, 3> vertices;
  Vector_3d weights;
};

// A surface and its map to the sphere in double precision, the input of an expansion.
struct Expansion_surface
{
  std::vector<Vector_3d> points, images; // of the vertices
  const std::vector<Linked_triangle>& triangles;
  std::function<std::vector<Vertex_mean>(const std::vector<Vector_3d>& directions)>
      locate; // exact, with rounded weights
};

// Expands functions with the given values at the vertices; the values of a vertex are contiguous.
Error_code expand_functions(Expansion_surface surface, const std::vector<double>& values,
                            const Harmonic_expansion_3& expansion, Spherical_harmonics_3& harmonics,
                            Run_control& control, const Execution& execution);

// Appends the numbers of a vertex: a single number, or a range of numbers.
template <class Value>
void append_numbers(const Value& value, std::vector<double>& numbers)
{
  if constexpr(std::is_arithmetic<Value>::value)
    numbers.push_back(static_cast<double>(value));
  else
    numbers.insert(numbers.end(), std::begin(value), std::end(value));
}

// Expands functions. append(v, mesh, values) appends the values at the vertex v, the same number for every vertex.
template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters, class Append>
Error_code expand_functions(const TriangleMesh& tmesh, const VertexSphereMap& vertex_sphere_map,
                            const Harmonic_expansion_3& expansion, Spherical_harmonics_3& harmonics,
                            const NamedParameters& np, const Append& append)
{
  using Mesh = Mesh_on_sphere<TriangleMesh, VertexSphereMap>;
  using K = typename Mesh::Exact_kernel;
  using FT = typename K::FT;
  if(expansion.degree() < 0 || static_cast<std::size_t>(expansion.degree()) > Spherical_harmonics_3::max_degree)
    return ERROR_WRONG_PARAMETER;
  Visitor_control<NamedParameters> control(np);
  const Execution execution = execution_of<ConcurrencyTag>();
  Mesh mesh;
  if(const Error_code error = mesh.read_with_points(tmesh, vertex_sphere_map, np, execution))
    return error;
  const std::size_t n_vertices = mesh.points.size(), size = static_cast<std::size_t>(expansion.degree()) + 1;
  if(expansion.weights() == Harmonic_weights::vertices && size * size > n_vertices)
    return ERROR_TOO_HIGH_DEGREE;
  std::vector<double> values;
  std::size_t n_functions = 0;
  for(std::size_t v = 0; v < n_vertices; ++v)
  {
    append(v, mesh, values);
    if(v == 0)
      n_functions = values.size();
    if(n_functions == 0 || values.size() != (v + 1) * n_functions)
      return ERROR_WRONG_PARAMETER;
  }
  Sphere_triangulation<K> sphere;
  sphere.assign(std::move(mesh.images), std::move(mesh.triangles));
  sphere.make_grid();
  const auto locate = [&](const std::vector<Vector_3d>& directions) {
    std::vector<typename K::Point_3> points;
    points.reserve(directions.size());
    for(const Vector_3d& q : directions)
      points.emplace_back(FT(q[0]), FT(q[1]), FT(q[2]));
    std::vector<Vertex_mean> result;
    for(const auto& [triangle, w] : sphere.locate(points, execution))
      result.push_back({sphere.triangles()[triangle].vertices,
                        {CGAL::to_double(w[0]), CGAL::to_double(w[1]), CGAL::to_double(w[2])}});
    return result;
  };
  return expand_functions(
      {std::move(mesh.points), read_points(mesh.vertices_of_mesh, vertex_sphere_map), sphere.triangles(), locate},
      values, expansion, harmonics, control, execution);
}

} // namespace internal

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// expands a surface in spherical harmonics by means of its map to the sphere \cgalCite{cgal:bgk-psdod-95},
/// \cgalCite{cgal:gwcty-gzscm-04}.
///
/// The three coordinates of the surface points are functions of the direction of the image. The surface is piecewise
/// linear, with the correspondence of `Sphere_locator_3`. The expansion of a finite degree approximates it.
///
/// The surface is sampled at the nodes of a Gauss-Legendre grid for at least twice the degree, on which integrals of
/// harmonics are exact. The expansion minimizes the integral of the squared error over the surface;
/// `Harmonic_expansion_3::weights()` selects other weights. `Spherical_harmonics_3::fit` reports the error, and with
/// `Harmonic_fit::aliasing` a value that exceeds the influence of the choice of nodes. Section
/// \ref SphericalParameterizationShapes lists the errors of four surfaces at several degrees.
///
/// With a grid of \f$ k \f$ parallels and the degree \f$ L \f$, the running time is \f$ O(k^2 L) \f$ for each iteration
/// of conjugate gradients. There are usually 20 to 40 iterations; with `Harmonic_weights::sphere`, one is enough. The
/// number \f$ k \f$ is about twice the larger of \f$ L \f$ and \f$ \sqrt{n} \f$ for \f$ n \f$ vertices, but at most 600
/// or \f$ 1.5 L \f$, whichever is larger. With `Harmonic_weights::vertices`, an iteration takes \f$ O(n L^2) \f$, and
/// there are up to several hundred. Memory is linear in the numbers of nodes and vertices.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a
///         \cgal kernel; its coordinates are of type `double` or `float`, or of an exact number type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface, a closed triangle mesh of genus 0
/// \param vertex_sphere_map its map to the sphere, which must be bijective, such as a map computed by `parameterize()`
/// \param expansion the degree, and the weights of the minimized squared error
/// \param harmonics receives the coefficients of the three coordinates, in 4 pi normalization and without the
///         Condon-Shortley phase, and the quality of the fit
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `%Point_3` of a \cgal kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{a visitor whose `go_further()` is called in each iteration and may stop the run}
///     \cgalParamType{a model of `SphericalParameterizationVisitor`, or an `std::reference_wrapper` of one}
///     \cgalParamDefault{`Default_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the run is stopped}
///     \cgalParamType{double}
///     \cgalParamDefault{no limit, as with any value that is not positive}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`; an error of the mesh, see `find_defect()`; `ERROR_NO_1_TO_1_MAPPING` if the map is not bijective;
///         `ERROR_WRONG_PARAMETER` if the degree is out of range; `ERROR_TOO_HIGH_DEGREE` if the weights are
///         `Harmonic_weights::vertices` and the degree exceeds \f$ \lfloor \sqrt{n} \rfloor - 1 \f$ for \f$ n \f$
///         vertices, see `Harmonic_fit::degree_of_vertices`; or `ERROR_STOPPED`. On an error, `harmonics` is unchanged.
///
/// \sa `CGAL::Spherical_parameterization::reconstruct_from_spherical_harmonics()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code expand_in_spherical_harmonics(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                         const Harmonic_expansion_3& expansion, Spherical_harmonics_3& harmonics,
                                         const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::expand_functions<ConcurrencyTag>(
      tmesh, vertex_sphere_map, expansion, harmonics, np,
      [](std::size_t v, const auto& mesh, auto& values) { internal::append_numbers(mesh.points[v], values); });
}

/// \ingroup PkgSphericalParameterizationHarmonics
///
/// expands values given at the vertices, such as curvature or thickness, in spherical harmonics. The functions are
/// linear on the images of the faces. Method, weights and complexity are as for the function above, including the areas
/// of the surface as weights.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam VertexSphereMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to `%Point_3` of a \cgal kernel
/// \tparam VertexValueMap a model of `ReadablePropertyMap` from the vertices of `TriangleMesh` to numbers, or to ranges of them,
///         such as `std::vector<double>`, of the same length for all vertices
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface, a closed triangle mesh of genus 0
/// \param vertex_sphere_map its map to the sphere, which must be bijective
/// \param vertex_value_map the values
/// \param expansion the degree, and the weights of the minimized squared error
/// \param harmonics receives the coefficients of one function for each number at a vertex
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", the same as for the function above
///
/// \return an error code of the function above; `ERROR_WRONG_PARAMETER` also if a vertex has no number or the vertices
///         have different numbers of them; or `ERROR_NON_FINITE_COORDINATE` if a value is infinite or not a number
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, class VertexSphereMap,
          class VertexValueMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code expand_in_spherical_harmonics(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map,
                                         VertexValueMap vertex_value_map, const Harmonic_expansion_3& expansion,
                                         Spherical_harmonics_3& harmonics,
                                         const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::expand_functions<ConcurrencyTag>(
      tmesh, vertex_sphere_map, expansion, harmonics, np, [&](std::size_t v, const auto& mesh, auto& values) {
        internal::append_numbers(get(vertex_value_map, mesh.vertices_of_mesh[v]), values);
      });
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Harmonics/internal/harmonics_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONICS_EXPAND_IN_SPHERICAL_HARMONICS_H
