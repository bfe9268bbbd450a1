// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_FACE_RANGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_FACE_RANGE_H

#include <CGAL/Spherical_parameterization/Face_invariants_3.h>

#include <cstddef>
#include <vector>

namespace archetypes {

// ConstRange, whose value type is Face_invariants_3
class Face_range
{
public:
  using const_iterator = std::vector<CGAL::Spherical_parameterization::Face_invariants_3>::const_iterator;
  using size_type = std::size_t;

  Face_range()
    : m_faces({{1., 2., 1., 1.}, {2., 2.5, 0.9, 1.1}})
  {}
  Face_range(const Face_range&) = delete;
  Face_range& operator=(const Face_range&) = delete;

  const_iterator begin() const { return m_faces.begin(); }
  const_iterator end() const { return m_faces.end(); }
  size_type size() const { return m_faces.size(); }
  bool empty() const { return m_faces.empty(); }

private:
  std::vector<CGAL::Spherical_parameterization::Face_invariants_3> m_faces;
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_FACE_RANGE_H
