// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_STAR_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_STAR_ENERGY_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Energy_derivatives_3.h>
#include <CGAL/Spherical_parameterization/internal/certificate/is_safely_positive.h>
#include <CGAL/Spherical_parameterization/internal/levels/Face_objective.h>
#include <CGAL/Spherical_parameterization/internal/levels/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/surface/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/surface/face_weights.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Whether both functions of an energy can be called for lanes of numbers. One that is written for `double` only is
// called for one lane after the other.
template <class Energy, class FT, class = void>
struct Is_lanewise : std::false_type
{};

template <class Energy, class FT>
struct Is_lanewise<
    Energy, FT,
    std::void_t<decltype(std::declval<const Energy&>()(std::declval<const FT&>(), std::declval<const FT&>())),
                decltype(std::declval<const Energy&>().derivatives(std::declval<const FT&>(),
                                                                   std::declval<const FT&>()))>> : std::true_type
{};

// The energy of a face as the descent evaluates it: in one lane or several, and, if the weight of the guard is
// positive, with that share of the area distortion d + 1 / d added, which keeps faces from shrinking without end where
// the energy itself does not mind.
template <class Energy>
class Face_energy
{
public:
  static constexpr bool weighs_faces_by_area = Weighs_faces_by_area<Energy>::value;

  explicit Face_energy(const Energy& energy, double guard = 0.)
    : m_energy(energy)
    , m_guard(guard)
  {}

  const Energy& energy() const { return m_energy; }
  bool is_guarded() const { return m_guard > 0.; }

  template <class FT>
  FT operator()(const FT& i, const FT& d) const
  {
    FT value = in_lanes(i, d);
    if(is_guarded())
      value += m_guard * (d + 1. / d);
    return value;
  }

  template <class FT>
  Energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const
  {
    Energy_derivatives_3<FT> e = derivatives_in_lanes(i, d);
    if(is_guarded())
    {
      const FT inverse_d = 1. / d;
      e.value += m_guard * (d + inverse_d);
      e.d += m_guard * (1. - inverse_d * inverse_d);
      e.dd += 2. * m_guard * inverse_d * inverse_d * inverse_d;
    }
    return e;
  }

private:
  template <class FT>
  FT in_lanes(const FT& i, const FT& d) const
  {
    if constexpr(Is_lanewise<Energy, FT>::value)
      return m_energy(i, d);
    else
      return FT::generate([&](std::size_t k) { return m_energy(lane(i, k), lane(d, k)); });
  }

  template <class FT>
  Energy_derivatives_3<FT> derivatives_in_lanes(const FT& i, const FT& d) const
  {
    if constexpr(Is_lanewise<Energy, FT>::value)
      return m_energy.derivatives(i, d);
    else
    {
      using Derivatives = Energy_derivatives_3<double>;
      Derivatives e[FT::width];
      for(std::size_t k = 0; k < FT::width; ++k)
        e[k] = m_energy.derivatives(lane(i, k), lane(d, k));
      const auto all = [&](auto member) { return FT::generate([&](std::size_t k) { return e[k].*member; }); };
      return {all(&Derivatives::value), all(&Derivatives::i),  all(&Derivatives::d),
              all(&Derivatives::ii),    all(&Derivatives::id), all(&Derivatives::dd)};
    }
  }

  Energy m_energy;
  double m_guard;
};

// The doubled area of the image of a face (x, p, q) as the energy sees it, as a function of its corner x. All corners
// are offsets from one point of the unit sphere, in the frame of that point; the centre of the sphere is at (0, 0, -1).
//
// This one is the determinant of the corners: the doubled area of the flat triangle times the distance of its plane
// from the centre. It agrees with the flat area for small faces, and is 0 exactly where a face turns over: the energy
// is a barrier there, and no face comes to lie across a great circle.
template <class FT>
class Determinant_measure
{
public:
  // the value at x = 0
  Determinant_measure(const Vector_3<FT>& p, const Vector_3<FT>& q)
  {
    // The normal p x q of the plane through p, q and the centre. As p and q are offsets of the size of the edge,
    // nothing cancels.
    const Vector_3<FT> n = cross(p, q);
    m_gradient = {n[0] + (p[1] - q[1]), n[1] + (q[0] - p[0]), n[2]};
  }
  Determinant_measure() = default;

  FT value() const { return m_gradient[2]; }
  FT dx() const { return m_gradient[0]; }
  FT dy() const { return m_gradient[1]; }
  // As x = (x, y, -(x^2 + y^2) / 2), up to higher order, the second derivatives follow from the height.
  FT dxx() const { return -m_gradient[2]; }
  FT dyy() const { return -m_gradient[2]; }

