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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FACE_RANGE_3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FACE_RANGE_3_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>

#include <array>
#include <cstddef>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {

#ifndef DOXYGEN_RUNNING
namespace internal {
template <class Space, class Step>
class Block_coordinate_descent;
}
#endif

/// \ingroup PkgSphericalParameterizationEnergies
///
/// The class `Face_invariants_3` holds what a radius policy can use of a face: its area on the surface and the
/// invariants of its map to the sphere of the current radius.
///
/// If the radius is multiplied by \f$ \rho \f$, then `i`, `d` and `flat_d` are multiplied by \f$ \rho^2 \f$. The shape
/// of a (nearly) degenerate face is replaced by a slightly less degenerate one.
///
/// \sa `Face_range_3`
struct Face_invariants_3
{
  double area; ///< \f$ A \f$, the area of the face on the surface, in a unit in which the area of the surface is 4 pi
  double i;    ///< \f$ I = \sigma_1^2 + \sigma_2^2 \f$ of the map onto the flat image triangle
  double d; ///< the invariant of the energy: \f$ \det(u_0, u_1, u_2) / (2 A r) \f$; in the published method: `flat_d`
  double flat_d; ///< \f$ \sigma_1 \sigma_2 = a / A \f$ of the map onto the flat image triangle with the area \f$ a \f$
};

/// \ingroup PkgSphericalParameterizationEnergies
///
/// The class `Face_range_3` is the range of the faces of a mesh that radius policies and energies iterate over. Its
/// values are the invariants of each face on the sphere of the current radius. The range refers to data of the caller
/// and is valid only during the call that receives it.
///
/// \cgalModels{ConstRange}
class Face_range_3
{
public:
  /// Value type
  using value_type = Face_invariants_3;
  /// Iterator type
  using const_iterator = const Face_invariants_3*;
  /// Iterator type, the same type because the faces are constant
  using iterator = const_iterator;
  /// Size type
  using size_type = std::size_t;

  /// constructs the range of the faces in [`begin`, `end`).
  Face_range_3(const_iterator begin, const_iterator end)
    : m_begin(begin)
    , m_end(end)
  {}

  /// returns the first face.
  const_iterator begin() const { return m_begin; }
  /// returns the end of the range.
  const_iterator end() const { return m_end; }
  /// returns the number of faces.
  size_type size() const { return static_cast<size_type>(m_end - m_begin); }
  /// returns whether there is no face.
  bool empty() const { return m_begin == m_end; }

  /// returns `n` sums over all faces, computed with all threads of the run. The order of the additions, and therefore
  /// the result, does not depend on the number of threads. The function takes linear time.
  ///
  /// \tparam n the number of sums
  /// \tparam Terms a function object that several threads may call concurrently
  ///
  /// \param terms `terms(face)` returns an `std::array<double, n>`, the summands of the face
  template <std::size_t n, class Terms>
  std::array<double, n> sums(const Terms& terms) const
  {
    std::vector<std::array<double, n>> parts((size() + internal::usual_block_size - 1) / internal::usual_block_size);
    internal::for_each_block(m_execution, 0, size(), internal::usual_block_size,
                             [&](std::size_t begin, std::size_t end) {
                               std::array<double, n> part = {};
                               for(const_iterator face = m_begin + begin; face != m_begin + end; ++face)
                                 add(terms(*face), part);
                               parts[begin / internal::usual_block_size] = part;
                             });
    std::array<double, n> result = {};
    for(const std::array<double, n>& part : parts)
      add(part, result);
    return result;
  }

private:
  template <class Space, class Step>
  friend class internal::Block_coordinate_descent;

  Face_range_3(const_iterator begin, const_iterator end, const internal::Execution& execution)
    : m_begin(begin)
    , m_end(end)
    , m_execution(execution)
  {}

  template <std::size_t n>
  static void add(const std::array<double, n>& terms, std::array<double, n>& sums)
  {
    for(std::size_t k = 0; k < n; ++k)
      sums[k] += terms[k];
  }

  const_iterator m_begin, m_end;
  internal::Execution m_execution; // sequential except for the faces of a run
};

} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FACE_RANGE_3_H
