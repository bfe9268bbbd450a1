// A fuzzer for geometry images: the first byte says whether the others are a file in the format PNG or OpenEXR. Whatever they
// are, they are refused and nothing is added to the mesh, or they give a closed mesh whose file gives it back.

#include "Fuzzed_bytes.h"
#include "require.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spherical_parameterization/Sampling/EXR_geometry_image.h>
#include <CGAL/Spherical_parameterization/Sampling/PNG_geometry_image.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

namespace SP = CGAL::Spherical_parameterization;

namespace {

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

struct Format
{
  template <class Out>
  SP::Error_code write(Out& out, const Mesh& mesh) const
  {
    return is_png ? SP::IO::write_PNG_geometry_image(out, mesh, mesh.points())
                  : SP::IO::write_EXR_geometry_image(out, mesh, mesh.points());
  }
  SP::Error_code read(const std::string& file, Mesh& mesh) const
  {
    std::istringstream in(file);
    return is_png ? SP::IO::read_PNG_geometry_image(in, mesh) : SP::IO::read_EXR_geometry_image(in, mesh);
  }

  bool is_png;
};

// Whether meshes differ by no more than a format rounds coordinates: by half a code of PNG files, and not at all of others.
bool are_equal(const Mesh& a, const Mesh& b, const Format& format)
{
  double size = 0.;
  for(int i = 0; i < 3; ++i)
  {
    const auto less = [i](const Point_3& p, const Point_3& q) { return p[i] < q[i]; };
    const auto range = std::minmax_element(a.points().begin(), a.points().end(), less);
    // halves, as the whole may be infinite
    size = (std::max)({size, 0.5 * (*range.second)[i] - 0.5 * (*range.first)[i], std::abs((*range.first)[i]) * 1e-10,
                       std::abs((*range.second)[i]) * 1e-10});
  }
  const double tolerance = format.is_png ? 1.01 / 65535. * size : 0.;
  for(const Mesh::Vertex_index v : a.vertices())
    for(int i = 0; i < 3; ++i)
      if(!(std::abs(0.5 * a.point(v)[i] - 0.5 * b.point(v)[i]) <= 0.5 * tolerance))
        return false;
  return a.number_of_vertices() == b.number_of_vertices() && a.number_of_faces() == b.number_of_faces();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Fuzzed_bytes bytes(data, size);
  const Format format = {bytes.below(2) == 0};
  Mesh mesh;
  const SP::Error_code error = format.read(bytes.rest(), mesh);
  if(error != SP::OK)
  {
    require(error == SP::ERROR_INVALID_IMAGE_FILE || error == SP::ERROR_INVALID_IMAGE_SIZE ||
                error == SP::ERROR_NON_FINITE_COORDINATE || error == SP::ERROR_NON_MATCHING_BOUNDARY,
            SP::get_error_message(error));
    require(mesh.number_of_vertices() == 0, "something has been added");
    return 0;
  }
  require(CGAL::is_closed(mesh) && CGAL::is_triangle_mesh(mesh) &&
              mesh.number_of_faces() + 4 == 2 * mesh.number_of_vertices(),
          "the mesh is not closed");
  std::stringstream file;
  Mesh again;
  const SP::Error_code written = format.write(file, mesh);
  if(written == SP::ERROR_OUT_OF_FLOAT_RANGE && !format.is_png) // None of the numbers has all its digits.
    return 0;
  require(written == SP::OK, "what was read cannot be written");
  require(format.read(file.str(), again) == SP::OK && are_equal(mesh, again, format), "the file gives another mesh");
  return 0;
}
