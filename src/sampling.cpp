// Sampling of surfaces through spheres, except for code that depends on the caller's mesh and number types.

#include <CGAL/Spherical_parameterization/Sampling/internal/sampling_impl.h>
