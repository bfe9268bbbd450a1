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

#include <CGAL/Spherical_parameterization/internal/numbers/run_in_lanes.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// What some threads of this machine do in a second at best, together: loops without any dependence from one element to
// the next, with the instructions that the package uses on this processor.
namespace machine_rates {

namespace internal = CGAL::Spherical_parameterization::internal;

// Reads ten numbers for each that is written, as a sweep does: one is the sum of nine others and of its own half. The
// arrays of all threads have `n_bytes`; they may fit into a cache.
inline void sum_columns(benchmark::State& state, double n_bytes)
{
  constexpr std::size_t n_columns = 9, bytes_of_sum = (n_columns + 2) * sizeof(double), max_lanes = 8;
  const double n_rows = n_bytes / static_cast<double>(state.threads()) / static_cast<double>(bytes_of_sum * max_lanes);
  std::vector<double> sums(max_lanes * (static_cast<std::size_t>(n_rows) + 1), 0.), values(n_columns * sums.size(), 1.);
  internal::run_in_lanes([&](auto type) {
    using FT = typename decltype(type)::FT;
    using Lanes = internal::Lanes<FT>;
    const FT half(0.5);
    for(auto _ : state)
    {
      const double* next = values.data();
      for(std::size_t i = 0; i < sums.size(); i += Lanes::width)
      {
        FT sum = half * Lanes::load(sums.data() + i);
        for(std::size_t column = 0; column < n_columns; ++column, next += Lanes::width)
          sum = sum + Lanes::load(next);
        Lanes::store(sum, sums.data() + i);
      }
      benchmark::ClobberMemory();
    }
  });
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(bytes_of_sum * sums.size()));
}

// Multiplies and adds in registers.
template <std::size_t... I>
void multiply_and_add(benchmark::State& state, std::index_sequence<I...>)
{
  constexpr std::size_t n_rounds = 1000;
  std::size_t n_operations = 0;
  internal::run_in_lanes([&](auto type) {
    using FT = typename decltype(type)::FT;
    FT values[] = {FT(1. + static_cast<double>(I))...}; // stay in registers, as the indices are constants
    double x = 1.;
    for(auto _ : state)
    {
      benchmark::DoNotOptimize(x);
      const FT factor(1. - 1e-9 * x), term(1e-9 * x);
      for(std::size_t k = 0; k < n_rounds; ++k)
        ((values[I] = values[I] * factor + term), ...);
    }
    benchmark::DoNotOptimize(values);
    n_operations = 2 * n_rounds * sizeof...(I) * internal::Lanes<FT>::width;
  });
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(n_operations));
}

// Replaces each of a few numbers, which fit into every first cache, by f(number, shift).
template <class Function>
void transform(benchmark::State& state, const Function& f)
{
  std::vector<double> values(512, 1.);
  internal::run_in_lanes([&](auto type) {
    using FT = typename decltype(type)::FT;
    using Lanes = internal::Lanes<FT>;
    double shift = 1.;
    for(auto _ : state)
    {
      benchmark::DoNotOptimize(shift);
      for(std::size_t i = 0; i < values.size(); i += Lanes::width)
        Lanes::store(f(Lanes::load(values.data() + i), FT(shift)), values.data() + i);
      benchmark::ClobberMemory();
    }
  });
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(values.size()));
}

// Registers all of them; `working_set()` is the size of the arrays of sum_columns().
template <class WorkingSet>
void add(std::size_t number_of_threads, const WorkingSet& working_set)
{
  const auto add_one = [&](const char* name, const auto& run) {
    benchmark::internal::Benchmark* const added = benchmark::RegisterBenchmark(name, run);
    if(number_of_threads > 1)
      added->Threads(static_cast<int>(number_of_threads))->UseRealTime();
  };
  add_one("machine_bytes", [=](benchmark::State& state) { sum_columns(state, working_set()); });
  add_one("machine_sums_and_products",
          [](benchmark::State& state) { multiply_and_add(state, std::make_index_sequence<12>()); });
  add_one("machine_divisions", [](benchmark::State& state) {
    transform(state, [](const auto& x, const auto& shift) { return shift / x; });
  });
  add_one("machine_square_roots", [](benchmark::State& state) {
    using internal::square_root; // for a single number, too
    transform(state, [](const auto& x, const auto& shift) { return square_root(x + shift); });
  });
  add_one("machine_exponentials", [](benchmark::State& state) {
    using internal::clamped_exponential;
    transform(state, [](const auto& x, const auto& shift) { return clamped_exponential(-(shift * x)); });
  });
}

} // namespace machine_rates

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_MACHINE_RATES_H
