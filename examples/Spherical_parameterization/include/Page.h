#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PAGE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PAGE_H

#include "Input_mesh.h"
#include "Json_object.h"
#include "Page_text.h"
#include "Program_error.h"
#include "Run_report.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Spherical_parameterization/align_spheres.h>

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
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Program {

/// A page for web browsers with the surface and its sphere side by side, and all that it needs.
///
/// The scripts of the folder page/ read its data: two sides, `left` and `right`, which place the vertices of the same faces, and
/// measures of these faces.
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

  /// \param input has to live longer, as the other parameters
  /// \param distortions of the faces, as the report tells them
  Page(Input_mesh& input, const Sphere_map& sphere, const Distortion_map& distortions, const Run_report& report)
    : m_mesh(input.mesh())
    , m_triangles(input.triangles())
    , m_sphere(sphere)
    , m_distortions(distortions)
    , m_report(report)
  {
    place_surface();
    turn_sphere();
  }

  void write([[maybe_unused]] std::ostream& out) const
  {
#ifdef PROGRAM_WRITES_PAGES
    write_pieces(out, page_head);
    out << R"(<script type="application/json" id="facts">)" << without_tags(facts()) << "</script>\n";
    if(m_mesh.number_of_vertices() <= max_short_index + 1)
      write_corners<std::uint16_t>(out);
    else
      write_corners<std::uint32_t>(out);
    write_points(out, "left", [&](Vertex_index v) { return m_centred[v]; });
    write_points(out, "right", [&](Vertex_index v) { return direction_of(m_sphere[v]); });
    write_measure(out, "D_iso", &SP::Face_distortion::isometric);
    write_measure(out, "D_area", &SP::Face_distortion::area);
    write_measure(out, "D_angle", &SP::Face_distortion::angle);
    std::string folded;
    for(const Mesh::Face_index f : m_mesh.faces())
      if(m_distortions[f].is_inverted)
        append(folded, std::uint32_t(f));
    write_array(out, "folded", folded);
    write_pieces(out, page_tail);
#endif
  }

private:
  static constexpr std::size_t max_short_index = (std::numeric_limits<std::uint16_t>::max)();

  // Puts the surface into the unit ball: numbers of the page have 24 bits only.
  void place_surface()
  {
    m_centred = m_mesh.add_property_map<Vertex_index, Point_3>("v:centred", Point_3(0, 0, 0)).first;
    CGAL::Bbox_3 box;
    for(const Vertex_index v : m_mesh.vertices())
      if(!m_mesh.is_isolated(v))
        box += m_mesh.point(v).bbox();
    double extent = 0., radius = 0.;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const int i = static_cast<int>(k);
      m_centre[k] = 0.5 * box.min(i) + 0.5 * box.max(i); // their sum may be infinite
      extent = (std::max)(extent, 0.5 * box.max(i) - 0.5 * box.min(i));
    }
    if(extent == 0.)
      extent = 1.;
    const auto for_each_vertex = [&](const auto& visit) {
      for(const Vertex_index v : m_mesh.vertices())
        if(!m_mesh.is_isolated(v))
          visit(v);
    };
    for_each_vertex([&](Vertex_index v) {
      const Point_3& p = m_mesh.point(v);
      m_centred[v] =
          Point_3((p.x() - m_centre[0]) / extent, (p.y() - m_centre[1]) / extent, (p.z() - m_centre[2]) / extent);
      radius = (std::max)(radius, length_of(m_centred[v]));
    });
    if(radius == 0.)
      radius = 1.;
    for_each_vertex([&](Vertex_index v) {
      const Point_3& p = m_centred[v];
      m_centred[v] = Point_3(p.x() / radius, p.y() / radius, p.z() / radius);
    });
    m_scale = extent * radius;
  }

  // Finds out how the sphere lies like the surface: how a method leaves it is arbitrary.
  void turn_sphere()
  {
    std::vector<std::pair<Vertex_index, Vertex_index>> pairs;
    for(const Vertex_index v : m_mesh.vertices())
      if(!m_mesh.is_isolated(v) && length_of(m_centred[v]) > 0.)
        pairs.emplace_back(v, v);
    SP::Sphere_alignment_3::Rotation_3 rotation(CGAL::IDENTITY);
    if(SP::fit_rotation(m_sphere, m_centred, pairs, rotation) != SP::OK)
      return; // any rotation is as good
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        m_rotation[static_cast<std::size_t>(3 * i + j)] = rotation.m(i, j);
  }

  std::string facts() const
  {
    const SP::Distortion_summary& distortion = m_report.balanced ? *m_report.balanced : m_report.distortion;
    const auto measure = [](const char* meaning, double minimum, const SP::Distortion_statistics& of) {
      return Json_object()
          .add("meaning", meaning)
          .add("minimum", minimum)
          .add("maximum", of.maximum)
          .add("average", of.average)
          .add("deviation", of.deviation);
    };
    const auto side = [](const std::string& title, const std::array<double, 3>& centre, double scale,
                         const std::array<double, 9>& rotation) {
      return Json_object().add("title", title).add("centre", centre).add("scale", scale).add("rotation", rotation);
    };
    return Json_object()
        .add("vertices", m_mesh.number_of_vertices())
        .add("left",
             side(printable(std::filesystem::path(m_report.input()).filename().string()), m_centre, m_scale, identity))
        .add("right", side("its sphere", {0., 0., 0.}, m_report.result.report.radius, m_rotation))
        .add("measure", m_report.shows_angles() ? "D_angle" : "D_iso")
        .add("measures",
             Json_object()
                 .add("D_iso", measure("the largest factor by which a length is wrong", 1., distortion.isometric))
                 .add("D_area", measure("how areas change; 2 is best", 2., distortion.area))
                 .add("D_angle", measure("how angles change; 2 is best", 2., distortion.angle)))
        .add("one_to_one", m_report.result.is_one_to_one)
        .add("certificate", m_report.verdict())
        .add("summary", m_report.summary())
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
    for(const Polygon& triangle : m_triangles)
      for(const std::size_t v : triangle)
        append(bytes, static_cast<Index>(v));
    write_array(out, "corners", bytes);
  }

  template <class Point_of>
  void write_points(std::ostream& out, const char* id, const Point_of& point_of) const
  {
    std::string bytes;
    for(const Vertex_index v : m_mesh.vertices())
    {
      const Point_3 p = point_of(v);
      for(int k = 0; k < 3; ++k)
        append(bytes, static_cast<float>(p[k]));
    }
    write_array(out, id, bytes);
  }

  void write_measure(std::ostream& out, const char* id, double SP::Face_distortion::*measure) const
  {
    std::string bytes;
    for(const Mesh::Face_index f : m_mesh.faces())
    {
      const double value = m_distortions[f].*measure;
      append(bytes, value <= (std::numeric_limits<float>::max)() ? static_cast<float>(value)
                                                                 : std::numeric_limits<float>::infinity());
    }
    write_array(out, id, bytes);
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

  static void write_array(std::ostream& out, const char* id, std::string& bytes)
  {
    using Base64 =
        boost::archive::iterators::base64_from_binary<boost::archive::iterators::transform_width<const char*, 6, 8>>;
    const std::size_t n_missing = (3 - bytes.size() % 3) % 3;
    bytes.append(n_missing, '\0');
    std::string text(Base64(bytes.data()), Base64(bytes.data() + bytes.size()));
    text.replace(text.size() - n_missing, n_missing, n_missing, '=');
    out << R"(<script type="text/plain" id=")" << id << "\">" << text << "</script>\n";
  }

  static constexpr std::array<double, 9> identity = {1., 0., 0., 0., 1., 0., 0., 0., 1.};

  Mesh& m_mesh;
  const std::vector<Polygon>& m_triangles;
  const Sphere_map& m_sphere;
  const Distortion_map& m_distortions;
  const Run_report& m_report;
  Sphere_map m_centred;
  std::array<double, 3> m_centre{};
  double m_scale = 1.;
  std::array<double, 9> m_rotation = identity;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_PAGE_H
