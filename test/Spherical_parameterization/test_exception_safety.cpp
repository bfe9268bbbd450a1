// An exception that is thrown at any point of a run, by the caller's visitor, by his property maps or for want of memory,
// arrives at the caller, and nothing else has happened: the mesh and the map are as they were, no memory is lost, and the
// parameterizer is as good as new.

#include <cstddef>
#include <cstring>

// Eigen takes its memory from malloc(), but asks its own assertion first.
namespace allocation {
void on_eigen_assertion(bool is_true, const char* text);
}
#define EIGEN_NO_MALLOC
#define eigen_assert(x) allocation::on_eigen_assertion(static_cast<bool>(x), #x)

#include <CGAL/spherical_parameterization.h>

#include "test_maps.h"
#include "test_meshes.h"
#include "test_scale.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace params = CGAL::parameters;

// ---------------------------------------------------------------------------------------------------------------------
// Memory that can be had to run out. All of this program goes through here.

namespace allocation {

std::atomic<std::size_t> number_of_requests(0), first_refused(0), last_refused(0), number_of_eigen_requests(0);
std::atomic<std::ptrdiff_t> number_of_blocks(0);

bool is_refused()
{
  const std::size_t k = ++number_of_requests;
  return k >= first_refused && k <= last_refused;
}

void* request(std::size_t size, std::size_t alignment)
{
  if(is_refused())
    return nullptr;
  size = (std::max)(size, std::size_t(1));
  void* const block = alignment == 0 ? std::malloc(size)
                                     : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if(block != nullptr)
    ++number_of_blocks;
  return block;
}

void* request_or_throw(std::size_t size, std::size_t alignment)
{
  void* const block = request(size, alignment);
  if(block == nullptr)
    throw std::bad_alloc();
  return block;
}

void release(void* block) noexcept
{
  if(block == nullptr)
    return;
  --number_of_blocks;
  std::free(block);
}

void on_eigen_assertion(bool is_true, const char* text)
{
  if(is_true)
    return;
  if(std::strstr(text, "EIGEN_NO_MALLOC") == nullptr)
    throw std::logic_error(text);
  ++number_of_eigen_requests;
  if(is_refused())
    throw std::bad_alloc();
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

} // namespace allocation

void* operator new(std::size_t size)
{
  return allocation::request_or_throw(size, 0);
}
void* operator new[](std::size_t size)
{
  return allocation::request_or_throw(size, 0);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return allocation::request_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment)
{
  return allocation::request_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return allocation::request(size, 0);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return allocation::request(size, 0);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return allocation::request(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
  return allocation::request(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept
{
  allocation::release(block);
}
void operator delete[](void* block) noexcept
{
  allocation::release(block);
}
void operator delete(void* block, std::size_t) noexcept
{
  allocation::release(block);
}
void operator delete[](void* block, std::size_t) noexcept
{
  allocation::release(block);
}
void operator delete(void* block, std::align_val_t) noexcept
{
  allocation::release(block);
}
void operator delete[](void* block, std::align_val_t) noexcept
{
  allocation::release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept
{
  allocation::release(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept
{
  allocation::release(block);
}
void operator delete(void* block, const std::nothrow_t&) noexcept
{
  allocation::release(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept
{
  allocation::release(block);
}
void operator delete(void* block, std::align_val_t, const std::nothrow_t&) noexcept
{
  allocation::release(block);
}
void operator delete[](void* block, std::align_val_t, const std::nothrow_t&) noexcept
{
  allocation::release(block);
}

namespace {

using test_meshes::Coordinates;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Sphere_map = Mesh::Property_map<Vertex, Point_3>;

// ---------------------------------------------------------------------------------------------------------------------
// What throws.

// what the caller's own functions throw: nothing that the library could know
struct Interruption
{
  std::size_t number;
};

// Throws when it is called the `throw_at`th time, or ever after as well.
struct Countdown
{
  void tick()
  {
    ++n_calls;
    if(n_calls == throw_at || (is_for_good && n_calls > throw_at))
      throw Interruption{n_calls};
  }

  std::size_t throw_at = 0, n_calls = 0;
  bool is_for_good = false;
};

class Failing_visitor
{
public:
  explicit Failing_visitor(Countdown& countdown)
    : m_countdown(countdown)
  {}

  void on_initialization_begin(std::size_t) { m_countdown.tick(); }
  void on_level(std::size_t) { m_countdown.tick(); }
  void on_initialization_end() { m_countdown.tick(); }
  void after_iteration(std::size_t, double, double) { m_countdown.tick(); }
  bool go_further(std::size_t, double)
  {
    m_countdown.tick();
    return true;
  }
  void on_optimization_end() { m_countdown.tick(); }

private:
  Countdown& m_countdown;
};

// when the functions of a property map throw
struct Map_failures
{
  Countdown get, put, put_has_written; // put() throws before or after it has written
};

// A property map over another one that throws.
template <class Base>
struct Failing_map
{
  using key_type = typename boost::property_traits<Base>::key_type;
  using value_type = typename boost::property_traits<Base>::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  friend value_type get(const Failing_map& map, const key_type& key)
  {
    map.failures->get.tick();
    return get(map.base, key);
  }

  friend void put(const Failing_map& map, const key_type& key, const value_type& value)
  {
    map.failures->put.tick();
    put(map.base, key, value);
    map.failures->put_has_written.tick();
  }

  Base base;
  Map_failures* failures;
};

template <class Base>
Failing_map<Base> make_failing_map(const Base& base, Map_failures& failures)
{
  return {base, &failures};
}

// A property map that can be written, but not read.
template <class Key, class Value>
struct Failing_output
{
  using key_type = Key;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;

  friend void put(const Failing_output& map, const Key& key, const Value& value)
  {
    map.countdown->tick();
    map.values->at(key) = value;
  }

  std::vector<Value>* values;
  Countdown* countdown;
};

// ---------------------------------------------------------------------------------------------------------------------
// What must not change.

struct Mesh_state
{
  explicit Mesh_state(const Mesh& mesh)
    : points(test_maps::images(mesh, mesh.points()))
    , numbers({mesh.num_vertices(), mesh.num_halfedges(), mesh.num_faces(), mesh.has_garbage() ? 1u : 0u})
  {
    for(const auto h : mesh.halfedges())
      for(const std::size_t number : {std::size_t(mesh.target(h)), std::size_t(mesh.next(h)),
                                      std::size_t(mesh.opposite(h)), std::size_t(mesh.face(h))})
        numbers.push_back(number);
    for(const auto v : mesh.vertices())
      numbers.push_back(mesh.halfedge(v));
    for(const auto& names : {mesh.properties<Vertex>(), mesh.properties<Mesh::Halfedge_index>(),
                             mesh.properties<Mesh::Edge_index>(), mesh.properties<Mesh::Face_index>()})
    {
      properties.insert(properties.end(), names.begin(), names.end());
      properties.push_back(std::string());
    }
  }

  bool operator==(const Mesh_state& other) const
  {
    return test_maps::have_same_bits(points, other.points) && numbers == other.numbers &&
           properties == other.properties;
  }

  std::vector<Coordinates> points;
  std::vector<std::size_t> numbers;
  std::vector<std::string> properties;
};

// A small mesh with a map that can be told from any that is written, and the checks that both are left alone.
class Subject
{
public:
  explicit Subject(const test_meshes::Triangle_list& list)
    : mesh(test_meshes::make_mesh<Mesh>(list))
    , sphere(mesh.add_property_map<Vertex, Point_3>("v:sphere").first)
    , m_sentinels(test_maps::images(mesh, test_maps::make_sentinel_map<Point_3>(mesh)))
    , m_state(mesh)
  {
    forget_images();
  }

  void forget_images()
  {
    std::size_t i = 0;
    for(const Vertex v : mesh.vertices())
    {
      sphere[v] = Point_3(m_sentinels[i][0], m_sentinels[i][1], m_sentinels[i][2]);
      ++i;
    }
  }

  std::vector<Coordinates> images() const { return test_maps::images(mesh, sphere); }

  const std::vector<Coordinates>& sentinels() const { return m_sentinels; }

  // Calls `run`, which is to throw an Exception, and nothing else is to happen.
  template <class Exception, class Run>
  void expect_no_trace_of(const Run& run) const
  {
    const std::ptrdiff_t n_blocks = allocation::number_of_blocks;
    bool is_caught = false;
    try
    {
      run();
    }
    catch(const Exception&)
    {
      is_caught = true;
    }
    EXPECT_EQ(allocation::number_of_blocks, n_blocks) << "memory was lost";
    EXPECT_TRUE(is_caught) << "the exception did not arrive";
    EXPECT_TRUE(test_maps::have_same_bits(images(), m_sentinels)) << "the map has changed";
    EXPECT_TRUE(Mesh_state(mesh) == m_state) << "the mesh has changed";
  }

  Mesh mesh;
  Sphere_map sphere;

private:
  std::vector<Coordinates> m_sentinels;
  Mesh_state m_state;
};

// every how many of the points where a run can fail it does
constexpr std::size_t stride = test_scale::is_slow ? 7 : 1;

// ---------------------------------------------------------------------------------------------------------------------
// Every parameterizer.

using Bijective = SP::Bijective_low_distortion_parameterizer_3<Mesh>;
using Own_map = std::decay_t<decltype(std::declval<Mesh&>().points())>;
using Precomputed = SP::Precomputed_parameterizer_3<Mesh, Own_map>;
using From_precomputed = SP::Bijective_low_distortion_parameterizer_3<Mesh, Precomputed>;

template <class Method>
class Exception_safety : public ::testing::Test
{
protected:
  // The surface is star-shaped about the origin, so that it is a map to start from itself.
  Subject subject{test_meshes::bumpy_sphere(1)};
  Method method = make_method<Method>(subject.mesh);

  template <class ConcurrencyTag = CGAL::Sequential_tag, class Map, class NamedParameters>
  SP::Error_code parameterize(const Map& map, const NamedParameters& np)
  {
    return SP::parameterize<ConcurrencyTag>(std::as_const(subject.mesh), method, map, np.number_of_iterations(3u));
  }

  template <class NamedParameters>
  std::vector<Coordinates> images_of(const NamedParameters& np)
  {
    EXPECT_EQ(parameterize(subject.sphere, np), SP::OK);
    const std::vector<Coordinates> result = subject.images();
    subject.forget_images();
    return result;
  }

  std::vector<Coordinates> images() { return images_of(params::default_values()); }

private:
  template <class M>
  static M make_method(const Mesh& mesh)
  {
    if constexpr(std::is_same<M, Precomputed>::value)
      return M(mesh.points());
    else if constexpr(std::is_same<M, From_precomputed>::value)
      return M(Precomputed(mesh.points()));
    else
      return M();
  }
};

using Methods =
    ::testing::Types<Bijective, SP::Hierarchical_parameterizer_3<Mesh>, SP::Stereographic_parameterizer_3<Mesh>,
                     SP::Harmonic_parameterizer_3<Mesh>, SP::Conformal_parameterizer_3<Mesh>,
                     SP::ARAP_parameterizer_3<Mesh>, SP::Published_low_distortion_parameterizer_3<Mesh>, Precomputed,
                     SP::Bijective_low_distortion_parameterizer_3<Mesh, SP::Stereographic_parameterizer_3<Mesh>>,
                     From_precomputed>;
TYPED_TEST_SUITE(Exception_safety, Methods, ); // without the last comma, Clang is pedantic about the macro

TYPED_TEST(Exception_safety, of_the_visitor)
{
  const std::vector<Coordinates> expected = this->images();
  Countdown countdown;
  Failing_visitor visitor(countdown);
  const auto np = params::visitor(std::ref(visitor));
  this->images_of(np);
  const std::size_t n = countdown.n_calls;
  if(std::is_same<TypeParam, Precomputed>::value)
    EXPECT_EQ(n, 0u); // it has none
  else
    EXPECT_GE(n, 2u);
  for(std::size_t k = 1; k <= n; k += stride)
  {
    SCOPED_TRACE(k);
    countdown = Countdown{k};
    this->subject.template expect_no_trace_of<Interruption>([&] { this->parameterize(this->subject.sphere, np); });
    EXPECT_EQ(countdown.n_calls, k); // it is not called again
    EXPECT_TRUE(test_maps::have_same_bits(this->images(), expected));
  }
}

TYPED_TEST(Exception_safety, of_the_points)
{
  const std::vector<Coordinates> expected = this->images();
  Map_failures failures;
  const auto np = params::vertex_point_map(make_failing_map(this->subject.mesh.points(), failures));
  this->images_of(np);
  const std::size_t n = failures.get.n_calls;
  EXPECT_GE(n, this->subject.mesh.num_vertices());
  for(std::size_t k = 1; k <= n; k += stride)
  {
    SCOPED_TRACE(k);
    failures.get = Countdown{k};
    this->subject.template expect_no_trace_of<Interruption>([&] { this->parameterize(this->subject.sphere, np); });
    EXPECT_TRUE(test_maps::have_same_bits(this->images(), expected));
  }
}

TYPED_TEST(Exception_safety, of_the_images)
{
  const std::vector<Coordinates> expected = this->images();
  Map_failures failures;
  const auto map = make_failing_map(this->subject.sphere, failures);
  const auto np = params::default_values();
  ASSERT_EQ(this->parameterize(map, np), SP::OK);
  this->subject.forget_images();
  EXPECT_EQ(failures.put.n_calls, this->subject.mesh.num_vertices()); // each vertex is written once
  for(Countdown Map_failures::*function : {&Map_failures::get, &Map_failures::put, &Map_failures::put_has_written})
  {
    failures = Map_failures();
    ASSERT_EQ(this->parameterize(map, np), SP::OK);
    this->subject.forget_images();
    const std::size_t n = (failures.*function).n_calls;
    for(std::size_t k = 1; k <= n; k += stride)
    {
      SCOPED_TRACE(k);
      failures = Map_failures();
      (failures.*function).throw_at = k;
      this->subject.template expect_no_trace_of<Interruption>([&] { this->parameterize(map, np); });
      EXPECT_TRUE(test_maps::have_same_bits(this->images(), expected));
    }
  }
}

TYPED_TEST(Exception_safety, of_every_allocation)
{
  const std::vector<Coordinates> expected = this->images();
  const auto run = [&] { return this->parameterize(this->subject.sphere, params::default_values()); };
  std::size_t n = 0;
  {
    allocation::number_of_eigen_requests = 0;
    const allocation::Shortage none(0, 0);
    ASSERT_EQ(run(), SP::OK);
    n = allocation::number_of_requests;
    std::cout << "  " << n << " allocations, " << allocation::number_of_eigen_requests << " of them by Eigen"
              << std::endl;
  }
  const bool uses_eigen = std::is_same<TypeParam, SP::Stereographic_parameterizer_3<Mesh>>::value;
  EXPECT_TRUE(!uses_eigen || allocation::number_of_eigen_requests > 0u); // else its assertion was defined too late
  this->subject.forget_images();
  EXPECT_GT(n, (std::is_same<TypeParam, Precomputed>::value ? 30u : 50u));
  // One request that fails, and memory that has run out for good: then the way back must not need any either.
  for(const bool is_for_good : {false, true})
    for(std::size_t k = 1; k <= n; k += stride)
    {
      SCOPED_TRACE(k);
      this->subject.template expect_no_trace_of<std::bad_alloc>([&] {
        const allocation::Shortage shortage(k, is_for_good ? n : k);
        run();
      });
      ASSERT_TRUE(test_maps::have_same_bits(this->images(), expected));
    }
  // one more than there are
  const allocation::Shortage shortage(n + 1, n + 1);
  EXPECT_EQ(run(), SP::OK);
}

// ---------------------------------------------------------------------------------------------------------------------
// Every kind of map that is written. Which method it is does not matter: the quickest is taken.

class Exception_safety_of_maps : public ::testing::Test
{
protected:
  Subject subject{test_meshes::bumpy_sphere(1)};
  const Mesh& mesh = subject.mesh;
  Precomputed method = Precomputed(subject.mesh.points());

  // Lets each function of a map that is filled throw in turn: the values are the former ones then.
  template <class Map>
  void expect_strong_guarantee(const Map& map)
  {
    const auto fill = [&] {
      std::size_t i = 0;
      for(const Vertex v : mesh.vertices())
      {
        const Coordinates& p = subject.sentinels()[i++];
        put(map, v, Point_3(p[0], p[1], p[2]));
      }
    };
    for(Countdown Map_failures::*function : {&Map_failures::get, &Map_failures::put, &Map_failures::put_has_written})
    {
      // A value is read before it is overwritten, and when all are there.
      const std::size_t n_calls = (function == &Map_failures::get ? 2 : 1) * mesh.num_vertices();
      for(std::size_t k = 1; k <= n_calls; ++k)
      {
        SCOPED_TRACE(k);
        fill();
        Map_failures failures;
        (failures.*function).throw_at = k;
        subject.expect_no_trace_of<Interruption>(
            [&] { SP::parameterize<CGAL::Sequential_tag>(mesh, method, make_failing_map(map, failures)); });
        EXPECT_TRUE(test_maps::have_same_bits(test_maps::images(mesh, map), subject.sentinels()));
      }
    }
    EXPECT_EQ(SP::parameterize<CGAL::Sequential_tag>(mesh, method, map), SP::OK);
    EXPECT_TRUE(SP::is_bijective(mesh, map));
  }
};

TEST_F(Exception_safety_of_maps, in_the_mesh)
{
  expect_strong_guarantee(subject.sphere);
}

// keeps multiples of 10 only, so that the map folds
struct Coarse_map
{
  using key_type = Vertex;
  using value_type = Point_3;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  friend value_type get(const Coarse_map& map, const key_type& key) { return map.values->at(key); }
  friend void put(const Coarse_map& map, const key_type& key, const value_type& p)
  {
    const auto rounded = [](double x) { return 10. * std::round(0.1 * x); };
    map.values->at(key) = Point_3(rounded(p.x()), rounded(p.y()), rounded(p.z()));
  }

  std::vector<Point_3>* values;
};

// The map is found not to be one-to-one when it has been written, and a value cannot be put back: all others are.
TEST_F(Exception_safety_of_maps, when_values_are_put_back)
{
  const std::size_t n = mesh.num_vertices();
  const std::vector<Point_3> before(n, Point_3(70., 80., 90.));
  for(std::size_t k = 0; k <= n; ++k)
  {
    SCOPED_TRACE(k);
    std::vector<Point_3> values = before;
    Map_failures failures;
    failures.put.throw_at = n + k;
    const auto map = make_failing_map(Coarse_map{&values}, failures);
    const auto run = [&] { return SP::parameterize<CGAL::Sequential_tag>(mesh, method, map); };
    if(k == 0) // the last one that is written
    {
      EXPECT_THROW(run(), Interruption);
      EXPECT_EQ(values, before);
      continue;
    }
    EXPECT_THROW(run(), Interruption);
    EXPECT_EQ(std::count(values.begin(), values.end(), before.front()), static_cast<std::ptrdiff_t>(n - 1));
    EXPECT_EQ(failures.put.n_calls, 2 * n);
  }
  std::vector<Point_3> values = before;
  EXPECT_EQ(SP::parameterize<CGAL::Sequential_tag>(mesh, method, Coarse_map{&values}),
            SP::ERROR_INSUFFICIENT_PRECISION);
  EXPECT_EQ(values, before);
}

TEST_F(Exception_safety_of_maps, in_a_tree)
{
  std::map<Vertex, Point_3> points;
  expect_strong_guarantee(boost::associative_property_map<std::map<Vertex, Point_3>>(points));
}

TEST_F(Exception_safety_of_maps, in_an_array)
{
  std::vector<Point_3> points(mesh.num_vertices());
  expect_strong_guarantee(boost::make_iterator_property_map(points.begin(), get(boost::vertex_index, mesh)));
}

TEST_F(Exception_safety_of_maps, made_for_the_purpose)
{
  expect_strong_guarantee(get(CGAL::dynamic_vertex_property_t<Point_3>(), mesh));
}

// What folds is written by methods that promise no bijection, and put back as well.
TEST_F(Exception_safety_of_maps, that_fold)
{
  Subject spiky(test_meshes::random_stacked_sphere(300, 7));
  SP::Conformal_parameterizer_3<Mesh> conformal;
  for(std::size_t k : {std::size_t(1), std::size_t(150), spiky.mesh.num_vertices() + std::size_t(0)})
  {
    Map_failures failures;
    failures.put_has_written.throw_at = k;
    spiky.expect_no_trace_of<Interruption>([&] {
      SP::parameterize<CGAL::Sequential_tag>(std::as_const(spiky.mesh), conformal,
                                             make_failing_map(spiky.sphere, failures));
    });
  }
  EXPECT_EQ(SP::parameterize<CGAL::Sequential_tag>(std::as_const(spiky.mesh), conformal, spiky.sphere),
            SP::ERROR_NO_1_TO_1_MAPPING);
}

// One key that accepts no value at all, its former one included.
struct Map_with_a_bad_key
{
  using key_type = Vertex;
  using value_type = Point_3;
  using reference = const Point_3&;
  using category = boost::read_write_property_map_tag;

  friend reference get(const Map_with_a_bad_key& map, Vertex v) { return (*map.points)[std::size_t(v)]; }
  friend void put(const Map_with_a_bad_key& map, Vertex v, const Point_3& p)
  {
    if(v == map.bad_key)
      throw Interruption{std::size_t(v)};
    (*map.points)[std::size_t(v)] = p;
  }

  std::vector<Point_3>* points;
  Vertex bad_key;
};

// What can be put back is put back.
TEST_F(Exception_safety_of_maps, with_a_key_that_refuses_every_value)
{
  const std::vector<Point_3> former(mesh.num_vertices(), Point_3(7, 7, 7));
  for(const Vertex v : mesh.vertices())
  {
    std::vector<Point_3> points = former;
    EXPECT_THROW(SP::parameterize<CGAL::Sequential_tag>(mesh, method, Map_with_a_bad_key{&points, v}), Interruption);
    EXPECT_EQ(points, former) << v;
  }
}

// Where a map cannot be read, or refuses to be put back, there is nothing to save but the memory.
TEST_F(Exception_safety_of_maps, that_cannot_be_restored)
{
  std::vector<Point_3> points(mesh.num_vertices());
  Countdown countdown;
  for(std::size_t k = 1; k <= mesh.num_vertices(); ++k)
  {
    SCOPED_TRACE(k);
    const Point_3 none(7, 7, 7);
    std::fill(points.begin(), points.end(), none);
    countdown = Countdown{k};
    subject.expect_no_trace_of<Interruption>([&] {
      SP::parameterize<CGAL::Sequential_tag>(mesh, method, Failing_output<Vertex, Point_3>{&points, &countdown});
    });
    EXPECT_EQ(std::count(points.begin(), points.end(), none), static_cast<std::ptrdiff_t>(points.size() - (k - 1)));

    Map_failures failures;
    failures.put = Countdown{k, 0, true};
    const auto map = boost::make_iterator_property_map(points.begin(), get(boost::vertex_index, mesh));
    subject.expect_no_trace_of<Interruption>(
        [&] { SP::parameterize<CGAL::Sequential_tag>(mesh, method, make_failing_map(map, failures)); });
  }
  countdown = Countdown();
  EXPECT_EQ(SP::parameterize<CGAL::Sequential_tag>(mesh, method, Failing_output<Vertex, Point_3>{&points, &countdown}),
            SP::OK);
}

// ---------------------------------------------------------------------------------------------------------------------
// The functions that only measure.

class Exception_safety_of_measuring : public ::testing::Test
{
protected:
  Subject subject{test_meshes::bumpy_sphere(1)};
  const Mesh& mesh = subject.mesh;

  // Lets the countdown stop `run` at each of its steps, and each allocation fail.
  template <class Run>
  void expect_no_trace(Countdown& countdown, const Run& run)
  {
    countdown = Countdown();
    std::size_t n_allocations = 0;
    {
      const allocation::Shortage none(0, 0);
      run();
      n_allocations = allocation::number_of_requests;
    }
    const std::size_t n_calls = countdown.n_calls;
    EXPECT_GE(n_calls, mesh.num_vertices());
    for(std::size_t k = 1; k <= n_calls; ++k)
    {
      SCOPED_TRACE(k);
      countdown = Countdown{k};
      subject.expect_no_trace_of<Interruption>(run);
      countdown = Countdown();
      run();
    }
    for(std::size_t k = 1; k <= n_allocations; ++k)
    {
      SCOPED_TRACE(k);
      subject.expect_no_trace_of<std::bad_alloc>([&] {
        const allocation::Shortage shortage(k, n_allocations);
        run();
      });
      run();
    }
  }
};

TEST_F(Exception_safety_of_measuring, the_certificate)
{
  Map_failures failures;
  const auto map = make_failing_map(mesh.points(), failures);
  expect_no_trace(failures.get, [&] { EXPECT_TRUE(SP::is_bijective(mesh, map)); });
}

TEST_F(Exception_safety_of_measuring, the_distortion)
{
  Map_failures failures;
  const auto map = make_failing_map(mesh.points(), failures);
  const auto own_map = mesh.points();
  const auto measure = [&](const auto& sphere, const auto& points) {
    EXPECT_NEAR(SP::measure_distortion(mesh, sphere, params::vertex_point_map(points)).isometric.maximum, 1., 1e-12);
  };
  expect_no_trace(failures.get, [&] { measure(map, own_map); });
  expect_no_trace(failures.get, [&] { measure(own_map, map); });

  std::vector<SP::Face_distortion> distortions(mesh.num_faces());
  Countdown countdown;
  const Failing_output<Mesh::Face_index, SP::Face_distortion> output{&distortions, &countdown};
  expect_no_trace(countdown, [&] { SP::measure_distortion(mesh, own_map, output); });
}

// ---------------------------------------------------------------------------------------------------------------------

#ifdef CGAL_LINKED_WITH_TBB
// A vertex update that throws on any thread but the caller's, once so many vertices have been moved.
class Failing_update : public SP::Newton_update_3
{
public:
  Failing_update(std::atomic<std::size_t>& n_calls, std::size_t n_before)
    : m_n_calls(n_calls)
    , m_n_before(n_before)
  {}

  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const
  {
    const std::size_t k = ++m_n_calls;
    if(k > m_n_before && std::this_thread::get_id() != m_caller)
      throw Interruption{k};
    return SP::Newton_update_3::operator()(energy, step);
  }

private:
  std::atomic<std::size_t>& m_n_calls;
  std::size_t m_n_before;
  std::thread::id m_caller = std::this_thread::get_id();
};

// An energy that throws when it is evaluated the `throw_at`th time for a single face: where several are in one call, only
// the search for the worst faces does that, which goes on beside a sweep.
class Failing_energy : public SP::Symmetric_Dirichlet_energy_3
{
public:
  Failing_energy(std::atomic<std::size_t>& n_calls, std::size_t throw_at)
    : m_n_calls(n_calls)
    , m_throw_at(throw_at)
  {}

  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    if constexpr(std::is_same<FT, double>::value)
    {
      const std::size_t k = ++m_n_calls;
      if(k == m_throw_at)
        throw Interruption{k};
    }
    return SP::Symmetric_Dirichlet_energy_3::operator()(i, d);
  }

private:
  std::atomic<std::size_t>& m_n_calls;
  std::size_t m_throw_at;
};

class Exception_safety_in_parallel : public ::testing::Test
{
protected:
  // What TBB takes for itself once and keeps does not count, and it need not live with a shortage then.
  Exception_safety_in_parallel() { m_arena.initialize(); }

  // Calls f in an arena of more threads than the machine may have.
  template <class Function>
  void execute(const Function& f)
  {
    m_arena.execute(f);
  }

private:
  const tbb::global_control m_control{tbb::global_control::max_allowed_parallelism, 4};
  tbb::task_arena m_arena{4};
};

// Which request is the k-th one is left to chance when several threads make them.
TEST_F(Exception_safety_in_parallel, of_allocations)
{
  Subject subject(test_meshes::bumpy_sphere(3)); // just large enough for its levels to be mapped in parallel
  Bijective method;
  const auto run = [&] {
    execute([&] {
      EXPECT_EQ(SP::parameterize<CGAL::Parallel_tag>(std::as_const(subject.mesh), method, subject.sphere,
                                                     params::number_of_iterations(1u)),
                SP::OK);
    });
  };
  run();
  const std::vector<Coordinates> expected = subject.images();
  std::size_t n = 0;
  {
    const allocation::Shortage none(0, 0);
    run();
    n = allocation::number_of_requests;
  }
  for(std::size_t i = 0; i < test_scale::reduced(40); ++i)
  {
    const std::size_t k = 1 + i * i * i * n / 100000; // most of them early, none so late that there is no such request
    SCOPED_TRACE(k);
    subject.forget_images();
    subject.expect_no_trace_of<std::bad_alloc>([&] {
      const allocation::Shortage shortage(k, 2 * n);
      run();
    });
    run();
    ASSERT_TRUE(test_maps::have_same_bits(subject.images(), expected));
  }
}

TEST_F(Exception_safety_in_parallel, of_another_thread)
{
  using Method = SP::Bijective_low_distortion_parameterizer_3<Mesh, Precomputed, CGAL::Default, CGAL::Default,
                                                              CGAL::Default, Failing_update>;
  Subject subject(test_meshes::bumpy_sphere(5));
  const Precomputed start(subject.mesh.points());
  std::size_t n_caught = 0;
  SP::parameterize<CGAL::Parallel_tag>(std::as_const(subject.mesh), Bijective(), subject.sphere);
  subject.forget_images();
  for(std::size_t i = 0; i < test_scale::reduced(20); ++i)
  {
    SCOPED_TRACE(i);
    const std::ptrdiff_t n_blocks = allocation::number_of_blocks;
    SP::Error_code error = SP::OK;
    bool is_caught = false;
    try
    {
      execute([&] {
        std::atomic<std::size_t> n_calls(0);
        Method method(start, SP::Symmetric_Dirichlet_energy_3(), SP::Relative_sharpness_3(), SP::Two_phase_radius_3<>(),
                      Failing_update(n_calls, 1000 * i));
        error = SP::parameterize<CGAL::Parallel_tag>(std::as_const(subject.mesh), method, subject.sphere,
                                                     params::number_of_iterations(3u));
      });
    }
    catch(const Interruption&)
    {
      is_caught = true;
    }
    EXPECT_EQ(error, SP::OK); // where no other thread came to help in time, nothing was thrown
    EXPECT_EQ(allocation::number_of_blocks, n_blocks);
    EXPECT_EQ(test_maps::have_same_bits(subject.images(), subject.sentinels()), is_caught);
    EXPECT_TRUE(is_caught || SP::is_bijective(subject.mesh, subject.sphere));
    subject.forget_images();
    n_caught += is_caught;
  }
  EXPECT_GT(n_caught, 0u);
}

TEST_F(Exception_safety_in_parallel, of_the_search_for_the_worst_faces)
{
  using Method = SP::Bijective_low_distortion_parameterizer_3<Mesh, Precomputed, Failing_energy>;
  Subject subject(test_meshes::bumpy_sphere(4));
  const Precomputed start(subject.mesh.points());
  std::size_t n_calls = 0;
  const auto run = [&](std::size_t throw_at) {
    execute([&] {
      std::atomic<std::size_t> n(0);
      Method method(start, Failing_energy(n, throw_at));
      EXPECT_EQ(SP::parameterize<CGAL::Parallel_tag>(std::as_const(subject.mesh), method, subject.sphere,
                                                     params::number_of_iterations(5u)),
                SP::OK);
      n_calls = n;
    });
  };
  run(0);
  ASSERT_GT(n_calls, 0u);
  const std::vector<Coordinates> expected = subject.images();
  const std::size_t n_samples = test_scale::reduced(20);
  for(std::size_t i = 0; i <= n_samples; ++i)
  {
    const std::size_t k = 1 + i * (n_calls - 1) / n_samples;
    SCOPED_TRACE(k);
    subject.forget_images();
    subject.expect_no_trace_of<Interruption>([&] { run(k); });
  }
  run(0);
  EXPECT_TRUE(test_maps::have_same_bits(subject.images(), expected));
}
#endif

} // namespace
