// The methods that solve linear systems, by the default solver, Eigen's.

#include <CGAL/Spherical_parameterization/internal/initializers/ARAP_map.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Harmonic_map.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Stereographic_embedding.h>

namespace CGAL::Spherical_parameterization::internal {

template Error_code embed_stereographically<Default>(Run&, bool);
template Error_code map_harmonically<Default>(Run&, bool, std::size_t);
template Error_code lower_energy<Default>(ARAP_map, std::size_t, Run&);

} // namespace CGAL::Spherical_parameterization::internal
