// The descent by `Conformal_energy_3`.

#include <CGAL/Spherical_parameterization/internal/run/run_descent_impl.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(, Conformal_energy_3)

} // namespace CGAL::Spherical_parameterization::internal
