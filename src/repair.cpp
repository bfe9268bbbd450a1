// The repair of surfaces, but for what works with the caller's meshes.

#include <CGAL/Spherical_parameterization/Repair/internal/fill_holes_impl.h>
#include <CGAL/Spherical_parameterization/Repair/internal/find_handles_impl.h>
#include <CGAL/Spherical_parameterization/Repair/internal/repair_surface_impl.h>
