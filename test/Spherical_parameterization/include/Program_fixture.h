#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PROGRAM_FIXTURE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PROGRAM_FIXTURE_H

// What the tests of the command line program have in common: a folder of their own, files in it, and runs within it.

// In CGAL's tree the program is not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#define BOOST_BIND_GLOBAL_PLACEHOLDERS // Boost's JSON parser uses them, and says so in every compilation otherwise
#endif

#include "mesh_texts.h"
#include "test_meshes.h"

#include <CGAL/Spherical_parameterization/Cortex/FreeSurfer.h>
#ifdef TEST_GIFTI
#include <CGAL/Spherical_parameterization/Cortex/GIFTI.h>
#endif
#ifdef TEST_MGH
#include <CGAL/Spherical_parameterization/Cortex/MGH.h>
#endif

#include <CGAL/Spherical_parameterization/internal/files/read_mesh_file.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <gtest/gtest.h>

#include <regex>

namespace fs = std::filesystem;
namespace SP = CGAL::Spherical_parameterization;

inline std::string content(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline SP::IO::Surface_file corner_surface()
{
  SP::IO::Surface_file surface;
  surface.points = {{{0., 0., 0.}}, {{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}};
  surface.triangles = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};
  return surface;
}

// A sphere with properties of its vertices: a height or a density, which can be chosen for the first one, a label, and which
// ones count.
inline std::string ply_with_values(unsigned int subdivisions, const std::string& properties = "float height,uint label",
                                   double first_value = 1.)
{
  const test_meshes::Triangle_list list = test_meshes::icosphere(subdivisions);
  const std::string property = "\nproperty ";
  std::ostringstream ply;
  ply.precision(9);
  ply << "ply\nformat ascii 1.0\nelement vertex " << list.points.size() << property << "double x" << property
      << "double y" << property << "double z" << property << replaced(properties, ",", property) << "\nelement face "
      << list.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(std::size_t v = 0; v < list.points.size(); ++v)
  {
    const test_meshes::Coordinates& p = list.points[v];
    ply << p[0] << ' ' << p[1] << ' ' << p[2];
    for(const std::string& name : words_of(replaced(properties, ",", " ")))
      if(name == "height" || name == "density")
        ply << ' ' << (v == 0 ? first_value : name == "height" ? p[2] : p[0] > 0. ? 10. : 1.);
      else if(name == "label" || name == "counts" || name == "zero")
        ply << ' ' << (name == "label" ? (p[0] > 0.1 ? 7 : 3) : name == "counts" && p[2] > 0.);
    ply << '\n';
  }
  for(const test_meshes::Triangle& t : list.triangles)
    ply << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return ply.str();
}

// the warning of the program about an ambiguous alignment
constexpr const char* uncertain =
    "the alignment of the surfaces is ambiguous: check the map, for example with --page, or give --landmarks\n";

inline void expect_part(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text << "\nhas not: " << part;
}

struct Outcome
{
  int status;
  std::string out, err;
};

// A mesh file that the program has written, .off or .ply, with the columns of numbers of the latter, such as "vertex nx".
struct Mesh_file
{
  explicit Mesh_file(const fs::path& path)
  {
    const SP::internal::Polygon_soup soup =
        SP::internal::read_mesh_file(path.extension().string(), content(path), true);
    for(const auto& p : soup.points)
      points.push_back({p.x(), p.y(), p.z()});
    for(const auto& polygon : soup.polygons)
      faces.emplace_back(polygon.begin(), polygon.end());
    for(const auto& property : soup.values_of_vertices)
      columns["vertex " + property.name] = property.numbers;
    for(const auto& property : soup.values_of_faces)
      columns["face " + property.name] = property.numbers;
  }

  std::vector<test_meshes::Coordinates> points;
  std::vector<std::vector<std::size_t>> faces;
  std::map<std::string, std::vector<double>> columns;
};

// Files have all digits; the parts of a sum may come in another order.
inline void expect_near(const std::vector<test_meshes::Coordinates>& found,
                        const std::vector<test_meshes::Coordinates>& expected, double tolerance = 1e-12)
{
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t v = 0; v < found.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k)
      ASSERT_NEAR(found[v][k], expected[v][k], tolerance) << v;
}

class Program_fixture : public ::testing::Test
{
protected:
  using Names = std::set<std::string>;
  using Messages = std::vector<std::pair<std::string, std::string>>; // of arguments

