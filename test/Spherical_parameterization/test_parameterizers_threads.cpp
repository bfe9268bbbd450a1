// The same input and options give the same bits: sequentially or in parallel, with any number of threads, again and
// again, also of calls at the same time and from within what the caller runs in parallel. scripts/test_sanitizers.sh
// runs this file under the sanitizer of threads.

#include "methods.h"
#include "test_scale.h"
#include "without_tbb.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>

#include <boost/property_map/function_property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

using namespace test;

namespace {

// The first is large enough for all loops to be cut into many blocks, the others for some.
const std::vector<Mesh>& meshes()
{
  static const std::vector<Mesh> result = {make(bumpy_sphere(4)), make(ellipsoid(1., 2., 4., 3)),
                                           make(random_stacked_sphere(200, 1)), make(octahedron())};
  return result;
}

// The images of mesh k, by a method of its own.
Images run(std::size_t k, bool is_parallel = true, Visitor* visitor = nullptr)
{
  Options options = Options().iterations(2);
  if(visitor != nullptr)
    options.visitor(*visitor);
  return bijective().run(meshes()[k], is_parallel ? options : options.sequential()).images;
}

const Images& alone(std::size_t k)
{
  static const std::vector<Images> result = [] {
    std::vector<Images> all;
    for(std::size_t i = 0; i < meshes().size(); ++i)
      all.push_back(run(i, false));
    return all;
  }();
  return result[k];
}

void expect_same_bits(std::size_t k)
{
  EXPECT_TRUE(have_same_bits(run(k), alone(k))) << k;
}

TEST(Determinism, of_every_method)
{
  std::vector<Method> methods = all_methods();
  methods.push_back(sampling());
  for(const Method& method : methods)
  {
    SCOPED_TRACE(method.name());
    const Options parallel = Options().iterations(5), sequential = Options(parallel).sequential();
    const Result first = method.run(meshes()[0], sequential);
    // The same object again, with another mesh in between, which leaves no trace.
    EXPECT_EQ(method.run(meshes()[3], sequential).error, SP::OK);
    for(const Options& options : {sequential, parallel})
    {
      const Result again = method.run(meshes()[0], options);
      EXPECT_EQ(again.error, first.error);
      EXPECT_TRUE(have_same_bits(again.images, first.images));
      EXPECT_EQ(again.report.average_energy, first.report.average_energy);
    }
  }
}

// What is measured, too.
TEST(Determinism, of_measuring)
{
  const Mesh& mesh = meshes()[0];
  const Point_map map(mesh, alone(0));
  EXPECT_TRUE(SP::is_bijective<CGAL::Sequential_tag>(mesh, map));
  EXPECT_TRUE(SP::is_bijective<CGAL::Parallel_if_available_tag>(mesh, map));
  const SP::Distortion_summary a = distortion_of<CGAL::Sequential_tag>(mesh, map),
                               b = distortion_of<CGAL::Parallel_if_available_tag>(mesh, map);
  for(const auto statistics :
      {&SP::Distortion_summary::isometric, &SP::Distortion_summary::area, &SP::Distortion_summary::angle})
  {
    EXPECT_EQ((a.*statistics).maximum, (b.*statistics).maximum);
    EXPECT_EQ((a.*statistics).average, (b.*statistics).average);
    EXPECT_EQ((a.*statistics).deviation, (b.*statistics).deviation);
  }
  EXPECT_EQ(a.radius, b.radius);
}

// Calls at the same time for one const mesh, which is only read.

TEST(Execution, is_the_same_for_files_compiled_without_tbb)
{
  for(const std::size_t n : {std::size_t(0), std::size_t(1), std::size_t(3), std::size_t(100000)})
  {
    const std::size_t sum = n > 0 ? n * (n - 1) / 2 : 0;
    EXPECT_EQ(sum_without_tbb(SP::internal::execution_of<CGAL::Sequential_tag>(), n), sum);
    EXPECT_EQ(sum_without_tbb(SP::internal::execution_of<CGAL::Parallel_if_available_tag>(), n), sum);
  }
}

TEST(Simultaneous_calls, for_the_same_mesh)
{
  const Mesh& mesh = meshes()[1];
  const std::vector<Method> methods = {bijective(), bijective_from_stereographic()};
  std::vector<Images> expected;
  for(const Method& method : methods)
    expected.push_back(method.run(mesh, Options().iterations(5)).images);
  std::vector<std::thread> threads;
  for(std::size_t i = 0; i < 4; ++i)
    threads.emplace_back([&, i] {
      for(int k = 0; k < 5; ++k)
      {
        const Method method = i % 2 == 0 ? bijective() : bijective_from_stereographic();
        EXPECT_TRUE(have_same_bits(method.run(mesh, Options().iterations(5)).images, expected[i % 2]));
      }
    });
  for(std::thread& thread : threads)
    thread.join();
}

// A race need not show; a temporary property of the mesh, where it would come from, does: while the mesh is read, while
// the start is made by another parameterizer, and during the sweeps.
TEST(Simultaneous_calls, add_no_property_even_for_a_while)
{
  const Mesh mesh = make(bumpy_sphere(2));
  const auto number_of_properties = [&] {
    return mesh.properties<Mesh::Vertex_index>().size() + mesh.properties<Mesh::Halfedge_index>().size() +
           mesh.properties<Mesh::Edge_index>().size() + mesh.properties<Mesh::Face_index>().size();
  };
  const std::size_t n_properties = number_of_properties();
  std::size_t max_properties = 0;
  const auto count = [&] { max_properties = (std::max)(max_properties, number_of_properties()); };
  struct Counting_visitor : Visitor
  {
    bool go_further(std::size_t, double) override
    {
      count();
      return true;
    }
    std::function<void()> count;
  };
  Counting_visitor visitor;
  visitor.count = count;
  const Point_map surface(mesh, points(mesh));
  surface.on_get() = count;
  bijective_from_stereographic().run(mesh, Options().points(surface).visitor(visitor).iterations(2));
  EXPECT_EQ(max_properties, n_properties);
  EXPECT_EQ(number_of_properties(), n_properties);
}

// The ids of a Polyhedron_3 are the caller's, whatever they are.
TEST(Simultaneous_calls, leave_the_ids_of_a_polyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  Polyhedron mesh = make_mesh<Polyhedron>(icosphere(1));
  for(const auto v : vertices(mesh))
    v->id() = 7;
  std::map<boost::graph_traits<Polyhedron>::vertex_descriptor, Point_3> result;
  const boost::associative_property_map<decltype(result)> map(result);
  EXPECT_EQ(SP::parameterize(mesh, map), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  for(const auto v : vertices(mesh))
    EXPECT_EQ(v->id(), 7u);
}

#ifdef CGAL_LINKED_WITH_TBB

class Tasks : public ::testing::Test
{
protected:
  Tasks()
  {
    for(std::size_t k = 0; k < meshes().size(); ++k)
      alone(k);
  }

  static constexpr std::size_t n_repetitions = test_scale::reduced(8);

  // TBB's own limit is the number of cores; for an arena to be larger, it has to be raised.
  const tbb::global_control m_control{tbb::global_control::max_allowed_parallelism, 7};
};

TEST_F(Tasks, of_any_number_of_threads)
{
  for(const int n_threads : {1, 2, 4, 7})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(n_threads));
    tbb::task_arena(n_threads).execute([] {
      for(std::size_t i = 0; i < n_repetitions; ++i)
        expect_same_bits(0);
    });
  }
  tbb::task_arena(2, 0).execute([] { expect_same_bits(0); }); // without a slot for the caller
}

