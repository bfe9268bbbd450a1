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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_BIJECTIVITY_CERTIFICATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_BIJECTIVITY_CERTIFICATE_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

#include <CGAL/enum.h>

#include <atomic>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The result of exact predicates on a closed triangle mesh around the origin.
//
// Theorem. Let the vertices of a closed oriented triangle mesh M have images other than the origin, and let every face
// be mapped to the spherical triangle of its images. If every face is positive, i.e. det(a, b, c) > 0, and if a point
// of the sphere on the image of no edge lies in exactly one face, then the map is a homeomorphism, and M is a sphere.
//
// Proof. A positive face is mapped injectively, with its orientation. The two faces of an edge lie on different sides
// of it, so the map is a local homeomorphism there. The faces around a vertex v turn around its image in one sense,
// each by an angle in (0, pi), and close up after k_v >= 1 full turns: the map is z -> z^k_v near v. So M is a branched
// covering of the sphere, and all points that are not images of an edge or vertex have the same number of preimages,
// the degree. If it is 1, then M is connected, since every component covers the sphere on its own, no k_v exceeds 1,
// since the points near the image of v have k_v preimages near v, and a covering of degree 1 is a homeomorphism.
//
// Positive faces alone are not sufficient: a star can wind around its center twice (k_v = 2), and two such stars
// together with the faces between them cover the sphere twice.
struct Bijectivity_certificate
{
  std::size_t number_of_non_positive_faces = 0; // faces that are inverted or degenerate, or have no finite image
  std::size_t degree = 0;                       // known, i.e. not 0, only if all faces are positive

  bool is_bijective() const { return number_of_non_positive_faces == 0 && degree == 1; }
};

// Counts the triangles for which `is_counted(t)`.
template <class Triangles, class Predicate>
std::size_t count_triangles(Execution execution, const Triangles& triangles, const Predicate& is_counted)
{
  std::atomic<std::size_t> result(0);
  for_each_block(execution, 0, triangles.size(), usual_block_size, [&](std::size_t begin, std::size_t end) {
    std::size_t n = 0;
    for(std::size_t k = begin; k < end; ++k)
      n += is_counted(triangles[k]);
    result += n;
  });
  return result;
}

// Computes the certificate in linear time and, sequentially, without allocating memory; in parallel only if the
// coordinates are of type double, because copies of exact numbers may share mutable state.
//
// `K` is a kernel with exact predicates, `points` a random-access range of its points, `triangles` a range of index
// triples: a closed mesh whose triangles are oriented consistently. Points that no triangle uses are ignored.
template <class K, class Points, class Triangles>
Bijectivity_certificate certify_bijectivity(const Points& points, const Triangles& triangles, Execution execution)
{
  using FT = typename K::FT;
  if(!std::is_same<FT, double>::value)
    execution = Execution();
  const Orientation_about_origin_3<K> orientation;

  Bijectivity_certificate certificate;
  certificate.number_of_non_positive_faces = count_triangles(execution, triangles, [&](const auto& t) {
    return orientation(points[t[0]], points[t[1]], points[t[2]]) != POSITIVE;
  });
  if(certificate.number_of_non_positive_faces != 0)
    return certificate;

  // The directions (1, x, x^2) lie on a curve that meets any plane through the origin at most twice. So for any mesh,
  // at most two of them are unsuitable per edge, and in practice the first one is suitable. With x = k / 2^20 and k <
  // 2^26 they are exact in double precision.
  for(double k = 742913.; k < 0x1p26; ++k)
  {
    const double x = k * 0x1p-20;
    const typename K::Point_3 q{FT(1.), FT(x), FT(x * x)};
    std::atomic<bool> is_generic(true); // not on the boundary of a cone that contains it
    certificate.degree = count_triangles(execution, triangles, [&](const auto& t) {
      bool is_on_boundary = false;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Sign side = orientation(points[t[i]], points[t[(i + 1) % 3]], q);
        if(side == NEGATIVE)
          return false;
        is_on_boundary = is_on_boundary || side == ZERO;
      }
      if(is_on_boundary)
        is_generic = false;
      return true;
    });
    if(is_generic)
      return certificate;
  }
  certificate.degree = 0;
  return certificate;
}

// Whether points on the sphere define a bijection of a closed triangle mesh.
inline bool are_bijective(const Index_triangles& triangles, const std::vector<Vector_3d>& points,
                          const Execution& execution)
{
  return certify_bijectivity<Double_points>(points, triangles, execution).is_bijective();
}

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CERTIFICATE_BIJECTIVITY_CERTIFICATE_H
