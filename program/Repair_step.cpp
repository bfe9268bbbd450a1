#include "Repair_step.h"

#include <CGAL/Spherical_parameterization/internal/files/Soup_defect.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Program {

namespace {

using Neighbors = std::vector<std::vector<std::size_t>>;

// Replaces unknown values by those of neighbours, the nearest first: by one of them, or by their mean.
void spread(const std::vector<std::size_t>& sources, const Neighbors& neighbors, bool averages,
            std::vector<double>& values)
{
  std::vector<char> is_known(values.size()), is_reached(values.size());
  std::vector<std::size_t> order;
  const auto reach = [&](std::size_t i) {
    if(is_reached[i])
      return;
    is_reached[i] = 1;
    order.push_back(i);
  };
  for(std::size_t i = 0; i < values.size(); ++i)
    is_known[i] = is_reached[i] = sources[i] != Repair_step::none;
  for(std::size_t i = 0; i < values.size(); ++i)
    if(!is_known[i] &&
       std::any_of(neighbors[i].begin(), neighbors[i].end(), [&](std::size_t j) { return is_known[j]; }))
      reach(i);
  for(std::size_t k = 0; k < order.size(); ++k)
  {
    const std::size_t i = order[k];
    double sum = 0.;
    std::size_t n = 0;
    for(const std::size_t j : neighbors[i])
      if(is_known[j] && (averages || n == 0))
      {
        sum += values[j];
        ++n;
      }
    values[i] = sum / static_cast<double>(n);
    is_known[i] = 1;
    for(const std::size_t j : neighbors[i])
      reach(j);
  }
  constexpr int sweeps = 100;
  for(int sweep = 0; sweep < sweeps && averages; ++sweep)
    for(const std::size_t i : order)
    {
      double sum = 0.;
      for(const std::size_t j : neighbors[i])
        sum += values[j];
      values[i] = sum / static_cast<double>(neighbors[i].size());
    }
}

// The neighbors of vertices without a source.
Neighbors neighbors_of_vertices(const std::vector<std::size_t>& sources, const std::vector<Polygon>& triangles)
{
  Neighbors result(sources.size());
  for(const Polygon& triangle : triangles)
    SP::internal::for_each_side(triangle,
                                [&](std::size_t v, std::size_t w) { // each edge of a closed surface in both directions
                                  if(sources[v] == Repair_step::none)
                                    result[v].push_back(w);
                                });
  return result;
}

// The neighbors of faces without a source.
Neighbors neighbors_of_faces(const std::vector<std::size_t>& sources, const std::vector<Polygon>& triangles)
{
  std::vector<std::array<std::size_t, 3>> sides; // both vertices of an edge, and a face
  for(std::size_t f = 0; f < triangles.size(); ++f)
    SP::internal::for_each_side(triangles[f], [&](std::size_t v, std::size_t w) {
      sides.push_back({(std::min)(v, w), (std::max)(v, w), f});
    });
  std::sort(sides.begin(), sides.end());
  Neighbors result(sources.size());
  for(std::size_t k = 0; k + 1 < sides.size(); k += 2)
    for(const auto& [f, g] : {std::pair(sides[k][2], sides[k + 1][2]), std::pair(sides[k + 1][2], sides[k][2])})
      if(sources[f] == Repair_step::none)
        result[f].push_back(g);
  return result;
}

std::vector<double> transferred(const std::vector<double>& numbers, const std::vector<std::size_t>& sources)
{
  std::vector<double> result;
  result.reserve(sources.size());
  for(const std::size_t source : sources)
    result.push_back(source == Repair_step::none ? 0. : numbers[source]);
  return result;
}

std::string percent(double fraction)
{
  return fixed_text(100. * fraction, 2) + " %";
}

} // namespace

