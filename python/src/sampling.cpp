#include "Interruption.h"
#include "functions.h"
#include "threads.h"

#include <CGAL/Spherical_parameterization/Sampling/Sphere_domain_3.h>
#include <CGAL/Spherical_parameterization/Sphere_locator_3.h>
#include <CGAL/Spherical_parameterization/Sampling/remesh_through_sphere.h>
#include <CGAL/Spherical_parameterization/Sampling/transfer.h>

#include <functional>
#include <iterator>
#include <limits>
#include <memory>

namespace Module {

namespace {

class Locator
{
public:
  Locator(const Indices& faces, const Points& sphere, std::size_t threads)
    : m_threads(threads)
    , m_mesh(make_mesh("", sphere, faces))
    , m_locator(run_with_threads(threads, [&] { return Sphere_locator(m_mesh, rows_of(sphere)); }))
  {
    if(m_locator.error_code() != SP::OK)
      check_map("", m_mesh, "sphere", sphere);
  }

  py::tuple locate(const Points& directions) const
  {
    const std::size_t n = number_of_rows(directions);
    Indices faces(static_cast<py::ssize_t>(n));
    Points coordinates = new_points(n);
    std::int64_t* face = faces.mutable_data();
    double* coordinate = coordinates.mutable_data();
    {
      const py::gil_scoped_release unlock;
      std::vector<Point_3> points;
      points.reserve(n);
      for(std::size_t k = 0; k < n; ++k)
        points.push_back(get(rows_of(directions), Vertex_index(static_cast<Mesh::size_type>(k))));
      std::vector<Sphere_locator::Face_location> locations;
      locations.reserve(n);
      const SP::Error_code error =
          run_with_threads(m_threads, [&] { return m_locator.locate(points, std::back_inserter(locations)); });
      if(error != SP::OK)
        explain_directions(locations);
      for(const auto& [f, c] : locations)
      {
        *face++ = std::uint32_t(f);
        for(const std::size_t i : {1u, 2u, 0u}) // the first one belongs to the last corner
          *coordinate++ = c[i];
      }
    }
    return py::make_tuple(faces, coordinates);
  }

  /// returns the arguments of the constructor.
  py::tuple parts() const
  {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for(const Face_index f : m_mesh.faces())
    {
      const Mesh::Halfedge_index h = m_mesh.next(m_mesh.halfedge(f)); // from the first corner
      triangles.push_back({m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))});
    }
    Points sphere = new_points(m_mesh.number_of_vertices());
    const Row_map<double> rows(sphere.mutable_data());
    for(const Vertex_index v : m_mesh.vertices())
      put(rows, v, m_mesh.point(v));
    return py::make_tuple(to_array(triangles), sphere, m_threads);
  }

private:
  using Sphere_locator = SP::Sphere_locator_3<Mesh, Const_row_map>;

  [[noreturn]] static void explain_directions(const std::vector<Sphere_locator::Face_location>& locations)
  {
    const auto is_invalid = [](const auto& location) { return location.first == Face_index(); };
    const auto first = std::find_if(locations.begin(), locations.end(), is_invalid);
    const auto row = static_cast<std::size_t>(first - locations.begin());
    throw Error{{SP::ERROR_INVALID_DIRECTION,
                 "directions: row " + std::to_string(row) + " is zero, infinite or not a number (" +
                     std::to_string(std::count_if(first, locations.end(), is_invalid)) +
                     " such rows in total).\n(Rows are counted from 0.)",
                 row,
                 {},
                 {}}};
  }

  std::size_t m_threads;
  Mesh m_mesh;
  Sphere_locator m_locator;
};

// Returns the points of the remesh and its directions.
std::pair<Points, Points> remesh_over(const Points& vertices, const Indices& faces, const Points& sphere,
                                      const SP::Sphere_domain_3& domain, std::size_t threads)
{
  const std::size_t n = domain.directions().size();
  Points points = new_points(n), directions = new_points(n);
  const Row_map<double> point_map(points.mutable_data()), direction_map(directions.mutable_data());
  Signal_visitor visitor;
  {
    const py::gil_scoped_release unlock;
    const Mesh mesh = make_mesh("", vertices, faces);
    Mesh result; // its vertices and faces are those of the domain
    const SP::Error_code error = run_with_threads(threads, [&] {
      return SP::remesh_through_sphere(mesh, rows_of(sphere), domain, result, direction_map,
                                       CGAL::parameters::visitor(std::ref(visitor)),
                                       CGAL::parameters::vertex_point_map(point_map));
    });
    if(error != SP::OK)
    {
      check_map("", mesh, "sphere", sphere);
      fail(error, SP::get_error_message(error));
    }
  }
  return {points, directions};
}

// The rows of a table of numbers, or of a table with one label in each row.
template <class Index, class Number>
struct Table_map
{
  using key_type = Index;
  using value_type =
      std::conditional_t<std::is_same<std::remove_const_t<Number>, double>::value, std::vector<double>, std::int64_t>;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  Number* data;
  std::size_t n_columns;

