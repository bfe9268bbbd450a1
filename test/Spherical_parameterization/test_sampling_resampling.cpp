// What the vertices of one sphere have is carried to those of another one by the weights that the documentation defines.

#include <CGAL/Spherical_parameterization/Sampling/Sphere_resampler_3.h>
#include <CGAL/Spherical_parameterization/Sampling/internal/Interpolation_weights.h>

#include "broken_maps.h"
#include "methods.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

using namespace test;

namespace {

using Weighting = SP::Resampling_method;
using Resampler = SP::Sphere_resampler_3<>;
using Weights = std::vector<std::map<std::size_t, double>>;

constexpr std::array<Weighting, 4> methods_of_resampling = {Weighting::barycentric, Weighting::adaptive,
                                                            Weighting::nearest, Weighting::largest};

struct Sphere
{
  explicit Sphere(const Triangle_list& list)
    : points(list.points)
  {
    for(const auto& t : list.triangles)
      triangles.push_back(
          {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
    areas = Resampler::vertex_areas(points, triangles);
  }

  std::size_t size() const { return points.size(); }

  Resampler::Points points;
  Resampler::Triangles triangles;
  std::vector<double> areas;
};

// Where one of them is coarser, finer and about as fine as the other one.
struct Pair
{
  Sphere from, to;
};
std::vector<Pair> pairs()
{
  const Triangle_list coarse = tilted(icosphere(2)), middle = bumpy_sphere(3), fine = icosphere(4);
  return {{Sphere(fine), Sphere(coarse)},
          {Sphere(coarse), Sphere(fine)},
          {Sphere(middle), Sphere(tilted(icosphere(3)))},
          {Sphere(fine), Sphere(middle)}};
}

Resampler connected(const Pair& pair, Weighting method, const std::vector<bool>& mask = {})
{
  Resampler resampler;
  resampler.method(method).areas(pair.from.areas, pair.to.areas).mask(mask);
  EXPECT_EQ(resampler.connect(pair.from.points, pair.from.triangles, pair.to.points, pair.to.triangles), SP::OK);
  return resampler;
}

template <class T>
std::vector<T> resampled(const Resampler& resampler, const std::vector<T>& values)
{
  std::vector<T> result;
  EXPECT_EQ(resampler.resample(values, result), SP::OK);
  return result;
}

// the barycentric coordinates of the vertices of a sphere in another one, by the locator
Weights located(const Sphere& of, const Sphere& in)
{
  Mesh mesh;
  for(const auto& p : in.points)
    mesh.add_vertex(Point_3(p[0], p[1], p[2]));
  for(const auto& t : in.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  const SP::Sphere_locator_3 locator(mesh, mesh.points());
  Weights result;
  for(const auto& p : of.points)
  {
    const auto [face, coordinates] = locator.locate(Point_3(p[0], p[1], p[2]));
    const auto h = mesh.halfedge(face);
    result.emplace_back();
    std::size_t i = 0;
    for(const auto v : {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))})
      if(coordinates[i++] > 0.)
        result.back()[v] = coordinates[i - 1];
  }
  return result;
}

// the weights of the documentation, word by word
Weights expected_weights(const Pair& pair, bool is_adaptive)
{
  const Weights interpolated = located(pair.to, pair.from), distributed = located(pair.from, pair.to);
  if(!is_adaptive)
    return interpolated;
  Weights result(pair.to.size());
  for(std::size_t s = 0; s < distributed.size(); ++s)
    for(const auto& [v, weight] : distributed[s])
      result[v][s] = weight;
  std::vector<double> sums(pair.from.size(), 0.);
  for(std::size_t v = 0; v < result.size(); ++v)
  {
    if(std::all_of(result[v].begin(), result[v].end(),
                   [&](const auto& term) { return interpolated[v].count(term.first) > 0; }))
      result[v] = interpolated[v];
    for(auto& [s, weight] : result[v])
      sums[s] += weight *= pair.to.areas[v];
  }
  for(auto& weights : result)
    for(auto& [s, weight] : weights)
      weight *= pair.from.areas[s] / sums[s];
  return result;
}

std::vector<double> random_values(std::size_t n)
{
  std::vector<double> result;
  for(std::size_t k = 0; k < n; ++k)
    result.push_back(std::sin(1e4 * static_cast<double>(k * k)));
  return result;
}

} // namespace

TEST(Resampling, has_the_weights_of_the_definition)
{
  for(const Pair& pair : pairs())
    for(const bool is_adaptive : {false, true})
    {
      const Weights expected = expected_weights(pair, is_adaptive);
      const std::vector<double> values = random_values(pair.from.size());
      std::vector<std::int32_t> labels;
      for(std::size_t s = 0; s < pair.from.size(); ++s)
        labels.push_back(static_cast<std::int32_t>(s * 7 % 5) - 1);
      const Resampler resampler = connected(pair, is_adaptive ? Weighting::adaptive : Weighting::barycentric);
      const auto result = resampled(resampler, values);
      const auto result_of_labels = resampled(resampler, labels);
      const auto largest = resampled(connected(pair, is_adaptive ? Weighting::largest : Weighting::nearest), values);
      ASSERT_EQ(result.size(), pair.to.size());
      for(std::size_t v = 0; v < result.size(); ++v)
      {
        double sum = 0., weight = 0., max = 0.;
        std::map<std::int32_t, double> shares;
        for(const auto& [s, w] : expected[v])
        {
          sum += w * values[s];
          weight += w;
          max = (std::max)(max, w);
          shares[labels[s]] += w;
        }
        EXPECT_NEAR(result[v], sum / weight, 1e-12);
        for(const auto& share : shares)
          EXPECT_LE(share.second, shares[result_of_labels[v]] * (1. + 1e-12));
        EXPECT_TRUE(std::any_of(expected[v].begin(), expected[v].end(), [&](const auto& term) {
          return values[term.first] == largest[v] && term.second >= (1. - 1e-12) * max;
        }));
      }
    }
}

TEST(Resampling, a_sphere_gets_from_itself_what_it_has)
{
  const Sphere sphere(bumpy_sphere(3));
  const std::vector<double> values = random_values(sphere.size());
  for(const Weighting method : methods_of_resampling)
    EXPECT_EQ(resampled(connected({sphere, sphere}, method), values), values);
}

TEST(Resampling, the_mask_leaves_out_sources)
{
  for(const Pair& pair : pairs())
    for(const Weighting method : methods_of_resampling)
    {
      std::vector<bool> mask;
      std::vector<double> values;
      std::vector<std::string> labels;
      for(const auto& p : pair.from.points)
      {
        mask.push_back(p[2] < 0.3);
        values.push_back(mask.back() ? 3. : std::numeric_limits<double>::quiet_NaN());
        labels.emplace_back(mask.back() ? "in" : "out");
      }
      const Resampler resampler = connected(pair, method, mask);
      const std::vector<bool> has_value = resampler.has_value();
      const auto result = resampled(resampler, values);
      const auto result_of_labels = resampled(resampler, labels);
      std::size_t n_empty = 0;
      for(std::size_t v = 0; v < result.size(); ++v)
      {
        EXPECT_NEAR(result[v], has_value[v] ? 3. : 0., 1e-14);
        EXPECT_EQ(result_of_labels[v], has_value[v] ? "in" : "");
        n_empty += !has_value[v];
        EXPECT_TRUE(has_value[v] || pair.to.points[v][2] > -0.5);
      }
      EXPECT_GT(n_empty, 0u);
      EXPECT_LT(n_empty, result.size() / 2);
    }
}

TEST(Resampling, spheres_are_carried_through_a_registration)
{
  const Sphere fine(icosphere(4)), coarse(tilted(icosphere(3)));
  const Resampler resampler = connected({fine, coarse}, Weighting::barycentric);
  Resampler::Points result, registered = fine.points, expected = coarse.points;
  for(Resampler::Points* points : {&registered, &expected})
    for(auto& p : *points) // a rotation, and another radius
      p = {-100. * p[1], 100. * p[0], 100. * p[2]};
  EXPECT_EQ(resampler.resample_sphere(registered, result), SP::OK);
  for(std::size_t v = 0; v < result.size(); ++v)
    for(std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(result[v][i], expected[v][i], 1e-12);
  for(auto& p : registered) // turned over: all faces are
    p[2] = -p[2];
  EXPECT_EQ(resampler.resample_sphere(registered, result), SP::ERROR_NO_1_TO_1_MAPPING);
  registered.pop_back();
  EXPECT_EQ(resampler.resample_sphere(registered, result), SP::ERROR_WRONG_PARAMETER);
}

TEST(Resampling, any_number_of_threads_gives_the_same_bits)
{
  const Pair pair = {Sphere(icosphere(5)), Sphere(tilted(icosphere(5)))};
  const std::vector<double> values = random_values(pair.from.size());
  for(const Weighting method : methods_of_resampling)
  {
    SP::Sphere_resampler_3<CGAL::Sequential_tag> sequential;
    sequential.method(method).areas(pair.from.areas, pair.to.areas);
    ASSERT_EQ(sequential.connect(pair.from.points, pair.from.triangles, pair.to.points, pair.to.triangles), SP::OK);
    std::vector<double> expected;
    ASSERT_EQ(sequential.resample(values, expected), SP::OK);
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
#endif
    EXPECT_EQ(resampled(connected(pair, method), values), expected);
  }
}

TEST(Resampling, vertices_without_a_triangle_have_no_part)
{
  Pair pair = pairs()[0];
  for(Sphere* sphere : {&pair.from, &pair.to})
  {
    sphere->points.push_back({std::numeric_limits<double>::quiet_NaN(), 0., 0.});
    sphere->areas.push_back(1.);
  }
  for(const Weighting method : methods_of_resampling)
  {
    const Resampler resampler = connected(pair, method);
    std::vector<double> values(pair.from.size(), 2.);
    values.back() = 1e9;
    std::vector<double> result = resampled(resampler, values);
    EXPECT_FALSE(resampler.has_value().back());
    EXPECT_EQ(result.back(), 0.);
    result.pop_back();
    for(const double x : result)
      EXPECT_NEAR(x, 2., 1e-15);
  }
}

TEST(Resampling, areas_of_any_size_will_do)
{
  Pair pair = pairs()[0];
  const std::vector<double> values = random_values(pair.from.size());
  const auto expected = resampled(connected(pair, Weighting::adaptive), values);
  for(double& area : pair.from.areas)
    area *= 0x1p900;
  for(double& area : pair.to.areas)
    area *= 0x1p-900;
  EXPECT_EQ(resampled(connected(pair, Weighting::adaptive), values), expected);
  // What has no area gets and gives something nevertheless.
  std::fill(pair.from.areas.begin(), pair.from.areas.end(), 0.);
  pair.to.areas[7] = 0.;
  for(const double x : resampled(connected(pair, Weighting::adaptive), std::vector<double>(pair.from.size(), 1.)))
    EXPECT_NEAR(x, 1., 1e-15);
}

TEST(Resampling, what_is_wrong_is_told)
{
  const Pair pair = pairs()[0];
  const auto expect_error = [&](const Sphere& from, const Sphere& to, SP::Error_code error) {
    Resampler resampler;
    EXPECT_EQ(resampler.connect(from.points, from.triangles, to.points, to.triangles), error);
    std::vector<double> result = {5.};
    EXPECT_EQ(resampler.resample(std::vector<double>(from.size(), 1.), result) == SP::OK, error == SP::OK);
    EXPECT_EQ(result.size() == 1, error != SP::OK); // as it was
    EXPECT_EQ(resampler.has_value().empty(), error != SP::OK);
  };
  expect_error(pair.from, pair.to, SP::OK);
  for(const auto& [list, error] : broken_maps())
  {
    const bool is_closed = error == SP::ERROR_NO_TOPOLOGICAL_SPHERE || error == SP::ERROR_SEVERAL_COMPONENTS;
    const SP::Error_code expected = is_closed ? SP::ERROR_NO_1_TO_1_MAPPING : error; // whatever the reason is
    expect_error(pair.from, Sphere(list), expected);
    expect_error(Sphere(list), pair.from, expected);
  }
  Sphere wrong = pair.to;
  wrong.triangles[5][1] = 162;
  expect_error(pair.from, wrong, SP::ERROR_WRONG_PARAMETER);
  expect_error(wrong, pair.from, SP::ERROR_WRONG_PARAMETER);

  const auto error_with = [&](Resampler& resampler) {
    return resampler.connect(pair.from.points, pair.from.triangles, pair.to.points, pair.to.triangles);
  };
  Resampler resampler;
  EXPECT_EQ(error_with(resampler.method(Weighting::adaptive)), SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(error_with(resampler.areas(pair.to.areas, pair.from.areas)), SP::ERROR_WRONG_PARAMETER);
  std::vector<double> areas = pair.from.areas;
  areas[9] = -1.;
  EXPECT_EQ(error_with(resampler.areas(areas, pair.to.areas)), SP::ERROR_WRONG_PARAMETER);
  EXPECT_EQ(error_with(resampler.areas(pair.from.areas, pair.to.areas)), SP::OK);
  EXPECT_EQ(error_with(resampler.mask({true, false})), SP::ERROR_WRONG_PARAMETER);
}
