// Spherical harmonics of surfaces and their file formats.

#include <CGAL/Spherical_parameterization/Harmonics/internal/harmonics_impl.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/spherical_harmonics_files_impl.h>
