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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_PARALLEL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_PARALLEL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/library.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

// The execution of loops, in one thread or in several, is determined by a value, so that code below the parameterizers
// is not compiled for each tag. The value contains the functions of the thread pool. So code compiled without TBB is
// the same as code compiled with it, except for `execution_of<Parallel_tag>()`, and both may be linked into one
// program.

// Refers to a function f(begin, end) without owning it.
class Block_function
{
public:
  template <class Function>
  explicit Block_function(const Function& f)
    : m_function(&f)
    , m_call([](const void* function, std::size_t begin, std::size_t end) {
      (*static_cast<const Function*>(function))(begin, end);
    })
  {}

  void operator()(std::size_t begin, std::size_t end) const { m_call(m_function, begin, end); }

private:
  const void* m_function;
  void (*m_call)(const void*, std::size_t, std::size_t);
};

// A pointer for each thread that requests it, initially null.
class Thread_pointers
{
public:
  virtual ~Thread_pointers() = default;
  virtual void*& local() = 0;
};

// Calls f(k, k + 1) for all k < n in this thread.
inline void run_in_one_thread(std::size_t n, const Block_function& f)
{
  for(std::size_t k = 0; k < n; ++k)
    f(k, k + 1);
}

struct Execution // sequential by default
{
  void (*run)(std::size_t n, const Block_function& f) = &run_in_one_thread;
  std::unique_ptr<Thread_pointers> (*make_thread_pointers)() = nullptr; // null: there is only one thread
};

// Loops in the thread pool of TBB, with any number of threads. The loop may be called from within a task of the caller.
Execution parallel_execution();

template <class ConcurrencyTag>
Execution execution_of()
{
  if constexpr(std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
#ifdef CGAL_LINKED_WITH_TBB
    return parallel_execution();
#else
    static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                  "Parallel_tag is enabled but TBB is unavailable.");
#endif
  }
  else
    return Execution();
}

constexpr std::size_t usual_block_size = 1024; // of a loop: large enough to make the overhead negligible

// Calls f(begin, end) for consecutive blocks that cover [first, last), in parallel if there is more than one. The
// blocks do not depend on the number of threads: block k starts at first + k * block_size. So reductions within blocks
// and then over the blocks in order have bitwise identical results.
template <class Function>
void for_each_block(const Execution& execution, std::size_t first, std::size_t last, std::size_t block_size,
                    const Function& f)
{
  const std::size_t n_blocks = last > first ? (last - first + block_size - 1) / block_size : 0;
  const auto run_block = [&](std::size_t block, std::size_t) {
    const std::size_t begin = first + block * block_size;
    f(begin, (std::min)(begin + block_size, last));
  };
  (n_blocks > 1 ? execution.run : &run_in_one_thread)(n_blocks, Block_function(run_block));
}

// Calls f(k) for all k in [first, last), block by block.
template <class Function>
void for_each_in_blocks(const Execution& execution, std::size_t first, std::size_t last, std::size_t block_size,
                        const Function& f)
{
  for_each_block(execution, first, last, block_size, [&](std::size_t begin, std::size_t end) {
    for(std::size_t k = begin; k < end; ++k)
      f(k);
  });
}

// Calls f() and g(), in parallel or one after the other. Neither may depend on the effects of the other one. Loops
// within them are parallel as well; but a thread that runs one of the two does not help with the loops of the other, so
// g() should be the shorter one.
template <class Function, class OtherFunction>
void run_both(const Execution& execution, const Function& f, const OtherFunction& g)
{
  for_each_block(execution, 0, 2, 1, [&](std::size_t k, std::size_t) {
    if(k == 0)
      f();
    else
      g();
  });
}

// One copy of a scratch object for each thread that requests it, or just one if the execution is sequential.
template <class T>
class Per_thread
{
public:
  Per_thread(const Execution& execution, const T& exemplar)
    : m_exemplar(exemplar)
    , m_pointers(execution.make_thread_pointers ? execution.make_thread_pointers() : nullptr)
  {}

  T& local()
  {
    if(!m_pointers)
      return m_exemplar;
    void*& pointer = m_pointers->local();
    if(!pointer)
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_objects.push_back(std::make_unique<T>(m_exemplar));
      pointer = m_objects.back().get();
    }
    return *static_cast<T*>(pointer);
  }

private:
  T m_exemplar;
  std::unique_ptr<Thread_pointers> m_pointers;
  std::mutex m_mutex; // of the objects, one per thread
  std::vector<std::unique_ptr<T>> m_objects;
};

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
#include <CGAL/Spherical_parameterization/internal/execution/parallel_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_EXECUTION_PARALLEL_H
