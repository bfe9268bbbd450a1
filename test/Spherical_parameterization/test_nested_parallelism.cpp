// Calls from within what the caller runs in parallel himself: the same bits as a call alone and sequential, every time.

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"
#include "test_scale.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace params = CGAL::parameters;

namespace {

using test_meshes::Coordinates;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Method = SP::Bijective_low_distortion_parameterizer_3<Mesh>;
using Images = std::vector<Coordinates>;

constexpr std::size_t number_of_repetitions = test_scale::reduced(20);

template <class ConcurrencyTag, class NamedParameters>
Images images(const Mesh& mesh, const NamedParameters& np)
{
  Method method;
  const auto map = test_maps::make_sentinel_map<Point_3>(mesh);
  EXPECT_EQ(SP::parameterize<ConcurrencyTag>(mesh, method, map, np.number_of_iterations(1u)), SP::OK);
  EXPECT_TRUE(SP::is_bijective(mesh, map));
  return test_maps::images(mesh, map);
}

// The meshes, of several sizes, and their maps when they are mapped alone and sequentially.
class Nested_parallelism : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    if(!meshes().empty())
      return;
    // the first is large enough for all loops to be cut into many blocks, the others for some
    for(const test_meshes::Triangle_list& list :
        {test_meshes::bumpy_sphere(4), test_meshes::ellipsoid(1., 2., 4., 3),
         test_meshes::random_stacked_sphere(200, 1), test_meshes::octahedron()})
      meshes().push_back(test_meshes::make_mesh<Mesh>(list));
    for(const Mesh& mesh : meshes())
      alone().push_back(images<CGAL::Sequential_tag>(mesh, params::default_values()));
  }

  static std::vector<Mesh>& meshes()
  {
    static std::vector<Mesh> result;
    return result;
  }

  static std::vector<Images>& alone()
  {
    static std::vector<Images> result;
    return result;
  }

  // Maps mesh k, here and now.
  static void expect_same_bits(std::size_t k)
  {
    EXPECT_TRUE(
        test_maps::have_same_bits(images<CGAL::Parallel_tag>(meshes()[k], params::default_values()), alone()[k]))
        << k;
  }

  // TBB's own limit is the number of cores; for an arena to be larger, it has to be raised.
  const tbb::global_control m_control{tbb::global_control::max_allowed_parallelism, 4};
};

TEST_F(Nested_parallelism, in_an_arena)
{
  for(const int n_slots : {1, 2, 4})
  {
    tbb::task_arena arena(n_slots);
    for(std::size_t i = 0; i < number_of_repetitions; ++i)
      arena.execute([] { expect_same_bits(0); });
  }
}

TEST_F(Nested_parallelism, in_an_arena_without_a_slot_for_the_caller)
{
  tbb::task_arena arena(2, 0);
  for(std::size_t i = 0; i < number_of_repetitions; ++i)
    arena.execute([] { expect_same_bits(0); });
}

TEST_F(Nested_parallelism, in_a_loop_over_meshes)
{
  for(std::size_t i = 0; i < number_of_repetitions; ++i)
    tbb::parallel_for(std::size_t(0), meshes().size(), &expect_same_bits);
}

// Several iterations of the caller's loop on the same mesh, and one loop within another.
TEST_F(Nested_parallelism, in_loops_within_loops)
{
  for(std::size_t i = 0; i < test_scale::reduced(5); ++i)
    tbb::parallel_for(0, 2, [](int) {
      tbb::parallel_for(std::size_t(0), 2 * meshes().size(),
                        [](std::size_t k) { expect_same_bits(k % meshes().size()); });
    });
}

// Where the caller keeps his threads to one iteration at a time himself.
TEST_F(Nested_parallelism, in_isolated_iterations)
{
  for(std::size_t i = 0; i < number_of_repetitions; ++i)
    tbb::parallel_for(std::size_t(0), meshes().size(),
                      [](std::size_t k) { tbb::this_task_arena::isolate([k] { expect_same_bits(k); }); });
}

TEST_F(Nested_parallelism, in_task_groups)
{
  for(std::size_t i = 0; i < number_of_repetitions; ++i)
  {
    tbb::task_group group;
    for(std::size_t k = 0; k < meshes().size(); ++k)
      group.run([k] { expect_same_bits(k); });
    EXPECT_EQ(group.wait(), tbb::task_group_status::complete);
  }
}

// Each thread has an arena of its own, and all of them share TBB's workers.
TEST_F(Nested_parallelism, in_threads_with_different_meshes)
{
  for(std::size_t i = 0; i < number_of_repetitions; ++i)
  {
    std::vector<std::thread> threads;
    for(std::size_t k = 0; k < meshes().size(); ++k)
      threads.emplace_back([k] { expect_same_bits(k); });
    for(std::thread& thread : threads)
      thread.join();
  }
}

