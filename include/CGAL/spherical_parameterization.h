// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_H

/// \file spherical_parameterization.h
/// Convenience header file that includes every public header of the package.

#if !defined(DOXYGEN_RUNNING) && __cplusplus < 201703L && !(_MSVC_LANG >= 201703L)
#error "Spherical_parameterization needs C++17: compile with -std=c++17 or newer."
#else

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Area_balancing_radius_3.h>
#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Bijective_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Conformal_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/Distortion_between.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Face_range_3.h>
#include <CGAL/Spherical_parameterization/Fixed_radius_3.h>
#include <CGAL/Spherical_parameterization/Harmonic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/IO/FreeSurfer.h>
#include <CGAL/Spherical_parameterization/IO/Surface_file.h>
#include <CGAL/Spherical_parameterization/IO/spherical_harmonics_files.h>
#include <CGAL/Spherical_parameterization/IO/write_OBJ.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Optimal_radius_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Precomputed_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Published_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Schnyder_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sphere_locator_3.h>
#include <CGAL/Spherical_parameterization/Sphere_resampler_3.h>
#include <CGAL/Spherical_parameterization/Spherical_harmonics_3.h>
#include <CGAL/Spherical_parameterization/Stereographic_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Surface_map_report.h>
#include <CGAL/Spherical_parameterization/Surface_mapper_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/Target_area_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Two_phase_radius_3.h>
#include <CGAL/Spherical_parameterization/align_spheres.h>
#include <CGAL/Spherical_parameterization/compute_texture_coordinates.h>
#include <CGAL/Spherical_parameterization/evaluate_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/expand_in_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/fill_holes.h>
#include <CGAL/Spherical_parameterization/find_defect.h>
#include <CGAL/Spherical_parameterization/find_handles.h>
#include <CGAL/Spherical_parameterization/fit_rotation_to_surface.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/map_surface.h>
#include <CGAL/Spherical_parameterization/measure_distance.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/measure_distortion_between.h>
#include <CGAL/Spherical_parameterization/measure_folding.h>
#include <CGAL/Spherical_parameterization/move_to_standard_position.h>
#include <CGAL/Spherical_parameterization/overlay.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/reconstruct_from_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/remesh_through_sphere.h>
#include <CGAL/Spherical_parameterization/rotate_spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/round_to_float.h>
#include <CGAL/Spherical_parameterization/split_bent_faces.h>
#include <CGAL/Spherical_parameterization/split_blocking_edges.h>
#include <CGAL/Spherical_parameterization/transfer.h>

#endif // C++17

#endif // CGAL_SPHERICAL_PARAMETERIZATION_H
