// The steps to prescribed areas, by the energies of the package. They take Eigen.

#include <CGAL/Spherical_parameterization/internal/areas/area_descents_of_library.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENTS()

} // namespace CGAL::Spherical_parameterization::internal
