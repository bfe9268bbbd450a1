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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_UPDATE_ON_COARSE_LEVELS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_UPDATE_ON_COARSE_LEVELS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

template <class VertexUpdate, class = void>
struct Has_update_on_coarse_levels : std::false_type
{};

// A class that is derived from one with the member inherits it, but it would return the base, without what is new.
template <class VertexUpdate>
struct Has_update_on_coarse_levels<VertexUpdate,
                                   std::void_t<decltype(std::declval<const VertexUpdate&>().on_coarse_levels())>>
  : std::is_same<std::decay_t<decltype(std::declval<const VertexUpdate&>().on_coarse_levels())>, VertexUpdate>
{};

// The update for the levels of a hierarchy that are coarser than the mesh: what the update says, if it says anything.
template <class VertexUpdate>
VertexUpdate update_on_coarse_levels(const VertexUpdate& update)
{
  if constexpr(Has_update_on_coarse_levels<VertexUpdate>::value)
    return update.on_coarse_levels();
  else
    return update;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_UPDATE_ON_COARSE_LEVELS_H
