#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_METHODS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_METHODS_H

// Every parameterizer behind one type, on one type of mesh, with one type of property map and of visitor: what is to be said
// of all of them is a loop, and each is compiled once (methods.cpp). A run is checked on the way for all that every run
// promises.

#include "images.h"

#include <CGAL/spherical_parameterization.h>
#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

namespace test {

namespace SP = CGAL::Spherical_parameterization;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// SphericalParameterizationVisitor with virtual functions.
struct Visitor
{
  virtual ~Visitor() = default;
  virtual void on_initialization_begin(std::size_t) {}
  virtual void on_level(std::size_t) {}
  virtual void on_initialization_end() {}
  virtual void after_iteration(std::size_t, double, double) {}
  virtual bool go_further(std::size_t, double) { return true; }
  virtual void on_optimization_end() {}
};

// Stores what is reported to it, and stops when it is asked the `stop_at`th time.
struct Recorder : Visitor
{
  explicit Recorder(std::size_t n = 0)
    : stop_at(n)
  {}

  struct Event
  {
    std::string name;
    std::size_t number = 0;
    double energy = 0., radius = 0.;
  };

  void on_initialization_begin(std::size_t n) override { events.push_back({"initialization_begin", n}); }
  void on_level(std::size_t n) override { events.push_back({"level", n}); }
  void on_initialization_end() override { events.push_back({"initialization_end"}); }
  void after_iteration(std::size_t i, double energy, double radius) override
  {
    events.push_back({"iteration", i, energy, radius});
  }
  bool go_further(std::size_t i, double energy) override
  {
    events.push_back({"question", i, energy});
    return ++number_of_questions != stop_at;
  }
  void on_optimization_end() override { events.push_back({"optimization_end"}); }

  std::vector<Event> all(const std::string& name) const
  {
    std::vector<Event> result;
    for(const Event& event : events)
      if(event.name == name)
        result.push_back(event);
    return result;
  }

  std::size_t stop_at, number_of_questions = 0;
  std::vector<Event> events;
};

// A property map from the vertices of a mesh to points in an array that its copies share, for reading and writing. What
// happens in both, a test may change.
class Point_map
{
public:
  using key_type = Mesh::Vertex_index;
  using value_type = Point_3;
  using reference = Point_3;
  using category = boost::read_write_property_map_tag;

  Point_map(const Mesh& mesh, const Images& images);

  friend Point_3 get(const Point_map& map, key_type v)
  {
    if(map.m_data->on_get)
      map.m_data->on_get();
    return map.m_data->points[v];
  }

  friend void put(const Point_map& map, key_type v, const Point_3& p)
  {
    if(map.m_data->on_put)
      map.m_data->on_put();
    map.m_data->points[v] = map.m_data->stored ? map.m_data->stored(p) : p;
  }

  std::function<void()>& on_get() const { return m_data->on_get; }
  std::function<void()>& on_put() const { return m_data->on_put; }
  std::function<Point_3(const Point_3&)>& stored() const { return m_data->stored; }

private:
  struct Data
  {
    std::vector<Point_3> points;
    std::function<void()> on_get, on_put;
    std::function<Point_3(const Point_3&)> stored;
  };
  std::shared_ptr<Data> m_data;
};

// A map that takes a number of values only.
template <class Key, class Value>
struct Full_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;
  std::size_t* n_left;

  friend void put(const Full_map& map, Key, const Value&)
  {
    if(*map.n_left == 0)
      throw std::length_error("full");
    --*map.n_left;
  }
};

// The named parameters of a run.
class Options
{
public:
  Options& iterations(int n) { return m_iterations = n, *this; }
  Options& seconds(double s) { return m_seconds = s, *this; }
  Options& visitor(Visitor& v) { return m_visitor = &v, *this; }
  Options& points(const Point_map& map) { return m_points = map, *this; }
  Options& sequential() { return m_is_parallel = false, *this; }

private:
  friend class Method;
  std::optional<int> m_iterations;
  std::optional<Point_map> m_points;
  double m_seconds = 0.;
  Visitor* m_visitor = nullptr;
  bool m_is_parallel = true;
};

