// What is found between two surfaces is the same sequentially and in parallel, and in calls at the same time for the same
// const meshes. scripts/test_sanitizers.sh runs this file under the sanitizer of threads.

#include "surfaces.h"

using namespace test;

namespace {

// Two surfaces, one of them so large that loops over it are cut into many blocks.
struct Two_surfaces
{
  Mapped_mesh large{icosphere(4), on_body};
  Mapped_mesh small{octahedron_of(12), on_body, turns[1]};
};

// All that is found between the two.
struct Findings
{
  template <class ConcurrencyTag>
  static Findings of(const Two_surfaces& surfaces, ConcurrencyTag)
  {
    Findings result;
    const auto& [large, small] = surfaces;

    using Locator = SP::Sphere_locator_3<Mesh, Image_map, ConcurrencyTag>;
    const std::vector<Point_3> directions = SP::Sphere_domain_3::octahedron(40).directions();
    std::vector<typename Locator::Face_location> locations;
    EXPECT_EQ(Locator(small.mesh, small.sphere).locate(directions, std::back_inserter(locations)), SP::OK);
    for(const auto& [face, weights] : locations)
    {
      result.faces.push_back(face);
      result.numbers.insert(result.numbers.end(), weights.begin(), weights.end());
    }

    SP::Surface_overlay_3<Mesh, Mesh> overlay;
    EXPECT_EQ(SP::overlay<ConcurrencyTag>(large.mesh, large.sphere, small.mesh, small.sphere, overlay), SP::OK);
    for(const auto& [face, face_of_other] : overlay.faces)
      result.faces.insert(result.faces.end(), {face, face_of_other});
    for(const auto& places : overlay.points)
      result.points.insert(result.points.end(), places.begin(), places.end());

    Mesh remesh;
    const Image_map sphere = remesh.add_property_map<Vertex_index, Point_3>("v:sphere").first;
    EXPECT_EQ(SP::remesh_through_sphere<ConcurrencyTag>(large.mesh, large.sphere, SP::Sphere_domain_3::octahedron(24),
                                                        remesh, sphere),
              SP::OK);
    result.points.insert(result.points.end(), remesh.points().begin(), remesh.points().end());
    SP::Surface_distance distance;
    EXPECT_EQ(SP::measure_distance<ConcurrencyTag>(large.mesh, remesh, distance), SP::OK);
    result.numbers.push_back(distance.from_first.root_mean_square);

    Mesh source = large.mesh, target = make(octahedron_of(120)); // of 15 blocks
    const auto heights = source.add_property_map<Vertex_index, double>("v:height").first,
               heights_of_target = target.add_property_map<Vertex_index, double>("v:height").first;
    for(const Vertex_index v : source.vertices())
      heights[v] = source.point(v).z();
    EXPECT_EQ(SP::transfer<ConcurrencyTag>(source, large.sphere, target, target.points(),
                                           std::pair(heights, heights_of_target)),
              SP::OK);
    result.numbers.insert(result.numbers.end(), heights_of_target.begin(), heights_of_target.end());

    Mesh mapped = small.mesh;
    const Mapper by_landmarks = Mapper().landmarks(
        {{Vertex_index(0), Vertex_index(0)}, {Vertex_index(37), Vertex_index(1)}, {Vertex_index(74), Vertex_index(2)}});
    for(const Mapper& mapper : {Mapper(), by_landmarks})
    {
      const Image_map images = mapped.add_property_map<Vertex_index, Point_3>("v:images").first;
      EXPECT_EQ(
          SP::map_surface<ConcurrencyTag>(small.mesh, small.sphere, large.mesh, large.sphere, Mapper(mapper), images),
          SP::OK);
      result.points.insert(result.points.end(), images.begin(), images.end());
    }
    return result;
  }

  bool operator==(const Findings& other) const
  {
    return faces == other.faces && points == other.points && numbers == other.numbers;
  }

  std::vector<Mesh::Face_index> faces;
  std::vector<Point_3> points;
  std::vector<double> numbers;
};

const Two_surfaces& surfaces()
{
  static const Two_surfaces result;
  return result;
}

const Findings& found_in_one_thread()
{
  static const Findings result = Findings::of(surfaces(), CGAL::Sequential_tag());
  return result;
}

TEST(Threads, change_nothing_of_what_is_found_between_surfaces)
{
  EXPECT_TRUE(Findings::of(surfaces(), CGAL::Parallel_if_available_tag()) == found_in_one_thread());
}

TEST(Threads, may_use_the_same_surfaces_and_the_same_locator_at_the_same_time)
{
  const Findings& expected = found_in_one_thread();
  const SP::Sphere_locator_3 locator(surfaces().large.mesh, surfaces().large.sphere);
  const std::vector<Point_3> directions = SP::Sphere_domain_3::cube(20).directions();
  std::vector<decltype(locator)::Face_location> locations;
  ASSERT_EQ(locator.locate(directions, std::back_inserter(locations)), SP::OK);
  std::vector<std::thread> threads;
  for(std::size_t i = 0; i < 2; ++i)
    threads.emplace_back([&] {
      for(std::size_t k = 0; k < directions.size(); ++k)
        EXPECT_EQ(locator.locate(directions[k]), locations[k]) << k;
      EXPECT_TRUE(Findings::of(surfaces(), CGAL::Parallel_if_available_tag()) == expected);
    });
  for(std::thread& thread : threads)
    thread.join();
}

} // namespace
