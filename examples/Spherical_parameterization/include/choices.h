// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_CHOICES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_CHOICES_H

#include "Word.h"

#include <array>

namespace Program {

enum class Method_choice
{
  BLD,
  HIERARCHICAL,
  HARMONIC,
  CONFORMAL,
  ARAP,
  STEREOGRAPHIC
};

constexpr std::array<Word<Method_choice>, 6> methods = {{{"bld", Method_choice::BLD},
                                                         {"hierarchical", Method_choice::HIERARCHICAL},
                                                         {"harmonic", Method_choice::HARMONIC},
                                                         {"conformal", Method_choice::CONFORMAL},
                                                         {"arap", Method_choice::ARAP},
                                                         {"stereographic", Method_choice::STEREOGRAPHIC}}};

enum class Energy_choice
{
  SYMMETRIC_DIRICHLET,
  ISOMETRIC,
  CONFORMAL
};

constexpr std::array<Word<Energy_choice>, 3> energies = {{{"symmetric-dirichlet", Energy_choice::SYMMETRIC_DIRICHLET},
                                                          {"isometric", Energy_choice::ISOMETRIC},
                                                          {"conformal", Energy_choice::CONFORMAL}}};

/// Where a method that improves a map starts. A map from a file is no word.
enum class Start_choice
{
  HIERARCHICAL,
  STEREOGRAPHIC,
  HARMONIC,
  CONFORMAL,
  PRECOMPUTED
};

constexpr std::array<Word<Start_choice>, 4> starts = {{{"hierarchical", Start_choice::HIERARCHICAL},
                                                       {"stereographic", Start_choice::STEREOGRAPHIC},
                                                       {"harmonic", Start_choice::HARMONIC},
                                                       {"conformal", Start_choice::CONFORMAL}}};

enum class Update_choice
{
  NEWTON,
  GRADIENT
};

constexpr std::array<Word<Update_choice>, 2> updates = {
    {{"newton", Update_choice::NEWTON}, {"gradient", Update_choice::GRADIENT}}};

enum class Barrier_choice
{
  DETERMINANT,
  FLAT
};

constexpr std::array<Word<Barrier_choice>, 2> barriers = {
    {{"determinant", Barrier_choice::DETERMINANT}, {"flat", Barrier_choice::FLAT}}};

/// The values of --prefer: which sharpness they are.
constexpr std::array<Word<double>, 3> preferences = {{{"average", 0.}, {"balance", 13.5}, {"worst", 50.}}};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_CHOICES_H
