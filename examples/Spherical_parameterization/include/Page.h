#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PAGE_H

#include "Input_mesh.h"
#include "Json_object.h"
#include "Page_text.h"
#include "Polygon_soup.h"
#include "Program_error.h"
#include "Run_report.h"
#include "read_soup.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Spherical_parameterization/Surface_maps/overlay.h>
#include <CGAL/Spherical_parameterization/Surface_maps/align_spheres.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/Cortex/compute_sulcal_measures.h>
#include <CGAL/property_map.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Program {

/// A page for web browsers with two surfaces side by side, or a surface and its sphere, and all that it needs.
///
/// The scripts of the folder page/ read its data: two sides, `left` and `right`, which place the vertices of the same faces,
/// measures and classes of these faces, and texts.
class Page
{
public:
  /// checks that the program can write pages.
  ///
  /// \throws Program_error if it was built without what that takes
  static void check()
  {
#ifdef PROGRAM_WRITES_PAGES
    if(*page_fault != '\0')
      throw Program_error(page_fault);
#else
    throw Program_error(
        "this program was built without the page of --page.\nInstall Node.js and npm, and build it again.");
#endif
  }

  /// shows a surface and its sphere.
  ///
  /// \param distortions of the faces, as the report tells them
  Page(Input_mesh& input, const Sphere_map& sphere, const Distortion_map& distortions, const Run_report& report)
  {
    const Mesh& mesh = input.mesh_of_file();
    show_surface(input, mesh);
    place({&m_left});
    m_has_sphere = true;
    m_right.title = "its sphere";
    tell(report);
    add_distortions({distortions.begin(), distortions.end()},
                    [&](auto of_sphere, auto of_both) { return report.statistics(of_sphere, of_both); });
    for(const Mesh::Face_index f : mesh.faces())
      if(distortions[f].is_inverted)
        m_folded.push_back(f);
    for(const Vertex_index v : mesh.vertices())
      m_right.points.push_back(direction_of(sphere[v]));
    m_right.scale = report.result.report.radius;
    turn_like_left(m_right);
  }

  /// offers to colour what is shown by how the first surface is folded, and by its labels, if there are any.
  ///
  /// \param labels a file, empty if there is none
  ///
  /// \pre a constructor has put one or two surfaces with a map between them onto the page
  ///
  /// \throws Program_error if the labels are not those of the surface
  void add_anatomy(Input_mesh& input, const std::string& labels)
  {
    const Mesh& mesh = input.mesh_of_file();
    SP::Sulcal_measures folding;
    if(const SP::Error_code error = SP::compute_sulcal_measures(input.mesh(), folding); error != SP::OK)
      throw Program_error(input.name() + ": " + SP::get_error_message(error));
    std::vector<std::uint16_t> folds, areas;
    for(const Polygon& t : input.triangles())
      folds.push_back(folding.curvature[t[0]] + folding.curvature[t[1]] + folding.curvature[t[2]] > 0. ? 1 : 0);
    const std::vector<Class> grey = {{"ridge", {190, 190, 190}}, {"furrow", {105, 105, 105}}};
    if(!labels.empty())
    {
      areas = folds;
      std::vector<Class> classes = grey;
      for(Class& one : classes)
        one.name = "no label";
      read_named(labels, [&] { add_labels(read_soup(labels, true), mesh, input.triangles(), classes, areas); });
      add_classes({"labels", name_of(labels), std::move(classes), std::move(areas)});
      m_shown = m_measures.size() + m_classes.size() - 1;
    }
    add_classes({"folds", "ridges and furrows, by the sign of the mean curvature", grey, std::move(folds)});
  }

