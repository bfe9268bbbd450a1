// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_SPHERICAL_PARAMETERIZER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_SPHERICAL_PARAMETERIZER_H

#include "Copy_constructible.h"

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Hierarchical_parameterizer_3.h>

namespace archetypes {

// SphericalParameterizer_3 without the optional member
class Spherical_parameterizer : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters>
  CGAL::Spherical_parameterization::Error_code parameterize(const TriangleMesh& tmesh,
                                                            VertexSphereMap vertex_sphere_map,
                                                            const NamedParameters& np)
  {
    CGAL::Spherical_parameterization::Hierarchical_parameterizer_3<TriangleMesh> parameterizer;
    return parameterizer.template parameterize<ConcurrencyTag>(tmesh, vertex_sphere_map, np);
  }
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_SPHERICAL_PARAMETERIZER_H
