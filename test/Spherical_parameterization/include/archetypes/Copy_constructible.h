// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_COPY_CONSTRUCTIBLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_COPY_CONSTRUCTIBLE_H

namespace archetypes {

// What can be made by the test alone, and copied: a model of CopyConstructible that is a model of nothing else.
class Copy_constructible
{
public:
  enum Maker
  {
    TEST
  };

  explicit Copy_constructible(Maker) {}
  Copy_constructible(const Copy_constructible&) = default;
  Copy_constructible& operator=(const Copy_constructible&) = delete;
  void operator&() const = delete;
  template <class T>
  void operator,(const T&) const = delete;
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_COPY_CONSTRUCTIBLE_H
