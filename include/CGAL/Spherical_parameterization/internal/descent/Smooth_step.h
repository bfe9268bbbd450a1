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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_SMOOTH_STEP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_SMOOTH_STEP_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/internal/descent/Face_energy.h>
#include <CGAL/Spherical_parameterization/internal/descent/Measured_faces.h>
#include <CGAL/Spherical_parameterization/internal/descent/Sphere_cells.h>
#include <CGAL/Spherical_parameterization/internal/descent/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/descent/Strain_sums.h>
#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>
#include <CGAL/Spherical_parameterization/internal/execution/parallel.h>
#include <CGAL/Spherical_parameterization/internal/numbers/Vector_3.h>
#include <CGAL/Spherical_parameterization/internal/numbers/conjugate_gradients.h>
#include <CGAL/Spherical_parameterization/internal/numbers/elementary_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// A step of all vertices at once, by a deformation of the sphere. Sweeps reduce smooth components of the error slowly,
// the more slowly the finer the mesh, and the worst faces depend on them, because the area that they need comes from
// distant parts. The deformation is linear in the cells of a grid that is much coarser than the mesh. It is one step of
// Newton's method for the objective of the mesh itself, in the nodes, the level R and the radius together. So no coarse
// mesh is involved whose energies would have to agree with those of the mesh.
template <class Space>
class Smooth_step
{
public:
  // `has_radius` is true if the radius is a variable.
  Smooth_step(const Space& space, std::size_t n_vertices, bool has_radius)
    : m_cells(grid_size(n_vertices))
    , m_sums(space)
    , m_has_radius(has_radius)
  {}

  // Computes the step for the current map, and returns whether there is one.
  bool find(const Measured_faces& faces, const Star_packets& stars, const std::vector<Vector_3d>& positions,
            double radius, const Face_objective& objective, Execution execution)
  {
    m_sums.sum_up(m_cells, faces, stars, positions, radius, objective, execution);
    assemble(execution);
    return solve();
  }

  // Makes the fraction t of the step, starting from `positions`.
  void move(const std::vector<Vector_3d>& positions, double t, std::vector<Vector_3d>& moved, Execution execution) const
  {
    constexpr std::size_t block_size = 256; // about five microseconds
    moved.resize(positions.size());
    for_each_block(execution, 0, positions.size(), block_size, [&](std::size_t begin, std::size_t end) {
      run_in_lanes([&](auto number_type) {
        using FT = typename decltype(number_type)::FT;
        constexpr std::size_t width = Lanes<FT>::width;
        for(std::size_t first = begin; first < end; first += width)
        {
          std::array<std::uint32_t, width> vertices;
          for(std::size_t k = 0; k < width; ++k)
            vertices[k] = static_cast<std::uint32_t>((std::min)(first + k, end - 1));
          const Vector_3<FT> p = points_in_lanes<FT>(vertices.data(), positions.data());
          const Vector_3<FT> q = normalized<FT>(p + FT(t) * m_cells.step_at<FT>(p, m_steps));
          for(std::size_t k = 0; k < width && first + k < end; ++k)
            moved[first + k] = {lane(q[0], k), lane(q[1], k), lane(q[2], k)};
        }
      });
    });
  }

  // The increment of R and the factor of the radius.
  double level_step(double t) const { return t * m_level_step; }
  double radius_factor(double t) const { return exponential(t * m_log_radius_step); }

private:
  using Matrix_6 = std::array<std::array<double, 6>, 6>;

  // The number of nodes is limited, because one thread solves the equations; for a million vertices or more, they would
  // cost too much.
  static constexpr std::size_t vertices_per_node = 64, max_nodes = 20000;

  // The number of squares along an edge of the cube, which has six sides.
  static std::size_t grid_size(std::size_t n_vertices)
  {
    const std::size_t n_nodes = (std::min)(n_vertices / vertices_per_node, max_nodes);
    return (std::max)(static_cast<std::size_t>(std::sqrt(static_cast<double>(n_nodes) / 6.)), std::size_t(2));
  }