Repair_step::Repair_step(const Repair_settings& settings, File_content& surface)
{
  if(settings.alpha > 0.)
  {
    for(const Polygon& polygon : surface.polygons)
      for(const std::size_t v : polygon)
        if(const Point_3& p = surface.points[v];
           !std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
          throw Program_error("vertex ", v, " has a coordinate that is infinite or not a number");
    File_content wrapping = wrapping_of(surface, settings.alpha);
    m_number_of_wrapping_faces = wrapping.polygons.size();
    std::swap(surface.points, wrapping.points);
    std::swap(surface.polygons, wrapping.polygons);
  }
  SP::Repaired_surface<Point_3> repaired;
  if(const SP::Error_code error =
         SP::repair_surface(surface.points, surface.polygons, repaired, m_report, settings.limits);
     error != SP::OK)
  {
    std::string advice, option;
    if(m_report.added_area > settings.limits.maximum_added_area)
      option = "--max-added-area " + fixed_text((std::min)(std::ceil(100. * m_report.added_area) / 100., 1.), 2);
    else if(error == SP::ERROR_NON_CLOSED_MESH)
      option = "A larger --max-hole";
    else if(error == SP::ERROR_NO_TOPOLOGICAL_SPHERE)
      option = "A larger --max-handle";
    if(!option.empty())
      advice = "\n" + option + " permits this; " +
               (is_wrapped() ? "a larger ALPHA closes wider gaps."
                             : "--wrap ALPHA closes gaps with a new surface around it.");
    throw Program_error(m_report.message, ".", advice, "\n(Vertices and faces ",
                        is_wrapped() ? "belong to the wrapping, and " : "", "are counted from 0.)");
  }
  m_file.points = std::move(surface.points);
  m_file.polygons = std::move(surface.polygons);
  m_vertices = std::move(repaired.source_vertices);
  m_faces = std::move(repaired.source_faces);
  surface.points = std::move(repaired.points);
  surface.polygons.assign(repaired.triangles.size(), Polygon());
  for(std::size_t f = 0; f < repaired.triangles.size(); ++f)
    surface.polygons[f].assign(repaired.triangles[f].begin(), repaired.triangles[f].end());
}

Words Repair_step::descriptions() const
{
  Words result;
  if(is_wrapped())
    result.push_back(joined("wrapped: ", m_number_of_wrapping_faces, " faces, all of them new"));
  const SP::Repair_report& r = m_report;
  const auto add = [&](const SP::Repair_count& count, const char* one, const char* many, const char* at) {
    if(count.number > 0)
      result.push_back(joined(count.number, ' ', count.number == 1 ? one : many, count.number == 1 ? " (" : " (first ",
                              at, ' ', count.first, ')'));
  };
  add(r.triangulated_polygons, "polygon triangulated", "polygons triangulated", "face");
  add(r.degenerate_faces, "degenerate face removed", "degenerate faces removed", "face");
  add(r.repeated_faces, "duplicate face removed", "duplicate faces removed", "face");
  add(r.merged_vertices, "vertex merged with another one", "vertices merged with others", "vertex");
  add(r.reversed_faces, "face reversed", "faces reversed", "face");
  add(r.non_manifold_edges, "edge with more than two faces separated", "edges with more than two faces separated",
      "at vertex");
  add(r.divided_vertices, "non-manifold vertex divided", "non-manifold vertices divided", "vertex");
  if(r.removed_faces.number > 0)
    result.push_back(joined("the largest of ", r.number_of_components, " components kept; the others had ",
                            r.removed_faces.number, " faces"));
  const auto n_holes = std::count_if(r.patches.begin(), r.patches.end(), [](const auto& p) { return !p.is_of_handle; });
  if(n_holes > 0)
    result.push_back(joined(n_holes, n_holes == 1 ? " hole filled" : " holes filled"));
  if(const std::size_t n = r.handle_cycles.size(); n > 0)
    result.push_back(joined(n, n == 1 ? " handle cut" : " handles cut"));
  if(!r.patches.empty())
  {
    constexpr std::size_t max_listed = 5;
    std::vector<SP::Repair_patch> patches = r.patches;
    std::stable_sort(patches.begin(), patches.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
    std::string text = "patches cover " + percent(r.added_area) + " of the area:";
    for(std::size_t k = 0; k < patches.size() && k < max_listed; ++k)
      text +=
          joined(k == 0 ? " " : ", ", percent(patches[k].share), patches[k].is_of_handle ? " at a cut" : " in a hole",
                 " of ", patches[k].number_of_edges, " edges at vertex ", patches[k].vertex);
    if(const std::size_t n = patches.size(); n > max_listed)
      text += joined(", and ", n - max_listed, n == max_listed + 1 ? " smaller patch" : " smaller patches");
    result.push_back(text);
  }
  add(r.split_edges, "duplicate edge split", "duplicate edges split", "at vertex");
  if(result.empty())
    result.push_back("nothing, because the surface has no defects");
  return result;
}

std::size_t Repair_step::vertex_of(std::size_t vertex_of_file) const
{
  const auto found = std::find(m_vertices.begin(), m_vertices.end(), vertex_of_file);
  return found == m_vertices.end() ? none : static_cast<std::size_t>(found - m_vertices.begin());
}

void Repair_step::transfer(File_content& values, const std::vector<Polygon>& triangles) const
{
  const auto transfer_all = [&](std::vector<Values>& all, std::size_t size, const std::vector<std::size_t>& sources,
                                const auto& find_neighbors) {
    const auto is_of_file = [&](const Values& one) { return one.numbers.size() == size; };
    if(all.empty() || !std::all_of(all.begin(), all.end(), is_of_file))
      return;
    const Neighbors neighbors = find_neighbors(sources, triangles);
    for(Values& one : all)
    {
      one.numbers = Program::transferred(one.numbers, sources);
      spread(sources, neighbors, one.has_fractions(), one.numbers);
    }
  };
  if(!has_changed_surface())
    return;
  transfer_all(values.values_of_vertices, m_file.points.size(), m_vertices, neighbors_of_vertices);
  transfer_all(values.values_of_faces, m_file.polygons.size(), m_faces, neighbors_of_faces);
}

std::vector<Point_3> Repair_step::transferred(const std::vector<Point_3>& points,
                                              const std::vector<Polygon>& triangles) const
{
  File_content coordinates;
  for(int k = 0; k < 3; ++k)
  {
    coordinates.values_of_vertices.push_back({"", double(), {}});
    for(const Point_3& p : points)
      coordinates.values_of_vertices.back().numbers.push_back(p[k]);
  }
  transfer(coordinates, triangles);
  const auto& [x, y, z] = std::tie(coordinates.values_of_vertices[0].numbers, coordinates.values_of_vertices[1].numbers,
                                   coordinates.values_of_vertices[2].numbers);
  std::vector<Point_3> result;
  for(std::size_t v = 0; v < x.size(); ++v)
    result.emplace_back(x[v], y[v], z[v]);
  return result;
}

} // namespace Program
