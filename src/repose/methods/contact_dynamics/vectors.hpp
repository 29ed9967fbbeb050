// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The widest vectors of the instruction set that the including source is compiled for. Everything in the kernels is
// local to that source, and of other headers they call only functions that are always inlined: the linker keeps one
// copy of an inline function, and that copy must not contain instructions that the machine lacks.
#pragma once

#include "repose/core/inline.hpp"
#include "repose/methods/contact_dynamics/start.hpp"

#include <cstddef>

namespace repose::contact_dynamics {
namespace {

#if defined(__AVX512F__)
constexpr std::size_t width = 8;
#elif defined(__AVX2__)
constexpr std::size_t width = 4;
#else
constexpr std::size_t width = 2;
#endif

using Lanes = double __attribute__((vector_size(8 * width)));
using LanesInMemory = double __attribute__((vector_size(8 * width), may_alias));

REPOSE_FN LanesInMemory& lanes(double* p) { return *reinterpret_cast<LanesInMemory*>(p); }
REPOSE_FN Lanes lanes(const double* p) { return *reinterpret_cast<const LanesInMemory*>(p); }

/// Calls use.operator()<Kind, Others>() for the kind of a start.
template <class Use>
REPOSE_FN void with_kind(const Start& start, const Use& use) {
  if (start.kind == Start::Kind::here) return use.template operator()<Start::Kind::here, 0>();
  if (start.kind == Start::Kind::restart) return use.template operator()<Start::Kind::restart, 0>();
  if (start.others == 0) return use.template operator()<Start::Kind::combine, 0>();
  if (start.others == 1) return use.template operator()<Start::Kind::combine, 1>();
  use.template operator()<Start::Kind::combine, 2>();
}

/// Advances the numbers at an entry and returns them at the start of a sweep.
template <Start::Kind Kind, std::size_t Others>
REPOSE_FN Lanes start_lanes(const Start& start, const History& of, std::size_t entry) {
  const auto at = [=](const double* numbers) __attribute__((always_inline)) { return lanes(numbers + entry); };
  const auto put = [=](double* to, const Lanes& value) __attribute__((always_inline)) { lanes(to + entry) = value; };
  return start_of_sweep<Kind, Others>(start, of, at, put);
}

}  // namespace
}  // namespace repose::contact_dynamics
