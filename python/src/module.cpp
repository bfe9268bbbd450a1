#include "functions.h"

#include <CGAL/Spherical_parameterization/Error_code.h>

#include <exception>

namespace {

using namespace Module;

void raise(const SP::internal::Soup_defect& defect)
{
  const py::object type = py::module_::import("spherical_parameterization._errors").attr("Error");
  const py::object value = type(defect.message, defect.error, defect.vertex, defect.other_vertex, defect.face);
  PyErr_SetObject(type.ptr(), value.ptr());
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  // The codes that arrays, files and the default method can cause.
  py::enum_<SP::Error_code>(module, "ErrorCode", "Kind of an `Error`.")
      .value("EMPTY_MESH", SP::ERROR_EMPTY_MESH, "The mesh has no face.")
      .value("TOO_FEW_VERTICES", SP::ERROR_TOO_FEW_VERTICES, "Fewer than four vertices have a face.")
      .value("NON_TRIANGULAR_MESH", SP::ERROR_NON_TRIANGULAR_MESH, "A face is not a triangle.")
      .value("NON_CLOSED_MESH", SP::ERROR_NON_CLOSED_MESH, "The mesh has a border.")
      .value("SEVERAL_COMPONENTS", SP::ERROR_SEVERAL_COMPONENTS, "The mesh has several connected components.")
      .value("NO_TOPOLOGICAL_SPHERE", SP::ERROR_NO_TOPOLOGICAL_SPHERE, "The genus of the mesh is not 0.")
      .value("NO_SIMPLICIAL_COMPLEX", SP::ERROR_NO_SIMPLICIAL_COMPLEX,
             "Two edges join the same two vertices, or two fans of faces meet in a vertex.")
      .value("NON_FINITE_COORDINATE", SP::ERROR_NON_FINITE_COORDINATE, "A coordinate is infinite or not a number.")
      .value("INVALID_INITIAL_PARAMETERIZATION", SP::ERROR_INVALID_INITIAL_PARAMETERIZATION,
             "The initial map is not bijective, or not by a sufficient margin.")
      .value("NO_1_TO_1_MAPPING", SP::ERROR_NO_1_TO_1_MAPPING, "A map is not bijective.")
      .value("INSUFFICIENT_PRECISION", SP::ERROR_INSUFFICIENT_PRECISION,
             "No bijective map was found within the precision of the coordinates.")
      .value("WRONG_PARAMETER", SP::ERROR_WRONG_PARAMETER, "A parameter is out of range.")
      .value("TOO_LARGE_MESH", SP::ERROR_TOO_LARGE_MESH, "The mesh has 2**31 - 1 halfedges or more.")
      .value("TOO_LARGE_OVERLAY", SP::ERROR_TOO_LARGE_OVERLAY,
             "The common refinement of two surfaces has too many vertices.")
      .value("INVALID_DIRECTION", SP::ERROR_INVALID_DIRECTION, "A direction is zero or not finite.")
      .value("INVALID_SURFACE_FILE", SP::ERROR_INVALID_SURFACE_FILE,
             "A file is damaged, or does not contain a surface.")
      .value("INVALID_HARMONICS_FILE", SP::ERROR_INVALID_HARMONICS_FILE,
             "A file is damaged, or does not contain coefficients of spherical harmonics.")
      .value("UNDETERMINED_ROTATION", SP::ERROR_UNDETERMINED_ROTATION,
             "The axes of an ellipsoid do not determine a rotation.")
      .value("TOO_HIGH_DEGREE", SP::ERROR_TOO_HIGH_DEGREE,
             "An expansion has more coefficients than there are vertices.")
      .value("INVALID_DENSITY", SP::ERROR_INVALID_DENSITY,
             "A density is negative, infinite or not a number, or all are 0.")
      .value("INVALID_LANDMARK", SP::ERROR_INVALID_LANDMARK,
             "A landmark is not a vertex of a face, or a vertex has two landmarks.")
      .value("STOPPED", SP::ERROR_STOPPED, "The run was stopped before there was a result.");

  py::register_exception_translator([](std::exception_ptr pointer) {
    try
    {
      std::rethrow_exception(pointer);
    }
    catch(const Error& error)
    {
      raise(error.defect);
    }
  });

  module.attr("__version__") = SPHERICAL_PARAMETERIZATION_VERSION;
  module.def("parameterize", &parameterize);
  module.def("fill_holes", &fill_holes);
  module.def("repair_surface", &repair_surface);
  module.def("find_handles", &find_handles);
  module.def("find_defect", &find_defect);
  module.def("is_bijective", &is_bijective);
  module.def("round_to_float", &round_to_float);
  module.def("compute_sulcal_measures", &compute_sulcal_measures);
  module.def("measure_distortion", &measure_distortion);
  module.def("measure_distance", &measure_distance);
  module.def("remesh", &remesh);
  module.def("remesh_with", &remesh_with);
  module.def("transfer", &transfer);
  module.def("resample", &resample);
  module.def("resample_sphere", &resample_sphere);
  module.def("expand", &expand);
  module.def("evaluate_harmonics", &evaluate_harmonics);
  module.def("make_domain", &make_domain);
  module.def("standard_position", &standard_position);
  module.def("read_mesh", &read_mesh);
  module.def("read_coefficients", &read_coefficients);
  module.def("write_coefficients", &write_coefficients);
  module.def("map_surface", &map_surface);
  module.def("align_spheres", &align_spheres);
  module.def("overlay", &overlay);
  module.def("measure_distortion_between", &measure_distortion_between);
  define_locator(module);
}
