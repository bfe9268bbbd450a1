// The methods that solve linear systems, by the default solver, Eigen's.

#include <CGAL/Spherical_parameterization/internal/initializers/initializers_of_library.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_INITIALIZERS()

} // namespace CGAL::Spherical_parameterization::internal
