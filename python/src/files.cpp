#include "functions.h"

#include "../../program/read_file.h"

#include <CGAL/Spherical_parameterization/Harmonics/spherical_harmonics_files.h>

#include <algorithm>
#include <sstream>

namespace Module {

std::pair<Points, Indices> read_mesh(const std::string& path)
{
  Program::File_content soup;
  {
    const py::gil_scoped_release unlock;
    try
    {
      soup = Program::read_file_content(path);
    }
    catch(const Program::Program_error& error)
    {
      fail(SP::ERROR_INVALID_SURFACE_FILE, error.what());
    }
  }
  const auto is_polygon = [](const Program::Polygon& polygon) { return polygon.size() != 3; };
  const auto polygon = std::find_if(soup.polygons.begin(), soup.polygons.end(), is_polygon);
  if(polygon != soup.polygons.end())
  {
    const auto f = static_cast<std::size_t>(polygon - soup.polygons.begin());
    throw Error{{SP::ERROR_NON_TRIANGULAR_MESH,
                 Program::printable(path) + ": face " + std::to_string(f) + " is not a triangle but has " +
                     std::to_string(polygon->size()) + " corners (" +
                     std::to_string(std::count_if(polygon, soup.polygons.end(), is_polygon)) +
                     " such faces in total).\nTriangulate the mesh first; trimesh.load() does.\n"
                     "(Faces are counted from 0.)",
                 {},
                 {},
                 f}};
  }
  Points points = new_points(soup.points.size());
  double* row = points.mutable_data();
  for(const auto& p : soup.points)
    row = std::copy(p.cartesian_begin(), p.cartesian_end(), row);
  Indices faces({static_cast<py::ssize_t>(soup.polygons.size()), py::ssize_t(3)});
  std::int64_t* corner = faces.mutable_data();
  for(const Program::Polygon& triangle : soup.polygons)
    corner = std::copy(triangle.begin(), triangle.end(), corner);
  return {points, faces};
}

Values read_coefficients(const std::string& content, bool is_table, const std::string& normalization, bool has_phase)
{
  SP::Spherical_harmonics_3 harmonics;
  std::string message;
  std::istringstream in(content);
  const SP::Error_code error =
      is_table ? SP::IO::read_harmonics_table(in, harmonics, message) : SP::IO::read_SPHARM_PDM(in, harmonics, message);
  if(error != SP::OK)
    fail(error, message);
  harmonics.convert(normalization_of(normalization), has_phase);
  return array_of(harmonics);
}

py::bytes write_coefficients(const Values& coefficients, bool is_table, const std::string& normalization,
                             bool has_phase)
{
  const SP::Spherical_harmonics_3 harmonics = to_harmonics(coefficients, normalization, has_phase);
  std::ostringstream out;
  const SP::Error_code error =
      is_table ? SP::IO::write_harmonics_table(out, harmonics) : SP::IO::write_SPHARM_PDM(out, harmonics);
  if(error != SP::OK)
    fail(error, SP::get_error_message(error));
  return out.str();
}

} // namespace Module