  /// shows two surfaces by their common refinement.
  Page(const SP::Surface_overlay_3<Mesh, Mesh>& overlay, const Run_report& report)
    : m_triangles(overlay.triangles)
    , m_has_numbers(true)
  {
    m_left.title = name_of(report.input());
    m_right.title = name_of(report.match->other);
    for(const auto& [p, q] : overlay.points)
    {
      m_left.points.emplace_back(p.x(), p.y(), p.z());
      m_right.points.emplace_back(q.x(), q.y(), q.z());
    }
    const std::vector<std::size_t>& parents = report.match->parents; // of the faces of a surface that has been split
    for(const auto& [f, g] : overlay.faces)
    {
      m_left.faces.push_back(parents.empty() ? std::uint32_t(f) : static_cast<std::uint32_t>(parents[f]));
      m_right.faces.push_back(std::uint32_t(g));
    }
    place({&m_left});
    place({&m_right});
    tell(report);
    add_distortions(distortions_between(),
                    [&](auto of_sphere, auto of_both) { return report.statistics(of_sphere, of_both); });
    turn_like_left(m_right);
  }

  /// shows two surfaces with the same faces: the map between them takes each vertex to that of the same number.
  ///
  /// Places and sizes are compared as well as shapes: both stay where they are in the space of their files.
  ///
  /// \throws Program_error if the faces differ
  Page(Input_mesh& input, Input_mesh& other)
  {
    const Mesh &mesh = input.mesh_of_file(), &second = other.mesh();
    input.check_faces_of(other.name(), "is no surface to show beside", second.number_of_vertices(), other.triangles());
    show_surface(input, mesh);
    m_right.title = name_of(other.name());
    m_right.points.assign(second.points().begin(), second.points().end());
    place({&m_left, &m_right});
    m_has_one_frame = true;
    m_verdict = "The same faces: each vertex is mapped to that of the same number.";
    m_summary.add("Mesh", std::to_string(mesh.number_of_vertices()) + " vertices, " +
                              std::to_string(mesh.number_of_faces()) + " faces");
    add_displacements();
    SP::Distortion_summary summary;
    const std::vector<SP::Face_distortion> distortions = distortions_between(&summary);
    add_distortions(distortions, [&](auto of_summary, auto) {
      const SP::Distortion_statistics& of = summary.*of_summary;
      return Json_object().add("maximum", of.maximum).add("average", of.average).add("deviation", of.deviation);
    });
  }

  /// shows a surface that has no map from two sides, and how far each face is from the handles.
  Page(Input_mesh& input, const std::vector<SP::Handle<Mesh>>& handles)
    : m_is_one_to_one(false)
    , m_morphs(false)
  {
    const Mesh& mesh = input.mesh();
    show_surface(input, mesh);
    place({&m_left});
    m_right = m_left;
    m_right.title = "from behind";
    m_right.rotation = {-1., 0., 0., 0., 1., 0., 0., 0., -1.};
    m_verdict = handles.size() == 1 ? "A handle keeps the surface from being mapped."
                                    : std::to_string(handles.size()) + " handles keep the surface from being mapped.";
    m_summary.add("Mesh", std::to_string(mesh.number_of_vertices()) + " vertices, " +
                              std::to_string(mesh.number_of_faces()) + " faces");
    for(std::size_t k = 0; k < handles.size(); ++k)
      m_summary.add("Handle " + std::to_string(k + 1), Input_mesh::describe(handles[k]));
    Measure measure{"near handles",
                    "1 at a short path around a handle; grows by 1 for each face between",
                    1.,
                    Json_object().add("handles", handles.size()),
                    {}};
    for(const std::size_t steps : steps_from(mesh, handles))
      measure.values.push_back(1.f + static_cast<float>(steps));
    m_measures.push_back(std::move(measure));
  }

  void write([[maybe_unused]] std::ostream& out) const
  {
#ifdef PROGRAM_WRITES_PAGES
    write_pieces(out, page_head);
    out << R"(<script type="application/json" id="facts">)" << without_tags(facts()) << "</script>\n";
    if(m_left.points.size() <= std::size_t((std::numeric_limits<std::uint16_t>::max)()) + 1)
      write_corners<std::uint16_t>(out);
    else
      write_corners<std::uint32_t>(out);
    write_side(out, "left", m_left);
    write_side(out, "right", m_right);
    for(const Measure& measure : m_measures)
    {
      std::string bytes;
      for(const float value : measure.values)
        append(bytes, value);
      write_array(out, measure.name, bytes);
    }
    for(const Classes& classes : m_classes)
    {
      std::string bytes;
      for(const std::uint16_t value : classes.values)
        append(bytes, value);
      write_array(out, classes.name, bytes);
    }
    std::string folded;
    for(const std::uint32_t f : m_folded)
      append(folded, f);
    write_array(out, "folded", folded);
    write_pieces(out, page_tail);
#endif
  }

private:
  static constexpr std::array<double, 9> identity = {1., 0., 0., 0., 1., 0., 0., 0., 1.};

