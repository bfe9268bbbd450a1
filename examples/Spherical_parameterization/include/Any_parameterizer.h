// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_PARAMETERIZER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_PARAMETERIZER_H

#include "Input_mesh.h"

#include <CGAL/Spherical_parameterization/Conformal_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Precomputed_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Stereographic_parameterizer_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <variant>

namespace Program {

/// A parameterizer without policies that is chosen at run time: one model of `SphericalParameterizer_3` for all. So a
/// method that starts from the map of another one is compiled once for all of them.
class Any_parameterizer
{
public:
  using Triangle_mesh = Mesh;
  using TriangleMesh = Mesh;

  using Stereographic = CGAL::Spherical_parameterization::Stereographic_parameterizer_3<Mesh>;
  using Harmonic = CGAL::Spherical_parameterization::Harmonic_parameterizer_3<Mesh>;
  using Conformal = CGAL::Spherical_parameterization::Conformal_parameterizer_3<Mesh>;
  using Precomputed = CGAL::Spherical_parameterization::Precomputed_parameterizer_3<Mesh, Sphere_map>;

  using Parameterizer = std::variant<Stereographic, Harmonic, Conformal, Precomputed>;

  explicit Any_parameterizer(const Parameterizer& parameterizer)
    : m_parameterizer(parameterizer)
  {}

  template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class VertexSphereMap,
            typename CGAL_NP_TEMPLATE_PARAMETERS>
  CGAL::Spherical_parameterization::Error_code parameterize(
      const Mesh& mesh, VertexSphereMap map, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
  {
    return std::visit(
        [&](auto& parameterizer) { return parameterizer.template parameterize<ConcurrencyTag>(mesh, map, np); },
        m_parameterizer);
  }

  const CGAL::Spherical_parameterization::Parameterization_report& report() const
  {
    return std::visit(
        [](const auto& parameterizer) -> const auto& { return parameterizer.report(); }, m_parameterizer);
  }

private:
  Parameterizer m_parameterizer;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_PARAMETERIZER_H
