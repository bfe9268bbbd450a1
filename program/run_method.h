#ifndef PROGRAM_RUN_METHOD_H
#define PROGRAM_RUN_METHOD_H

#include "Input_mesh.h"
#include "Options.h"

#include <CGAL/Spherical_parameterization/Parameterization_report.h>

#include <array>
#include <memory>

namespace CGAL::Spherical_parameterization {
struct Area_report;
} // namespace CGAL::Spherical_parameterization

namespace Program {

/// The result of a method.
struct Run_result
{
  SP::Parameterization_report report;
  std::vector<std::array<double, 3>> history;        ///< iteration, energy and radius of each sweep or global step
  bool is_one_to_one = false;                        ///< certified
  std::shared_ptr<const SP::Area_report> areas = {}; ///< for prescribed areas
};

/// maps the mesh to a sphere by the method in the options.
Run_result run_method(const Options& options, Input_mesh& input, const Sphere_map& sphere);

/// maps the mesh by the low-distortion methods: from the initial map in the options, or to prescribed areas.
Run_result run_descent(const Options& options, Input_mesh& input, const Sphere_map& sphere);
Run_result run_area_descent(const Options& options, Input_mesh& input, const Sphere_map& sphere);

} // namespace Program

#endif // PROGRAM_RUN_METHOD_H
