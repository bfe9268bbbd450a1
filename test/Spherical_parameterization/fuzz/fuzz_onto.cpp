// A fuzzer for what the command line program reads between two surfaces: the first byte says whether the others are a file of
// landmarks or of features. Whatever they are, they are refused with a message for a person, or the first surface is mapped
// by them onto the second one, one-to-one.

#include "Fuzzed_bytes.h"
#include "require.h"

#include "test_meshes.h"

#include "surface_hints.h"

#include <CGAL/Spherical_parameterization/internal/files/read_mesh_file.h>
#include <CGAL/Spherical_parameterization/is_bijective.h>
#include <CGAL/Spherical_parameterization/Surface_maps/map_surface.h>
#include <CGAL/tags.h>

using namespace test_meshes;

namespace {

namespace SP = CGAL::Spherical_parameterization;

using Program::Mesh;
using Program::Vertex_index;
using Mapper = SP::Surface_mapper_3<Mesh>;

Vertex_index vertex(std::size_t v)
{
  return Vertex_index(static_cast<Mesh::size_type>(v));
}

// Two surfaces with the same faces, which are mapped as an icosphere. The first one has a vertex without a face, the last.
struct Surfaces
{
  Surfaces()
  {
    first.add_vertex();
    sphere.add_vertex();
  }

  void require_map(const Mapper& settings) const
  {
    Mapper mapper = settings;
    Mesh images = first;
    const SP::Error_code error =
        SP::map_surface<CGAL::Sequential_tag>(first, sphere.points(), second, sphere.points(), mapper, images.points());
    require(error == SP::OK, SP::get_error_message(error));
    require(SP::is_bijective(first, images.points()), "the map is not one-to-one");
  }

  static Program::Input_mesh input_of(const Triangle_list& list)
  {
    Program::File_content content;
    for(const auto& p : list.points)
      content.points.emplace_back(p[0], p[1], p[2]);
    content.points.emplace_back(0., 0., 0.);
    for(const auto& t : list.triangles)
      content.polygons.emplace_back(t.begin(), t.end());
    return Program::Input_mesh("first", std::move(content));
  }

  Mesh first = make_mesh<Mesh>(bumpy_sphere(1)), second = make_mesh<Mesh>(icosphere(1)), sphere = second;
  Program::Input_mesh input = input_of(bumpy_sphere(1));
};

void map_by_landmarks(const Surfaces& surfaces, const std::string& content)
{
  const std::vector<Program::Landmark> first = Program::parse_landmarks(content, surfaces.input);
  if(first.size() < 3) // The search for a rotation would take all the time.
    return;
  std::vector<Mapper::Landmark> landmarks;
  for(std::size_t k = 0; k < first.size(); ++k)
    landmarks.emplace_back(first[k].vertex, first[(k + 1) % first.size()].vertex);
  surfaces.require_map(Mapper().landmarks(landmarks));
}

void map_by_features(const Surfaces& surfaces, const std::string& content)
{
  const std::size_t n = num_vertices(surfaces.first);
  const Program::File_features features =
      Program::features_of({SP::internal::read_mesh_file(".ply", content, true)}, n);
  std::vector<Mapper::Feature> pairs;
  for(const auto& [name, values] : features.values)
    pairs.emplace_back([values = &values](Vertex_index v) { return (*values)[v]; },
                       [values = &values, n](Vertex_index v) { return (*values)[n - 1 - v]; });
  if(pairs.empty())
    return;
  const std::vector<Mapper::Landmark> landmarks = {
      {vertex(0), vertex(0)}, {vertex(2), vertex(2)}, {vertex(4), vertex(4)}};
  surfaces.require_map(Mapper().landmarks(landmarks).features(pairs));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Surfaces surfaces;
  Fuzzed_bytes bytes(data, size);
  const bool are_landmarks = bytes.below(2) == 0;
  const std::string content = bytes.rest();
  require_message_or_nothing([&] {
    if(are_landmarks)
      map_by_landmarks(surfaces, content);
    else
      map_by_features(surfaces, content);
  });
  return 0;
}
