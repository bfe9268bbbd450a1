#include "Page.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Spherical_parameterization/Cortex/compute_sulcal_measures.h>
#include <CGAL/Spherical_parameterization/Surface_maps/align_spheres.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <limits>

namespace Program {

namespace {

double length_of(const Point_3& p)
{
  return SP::internal::hypotenuse(p.x(), p.y(), p.z());
}

Point_3 direction_of(const Point_3& p)
{
  const double length = length_of(p);
  return length > 0. ? Point_3(p.x() / length, p.y() / length, p.z() / length) : p;
}

std::string shown_name(const std::string& path)
{
  return printable(name_of(path_of(path).filename()));
}

float to_float(double value)
{
  return value <= (std::numeric_limits<float>::max)() ? static_cast<float>(value)
                                                      : std::numeric_limits<float>::infinity();
}

// calls `visit(v)` for each corner of a face; isolated vertices may have any point
template <class Visit>
void for_each_corner(const Page& page, const Visit& visit)
{
  for(const auto& triangle : page.triangles)
    for(const std::uint32_t v : triangle)
      visit(v);
}

// Sets the left side to a surface with all its faces.
void show_surface(Page& page, const Input_mesh& input, const Mesh& mesh)
{
  for(const Polygon& triangle : input.triangles())
    page.triangles.push_back({std::uint32_t(triangle[0]), std::uint32_t(triangle[1]), std::uint32_t(triangle[2])});
  page.left.title = shown_name(input.name());
  page.left.points.assign(mesh.points().begin(), mesh.points().end());
}

// Scales and translates one side, or both with the same transformation, into the unit ball.
void normalize(const Page& page, const std::vector<Page::Side*>& sides)
{
  CGAL::Bbox_3 box;
  for(const Page::Side* side : sides)
    for_each_corner(page, [&](std::size_t v) { box += side->points[v].bbox(); });
  std::array<double, 3> center{};
  double extent = 0., radius = 0.;
  for(std::size_t k = 0; k < 3; ++k)
  {
    const double low = (box.min)(static_cast<int>(k)), high = (box.max)(static_cast<int>(k));
    center[k] = 0.5 * low + 0.5 * high; // their sum may be infinite
    extent = (std::max)(extent, 0.5 * high - 0.5 * low);
  }
  const auto shrink = [&](const Point_3& origin, double& size) {
    size = size > 0. ? size : 1.;
    for(Page::Side* side : sides)
      for(Point_3& p : side->points)
        p = CGAL::ORIGIN + (p - origin) / size;
  };
  shrink(Point_3(center[0], center[1], center[2]), extent);
  for(Page::Side* side : sides)
    for_each_corner(page, [&](std::size_t v) { radius = (std::max)(radius, length_of(side->points[v])); });
  shrink(Point_3(0., 0., 0.), radius);
  for(Page::Side* side : sides)
  {
    side->center = center;
    side->scale = extent * radius;
  }
}

// Finds the rotation of a side to the pose of the left one; the pose of a computed sphere is arbitrary.
void rotate_to_left(const Page& page, Page::Side& side)
{
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<bool> is_paired(side.points.size(), false);
  for_each_corner(page, [&](std::size_t v) {
    if(!is_paired[v] && length_of(side.points[v]) > 0. && length_of(page.left.points[v]) > 0.)
      pairs.emplace_back(v, v);
    is_paired[v] = true;
  });
  SP::Sphere_alignment_3::Rotation_3 rotation(CGAL::IDENTITY);
  if(SP::fit_rotation(CGAL::make_property_map(side.points), CGAL::make_property_map(page.left.points), pairs,
                      rotation) != SP::OK)
    return; // no rotation is determined
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      side.rotation[static_cast<std::size_t>(3 * i + j)] = rotation.m(i, j);
}

// The number of faces between each face and the nearest handle cycle.
std::vector<std::size_t> steps_from(const Mesh& mesh, const std::vector<Input_mesh::Handle>& handles)
{
  std::vector<std::size_t> steps(mesh.number_of_faces(), mesh.number_of_faces());
  std::vector<Mesh::Face_index> queue;
  const auto reach = [&](Mesh::Face_index f, std::size_t n) {
    if(n >= steps[f])
      return;
    steps[f] = n;
    queue.push_back(f);
  };
  for(const Input_mesh::Handle& handle : handles)
    for(const Vertex_index v : handle.path)
      for(const Mesh::Face_index f : faces_around_target(mesh.halfedge(v), mesh))
        reach(f, 0);
  for(std::size_t i = 0; i < queue.size(); ++i)
    for(const Mesh::Face_index f : faces_around_face(mesh.halfedge(queue[i]), mesh))
      reach(f, steps[queue[i]] + 1);
  return steps;
}

// Measures the distortion of each face, with both surfaces scaled to the same area.
std::vector<SP::Face_distortion> distortions_between(const Page& page, SP::Distortion_summary* summary = nullptr)
{
  const auto area = [&](const Page::Side& side) {
    double sum = 0.;
    for(const auto& t : page.triangles)
      sum += std::sqrt(CGAL::squared_area(side.points[t[0]], side.points[t[1]], side.points[t[2]]));
    return sum;
  };
  const double factor = std::sqrt(area(page.left) / area(page.right));
  File_content soup;
  soup.points = page.left.points;
  for(const auto& triangle : page.triangles)
    soup.polygons.emplace_back(triangle.begin(), triangle.end());
  Input_mesh refinement(page.left.title, std::move(soup));
  const Sphere_map map = refinement.mesh().add_property_map<Vertex_index, Point_3>("v:other").first;
  for(const Vertex_index v : refinement.mesh().vertices())
  {
    const Point_3& p = page.right.points[v];
    map[v] = Point_3(factor * p.x(), factor * p.y(), factor * p.z());
  }
  const Distortion_map distortions =
      refinement.mesh().add_property_map<Mesh::Face_index, SP::Face_distortion>("f:between").first;
  const SP::Distortion_summary measured = measured_distortion(refinement.mesh(), map, distortions);
  if(summary != nullptr)
    *summary = measured;
  return {distortions.begin(), distortions.end()};
}

// Adds a coloring by expected errors: each face has the mean over the corners of the face of the first surface that contains it.
void add_expected_errors(Page& page, const Surface_match& match)
{
  const std::vector<double>& errors = match.expected_errors();
  if(errors.empty())
    return;
  const std::vector<Polygon>& triangles = match.input().triangles();
  std::vector<float> values;
  for(const auto& faces : match.overlay().faces)
  {
    const Polygon& t = triangles[faces.first];
    values.push_back(to_float((errors[t[0]] + errors[t[1]] + errors[t[2]]) / 3.));
  }
  page.add_measure(
      "expected error", "expected error of the correspondence",
      "estimated distance of each matched point from the true corresponding point, as a fraction of the square root of "
      "the area of "
      "the right surface; the larger the value, the less reliable the match",
      0.,
      {{"maximum", *std::max_element(errors.begin(), errors.end())}, {"average", *match.figures.report.expected_error}},
      values);
}

void add_report(Page& page, const Run_report& report)
{
  page.is_one_to_one = report.result.is_one_to_one;
  page.verdict = report.verdict();
  if(report.match && report.match->report.is_uncertain)
    page.warning =
        "Ambiguous alignment: another alignment of the surfaces is almost as good, so that the map may be wrong as a "
        "whole, for example by a half-turn. Compare corresponding points of both sides, or repeat the match with "
        "--landmarks.";
  page.summary = report.summary();
  page.shown = report.shows_angles() ? "D_angle" : "D_iso";
}

// The displacement of the centroid of each face between two sides in one coordinate frame.
void add_displacements(Page& page)
{
  std::vector<float> values;
  SP::internal::Statistics_accumulator lengths; // in the unit of the page, so that squares do not overflow
  for(const auto& triangle : page.triangles)
  {
    CGAL::Vector_3<Kernel> moved(0., 0., 0.);
    for(const std::uint32_t v : triangle)
      moved = moved + (page.right.points[v] - page.left.points[v]) / 3.;
    const double length = length_of(CGAL::ORIGIN + moved);
    lengths.add(length);
    values.push_back(to_float(page.left.scale * length));
  }
  const double unit = page.left.scale;
  page.add_measure("displacement", "displacement",
                   "distance between corresponding points of both surfaces, in the unit of the files", 0.,
                   json_of({unit * lengths.maximum(), unit * lengths.average(), unit * lengths.deviation()}), values);
}

// `statistics_of` returns the statistics of a measure from its members of both summaries.
template <class Statistics>
void add_distortions(Page& page, const std::vector<SP::Face_distortion>& distortions, const Statistics& statistics_of)
{
  const auto add = [&](const char* name, const char* title, const char* meaning, double minimum,
                       double SP::Face_distortion::*of_face, const Json& statistics) {
    std::vector<float> values;
    for(const SP::Face_distortion& distortion : distortions)
      values.push_back(to_float(distortion.*of_face));
    page.add_measure(name, title, meaning, minimum, statistics, values);
  };
  add("D_iso", "isometric distortion D_iso",
      "largest factor by which the map stretches or shrinks lengths; 1 is no distortion", 1.,
      &SP::Face_distortion::isometric,
      statistics_of(&SP::Distortion_summary::isometric, &SP::Distortion_between::isometric));
  add("D_area", "area distortion D_area", "factor by which the map changes areas, plus its inverse; 2 is no distortion",
      2., &SP::Face_distortion::area, statistics_of(&SP::Distortion_summary::area, &SP::Distortion_between::area));
  add("D_angle", "angle distortion D_angle",
      "ratio of the largest to the smallest stretch, plus its inverse; 2 is no distortion", 2.,
      &SP::Face_distortion::angle, statistics_of(&SP::Distortion_summary::angle, &SP::Distortion_between::angle));
}

// Assigns to each face the most frequent label of its corners, if there is one.
void add_labels(const File_content& soup, const Mesh& mesh, const std::vector<Polygon>& triangles,
                std::vector<Page::Class>& classes, std::vector<std::uint16_t>& of_faces)
{
  if(soup.labels.empty() || soup.values_of_vertices.empty() || soup.values_of_vertices.front().has_fractions())
    throw Program_error("has no labels with names and colors; use an annotation of FreeSurfer or a .label.gii file");
  const std::vector<double>& keys = soup.values_of_vertices.front().numbers;
  if(keys.size() != mesh.number_of_vertices())
    throw Program_error("has labels of ", keys.size(), " vertices, but the surface has ", mesh.number_of_vertices());
  std::map<double, std::uint16_t> class_of;
  for(const SP::IO::Label& label : soup.labels)
    if(!is_among(label.name, {"", "???", "unknown", "Unknown"}) &&
       classes.size() < (std::numeric_limits<std::uint16_t>::max)())
    {
      class_of[label.key] = static_cast<std::uint16_t>(classes.size());
      classes.push_back({printable(label.name), {255. * label.color[0], 255. * label.color[1], 255. * label.color[2]}});
    }
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    const double a = keys[triangles[f][0]], b = keys[triangles[f][1]], c = keys[triangles[f][2]];
    const auto found = class_of.find(b == c ? b : a);
    if(found != class_of.end())
      of_faces[f] = found->second;
  }
}

} // namespace

