// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_UPDATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_UPDATE_H

#include <CGAL/Spherical_parameterization/Gradient_update_3.h>
#include <CGAL/Spherical_parameterization/Newton_update_3.h>

#include <array>
#include <variant>

namespace Program {

/// A vertex update that is chosen at run time: one model of `VertexUpdate_3` for all, as `Any_sharpness` is one of its
/// concept. It is asked once per vertex and then evaluates a whole star, beside which the choice costs nothing; but it does
/// not move several vertices at once, as the Newton update by itself does.
class Any_update
{
public:
  using Update = std::variant<CGAL::Spherical_parameterization::Newton_update_3,
                              CGAL::Spherical_parameterization::Gradient_update_3>;

  Any_update() = default;

  Any_update(const Update& update)
    : m_update(update)
  {}

  /// returns the Newton update, or null if it is another one.
  const CGAL::Spherical_parameterization::Newton_update_3* newton() const
  {
    return std::get_if<CGAL::Spherical_parameterization::Newton_update_3>(&m_update);
  }

  /// returns what the update says of the levels of a hierarchy, which is the Newton update alone.
  Any_update on_coarse_levels() const { return newton() ? Any_update(Update(newton()->on_coarse_levels())) : *this; }

  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const
  {
    return std::visit([&](const auto& update) { return update(energy, step); }, m_update);
  }

private:
  Update m_update;
};

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_ANY_UPDATE_H
