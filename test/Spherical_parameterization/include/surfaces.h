#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_SURFACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_SURFACES_H

// Surfaces with maps to the sphere that are known, to be compared with each other.

#include "methods.h"
#include "random_meshes.h"

#include <CGAL/Spherical_parameterization/sampling.h>
#include <CGAL/Spherical_parameterization/surface_maps.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/Surface_pair.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/read_two_surfaces.h>

namespace test {

using Mapper = SP::Surface_mapper_3<Mesh>;
using Rotation_3 = SP::Sphere_alignment_3::Rotation_3;
using Quaternion = SP::internal::Quaternion;
using Vector_3d = SP::internal::Vector_3d;
using Vertex_index = Mesh::Vertex_index;
using Image_map = Mesh::Property_map<Vertex_index, Point_3>;
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

inline double distance(const Point_3& p, const Point_3& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

inline Point_3 as_it_is(const Point_3& p)
{
  return p;
}

// A mesh and a map to the sphere
struct Mapped_mesh
{
  Mesh mesh;
  Image_map sphere;

  // the surface has the vertex p of the list at position_of(p), and its image is p, rotated
  template <class Position = Point_3 (*)(const Point_3&)>
  explicit Mapped_mesh(const Triangle_list& list, const Position& position_of = &as_it_is,
                       const Quaternion& turn = turns[0])
    : mesh(make(list))
    , sphere(add_map("v:sphere"))
  {
    for(const Vertex_index v : mesh.vertices())
    {
      const Point_3 p = mesh.point(v);
      sphere[v] = rotation(turn).transform(p);
      mesh.point(v) = position_of(p);
    }
  }

  // a map to write to
  Image_map add_map(const char* name = "v:images") { return mesh.add_property_map<Vertex_index, Point_3>(name).first; }
};

// The same, as the parts that map surfaces take it.
struct Located_mesh : SP::internal::Located_surface
{
  explicit Located_mesh(const Mapped_mesh& m)
  {
    SP::internal::Mesh_on_sphere<Mesh, Image_map> arrays;
    EXPECT_EQ(arrays.read_with_points(m.mesh, m.sphere, CGAL::parameters::default_values(), {}), SP::OK);
    EXPECT_EQ(assign(SP::internal::surface_of(arrays)), SP::OK);
  }

  // the directions of the images, in the order of `mesh`
  std::vector<Vector_3d> positions() const { return mesh.in_own_order(SP::internal::directions_of(sphere)); }
};

// Calls a function for surfaces that are to be refused, with the error.
template <class Function>
void for_each_broken_surface(const Function& function)
{
  const Vertex_index v(0);
  Mapped_mesh inverted(icosphere(1)), infinite(icosphere(1)), open(icosphere(1)), ring(torus(5, 5));
  inverted.sphere[v] = inverted.sphere[v] + 2. * (CGAL::ORIGIN - inverted.sphere[v]);
  infinite.mesh.point(v) = Point_3(0., std::numeric_limits<double>::infinity(), 0.);
  CGAL::Euler::remove_face(halfedge(*faces(open.mesh).begin(), open.mesh), open.mesh);
  function(inverted, SP::ERROR_NO_1_TO_1_MAPPING);
  function(infinite, SP::ERROR_NON_FINITE_COORDINATE);
  function(open, SP::ERROR_NON_CLOSED_MESH);
  function(ring, SP::ERROR_NO_TOPOLOGICAL_SPHERE);
}

// The mean of a function of the vertices.
template <class Function>
double mean_over_vertices(const Mesh& mesh, const Function& f)
{
  double sum = 0.;
  for(const Vertex_index v : mesh.vertices())
    sum += f(v);
  return sum / static_cast<double>(mesh.number_of_vertices());
}

// The vertex where a function is least.
template <class Function>
Vertex_index least_vertex(const Mesh& mesh, const Function& f)
{
  const auto vertices = mesh.vertices();
  return *std::min_element(vertices.begin(), vertices.end(),
                           [&](Vertex_index v, Vertex_index w) { return f(v) < f(w); });
}

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