Page page_of_sphere(Input_mesh& input, const Sphere_map& sphere, const Distortion_map& distortions,
                    const Run_report& report)
{
  Page page;
  const Mesh& mesh = input.mesh();
  show_surface(page, input, mesh);
  normalize(page, {&page.left});
  page.has_sphere = true;
  page.right.title = "sphere";
  add_report(page, report);
  add_distortions(page, {distortions.begin(), distortions.end()},
                  [&](auto of_sphere, auto of_both) { return report.statistics(of_sphere, of_both); });
  for(const Mesh::Face_index f : mesh.faces())
    if(distortions[f].is_inverted)
      page.inverted.push_back(f);
  for(const Vertex_index v : mesh.vertices())
    page.right.points.push_back(direction_of(sphere[v]));
  page.right.scale = report.result.report.radius;
  rotate_to_left(page, page.right);
  return page;
}

Page page_of_match(const Surface_match& match, const Run_report& report)
{
  Page page;
  const Overlay& overlay = match.overlay();
  page.triangles = overlay.triangles;
  page.has_numbers = true;
  page.left.title = shown_name(report.input());
  page.right.title = shown_name(report.match->other);
  for(const auto& [p, q] : overlay.points)
  {
    page.left.points.emplace_back(p.x(), p.y(), p.z());
    page.right.points.emplace_back(q.x(), q.y(), q.z());
  }
  const std::vector<std::size_t>& parents = report.match->parents; // of the faces of a surface that has been split
  for(const auto& [f, g] : overlay.faces)
  {
    page.left.faces.push_back(parents.empty() ? std::uint32_t(f) : static_cast<std::uint32_t>(parents[f]));
    page.right.faces.push_back(std::uint32_t(g));
  }
  normalize(page, {&page.left});
  normalize(page, {&page.right});
  add_report(page, report);
  add_distortions(page, distortions_between(page),
                  [&](auto of_sphere, auto of_both) { return report.statistics(of_sphere, of_both); });
  add_expected_errors(page, match);
  rotate_to_left(page, page.right);
  return page;
}

