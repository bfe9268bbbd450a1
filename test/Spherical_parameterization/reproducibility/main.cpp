// Usage: hashes TABLE [--renew] [--largest N] [--generated] [WORD...]
//
// Computes each row of the table for which there is a mesh here, and compares the hash of the result with that of the row; says what
// differs. Left out are meshes of more vertices than --largest, with --generated those that come from files, and with words the rows that
// have none of them. --renew writes the hashes that it finds to the table; no row may be left out then.
//
// The folders of meshes are the environment variables CGAL_DATA_DIR and SPHERICAL_PARAMETERIZATION_DATA_DIR.

#include "Hash_case.h"

#include <CGAL/Spherical_parameterization/internal/files/read_mesh_file.h>
#include <CGAL/Spherical_parameterization/reproducibility.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

namespace reproducibility {

namespace {

using test_meshes::Triangle_list;

Mesh read_mesh(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  if(!in)
    return Mesh();
  std::string content(std::istreambuf_iterator<char>(in), {});
  const SP::internal::Polygon_soup soup =
      SP::internal::read_mesh_file(path.substr(path.rfind('.')), std::move(content));
  Triangle_list list;
  for(const auto& p : soup.points)
    list.points.push_back({p.x(), p.y(), p.z()});
  for(const auto& polygon : soup.polygons)
    list.triangles.push_back({polygon.at(0), polygon.at(1), polygon.at(2)});
  return test_meshes::make_mesh<Mesh>(list);
}

} // namespace

Mesh find_mesh(const std::string& name)
{
  const std::map<std::string, std::pair<const char*, std::string>> folders = {
      {"cgal", {"CGAL_DATA_DIR", "/meshes/"}}, {"shared", {"SPHERICAL_PARAMETERIZATION_DATA_DIR", "/meshes/"}}};
  if(const std::size_t slash = name.find('/'); slash != std::string::npos)
  {
    const auto& [variable, folder] = folders.at(name.substr(0, slash));
    const char* value = std::getenv(variable);
    return value != nullptr ? read_mesh(value + folder + name.substr(slash + 1)) : Mesh();
  }
  const std::map<std::string, std::function<Triangle_list()>> made = {
      {"tetrahedron", [] { return test_meshes::tetrahedron(); }},
      {"bumpy", [] { return test_meshes::bumpy_sphere(4); }},
      {"body", [] { return test_meshes::tilted(test_meshes::scaled(test_meshes::bumpy_sphere(3), 1., 0.7, 1.3)); }},
      {"needle", [] { return test_meshes::ellipsoid(1., 1., 1e-4, 3); }},
      {"stacked", [] { return test_meshes::random_stacked_sphere(400, 5); }},
      {"tentacle", [] { return test_meshes::with_tentacle(60, 10.); }}};
  return test_meshes::make_mesh<Mesh>(made.at(name)());
}

namespace {

struct Row
{
  std::string mesh, operation, hash;
};

std::vector<Row> read_table(const std::string& path)
{
  std::ifstream in(path);
  std::vector<Row> rows;
  for(std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    Row row;
    if(words >> row.mesh >> row.operation)
    {
      words >> row.hash;
      rows.push_back(row);
    }
  }
  if(rows.empty())
    throw std::runtime_error(path + " has no rows");
  return rows;
}

void write_table(const std::string& path, const std::vector<Row>& rows)
{
  std::ofstream out(path, std::ios::binary);
  for(const Row& row : rows)
    out << row.mesh << ' ' << row.operation << ' ' << row.hash << '\n';
  if(!out.flush())
    throw std::runtime_error(path + " cannot be written");
}

// what SP::results_version has to be
std::string digest(const std::vector<Row>& rows)
{
  Hash hash;
  for(const Row& row : rows)
    for(const std::string& word : {row.mesh, row.operation, row.hash})
      hash.add(word);
  return hash.text().substr(0, 8);
}

int run(std::vector<std::string> words)
{
  if(words.empty())
    throw std::runtime_error("Usage: hashes TABLE [--renew] [--largest N] [--generated] [WORD...]");
  const std::string path = words.front();
  words.erase(words.begin());
  const bool renews = !words.empty() && words.front() == "--renew";
  if(renews)
    words.erase(words.begin());
  std::size_t largest = ~std::size_t(0);
  if(words.size() > 1 && words.front() == "--largest")
  {
    largest = std::stoul(words[1]);
    words.erase(words.begin(), words.begin() + 2);
  }

  const bool is_generated_only = !words.empty() && words.front() == "--generated";
  if(is_generated_only)
    words.erase(words.begin());

  Hash_cases cases;
  add_spheres(cases);
#ifndef HASHES_OF_SPHERES_ONLY
  add_operations(cases);
#endif
  std::vector<Row> rows = read_table(path);
  std::size_t n_compared = 0, n_different = 0;
  std::string name;
  Mesh mesh;
  for(Row& row : rows)
  {
    const std::string text = row.mesh + ' ' + row.operation;
    if(is_generated_only && row.mesh.find('/') != std::string::npos)
      continue;
    if(!words.empty() && std::none_of(words.begin(), words.end(),
                                      [&](const std::string& word) { return text.find(word) != std::string::npos; }))
      continue;
    const auto found = cases.find(row.operation);
    if(name != row.mesh)
      mesh = find_mesh(name = row.mesh);
    if(found == cases.end() || mesh.is_empty() || mesh.number_of_vertices() > largest)
    {
      if(renews)
        throw std::runtime_error(text + " cannot be computed here");
      continue;
    }
    Hash hash;
    found->second(mesh, hash);
    ++n_compared;
    if(hash.text() != row.hash)
    {
      ++n_different;
      std::cout << text << ' ' << hash.text() << (row.hash.empty() ? " is new" : " instead of " + row.hash)
                << std::endl;
      row.hash = hash.text();
    }
  }
  std::cout << n_compared << " of " << rows.size() << " rows compared, " << n_different << " differ" << std::endl;
  if(renews)
  {
    write_table(path, rows);
    std::cout << "results_version " << digest(rows) << std::endl;
    return EXIT_SUCCESS;
  }
  if(!SP::is_reproducible())
    std::cout << "the arithmetic of this build is not that of IEEE 754" << std::endl;
  const bool has_version = n_different > 0 || digest(rows) == SP::results_version;
  if(!has_version)
    std::cout << "results_version is " << SP::results_version << " instead of " << digest(rows) << std::endl;
  return n_compared > 0 && n_different == 0 && has_version ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

} // namespace reproducibility

int main(int argc, char** argv)
{
  try
  {
    return reproducibility::run({argv + 1, argv + argc});
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
