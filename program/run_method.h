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

/// What a method has told of its run.
struct Run_result
{
  SP::Parameterization_report report;
  std::vector<std::array<double, 3>> history;        ///< iteration, energy and radius of each sweep or global step
  bool is_one_to_one = false;                        ///< certified
  std::shared_ptr<const SP::Area_report> areas = {}; ///< if areas were wanted
};

/// maps the mesh to a sphere by the method that the options name.
Run_result run_method(const Options& options, Input_mesh& input, const Sphere_map& sphere);

/// does so by the methods of lowest distortion, from the map that the options name or, if areas are wanted, to these.
Run_result run_descent(const Options& options, Input_mesh& input, const Sphere_map& sphere);
Run_result run_area_descent(const Options& options, Input_mesh& input, const Sphere_map& sphere);

} // namespace Program

#endif // PROGRAM_RUN_METHOD_H
