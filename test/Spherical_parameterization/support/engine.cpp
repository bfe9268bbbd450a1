#include "engine.h"

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {
CGAL_SPHERICAL_PARAMETERIZATION_TEST_ENGINE()
} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL
