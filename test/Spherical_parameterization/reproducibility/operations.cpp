// One case for each operation beside the default method; those that need Eigen only where it is.

#include "Hash_case.h"

#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/cortex.h>
#include <CGAL/Spherical_parameterization/harmonics.h>
#include <CGAL/Spherical_parameterization/sampling.h>
#include <CGAL/Spherical_parameterization/surface_maps.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Spherical_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Conformal_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Published_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Stereographic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Target_area_parameterizer_3.h>
#endif

#include <cstdint>
#include <sstream>
#include <utility>

namespace reproducibility {

namespace {

// A mesh with its default map
struct Mapped_mesh
{
  explicit Mapped_mesh(const Mesh& original)
    : mesh(original)
    , sphere(sphere_of(mesh))
  {
    check(SP::parameterize(mesh, sphere));
  }

  Mesh mesh;
  Sphere sphere;
};

#ifdef CGAL_EIGEN3_ENABLED
template <class Parameterizer>
void hash_other_method(const Mesh& mesh, Hash& hash, Parameterizer parameterizer)
{
  Mesh copy = mesh;
  const Sphere sphere = sphere_of(copy);
  check(SP::parameterize(copy, parameterizer, sphere));
  hash.add(copy, sphere);
}
#endif

void remesh(const Mesh& mesh, Hash& hash)
{
  const Mapped_mesh m(mesh);
  for(const SP::Sphere_domain_3& domain : {SP::Sphere_domain_3::octahedron(16), SP::Sphere_domain_3::icosahedron(9)})
  {
    Mesh result;
    const Sphere sphere = sphere_of(result);
    check(SP::remesh_through_sphere(m.mesh, m.sphere, domain, result, sphere));
    hash.add(result, result.points());
    hash.add(result, sphere);
    SP::Surface_distance distance;
    check(SP::measure_distance(m.mesh, result, distance));
    for(const auto& d : {distance.from_first, distance.from_second})
      hash.add(std::array<double, 2>{d.root_mean_square, d.maximum});
    hash.add(distance.psnr());
  }
}

void transfer(const Mesh& mesh, Hash& hash)
{
  Mapped_mesh m(mesh);
  const SP::Sphere_domain_3 domain = SP::Sphere_domain_3::cube(12);
  Mesh target;
  const Sphere sphere = sphere_of(target);
  check(SP::remesh_through_sphere(m.mesh, m.sphere, domain, target, sphere));
  const auto height = m.mesh.add_property_map<Vertex, double>("v:height").first;
  const auto height_of_target = target.add_property_map<Vertex, double>("v:height").first;
  for(const Vertex v : m.mesh.vertices())
    height[v] = m.mesh.point(v).z();
  check(SP::transfer(m.mesh, m.sphere, target, sphere, std::pair(height, height_of_target)));
  for(const Vertex v : target.vertices())
    hash.add(height_of_target[v]);
}

void locate(const Mesh& mesh, Hash& hash)
{
  const Mapped_mesh m(mesh);
  const SP::Sphere_locator_3 locator(m.mesh, m.sphere);
  const SP::Sphere_domain_3 domain = SP::Sphere_domain_3::octahedron(8);
  for(const auto& p : domain.directions())
  {
    const auto location = locator.locate(Point_3(p.x(), p.y(), p.z()));
    hash.add(static_cast<std::uint64_t>(location.first));
    hash.add(location.second);
  }
}

void resample(const Mesh& mesh, Hash& hash)
{
  using Resampler = SP::Sphere_resampler_3<>;
  const Mapped_mesh m(mesh);
  Resampler::Points source, target;
  Resampler::Triangles triangles;
  std::vector<double> heights;
  for(const Vertex v : m.mesh.vertices())
  {
    source.push_back({m.sphere[v].x(), m.sphere[v].y(), m.sphere[v].z()});
    heights.push_back(m.mesh.point(v).y());
  }
  for(const auto f : m.mesh.faces())
  {
    triangles.push_back({});
    std::size_t k = 0;
    for(const Vertex v : vertices_around_face(m.mesh.halfedge(f), m.mesh))
      triangles.back()[k++] = v;
  }
  const SP::Sphere_domain_3 domain = SP::Sphere_domain_3::icosahedron(12);
  for(const auto& p : domain.directions())
    target.push_back({p.x(), p.y(), p.z()});
  for(const SP::Resampling_method method : {SP::Resampling_method::barycentric, SP::Resampling_method::adaptive})
  {
    Resampler resampler;
    resampler.method(method);
    resampler.areas(Resampler::vertex_areas(source, triangles), Resampler::vertex_areas(target, domain.triangles()));
    check(resampler.connect(source, triangles, target, domain.triangles()));
    std::vector<double> result;
    check(resampler.resample(heights, result));
    hash.add(result);
  }
}

void unfold(const Mesh& mesh, Hash& hash)
{
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
  const Mapped_mesh m(mesh);
  Mesh textured;
  const auto uv = textured.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  check(SP::compute_texture_coordinates(m.mesh, m.sphere, textured, uv, {0., 1., 0.}, {0., 0., 1.}));
  for(const auto h : textured.halfedges())
    hash.add(std::array<double, 2>{uv[h].x(), uv[h].y()});
  std::ostringstream out;
  check(SP::IO::write_OBJ(out, textured, uv));
  hash.add(out.str());
}

void expand(const Mesh& mesh, Hash& hash)
{
  const Mapped_mesh m(mesh);
  SP::Spherical_harmonics_3 harmonics;
  check(SP::expand_in_spherical_harmonics(m.mesh, m.sphere, 12, harmonics));
  const auto add_coefficients = [&] {
    for(std::size_t function = 0; function < harmonics.number_of_functions(); ++function)
      for(std::size_t degree = 0; degree <= harmonics.degree(); ++degree)
        for(std::ptrdiff_t k = 0; k <= 2 * static_cast<std::ptrdiff_t>(degree); ++k)
          hash.add(harmonics.coefficient(function, degree, k - static_cast<std::ptrdiff_t>(degree)));
  };
  add_coefficients();
  hash.add(harmonics.power_spectrum());
  hash.add(harmonics.fit.error_over_surface);
  Mesh smooth;
  const Sphere sphere = sphere_of(smooth);
  check(SP::reconstruct_from_spherical_harmonics(harmonics, SP::Sphere_domain_3::octahedron(12), smooth, sphere));
  hash.add(smooth, smooth.points());
  SP::Standard_position position;
  check(SP::move_to_standard_position(harmonics, position)); // rotates them
  add_coefficients();
  hash.add(position.semi_axes);
  std::ostringstream out;
  check(SP::IO::write_harmonics_table(out, harmonics));
  check(SP::IO::write_SPHARM_PDM(out, harmonics));
  hash.add(out.str());
}

void measure_folding(const Mesh& mesh, Hash& hash)
{
  const Mapped_mesh m(mesh);
  SP::Sulcal_measures measures;
  check(SP::compute_sulcal_measures(m.mesh, measures));
  for(const auto& values : {measures.curvature, measures.depth, measures.inflated_curvature})
    hash.add(values);
  CGAL::Aff_transformation_3<CGAL::Exact_predicates_inexact_constructions_kernel> rotation(CGAL::IDENTITY);
  check(SP::fit_rotation_to_surface(m.mesh, m.sphere, rotation));
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      hash.add(rotation.m(i, j));
}

void round_to_float(const Mesh& mesh, Hash& hash)
{
  Mapped_mesh m(mesh);
  const Sphere rounded = sphere_of(m.mesh, "v:rounded");
  check(SP::round_to_float(m.mesh, m.sphere, rounded));
  hash.add(m.mesh, rounded);
}

// Maps the surface onto another one, there and back again by their common refinement.
void map_onto(const Mesh& mesh, const Mesh& other, Hash& hash)
{
  Mapped_mesh first(mesh), second(other);
  const Sphere directions = sphere_of(first.mesh, "v:directions");
  SP::Surface_mapper_3<Mesh> mapper;
  check(SP::map_surface(first.mesh, first.sphere, second.mesh, second.sphere, mapper, directions));
  hash.add(first.mesh, directions);
  hash.add(std::array<double, 2>{mapper.report().energy, mapper.report().margin});
  SP::Surface_overlay_3<Mesh, Mesh> overlay;
  check(SP::overlay(first.mesh, directions, second.mesh, second.sphere, overlay));
  for(const auto& points : overlay.points)
    for(const auto& p : points)
      hash.add(Point_3(p.x(), p.y(), p.z()));
  for(const auto& triangle : overlay.triangles)
    hash.add(triangle);
  SP::Distortion_between distortion;
  check(SP::measure_distortion_between(overlay, distortion));
  for(const auto& measure : {distortion.isometric, distortion.area, distortion.angle, distortion.energy})
    hash.add(std::array<double, 3>{measure.maximum, measure.average_over_first, measure.average_over_second});
}

} // namespace

void add_operations(Hash_cases& cases)
{
  cases["remesh"] = &remesh;
  cases["transfer"] = &transfer;
  cases["locate"] = &locate;
  cases["resample"] = &resample;
  cases["unfold"] = &unfold;
  cases["expand"] = &expand;
  cases["measure-folding"] = &measure_folding;
  cases["round-to-float"] = &round_to_float;
  for(const char* name : {"body", "shared/triceratops_2832.off", "shared/shrec391_steer_4315.off"})
    cases[std::string("onto:") + name] = [name](const Mesh& mesh, Hash& hash) {
      const Mesh other = find_mesh(name);
      if(other.is_empty())
        throw std::runtime_error("the other surface is missing");
      map_onto(mesh, other, hash);
    };
#ifdef CGAL_EIGEN3_ENABLED
  const auto add = [&](const char* name, const auto& method) {
    cases[name] = [method](const Mesh& mesh, Hash& hash) { hash_other_method(mesh, hash, method); };
  };
  add("harmonic", SP::Harmonic_parameterizer_3<>());
  add("conformal", SP::Conformal_parameterizer_3<>());
  add("stereographic", SP::Stereographic_parameterizer_3<>());
  add("arap", SP::ARAP_parameterizer_3<>());
  add("areas", SP::Target_area_parameterizer_3<>());
  add("published", SP::Published_low_distortion_parameterizer_3<>());
#endif
}

} // namespace reproducibility
