#include "Repair_step.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Program {

File_content wrapping_of(const File_content& surface, double alpha)
{
  using Wrap_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  constexpr double offsets_per_alpha = 30.; // the ratio in the examples of CGAL
  std::vector<Wrap_kernel::Point_3> points;
  CGAL::Bbox_3 box;
  for(const Point_3& p : surface.points)
    points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const Polygon& polygon : surface.polygons)
  {
    for(const std::size_t v : polygon)
      box += surface.points[v].bbox();
    for(std::size_t k = 2; k < polygon.size(); ++k) // wrapping also accepts polygons that are not planar
      if(std::array<std::size_t, 3> t = {polygon[0], polygon[k - 1], polygon[k]};
         !CGAL::collinear(points[t[0]], points[t[1]], points[t[2]]))
        triangles.push_back(t);
  }
  const double length = alpha * SP::internal::hypotenuse((box.max)(0) - (box.min)(0), (box.max)(1) - (box.min)(1),
                                                         (box.max)(2) - (box.min)(2));
  if(triangles.empty() || !std::isfinite(length))
    throw Program_error(
        "the surface cannot be wrapped: all its triangles are degenerate, or its coordinates are too large");
  CGAL::Surface_mesh<Wrap_kernel::Point_3> wrapping;
  CGAL::alpha_wrap_3(points, triangles, length, length / offsets_per_alpha, wrapping);
  File_content result;
  for(const Wrap_kernel::Point_3& p : wrapping.points())
    result.points.emplace_back(p.x(), p.y(), p.z());
  for(const auto f : wrapping.faces())
  {
    result.polygons.emplace_back();
    for(const auto v : CGAL::vertices_around_face(wrapping.halfedge(f), wrapping))
      result.polygons.back().push_back(v);
  }
  return result;
}

} // namespace Program
