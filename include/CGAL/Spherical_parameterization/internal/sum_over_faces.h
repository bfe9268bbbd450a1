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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SUM_OVER_FACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SUM_OVER_FACES_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Face_invariants_3.h>
#include <CGAL/Spherical_parameterization/internal/Face_range.h>
#include <CGAL/Spherical_parameterization/internal/for_each_block.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

using Two_sums = std::array<double, 2>;

// Sums up terms(x), two at once, over all x.
template <class Range, class Terms>
Two_sums two_sums(const Range& range, const Terms& terms)
{
  Two_sums sums = {0., 0.};
  for(const auto& x : range)
  {
    const Two_sums summands = terms(x);
    sums[0] += summands[0];
    sums[1] += summands[1];
  }
  return sums;
}

// Sums up terms(face) over any range of faces.
template <class FaceRange, class Terms>
Two_sums sum_over_faces(const FaceRange& faces, const Terms& terms)
{
  return two_sums(faces, terms);
}

// The same over the faces of a descent, block by block.
template <class ConcurrencyTag, class Terms>
Two_sums sum_over_faces(const Face_range<ConcurrencyTag>& faces, const Terms& terms)
{
  constexpr std::size_t block_size = 1024;
  const std::size_t n = faces.size();
  std::vector<Two_sums> parts((n + block_size - 1) / block_size);
  for_each_block<ConcurrencyTag>(0, n, block_size, [&](std::size_t begin, std::size_t end) {
    const Face_range<ConcurrencyTag> block(faces.begin() + begin, faces.begin() + end);
    parts[begin / block_size] = two_sums(block, terms);
  });
  return two_sums(parts, [](const Two_sums& sums) { return sums; });
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SUM_OVER_FACES_H