  // a folder of its own for each test
  Program_fixture()
  {
    m_folder = fs::path("program") / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);
  }

  fs::path path(const std::string& name) const { return m_folder / name; }

  // a file to be written, in a folder that is made where it is missing
  std::ofstream opened(const std::string& name) const
  {
    fs::create_directories(path(name).parent_path());
    return std::ofstream(path(name), std::ios::binary);
  }

  void write(const std::string& name, const std::string& text) const { opened(name) << text; }

  // writes by a function of the library
  template <class Write>
  void write_by(const std::string& name, const Write& write) const
  {
    std::ofstream out = opened(name);
    std::string message;
    ASSERT_EQ(write(out, message), SP::OK) << message;
  }

  // writes values of the vertices of a surface in the format of FreeSurfer
  void write_curv(const std::string& name, const std::vector<double>& values) const
  {
    SP::IO::Vertex_values column;
    column.values = values;
    write_by(name, [&](auto& out, auto& message) {
      return SP::IO::write_FreeSurfer_curv(out, column, 2 * values.size() - 4, message);
    });
  }

  void write_surface(const std::string& name, const SP::IO::Surface_file& surface) const
  {
    write_by(name, [&](auto& out, auto& message) { return SP::IO::write_FreeSurfer_surface(out, surface, message); });
  }

  template <class Read>
  SP::IO::Surface_file read_by(const std::string& name, const Read& read) const
  {
    SP::IO::Surface_file file;
    std::string message;
    std::ifstream in(path(name), std::ios::binary);
    EXPECT_EQ(read(in, file, message), SP::OK) << name << ": " << message;
    return file;
  }

  Mesh_file read_mesh(const std::string& name) const { return Mesh_file(path(name)); }

  void write_off(const std::string& name, const test_meshes::Triangle_list& list) const
  {
    std::ofstream out = opened(name);
    out.precision(17);
    out << "OFF\n" << list.points.size() << ' ' << list.triangles.size() << " 0\n";
    for(const auto& p : list.points)
      out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for(const auto& t : list.triangles)
      out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }

  // runs the program within the folder; arguments are separated by blanks
  Outcome run(const std::string& arguments) const { return run_script("\"$PROGRAM\" " + arguments); }

  // runs commands of the shell within the folder, for which PROGRAM is the program
  Outcome run_script(const std::string& commands) const
  {
    const std::string command = "PROGRAM='" SPHERICAL_PARAMETERIZATION_PROGRAM "'; cd '" + m_folder.string() +
                                "' && { " + commands + "; } > stdout.txt 2> stderr.txt < /dev/null";
    const int status = std::system(command.c_str());
    return {status % 256 == 0 ? status / 256 : status, content(path("stdout.txt")), content(path("stderr.txt"))};
  }

  // runs the program, which has to end in order with these warnings, and returns what it prints
  std::string expect_success(const std::string& arguments, const std::string& warnings = "") const
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, warnings);
    return outcome.out;
  }

  // the program has to end with a message, and to leave the folder as it was
  void expect_message(const std::string& arguments, const std::string& part_of_message) const
  {
    SCOPED_TRACE(arguments);
    Names before = names_of_files();
    before.insert({"stdout.txt", "stderr.txt"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    expect_part(outcome.err, part_of_message);
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
    EXPECT_EQ(names_of_files(), before);
  }

  void expect_messages(const std::string& begin, const Messages& table) const
  {
    for(const auto& [rest, message] : table)
      expect_message(begin + rest, message);
  }

  boost::property_tree::ptree json(const std::string& name = "result.json") const
  {
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(path(name).string(), tree);
    return tree;
  }

  // the names of all that is in the folder, or in one of its folders
  Names names_of_files(const std::string& folder = ".") const
  {
    Names names;
    for(const fs::directory_entry& entry : fs::directory_iterator(path(folder)))
      names.insert(entry.path().filename().string());
    return names;
  }

private:
  fs::path m_folder;
};

// Many meshes in the folder `in`, which results in the folder `out` are made of.
class Batch_fixture : public Program_fixture
{
protected:
  Batch_fixture() { fs::create_directory(path("in")); }

  void write_meshes(const std::vector<std::string>& names) const
  {
    for(const std::string& name : names)
      write("in/" + name, corner_off);
  }

  // runs the program and returns what it reports of each input. Each has a line of its own, in the order of their numbers.
  std::map<std::string, std::string> run_batch(const std::string& arguments, int status)
  {
    SCOPED_TRACE(arguments);
    m_outcome = run("batch " + arguments);
    EXPECT_EQ(m_outcome.status, status) << m_outcome.out << m_outcome.err;
    std::map<std::string, std::string> texts;
    std::istringstream lines(m_outcome.out);
    std::string line;
    std::size_t n = 0;
    const std::regex pattern("\\[([0-9]+)/([0-9]+)\\] (.*?): (.*)");
    for(std::smatch parts; std::getline(lines, line) && std::regex_match(line, parts, pattern);
        n = std::stoul(parts[2]))
    {
      EXPECT_TRUE(texts.emplace(parts[3], parts[4]).second) << line;
      EXPECT_EQ(parts[1], std::to_string(texts.size()));
    }
    EXPECT_EQ(texts.size(), n);
    EXPECT_EQ(line.substr(0, 7), "Mapped ") << line;
    EXPECT_FALSE(std::getline(lines, line)) << "something follows the summary: " << line;
    return texts;
  }

  // runs the program once more and returns the names of the meshes that it maps again
  Names redone(const std::string& arguments, int status = 0)
  {
    Names names;
    for(const auto& [input, text] : run_batch(arguments + " --output-folder out --resume", status))
      names.insert(fs::path(input).filename().string());
    return names;
  }

  Outcome m_outcome;
};

#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PROGRAM_FIXTURE_H
