// What samples a surface through its sphere, but for what works with the caller's meshes and number types.

#include <CGAL/Spherical_parameterization/Sampling/internal/sampling_impl.h>
