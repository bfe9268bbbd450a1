// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_COLOR_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_COLOR_MAP_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace Program {

/// returns a colour for `t` in [0, 1], from dark violet to light yellow, as red, green and blue in [0, 255].
///
/// Equal steps of `t` look alike: the lightness grows evenly in Oklab, Ottosson's perceptually uniform space, while the hue
/// turns through blue and green, so that the order is visible on a grey print and with colour blindness.
inline std::array<int, 3> color_of(double t)
{
  constexpr double first_lightness = 0.3, last_lightness = 0.93;
  constexpr double first_hue = 5.2, last_hue = 1.85;       // in radians
  constexpr double first_chroma = 0.1, last_chroma = 0.16; // all that sRGB holds along this way

  t = (std::min)((std::max)(t, 0.), 1.);
  const double lightness = first_lightness + t * (last_lightness - first_lightness);
  const double hue = first_hue + t * (last_hue - first_hue);
  const double chroma = first_chroma + t * t * t * t * (last_chroma - first_chroma);
  const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);

  // Oklab to linear sRGB
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const std::array<double, 3> linear = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                                        -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                                        -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  std::array<int, 3> rgb{};
  for(std::size_t i = 0; i < 3; ++i)
  {
    const double x = (std::min)((std::max)(linear[i], 0.), 1.);
    const double gamma = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1. / 2.4) - 0.055;
    rgb[i] = static_cast<int>(std::lround(255. * gamma));
  }
  return rgb;
}

} // namespace Program

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXAMPLES_COLOR_MAP_H