  // the value at x, given the determinant and the normal (p - x) x (q - x) there
  static FT value(const FT& determinant, const Vector_3<FT>& /* normal */) { return determinant; }

private:
  Vector_3<FT> m_gradient;
};

// The doubled area of the flat triangle, as in eq. 4 and 5 of the paper. It is positive where a face turns over, so
// that nothing but the test of every step prevents that, and faces may get stuck across a great circle. It goes with
// gradient steps, and has no second derivatives.
template <class FT>
class Flat_measure
{
public:
  Flat_measure(const Vector_3<FT>& p, const Vector_3<FT>& q)
  {
    // The normal (p - x) x (q - x) has the derivative dx x (p - q).
    const Vector_3<FT> n = cross(p, q), w = p - q;
    const Vector_3<FT> nx = {FT(0.), -w[2], w[1]}, ny = {w[2], FT(0.), -w[0]};
    m_value = length(n);
    const FT inverse = select(m_value > 0., 1. / m_value, FT(0.)); // no direction where there is no area
    m_dx = inverse * dot(n, nx);
    m_dy = inverse * dot(n, ny);
  }
  Flat_measure() = default;

  FT value() const { return m_value; }
  FT dx() const { return m_dx; }
  FT dy() const { return m_dy; }

  static FT value(const FT& /* determinant */, const Vector_3<FT>& normal) { return length(normal); }

private:
  FT m_value, m_dx, m_dy;
};

// The part of the objective that depends on one vertex, as a function of the two tangential coordinates of the vertex:
// the sum over the faces of its star of E or, if the sharpness s is positive, of s psi(E), see Face_objective, each times
// the area that the face has on the surface, if the energy weighs faces by it. Where there
// is no level R (eq. 7 of the paper), the largest energy of the star at its current state takes its place, which changes
// neither the minimiser nor the direction of the steps and never overflows there.
//
// One object serves many vertices: it only allocates when it meets a star larger than all before. With a packed number
// type it serves as many stars at once as that has lanes. It has mutable state, and is used by one thread at a time.
//
// Exponentials, whose operations have to wait for each other, are taken in loops of their own: the shorter a loop is,
// the more of its iterations are in flight at once.
template <class Energy, template <class> class Image_measure, class FT = double>
class Star_energy
{
public:
  explicit Star_energy(const Face_energy<Energy>& energy)
    : m_energy(energy)
  {}

  // The objective of the stars that come next: E is evaluated on the sphere of squared radius `squared_radius`.
  void set_objective(double squared_radius, const Face_objective& objective)
  {
    m_scale = squared_radius;
    m_sliver_scale = objective.sliver_radius > 0. ? objective.sliver_radius * objective.sliver_radius : squared_radius;
    m_objective = objective;
  }

  // Takes a star; the positions are on the unit sphere.
  void load(const Star_view<FT>& star, const Vector_3d* positions)
  {
    m_star = star;
    m_frame = Basic_tangent_frame<FT>(star.center(positions));
    const std::size_t size = star.size();
    if(m_faces.size() <= size)
      m_faces.resize(2 * size + 1);
    FT shortest = std::numeric_limits<double>::infinity();
    for(std::size_t j = 0; j < size; ++j)
    {
      m_faces[j].offset = m_frame.offset_of(star.neighbor(j, positions));
      shortest = minimum(shortest, squared_length(m_faces[j].offset));
    }
    m_faces[size].offset = m_faces[0].offset;
    m_squared_shortest_edge = shortest;

    m_max_energy = FT(0.);
    for(std::size_t j = 0; j < size; ++j)
    {
      Face& face = m_faces[j];
      const auto choose = [&](double ordinary, double sliver) {
        return select(star.is_at_sliver(j), FT(sliver), FT(ordinary));
      };
      face.scale = choose(m_scale, m_sliver_scale);
      face.sharpness = choose(m_objective.ordinary.sharpness, m_objective.of_slivers.sharpness);
      face.reach = choose(1., m_objective.ordinary.sharpness / m_objective.of_slivers.sharpness);
      face.level = choose(m_objective.ordinary.level, m_objective.of_slivers.level);
      const FT& scale = face.scale;
      const Vector_3<FT>&p = face.offset, &q = m_faces[j + 1].offset;
      face.fixed_i = scale * star.opposite_0(j) * squared_length(q - p); // the part of I that does not move
      face.measure = Measure(p, q);
      const FT inverse_doubled_area = star.inverse_doubled_area(j);
      const FT doubled_area = this->doubled_area(j);
      face.to_d = scale * inverse_doubled_area *
                  m_objective.area_factor(star.opposite_0(j), star.opposite_1(j), star.opposite_2(j), doubled_area);
      const FT i =
          face.fixed_i + scale * (star.opposite_2(j) * squared_length(p) + star.opposite_1(j) * squared_length(q));
      const FT d = unless_padding(j, face.to_d * face.measure.value(), FT(1.));
      face.energy = m_energy.derivatives(i, d);
      m_max_energy = maximum(m_max_energy, face.energy.value);
    }
    if(m_objective.is_average())
      return;
    for(std::size_t j = 0; j < size; ++j)
    {
      if(!m_objective.has_levels())
        m_faces[j].level = m_max_energy;
      m_faces[j].weight = weight_of(j, m_faces[j].energy.value);
    }
  }

