// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The sweep over packs, for the instruction set that the including source is compiled for (see vectors.hpp).
#pragma once

#include "repose/methods/contact_dynamics/kernels.hpp"
#include "repose/methods/contact_dynamics/relax.hpp"
#include "repose/methods/contact_dynamics/self_stress.hpp"
#include "repose/methods/contact_dynamics/vectors.hpp"

#if defined(__AVX512F__)
#pragma GCC diagnostic push
// g++ 12 warns about values that its header leaves undefined on purpose.
#pragma GCC diagnostic ignored "-Wuninitialized"
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>
#pragma GCC diagnostic pop
#endif

#include <cstddef>
#include <cstdint>

namespace repose::contact_dynamics {
namespace {

using LanesBody = Body<2, Lanes>;

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

REPOSE_FN void gather(Body<2>* of, const std::uint32_t* k, LanesBody& to) {
  const Lanes a = both(line(of[k[0]]), line(of[k[4]]));
  const Lanes b = both(line(of[k[1]]), line(of[k[5]]));
  const Lanes c = both(line(of[k[2]]), line(of[k[6]]));
  const Lanes d = both(line(of[k[3]]), line(of[k[7]]));
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  to.velocity.x = __builtin_shufflevector(ab_even, cd_even, 0, 1, 8, 9, 4, 5, 12, 13);
  to.velocity.y = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 8, 9, 4, 5, 12, 13);
  to.rim_velocity = __builtin_shufflevector(ab_even, cd_even, 2, 3, 10, 11, 6, 7, 14, 15);
  to.inverse_mass = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 10, 11, 6, 7, 14, 15);
}

