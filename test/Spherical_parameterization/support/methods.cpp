#include "methods.h"

#include "engine.h"
#include "judge.h"

#include <CGAL/Spherical_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Conformal_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Published_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Stereographic_parameterizer_3.h>

#include <CGAL/boost/graph/generators.h>

namespace test {

Point_map::Point_map(const Mesh& mesh, const Images& images)
  : m_data(std::make_shared<Data>())
{
  m_data->points.resize(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  auto p = images.begin();
  for(const auto v : vertices(mesh))
  {
    m_data->points[v] = Point_3((*p)[0], (*p)[1], (*p)[2]);
    ++p;
  }
}

SP::Error_code Method::parameterize(const Mesh& mesh, const Point_map& map, const Options& options) const
{
  Visitor visitor;
  return m_model->parameterize(mesh, map,
                               {options.m_points ? *options.m_points : Point_map(mesh, points(mesh)), options.m_seconds,
                                std::ref(options.m_visitor != nullptr ? *options.m_visitor : visitor),
                                options.m_iterations, options.m_is_parallel});
}

Result Method::run(const Mesh& mesh, const Options& options) const
{
  SCOPED_TRACE(m_name);
  const Images untouched = sentinels(mesh.number_of_vertices());
  const Point_map map(mesh, untouched);
  Result result;
  result.error = parameterize(mesh, map, options);
  result.report = report();
  result.images = images(mesh, map);
  if(result.error != SP::OK && !(m_may_fold && result.error == SP::ERROR_NO_1_TO_1_MAPPING))
  {
    EXPECT_NE(result.error, SP::ERROR_NO_1_TO_1_MAPPING);
    EXPECT_TRUE(have_same_bits(result.images, untouched));
    return result;
  }
  EXPECT_EQ(static_cast<bool>(judge::is_one_to_one(result.images, triangles(mesh))), result.error == SP::OK);
  EXPECT_EQ(is_bijective(mesh, result.images), result.error == SP::OK);
  result.distortion = measure(mesh, result.images);
  EXPECT_EQ(result.distortion.number_of_inverted_faces == 0, result.error == SP::OK);
  // All vertices are on the sphere; those without a face stay where they are.
  const double radius = result.report.radius;
  std::size_t n_on_sphere = 0, n_untouched = 0;
  for(std::size_t v = 0; v < untouched.size(); ++v)
  {
    n_on_sphere += std::abs(norm(result.images[v]) - radius) <= 1e-15 * radius;
    n_untouched += result.images[v] == untouched[v];
  }
  EXPECT_EQ(n_on_sphere, result.report.number_of_vertices);
  EXPECT_EQ(n_untouched, result.report.number_of_isolated_vertices);
  EXPECT_EQ(n_on_sphere + n_untouched, untouched.size());
  return result;
}

Result Method::run(const Triangle_list& list, const Options& options) const
{
  return run(make(list), options);
}

Method bijective()
{
  return Method("bijective", SP::Bijective_low_distortion_parameterizer_3());
}

Method hierarchical()
{
  return Method("hierarchical", SP::Hierarchical_parameterizer_3());
}

Method published()
{
  return Method("published", SP::Published_low_distortion_parameterizer_3());
}

Method stereographic()
{
  return Method("stereographic", SP::Stereographic_parameterizer_3());
}

Method schnyder()
{
  return Method("schnyder", SP::Schnyder_parameterizer_3());
}

Method harmonic()
{
  return Method("harmonic", SP::Harmonic_parameterizer_3());
}

Method conformal()
{
  return Method("conformal", SP::Conformal_parameterizer_3(), true);
}

Method arap()
{
  return Method("as rigid as possible", SP::ARAP_parameterizer_3(), true);
}

std::vector<Method> all_methods()
{
  return {bijective(), hierarchical(), published(), stereographic(), schnyder(), harmonic(), conformal(), arap()};
}

Method bijective_conformal()
{
  return Method(
      "bijective, conformal",
      SP::Bijective_low_distortion_parameterizer_3().energy(SP::Conformal_energy_3()).radius(SP::Fixed_radius_3()));
}

Method sampling()
{
  return Method("sampling", SP::Bijective_low_distortion_parameterizer_3()
                                .energy(SP::Stretch_energy_3())
                                .radius(SP::Area_preserving_radius_3())
                                .sharpness(SP::Sharpness::relative(3.)));
}

Method precomputed(const Mesh& mesh, const Images& images)
{
  return Method("precomputed", SP::Precomputed_parameterizer_3(Point_map(mesh, images)));
}

Method bijective_from(const Mesh& mesh, const Images& images)
{
  return Method("bijective from a given map", SP::Bijective_low_distortion_parameterizer_3().initial_parameterizer(
                                                  SP::Precomputed_parameterizer_3(Point_map(mesh, images))));
}

Method bijective_from_stereographic()
{
  return Method("bijective from stereographic", SP::Bijective_low_distortion_parameterizer_3().initial_parameterizer(
                                                    SP::Stereographic_parameterizer_3()));
}

void expect_error(const Mesh& mesh, const Method& method, SP::Error_code error)
{
  const Result result = method.run(mesh);
  EXPECT_EQ(result.error, error) << method.name();
  EXPECT_EQ(result.report.number_of_iterations(), 0u);
  EXPECT_EQ(result.report.stop_reason, SP::NOT_RUN);
}

Mesh make(const Triangle_list& list)
{
  return test_meshes::make_mesh<Mesh>(list);
}

Mesh cube()
{
  Mesh result;
  CGAL::make_hexahedron(Point_3(-1, -1, -1), Point_3(1, -1, -1), Point_3(1, 1, -1), Point_3(-1, 1, -1),
                        Point_3(-1, 1, 1), Point_3(-1, -1, 1), Point_3(1, -1, 1), Point_3(1, 1, 1), result);
  return result;
}

// the triangles of a domain, whose points are its directions
Triangle_list list_of(const SP::Sphere_domain_3& domain)
{
  Triangle_list result;
  for(const Point_3& p : domain.directions())
    result.points.push_back({p.x(), p.y(), p.z()});
  for(const auto& t : domain.triangles())
    result.triangles.push_back({t[0], t[1], t[2]});
  return result;
}

std::vector<Triangle> triangles(const Mesh& mesh)
{
  std::vector<std::size_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  std::size_t n = 0;
  for(const auto v : vertices(mesh))
    number[v] = n++;
  std::vector<Triangle> result;
  for(const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    result.push_back({number[source(h, mesh)], number[target(h, mesh)], number[target(next(h, mesh), mesh)]});
  }
  return result;
}

Images points(const Mesh& mesh)
{
  return images(mesh, mesh.points());
}

bool is_bijective(const Mesh& mesh, const Images& images)
{
  return SP::is_bijective(mesh, Point_map(mesh, images));
}

SP::Distortion_summary measure(const Mesh& mesh, const Images& images)
{
  return distortion_of(mesh, Point_map(mesh, images));
}

} // namespace test
