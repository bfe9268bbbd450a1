#include "engine.h"

namespace CGAL::Spherical_parameterization::internal {
CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS_BY(, test::Hooked_energy)
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_HEADER_ONLY
CGAL_SPHERICAL_PARAMETERIZATION_DESCENTS()
#endif
} // namespace CGAL::Spherical_parameterization::internal
