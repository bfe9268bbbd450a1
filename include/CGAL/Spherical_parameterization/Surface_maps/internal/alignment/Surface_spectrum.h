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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_SPECTRUM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_SPECTRUM_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/numbers/Sparse_factorization.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface_diffusion.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/surface/vertex_scalars.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// The lowest eigenvalues and eigenfunctions, except the constant one, of the Laplacian of a small surface of area 1: L x = lambda M x,
// with cotangents in L and areas in M. They change little when the surface is bent.
//
// They are computed by Lanczos' method with the inverse of L + M and full orthogonalization, in a fixed order of summation, so that
// results are bitwise identical on all machines. Of several functions with the same eigenvalue, as on symmetric surfaces, possibly
// only one is found. If the factorization fails, there are no functions.
class Surface_spectrum
{
public:
  Surface_spectrum(const Vertex_rings& rings, const Surface_diffusion& diffusion)
    : m_roots(diffusion.areas())
  {
    for(double& root : m_roots)
      root = std::sqrt(root);
    if(factorize(rings, diffusion))
      iterate();
  }

  std::size_t number_of_functions() const { return m_values.size(); }
  double value(std::size_t k) const { return m_values[k]; }

  // The functions, normalized to mean square 1.
  const std::vector<Vertex_scalars>& functions() const { return m_functions; }

  // The wave kernel signature at the logarithm of an eigenvalue: the mean square of the functions with eigenvalues near it
  // (Aubry, Schlickewei and Cremers, The Wave Kernel Signature, 2011).
  Vertex_scalars wave_kernel_signature(double energy, double width) const
  {
    Vertex_scalars result(m_roots.size(), 0.);
    double total = 0.;
    for(std::size_t k = 0; k < m_values.size(); ++k)
    {
      const double d = (energy - logarithm(m_values[k])) / width, weight = exponential(-0.5 * d * d);
      total += weight;
      for(std::size_t v = 0; v < result.size(); ++v)
        result[v] += weight * m_functions[k][v] * m_functions[k][v];
    }
    for(double& x : result)
      x = total > 0. ? x / total : 0.;
    return result;
  }

private:
  using Vector = std::vector<double>;

  // An elimination order with little fill-in: a vertex with the fewest neighbors is eliminated next.
  static std::vector<std::uint32_t> elimination_order(const Vertex_rings& rings, std::size_t n)
  {
    std::vector<std::vector<std::uint32_t>> neighbors(n);
    for(std::uint32_t v = 0; v < n; ++v)
    {
      const Vertex_rings::Ring ring = rings.ring(v);
      neighbors[v].assign(ring.begin(), ring.end());
      std::sort(neighbors[v].begin(), neighbors[v].end());
    }
    std::vector<std::uint32_t> order, merged, left(n);
    std::iota(left.begin(), left.end(), 0u);
    while(!left.empty())
    {
      const auto next = std::min_element(left.begin(), left.end(), [&](std::uint32_t v, std::uint32_t w) {
        return std::pair(neighbors[v].size(), v) < std::pair(neighbors[w].size(), w);
      });
      const std::uint32_t v = *next;
      left.erase(next);
      order.push_back(v);
      for(const std::uint32_t w : neighbors[v])
      {
        merged.clear();
        std::set_union(neighbors[w].begin(), neighbors[w].end(), neighbors[v].begin(), neighbors[v].end(),
                       std::back_inserter(merged));
        merged.erase(std::remove_if(merged.begin(), merged.end(), [&](std::uint32_t u) { return u == v || u == w; }),
                     merged.end());
        neighbors[w] = merged;
      }
    }
    return order;
  }

  // Factorizes L + M; returns false on failure.
  bool factorize(const Vertex_rings& rings, const Surface_diffusion& diffusion)
  {
    const std::size_t n = m_roots.size();
    m_order = elimination_order(rings, n);
    std::vector<std::uint32_t> position(n);
    for(std::uint32_t k = 0; k < n; ++k)
      position[m_order[k]] = k;
    Symmetric_matrix matrix;
    std::vector<std::pair<std::uint32_t, double>> column;
    for(std::uint32_t k = 0; k < n; ++k)
    {
      const std::uint32_t v = m_order[k];
      const Vertex_rings::Ring ring = rings.ring(v);
      double sum = diffusion.areas()[v];
      column.clear();
      for(std::size_t j = 0; j < ring.size(); ++j)
      {
        const double weight = diffusion.weight(v, j);
        sum += weight;
        if(position[ring[j]] > k)
          column.emplace_back(position[ring[j]], -weight);
      }
      std::sort(column.begin(), column.end());
      matrix.rows.push_back(k);
      matrix.values.push_back(sum);
      for(const auto& [row, value] : column)
      {
        matrix.rows.push_back(row);
        matrix.values.push_back(value);
      }
      matrix.starts.push_back(matrix.rows.size());
    }
    m_factorization.emplace(matrix);
    return m_factorization->factorize(matrix, [] { return true; });
  }

  // Applies the inverse of M^-1/2 L M^-1/2 + 1, which has the same eigenfunctions up to the factor M^1/2.
  Vector inverse(const Vector& x) const
  {
    Vector y(x.size());
    for(std::size_t k = 0; k < x.size(); ++k)
      y[k] = m_roots[m_order[k]] * x[m_order[k]];
    m_factorization->solve(y);
    Vector result(x.size());
    for(std::size_t k = 0; k < x.size(); ++k)
      result[m_order[k]] = m_roots[m_order[k]] * y[k];
    return result;
  }

