// The descents for the energies of the package. They share a file so that code independent of the energy is compiled once.

#include <CGAL/Spherical_parameterization/internal/run/run_descent_impl.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS()

} // namespace CGAL::Spherical_parameterization::internal