  friend value_type get(const Table_map& map, Index i)
  {
    Number* const row = map.data + std::size_t(i) * map.n_columns;
    if constexpr(std::is_same<value_type, std::int64_t>::value)
      return *row;
    else
      return value_type(row, row + map.n_columns);
  }
  friend void put(const Table_map& map, Index i, const value_type& value)
  {
    Number* const row = map.data + std::size_t(i) * map.n_columns;
    if constexpr(std::is_same<value_type, std::int64_t>::value)
      *row = value;
    else
      std::copy(value.begin(), value.end(), row);
  }
};

template <class Number>
py::array transfer_values(const py::array_t<Number, py::array::c_style>& values, bool is_of_faces, Number missing,
                          const Points& vertices, const Indices& faces, const Points& sphere,
                          const Indices& target_faces, const Points& target_sphere, std::size_t threads)
{
  const auto n_columns = static_cast<std::size_t>(values.shape(1));
  py::array_t<Number> result({is_of_faces ? target_faces.shape(0) : target_sphere.shape(0), values.shape(1)});
  Number* const results = result.mutable_data();
  const Number* const sources = values.data();
  std::fill_n(results, result.size(), missing);

  Signal_visitor visitor;
  const py::gil_scoped_release unlock;
  const Mesh source = make_mesh("source: ", vertices, faces),
             target = make_mesh("target: ", target_sphere, target_faces);
  const auto carry = [&](auto index) {
    using Index = decltype(index);
    return SP::transfer(
        source, rows_of(sphere), target, rows_of(target_sphere),
        std::pair(Table_map<Index, const Number>{sources, n_columns}, Table_map<Index, Number>{results, n_columns}),
        CGAL::parameters::visitor(std::ref(visitor)));
  };
  const SP::Error_code error =
      run_with_threads(threads, [&] { return is_of_faces ? carry(Face_index()) : carry(Vertex_index()); });
  if(error != SP::OK)
  {
    check_map("source: ", source, "sphere", sphere);
    check_map("target: ", target, "sphere", target_sphere);
    fail(error, SP::get_error_message(error));
  }
  return std::move(result);
}

} // namespace

void define_locator(py::module_& module)
{
  py::class_<Locator>(module, "Locator")
      .def(py::init<const Indices&, const Points&, std::size_t>(), py::call_guard<py::gil_scoped_release>())
      .def("locate", &Locator::locate)
      .def(py::pickle([](const Locator& locator) { return locator.parts(); },
                      [](const py::tuple& parts) {
                        const auto faces = parts[0].cast<Indices>();
                        const auto sphere = parts[1].cast<Points>();
                        const auto threads = parts[2].cast<std::size_t>();
                        const py::gil_scoped_release unlock;
                        return std::make_unique<Locator>(faces, sphere, threads);
                      }));
}

py::tuple remesh(const Points& vertices, const Indices& faces, const Points& sphere, const std::string& solid,
                 std::uint32_t subdivision, std::size_t threads)
{
  const auto domain = [&] {
    const py::gil_scoped_release unlock;
    return solid == "cube"          ? SP::Sphere_domain_3::cube(subdivision)
           : solid == "icosahedron" ? SP::Sphere_domain_3::icosahedron(subdivision)
                                    : SP::Sphere_domain_3::octahedron(subdivision);
  }();
  const auto [points, directions] = remesh_over(vertices, faces, sphere, domain, threads);
  return py::make_tuple(points, to_array(domain.triangles()), directions);
}

std::pair<Points, Points> remesh_with(const Points& vertices, const Indices& faces, const Points& sphere,
                                      const Indices& domain_faces, const Points& domain_sphere, std::size_t threads)
{
  const auto domain = [&] {
    const py::gil_scoped_release unlock;
    const Mesh mesh = make_mesh("domain: ", domain_sphere, domain_faces);
    SP::Sphere_domain_3 result;
    const SP::Error_code error =
        run_with_threads(threads, [&] { return SP::make_sphere_domain(mesh, rows_of(domain_sphere), result); });
    if(error != SP::OK)
    {
      check_map("domain: ", mesh, "sphere", domain_sphere);
      fail(error, SP::get_error_message(error));
    }
    return result;
  }();
  return remesh_over(vertices, faces, sphere, domain, threads);
}

py::array transfer(const py::array& values, bool is_of_faces, const Points& vertices, const Indices& faces,
                   const Points& sphere, const Indices& target_faces, const Points& target_sphere, std::size_t threads)
{
  if(values.dtype().kind() == 'f')
    return transfer_values<double>(values, is_of_faces, std::numeric_limits<double>::quiet_NaN(), vertices, faces,
                                   sphere, target_faces, target_sphere, threads);
  return transfer_values<std::int64_t>(values, is_of_faces, -1, vertices, faces, sphere, target_faces, target_sphere,
                                       threads);
}

} // namespace Module
