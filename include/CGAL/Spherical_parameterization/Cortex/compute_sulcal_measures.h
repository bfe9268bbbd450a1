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
/// How a surface is folded: what `compute_sulcal_measures()` measures. A value for each vertex, in the order of `vertices(tmesh)`, 0 for one
/// without a face; all are positive in furrows (sulci) and negative on ridges (gyri).
struct Sulcal_measures
{
  std::vector<double> curvature; ///< Mean curvature, in units of one over that of the coordinates
  std::vector<double>
      depth; ///< How far inside of the smoothed surface it is, in the unit of the coordinates; 0 on average

  /// Mean curvature of the smoothed surface, which has the lobes and the deepest furrows alone, in the same unit as `curvature`
  std::vector<double> inflated_curvature;
};

namespace internal {

// The measures of a surface, in the order and the unit of the caller.
Sulcal_measures sulcal_measures_of(const Surface& surface, const Execution& execution);

} // namespace internal

/// \ingroup PkgSphericalParameterizationSurfaces
///
/// measures the curvature and the depth of the folds of a surface, such as a cortex: features for `map_surface()`, where none have
/// been measured otherwise. They do not depend on where the surface is and, but for errors of sampling, on
/// its triangles.
///
/// The surface is smoothed by heat that is conducted on it \cgalCite{cgal:dmsb-ifimdcf-99}, by implicit steps with the
/// cotangents of its triangles, in units in which its area is 1.
/// - `curvature`: the way that a vertex goes inwards in the time \f$ t = 1.5 \cdot 10^{-5} \f$, over \f$ -2 t \f$. This is some 1.5
///   mm<sup>2</sup> on a human hemisphere.
/// - `depth`: the ways outwards, added up over the time \f$ 10^{-3} \f$, some 100 mm<sup>2</sup>, less their mean over the surface. Heat goes as
///   on the surface that was given; the normals are those on the way.
/// - `inflated_curvature`: the curvature of what there is then, in the time \f$ 4 \cdot 10^{-5} \f$.
///
/// By depth and inflated curvature, maps between human hemispheres agree better with the areas of a probabilistic atlas; see the
/// \ref SphericalParameterizationCortexFigures "manual".
///
/// The running time is \f$ O(n^{3/2}) \f$ for `n` vertices, 2 seconds for 164,000 in one thread.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; no result depends on it
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a closed triangle mesh without handles
/// \param folding receives the measures
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
/// \return `OK`; or what is wrong with the mesh, see `find_defect()`, or `ERROR_NON_FINITE_COORDINATE`: then `folding` is as it was
///
/// \sa `CGAL::Spherical_parameterization::Surface_mapper_3::features()`
template <class ConcurrencyTag = Parallel_if_available_tag, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code compute_sulcal_measures(const TriangleMesh& tmesh, Sulcal_measures& folding,
                                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr(internal::check_vertex_point_map<TriangleMesh, CGAL_NP_CLASS>())
  {
    internal::Mesh_arrays<TriangleMesh> mesh;
    internal::Surface surface;
    if(const Error_code error = internal::read_surface(tmesh, internal::vertex_point_map_of(tmesh, np), mesh, surface))
      return error;
    Sulcal_measures result = internal::sulcal_measures_of(surface, internal::execution_of<ConcurrencyTag>());
    for(std::vector<double>* values : {&result.curvature, &result.depth, &result.inflated_curvature})
    {
      std::vector<double> all; // the arrays lack vertices without a face
      auto value = values->begin();
      for(const auto v : vertices(tmesh))
        all.push_back(halfedge(v, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge() ? 0. : *value++);
      values->swap(all);
    }
    folding = std::move(result);
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
