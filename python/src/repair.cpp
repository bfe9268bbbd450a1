#include "functions.h"

#include <CGAL/Spherical_parameterization/Repair/fill_holes.h>
#include <CGAL/Spherical_parameterization/Repair/find_handles.h>
#include <CGAL/Spherical_parameterization/Repair/repair_surface.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstdint>

namespace Module {

py::tuple fill_holes(const Points& vertices, const Indices& faces, std::size_t max_edges)
{
  std::vector<SP::Filled_hole<Mesh>> holes;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Point_3> new_points;
  {
    const py::gil_scoped_release unlock;
    Mesh mesh = make_mesh("", vertices, faces);
    check_points("", mesh, "vertices", vertices); // before the mesh has vertices without rows
    const std::size_t n_vertices = mesh.number_of_vertices(), n_faces = mesh.number_of_faces();
    const SP::Error_code error = SP::fill_holes(mesh, holes, CGAL::parameters::maximum_number(max_edges));
    if(error == SP::ERROR_NO_SIMPLICIAL_COMPLEX)
      throw Error{{error,
                   "the border touches itself in vertex " + std::to_string(holes.back().vertex) +
                       ", so that its holes are ambiguous.\nGive each part of the border its own copy of this vertex. "
                       "(Vertices are counted from 0.)",
                   std::size_t(holes.back().vertex),
                   {},
                   {}}};
    for(const Face_index f : mesh.faces())
      if(f.idx() >= n_faces)
      {
        triangles.emplace_back();
        std::size_t k = 0;
        for(const Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
          triangles.back()[k++] = v;
      }
    for(const Vertex_index v : mesh.vertices())
      if(v.idx() >= n_vertices)
        new_points.push_back(mesh.point(v));
  }
  Points points({static_cast<py::ssize_t>(new_points.size()), py::ssize_t(3)});
  double* row = points.mutable_data();
  for(const Point_3& p : new_points)
    row = std::copy(p.cartesian_begin(), p.cartesian_end(), row);
  py::list list;
  for(const auto& hole : holes)
    list.append(
        py::make_tuple(std::size_t(hole.vertex), hole.number_of_edges, hole.perimeter, hole.faces.size(), hole.share));
  return py::make_tuple(points, to_array(triangles), list);
}

py::tuple repair_surface(const Points& vertices, const Corners& corners, const Corners& first, double maximum_hole,
                         double maximum_handle, double maximum_added_area, bool refines_patches)
{
  SP::Repaired_surface<Point_3> repaired;
  SP::Repair_report report;
  SP::Error_code error = SP::OK;
  {
    const py::gil_scoped_release unlock;
    const Const_row_map rows = rows_of(vertices);
    std::vector<Point_3> points;
    for(std::size_t v = 0; v < number_of_rows(vertices); ++v)
      points.push_back(get(rows, Vertex_index(static_cast<Mesh::size_type>(v))));
    std::vector<std::vector<std::int64_t>> polygons;
    for(py::ssize_t f = 0; f + 1 < first.size(); ++f)
      polygons.emplace_back(corners.data() + first.data()[f], corners.data() + first.data()[f + 1]);
    error = SP::repair_surface(points, polygons, repaired, report,
                               {maximum_hole, maximum_handle, maximum_added_area, refines_patches});
  }
  if(error != SP::OK)
    fail(error, report.message);
  Points new_points({static_cast<py::ssize_t>(repaired.points.size()), py::ssize_t(3)});
  double* row = new_points.mutable_data();
  for(const Point_3& p : repaired.points)
    row = std::copy(p.cartesian_begin(), p.cartesian_end(), row);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for(const auto& [a, b, c] : repaired.triangles)
    triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  const auto sources = [](const std::vector<std::size_t>& all) {
    Corners result(static_cast<py::ssize_t>(all.size()));
    std::transform(all.begin(), all.end(), result.mutable_data(), [](std::size_t i) {
      return i == SP::Repaired_surface<Point_3>::none ? std::int64_t(-1) : static_cast<std::int64_t>(i);
    });
    return result;
  };
  py::list patches, counts, cycles;
  for(const std::vector<std::size_t>& cycle : report.handle_cycles)
    cycles.append(sources(cycle));
  for(const SP::Repair_patch& patch : report.patches)
    patches.append(py::make_tuple(patch.is_of_handle, patch.vertex, patch.number_of_edges, patch.length, patch.share));
  for(const SP::Repair_count& count : {report.triangulated_polygons, report.degenerate_faces, report.repeated_faces,
                                       report.merged_vertices, report.reversed_faces, report.non_manifold_edges,
                                       report.divided_vertices, report.removed_faces, report.split_edges})
    counts.append(count.number);
  return py::make_tuple(new_points, to_array(triangles), sources(repaired.source_vertices),
                        sources(repaired.source_faces), counts, report.number_of_components, cycles, patches,
                        report.added_area);
}

py::list find_handles(const Points& vertices, const Indices& faces, std::size_t max_handles)
{
  std::vector<SP::Handle<Mesh>> handles;
  {
    const py::gil_scoped_release unlock;
    const Mesh mesh = make_mesh("", vertices, faces);
    const SP::Error_code error = SP::find_handles(
        mesh, handles, CGAL::parameters::vertex_point_map(rows_of(vertices)).maximum_number(max_handles));
    if(error != SP::OK)
    {
      check_surface("", mesh);
      fail(error, SP::get_error_message(error));
    }
  }
  py::list result;
  for(const auto& handle : handles)
  {
    py::array_t<std::int64_t> path(static_cast<py::ssize_t>(handle.path.size()));
    std::transform(handle.path.begin(), handle.path.end(), path.mutable_data(),
                   [](Vertex_index v) { return static_cast<std::int64_t>(v.idx()); });
    result.append(py::make_tuple(path, handle.length));
  }
  return result;
}

} // namespace Module
