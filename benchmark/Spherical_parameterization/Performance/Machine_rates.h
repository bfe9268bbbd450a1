// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MACHINE_RATES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MACHINE_RATES_H

#include <CGAL/Spherical_parameterization/internal/Lanes.h>
#include <CGAL/Spherical_parameterization/internal/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/run_in_lanes.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace benchmarks {

namespace Internal = CGAL::Spherical_parameterization::internal;

// What some threads of this machine do in a second at best, together: in loops without any dependence from one element
// to the next, with the instructions that the package uses on this processor.
class Machine_rates
{
public:
  // Measures it. The rate of memory is that of arrays of `working_set` bytes in all: they may fit into a cache.
  Machine_rates(std::size_t n_threads, std::size_t working_set)
    : m_n_threads(n_threads)
  {
    bytes = rate<Sums_of_columns>(working_set / n_threads);
    sums_and_products = rate<Sums_and_products>();
    divisions = rate<Divisions>();
    square_roots = rate<Square_roots>();
    exponentials = rate<Exponentials>();
  }

  double bytes;             // read or written, ten times as many of the former
  double sums_and_products; // additions, subtractions and multiplications of doubles
  double divisions;
  double square_roots;
  double exponentials;

private:
  static constexpr std::size_t n_attempts = 15;
  static constexpr std::size_t array_size = 512; // fits into every first cache, and is a multiple of the lanes

  // Each kernel has amount(), what one call of it does, and operator()(x), which returns something that depends on all
  // of it and on x.

  // Reads ten numbers for each that is written, as a sweep does: one is the sum of nine others and of its own half.
  class Sums_of_columns
  {
  public:
    explicit Sums_of_columns(std::size_t n_bytes)
      : m_sums(most_lanes * (n_bytes / bytes_of_sum / most_lanes + 1), 0.)
      , m_values(n_columns * m_sums.size(), 1.)
      , m_n_passes(1 + least_bytes / (bytes_of_sum * m_sums.size()))
    {}
    double amount() const { return static_cast<double>(bytes_of_sum * m_sums.size() * m_n_passes); }
    double operator()(double x)
    {
      m_values.front() = x;
      Internal::run_in_lanes([&](auto type) {
        using FT = typename decltype(type)::FT;
        for(std::size_t pass = 0; pass < m_n_passes; ++pass)
        {
          pass_once<FT>(); // with what the one before has written, so none can be left out
        }
      });
      return m_sums.front() + m_sums.back();
    }

  private:
    static constexpr std::size_t n_columns = 9, bytes_of_sum = (n_columns + 2) * sizeof(double);
    static constexpr std::size_t most_lanes = 8; // the number of sums is a multiple of the lanes
    static constexpr std::size_t least_bytes = std::size_t(1) << 27;

    template <class FT>
    void pass_once()
    {
      using Lanes = Internal::Lanes<FT>;
      const FT half(0.5);
      const double* values = m_values.data();
      for(std::size_t i = 0; i < m_sums.size(); i += Lanes::width)
      {
        double* sums = m_sums.data() + i;
        FT sum = half * Lanes::load(sums);
        for(std::size_t column = 0; column < n_columns; ++column, values += Lanes::width)
        {
          sum = sum + Lanes::load(values);
        }
        Lanes::store(sum, sums);
      }
    }

    std::vector<double> m_sums, m_values;
    std::size_t m_n_passes;
  };

  class Sums_and_products
  {
  public:
    double amount() const { return m_amount; }
    double operator()(double x)
    {
      double sum = 0.;
      Internal::run_in_lanes([&](auto type) {
        using FT = typename decltype(type)::FT;
        sum = run<FT>(x, std::make_index_sequence<n_values>());
        m_amount = 2. * n_rounds * n_values * Internal::Lanes<FT>::width;
      });
      return sum;
    }

  private:
    static constexpr std::size_t n_values = 12, n_rounds = 1000000;

