// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The sweep over packs, for the instruction set that the including source is compiled for. Everything is local to that
// source and calls no function of other headers: the linker keeps one copy of an inline function, and that copy must
// not contain instructions that the machine lacks.
#pragma once

#include "repose/methods/contact_dynamics/pack_sweep.hpp"

#if defined(__AVX512F__)
#pragma GCC diagnostic push
#if !defined(__clang__)
#pragma GCC diagnostic ignored \
    "-Wmaybe-uninitialized"  // g++ 12 warns about values that its header leaves undefined on purpose
#endif
#include <immintrin.h>
#pragma GCC diagnostic pop
#endif

#include <cstddef>
#include <cstdint>

namespace repose::contact_dynamics {
namespace {

#if defined(__AVX512F__)
constexpr std::size_t width = 8;
#elif defined(__AVX2__)
constexpr std::size_t width = 4;
#else
constexpr std::size_t width = 2;
#endif

using Lanes = double __attribute__((vector_size(8 * width), may_alias));

REPOSE_FN Lanes& lanes(double* p) { return *reinterpret_cast<Lanes*>(p); }
REPOSE_FN const Lanes& lanes(const double* p) { return *reinterpret_cast<const Lanes*>(p); }

/// The same as std::max and std::min, also if both arguments are zero.
REPOSE_FN Lanes larger(const Lanes& a, const Lanes& b) { return a < b ? b : a; }
REPOSE_FN Lanes smaller(const Lanes& a, const Lanes& b) { return b < a ? b : a; }

/// The bodies of some lanes, property by property.
struct Bodies {
  Lanes x, y, rim, inverse_mass;
};

#if defined(__AVX2__) || defined(__AVX512F__)
using Line = double __attribute__((vector_size(32), may_alias));
REPOSE_FN Line& line(Body<2>& body) { return *reinterpret_cast<Line*>(&body); }
#else
using Half = double __attribute__((vector_size(16), may_alias));
REPOSE_FN Half* halves(Body<2>& body) { return reinterpret_cast<Half*>(&body); }
#endif

#if defined(__AVX512F__)
// Compilers make shuffles of these two; an instruction with an operand in memory needs none.
REPOSE_FN Lanes both(const Line& a, const Line& b) {
  return Lanes(_mm512_insertf64x4(_mm512_castpd256_pd512(__m256d(a)), __m256d(b), 1));
}
REPOSE_FN Line upper(const Lanes& a) { return Line(_mm512_extractf64x4_pd(__m512d(a), 1)); }

REPOSE_FN void gather(Body<2>* of, const std::uint32_t* k, Bodies& to) {
  const Lanes a = both(line(of[k[0]]), line(of[k[4]]));
  const Lanes b = both(line(of[k[1]]), line(of[k[5]]));
  const Lanes c = both(line(of[k[2]]), line(of[k[6]]));
  const Lanes d = both(line(of[k[3]]), line(of[k[7]]));
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  to.x = __builtin_shufflevector(ab_even, cd_even, 0, 1, 8, 9, 4, 5, 12, 13);
  to.y = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 8, 9, 4, 5, 12, 13);
  to.rim = __builtin_shufflevector(ab_even, cd_even, 2, 3, 10, 11, 6, 7, 14, 15);
  to.inverse_mass = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 10, 11, 6, 7, 14, 15);
}

