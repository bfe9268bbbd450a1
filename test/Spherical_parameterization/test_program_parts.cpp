// Parts of the command line program by themselves: signals, files, the spread of meshes over the cores, messages of errors.

#include "Program_fixture.h"
#include "locale_of_commas.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

#include "../../program/Interrupt_guard.h"
#include "../../program/Json.h"
#include "../../program/for_each_mesh.h"
#include "../../program/output_files.h"
#include "../../program/surface_hints.h"
#include "../../program/text.h"

#include <condition_variable>
#include <csignal>
#include <iostream>
#include <mutex>
#include <thread>

namespace {

TEST(Program_messages, call_what_is_the_same_by_the_same_words)
{
  EXPECT_EQ(::Program::message_of(std::bad_alloc()), "not enough memory");
  EXPECT_EQ(::Program::message_of(::Program::error_in("a\nb", "c")), "a\\x0ab: c");
}

TEST(Program_texts, are_the_same_in_every_locale)
{
  expect_same_with_commas([] {
    double x = 0.;
    EXPECT_TRUE(Program::is_number("1234.5", x));
    return std::tuple(x, Program::fixed_text(1234.5, 2), Program::joined(1234567), Program::Json(1234.5).text(),
                      Program::Json(std::size_t(1234567)).text());
  });
}

// The value decides, also if the file names the vertices that it has values of.
TEST(Mask, counts_vertices_with_a_value_that_is_not_0)
{
  Program::File_content soup;
  soup.values_of_vertices.push_back({"mask", std::uint8_t(), {1., 0., 2.}});
  EXPECT_EQ(Program::mask_of(soup, 3), (std::vector<char>{1, 0, 1}));
  soup.vertices = {0, 1, 4};
  EXPECT_EQ(Program::mask_of(soup, 5), (std::vector<char>{1, 0, 0, 0, 1}));
}

// Which of the two comes second makes no difference.
TEST(Interrupt_guard_death, ends_the_program_at_the_second_signal)
{
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  for(const int first : {SIGINT, SIGTERM, SIGHUP})
    for(const int second : {SIGINT, SIGTERM})
      EXPECT_EXIT(
          {
            const Program::Interrupt_guard guard;
            std::raise(first);
            std::cerr << (Program::Interrupt_guard::is_interrupted() ? "interrupted" : "") << std::endl;
            std::raise(second);
            std::exit(EXIT_SUCCESS);
          },
          ::testing::KilledBySignal(second), "^interrupted");
}

TEST(Interrupt_guard, leaves_it_to_nohup_what_a_hangup_means)
{
  std::signal(SIGHUP, SIG_IGN);
  {
    const Program::Interrupt_guard guard;
    std::raise(SIGHUP);
    EXPECT_FALSE(Program::Interrupt_guard::is_interrupted());
  }
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
}

TEST(Interrupt_guard, tells_all_threads_of_a_signal) // for the thread sanitizer
{
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const Program::Interrupt_guard guard;
        std::thread other([] {
          while(!Program::Interrupt_guard::is_interrupted())
            std::this_thread::yield();
        });
        std::raise(SIGINT);
        other.join();
        std::exit(EXIT_SUCCESS);
      },
      ::testing::ExitedWithCode(EXIT_SUCCESS), "");
}

TEST(Output_files, are_all_of_the_same_run_where_two_write_them)
{
  const fs::path folder = fs::path("program") / "two_runs";
  fs::create_directories(folder);
  const std::vector<std::string> names = {(folder / "sphere").string(), (folder / "report").string()};
  const auto run = [&](const std::string& text) {
    Program::Output_files files(names, {}, Program::Output_policy::replace);
    for(const std::string& name : names)
      files.write(name, [&](std::ostream& out) { out << text; });
    files.commit();
  };
  for(int k = 0; k < 1000; ++k)
  {
    std::thread other(run, "one");
    run("other");
    other.join();
    ASSERT_EQ(content(names[0]), content(names[1])) << k;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

using Program::large;
using Program::Thread_limit;

TEST(Batch_scheduling, starts_with_the_largest_mesh)
{
  const Thread_limit one_thread(1);
  std::vector<std::size_t> order;
  Program::for_each_mesh({5, large, 7, 5, 3 * large, 0, large - 1}, [&](std::size_t i) { order.push_back(i); });
  EXPECT_EQ(order, (std::vector<std::size_t>{4, 1, 6, 2, 0, 3, 5}));
  Program::for_each_mesh({}, [&](std::size_t) { FAIL(); });
}

#ifdef CGAL_LINKED_WITH_TBB

TEST(Batch_scheduling, runs_small_meshes_on_a_core_each_and_large_ones_on_all)
{
  for(const std::size_t n_threads : {1u, 2u, 4u})
  {
    SCOPED_TRACE(n_threads);
    const Thread_limit limit(n_threads);
    std::vector<std::uintmax_t> sizes(40);
    std::iota(sizes.begin(), sizes.end(), std::uintmax_t(1));
    sizes.insert(sizes.end(), 3, large);
    std::vector<std::size_t> counts(sizes.size(), 0), concurrency(sizes.size(), 0);
    std::mutex mutex;
    std::condition_variable changed;
    std::size_t n_now = 0, n_max = 0; // what goes on at the same time
    const auto run = [&](std::size_t i) {
      std::unique_lock<std::mutex> lock(mutex);
      n_max = (std::max)(n_max, ++n_now);
      changed.notify_all();
      ++counts[i];
      concurrency[i] = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
      if(sizes[i] >= large)
        EXPECT_EQ(n_max, 1u); // alone, before all others
      else                    // the others come, however late
        EXPECT_TRUE(changed.wait_for(lock, std::chrono::minutes(2), [&] { return n_max >= n_threads; }));
      --n_now;
    };
    tbb::task_arena arena(static_cast<int>(n_threads)); // on any machine
    arena.execute([&] { Program::for_each_mesh(sizes, run); });
    EXPECT_EQ(counts, std::vector<std::size_t>(sizes.size(), 1));
    EXPECT_EQ(n_max, n_threads);
    for(std::size_t i = 0; i < sizes.size(); ++i)
    {
      const bool is_alone = sizes[i] < large && sizes[i] > n_threads; // the last ones, which are the smallest, get help
      EXPECT_EQ(concurrency[i], is_alone ? 1u : n_threads) << i;
    }
  }
}

#endif

} // namespace

#endif
