#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_SURFACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_SURFACES_H

// Surfaces with maps to the sphere that are known, to be compared with each other.

#include "methods.h"
#include "random_meshes.h"

#include <CGAL/Spherical_parameterization/Surface_maps/align_spheres.h>

namespace test {

using Rotation_3 = SP::Sphere_alignment_3::Rotation_3;
using Quaternion = SP::internal::Quaternion;
using Vertex_index = Mesh::Vertex_index;
using Vertex_pairs = std::vector<std::pair<Vertex_index, Vertex_index>>;

inline const std::array<Quaternion, 4> turns = {Quaternion{1., 0., 0., 0.}, Quaternion{0.3, -0.5, 0.8, 0.1},
                                                Quaternion{-0.1, 0.2, 0.9, -0.6}, Quaternion{0., 0.6, 0., 0.8}};

inline Rotation_3 rotation(const Quaternion& q)
{
  return SP::internal::as_transformation(SP::internal::rotation_matrix(q));
}

// the angle between two rotations in degrees
inline double angle(const Rotation_3& a, const Rotation_3& b)
{
  double squared_distance = 0.; // of the matrices: 8 times the square of the sine of half the angle
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      squared_distance += (a.m(i, j) - b.m(i, j)) * (a.m(i, j) - b.m(i, j));
  return 360. / pi * std::asin((std::min)(1., std::sqrt(squared_distance / 8.)));
}

// A mesh and a map to the sphere
struct Mapped_mesh
{
  Mesh mesh;
  Mesh::Property_map<Vertex_index, Point_3> sphere;

  // the surface has the vertex p of the list at position_of(p), and its image at turn(p)
  template <class Position>
  Mapped_mesh(const Triangle_list& list, const Position& position_of, const Rotation_3& turn)
    : mesh(make(list))
    , sphere(mesh.add_property_map<Vertex_index, Point_3>("v:sphere").first)
  {
    for(const Vertex_index v : mesh.vertices())
    {
      const Point_3 p = mesh.point(v);
      sphere[v] = turn.transform(p);
      mesh.point(v) = position_of(p);
    }
  }
};

// a body with three extremities of different lengths, without a symmetry
inline Point_3 on_body(const Point_3& p)
{
  const auto extremity = [&](double x, double y, double z, double sharpness) {
    return std::exp(sharpness * ((x * p.x() + y * p.y() + z * p.z()) / std::sqrt(x * x + y * y + z * z) - 1.));
  };
  const double r =
      1. + 1.5 * extremity(1., 0., 0., 8.) + 1. * extremity(-1., 2., 0.5, 6.) - 0.4 * extremity(0., -1., 1.5, 3.);
  return Point_3(r * p.x(), 1.2 * r * p.y(), 0.8 * r * p.z());
}

inline Triangle_list octahedron_of(std::uint32_t n)
{
  return list_of(SP::Sphere_domain_3::octahedron(n));
}

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_SURFACES_H
