#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_BROKEN_MAPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_BROKEN_MAPS_H

// What every function of a mesh with a map to the sphere has to refuse.

#include "test_meshes.h"

#include <CGAL/Spherical_parameterization/Error_code.h>

namespace test {

// Meshes whose points are their images, each with its error.
inline std::vector<std::pair<test_meshes::Triangle_list, CGAL::Spherical_parameterization::Error_code>> broken_maps()
{
  using namespace CGAL::Spherical_parameterization;
  const test_meshes::Triangle_list sphere = test_meshes::icosphere(1);
  test_meshes::Triangle_list folded = sphere, infinite = sphere, open = sphere;
  std::swap(folded.points[0], folded.points[1]);
  infinite.points[3][1] = std::numeric_limits<double>::infinity();
  open.triangles.pop_back();
  return {{folded, ERROR_NO_1_TO_1_MAPPING},
          {test_meshes::suspension(5, 2), ERROR_NO_1_TO_1_MAPPING},
          {infinite, ERROR_NON_FINITE_COORDINATE},
          {open, ERROR_NON_CLOSED_MESH},
          {test_meshes::torus(5, 5), ERROR_NO_TOPOLOGICAL_SPHERE},
          {test_meshes::disjoint_union(sphere, sphere), ERROR_SEVERAL_COMPONENTS},
          {{}, ERROR_EMPTY_MESH}};
}

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_BROKEN_MAPS_H