  void iterate()
  {
    // The functions beyond half of the number of steps are not accurate yet.
    constexpr std::size_t max_functions = 100, max_steps = 210;
    constexpr double least_length = 1e-13; // of a vector that is linearly independent of the basis
    const std::size_t n = m_roots.size(), n_steps = (std::min)(max_steps, n - 1);
    std::vector<Vector> basis = {m_roots}; // the constant function is known
    scale(basis[0], 1. / std::sqrt(sum_of_products(m_roots, m_roots)));
    // Returns the remaining length. If little remains, another round removes rounding errors (Parlett, The Symmetric Eigenvalue Problem,
    // section 6.9).
    const auto orthogonalize = [&](Vector& x) {
      constexpr double enough = 0.7; // of the length; otherwise, rounding errors may not be orthogonal
      const auto length_of = [](const Vector& y) { return std::sqrt(sum_of_products(y, y)); };
      double before, after = length_of(x);
      do
      {
        before = after;
        for(const Vector& b : basis)
          add_multiple(-sum_of_products(b, x), b, x);
        after = length_of(x);
      } while(after > least_length && after < enough * before);
      return after;
    };
    Vector next(n), diagonal, beside;
    std::uint32_t random = 1;
    for(double& x : next)
    {
      random = random * 1664525u + 1013904223u;
      x = static_cast<double>(random >> 8) * 0x1p-24 - 0.5;
    }
    double length = orthogonalize(next);
    while(diagonal.size() < n_steps && length > least_length)
    {
      scale(next, 1. / length);
      basis.push_back(std::move(next));
      next = inverse(basis.back());
      diagonal.push_back(sum_of_products(basis.back(), next));
      length = orthogonalize(next);
      beside.push_back(length);
    }
    const std::size_t m = diagonal.size();
    const std::vector<Vector> vectors = diagonalize(diagonal, std::move(beside));
    std::vector<std::size_t> order(m);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return diagonal[i] > diagonal[j]; });
    const bool is_complete = m < max_steps; // The vectors span the whole space.
    order.resize((std::min)(max_functions, is_complete ? m : m / 2));
    for(const std::size_t i : order)
    {
      Vector x(n, 0.);
      for(std::size_t j = 0; j < m; ++j)
        add_multiple(vectors[i][j], basis[j + 1], x);
      for(std::size_t v = 0; v < n; ++v)
        x[v] /= m_roots[v];
      // It is about 1 for a surface with long extremities; smaller values are rounding errors.
      constexpr double least_value = 1e-3;
      m_values.push_back((std::max)(1. / diagonal[i] - 1., least_value));
      m_functions.push_back(std::move(x));
    }
  }

  static void scale(Vector& x, double factor)
  {
    for(double& value : x)
      value *= factor;
  }

  // Replaces the diagonal of a symmetric tridiagonal matrix by its eigenvalues, by implicit QL steps (Golub and Van Loan, Matrix
  // Computations, section 8.3), and returns the eigenvectors. Entry k of `e` couples the entries k and k + 1 of the diagonal.
  static std::vector<Vector> diagonalize(Vector& d, Vector e)
  {
    constexpr int max_steps = 60; // for each eigenvalue; two or three are usual
    constexpr double negligible = 1e-16;
    const std::size_t n = d.size();
    std::vector<Vector> z(n, Vector(n, 0.));
    for(std::size_t i = 0; i < n; ++i)
      z[i][i] = 1.;
    for(std::size_t l = 0; l < n; ++l)
      for(int step = 0; step < max_steps; ++step)
      {
        std::size_t m = l;
        while(m + 1 < n && std::abs(e[m]) > negligible * (std::abs(d[m]) + std::abs(d[m + 1])))
          ++m;
        if(m == l)
          break;
        // A rotation for each pair of rows from m down to l, which chases the entry outside of the three diagonals upwards until it
        // vanishes.
        const double half = (d[l + 1] - d[l]) / (2. * e[l]), root = std::sqrt(half * half + 1.);
        double g = d[m] - d[l] + e[l] / (half + (half >= 0. ? root : -root)), s = 1., c = 1., p = 0.;
        bool falls_apart = false;
        for(std::size_t i = m; i-- > l && !falls_apart;)
        {
          const double f = s * e[i], b = c * e[i], r = std::sqrt(f * f + g * g);
          e[i + 1] = r;
          falls_apart = r == 0.;
          if(falls_apart)
          {
            d[i + 1] -= p;
            continue;
          }
          s = f / r;
          c = g / r;
          const double x = d[i + 1] - p, t = (d[i] - x) * s + 2. * c * b;
          p = s * t;
          d[i + 1] = x + p;
          g = c * t - b;
          for(std::size_t k = 0; k < n; ++k)
          {
            const double z1 = z[i + 1][k], z0 = z[i][k];
            z[i + 1][k] = s * z0 + c * z1;
            z[i][k] = c * z0 - s * z1;
          }
        }
        if(!falls_apart)
        {
          d[l] -= p;
          e[l] = g;
        }
        e[m] = 0.;
      }
    return z;
  }

  Vector m_roots;                     // the square roots of the areas
  std::vector<std::uint32_t> m_order; // the elimination order of the vertices
  std::optional<Sparse_factorization> m_factorization;
  Vector m_values;
  std::vector<Vertex_scalars> m_functions;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SURFACE_MAPS_INTERNAL_ALIGNMENT_SURFACE_SPECTRUM_H