  // Sets up the equations: the matrix of each cell, those of R and t, and the right-hand side.
  void assemble(Execution execution)
  {
    const std::size_t n_cells = m_cells.cells().size(), n_nodes = m_cells.frames().size();
    double mean_trace = 0.;
    for(std::size_t c = 0; c < n_cells; ++c)
      mean_trace += trace(m_sums.hessian(c)) / static_cast<double>(n_cells);
    m_matrices.resize(n_cells);
    constexpr std::size_t cells_per_block = 16; // about ten microseconds
    for_each_in_blocks(execution, 0, n_cells, cells_per_block, [&](std::size_t c) {
      m_matrices[c] = matrix_of_nodes(made_positive(m_sums.hessian(c), mean_trace), m_cells.cells()[c].motions);
    });

    m_right.assign(2 * n_nodes + 2, 0.);
    m_columns.assign(2 * n_nodes, {0., 0.});
    m_diagonal.assign(n_nodes, {0., 0., 0.});
    // A variable that the objective does not have, or in which its curvature is negative, is fixed.
    const auto [r, t, rr, rt, tt] = m_sums.of_level_and_radius();
    const bool moves_level = rr > 0., moves_radius = m_has_radius && tt > 0.;
    m_right[2 * n_nodes] = moves_level ? -r : 0.;
    m_right[2 * n_nodes + 1] = moves_radius ? -t : 0.;
    m_last_block = {moves_level ? rr : 1., moves_level && moves_radius ? rt : 0., moves_radius ? tt : 1.};
    for(std::size_t c = 0; c < n_cells; ++c)
    {
      const Sphere_cells::Cell& cell = m_cells.cells()[c];
      if(cell.is_empty())
        continue;
      const auto along = [&](std::size_t k, const std::array<double, 4>& gradient) {
        return inner_product(gradient, cell.motions[k]);
      };
      for(std::size_t k = 0; k < 6; ++k)
      {
        const std::size_t row = 2 * cell.nodes[k / 2] + k % 2;
        m_right[row] -= along(k, m_sums.gradient(c));
        if(moves_level)
          m_columns[row][0] += along(k, m_sums.gradient_in_level(c));
        if(moves_radius)
          m_columns[row][1] += along(k, m_sums.gradient_in_radius(c));
      }
      for(std::size_t k = 0; k < 3; ++k)
      {
        std::array<double, 3>& block = m_diagonal[cell.nodes[k]];
        block[0] += m_matrices[c][2 * k][2 * k];
        block[1] += m_matrices[c][2 * k][2 * k + 1];
        block[2] += m_matrices[c][2 * k + 1][2 * k + 1];
      }
    }
  }

  static Matrix_6 matrix_of_nodes(const Matrix_4& h, const std::array<std::array<double, 4>, 6>& motions)
  {
    Matrix_6 result;
    for(std::size_t k = 0; k < 6; ++k)
    {
      std::array<double, 4> image;
      for(std::size_t i = 0; i < 4; ++i)
        image[i] = inner_product(h[i], motions[k]);
      for(std::size_t l = 0; l < 6; ++l)
        result[l][k] = inner_product(image, motions[l]);
    }
    return result;
  }

  static double trace(const Matrix_4& h) { return h[0][0] + h[1][1] + h[2][2] + h[3][3]; }

  // Adds to the diagonal: a small multiple of the mean over the cells, for cells without faces, and as much as is
  // necessary to make the matrix positive definite, since compressed faces have directions of negative curvature.
  static Matrix_4 made_positive(const Matrix_4& h, double mean_trace)
  {
    constexpr double fraction_of_mean = 1e-3, first_shift = 2.5e-3, last_shift = 1e3;
    Matrix_4 result = h;
    for(double shift = 0.; shift < last_shift; shift = (std::max)(2. * shift, first_shift))
    {
      for(std::size_t k = 0; k < 4; ++k)
        result[k][k] = h[k][k] + shift * std::abs(trace(h)) + fraction_of_mean * mean_trace;
      if(is_positive_definite(result))
        return result;
    }
    result = Matrix_4();
    for(std::size_t k = 0; k < 4; ++k)
      result[k][k] = std::abs(mean_trace);
    return result;
  }

  // By Cholesky factorization.
  static bool is_positive_definite(Matrix_4 h)
  {
    for(std::size_t k = 0; k < 4; ++k)
    {
      if(!(h[k][k] > 0.))
        return false;
      for(std::size_t i = k + 1; i < 4; ++i)
        for(std::size_t j = k + 1; j <= i; ++j)
          h[i][j] -= h[i][k] * h[j][k] / h[k][k];
    }
    return true;
  }

