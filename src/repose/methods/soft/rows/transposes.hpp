// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers of several grains, transposed into packs, and back. Include this only in sources that are compiled
// once for each instruction set; everything is local to them.
#pragma once

#include "repose/core/inline.hpp"

#if !defined(REPOSE_SCALAR_ROWS)
#include "repose/core/pack.hpp"
#endif

#include <cstddef>
#include <cstdint>

namespace repose::soft {
namespace {

/// Four numbers in memory; where registers are shorter, the compiler uses two.
using Four = double __attribute__((vector_size(32), may_alias));

using FourBits = std::int64_t __attribute__((vector_size(32), may_alias));

REPOSE_FN void drop_signs(Four& a) { a = Four(FourBits(a) & std::int64_t{0x7fffffffffffffff}); }
/// Adds b with signs, which are 1 or -1. Their products are exact, so one rounding is that of the sum.
REPOSE_FN void add_signed(const Four& b, const Four& signs, Four& a) {
#if defined(__FMA__)
  a = Four(_mm256_fmadd_pd(__m256d(b), __m256d(signs), __m256d(a)));
#else
  a += b * signs;
#endif
}
REPOSE_FN Four& four(double* p) { return *reinterpret_cast<Four*>(p); }
REPOSE_FN const Four& four(const double* p) { return *reinterpret_cast<const Four*>(p); }

#if defined(REPOSE_SCALAR_ROWS)

using Numbers = double;
constexpr std::size_t width = 1;
REPOSE_FN double load(const double* from) { return *from; }
REPOSE_FN void store(double a, double* to) { *to = a; }

/// For each pair the group of four numbers at `offset` of its first line, plus those of its second line with `signs`.
template <class Line>
REPOSE_FN void sum_fours(const Line* lines, const std::uint32_t* first, const std::uint32_t* second, std::size_t offset,
                         const Four& signs, Numbers (&to)[4]) {
  const auto at = [&](std::uint32_t k) { return reinterpret_cast<const double*>(lines + std::size_t{k}) + offset; };
  const Four sum = four(at(*first)) + four(at(*second)) * signs;
  for (int k = 0; k < 4; ++k) to[k] = sum[k];
}

/// Writes the four numbers of each pair, `stride` apart.
REPOSE_FN void store_fours(const Numbers (&from)[4], double* to, std::size_t /*stride*/) {
  for (int k = 0; k < 4; ++k) to[k] = from[k];
}

#else

using Lanes = std::experimental::native_simd<double>;
using Numbers = Pack<Lanes>;
constexpr std::size_t width = Numbers::size;
REPOSE_FN Numbers load(const double* from) { return Numbers::load(from); }
REPOSE_FN void store(const Numbers& a, double* to) { a.store(to); }

#if defined(__AVX512F__)

REPOSE_FN __m512d both(const double* a, const double* b) {  // an operand in memory needs no shuffle
  return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(a)), _mm256_load_pd(b), 1);
}
REPOSE_FN __m512d low_parts(__m512d a, __m512d b) {
  return _mm512_permutex2var_pd(a, _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13), b);
}
REPOSE_FN __m512d high_parts(__m512d a, __m512d b) {
  return _mm512_permutex2var_pd(a, _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15), b);
}

/// Transposes the lower and the upper four columns of four rows, each by itself.
REPOSE_FN void transpose_halves(__m512d (&rows)[4]) {
  const __m512d ab_even = _mm512_unpacklo_pd(rows[0], rows[1]);
  const __m512d ab_odd = _mm512_unpackhi_pd(rows[0], rows[1]);
  const __m512d cd_even = _mm512_unpacklo_pd(rows[2], rows[3]);
  const __m512d cd_odd = _mm512_unpackhi_pd(rows[2], rows[3]);
  rows[0] = low_parts(ab_even, cd_even);
  rows[1] = low_parts(ab_odd, cd_odd);
  rows[2] = high_parts(ab_even, cd_even);
  rows[3] = high_parts(ab_odd, cd_odd);
}

template <class Line>
REPOSE_FN void sum_fours(const Line* lines, const std::uint32_t* first, const std::uint32_t* second, std::size_t offset,
                         const Four& signs, Numbers (&to)[4]) {
  const auto at = [&](std::uint32_t k) { return reinterpret_cast<const double*>(lines + std::size_t{k}) + offset; };
  const __m512d sign = _mm512_broadcast_f64x4(__m256d(signs));
  const auto sum = [&](std::size_t k) {
    return _mm512_fmadd_pd(both(at(second[k]), at(second[k + 4])), sign, both(at(first[k]), at(first[k + 4])));
  };
  __m512d rows[4] = {sum(0), sum(1), sum(2), sum(3)};
  transpose_halves(rows);
  for (int k = 0; k < 4; ++k) to[k] = Numbers(Lanes(rows[k]));
}

