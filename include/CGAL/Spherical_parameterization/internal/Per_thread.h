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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PER_THREAD_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PER_THREAD_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#endif

#include <type_traits>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// One copy of a scratch object for each thread that asks for it, or just one if `ConcurrencyTag` is sequential.
template <class ConcurrencyTag, class T, bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value>
class Per_thread
{
public:
  explicit Per_thread(const T& exemplar)
    : m_object(exemplar)
  {}
  T& local() { return m_object; }

private:
  T m_object;
};

#ifdef CGAL_LINKED_WITH_TBB
template <class ConcurrencyTag, class T>
class Per_thread<ConcurrencyTag, T, true>
{
public:
  explicit Per_thread(const T& exemplar)
    : m_objects(exemplar)
  {}
  T& local() { return m_objects.local(); }

private:
  tbb::enumerable_thread_specific<T> m_objects;
};
#endif

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PER_THREAD_H
