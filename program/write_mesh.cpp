#include "write_mesh.h"

#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#ifdef PROGRAM_READS_GIFTI
#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#endif
#ifdef PROGRAM_READS_MGH
#include <CGAL/Spherical_parameterization/Cortex/MGH.h>
#endif

#include <CGAL/IO/GOCAD.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/io.h>

#include <algorithm>
#include <cstdint>

namespace Program {

void write_surface_file(std::ostream& out, const std::string& format, const SP::IO::Surface_file& file,
                        std::size_t n_triangles)
{
  SP::Error_code error = SP::OK;
  if(format == freesurfer_format)
    error = file.points.empty() ? SP::IO::write_FreeSurfer_curv(out, file.columns.at(0), n_triangles)
                                : SP::IO::write_FreeSurfer_surface(out, file);
  else if(format == ".annot")
    error = SP::IO::write_FreeSurfer_annotation(out, file);
  else if(format == ".mgh" || format == ".mgz")
#ifdef PROGRAM_READS_MGH
    error = SP::IO::write_MGH(out, file, format == ".mgz");
#else
    throw Program_error("this program was built without zlib, which MGH files take");
#endif
#ifdef PROGRAM_READS_GIFTI
  else
    error = SP::IO::write_GIFTI(out, file, format == ".gii.gz");
#else
  else
    throw Program_error("this program was built without expat and zlib, which GIFTI files take");
#endif
  if(error != SP::OK && error != SP::ERROR_CANNOT_WRITE_FILE) // of which the stream tells
    throw Program_error(SP::get_error_message(error));
}

SP::IO::Surface_origin inherited(SP::IO::Surface_origin origin, bool is_sphere)
{
  origin.created_by.clear();
  const auto remove = [](SP::IO::Metadata& metadata, const std::string& name) {
    const auto is_it = [&](const auto& pair) { return pair.first == name; };
    metadata.erase(std::remove_if(metadata.begin(), metadata.end(), is_it), metadata.end());
  };
  const auto set = [&](const std::string& name, const std::string& value) {
    remove(origin.metadata_of_points, name);
    origin.metadata_of_points.emplace_back(name, value);
  };
  for(SP::IO::Metadata* metadata : {&origin.metadata, &origin.metadata_of_points, &origin.metadata_of_triangles})
    remove(*metadata, "UniqueID"); // it is that of the other one
  set("TopologicalType", "Closed");
  if(is_sphere)
  {
    remove(origin.metadata_of_points, "AnatomicalStructureSecondary"); // which layer it is
    set("GeometricType", "Spherical");
  }
  return origin;
}

void write_mesh(std::ostream& out, const std::string& format, const std::vector<Point_3>& points,
                const std::vector<Polygon>& polygons, const SP::IO::Surface_origin& origin)
{
  constexpr int digits = 17;
  const auto np = CGAL::parameters::stream_precision(digits);
  out.precision(digits);
  if(format == ".off")
    CGAL::IO::write_OFF(out, points, polygons, np);
  else if(format == ".obj")
    CGAL::IO::write_OBJ(out, points, polygons, np);
  else if(format == ".ts")
    CGAL::IO::write_GOCAD(out, points, polygons, np);
  else if(format == ".ply")
  {
    CGAL::IO::set_binary_mode(out);
    CGAL::IO::write_PLY(out, points, polygons, np);
  }
  else
  {
    SP::IO::Surface_file file = surface_file_of(points, polygons);
    file.origin = origin;
    write_surface_file(out, format, file);
  }
}
} // namespace Program
