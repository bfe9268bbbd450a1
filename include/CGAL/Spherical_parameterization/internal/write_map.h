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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_WRITE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_WRITE_MAP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/internal/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/Exact_predicates_kernel.h>
#include <CGAL/Spherical_parameterization/internal/Guarantee.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/is_finite.h>
#include <CGAL/Spherical_parameterization/internal/put_all.h>

#include <CGAL/Kernel_traits.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Scales the positions from the unit sphere to the sphere of radius `radius`, certifies the points exactly as the
// caller will get them, and only then writes them: the second of the two places that touch the caller's data. A map
// that is not one-to-one is written only if nothing else was promised.
//
// A property map may hold other values than those that it was given, for example numbers of single precision. So what
// can be read is read again, and certified anew if it differs.
template <class ConcurrencyTag, class VertexDescriptor, class VertexSphereMap>
Error_code write_map(const Indexed_mesh& mesh, const std::vector<VertexDescriptor>& vertices_of_mesh,
                     const std::vector<Vector_3d>& positions, double radius, Guarantee guarantee,
                     VertexSphereMap vertex_sphere_map)
{
  using Point_3 = typename boost::property_traits<VertexSphereMap>::value_type;
  using Category = typename boost::property_traits<VertexSphereMap>::category;
  using Selection = Exact_predicates_kernel_of_map<VertexSphereMap>;
  using Exact_kernel = typename Selection::type;
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;

  if(!(radius > 0.) || !is_finite(radius))
    return ERROR_INSUFFICIENT_PRECISION;
  if constexpr(std::is_floating_point<FT>::value)
    if(radius > static_cast<double>((std::numeric_limits<FT>::max)()))
      return ERROR_INSUFFICIENT_PRECISION;

  std::vector<Point_3> points;
  points.reserve(positions.size());
  for(const Vector_3d& u : positions)
  {
    if(!is_finite(u))
      return ERROR_INSUFFICIENT_PRECISION;
    points.push_back(
        Point_3(static_cast<FT>(radius * u[0]), static_cast<FT>(radius * u[1]), static_cast<FT>(radius * u[2])));
  }
  const auto certify = [&](const std::vector<Point_3>& images) {
    std::vector<typename Exact_kernel::Point_3> exact_images;
    exact_images.reserve(images.size());
    for(const Point_3& p : images)
      exact_images.push_back(Selection::convert(p));
    return certify_bijectivity<Exact_kernel, ConcurrencyTag>(exact_images, mesh.triangles()).is_bijective();
  };
  bool is_bijective = certify(points);
  if(!is_bijective && guarantee == Guarantee::ONE_TO_ONE)
    return ERROR_INSUFFICIENT_PRECISION;

  const auto vertex = [&](std::size_t v) { return vertices_of_mesh[mesh.original(v)]; };
  const auto is_accepted_as_written = [&] {
    if constexpr(std::is_convertible<Category, boost::readable_property_map_tag>::value)
    {
      // Lazy numbers that were made from what is not finite must not be compared.
      constexpr bool are_comparable = std::is_floating_point<FT>::value;
      std::vector<Point_3> written;
      written.reserve(points.size());
      bool is_the_same = are_comparable;
      for(std::size_t v = 0; v < points.size(); ++v)
      {
        written.push_back(get(vertex_sphere_map, vertex(v)));
        if constexpr(are_comparable)
        {
          const Point_3& p = written.back();
          if(!is_finite({p.x(), p.y(), p.z()}))
            return false;
          is_the_same = is_the_same && p == points[v];
        }
      }
      if(!is_the_same)
        is_bijective = certify(written);
    }
    return is_bijective || guarantee != Guarantee::ONE_TO_ONE;
  };
  if(!put_all(vertex_sphere_map, vertex, points, is_accepted_as_written))
    return ERROR_INSUFFICIENT_PRECISION;
  return is_bijective ? OK : ERROR_NO_1_TO_1_MAPPING;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_WRITE_MAP_H
