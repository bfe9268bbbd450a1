// The descents by the energies of the package: together, as what does not depend on the energy is compiled once.

#include <CGAL/Spherical_parameterization/internal/run/run_descent_impl.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS()

} // namespace CGAL::Spherical_parameterization::internal
