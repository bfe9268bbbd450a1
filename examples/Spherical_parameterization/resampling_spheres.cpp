// Resamples values from the vertices of a sphere to those of a coarser one, excluding a masked region.

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_resampler_3.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

using Resampler = SP::Sphere_resampler_3<>;

int main(int, char**)
{
  // For cortical surfaces, read the spheres from files; see read_GIFTI() and read_FreeSurfer_surface().
  const SP::Sphere_domain_3 fine = SP::Sphere_domain_3::icosahedron(64), coarse = SP::Sphere_domain_3::octahedron(40);
  const auto points_of = [](const SP::Sphere_domain_3& sphere) {
    Resampler::Points points;
    for(const auto& p : sphere.directions())
      points.push_back({p.x(), p.y(), p.z()});
    return points;
  };
  const Resampler::Points from = points_of(fine), to = points_of(coarse);

  std::vector<double> heights;
  std::vector<bool> mask;
  for(const auto& p : from)
  {
    heights.push_back(p[2]);
    mask.push_back(p[0] < 0.9);
  }

  // The weights can be reused for any number of values.
  Resampler resampler;
  resampler.method(SP::Resampling_method::adaptive).mask(mask);
  resampler.areas(Resampler::vertex_areas(from, fine.triangles()), Resampler::vertex_areas(to, coarse.triangles()));
  std::vector<double> result;
  SP::Error_code error = resampler.connect(from, fine.triangles(), to, coarse.triangles());
  if(error == SP::OK)
    error = resampler.resample(heights, result);
  if(error != SP::OK)
  {
    std::cerr << SP::get_error_message(error) << std::endl;
    return EXIT_FAILURE;
  }

  const std::vector<bool> has_value = resampler.has_value();
  std::cout << heights.size() << " to " << result.size() << " vertices, of which "
            << std::count(has_value.begin(), has_value.end(), false) << " get nothing" << std::endl;
  return EXIT_SUCCESS;
}