REPOSE_FN void scatter(const Bodies& from, Body<2>* of, const std::uint32_t* k) {
  const Lanes xy_even = __builtin_shufflevector(from.x, from.y, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes xy_odd = __builtin_shufflevector(from.x, from.y, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lanes rm_even = __builtin_shufflevector(from.rim, from.inverse_mass, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes rm_odd = __builtin_shufflevector(from.rim, from.inverse_mass, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lanes a = __builtin_shufflevector(xy_even, rm_even, 0, 1, 8, 9, 4, 5, 12, 13);
  const Lanes b = __builtin_shufflevector(xy_odd, rm_odd, 0, 1, 8, 9, 4, 5, 12, 13);
  const Lanes c = __builtin_shufflevector(xy_even, rm_even, 2, 3, 10, 11, 6, 7, 14, 15);
  const Lanes d = __builtin_shufflevector(xy_odd, rm_odd, 2, 3, 10, 11, 6, 7, 14, 15);
  line(of[k[0]]) = __builtin_shufflevector(a, a, 0, 1, 2, 3);
  line(of[k[1]]) = __builtin_shufflevector(b, b, 0, 1, 2, 3);
  line(of[k[2]]) = __builtin_shufflevector(c, c, 0, 1, 2, 3);
  line(of[k[3]]) = __builtin_shufflevector(d, d, 0, 1, 2, 3);
  line(of[k[4]]) = upper(a);
  line(of[k[5]]) = upper(b);
  line(of[k[6]]) = upper(c);
  line(of[k[7]]) = upper(d);
}
#elif defined(__AVX2__)
/// Transposes a 4 x 4 table.
REPOSE_FN void transpose(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d, Bodies& to) {
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  to.x = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  to.y = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  to.rim = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  to.inverse_mass = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

REPOSE_FN void gather(Body<2>* of, const std::uint32_t* k, Bodies& to) {
  transpose(line(of[k[0]]), line(of[k[1]]), line(of[k[2]]), line(of[k[3]]), to);
}

REPOSE_FN void scatter(const Bodies& from, Body<2>* of, const std::uint32_t* k) {
  Bodies turned;
  transpose(from.x, from.y, from.rim, from.inverse_mass, turned);
  line(of[k[0]]) = turned.x;
  line(of[k[1]]) = turned.y;
  line(of[k[2]]) = turned.rim;
  line(of[k[3]]) = turned.inverse_mass;
}
#else
REPOSE_FN void gather(Body<2>* of, const std::uint32_t* k, Bodies& to) {
  const Half* a = halves(of[k[0]]);
  const Half* b = halves(of[k[1]]);
  to.x = __builtin_shufflevector(a[0], b[0], 0, 2);
  to.y = __builtin_shufflevector(a[0], b[0], 1, 3);
  to.rim = __builtin_shufflevector(a[1], b[1], 0, 2);
  to.inverse_mass = __builtin_shufflevector(a[1], b[1], 1, 3);
}

REPOSE_FN void scatter(const Bodies& from, Body<2>* of, const std::uint32_t* k) {
  Half* a = halves(of[k[0]]);
  Half* b = halves(of[k[1]]);
  a[0] = __builtin_shufflevector(from.x, from.y, 0, 2);
  b[0] = __builtin_shufflevector(from.x, from.y, 1, 3);
  a[1] = __builtin_shufflevector(from.rim, from.inverse_mass, 0, 2);
  b[1] = __builtin_shufflevector(from.rim, from.inverse_mass, 1, 3);
}
#endif

/// The impulses of some lanes of a pack, or their changes.
struct Numbers {
  double* of;
  REPOSE_FN Lanes& normal() const { return lanes(of); }
  REPOSE_FN Lanes& tangent() const { return lanes(of + pack_lanes); }
  REPOSE_FN Lanes& roll() const { return lanes(of + 2 * pack_lanes); }
};

REPOSE_FN Lanes friction_limit(const Lanes& coefficient, const Lanes& normal_impulse) {
  return normal_impulse > 0.0 ? coefficient * normal_impulse : Lanes{};
}
REPOSE_FN Lanes change_within(const Lanes& impulse, const Lanes& change, const Lanes& limit) {
  return smaller(larger(change, -limit - impulse), limit - impulse);
}

/// Adds a change to a sum. The forward direction begins the sum at 0.0, which turns a negative zero into a positive
/// one; the backward direction continues it.
template <bool Back>
REPOSE_FN void add(Lanes& sum, const Lanes& change) {
  sum = (Back ? sum : Lanes{}) + change;
}

template <bool Partly, bool Back>
REPOSE_FN void relax_translation(const ContactPack& c, std::size_t lane, const double* fractions, Numbers impulse,
                                 Numbers change, Bodies& a, Bodies& b) {
  const Lanes nx = lanes(c.normal_x + lane);
  const Lanes ny = lanes(c.normal_y + lane);
  const Lanes lever = lanes(c.lever + lane);
  const Lanes x = a.x - b.x;
  const Lanes y = a.y - b.y;
  const Lanes opening = (x * nx + y * ny) + lanes(c.normal_bias + lane);
  const Lanes slip = ((y * nx - x * ny) - (a.rim + b.rim) * lever) + lanes(c.tangent_bias + lane);
  const Lanes normal_before = impulse.normal();
  const Lanes normal = larger(-normal_before, -lanes(c.normal_mass + lane) * opening);
  const Lanes normal_now = normal_before + normal;
  impulse.normal() = normal_now;
  const Lanes limit = friction_limit(lanes(c.friction + lane), normal_now);
  const Lanes tangent_before = impulse.tangent();
  Lanes tangent = change_within(tangent_before, slip * -lanes(c.tangent_mass + lane), limit);
  if constexpr (Partly) tangent *= lanes(fractions + lane);
  impulse.tangent() = tangent_before + tangent;
  const Lanes push_x = nx * normal - ny * tangent;
  const Lanes push_y = ny * normal + nx * tangent;
  const Lanes turn = tangent * (-inverse_inertia_factor<2> * lever);
  a.x += push_x * a.inverse_mass;
  a.y += push_y * a.inverse_mass;
  b.x -= push_x * b.inverse_mass;
  b.y -= push_y * b.inverse_mass;
  a.rim += turn * a.inverse_mass;
  b.rim += turn * b.inverse_mass;
  add<Back>(change.normal(), normal);
  add<Back>(change.tangent(), tangent);
}

template <bool Back>
REPOSE_FN void relax_roll(const ContactPack& c, std::size_t lane, Numbers impulse, Numbers change, Bodies& a,
                          Bodies& b) {
  const Lanes first_turn = lanes(c.first_turn + lane);
  const Lanes second_turn = 2.0 - first_turn;
  const Lanes velocity = a.rim * first_turn - b.rim * second_turn;
  const Lanes limit = friction_limit(lanes(c.rolling_friction + lane), impulse.normal());
  const Lanes before = impulse.roll();
  const Lanes roll = change_within(before, velocity * -lanes(c.roll_mass + lane), limit);
  impulse.roll() = before + roll;
  a.rim += roll * (inverse_inertia_factor<2> * first_turn * a.inverse_mass);
  b.rim -= roll * (inverse_inertia_factor<2> * second_turn * b.inverse_mass);
  add<Back>(change.roll(), roll);
}

template <bool Partly, bool Rolling, bool Back>
REPOSE_FN void relax(const PackSweep& s, std::size_t pack) {
  const ContactPack& c = s.packs[pack];
  for (std::size_t lane = 0; lane < pack_lanes; lane += width) {
    const Numbers impulse{s.impulses + pack_numbers * pack + lane};
    const Numbers change{s.changes + pack_numbers * pack + lane};
    const double* fractions = Partly ? s.fractions + pack_lanes * pack : nullptr;
    Bodies a, b;
    gather(s.bodies, c.first + lane, a);
    gather(s.bodies, c.second + lane, b);
    if constexpr (Rolling && Back) relax_roll<Back>(c, lane, impulse, change, a, b);
    relax_translation<Partly, Back>(c, lane, fractions, impulse, change, a, b);
    if constexpr (Rolling && !Back) relax_roll<Back>(c, lane, impulse, change, a, b);
    scatter(a, s.bodies, c.first + lane);
    scatter(b, s.bodies, c.second + lane);
  }
}

template <bool Partly, bool Rolling>
void sweep_packs(const PackSweep& sweep) {
  const PackSweep s = sweep;
  for (std::size_t pack = 0; pack < s.count; ++pack) relax<Partly, Rolling, false>(s, pack);
  for (std::size_t pack = s.count; pack-- > 0;) relax<Partly, Rolling, true>(s, pack);
}

void sweep_packs(const PackSweep& s) {
  if (s.fractions) {
    s.rolling ? sweep_packs<true, true>(s) : sweep_packs<true, false>(s);
  } else {
    s.rolling ? sweep_packs<false, true>(s) : sweep_packs<false, false>(s);
  }
}

}  // namespace
}  // namespace repose::contact_dynamics
