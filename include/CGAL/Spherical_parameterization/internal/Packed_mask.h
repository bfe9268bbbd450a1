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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_MASK_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_MASK_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/Packed_vectors.h>

#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

// A condition for each lane of a Packed_double.
template <int W>
class alignas(8 * W) Packed_mask
{
public:
  using Integers = typename Packed_vectors<W>::Integers;

  CGAL_SPHERICAL_PARAMETERIZATION_INLINE explicit Packed_mask(const Integers& lanes)
    : m_lanes(lanes)
  {}
  CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_mask(const Packed_mask& other)
    : m_lanes(other.m_lanes)
  {}
  CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_mask& operator=(const Packed_mask& other)
  {
    m_lanes = other.m_lanes;
    return *this;
  }

  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE bool lane(const Packed_mask& a, std::size_t k)
  {
    return a.m_lanes[k] != 0;
  }

  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_mask operator&&(const Packed_mask& a, const Packed_mask& b)
  {
    return Packed_mask(a.m_lanes & b.m_lanes);
  }
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_mask operator||(const Packed_mask& a, const Packed_mask& b)
  {
    return Packed_mask(a.m_lanes | b.m_lanes);
  }
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE Packed_mask operator!(const Packed_mask& a)
  {
    return Packed_mask(~a.m_lanes);
  }

  // whether the condition holds in any lane
  friend CGAL_SPHERICAL_PARAMETERIZATION_INLINE bool any(const Packed_mask& a)
  {
    return Packed_vectors<W>::any_negative(a.m_lanes);
  }

  // all bits of a lane are set where the condition holds
  CGAL_SPHERICAL_PARAMETERIZATION_INLINE const Integers& lanes() const { return m_lanes; }

private:
  Integers m_lanes;
};

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HAS_VECTORS

// The same for a single number.

CGAL_SPHERICAL_PARAMETERIZATION_INLINE bool lane(bool a, std::size_t)
{
  return a;
}

CGAL_SPHERICAL_PARAMETERIZATION_INLINE bool any(bool condition)
{
  return condition;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PACKED_MASK_H
