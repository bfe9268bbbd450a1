#ifndef PROGRAM_PAGE_H
#define PROGRAM_PAGE_H

#include "Surface_match.h"

namespace Program {

/// A page for web browsers with two surfaces side by side, or a surface and its sphere, and all that it needs.
///
/// The scripts of the folder page/ read its data: two sides, `left` and `right`, which place the vertices of the same faces,
/// measures and classes of these faces, and texts.
struct Page
{
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

  struct Class
  {
    std::string name;
    std::array<double, 3> colour; ///< red, green and blue, to 255
  };

  /// adds a number for each face. The colours are for their ratios to the minimum, or for differences if that is 0.
  ///
  /// \param statistics numbers by their names
  void add_measure(const std::string& name, const std::string& meaning, double minimum, const Json& statistics,
                   const std::vector<float>& values);

  /// adds a class for each face.
  void add_classes(const std::string& name, const std::string& meaning, const std::vector<Class>& names,
                   const std::vector<std::uint16_t>& values);

  std::vector<std::array<std::uint32_t, 3>> triangles;
  Side left, right;
  Json measures, classes;
  std::string arrays; ///< the values of the measures and of the classes, as elements of the page
  std::string shown;  ///< the name of the measure, or of the classes, that is shown first
  std::vector<std::uint32_t> folded;
  std::string verdict;
  Json summary;
  bool is_one_to_one = true;
  bool has_sphere = false;    // on the right side
  bool has_one_frame = false; ///< for both sides, so that sizes can be compared
  bool has_numbers = false;   // of faces, which the triangles are parts of
  bool morphs = true;         // from the left side to the right one
};

/// checks that the program can write pages.
void check_pages();

/// writes a page.
void write_page(std::ostream& out, const Page& page);

/// shows a surface and its sphere.
///
/// \param distortions of the faces, as the report tells them
Page page_of_sphere(Input_mesh& input, const Sphere_map& sphere, const Distortion_map& distortions,
                    const Run_report& report);

/// shows two surfaces by their common refinement.
Page page_of_match(const Surface_match& match, const Run_report& report);

/// shows two surfaces with the same faces: the map between them takes each vertex to that of the same number.
///
/// Places and sizes are compared as well as shapes: both stay where they are in the space of their files.
Page page_of_same_faces(Input_mesh& input, Input_mesh& other);

/// shows a surface that has no map from two sides, and how far each face is from the handles.
Page page_of_handles(Input_mesh& input, const std::vector<Input_mesh::Handle>& handles);

/// says what has been repaired of the first surface, and offers to colour what is shown by what was added to it.
void add_repair(Page& page, const Input_mesh& input);

/// offers to colour what is shown by how the first surface is folded, and by its labels, if there are any.
///
/// \param labels a file, empty if there is none
void add_anatomy(Page& page, Input_mesh& input, const std::string& labels);

} // namespace Program

#endif // PROGRAM_PAGE_H
