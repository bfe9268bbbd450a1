// The descent by `Isometric_energy_3`, that of the paper as well.

#include <CGAL/Spherical_parameterization/internal/run/run_descent_impl.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(, Isometric_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_DESCENT(, Isometric_energy_3, Gradient_step)

} // namespace CGAL::Spherical_parameterization::internal