/// The same for the first eight numbers of lines of 64 bytes.
template <class Line>
REPOSE_FN void sum_eights(const Line* lines, const std::uint32_t* first, const std::uint32_t* second, const Four& signs,
                          const Four& upper_signs, Numbers (&to)[8]) {
  const auto at = [&](std::uint32_t k) { return _mm512_load_pd(lines + std::size_t{k}); };
  const __m512d sign = _mm512_insertf64x4(_mm512_castpd256_pd512(__m256d(signs)), __m256d(upper_signs), 1);
  __m512d quarter[2][4];  // numbers 0 and 4, 1 and 5, ... of four pairs
  for (std::size_t half = 0; half < 2; ++half) {
    const auto sum = [&](std::size_t k) {
      return _mm512_fmadd_pd(at(second[4 * half + k]), sign, at(first[4 * half + k]));
    };
    for (std::size_t k = 0; k < 4; ++k) quarter[half][k] = sum(k);
    transpose_halves(quarter[half]);
  }
  for (int k = 0; k < 4; ++k) {
    to[k] = Numbers(Lanes(_mm512_shuffle_f64x2(quarter[0][k], quarter[1][k], 0x44)));
    to[k + 4] = Numbers(Lanes(_mm512_shuffle_f64x2(quarter[0][k], quarter[1][k], 0xee)));
  }
}

REPOSE_FN void store_fours(const Numbers (&from)[4], double* to, std::size_t stride) {
  __m512d rows[4];
  for (int k = 0; k < 4; ++k) rows[k] = static_cast<__m512d>(from[k].lanes);
  transpose_halves(rows);
  const auto put = [&](std::size_t k, __m512d two) {
    _mm256_store_pd(to + k * stride, _mm512_castpd512_pd256(two));
    _mm256_store_pd(to + (k + 4) * stride, _mm512_extractf64x4_pd(two, 1));
  };
  for (std::size_t k = 0; k < 4; ++k) put(k, rows[k]);
}

/// The x, y and z of eight vectors that follow each other in memory, and back.
REPOSE_FN void load_threes(const double* from, Numbers (&to)[3]) {
  const __m512d a = _mm512_loadu_pd(from);
  const __m512d b = _mm512_loadu_pd(from + 8);
  const __m512d c = _mm512_loadu_pd(from + 16);
  const auto pick = [&](__m512i of_ab, __m512i and_c) {
    return Numbers(Lanes(_mm512_permutex2var_pd(_mm512_permutex2var_pd(a, of_ab, b), and_c, c)));
  };
  to[0] = pick(_mm512_setr_epi64(0, 3, 6, 9, 12, 15, 0, 0), _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 10, 13));
  to[1] = pick(_mm512_setr_epi64(1, 4, 7, 10, 13, 0, 0, 0), _mm512_setr_epi64(0, 1, 2, 3, 4, 8, 11, 14));
  to[2] = pick(_mm512_setr_epi64(2, 5, 8, 11, 14, 0, 0, 0), _mm512_setr_epi64(0, 1, 2, 3, 4, 9, 12, 15));
}
REPOSE_FN void store_threes(const Numbers (&from)[3], double* to) {
  const __m512d x = static_cast<__m512d>(from[0].lanes);
  const __m512d y = static_cast<__m512d>(from[1].lanes);
  const __m512d z = static_cast<__m512d>(from[2].lanes);
  const auto pick = [&](__m512i of_xy, __m512i and_z) {
    return _mm512_permutex2var_pd(_mm512_permutex2var_pd(x, of_xy, y), and_z, z);
  };
  _mm512_storeu_pd(to, pick(_mm512_setr_epi64(0, 8, 0, 1, 9, 0, 2, 10), _mm512_setr_epi64(0, 1, 8, 3, 4, 9, 6, 7)));
  _mm512_storeu_pd(to + 8,
                   pick(_mm512_setr_epi64(0, 3, 11, 0, 4, 12, 0, 5), _mm512_setr_epi64(10, 1, 2, 11, 4, 5, 12, 7)));
  _mm512_storeu_pd(to + 16,
                   pick(_mm512_setr_epi64(13, 0, 6, 14, 0, 7, 15, 0), _mm512_setr_epi64(0, 13, 2, 3, 14, 5, 6, 15)));
}

#elif defined(__AVX2__)

REPOSE_FN void transpose(__m256d (&rows)[4]) {
  const __m256d ab_even = _mm256_unpacklo_pd(rows[0], rows[1]);
  const __m256d ab_odd = _mm256_unpackhi_pd(rows[0], rows[1]);
  const __m256d cd_even = _mm256_unpacklo_pd(rows[2], rows[3]);
  const __m256d cd_odd = _mm256_unpackhi_pd(rows[2], rows[3]);
  rows[0] = _mm256_permute2f128_pd(ab_even, cd_even, 0x20);
  rows[1] = _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20);
  rows[2] = _mm256_permute2f128_pd(ab_even, cd_even, 0x31);
  rows[3] = _mm256_permute2f128_pd(ab_odd, cd_odd, 0x31);
}

template <class Line>
REPOSE_FN void sum_fours(const Line* lines, const std::uint32_t* first, const std::uint32_t* second, std::size_t offset,
                         const Four& signs, Numbers (&to)[4]) {
  const auto at = [&](std::uint32_t k) { return reinterpret_cast<const double*>(lines + std::size_t{k}) + offset; };
  __m256d rows[4];
  for (int k = 0; k < 4; ++k) {
    Four sum = four(at(first[k]));
    add_signed(four(at(second[k])), signs, sum);
    rows[k] = __m256d(sum);
  }
  transpose(rows);
  for (int k = 0; k < 4; ++k) to[k] = Numbers(Lanes(rows[k]));
}

