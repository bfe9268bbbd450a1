#ifndef PROGRAM_COLORED_MESH_H
#define PROGRAM_COLORED_MESH_H

#include "File_content.h"

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace Program {

/// A mesh with a distortion per face, shown as a colour per vertex: what all viewers of PLY files understand.
class Colored_mesh
{
public:
  /// gives each vertex the average of its faces. The colours range from `min` to a value that is exceeded by one vertex in
  /// a hundred, because a single bad face would hide all others.
  ///
  /// \param distortions one for each face, at least `min`; those that are infinite are left out
  Colored_mesh(std::size_t number_of_vertices, const std::vector<Polygon>& faces,
               const std::vector<double>& distortions, double min);

  /// returns the distortion with the darkest colour, and that with the lightest, which larger ones have as well.
  const std::array<double, 2>& range() const { return m_range; }

  /// writes a PLY file with the vertices at `points`. The distortion is there as a number, too, as MeshLab's "quality".
  void write(std::ostream& out, const std::vector<Point_3>& points) const;

private:
  static constexpr double quantile = 0.99;
  static constexpr double min_range = 1.01;
  static constexpr std::array<int, 3> grey = {128, 128, 128}; // of vertices without a distortion

  // Returns a colour for `t` in [0, 1], from dark violet to light yellow, as red, green and blue in [0, 255].
  //
  // Equal steps of `t` look alike: the lightness grows evenly in Oklab, Ottosson's perceptually uniform space, while the
  // hue turns through blue and green, so that the order is visible on a grey print and with colour blindness.
  static std::array<int, 3> color_of(double t);

  const std::vector<Polygon>& m_faces;
  std::vector<double> m_values; // 0 where there is none
  std::array<double, 2> m_range;
};

} // namespace Program

#endif // PROGRAM_COLORED_MESH_H
