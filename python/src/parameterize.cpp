#include "Interruption.h"
#include "functions.h"
#include "threads.h"

#include <CGAL/Spherical_parameterization/Area_preserving_radius_3.h>
#include <CGAL/Spherical_parameterization/Conformal_energy_3.h>
#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/Fixed_radius_3.h>
#include <CGAL/Spherical_parameterization/Isometric_energy_3.h>
#include <CGAL/Spherical_parameterization/Precomputed_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Schnyder_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Sharpness.h>
#include <CGAL/Spherical_parameterization/Stretch_energy_3.h>
#include <CGAL/Spherical_parameterization/Target_area_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace Module {

namespace {

// Checks between two sweeps whether the run has to end.
class Python_visitor : public SP::Default_visitor
{
public:
  explicit Python_visitor(Interruption& interruption)
    : m_interruption(interruption)
  {}

  void on_level(std::size_t) { m_interruption.check_now_and_then(); }

  void after_iteration(std::size_t iteration, double energy, double radius)
  {
    m_interruption.call(iteration, energy, radius);
  }

  bool go_further(std::size_t, double)
  {
    m_interruption.check_now_and_then();
    return !m_interruption.is_stopped();
  }

  // Handles an interrupt after the last sweep.
  void on_optimization_end() { m_interruption.check(); }

private:
  Interruption& m_interruption;
};

SP::Sharpness find_sharpness(const std::string& prefer)
{
  if(prefer == "average")
    return SP::Sharpness::lowest_average();
  if(prefer == "worst")
    return SP::Sharpness::lowest_worst();
  if(prefer == "sampling")
    return SP::Sharpness::relative(3.);
  return SP::Sharpness::balanced();
}

py::dict to_dict(const SP::Parameterization_report& report)
{
  using namespace py::literals;
  return py::dict("number_of_vertices"_a = report.number_of_vertices, "number_of_faces"_a = report.number_of_faces,
                  "number_of_isolated_vertices"_a = report.number_of_isolated_vertices,
                  "number_of_flat_faces"_a = report.number_of_flat_faces, "radius"_a = report.radius,
                  "stop_reason"_a = SP::get_stop_message(report.stop_reason),
                  "number_of_levels"_a = report.number_of_levels, "used_last_resort"_a = report.used_last_resort,
                  "number_of_iterations"_a = report.number_of_iterations(), "initial_energy"_a = report.initial_energy,
                  "average_energy"_a = report.average_energy, "largest_energy"_a = report.largest_energy,
                  "seconds"_a = report.seconds());
}

// A number for each vertex or for each face, from an array.
template <class Index>
struct Number_map
{
  using key_type = Index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  friend double get(const Number_map& map, Index i) { return map.numbers[std::size_t(i)]; }

  const double* numbers;
};

py::dict to_dict(const SP::Area_report& report)
{
  using namespace py::literals;
  return py::dict("ratios"_a = Values(static_cast<py::ssize_t>(report.ratios.size()), report.ratios.data()),
                  "deviation"_a = report.deviation, "largest_deviation"_a = report.largest_deviation,
                  "number_of_off_vertices"_a = report.number_of_off_vertices,
                  "number_of_raised_faces"_a = report.number_of_raised_faces,
                  "number_of_steps"_a = report.number_of_steps, "is_reached"_a = report.is_reached());
}

template <class Parameterizer>
using Has_area_report = decltype(std::declval<Parameterizer&>().area_report());

} // namespace

py::tuple parameterize(const Points& vertices, const Indices& faces, const std::string& prefer,
                       const std::string& energy, const std::optional<Points>& initial, bool starts_from_drawing,
                       const std::optional<Values>& density, bool is_of_faces, std::size_t threads, double time_limit,
                       const py::object& callback, bool returns_on_interrupt)
{
  const std::size_t n = number_of_rows(vertices);
  Points sphere = new_points(n);
  double* const images = sphere.mutable_data();
  std::fill_n(images, 3 * n, std::numeric_limits<double>::quiet_NaN()); // vertices without a face
  SP::Parameterization_report report;
  std::optional<SP::Area_report> areas;
  Interruption interruption(callback, returns_on_interrupt);
  Python_visitor visitor(interruption);
  {
    const py::gil_scoped_release unlock;
    const Mesh mesh = make_mesh("", vertices, faces);
    const auto run = [&](auto parameterizer) {
      const SP::Error_code error = run_with_threads(threads, [&] {
        return SP::parameterize(mesh, parameterizer, Row_map<double>(images),
                                CGAL::parameters::visitor(std::ref(visitor)).maximum_running_time(time_limit));
      });
      report = parameterizer.report();
      if constexpr(SP::internal::is_detected<Has_area_report, decltype(parameterizer)>)
        areas = parameterizer.area_report();
      if(error == SP::OK)
        return;
      check_surface("", mesh);
      if(initial)
        check_map("", mesh, "initial", *initial);
      fail(error, SP::get_error_message(error));
    };
    const auto run_from_start = [&](const auto& bld) {
      if(initial)
        run(bld.initial_parameterizer(SP::Precomputed_parameterizer_3(rows_of(*initial))));
      else if(starts_from_drawing)
        run(bld.initial_parameterizer(SP::Schnyder_parameterizer_3()));
      else
        run(bld);
    };
    const auto run_for_areas = [&](const auto& energy_of_faces) {
#ifdef CGAL_EIGEN3_ENABLED
      const auto method = SP::Target_area_parameterizer_3<>().energy(energy_of_faces).sharpness(find_sharpness(prefer));
      if(density->size() == 0)
        run(method);
      else if(is_of_faces)
        run(method.target_density(Number_map<Face_index>{density->data()}));
      else
        run(method.target_density(Number_map<Vertex_index>{density->data()}));
#else
      static_cast<void>(energy_of_faces);
      static_cast<void>(is_of_faces);
      fail(SP::ERROR_WRONG_PARAMETER, "density needs Eigen, but this module was built without it");
#endif
    };
    // The defaults of the radius and the tolerance are those of the command line program.
    const auto bld = SP::Bijective_low_distortion_parameterizer_3<>().sharpness(find_sharpness(prefer));
    if(density)
    {
      if(energy == "isometric")
        run_for_areas(SP::Isometric_energy_3());
      else if(energy == "conformal")
        run_for_areas(SP::Conformal_energy_3());
      else if(energy == "stretch")
        run_for_areas(SP::Stretch_energy_3());
      else
        run_for_areas(SP::Symmetric_Dirichlet_energy_3());
    }
    else if(energy == "isometric")
      run_from_start(bld.energy(SP::Isometric_energy_3()));
    else if(energy == "conformal")
      run_from_start(bld.energy(SP::Conformal_energy_3()).radius(SP::Fixed_radius_3()));
    else if(energy == "stretch")
      run_from_start(bld.energy(SP::Stretch_energy_3()).radius(SP::Area_preserving_radius_3()).tolerances(3e-3, 2e-3));
    else
      run_from_start(bld);
  }
  return py::make_tuple(sphere, to_dict(report), areas ? py::object(to_dict(*areas)) : py::object(py::none()));
}

} // namespace Module