  // Conjugate gradients, preconditioned by the blocks of the nodes. The iteration ends early, because the next step
  // corrects the remaining error.
  bool solve()
  {
    constexpr double tolerance = 0.1;
    constexpr std::size_t max_rounds = 200; // about ten are usual
    const std::size_t n = m_right.size();
    std::vector<double> x(n, 0.), residual = m_right;
    conjugate_gradients(
        x, residual,
        [this](const std::vector<double>& p, std::vector<double>& image) {
          multiply(p, image);
          return inner_product(p, image);
        },
        [this](const std::vector<double>& r, std::vector<double>& z) {
          precondition(r, z);
          return inner_product(r, z);
        },
        [](std::size_t k, double size, double first_size, double step) { // a step of 0 indicates non-positive curvature
          return k < max_rounds && size > tolerance * tolerance * first_size && step > 0.;
        });
    m_steps.clear();
    for(const Tangent_frame& frame : m_cells.frames())
    {
      const std::size_t k = 2 * m_steps.size();
      m_steps.push_back(frame.vector_of(x[k], x[k + 1]));
    }
    m_level_step = x[n - 2];
    m_log_radius_step = x[n - 1];
    return is_positive_and_finite(inner_product(x, x));
  }

  void precondition(const std::vector<double>& r, std::vector<double>& z) const
  {
    for(std::size_t k = 0; k < m_diagonal.size(); ++k)
    {
      const auto& [a, b, c] = m_diagonal[k];
      const double inverse = 1. / (a * c - b * b);
      z[2 * k] = inverse * (c * r[2 * k] - b * r[2 * k + 1]);
      z[2 * k + 1] = inverse * (a * r[2 * k + 1] - b * r[2 * k]);
    }
    const std::size_t n = r.size();
    z[n - 2] = r[n - 2] / m_last_block[0];
    z[n - 1] = r[n - 1] / m_last_block[2];
  }

  void multiply(const std::vector<double>& x, std::vector<double>& result) const
  {
    const std::size_t n = x.size();
    const auto [rr, rt, tt] = m_last_block;
    std::fill(result.begin(), result.end(), 0.);
    result[n - 2] = rr * x[n - 2] + rt * x[n - 1];
    result[n - 1] = rt * x[n - 2] + tt * x[n - 1];
    for(std::size_t i = 0; i + 2 < n; ++i)
      for(std::size_t k = 0; k < 2; ++k)
      {
        result[i] += m_columns[i][k] * x[n - 2 + k];
        result[n - 2 + k] += m_columns[i][k] * x[i];
      }
    for(std::size_t c = 0; c < m_matrices.size(); ++c)
    {
      const auto& nodes = m_cells.cells()[c].nodes;
      std::array<double, 6> local;
      for(std::size_t k = 0; k < 6; ++k)
        local[k] = x[2 * nodes[k / 2] + k % 2];
      for(std::size_t k = 0; k < 6; ++k)
        result[2 * nodes[k / 2] + k % 2] += inner_product(local, m_matrices[c][k]);
    }
  }

  Sphere_cells m_cells;
  Strain_sums<Space> m_sums;
  bool m_has_radius;
  std::vector<Matrix_6> m_matrices;              // of the cells
  std::vector<std::array<double, 2>> m_columns;  // of R and t, in the rows of the nodes
  std::array<double, 3> m_last_block = {};       // R R, R t and t t
  std::vector<std::array<double, 3>> m_diagonal; // the diagonal block of each node
  std::vector<double> m_right;                   // two entries of each node, then R and t
  std::vector<Vector_3d> m_steps;                // of the nodes
  double m_level_step = 0., m_log_radius_step = 0.;
};

// The schedule of smooth steps: before every other sweep, and less often while a step gains less than a sweep. Both
// take about the same time.
class Smooth_step_schedule
{
public:
  static constexpr std::size_t min_interval = 2; // in sweeps

  bool is_due(std::size_t sweep) const { return sweep >= m_next; }

  // Called after a step before this sweep, with the values of the objective before and after it.
  void has_made(std::size_t sweep, double value_before, double value_after)
  {
    const double gain_of_sweeps = (m_last_value - value_before) / static_cast<double>(m_interval);
    m_interval = value_before - value_after < gain_of_sweeps ? (std::min)(2 * m_interval, max_interval) : min_interval;
    m_last = sweep;
    m_next = sweep + m_interval;
    m_last_value = value_after;
  }

  // Whether the changes of the sweeps from `begin` on can indicate convergence: if there was a step among them, or if
  // steps gain so little that they are rare.
  bool may_end(std::size_t begin) const { return m_last >= begin || m_interval > max_useful_interval; }

private:
  static constexpr std::size_t max_useful_interval = 4, max_interval = 16;

  std::size_t m_next = min_interval, m_last = 0, m_interval = min_interval;
  double m_last_value = 0.;
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DESCENT_SMOOTH_STEP_H
