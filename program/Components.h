#ifndef PROGRAM_COMPONENTS_H
#define PROGRAM_COMPONENTS_H

#include "File_content.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Program {

/// The parts of a surface: faces that are connected by edges belong to the same one. The largest comes first, of several as
/// large that with the first face.
class Components
{
public:
  explicit Components(const std::vector<Polygon>& polygons);

  /// returns the numbers of faces of all parts.
  const std::vector<std::size_t>& sizes() const { return m_sizes; }

  /// leaves out all faces but those of one part. All vertices stay, so that their numbers do.
  void keep(std::size_t part, std::vector<Polygon>& polygons) const;

private:
  struct Side
  {
    std::uint64_t edge; // both of its vertices
    std::size_t face;
  };

  std::vector<std::size_t> m_sizes, m_part_of_face;
};

} // namespace Program

#endif // PROGRAM_COMPONENTS_H
