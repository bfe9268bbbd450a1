// The default method in its three settings, and what else the core has: everything between the reading of a mesh and the
// certificate of its map.

#include "Hash_case.h"

#include <CGAL/spherical_parameterization.h>

namespace reproducibility {

namespace {

template <class Parameterizer>
void hash_map(const Mesh& mesh, Hash& hash, const Parameterizer& method)
{
  Mesh copy = mesh;
  const Sphere sphere = sphere_of(copy);
  Parameterizer parameterizer = method;
  check(SP::parameterize(copy, parameterizer, sphere));
  hash.add(copy, sphere);
  hash.add(parameterizer.report().radius);
  SP::Distortion_summary distortion;
  check(SP::measure_distortion(copy, sphere, distortion));
  for(const auto& measure : {distortion.isometric, distortion.area, distortion.angle})
    hash.add(std::array<double, 3>{measure.average, measure.maximum, measure.deviation});
  hash.add(distortion.balanced_radius);
}

} // namespace

void add_spheres(Hash_cases& cases)
{
  using Method = SP::Bijective_low_distortion_parameterizer_3<>;
  const auto add = [&](const char* name, const auto& method) {
    cases[name] = [method](const Mesh& mesh, Hash& hash) { hash_map(mesh, hash, method); };
  };
  add("default", Method());
  add("average", Method().sharpness(SP::Sharpness::lowest_average()));
  add("worst", Method().sharpness(SP::Sharpness::lowest_worst()));
  add("isometric", Method().energy(SP::Isometric_energy_3()).radius(SP::Two_phase_radius_3<>()));
  add("conformal-energy", Method().energy(SP::Conformal_energy_3()).radius(SP::Fixed_radius_3()));
  add("sampling", Method()
                      .energy(SP::Stretch_energy_3())
                      .radius(SP::Area_preserving_radius_3())
                      .sharpness(SP::Sharpness::relative(3.)));
  add("balanced-radius", Method().radius(SP::Area_balancing_radius_3()));
  add("schedule", Method().sharpness(SP::Sharpness::schedule(0.1, 10.)));
  add("hierarchical", SP::Hierarchical_parameterizer_3<>());
  add("schnyder", SP::Schnyder_parameterizer_3());
}

} // namespace reproducibility
