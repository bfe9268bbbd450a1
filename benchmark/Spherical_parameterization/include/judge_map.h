// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_JUDGE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_JUDGE_MAP_H

#include "Map_judge.h"
#include "run_in_child_process.h"

#include <array>
#include <exception>
#include <limits>
#include <string>

namespace benchmarks {

// What `Map_judge` says, in the form that goes through a pipe.
struct Map_judgement
{
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  std::array<char, 256> fault{}; // why it is no one-to-one map; empty if it is one
  double vertices = unknown;     // the rest is known if there are images of all vertices
  double folded_faces = unknown; // or faces without area
  Map_distortion isometric = {unknown, unknown};
  Map_distortion angle = {unknown, unknown};

  bool is_one_to_one() const { return fault[0] == 0; }
  void fail(const std::string& message) { message.copy(fault.data(), fault.size() - 1); }
};

// Judges the map that `make_judge()` has read, in a process of its own: a file can hold anything, and the calling
// process stays small, as all that it starts begins with its memory.
template <class MakeJudge>
Map_judgement judge_map(const MakeJudge& make_judge, double largest_deviation = Map_judge::default_deviation)
{
  const auto judge = [&] {
    Map_judgement judgement;
    try
    {
      const Map_judge map = make_judge();
      judgement.vertices = static_cast<double>(map.number_of_vertices());
      judgement.folded_faces = static_cast<double>(map.number_of_folded_faces());
      judgement.isometric = map.isometric_distortion();
      judgement.angle = map.angle_distortion();
      map.check(largest_deviation);
    }
    catch(const std::exception& error)
    {
      judgement.fail(error.what());
    }
    return judgement;
  };
  try
  {
    return run_in_child_process(judge);
  }
  catch(const std::exception& error)
  {
    Map_judgement judgement;
    judgement.fail("the map cannot be judged: " + std::string(error.what()));
    return judgement;
  }
}

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_JUDGE_MAP_H