/// The x, y and z of four vectors that follow each other in memory, and back.
REPOSE_FN void load_threes(const double* from, Numbers (&to)[3]) {
  const __m256d a = _mm256_loadu_pd(from);                // x0 y0 z0 x1
  const __m256d b = _mm256_loadu_pd(from + 4);            // y1 z1 x2 y2
  const __m256d c = _mm256_loadu_pd(from + 8);            // z2 x3 y3 z3
  const __m256d xy = _mm256_blend_pd(a, b, 0b1100);       // x0 y0 x2 y2
  const __m256d zx = _mm256_permute2f128_pd(a, c, 0x21);  // z0 x1 z2 x3
  const __m256d yz = _mm256_blend_pd(b, c, 0b1100);       // y1 z1 y3 z3
  to[0] = Numbers(Lanes(_mm256_shuffle_pd(xy, zx, 0b1010)));
  to[1] = Numbers(Lanes(_mm256_shuffle_pd(xy, yz, 0b0101)));
  to[2] = Numbers(Lanes(_mm256_shuffle_pd(zx, yz, 0b1010)));
}
REPOSE_FN void store_threes(const Numbers (&from)[3], double* to) {
  const __m256d x = static_cast<__m256d>(from[0].lanes);
  const __m256d y = static_cast<__m256d>(from[1].lanes);
  const __m256d z = static_cast<__m256d>(from[2].lanes);
  const __m256d xy = _mm256_shuffle_pd(x, y, 0b0000);
  const __m256d zx = _mm256_shuffle_pd(z, x, 0b1010);
  const __m256d yz = _mm256_shuffle_pd(y, z, 0b1111);
  _mm256_storeu_pd(to, _mm256_permute2f128_pd(xy, zx, 0x20));
  _mm256_storeu_pd(to + 4, _mm256_blend_pd(yz, xy, 0b1100));
  _mm256_storeu_pd(to + 8, _mm256_permute2f128_pd(zx, yz, 0x31));
}

REPOSE_FN void store_fours(const Numbers (&from)[4], double* to, std::size_t stride) {
  __m256d rows[4];
  for (int k = 0; k < 4; ++k) rows[k] = static_cast<__m256d>(from[k].lanes);
  transpose(rows);
  for (std::size_t k = 0; k < 4; ++k) _mm256_store_pd(to + k * stride, rows[k]);
}

#else

template <class Line>
REPOSE_FN void sum_fours(const Line* lines, const std::uint32_t* first, const std::uint32_t* second, std::size_t offset,
                         const Four& signs, Numbers (&to)[4]) {
  const auto at = [&](std::uint32_t k) { return reinterpret_cast<const double*>(lines + std::size_t{k}) + offset; };
  double rows[4][width];
  for (std::size_t k = 0; k < width; ++k) {
    const Four sum = four(at(first[k])) + four(at(second[k])) * signs;
    for (int n = 0; n < 4; ++n) rows[n][k] = sum[n];
  }
  for (int n = 0; n < 4; ++n) to[n] = load(rows[n]);
}

REPOSE_FN void store_fours(const Numbers (&from)[4], double* to, std::size_t stride) {
  for (std::size_t k = 0; k < width; ++k) {
    for (int n = 0; n < 4; ++n) to[k * stride + static_cast<std::size_t>(n)] = from[n].lanes[k];
  }
}

#endif
#endif

#if !defined(__AVX2__) || defined(REPOSE_SCALAR_ROWS)
REPOSE_FN void load_threes(const double* from, Numbers (&to)[3]) {
  double each[3][width];
  for (std::size_t k = 0; k < width; ++k) {
    for (std::size_t n = 0; n < 3; ++n) each[n][k] = from[3 * k + n];
  }
  for (int n = 0; n < 3; ++n) to[n] = load(each[n]);
}
REPOSE_FN void store_threes(const Numbers (&from)[3], double* to) {
  double each[3][width];
  for (int n = 0; n < 3; ++n) store(from[n], each[n]);
  for (std::size_t k = 0; k < width; ++k) {
    for (std::size_t n = 0; n < 3; ++n) to[3 * k + n] = each[n][k];
  }
}
#endif

#if !defined(__AVX512F__) || defined(REPOSE_SCALAR_ROWS)
template <class Line>
REPOSE_FN void sum_eights(const Line* lines, const std::uint32_t* first, const std::uint32_t* second, const Four& signs,
                          const Four& upper_signs, Numbers (&to)[8]) {
  Numbers lower[4];
  Numbers upper[4];
  sum_fours(lines, first, second, 0, signs, lower);
  sum_fours(lines, first, second, 4, upper_signs, upper);
  for (int k = 0; k < 4; ++k) {
    to[k] = lower[k];
    to[k + 4] = upper[k];
  }
}
#endif

}  // namespace
}  // namespace repose::soft