struct Result
{
  SP::Error_code error;
  SP::Parameterization_report report;
  Images images;
  SP::Distortion_summary distortion; // if a map has been written
};

// A parameterizer of any type.
class Method
{
public:
  template <class Parameterizer>
  Method(const std::string& name, const Parameterizer& parameterizer, bool may_fold = false)
    : m_name(name)
    , m_may_fold(may_fold)
    , m_model(std::make_shared<Model<Parameterizer>>(parameterizer))
  {}

  const std::string& name() const { return m_name; }
  bool may_fold() const { return m_may_fold; } // it promises no bijection
  const SP::Parameterization_report& report() const { return m_model->report(); }

  SP::Error_code parameterize(const Mesh& mesh, const Point_map& map, const Options& options = Options()) const;

  // Whatever comes out is sound: a bijection and OK, a map that folds and ERROR_NO_1_TO_1_MAPPING if the method may fold, or
  // another code and an untouched map.
  Result run(const Mesh& mesh, const Options& options = Options()) const;
  Result run(const Triangle_list& list, const Options& options = Options()) const;

private:
  struct Parameters
  {
    const Point_map& points;
    double seconds;
    std::reference_wrapper<Visitor> visitor;
    std::optional<int> iterations;
    bool is_parallel;
  };

  struct Interface
  {
    virtual ~Interface() = default;
    virtual SP::Error_code parameterize(const Mesh&, const Point_map&, const Parameters&) = 0;
    virtual const SP::Parameterization_report& report() const = 0;
  };

  template <class Parameterizer>
  struct Model : Interface
  {
    explicit Model(const Parameterizer& p)
      : parameterizer(p)
    {}

    template <class NamedParameters>
    SP::Error_code parameterize(const Mesh& mesh, const Point_map& map, bool is_parallel, const NamedParameters& np)
    {
      return is_parallel ? parameterizer.template parameterize<CGAL::Parallel_if_available_tag>(mesh, map, np)
                         : parameterizer.template parameterize<CGAL::Sequential_tag>(mesh, map, np);
    }

    SP::Error_code parameterize(const Mesh& mesh, const Point_map& map, const Parameters& p) override
    {
      const auto np = CGAL::parameters::vertex_point_map(p.points).maximum_running_time(p.seconds).visitor(p.visitor);
      return p.iterations ? parameterize(mesh, map, p.is_parallel, np.number_of_iterations(*p.iterations))
                          : parameterize(mesh, map, p.is_parallel, np);
    }

    const SP::Parameterization_report& report() const override { return parameterizer.report(); }

    Parameterizer parameterizer;
  };

  std::string m_name;
  bool m_may_fold;
  std::shared_ptr<Interface> m_model;
};

// The methods of the package with their default settings.
Method bijective();
Method hierarchical();
Method published();
Method stereographic();
Method schnyder();
Method harmonic();
Method conformal(); // the linear one, which may fold
Method arap();
std::vector<Method> all_methods();

Method sampling();                                             // by the stretch, as `--prefer sampling`
Method bijective_conformal();                                  // by the conformal energy, on the unit sphere
Method precomputed(const Mesh& mesh, const Images& images);    // a given map
Method bijective_from(const Mesh& mesh, const Images& images); // the default method, from a given map
Method bijective_from_stereographic();

// Expects this error of the method, and that it has not begun; that the map is untouched is a part of run().
void expect_error(const Mesh& mesh, const Method& method, SP::Error_code error);

Mesh make(const Triangle_list& list);
Mesh cube(); // of quadrangles
Triangle_list list_of(const SP::Sphere_domain_3& domain);
std::vector<Triangle> triangles(const Mesh& mesh);
Images points(const Mesh& mesh);
bool is_bijective(const Mesh& mesh, const Images& images);
SP::Distortion_summary measure(const Mesh& mesh, const Images& images);

// measures what can be measured
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class Any_mesh, class Map, class... NamedParameters>
SP::Distortion_summary distortion_of(const Any_mesh& mesh, const Map& map, const NamedParameters&... np)
{
  SP::Distortion_summary result;
  EXPECT_EQ(SP::measure_distortion<ConcurrencyTag>(mesh, map, result, np...), SP::OK);
  return result;
}

} // namespace test

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_METHODS_H
