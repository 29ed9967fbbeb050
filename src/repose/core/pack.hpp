// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Include this only in sources that are compiled once for each instruction set: a pack is as wide as the registers of
// the set that the including source is compiled for.
#pragma once

#include "repose/core/choose.hpp"
#include "repose/core/inline.hpp"

#include <cstddef>

#pragma GCC diagnostic push
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // in intrinsics of g++ 12, which leave values undefined
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <experimental/simd>
#pragma GCC diagnostic pop

namespace repose {

/// Several numbers that go through the same arithmetic at once, with the same bits as one after the other. Lanes is
/// std::experimental::simd<double> of one instruction set.
template <class Lanes>
struct Pack {
  using Mask = typename Lanes::mask_type;
  static constexpr std::size_t size = Lanes::size();

  Lanes lanes{};

  Pack() = default;
  REPOSE_FN Pack(double all) : lanes(all) {}  // NOLINT: a number is the same in every lane
  REPOSE_FN explicit Pack(const Lanes& of) : lanes(of) {}

  REPOSE_FN static Pack load(const double* from) { return Pack(Lanes(from, std::experimental::element_aligned)); }
  REPOSE_FN void store(double* to) const { lanes.copy_to(to, std::experimental::element_aligned); }

  REPOSE_FN friend Pack operator+(const Pack& a, const Pack& b) { return Pack(Lanes(a.lanes + b.lanes)); }
  REPOSE_FN friend Pack operator-(const Pack& a, const Pack& b) { return Pack(Lanes(a.lanes - b.lanes)); }
  REPOSE_FN friend Pack operator*(const Pack& a, const Pack& b) { return Pack(Lanes(a.lanes * b.lanes)); }
  REPOSE_FN friend Pack operator/(const Pack& a, const Pack& b) { return Pack(Lanes(a.lanes / b.lanes)); }
  REPOSE_FN friend Pack operator-(const Pack& a) { return Pack(Lanes(-a.lanes)); }
  REPOSE_FN Pack& operator+=(const Pack& b) { return *this = *this + b; }
  REPOSE_FN Pack& operator-=(const Pack& b) { return *this = *this - b; }
  REPOSE_FN Pack& operator*=(const Pack& b) { return *this = *this * b; }

  REPOSE_FN friend Mask operator<(const Pack& a, const Pack& b) { return a.lanes < b.lanes; }
  REPOSE_FN friend Mask operator>(const Pack& a, const Pack& b) { return a.lanes > b.lanes; }

  REPOSE_FN friend Pack choose(const Mask& condition, const Pack& yes, const Pack& no) {
    Lanes chosen = no.lanes;
    std::experimental::where(condition, chosen) = yes.lanes;
    return Pack(chosen);
  }
  // min and max of Lanes return the second number unless the first is the smaller or larger one.
  REPOSE_FN friend Pack larger(const Pack& a, const Pack& b) { return Pack(Lanes(max(b.lanes, a.lanes))); }
  REPOSE_FN friend Pack smaller(const Pack& a, const Pack& b) { return Pack(Lanes(min(b.lanes, a.lanes))); }
  REPOSE_FN friend Pack positive_part(const Pack& a) { return Pack(Lanes(max(a.lanes, Lanes(0.0)))); }
  REPOSE_FN friend Pack root(const Pack& a) { return Pack(Lanes(std::experimental::sqrt(a.lanes))); }
  REPOSE_FN friend Pack magnitude(const Pack& a) { return Pack(Lanes(std::experimental::fabs(a.lanes))); }
  REPOSE_FN friend Pack with_sign_of(const Pack& a, const Pack& sign) {
    return Pack(Lanes(std::experimental::copysign(a.lanes, sign.lanes)));
  }
};

}  // namespace repose