  // the length of the shortest edge at the vertex, the yardstick of its steps
  FT shortest_edge() const { return square_root(m_squared_shortest_edge); }

  // the objective at the current position, relative to the largest energy, with its gradient and Hessian
  FT derivatives(std::array<FT, 2>& gradient, std::array<FT, 3>& hessian) const
  {
    return evaluate<true>(gradient, hessian);
  }

  // the same without the Hessian
  FT gradient(std::array<FT, 2>& gradient) const
  {
    std::array<FT, 3> unused;
    return evaluate<false>(gradient, unused);
  }

  // the objective with the vertex at the tangential coordinates (x, y), or infinity if a face is not safely positive
  // there
  FT operator()(const FT& x, const FT& y) const
  {
    auto is_valid = x * x + y * y < max_squared_step;
    const FT infinite = std::numeric_limits<double>::infinity();
    if(!any(is_valid))
      return infinite;
    const FT z = Basic_tangent_frame<FT>::height_at(x, y);
    FT f = 0.;
    for(std::size_t j = 0; j < m_star.size(); ++j)
    {
      const Vector_3<FT>&p = m_faces[j].offset, &q = m_faces[j + 1].offset;
      const Vector_3<FT> to_p = {p[0] - x, p[1] - y, p[2] - z}, to_q = {q[0] - x, q[1] - y, q[2] - z};
      const Vector_3<FT> n = cross(to_p, to_q);
      const FT determinant = x * n[0] + y * n[1] + (1. + z) * n[2];
      const FT lp = squared_length(to_p), lq = squared_length(to_q);
      is_valid = is_valid && (is_safely_positive(determinant, lp + lq) || is_padding(j));
      if constexpr(std::is_same<FT, double>::value) // in lanes, to look costs more than to go on
        if(!is_valid)
          return infinite;
      const FT& scale = m_faces[j].scale;
      const FT i = m_faces[j].fixed_i + scale * (m_star.opposite_2(j) * lp + m_star.opposite_1(j) * lq);
      const FT ratio = m_faces[j].to_d * Measure::value(determinant, n);
      const FT d = select(is_valid, unless_padding(j, ratio, FT(1.)), FT(1.)); // energies are for positive ones
      m_faces[j].new_energy = m_energy(i, d);
    }
    if(!any(is_valid))
      return infinite;
    for(std::size_t j = 0; j < m_star.size(); ++j)
    {
      const FT& energy = m_faces[j].new_energy;
      f += weighted(j, m_objective.is_average() ? unless_padding(j, energy, FT(0.))
                                                : value_of(j, energy, weight_of(j, energy)));
    }
    return select(is_valid, f, infinite);
  }

  Vector_3<FT> point_at(const FT& x, const FT& y) const { return m_frame.point_at(x, y); }

private:
  static constexpr double max_squared_step = 0.75; // no step leaves the cap of 60 degrees around the vertex

  using Measure = Image_measure<FT>;

  // what is known of face j, whose corners are the vertex and its neighbors j and j + 1
  struct Face
  {
    Vector_3<FT> offset; // of neighbor j
    Measure measure;
    FT fixed_i, scale, to_d;
    Energy_derivatives_3<FT> energy;
    FT sharpness, level;   // of its objective
    FT reach;              // the sharpness of the others over its own
    FT weight;             // a exp(s (E - R))
    mutable FT new_energy; // the last one of operator()
  };