Page page_of_same_faces(Input_mesh& input, Input_mesh& other)
{
  Page page;
  const Mesh &mesh = input.mesh(), &second = other.mesh();
  input.check_faces_of(other.name(), "does not match the surface", second.number_of_vertices(), other.triangles());
  show_surface(page, input, mesh);
  page.right.title = shown_name(other.name());
  page.right.points.assign(second.points().begin(), second.points().end());
  normalize(page, {&page.left, &page.right});
  page.has_one_frame = true;
  page.shown = "displacement";
  page.verdict = "Both surfaces have the same faces; each vertex corresponds to the vertex with the same index.";
  page.summary.add("Mesh", sizes_of(mesh.number_of_vertices(), mesh.number_of_faces()));
  add_displacements(page);
  SP::Distortion_summary summary;
  const std::vector<SP::Face_distortion> distortions = distortions_between(page, &summary);
  add_distortions(page, distortions, [&](auto of_summary, auto) { return json_of(summary.*of_summary); });
  return page;
}

Page page_of_handles(Input_mesh& input, const std::vector<Input_mesh::Handle>& handles)
{
  Page page;
  page.is_one_to_one = false;
  page.morphs = false;
  const Mesh& mesh = input.mesh();
  show_surface(page, input, mesh);
  normalize(page, {&page.left});
  page.right = page.left;
  page.shown = "handles";
  page.right.title = "from behind";
  page.right.rotation = {-1., 0., 0., 0., 1., 0., 0., 0., -1.};
  page.verdict = handles.size() == 1
                     ? "The surface cannot be mapped: it has a handle."
                     : "The surface cannot be mapped: it has " + std::to_string(handles.size()) + " handles.";
  page.summary.add("Mesh", sizes_of(mesh.number_of_vertices(), mesh.number_of_faces()));
  for(std::size_t k = 0; k < handles.size(); ++k)
    page.summary.add("Handle " + std::to_string(k + 1), Input_mesh::describe(handles[k]));
  std::vector<float> values;
  for(const std::size_t steps : steps_from(mesh, handles))
    values.push_back(1.f + static_cast<float>(steps));
  page.add_measure("handles", "distance from handles",
                   "1 at a short cycle around a handle, and 1 more for each face between", 1.,
                   {{"handles", handles.size()}}, values);
  return page;
}