    template <class FT, std::size_t... I>
    static double run(double x, std::index_sequence<I...>)
    {
      using Internal::lane;
      FT values[] = {FT(x + static_cast<double>(I))...}; // stay in registers, as the indices are constants
      const FT factor(1. - 1e-9 * x), term(1e-9 * x);
      for(std::size_t k = 0; k < n_rounds; ++k)
      {
        ((values[I] = values[I] * factor + term), ...);
      }
      return (lane(values[I], 0) + ...);
    }

    double m_amount = 0.;
  };

  // Calls a function of an element and a number for all elements of a small array, again and again.
  template <class Function>
  class Elementwise
  {
  public:
    double amount() const { return static_cast<double>(array_size * n_passes); }
    double operator()(double x)
    {
      Internal::run_in_lanes([&](auto type) {
        using FT = typename decltype(type)::FT;
        constexpr std::size_t width = Internal::Lanes<FT>::width;
        for(std::size_t pass = 0; pass < n_passes; ++pass)
        {
          const FT shift(x + 1e-6 * static_cast<double>(pass));
          for(std::size_t i = 0; i < array_size; i += width)
          {
            double* values = m_values.data() + i;
            Internal::Lanes<FT>::store(Function::value(Internal::Lanes<FT>::load(values), shift), values);
          }
        }
      });
      return m_values.front() + m_values.back();
    }

  private:
    static constexpr std::size_t n_passes = 4000;

    std::vector<double> m_values = std::vector<double>(array_size, 1.);
  };

  struct Quotient
  {
    template <class FT>
    static FT value(const FT& value, const FT& shift)
    {
      return shift / value;
    }
  };
  struct Square_root
  {
    template <class FT>
    static FT value(const FT& value, const FT& shift)
    {
      using Internal::square_root; // for a single number, too
      return square_root(value + shift);
    }
  };
  struct Exponential
  {
    template <class FT>
    static FT value(const FT& value, const FT& shift)
    {
      using Internal::exponential;
      return exponential(-(shift * value));
    }
  };
  using Divisions = Elementwise<Quotient>;
  using Square_roots = Elementwise<Square_root>;
  using Exponentials = Elementwise<Exponential>;

  // What all threads do in a second, each with a kernel of its own, in the best of several attempts.
  template <class Kernel, class... Arguments>
  double rate(const Arguments&... arguments) const
  {
    using Clock = std::chrono::steady_clock;
    std::vector<std::array<Clock::time_point, n_attempts>> begins(m_n_threads), ends(m_n_threads);
    std::atomic<std::size_t> n_arrivals(0);
    std::atomic<double> amount(0.), sink(0.);
    const auto work = [&](std::size_t thread) {
      Kernel kernel(arguments...); // by the thread that uses it, so that its memory is close to it
      double result = kernel(1.);  // pages and clock frequency settle
      for(std::size_t attempt = 0; attempt < n_attempts; ++attempt)
      {
        ++n_arrivals;
        while(n_arrivals < m_n_threads * (attempt + 1))
        {
          std::this_thread::yield();
        }
        begins[thread][attempt] = Clock::now();
        result += kernel(1. + 1e-3 * static_cast<double>(attempt));
        ends[thread][attempt] = Clock::now();
      }
      amount = kernel.amount();
      sink = result;
    };
    std::vector<std::thread> threads;
    for(std::size_t thread = 1; thread < m_n_threads; ++thread)
    {
      threads.emplace_back(work, thread);
    }
    work(0);
    for(std::thread& thread : threads)
    {
      thread.join();
    }
    double least_seconds = std::numeric_limits<double>::infinity();
    for(std::size_t attempt = 0; attempt < n_attempts; ++attempt)
    {
      Clock::time_point begin = begins[0][attempt], end = ends[0][attempt];
      for(std::size_t thread = 1; thread < m_n_threads; ++thread)
      {
        begin = (std::min)(begin, begins[thread][attempt]);
        end = (std::max)(end, ends[thread][attempt]);
      }
      least_seconds = (std::min)(least_seconds, std::chrono::duration<double>(end - begin).count());
    }
    return static_cast<double>(m_n_threads) * amount / least_seconds;
  }

  std::size_t m_n_threads;
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MACHINE_RATES_H