  // whether row j is beyond the end of a star
  auto is_padding(std::size_t j) const
  {
    if constexpr(std::is_same<FT, double>::value)
      return false;
    else
      return !(m_star.inverse_doubled_area(j) > 0.);
  }
  FT unless_padding(std::size_t j, const FT& value, const FT& otherwise) const
  {
    if constexpr(std::is_same<FT, double>::value)
      return value;
    else
      return select(is_padding(j), otherwise, value);
  }

  // that of the face on the surface, or 1 for a padding row
  FT doubled_area(std::size_t j) const { return 1. / unless_padding(j, m_star.inverse_doubled_area(j), FT(1.)); }

  FT weighted(std::size_t j, const FT& value) const
  {
    if constexpr(Face_energy<Energy>::weighs_faces_by_area)
      return doubled_area(j) * value;
    else
      return value;
  }

  // a exp(s (E - R)), see Face_objective
  FT weight_of(std::size_t j, const FT& energy) const
  {
    return m_objective.share * exponential(m_faces[j].sharpness * (energy - m_faces[j].level));
  }

  double linear_weight() const { return m_objective.ordinary.sharpness * (1. - m_objective.share); }

  // s psi(E), given the weight; s is the sharpness of all faces but the slivers
  FT value_of(std::size_t j, const FT& energy, const FT& weight) const
  {
    return unless_padding(j, linear_weight() * energy + m_faces[j].reach * weight, FT(0.));
  }

  template <bool with_hessian>
  FT evaluate(std::array<FT, 2>& gradient, std::array<FT, 3>& hessian) const
  {
    const FT sharpness = m_objective.ordinary.sharpness;
    FT f = 0., gx = 0., gy = 0., hxx = 0., hxy = 0., hyy = 0.;
    for(std::size_t j = 0; j < m_star.size(); ++j)
    {
      const Vector_3<FT>&p = m_faces[j].offset, &q = m_faces[j + 1].offset;
      const Measure& measure = m_faces[j].measure;
      const FT& scale = m_faces[j].scale;
      const Energy_derivatives_3<FT>& e = m_faces[j].energy;
      const FT to_p = 2. * scale * m_star.opposite_2(j), to_q = 2. * scale * m_star.opposite_1(j);
      const FT ix = -(to_p * p[0] + to_q * q[0]), iy = -(to_p * p[1] + to_q * q[1]);
      const FT& to_d = m_faces[j].to_d;
      const FT dx = to_d * measure.dx(), dy = to_d * measure.dy();
      FT ex = e.i * ix + e.d * dx, ey = e.i * iy + e.d * dy;
      FT exx = 0., exy = 0., eyy = 0.;
      if constexpr(with_hessian)
      {
        const FT i2 = to_p * (1. + p[2]) + to_q * (1. + q[2]);
        exx = e.i * i2 + e.d * (to_d * measure.dxx()) + e.ii * ix * ix + 2. * e.id * ix * dx + e.dd * dx * dx;
        exy = e.ii * ix * iy + e.id * (ix * dy + iy * dx) + e.dd * dx * dy;
        eyy = e.i * i2 + e.d * (to_d * measure.dyy()) + e.ii * iy * iy + 2. * e.id * iy * dy + e.dd * dy * dy;
      }
      // The rest shape of a padding row is 0, and so are its derivatives.
      if(m_objective.is_average())
        f += weighted(j, unless_padding(j, e.value, FT(0.)));
      else
      {
        const FT& weight = m_faces[j].weight;
        const FT first = linear_weight() + sharpness * weight, second = sharpness * m_faces[j].sharpness * weight;
        f += weighted(j, value_of(j, e.value, weight));
        if constexpr(with_hessian)
        {
          exx = first * exx + second * ex * ex;
          exy = first * exy + second * ex * ey;
          eyy = first * eyy + second * ey * ey;
        }
        ex *= first;
        ey *= first;
      }
      gx += weighted(j, ex);
      gy += weighted(j, ey);
      hxx += weighted(j, exx);
      hxy += weighted(j, exy);
      hyy += weighted(j, eyy);
    }
    gradient = {gx, gy};
    hessian = {hxx, hxy, hyy};
    return f;
  }

  Face_energy<Energy> m_energy;
  double m_scale = 1., m_sliver_scale = 1.;
  Face_objective m_objective;

  Star_view<FT> m_star;
  Basic_tangent_frame<FT> m_frame = Basic_tangent_frame<FT>({FT(0.), FT(0.), FT(1.)});
  std::vector<Face> m_faces;
  FT m_squared_shortest_edge = 0., m_max_energy = 0.;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LEVELS_STAR_ENERGY_H
