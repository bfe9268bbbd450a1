// An exception that is thrown at any point of a run, by the caller's visitor, his property maps, his energy or for want of
// memory, arrives at the caller, and nothing else has happened: the mesh is as it was, and so is the map unless it is being
// written, no memory is lost, and the parameterizer is as good as new.

#include "engine.h"
#include "methods.h"
#include "test_scale.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

using namespace test;

// Memory that can be had to run out. All of this program goes through here.

namespace allocation {

std::atomic<std::size_t> number_of_requests(0), first_refused(0), last_refused(0);
std::atomic<std::ptrdiff_t> number_of_blocks(0);

bool is_refused()
{
  const std::size_t k = ++number_of_requests;
  return k >= first_refused && k <= last_refused;
}

void* request(std::size_t size, std::size_t alignment)
{
  if(is_refused())
    throw std::bad_alloc();
  size = (std::max)(size, std::size_t(1));
  void* const block = alignment == 0 ? std::malloc(size)
                                     : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if(block == nullptr)
    throw std::bad_alloc();
  ++number_of_blocks;
  return block;
}

void release(void* block) noexcept
{
  if(block == nullptr)
    return;
  --number_of_blocks;
  std::free(block);
}

// Refuses the requests with these numbers, counted from here, as long as it lives.
class Shortage
{
public:
  Shortage(std::size_t first, std::size_t last)
  {
    number_of_requests = 0;
    first_refused = first;
    last_refused = last;
  }
  ~Shortage() { first_refused = last_refused = 0; }
  Shortage(const Shortage&) = delete;
  Shortage& operator=(const Shortage&) = delete;
};

// How often a run asks for memory.
template <class Run>
std::size_t number_of_requests_of(const Run& run)
{
  const Shortage none(0, 0);
  static_cast<void>(run());
  return number_of_requests;
}

} // namespace allocation

