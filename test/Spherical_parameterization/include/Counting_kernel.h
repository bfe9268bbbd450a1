#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_COUNTING_KERNEL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_COUNTING_KERNEL_H

// A kernel that counts the orientations about the origin that it is asked for: what walks on the sphere take, which does not
// hang on the machine as seconds do.

#include "methods.h"

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3.h>
#include <CGAL/Spherical_parameterization/internal/locate/Sphere_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/surface/Linked_triangle.h>

namespace test {

struct Counting_kernel : Kernel
{
  inline static std::size_t n_orientations = 0;
};

} // namespace test

template <>
class CGAL::Spherical_parameterization::internal::Orientation_about_origin_3<test::Counting_kernel, double>
{
public:
  CGAL::Sign operator()(const test::Point_3& a, const test::Point_3& b, const test::Point_3& c) const
  {
    ++test::Counting_kernel::n_orientations;
    return m_orientation(a, b, c);
  }

private:
  Orientation_about_origin_3<test::Kernel> m_orientation;
};

namespace test {

// the triangulation of the sphere by the points of a mesh
template <class K>
SP::internal::Sphere_triangulation<K> triangulation_of(const Triangle_list& list)
{
  std::vector<Point_3> points;
  for(const Coordinates& p : list.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for(const Triangle& t : list.triangles)
    triangles.push_back(
        {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  SP::internal::Sphere_triangulation<K> result;
  result.assign(points, SP::internal::link_triangles(triangles, points.size()));
  return result;
}

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_COUNTING_KERNEL_H
