// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_RUN_PROGRAM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_RUN_PROGRAM_H

#include <boost/program_options.hpp>

#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace benchmarks {

// What every benchmark does around its own work: adds `inputs`, the meshes, and the options --help and --csv to its
// `options`, reads the command line, and calls `run(values)`, whose result becomes the exit status. Reports exceptions.
template <class Run>
int run_program(int argc, char* argv[], const std::string& purpose, boost::program_options::options_description options,
                const Run& run)
{
  namespace po = boost::program_options;

  options.add_options()("csv", po::bool_switch(), "print comma-separated values instead of Markdown");
  options.add_options()("help,h", po::bool_switch(), "print this text");
  po::options_description all_options;
  all_options.add(options).add_options()("inputs", po::value<std::vector<std::string>>());
  try
  {
    po::variables_map values;
    po::store(po::command_line_parser(argc, argv)
                  .options(all_options)
                  .positional(po::positional_options_description().add("inputs", -1))
                  .run(),
              values);
    po::notify(values);
    if(values["help"].as<bool>())
    {
      std::cout << "Usage: " << argv[0] << " [OPTIONS] FILE_OR_FOLDER...\n" << purpose << "\n\n" << options;
      return 0;
    }
    if(values.count("inputs") == 0)
    {
      throw po::error("Give a mesh or a folder of meshes, or --help.");
    }
    return run(values);
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_RUN_PROGRAM_H
