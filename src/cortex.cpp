// Cortical surfaces and their file formats.

#include <CGAL/Spherical_parameterization/Cortex/internal/FreeSurfer_impl.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/sulcal_measures_impl.h>
