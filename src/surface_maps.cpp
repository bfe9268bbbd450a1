// Maps between surfaces, except for code that depends on the caller's types.

#include <CGAL/Spherical_parameterization/Surface_maps/internal/find_surface_map_impl.h>
#include <CGAL/Spherical_parameterization/Surface_maps/internal/overlay/overlay_surfaces_impl.h>
