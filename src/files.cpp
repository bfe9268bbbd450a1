// Files of the parts that need no further library.

#include <CGAL/Spherical_parameterization/Cortex/internal/FreeSurfer_impl.h>
#include <CGAL/Spherical_parameterization/Harmonics/internal/spherical_harmonics_files_impl.h>
