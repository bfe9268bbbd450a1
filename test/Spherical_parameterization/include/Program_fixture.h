// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PROGRAM_FIXTURE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PROGRAM_FIXTURE_H

// What the tests of the command line program have in common: a folder of their own, files in it, and runs within it.

// In CGAL's tree the examples are not built along with the tests.
#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#define BOOST_BIND_GLOBAL_PLACEHOLDERS // Boost's JSON parser uses them, and says so in every compilation otherwise
#endif

#include "test_meshes.h"

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

inline std::string content(const std::filesystem::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// A tetrahedron with a right angle, as text.
inline const std::string corner_off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
inline const std::string corner_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
inline const std::string corner_stl =
    "solid facet of a corner\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 1 0\nvertex 0 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "endsolid\n";

// what the program says of a map between surfaces that may be wrong
constexpr const char* uncertain =
    "it is not clear that the surfaces lie well on each other: look at the map, for example with "
    "--page, or give --landmarks\n";

struct Outcome
{
  int status;
  std::string out, err;
};

class Program_fixture : public ::testing::Test
{
protected:
  // a folder of its own for each test
  void SetUp() override
  {
    m_folder = std::filesystem::path("program") / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(m_folder);
    std::filesystem::create_directories(m_folder);
  }

  std::filesystem::path path(const std::string& name) const { return m_folder / name; }

  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  void write_off(const std::string& name, const test_meshes::Triangle_list& list) const
  {
    std::ofstream out(path(name));
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

  void expect_message(const std::string& arguments, const std::string& part_of_message) const
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find(part_of_message), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  }

  boost::property_tree::ptree json(const std::string& name = "result.json") const
  {
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(path(name).string(), tree);
    return tree;
  }

  // the names of all that is in the folder, or in one of its folders
  std::set<std::string> names_of_files(const std::string& folder = ".") const
  {
    std::set<std::string> names;
    for(const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(path(folder)))
      names.insert(entry.path().filename().string());
    return names;
  }

private:
  std::filesystem::path m_folder;
};

#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PROGRAM_FIXTURE_H