// Several iterations of the caller's loop on the same mesh, one loop within another, and kept to one iteration at a
// time.
TEST_F(Tasks, of_loops_within_loops)
{
  for(std::size_t i = 0; i < n_repetitions; ++i)
  {
    tbb::parallel_for(0, 2, [](int) {
      tbb::parallel_for(std::size_t(0), 2 * meshes().size(),
                        [](std::size_t k) { expect_same_bits(k % meshes().size()); });
    });
    tbb::parallel_for(std::size_t(0), meshes().size(),
                      [](std::size_t k) { tbb::this_task_arena::isolate([k] { expect_same_bits(k); }); });
  }
}

// When the caller cancels a group of tasks, TBB drops what has not begun, in the loops within them as well. But a call
// that has begun goes on as if nothing had happened: it cannot return half a result.
TEST_F(Tasks, that_are_cancelled)
{
  struct Cancelling_visitor : Recorder
  {
    bool go_further(std::size_t i, double energy) override
    {
      const bool result = Recorder::go_further(i, energy);
      if(number_of_questions == cancel_at)
        context->cancel_group_execution();
      return result;
    }
    std::size_t cancel_at = 0;
    tbb::task_group_context* context = nullptr;
  };
  Cancelling_visitor counter;
  run(0, true, &counter);
  ASSERT_GT(counter.number_of_questions, 10u);
  for(std::size_t k = counter.number_of_questions; k > 0; k -= (std::min)(k, std::size_t(test_scale::is_slow ? 20 : 3)))
  {
    SCOPED_TRACE(k);
    Images found;
    tbb::task_group_context context;
    tbb::parallel_for(
        0, 1,
        [&](int) {
          Cancelling_visitor visitor;
          visitor.cancel_at = k;
          visitor.context = &context;
          found = run(0, true, &visitor);
        },
        context);
    EXPECT_TRUE(context.is_group_execution_cancelled());
    ASSERT_TRUE(have_same_bits(found, alone(0)));
  }
}

// A visitor may use TBB itself.
TEST_F(Tasks, of_the_visitor)
{
  struct Working_visitor : Visitor
  {
    void on_level(std::size_t) override { work(); }
    void after_iteration(std::size_t, double, double) override { work(); }
    void work()
    {
      std::vector<double> squares(1000);
      tbb::parallel_for(std::size_t(0), squares.size(),
                        [&](std::size_t k) { squares[k] = static_cast<double>(k) * static_cast<double>(k); });
      sum += squares.back();
    }
    double sum = 0.;
  };
  Working_visitor visitor;
  EXPECT_TRUE(have_same_bits(run(0, true, &visitor), alone(0)));
  EXPECT_GT(visitor.sum, 0.);
}

#endif

} // namespace
