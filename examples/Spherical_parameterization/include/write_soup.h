#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SOUP_H

#include "Polygon_soup.h"
#include "Program_error.h"
#include "mesh_files.h"

#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
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
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace Program {

/// writes a file of a cortical surface, or of values of vertices if it has no points.
///
/// \throws Program_error if the format cannot hold it, or the program was built without what it takes
///
/// \param n_triangles of the surface, which files of values of FreeSurfer tell
inline void write_surface_file(std::ostream& out, const std::string& format, const SP::IO::Surface_file& file,
                               std::size_t n_triangles = 0)
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

/// returns what is told of a surface that is made of another one.
///
/// \param is_sphere whether that is its image on the sphere
inline SP::IO::Surface_origin inherited(SP::IO::Surface_origin origin, bool is_sphere)
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

/// writes a mesh in one of the output formats. Coordinates do not change if they are read again, unless the format has short numbers.
///
/// To a stream, since a stream tells whether the last byte has been written.
///
/// \param origin what files of cortical surfaces tell beside the mesh
///
/// \throws Program_error if the format cannot hold the mesh, or the program was built without what it takes
inline void write_soup(std::ostream& out, const std::string& format, const std::vector<Point_3>& points,
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
    SP::IO::Surface_file file;
    for(const Point_3& p : points)
      file.points.push_back({{p.x(), p.y(), p.z()}});
    for(const Polygon& polygon : polygons)
      file.triangles.push_back({{static_cast<std::uint32_t>(polygon[0]), static_cast<std::uint32_t>(polygon[1]),
                                 static_cast<std::uint32_t>(polygon[2])}});
    file.origin = origin;
    write_surface_file(out, format, file);
  }
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_WRITE_SOUP_H
