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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FACE_RANGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FACE_RANGE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_invariants_3.h>

#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// The faces of a mesh as policies see them: a range of their invariants. Its type says how the policies of the
// package may go through it; see sum_over_faces().
template <class ConcurrencyTag>
class Face_range
{
public:
  using value_type = Face_invariants_3;
  using const_iterator = const Face_invariants_3*;
  using iterator = const_iterator;
  using size_type = std::size_t;

  Face_range(const_iterator begin, const_iterator end)
    : m_begin(begin)
    , m_end(end)
  {}

  const_iterator begin() const { return m_begin; }
  const_iterator end() const { return m_end; }
  size_type size() const { return static_cast<size_type>(m_end - m_begin); }
  bool empty() const { return m_begin == m_end; }

private:
  const_iterator m_begin, m_end;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FACE_RANGE_H
