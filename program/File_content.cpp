#include "File_content.h"

#include <algorithm>

namespace Program {

SP::IO::Surface_file surface_file_of(const std::vector<Point_3>& points, const std::vector<Polygon>& triangles)
{
  SP::IO::Surface_file file;
  file.points.reserve(points.size());
  for(const Point_3& p : points)
    file.points.push_back({{p.x(), p.y(), p.z()}});
  file.triangles.resize(triangles.size());
  for(std::size_t f = 0; f < triangles.size(); ++f)
    std::transform(triangles[f].begin(), triangles[f].end(), file.triangles[f].begin(),
                   [](std::size_t v) { return static_cast<std::uint32_t>(v); });
  return file;
}

File_content content_of(const SP::IO::Surface_file& file)
{
  File_content content;
  content.points.reserve(file.points.size());
  for(const auto& p : file.points)
    content.points.emplace_back(p[0], p[1], p[2]);
  content.polygons.reserve(file.triangles.size());
  for(const auto& t : file.triangles)
    content.polygons.emplace_back(t.begin(), t.end());
  return content;
}

} // namespace Program