// More threads than fit: those that get no slot let others do their work.
TEST_F(Nested_parallelism, in_an_arena_of_several_threads)
{
  for(std::size_t i = 0; i < number_of_repetitions; ++i)
  {
    tbb::task_arena arena(2);
    std::vector<std::thread> threads;
    for(int k = 0; k < 4; ++k)
      threads.emplace_back([&arena] { arena.execute([] { expect_same_bits(0); }); });
    for(std::thread& thread : threads)
      thread.join();
  }
}

TEST_F(Nested_parallelism, under_a_limit_of_threads)
{
  for(const std::size_t n_threads : {1u, 2u})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, n_threads);
    for(std::size_t i = 0; i < number_of_repetitions; ++i)
    {
      expect_same_bits(0);
      tbb::parallel_for(std::size_t(1), meshes().size(), &expect_same_bits);
    }
  }
}

// Cancels the caller's own tasks when it is called the given time.
class Cancelling_visitor : public SP::Default_visitor
{
public:
  Cancelling_visitor(std::size_t cancel_at, const std::function<void()>& cancel)
    : m_cancel_at(cancel_at)
    , m_cancel(cancel)
  {}

  void on_initialization_begin(std::size_t) { count(); }
  void on_level(std::size_t) { count(); }
  void on_initialization_end() { count(); }
  void after_iteration(std::size_t, double, double) { count(); }
  void on_optimization_end() { count(); }

  std::size_t number_of_calls() const { return m_n_calls; }

private:
  void count()
  {
    if(++m_n_calls == m_cancel_at)
      m_cancel();
  }

  std::size_t m_cancel_at, m_n_calls = 0;
  std::function<void()> m_cancel;
};

// When the caller cancels a group of tasks, TBB drops what has not begun, in the loops within them as well. But a call
// that has begun goes on as if nothing had happened: it cannot return half a result.
TEST_F(Nested_parallelism, in_tasks_that_are_cancelled)
{
  Cancelling_visitor counter(0, [] {});
  images<CGAL::Parallel_tag>(meshes()[0], params::visitor(std::ref(counter)));
  ASSERT_GT(counter.number_of_calls(), 10u);
  // from the end, where the least is left to be dropped
  for(std::size_t cancel_at = counter.number_of_calls(); cancel_at > 0; --cancel_at)
  {
    if(test_scale::is_slow && cancel_at % 10 != 1)
      continue;
    SCOPED_TRACE(cancel_at);
    Images found;
    tbb::task_group_context context;
    tbb::parallel_for(
        0, 1,
        [&](int) {
          Cancelling_visitor visitor(cancel_at, [&] { context.cancel_group_execution(); });
          found = images<CGAL::Parallel_tag>(meshes()[0], params::visitor(std::ref(visitor)));
        },
        context);
    EXPECT_TRUE(context.is_group_execution_cancelled());
    ASSERT_TRUE(test_maps::have_same_bits(found, alone()[0]));
  }
}

// The same where an exception cancels the tasks: what other iterations of the caller's loop have made is sound.
TEST_F(Nested_parallelism, beside_an_iteration_that_throws)
{
  struct Failure
  {};
  for(std::size_t i = 0; i < number_of_repetitions; ++i)
  {
    std::vector<Images> found(meshes().size());
    EXPECT_THROW(tbb::parallel_for(std::size_t(0), meshes().size() + 1,
                                   [&](std::size_t k) {
                                     if(k == i % (meshes().size() + 1))
                                       throw Failure();
                                     const std::size_t mesh = k < i % (meshes().size() + 1) ? k : k - 1;
                                     found[mesh] = images<CGAL::Parallel_tag>(meshes()[mesh], params::default_values());
                                   }),
                 Failure);
    for(std::size_t k = 0; k < meshes().size(); ++k)
      EXPECT_TRUE(found[k].empty() || test_maps::have_same_bits(found[k], alone()[k])) << k;
  }
}

// A visitor may use TBB itself.
TEST_F(Nested_parallelism, of_a_visitor_with_loops_of_its_own)
{
  struct Working_visitor : SP::Default_visitor
  {
    void on_level(std::size_t) { work(); }
    void after_iteration(std::size_t, double, double) { work(); }
    void work()
    {
      std::vector<double> squares(1000);
      tbb::parallel_for(std::size_t(0), squares.size(),
                        [&](std::size_t k) { squares[k] = static_cast<double>(k) * static_cast<double>(k); });
      sum += squares.back();
    }
    double sum = 0.;
  };
  for(std::size_t i = 0; i < number_of_repetitions; ++i)
  {
    Working_visitor visitor;
    EXPECT_TRUE(test_maps::have_same_bits(images<CGAL::Parallel_tag>(meshes()[0], params::visitor(std::ref(visitor))),
                                          alone()[0]));
    EXPECT_GT(visitor.sum, 0.);
  }
}

} // namespace

#else
TEST(Nested_parallelism, needs_TBB)
{
  GTEST_SKIP() << "TBB is not here.";
}
#endif
