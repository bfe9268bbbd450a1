#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_H

// Archetypes of the concepts, which can do what the concepts ask for and nothing else: what compiles with them asks for no
// more than is documented.

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <map>

namespace archetypes {

namespace SP = CGAL::Spherical_parameterization;

// What can be made by the test alone, and copied: a model of CopyConstructible that is a model of nothing else.
class Copy_constructible
{
public:
  enum Maker
  {
    MADE_BY_TEST
  };

  explicit Copy_constructible(Maker) {}
  Copy_constructible(const Copy_constructible&) = default;
  Copy_constructible& operator=(const Copy_constructible&) = delete;
  void operator&() const = delete;
  template <class T>
  void operator,(const T&) const = delete;
};

// DistortionEnergy_3 for double, without the optional members: the angle distortion and some of the square of the area
// distortion
class Distortion_energy : public Copy_constructible
{
public:
  Distortion_energy(Maker maker, double weight)
    : Copy_constructible(maker)
    , m_weight(weight)
  {}

  double operator()(double i, double d) const { return derivatives(i, d).value; }

  SP::Energy_derivatives_3<> derivatives(double i, double d) const
  {
    const double w = m_weight, d2 = d * d;
    return {i / d + w * (d2 + 1. / d2),
            1. / d,
            -i / d2 + 2. * w * (d - 1. / (d2 * d)),
            0.,
            -1. / d2,
            2. * i / (d2 * d) + 2. * w * (1. + 3. / (d2 * d2))};
  }

private:
  double m_weight;
};

// DistortionEnergy_3 for any number type: the symmetric Dirichlet energy in the four operations with FT and double alone
class Distortion_energy_in_lanes : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    return 0.5 * i * (1. + 1. / (d * d));
  }

  template <class FT>
  SP::Energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    const FT inverse = 1. / (d * d);
    return {0.5 * i * (1. + inverse),    0.5 * (1. + inverse), -i * inverse / d, FT(0.), -inverse / d,
            3. * i * (inverse * inverse)};
  }
};

// SphereRadiusPolicy_3 without the optional members
class Sphere_radius_policy : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  double initial_radius(double equal_area_radius) const { return 2. * equal_area_radius; }

  // such that the average of the ratios of the areas is 1
  template <class Energy>
  double operator()(const Energy& energy, const SP::Face_range_3& faces, double radius)
  {
    double sum = 0.;
    for(const SP::Face_invariants_3& face : faces)
      sum += energy(face.i, face.d) > 0. ? face.flat_d : 0.;
    return radius * std::sqrt(static_cast<double>(faces.size()) / sum);
  }
};

// SphericalParameterizer_3 without the optional member
class Spherical_parameterizer : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters>
  SP::Error_code parameterize(const TriangleMesh& tmesh, VertexSphereMap vertex_sphere_map, const NamedParameters& np)
  {
    SP::Hierarchical_parameterizer_3 parameterizer;
    return parameterizer.template parameterize<ConcurrencyTag>(tmesh, vertex_sphere_map, np);
  }
};

// SphericalParameterizationVisitor
class Visitor : public Copy_constructible
{
public:
  using Copy_constructible::Copy_constructible;

  void on_initialization_begin(std::size_t) {}
  void on_level(std::size_t) {}
  void on_initialization_end() {}
  void after_iteration(std::size_t, double, double) {}
  bool go_further(std::size_t, double) { return true; }
  void on_optimization_end() {}
};

// ReadablePropertyMap: it is copied and read, and nothing else.
template <class Mesh, class VertexDescriptor, class Point>
class Vertex_point_map : public Copy_constructible
{
public:
  using key_type = VertexDescriptor;
  using value_type = Point;
  using reference = Point; // a new one each time, as of a map that computes them
  using category = boost::readable_property_map_tag;

  explicit Vertex_point_map(const Mesh& mesh)
    : Copy_constructible(MADE_BY_TEST)
    , m_mesh(mesh)
  {}

  friend Point get(const Vertex_point_map& map, const VertexDescriptor& vertex) { return map.m_mesh.point(vertex); }

private:
  const Mesh& m_mesh;
};

// WritablePropertyMap: it is copied and written, and nothing else. What it has got is for the test to look at.
template <class VertexDescriptor, class Point>
class Vertex_sphere_map : public Copy_constructible
{
public:
  using key_type = VertexDescriptor;
  using value_type = Point;
  using reference = void;
  using category = boost::writable_property_map_tag;

  explicit Vertex_sphere_map(std::map<VertexDescriptor, Point>& images)
    : Copy_constructible(MADE_BY_TEST)
    , m_images(images)
  {}

  friend void put(const Vertex_sphere_map& map, const VertexDescriptor& vertex, const Point& image)
  {
    map.m_images[vertex] = image;
  }

private:
  std::map<VertexDescriptor, Point>& m_images;
};

} // namespace archetypes

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_ARCHETYPES_H
