#ifndef PROGRAM_PAGE_H
#define PROGRAM_PAGE_H

#include "Surface_match.h"

namespace Program {

/// The content of a self-contained page for web browsers that shows two surfaces, or a surface and its sphere, side by side.
///
/// The scripts of the folder page/ read its data: two sides, `left` and `right`, with points of the vertices of the same faces,
/// measures and classes of these faces, and texts.
struct Page
{
  static constexpr std::array<double, 9> identity = {1., 0., 0., 0., 1., 0., 0., 0., 1.};

  struct Side
  {
    std::string title;
    std::vector<Point_3> points; ///< of all vertices, in the unit ball: coordinates of the page have single precision
    std::vector<std::uint32_t> faces; ///< the faces of the file that contain the faces of the page, if these are parts
    std::array<double, 3> center{};
    double scale = 1.;
    std::array<double, 9> rotation = identity; ///< of the drawing; displayed coordinates are those of the file
  };

  struct Class
  {
    std::string name;
    std::array<double, 3> colour; ///< red, green and blue, to 255
  };

  /// adds a value for each face. Colors depend on the ratio to the minimum, or on the value if that is 0.
  ///
  /// \param title,meaning a name for the legend, and a text that explains the values
  /// \param statistics numbers by name
  void add_measure(const std::string& name, const std::string& title, const std::string& meaning, double minimum,
                   const Json& statistics, const std::vector<float>& values);

  /// adds a class for each face.
  void add_classes(const std::string& name, const std::string& title, const std::string& meaning,
                   const std::vector<Class>& names, const std::vector<std::uint16_t>& values);

  std::vector<std::array<std::uint32_t, 3>> triangles;
  Side left, right;
  Json measures, classes;
  std::string arrays;                  ///< the values of the measures and of the classes, as elements of the page
  std::string shown;                   ///< the name of the measure or of the classes that is shown first
  std::vector<std::uint32_t> inverted; ///< faces
  std::string verdict;                 ///< the result of the certificate
  std::string warning;                 ///< that needs attention; empty if there is none
  Json summary;
  bool is_one_to_one = true;
  bool has_sphere = false;    ///< whether the right side is a sphere
  bool has_one_frame = false; ///< whether both sides share a coordinate frame, so that sizes can be compared
  bool has_numbers = false;   ///< whether the triangles are parts of numbered faces of both files
  bool morphs = true;         ///< whether the left side can be morphed to the right one
};

/// checks that the program can write pages.
void check_pages();

/// writes a page.
void write_page(std::ostream& out, const Page& page);

/// returns the page of a surface and its sphere.
///
/// \param distortions of the faces, as in the report
Page page_of_sphere(Input_mesh& input, const Sphere_map& sphere, const Distortion_map& distortions,
                    const Run_report& report);

/// returns the page of two surfaces, drawn as their common refinement.
Page page_of_match(const Surface_match& match, const Run_report& report);

/// returns the page of two surfaces with the same faces: the map between them takes each vertex to the vertex with the same index.
///
/// Both remain in the coordinate frame of their files, so that positions and sizes can be compared.
Page page_of_same_faces(Input_mesh& input, Input_mesh& other);

/// returns the page of a surface without a map: two views of it, with the distance of each face from the handles.
Page page_of_handles(Input_mesh& input, const std::vector<Input_mesh::Handle>& handles);

/// adds the repair of the first surface: its summary, and a coloring of hole patches.
void add_repair(Page& page, const Input_mesh& input);

/// adds colorings of sulci and gyri of the first surface, and of its labels, if there are any.
///
/// \param labels a file; empty if there is none
void add_anatomy(Page& page, Input_mesh& input, const std::string& labels);

} // namespace Program

#endif // PROGRAM_PAGE_H
