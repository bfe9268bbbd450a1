// The repair of surfaces, except for code that depends on the caller's mesh types.

#include <CGAL/Spherical_parameterization/Repair/internal/fill_holes_impl.h>
#include <CGAL/Spherical_parameterization/Repair/internal/find_handles_impl.h>
#include <CGAL/Spherical_parameterization/Repair/internal/repair_surface_impl.h>
