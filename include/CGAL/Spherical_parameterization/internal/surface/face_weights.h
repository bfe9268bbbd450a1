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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_FACE_WEIGHTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_FACE_WEIGHTS_H

#include <CGAL/license/Spherical_parameterization.h>

#include <type_traits>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// How much the faces of a surface count in the sums of an energy, as it may say by static members.

template <class Energy, class = void>
struct Weighs_faces_by_area : std::false_type
{};

// whether faces count by their areas on the surface; if an energy does not say so, each counts the same
template <class Energy>
struct Weighs_faces_by_area<Energy, std::enable_if_t<Energy::weighs_faces_by_area>> : std::true_type
{};

template <class Energy, class = void>
struct Follows_curvature : std::false_type
{};

// whether the faces are given larger areas where the surface is curved; if an energy does not say so, they have their own
template <class Energy>
struct Follows_curvature<Energy, std::enable_if_t<Energy::follows_curvature>> : std::true_type
{};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_FACE_WEIGHTS_H