void add_repair(Page& page, const Input_mesh& input)
{
  if(!input.repair())
    return;
  page.summary.add("Repair", input.repair()->descriptions());
  std::vector<std::uint16_t> kinds;
  for(const Mesh::Face_index f : input.mesh().faces())
    kinds.push_back(input.is_patch(f) ? 1 : 0);
  if(input.has_patches())
    page.add_classes("repair", "hole patches", "faces that the repair has added to close holes and cuts",
                     {{"surface of the file", {190, 190, 190}}, {"hole patch", {230, 120, 30}}}, kinds);
}

void add_anatomy(Page& page, Input_mesh& input, const std::string& labels)
{
  const Mesh& mesh = input.mesh();
  SP::Sulcal_measures measures;
  check(SP::compute_sulcal_measures(input.mesh(), measures, SP::Sulcal_measures::CURVATURE), input.name());
  std::vector<std::uint16_t> is_sulcus, areas;
  for(const Polygon& t : input.triangles())
    is_sulcus.push_back(measures.curvature[t[0]] + measures.curvature[t[1]] + measures.curvature[t[2]] > 0. ? 1 : 0);
  const std::vector<Page::Class> grey = {{"gyrus", {190, 190, 190}}, {"sulcus", {105, 105, 105}}};
  if(!labels.empty())
  {
    areas = is_sulcus;
    std::vector<Page::Class> classes = grey;
    for(Page::Class& one : classes)
      one.name = "no label";
    {
      const File_content content = input.transferred(read_file_of_values(labels));
      read_named(labels, [&] { add_labels(content, mesh, input.triangles(), classes, areas); });
    }
    page.add_classes("labels", "labels", shown_name(labels), classes, areas);
    page.shown = "labels";
  }
  page.add_classes("sulci", "gyri and sulci", "sign of the mean curvature", grey, is_sulcus);
}

} // namespace Program