  struct Side
  {
    std::string title;
    std::vector<Point_3> points;      ///< of all vertices, in the unit ball: numbers of the page have 24 bits only
    std::vector<std::uint32_t> faces; ///< the numbers in the file of what the faces are parts of, if they are parts
    std::array<double, 3> centre{};
    double scale = 1.;
    std::array<double, 9> rotation = identity; ///< for the page; the numbers that are told are those of the file
  };

  struct Measure
  {
    std::string name, meaning;
    double minimum;         ///< colours are for ratios to it, or for differences if it is 0
    Json_object statistics; ///< numbers by their names
    std::vector<float> values;
  };

  struct Class
  {
    std::string name;
    std::array<double, 3> colour; ///< red, green and blue, to 255
  };

  /// A class for each face
  struct Classes
  {
    std::string name, meaning;
    std::vector<Class> classes;
    std::vector<std::uint16_t> values;
  };

  // Gives each face the label that most of its corners have, if they have one.
  static void add_labels(const Polygon_soup& soup, const Mesh& mesh, const std::vector<Polygon>& triangles,
                         std::vector<Class>& classes, std::vector<std::uint16_t>& of_faces)
  {
    if(soup.labels.empty() || soup.values_of_vertices.empty() || soup.values_of_vertices.front().has_fractions())
      throw Program_error(
          "has no labels with names and colours, as the annotations of FreeSurfer and .label.gii files have");
    const std::vector<double>& keys = soup.values_of_vertices.front().numbers;
    if(keys.size() != mesh.number_of_vertices())
      throw Program_error("has labels of " + std::to_string(keys.size()) + " vertices, but the surface has " +
                          std::to_string(mesh.number_of_vertices()));
    std::map<double, std::uint16_t> class_of;
    for(const SP::IO::Label& label : soup.labels)
      if(!is_among(label.name, {"", "???", "unknown", "Unknown"}) &&
         classes.size() < (std::numeric_limits<std::uint16_t>::max)())
      {
        class_of[label.key] = static_cast<std::uint16_t>(classes.size());
        classes.push_back(
            {printable(label.name), {255. * label.color[0], 255. * label.color[1], 255. * label.color[2]}});
      }
    for(std::size_t f = 0; f < triangles.size(); ++f)
    {
      const double a = keys[triangles[f][0]], b = keys[triangles[f][1]], c = keys[triangles[f][2]];
      const auto found = class_of.find(b == c ? b : a);
      if(found != class_of.end())
        of_faces[f] = found->second;
    }
  }

  // Of two surfaces, what is shown are parts of the faces of the first one.
  void add_classes(Classes classes)
  {
    if(m_has_numbers)
    {
      std::vector<std::uint16_t> of_parts;
      for(const std::uint32_t f : m_left.faces)
        of_parts.push_back(classes.values[f]);
      classes.values.swap(of_parts);
    }
    m_classes.push_back(std::move(classes));
  }

  static std::string name_of(const std::string& path)
  {
    return printable(std::filesystem::path(path).filename().string());
  }

  // Makes a surface the left side, with all its faces.
  void show_surface(const Input_mesh& input, const Mesh& mesh)
  {
    for(const Polygon& triangle : input.triangles())
      m_triangles.push_back({std::uint32_t(triangle[0]), std::uint32_t(triangle[1]), std::uint32_t(triangle[2])});
    m_left.title = name_of(input.name());
    m_left.points.assign(mesh.points().begin(), mesh.points().end());
  }

