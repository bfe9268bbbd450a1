// Code that solves linear systems with an elimination order from Eigen: the steps to prescribed areas for the energies
// of the package, and the methods without a descent for the default solver.

#include <CGAL/Spherical_parameterization/internal/areas/Area_descent.h>
#include <CGAL/Spherical_parameterization/internal/initializers/ARAP_map.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Harmonic_map.h>
#include <CGAL/Spherical_parameterization/internal/initializers/Stereographic_embedding.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(, Symmetric_Dirichlet_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(, Isometric_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(, Conformal_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(, Stretch_energy_3)

template Error_code embed_stereographically<Default>(Run&, bool);
template Error_code map_harmonically<Default>(Run&, bool, std::size_t);
template Error_code lower_energy<Default>(ARAP_map, std::size_t, Run&);

} // namespace CGAL::Spherical_parameterization::internal