// The other forms, of arrays and those that throw nothing, call these by default.
void* operator new(std::size_t size)
{
  return allocation::request(size, 0);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return allocation::request(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept
{
  allocation::release(block);
}
void operator delete(void* block, std::size_t) noexcept
{
  allocation::release(block);
}
void operator delete(void* block, std::align_val_t) noexcept
{
  allocation::release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept
{
  allocation::release(block);
}

namespace {

namespace params = CGAL::parameters;

// What the caller's own functions throw: nothing that the library could know.
struct Interruption
{};

// Throws when it is called the `throw_at`th time.
struct Countdown
{
  void operator()()
  {
    if(++n_calls == throw_at)
      throw Interruption();
  }

  std::size_t throw_at = 0, n_calls = 0;
};

struct Failing_visitor : Visitor
{
  explicit Failing_visitor(Countdown& c)
    : countdown(c)
  {}

  void on_initialization_begin(std::size_t) override { countdown(); }
  void on_level(std::size_t) override { countdown(); }
  void on_initialization_end() override { countdown(); }
  void after_iteration(std::size_t, double, double) override { countdown(); }
  bool go_further(std::size_t, double) override
  {
    countdown();
    return true;
  }
  void on_optimization_end() override { countdown(); }

  Countdown& countdown;
};

// A small mesh with a map that differs from any that is written, and the checks that both are left alone.
class Subject
{
public:
  explicit Subject(const Triangle_list& list)
    : mesh(make(list))
    , untouched(sentinels(num_vertices(mesh)))
    , map(mesh, untouched)
    , m_points(points(mesh))
    , m_triangles(triangles(mesh))
  {}

  // Calls `run`, which is to throw an Exception and to lose no memory.
  template <class Exception, class Run>
  void expect_exception(const Run& run) const
  {
    const std::ptrdiff_t n_blocks = allocation::number_of_blocks;
    bool is_caught = false;
    try
    {
      static_cast<void>(run());
    }
    catch(const Exception&)
    {
      is_caught = true;
    }
    EXPECT_EQ(allocation::number_of_blocks, n_blocks) << "memory was lost";
    EXPECT_TRUE(is_caught) << "the exception did not arrive";
    EXPECT_TRUE(have_same_bits(points(mesh), m_points) && triangles(mesh) == m_triangles) << "the mesh has changed";
    EXPECT_EQ(mesh.properties<Mesh::Vertex_index>().size(), m_number_of_properties) << "there is a property more";
  }

  template <class Exception, class Run>
  void expect_no_trace_of(const Run& run) const
  {
    expect_exception<Exception>(run);
    EXPECT_TRUE(have_same_bits(images(mesh, map), untouched)) << "the map has changed";
  }

  const Mesh mesh;
  const Images untouched;
  const Point_map map;

private:
  Images m_points;
  std::vector<Triangle> m_triangles;
  std::size_t m_number_of_properties = mesh.properties<Mesh::Vertex_index>().size();
};

// every how many of the points where a run can fail it does
constexpr std::size_t stride = test_scale::is_slow ? 29 : 1;

// Every method on a small surface that is star-shaped about the origin, so that it is a map to start from itself.
class Exception_safety : public ::testing::Test
{
protected:
  Subject subject{bumpy_sphere(1)};

  template <class Test>
  void for_each_method(const Test& test)
  {
    std::vector<Method> methods = all_methods();
    methods.push_back(precomputed(subject.mesh, points(subject.mesh)));
    methods.push_back(bijective_from(subject.mesh, points(subject.mesh)));
    methods.push_back(bijective_from_stereographic());
    for(const Method& method : methods)
    {
      SCOPED_TRACE(method.name());
      const Images expected = run(method);
      test(method);
      EXPECT_TRUE(have_same_bits(run(method), expected)); // as good as new
    }
  }

  // Lets the caller's function throw at its calls, every `step`th of them; returns how many there are.
  std::size_t throw_everywhere(const Method& method, const Options& options, Countdown& countdown, std::size_t step)
  {
    countdown = Countdown();
    method.run(subject.mesh, options);
    const std::size_t n = countdown.n_calls;
    for(std::size_t k = 1; k <= n; k += step)
    {
      countdown = Countdown{k};
      subject.expect_no_trace_of<Interruption>([&] { return method.parameterize(subject.mesh, subject.map, options); });
      EXPECT_EQ(countdown.n_calls, k); // it is not called again
    }
    countdown = Countdown();
    return n;
  }

  Images run(const Method& method) const { return method.run(subject.mesh, options()).images; }

  static Options options() { return Options().iterations(3).sequential(); }
};

TEST_F(Exception_safety, of_the_visitor)
{
  Countdown countdown;
  Failing_visitor visitor(countdown);
  for_each_method([&](const Method& method) {
    const std::size_t n = throw_everywhere(method, options().visitor(visitor), countdown, stride);
    EXPECT_EQ(n >= 2, method.name() != "precomputed"); // it has none
  });
}

// Also within the descent over a level, which only larger surfaces have.
TEST(Exception_of_the_visitor, leaves_no_trace_of_a_larger_surface)
{
  const Subject subject{bumpy_sphere(5)}, other{bumpy_sphere(5)};
  Countdown countdown;
  Failing_visitor visitor(countdown);
  const Options options = Options().iterations(1).visitor(visitor);
  EXPECT_EQ(bijective().parameterize(other.mesh, other.map, options), SP::OK);
  const std::size_t n = countdown.n_calls;
  for(std::size_t k = 1; k <= n; k += (n + 29) / 30)
  {
    SCOPED_TRACE(k);
    countdown = Countdown();
    countdown.throw_at = k;
    subject.expect_no_trace_of<Interruption>(
        [&] { return bijective().parameterize(subject.mesh, subject.map, options); });
  }
}

TEST_F(Exception_safety, of_the_points)
{
  const Point_map surface(subject.mesh, points(subject.mesh));
  Countdown countdown;
  surface.on_get() = std::ref(countdown);
  for_each_method([&](const Method& method) {
    EXPECT_GE(throw_everywhere(method, options().points(surface), countdown, 7 * stride), subject.mesh.num_vertices());
  });
}

TEST_F(Exception_safety, of_every_allocation)
{
  for_each_method([&](const Method& method) {
    const Point_map other(subject.mesh, subject.untouched);
    const std::size_t n =
        allocation::number_of_requests_of([&] { return method.parameterize(subject.mesh, other, options()); });
    EXPECT_GT(n, 30u);
    // One request that fails, and memory that has run out for good: then the way back must not need any either.
    for(const bool is_for_good : {false, true})
      for(std::size_t k = 1; k <= n; k += stride)
      {
        SCOPED_TRACE(k);
        subject.expect_no_trace_of<std::bad_alloc>([&] {
          const allocation::Shortage shortage(k, is_for_good ? n : k);
          return method.parameterize(subject.mesh, subject.map, options());
        });
      }
  });
}

// Maps that throw when they are written, or read back: what has been written by then stays. The method does not matter but
// for what it promises.

TEST_F(Exception_safety, of_put_leaves_the_rest_of_the_map)
{
  for(const Method& method : {precomputed(subject.mesh, points(subject.mesh)), arap()})
  {
    const Images complete = run(method);
    Countdown countdown;
    subject.map.on_put() = std::ref(countdown);
    for(std::size_t k = 1; k <= subject.mesh.num_vertices(); ++k)
    {
      countdown = Countdown();
      for(const auto v : subject.mesh.vertices())
        put(subject.map, v, Point_3(7, 7, 7));
      countdown = Countdown{k};
      subject.expect_exception<Interruption>([&] { return method.parameterize(subject.mesh, subject.map, options()); });
      std::size_t n_written = 0;
      const Images result = images(subject.mesh, subject.map);
      for(std::size_t v = 0; v < result.size(); ++v)
      {
        const bool is_written = result[v] == complete[v];
        n_written += is_written;
        EXPECT_TRUE(is_written || result[v] == (Coordinates{7., 7., 7.}));
      }
      EXPECT_EQ(n_written, k - 1);
    }
    countdown = Countdown();
  }
}

TEST_F(Exception_safety, of_get_leaves_the_map_as_written)
{
  const Method method = precomputed(subject.mesh, points(subject.mesh));
  const Images complete = run(method);
  for(std::size_t k = 1; k <= subject.mesh.num_vertices(); ++k)
  {
    const Point_map map(subject.mesh, subject.untouched);
    Countdown countdown{k};
    map.on_get() = std::ref(countdown);
    subject.expect_exception<Interruption>([&] { return method.parameterize(subject.mesh, map, options()); });
    EXPECT_TRUE(have_same_bits(images(subject.mesh, map), complete));
  }
}

TEST_F(Exception_safety, of_measuring)
{
  const Mesh& mesh = subject.mesh;
  const Point_map map(mesh, points(mesh)), surface(mesh, points(mesh));
  Countdown countdown;
  map.on_get() = surface.on_get() = std::ref(countdown);
  const std::function<void()> functions[] = {
      [&] { EXPECT_TRUE(SP::is_bijective(mesh, map)); },
      [&] { EXPECT_NEAR(distortion_of(mesh, map).isometric.maximum, 1., 1e-12); },
      [&] { distortion_of(mesh, mesh.points(), params::vertex_point_map(surface)); }};
  for(const std::function<void()>& function : functions)
  {
    countdown = Countdown();
    const std::size_t n_allocations = allocation::number_of_requests_of(function);
    const std::size_t n_calls = countdown.n_calls;
    EXPECT_GE(n_calls, mesh.num_vertices());
    for(std::size_t k = 1; k <= n_calls; k += stride)
    {
      countdown = Countdown{k};
      subject.expect_exception<Interruption>(function);
    }
    for(std::size_t k = 1; k <= n_allocations; k += stride)
    {
      countdown = Countdown();
      subject.expect_exception<std::bad_alloc>([&] {
        const allocation::Shortage shortage(k, n_allocations);
        function();
      });
    }
    function();
  }
}

#ifdef CGAL_LINKED_WITH_TBB
class Exception_safety_in_parallel : public ::testing::Test
{
protected:
  // What TBB takes for itself once and keeps does not count, and it need not live with a shortage then.
  Exception_safety_in_parallel() { m_arena.initialize(); }

  // Runs the method in an arena of more threads than the machine may have.
  SP::Error_code run(const Method& method, int iterations)
  {
    SP::Error_code error = SP::OK;
    m_arena.execute([&] { error = method.parameterize(subject.mesh, subject.map, Options().iterations(iterations)); });
    return error;
  }

  void forget_images()
  {
    const Point_map untouched(subject.mesh, subject.untouched);
    for(const auto v : subject.mesh.vertices())
      put(subject.map, v, get(untouched, v));
  }

  Subject subject{bumpy_sphere(4)};

private:
  const tbb::global_control m_control{tbb::global_control::max_allowed_parallelism, 4};
  tbb::task_arena m_arena{4};
};

// Which request is the k-th one is left to chance when several threads make them.
TEST_F(Exception_safety_in_parallel, of_allocations)
{
  const Method method = bijective();
  EXPECT_EQ(run(method, 1), SP::OK);
  const Images expected = images(subject.mesh, subject.map);
  const std::size_t n = allocation::number_of_requests_of([&] { return run(method, 1); });
  for(std::size_t i = 0; i < test_scale::reduced(30); ++i)
  {
    const std::size_t k = 1 + i * i * i * n / 50000; // most of them early, none so late that there is no such request
    SCOPED_TRACE(k);
    forget_images();
    subject.expect_no_trace_of<std::bad_alloc>([&] {
      const allocation::Shortage shortage(k, 2 * n);
      return run(method, 1);
    });
  }
  EXPECT_EQ(run(method, 1), SP::OK);
  EXPECT_TRUE(have_same_bits(images(subject.mesh, subject.map), expected));
}

// An energy that throws on any thread but the caller's, once it has been evaluated so many times.
TEST_F(Exception_safety_in_parallel, of_the_energy_on_another_thread)
{
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> n_calls(0), n_before(0);
  const Method method("hooked", SP::Bijective_low_distortion_parameterizer_3().energy(Hooked_energy([&] {
    if(++n_calls > n_before && std::this_thread::get_id() != caller)
      throw Interruption();
  })));
  std::size_t n_caught = 0;
  EXPECT_EQ(run(bijective(), 1), SP::OK);
  for(std::size_t i = 0; i < test_scale::reduced(20); ++i)
  {
    SCOPED_TRACE(i);
    forget_images();
    n_calls = 0;
    n_before = 20000 * i;
    const std::ptrdiff_t n_blocks = allocation::number_of_blocks;
    try
    {
      EXPECT_EQ(run(method, 3), SP::OK); // where no other thread came to help in time, nothing was thrown
      EXPECT_TRUE(is_bijective(subject.mesh, images(subject.mesh, subject.map)));
    }
    catch(const Interruption&)
    {
      ++n_caught;
      EXPECT_EQ(allocation::number_of_blocks, n_blocks);
      EXPECT_TRUE(have_same_bits(images(subject.mesh, subject.map), subject.untouched));
    }
  }
  EXPECT_GT(n_caught, 0u);
}
#endif

} // namespace
