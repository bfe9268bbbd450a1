// The core of the package, except for the descents.

#include <CGAL/Spherical_parameterization/internal/certificate/Orientation_about_origin_3_impl.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel_impl.h>
#include <CGAL/Spherical_parameterization/internal/run/first_map_impl.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface_impl.h>
