// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/reproducible_math.hpp"
#include "repose/laws/normal/damping.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>

namespace repose {

/// x^n for a whole number n >= 0 by repeated squaring: the same bits on every machine, unlike std::pow.
template <class T>
REPOSE_FN T whole_power(T x, unsigned n) {
  T result = 1.0;
  for (; n != 0; n >>= 1) {
    if ((n & 1U) != 0) result *= x;
    x *= x;
  }
  return result;
}

/// Continuous interaction: F = m g (s/r)^(n+1) for r < r0 s, with a dashpot relative to the local stiffness (default:
/// half critical). A grain at rest on a fixed grain of its size sits at exactly r = s.
/// Source: Baxter et al. (1997), eq. (3) and section II, with the sign of the exponent corrected.
/// Validated by tests/validation/soft_exact_test.cpp (rest distance, energy of an impact).
struct Continuous {
  double exponent = 36.0;        ///< n > 0
  double cutoff = 1.2;           ///< r0 >= 1, in mean diameters
  double damping = 0.5;          ///< >= 0; its meaning depends on damping_kind
  double gravity = 1.0;          ///< [L/T^2] sets the scale m g of the force, > 0
  bool attraction = false;       ///< whether the dashpot may make the total force attractive
  unsigned whole_exponent = 37;  ///< n + 1 if it is a whole number (fast path), else 0
  DampingKind damping_kind = DampingKind::of_critical;
  double restitution = 0.0;   ///< requested restitution, if damping_kind is restitution
  double impact_speed = 0.0;  ///< [L/T] speed of the impact that has this restitution

  static constexpr std::string_view name = "continuous";
  static constexpr bool restitution_depends_on_speed = true;

  static Continuous make(double exponent, double cutoff, double damping, double gravity, bool attraction = false) {
    const double next = exponent + 1.0;
    const bool whole = next == std::floor(next) && next < 1e6;
    Continuous law{exponent, cutoff, damping, gravity, attraction};
    law.whole_exponent = whole ? static_cast<unsigned>(next) : 0U;
    return law;
  }
};

inline void parameters(Continuous& law, Parameters& to, const LawScales& scales) {
  to.number("exponent", law.exponent, 36.0, positive, "", "n of F = m g (s/r)^(n+1)");
  to.number("cutoff", law.cutoff, 1.2, at_least_one, "diameters",
            "r0: the force acts below this distance; at 1, grains touch");
  damping_parameters(law, to, scales);
  const auto whole = Continuous::make(law.exponent, law.cutoff, law.damping, scales.gravity);
  law.gravity = whole.gravity;
  law.whole_exponent = whole.whole_exponent;
}

/// The distance, in mean diameters, below which the law acts.
REPOSE_FN double reach(const Continuous& law) { return law.cutoff; }

/// x^(n+1). For a pack of numbers n must be whole.
REPOSE_FN double power(const Continuous& law, double x) {
  return law.whole_exponent != 0 ? whole_power(x, law.whole_exponent) : reproducible::pow(x, law.exponent + 1.0);
}
template <class T>
REPOSE_FN T power(const Continuous& law, const T& x) {
  return whole_power(x, law.whole_exponent);
}

template <class T>
REPOSE_FN NormalForce<T> normal_force(const Continuous& law, const Touch<T>& touch) {
  const T elastic = touch.mass * law.gravity * power(law, touch.diameter * touch.inverse_distance);
  const T stiffness = (law.exponent + 1.0) * elastic * touch.inverse_distance;
  const T viscous = dashpot(law, touch, root(stiffness)) * touch.closing_speed;
  return {elastic, without_attraction(law.attraction, elastic + viscous), stiffness};
}

/// Energy [M L^2/T^2] stored in a pair with mean diameter `diameter` at `distance`; 0 at the cutoff.
inline double elastic_energy(const Continuous& law, double mass, double diameter, double distance) {
  const double scale = mass * law.gravity * diameter / law.exponent;
  return scale * (reproducible::pow(diameter / distance, law.exponent) - reproducible::pow(law.cutoff, -law.exponent));
}

/// Stiffness -dF/dr [M/T^2] at the distance where the pair stores `energy`.
inline double stiffness_at(const Continuous& law, double mass, double diameter, double energy) {
  const double scale = mass * law.gravity * diameter / law.exponent;
  const double x = reproducible::pow(energy / scale + reproducible::pow(law.cutoff, -law.exponent), 1.0 / law.exponent);
  return (law.exponent + 1.0) * mass * law.gravity * reproducible::pow(x, law.exponent + 2.0) / diameter;
}

}  // namespace repose
