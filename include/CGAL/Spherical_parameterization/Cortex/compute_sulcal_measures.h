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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_COMPUTE_SULCAL_MEASURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_COMPUTE_SULCAL_MEASURES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/library.h>
#include <CGAL/Spherical_parameterization/internal/run/check_arguments.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// Measures of the sulci and gyri of a surface, computed by `compute_sulcal_measures()`. Each array has a value for each vertex, in the
/// order of `vertices(tmesh)`, 0 for a vertex without a face, or is empty if it was not asked for. All measures are positive in sulci
/// and negative on gyri.
struct Sulcal_measures
{
  /// Measures to compute; may be combined by `|`.
  enum Selection : unsigned int
  {
    CURVATURE = 1,          ///< `curvature`
    DEPTH = 2,              ///< `depth`
    INFLATED_CURVATURE = 4, ///< `inflated_curvature`, at the cost of `DEPTH`, since it needs the smoothed surface
    ALL = 7                 ///< All of them
  };

  std::vector<double> curvature; ///< Mean curvature, in the inverse unit of the coordinates
  std::vector<double> depth; ///< Distance inside the smoothed surface, in the unit of the coordinates; its mean is 0

  /// Mean curvature of the smoothed surface, which retains only lobes and the deepest sulci, in the unit of `curvature`
  std::vector<double> inflated_curvature;
};

namespace internal {

// The selected measures of a surface, in the order and the unit of the caller.
Sulcal_measures sulcal_measures_of(const Surface& surface, unsigned int selection, const Execution& execution);

} // namespace internal

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// computes curvature and sulcal depth of a surface, such as a cortical surface. They are features for `map_surface()` where no others
/// are available. They are invariant under rigid motions and, up to sampling errors, independent of the triangulation.
///
/// The surface is smoothed by implicit mean curvature flow \cgalCite{cgal:dmsb-ifimdcf-99} with the cotangent weights of the input, in
/// units in which its area is 1.
/// - `curvature`: the inward displacement after the time \f$ t = 1.5 \cdot 10^{-5} \f$, divided by \f$ -2 t \f$. This time is about 1.5
///   mm<sup>2</sup> on a human hemisphere.
/// - `depth`: the outward displacements, summed over the time \f$ 10^{-3} \f$, about 100 mm<sup>2</sup>, minus their mean over the surface.
/// - `inflated_curvature`: the mean curvature of the surface at the end of this flow, with the time \f$ 4 \cdot 10^{-5} \f$.
///
/// With depth and inflated curvature as features, maps between human hemispheres agree better with a probabilistic atlas; see the
/// \ref SphericalParameterizationCortexFigures "manual".
///
/// The running time is \f$ O(n^{3/2}) \f$ for `n` vertices, 2 seconds for 164,000 in one thread.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a closed triangle mesh of genus 0
/// \param measures receives the selected measures; the other arrays are empty afterwards
/// \param selection the measures to compute, a combination of `Sulcal_measures::Selection`
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
/// \return `OK`; an error of the mesh, see `find_defect()`; or `ERROR_NON_FINITE_COORDINATE`. On an error, `measures`
///         is unchanged.
///
/// \sa `CGAL::Spherical_parameterization::Surface_mapper_3::features()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code compute_sulcal_measures(const TriangleMesh& tmesh, Sulcal_measures& measures,
                                   unsigned int selection = Sulcal_measures::ALL,
                                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr(internal::check_vertex_point_map<TriangleMesh, CGAL_NP_CLASS>())
  {
    internal::Mesh_arrays<TriangleMesh> mesh;
    internal::Surface surface;
    if(const Error_code error = internal::read_surface(tmesh, internal::vertex_point_map_of(tmesh, np), mesh, surface))
      return error;
    Sulcal_measures result = internal::sulcal_measures_of(surface, selection, internal::execution_of<ConcurrencyTag>());
    for(std::vector<double>* values : {&result.curvature, &result.depth, &result.inflated_curvature})
    {
      if(values->empty())
        continue;
      std::vector<double> all; // the arrays omit vertices without a face
      auto value = values->begin();
      for(const auto v : vertices(tmesh))
        all.push_back(halfedge(v, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge() ? 0. : *value++);
      values->swap(all);
    }
    measures = std::move(result);
    return OK;
  }
  else
    return ERROR_WRONG_PARAMETER;
}

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/Cortex/internal/sulcal_measures_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_COMPUTE_SULCAL_MEASURES_H