  // calls `visit(v)` for each corner of a face: other vertices may be anywhere
  template <class Visit>
  void for_each_corner(const Visit& visit) const
  {
    for(const auto& triangle : m_triangles)
      for(const std::uint32_t v : triangle)
        visit(v);
  }

  // Puts one side or both, as they lie to each other, into the unit ball.
  void place(const std::vector<Side*>& sides) const
  {
    CGAL::Bbox_3 box;
    for(const Side* side : sides)
      for_each_corner([&](std::size_t v) { box += side->points[v].bbox(); });
    std::array<double, 3> centre{};
    double extent = 0., radius = 0.;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const int i = static_cast<int>(k);
      const double low = (box.min)(i), high = (box.max)(i);
      centre[k] = 0.5 * low + 0.5 * high; // their sum may be infinite
      extent = (std::max)(extent, 0.5 * high - 0.5 * low);
    }
    if(extent == 0.)
      extent = 1.;
    for(Side* side : sides)
    {
      for(Point_3& p : side->points)
        p = Point_3((p.x() - centre[0]) / extent, (p.y() - centre[1]) / extent, (p.z() - centre[2]) / extent);
      for_each_corner([&](std::size_t v) { radius = (std::max)(radius, length_of(side->points[v])); });
    }
    if(radius == 0.)
      radius = 1.;
    for(Side* side : sides)
    {
      for(Point_3& p : side->points)
        p = Point_3(p.x() / radius, p.y() / radius, p.z() / radius);
      side->centre = centre;
      side->scale = extent * radius;
    }
  }

  // Finds out how a side lies like the left one: how a method leaves a sphere is arbitrary.
  void turn_like_left(Side& side)
  {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    std::vector<bool> is_paired(side.points.size(), false);
    for_each_corner([&](std::size_t v) {
      if(!is_paired[v] && length_of(side.points[v]) > 0. && length_of(m_left.points[v]) > 0.)
        pairs.emplace_back(v, v);
      is_paired[v] = true;
    });
    SP::Sphere_alignment_3::Rotation_3 rotation(CGAL::IDENTITY);
    if(SP::fit_rotation(CGAL::make_property_map(side.points), CGAL::make_property_map(m_left.points), pairs,
                        rotation) != SP::OK)
      return; // any rotation is as good
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        side.rotation[static_cast<std::size_t>(3 * i + j)] = rotation.m(i, j);
  }

  // The number of faces between each face and the nearest of the paths.
  static std::vector<std::size_t> steps_from(const Mesh& mesh, const std::vector<SP::Handle<Mesh>>& handles)
  {
    std::vector<std::size_t> steps(mesh.number_of_faces(), mesh.number_of_faces());
    std::vector<Mesh::Face_index> queue;
    const auto reach = [&](Mesh::Face_index f, std::size_t n) {
      if(n >= steps[f])
        return;
      steps[f] = n;
      queue.push_back(f);
    };
    for(const SP::Handle<Mesh>& handle : handles)
      for(const Vertex_index v : handle.path)
        for(const Mesh::Face_index f : faces_around_target(mesh.halfedge(v), mesh))
          reach(f, 0);
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(const Mesh::Face_index f : faces_around_face(mesh.halfedge(queue[i]), mesh))
        reach(f, steps[queue[i]] + 1);
    return steps;
  }

  // Measures each face, with both surfaces scaled to the same area.
  std::vector<SP::Face_distortion> distortions_between(SP::Distortion_summary* summary = nullptr) const
  {
    const auto area = [&](const Side& side) {
      double sum = 0.;
      for(const auto& t : m_triangles)
        sum += std::sqrt(CGAL::squared_area(side.points[t[0]], side.points[t[1]], side.points[t[2]]));
      return sum;
    };
    const double factor = std::sqrt(area(m_left) / area(m_right));
    Polygon_soup soup;
    soup.points = m_left.points;
    for(const auto& triangle : m_triangles)
      soup.polygons.emplace_back(triangle.begin(), triangle.end());
    Input_mesh refinement(m_left.title, std::move(soup));
    const Sphere_map map = refinement.mesh().add_property_map<Vertex_index, Point_3>("v:other").first;
    for(const Vertex_index v : refinement.mesh().vertices())
    {
      const Point_3& p = m_right.points[v];
      map[v] = Point_3(factor * p.x(), factor * p.y(), factor * p.z());
    }
    const Distortion_map distortions =
        refinement.mesh().add_property_map<Mesh::Face_index, SP::Face_distortion>("f:between").first;
    const SP::Distortion_summary measured = measured_distortion(refinement.mesh(), map, distortions);
    if(summary != nullptr)
      *summary = measured;
    return {distortions.begin(), distortions.end()};
  }

  void tell(const Run_report& report)
  {
    m_is_one_to_one = report.result.is_one_to_one;
    m_verdict = report.verdict();
    m_summary = report.summary();
    m_shown = report.shows_angles() ? 2 : 0;
  }

  static float to_float(double value)
  {
    return value <= (std::numeric_limits<float>::max)() ? static_cast<float>(value)
                                                        : std::numeric_limits<float>::infinity();
  }

  // How far the middle of each face moves between two sides of one frame.
  void add_displacements()
  {
    Measure measure{
        "displacement", "how far a place moves from one surface to the other, in the unit of the files", 0., {}, {}};
    std::vector<double> lengths; // in the unit of the page, in which squares are numbers
    for(const auto& triangle : m_triangles)
    {
      CGAL::Vector_3<Kernel> moved(0., 0., 0.);
      for(const std::uint32_t v : triangle)
        moved = moved + (m_right.points[v] - m_left.points[v]) / 3.;
      lengths.push_back(length_of(CGAL::ORIGIN + moved));
      measure.values.push_back(to_float(m_left.scale * lengths.back()));
    }
    const double n = static_cast<double>(lengths.size());
    const double average = std::accumulate(lengths.begin(), lengths.end(), 0.) / n;
    double variance = 0.;
    for(const double length : lengths)
      variance += (length - average) * (length - average) / n;
    measure.statistics = Json_object()
                             .add("maximum", m_left.scale * *std::max_element(lengths.begin(), lengths.end()))
                             .add("average", m_left.scale * average)
                             .add("deviation", m_left.scale * std::sqrt(variance));
    m_measures.push_back(std::move(measure));
  }

  // `statistics_of` tells those of a measure, by its members of both summaries.
  template <class Statistics>
  void add_distortions(const std::vector<SP::Face_distortion>& distortions, const Statistics& statistics_of)
  {
    const auto add = [&](const char* name, const char* meaning, double minimum, double SP::Face_distortion::*of_face,
                         const Json_object& statistics) {
      Measure measure{name, meaning, minimum, statistics, {}};
      for(const SP::Face_distortion& distortion : distortions)
        measure.values.push_back(to_float(distortion.*of_face));
      m_measures.push_back(std::move(measure));
    };
    add("D_iso", "the largest factor by which a length is wrong", 1., &SP::Face_distortion::isometric,
        statistics_of(&SP::Distortion_summary::isometric, &SP::Distortion_between::isometric));
    add("D_area", "how areas change; 2 is best", 2., &SP::Face_distortion::area,
        statistics_of(&SP::Distortion_summary::area, &SP::Distortion_between::area));
    add("D_angle", "how angles change; 2 is best", 2., &SP::Face_distortion::angle,
        statistics_of(&SP::Distortion_summary::angle, &SP::Distortion_between::angle));
  }

  std::string facts() const
  {
    const auto side = [](const Side& of) {
      return Json_object()
          .add("title", of.title)
          .add("centre", of.centre)
          .add("scale", of.scale)
          .add("rotation", of.rotation);
    };
    Json_object measures;
    for(const Measure& measure : m_measures)
      measures.add(measure.name, Json_object()
                                     .add("meaning", measure.meaning)
                                     .add("minimum", measure.minimum)
                                     .add("statistics", measure.statistics));
    Json_object all_classes;
    std::vector<std::string> names;
    for(const Measure& measure : m_measures)
      names.push_back(measure.name);
    for(const Classes& of : m_classes)
    {
      std::vector<Json_object> classes;
      for(const Class& one : of.classes)
        classes.push_back(Json_object().add("name", one.name).add("colour", one.colour));
      all_classes.add(of.name, Json_object().add("meaning", of.meaning).add("classes", classes));
      names.push_back(of.name);
    }
    return Json_object()
        .add("vertices", m_left.points.size())
        .add("left", side(m_left))
        .add("right", side(m_right))
        .add("has_sphere", m_has_sphere)
        .add("has_one_frame", m_has_one_frame)
        .add("has_numbers", m_has_numbers)
        .add("morphs", m_morphs)
        .add("measure", names[m_shown])
        .add("measures", measures)
        .add("classes", all_classes)
        .add("one_to_one", m_is_one_to_one)
        .add("certificate", m_verdict)
        .add("summary", m_summary)
        .text();
  }

  // A text in JSON is the same with this; HTML would end or change the script at a tag.
  static std::string without_tags(const std::string& json)
  {
    std::string result;
    for(const char c : json)
      result += c == '<' ? "\\u003c" : std::string(1, c);
    return result;
  }

  static double length_of(const Point_3& p)
  {
    return std::hypot(p.x(), p.y(), p.z());
  }

  static Point_3 direction_of(const Point_3& p)
  {
    const double length = length_of(p);
    return length > 0. ? Point_3(p.x() / length, p.y() / length, p.z() / length) : p;
  }

  static void write_pieces(std::ostream& out, const char* const* piece)
  {
    for(; *piece != nullptr; ++piece)
      out << *piece;
  }

  template <class Index>
  void write_corners(std::ostream& out) const
  {
    std::string bytes;
    for_each_corner([&](std::uint32_t v) { append(bytes, static_cast<Index>(v)); });
    write_array(out, "corners", bytes);
  }

  void write_side(std::ostream& out, const std::string& id, const Side& side) const
  {
    std::string bytes;
    for(const Point_3& p : side.points)
      for(int k = 0; k < 3; ++k)
        append(bytes, static_cast<float>(p[k]));
    write_array(out, id, bytes);
    if(!m_has_numbers)
      return;
    bytes.clear();
    for(const std::uint32_t f : side.faces)
      append(bytes, f);
    write_array(out, id + "_faces", bytes);
  }

  // The lowest byte comes first, as browsers have it.
  template <class Unsigned>
  static void append(std::string& bytes, Unsigned value)
  {
    for(std::size_t i = 0; i < sizeof value; ++i)
      bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * i) & 0xff));
  }

  static void append(std::string& bytes, float value)
  {
    std::uint32_t bits = 0;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof value);
    append(bytes, bits);
  }

  static void write_array(std::ostream& out, const std::string& id, std::string& bytes)
  {
    using Base64 =
        boost::archive::iterators::base64_from_binary<boost::archive::iterators::transform_width<const char*, 6, 8>>;
    const std::size_t n_missing = (3 - bytes.size() % 3) % 3;
    bytes.append(n_missing, '\0');
    std::string text(Base64(bytes.data()), Base64(bytes.data() + bytes.size()));
    text.replace(text.size() - n_missing, n_missing, n_missing, '=');
    out << R"(<script type="text/plain" id=")" << id << "\">" << text << "</script>\n";
  }

  std::vector<std::array<std::uint32_t, 3>> m_triangles;
  Side m_left, m_right;
  std::vector<Measure> m_measures;
  std::vector<Classes> m_classes;
  std::size_t m_shown = 0; // the number of the measure, or behind them of the classes, that is shown first
  std::vector<std::uint32_t> m_folded;
  std::string m_verdict;
  Json_object m_summary;
  bool m_is_one_to_one = true;
  bool m_has_sphere = false;    // on the right side
  bool m_has_one_frame = false; // for both sides, so that sizes can be compared
  bool m_has_numbers = false;   // of faces, which the triangles are parts of
  bool m_morphs = true;         // from the left side to the right one
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PAGE_H
