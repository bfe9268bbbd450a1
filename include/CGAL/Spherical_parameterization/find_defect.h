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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FIND_DEFECT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FIND_DEFECT_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Mesh_defect.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/internal/surface/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mesh_defect_locator.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

/// \file find_defect.h

namespace CGAL {
namespace Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasuring
///
/// finds what keeps a mesh from being parameterized, and where it is: the detail behind the `Error_code` that
/// `parameterize()` returns for the mesh, as far as it is the mesh that is at fault. It may also be called beforehand.
///
/// The checks are those of `parameterize()` itself, so that both agree: if no defect is found, `parameterize()` with
/// default parameters returns `OK`, but for a mesh whose map double precision numbers cannot hold. The running time is
/// linear in the size of the mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh a mesh, which need not be closed, connected or triangulated, as long as it is valid as a halfedge data
///        structure
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///     \cgalParamExtra{If this parameter is omitted, an internal property map for `CGAL::vertex_point_t`
///                     must be available in `TriangleMesh`.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the first defect that is found, or one with `OK` if there is none
///
/// \sa `CGAL::Spherical_parameterization::parameterize()`
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Mesh_defect<TriangleMesh> find_defect(const TriangleMesh& tmesh, const CGAL_NP_CLASS& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh));
  internal::Indexed_mesh mesh;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices_of_mesh;
  Parameterization_report report;
  const Error_code error = internal::read_mesh(tmesh, vpm, mesh, vertices_of_mesh, report);
  return internal::Mesh_defect_locator<TriangleMesh>(tmesh).locate(error, vpm);
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FIND_DEFECT_H
