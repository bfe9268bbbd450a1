// The steps to prescribed areas, by the energies of the package. They take Eigen.

#include <CGAL/Spherical_parameterization/internal/areas/Area_descent.h>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(, Symmetric_Dirichlet_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(, Isometric_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(, Conformal_energy_3)
CGAL_SPHERICAL_PARAMETERIZATION_AREA_DESCENT(, Stretch_energy_3)

} // namespace CGAL::Spherical_parameterization::internal
