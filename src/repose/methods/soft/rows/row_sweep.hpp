// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/core/instruction_set.hpp"
#include "repose/methods/soft/rows/line.hpp"

#include <cstddef>
#include <cstdint>

namespace repose::soft {

/// Force and rim torque on a grain, or those of a pair on its first grain, each padded with a zero to four numbers; in
/// 2D together.
template <int D>
struct alignas(32) RowSum {
  double value[D == 2 ? 4 : 8] = {};  // NOLINT: plain numbers, which kernels read in groups of four
};

/// The result of an edge pair: a pair whose second grain belongs to another member, or is far away in memory.
template <int D>
struct Edge {
  std::size_t pair;      ///< index in the pair list
  std::uint32_t first;   ///< index of the first grain
  std::uint32_t second;  ///< index of the second grain
  Tangent<D> slip;       ///< [L] after the step
  RowSum<D> push;        ///< on the first grain
};

/// An edge pair whose second grain is in the member's range.
template <int D>
struct RowArrival {
  std::size_t row;        ///< index of the second grain
  const RowSum<D>* push;  ///< on the first grain
};

/// The level axes of a box, x and in 3D y too, for the nearest image along each.
template <int D>
struct Periods {
  double length[D - 1];  // NOLINT [L] 0 unless the axis is periodic
  double half[D - 1];    // NOLINT [L] infinity unless the axis is periodic
};

/// The input and output of one sweep of a fused kernel over the rows of a member. It has plain pointers only: sources
/// compiled for an instruction set must not instantiate functions that others use too.
template <int D, class Law>
struct RowSweep {
  const Law* laws;                ///< of every pair of materials
  const std::uint16_t* material;  ///< of each grain; null if the first law is that of all pairs
  std::size_t materials;
  Periods<D> periods;
  double time_step;    ///< [T]
  double kick;         ///< [T] half a step in the first step, then a step
  double before;       ///< [T] from the time of the displacements to that of the force; synchronised velocities only
  double gravity[D];   // NOLINT [L/T^2]
  double speed_limit;  ///< [L/T] of each component, above which a grain cannot be followed
  bool synchronised;

  Line<D>* line;
  HalfStep<D>* half_step;          ///< synchronised velocities only
  const std::uint32_t* row_start;  ///< pairs of each grain, of which it is the first
  const std::uint32_t* first;      ///< of each pair
  const std::uint32_t* second;     ///< of each pair; of an edge pair the first grain again
  Tangent<D>* slip;                ///< [L] of each pair
  std::size_t begin;               ///< the rows of the member
  std::size_t end;
  std::size_t bandwidth;  ///< no second grain is further from its first one in memory

  RowSum<D>* window;     ///< zeros; sums of the grains that the sweep is about to reach
  std::size_t capacity;  ///< of the window
  RowSum<D>* push;       ///< room for the pushes of a block of rows
  Edge<D>* edges;        ///< ascending by pair, then one that comes after all pairs
  std::size_t edge_count;
  const RowArrival<D>* arrivals;  ///< ascending by row and first grain, then one that comes after all rows
  const std::uint32_t* special;   ///< rows to leave to the caller, ascending, then one that comes after all rows
  RowSum<D>* special_sum;         ///< the pushes on them

  double fastest[D];  // NOLINT [L/T] largest magnitude of each component of a velocity
  bool trouble;       ///< a grain is too fast, or its velocity is not a number
};

/// The number of rows whose pairs are computed before any of them is summed.
template <int D>
inline constexpr std::size_t rows_of_block = D == 2 ? 64 : 16;
/// Room for pushes beyond the pairs of a block.
inline constexpr std::size_t widest_pack = 8;

// One source, row_kernel.hpp, compiled for each instruction set; the scalar one computes one pair after the other.
template <int D, class Law>
void sweep_rows_scalar(RowSweep<D, Law>& sweep);
template <int D, class Law>
void sweep_rows_baseline(RowSweep<D, Law>& sweep);
template <int D, class Law>
void sweep_rows_avx2(RowSweep<D, Law>& sweep);
template <int D, class Law>
void sweep_rows_avx512(RowSweep<D, Law>& sweep);

/// Computes the edge pairs, before any grain moves.
template <int D, class Law>
void compute_edges(RowSweep<D, Law>& sweep);

}  // namespace repose::soft