REPOSE_FN void scatter(const LanesBody& from, Body<2>* of, const std::uint32_t* k) {
  const Lanes xy_even = __builtin_shufflevector(from.velocity.x, from.velocity.y, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes xy_odd = __builtin_shufflevector(from.velocity.x, from.velocity.y, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lanes rm_even = __builtin_shufflevector(from.rim_velocity, from.inverse_mass, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes rm_odd = __builtin_shufflevector(from.rim_velocity, from.inverse_mass, 1, 9, 3, 11, 5, 13, 7, 15);
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
REPOSE_FN void transpose(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d, LanesBody& to) {
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  to.velocity.x = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  to.velocity.y = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  to.rim_velocity = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  to.inverse_mass = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

REPOSE_FN void gather(Body<2>* of, const std::uint32_t* k, LanesBody& to) {
  transpose(line(of[k[0]]), line(of[k[1]]), line(of[k[2]]), line(of[k[3]]), to);
}

REPOSE_FN void scatter(const LanesBody& from, Body<2>* of, const std::uint32_t* k) {
  LanesBody turned;
  transpose(from.velocity.x, from.velocity.y, from.rim_velocity, from.inverse_mass, turned);
  line(of[k[0]]) = turned.velocity.x;
  line(of[k[1]]) = turned.velocity.y;
  line(of[k[2]]) = turned.rim_velocity;
  line(of[k[3]]) = turned.inverse_mass;
}
#else
REPOSE_FN void gather(Body<2>* of, const std::uint32_t* k, LanesBody& to) {
  const Half* a = halves(of[k[0]]);
  const Half* b = halves(of[k[1]]);
  to.velocity.x = __builtin_shufflevector(a[0], b[0], 0, 2);
  to.velocity.y = __builtin_shufflevector(a[0], b[0], 1, 3);
  to.rim_velocity = __builtin_shufflevector(a[1], b[1], 0, 2);
  to.inverse_mass = __builtin_shufflevector(a[1], b[1], 1, 3);
}

REPOSE_FN void scatter(const LanesBody& from, Body<2>* of, const std::uint32_t* k) {
  Half* a = halves(of[k[0]]);
  Half* b = halves(of[k[1]]);
  a[0] = __builtin_shufflevector(from.velocity.x, from.velocity.y, 0, 2);
  b[0] = __builtin_shufflevector(from.velocity.x, from.velocity.y, 1, 3);
  a[1] = __builtin_shufflevector(from.rim_velocity, from.inverse_mass, 0, 2);
  b[1] = __builtin_shufflevector(from.rim_velocity, from.inverse_mass, 1, 3);
}
#endif

template <bool Rolling>
REPOSE_FN void read(const double* from, Impulse<2, Lanes>& to) {
  to.normal = lanes(from);
  to.tangent = lanes(from + pack_lanes);
  if constexpr (Rolling) to.roll = lanes(from + 2 * pack_lanes);
}

template <bool Rolling>
REPOSE_FN void write(const Impulse<2, Lanes>& from, double* to) {
  lanes(to) = from.normal;
  lanes(to + pack_lanes) = from.tangent;
  if constexpr (Rolling) lanes(to + 2 * pack_lanes) = from.roll;
}

/// The contacts of some lanes, without their impulses. What a sweep does not use is not loaded.
REPOSE_FN void read(const ContactPack& pack, std::size_t lane, ContactLine<2, Lanes>& to) {
  to.normal.x = lanes(pack.normal_x + lane);
  to.normal.y = lanes(pack.normal_y + lane);
  to.normal_bias = lanes(pack.normal_bias + lane);
  to.tangent_bias = lanes(pack.tangent_bias + lane);
  to.normal_mass = lanes(pack.normal_mass + lane);
  to.tangent_mass = lanes(pack.tangent_mass + lane);
  to.roll_mass = lanes(pack.roll_mass + lane);
  to.friction = lanes(pack.friction + lane);
  to.rolling_friction = lanes(pack.rolling_friction + lane);
  to.lever = lanes(pack.lever + lane);
  to.first_turn = lanes(pack.first_turn + lane);
}

/// The impulse of some lanes at the start of a sweep; `at` is their first entry.
template <Start::Kind Kind, std::size_t Others, bool Rolling>
REPOSE_FN void start_impulse(const Start& start, const History& of, std::size_t at, Impulse<2, Lanes>& to) {
  to.normal = start_lanes<Kind, Others>(start, of, at);
  to.tangent = start_lanes<Kind, Others>(start, of, at + pack_lanes);
  if constexpr (Rolling) to.roll = start_lanes<Kind, Others>(start, of, at + 2 * pack_lanes);
}

/// The forward direction begins the sums of the changes at zero; the backward direction continues them.
template <Start::Kind Kind, std::size_t Others, bool Rolling, bool Recorded, bool Back>
REPOSE_FN void relax(const PackSweep& s, const Start& start, const History& history, std::size_t pack) {
  const FreeBodies among;
  const ContactPack& in = s.packs[pack];
  for (std::size_t lane = 0; lane < pack_lanes; lane += width) {
    const std::size_t at = pack_numbers(Rolling) * pack + lane;
    const Lanes fraction = s.fractions ? lanes(s.fractions + pack_lanes * pack + lane) : Lanes{} + 1.0;
    ContactLine<2, Lanes> c;
    read(in, lane, c);
    if constexpr (Kind == Start::Kind::here) {
      read<Rolling>(s.impulses + at, c.impulse);
    } else {
      start_impulse<Kind, Others, Rolling>(start, history, at, c.impulse);
    }
    Impulse<2, Lanes> change;
    if constexpr (Recorded && Back) read<Rolling>(history.change + at, change);
    LanesBody a, b;
    gather(s.bodies, in.first + lane, a);
    gather(s.bodies, in.second + lane, b);
    if constexpr (Rolling && Back) relax_roll(among, c, a, b, change);
    relax_translation(among, fraction, c, a, b, change);
    if constexpr (Rolling && !Back) relax_roll(among, c, a, b, change);
    scatter(a, s.bodies, in.first + lane);
    scatter(b, s.bodies, in.second + lane);
    write<Rolling>(c.impulse, s.impulses + at);
    if constexpr (Recorded) write<Rolling>(change, history.change + at);
  }
}

template <Start::Kind Kind, std::size_t Others, bool Rolling, bool Recorded, bool Back>
void sweep_packs(const PackSweep& sweep, Range packs) {
  const PackSweep s = sweep;
  const auto one = [&](std::size_t pack) { relax<Kind, Others, Rolling, Recorded, Back>(s, s.start, s.history, pack); };
  if constexpr (Back) {
    for (std::size_t pack = packs.end; pack-- > packs.begin;) one(pack);
  } else {
    for (std::size_t pack = packs.begin; pack < packs.end; ++pack) one(pack);
  }
}

void sweep_forward(const PackSweep& sweep, Range packs) {
  constexpr auto here = Start::Kind::here;
  if (!sweep.history.change) {
    sweep.rolling ? sweep_packs<here, 0, true, false, false>(sweep, packs)
                  : sweep_packs<here, 0, false, false, false>(sweep, packs);
    return;
  }
  with_kind(sweep.start, [&]<Start::Kind Kind, std::size_t Others>() {
    sweep.rolling ? sweep_packs<Kind, Others, true, true, false>(sweep, packs)
                  : sweep_packs<Kind, Others, false, true, false>(sweep, packs);
  });
}

void sweep_back(const PackSweep& sweep, Range packs) {
  constexpr auto here = Start::Kind::here;
  if (sweep.history.change) {
    sweep.rolling ? sweep_packs<here, 0, true, true, true>(sweep, packs)
                  : sweep_packs<here, 0, false, true, true>(sweep, packs);
  } else {
    sweep.rolling ? sweep_packs<here, 0, true, false, true>(sweep, packs)
                  : sweep_packs<here, 0, false, false, true>(sweep, packs);
  }
}

template <bool Rolling>
double separate_energies(const ContactPack* packs, const double* changes, std::size_t count) {
  double sum = 0.0;
  for (std::size_t pack = 0; pack < count; ++pack) {
    for (std::size_t lane = 0; lane < pack_lanes; lane += width) {
      ContactLine<2, Lanes> c;
      read(packs[pack], lane, c);
      Impulse<2, Lanes> change;
      read<Rolling>(changes + pack_numbers(Rolling) * pack + lane, change);
      if constexpr (!Rolling) c.roll_mass = c.normal_mass;
      // Unused lanes have no mass.
      const Lanes energy = choose(c.normal_mass > 0.0, separate_energy(c, change), Lanes{});
      for (std::size_t l = 0; l < width; ++l) sum += energy[l];
    }
  }
  return sum;
}

double separate_energies(const ContactPack* packs, const double* changes, bool rolling, std::size_t count) {
  return rolling ? separate_energies<true>(packs, changes, count) : separate_energies<false>(packs, changes, count);
}

}  // namespace
}  // namespace repose::contact_dynamics
