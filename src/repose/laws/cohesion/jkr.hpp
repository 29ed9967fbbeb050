// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace repose {

/// Adhesion of elastic spheres. With the radius a of the contact area, w the work of adhesion,
///
///     overlap = a^2/R* - sqrt(2 pi w a/E*),   F = 4 E* a^3/(3 R*) - sqrt(8 pi w E*) a^(3/2)
///
/// A contact begins at zero overlap, with the pull 4/3 pi w R*, and ends at the pull-off force 3/2 pi w R*, where the
/// grains are a gap apart: between the two it depends on the past, and `bonded` keeps it. Hertz's law acts beside it,
/// so the attraction is Hertz's force less F, and friction follows Hertz's force. Both use the same E*.
/// Source: Johnson, Kendall & Roberts (1971). Validated by tests/unit/jkr_test.cpp (pull-off, rest, energy of a cycle,
/// checkpoint) and tests/cli/test_jkr.py.
struct Jkr {
  double surface_energy = 1.0;  ///< w [M/T^2] > 0
  double modulus = 0.0;         ///< E* [M/(L T^2)]; 0: that of a Hertz contact of `stiffness`
  double stiffness = 5000.0;    ///< [M/(L^(1/2) T^2)] k of Hertz's law, from which E* = 3 k / (4 sqrt(R*))

  static constexpr std::string_view name = "jkr";
};

inline void parameters(Jkr& law, Parameters& to, const LawScales&) {
  to.number("surface_energy", law.surface_energy, required, positive, "M/T^2",
            "work of adhesion w of both surfaces: the pull-off force is 3/2 pi w R*");
}

/// The law of a contact with one effective radius. Formulas use b, the root of the radius of the contact area:
/// overlap = b^4/R - s b and F = 2 E b^3 (2 b^3/(3 R) - s), with s = sqrt(2 pi w/E).
struct JkrContact {
  double radius;   ///< R* [L]
  double modulus;  ///< E* [M/(L T^2)]
  double neck;     ///< s [L^(1/2)]

  /// The b at which b^3 = part R s: 3/4 at pull-off, 1 at zero overlap, 3/2 at zero force.
  double root_at(double part) const { return reproducible::pow(part * radius * neck, 1.0 / 3.0); }
  double overlap(double b) const { return b * (b * b * b / radius - neck); }
  double force(double b) const { return 2.0 * modulus * (b * b * b) * (2.0 * (b * b * b) / (3.0 * radius) - neck); }

  /// The integral of the force over the overlap from 0 to that of b.
  double energy(double b) const {
    const auto from_origin = [this](double at) {
      const double cube = at * at * at / radius;
      return modulus * radius * (at * cube) *
             ((8.0 / 15.0) * cube * cube - (4.0 / 3.0) * cube * neck + 0.5 * neck * neck);
    };
    return from_origin(b) - from_origin(root_at(1.0));
  }

  /// -dF/dr [M/T^2].
  double stiffness(double b) const {
    const double steep = 4.0 * (b * b * b) / radius;
    return 2.0 * modulus * (b * b) * (steep - 3.0 * neck) / (steep - neck);
  }

  double overlap_at_pull_off() const { return -0.25 * neck * root_at(0.75); }

  /// The b of this overlap on the stable branch, for overlaps from that at pull-off on. Newton's method from above on a
  /// convex function: each step is one of sums, products and quotients, and steps end where they no longer shorten b.
  double root_of(double wanted) const {
    const double deep = std::sqrt(std::sqrt(2.0 * radius * positive_part(wanted)));
    double b = std::max(root_at(2.0), deep);
    constexpr int most = 100;
    for (int n = 0; n < most; ++n) {
      const double cube = b * b * b / radius;
      const double next = (3.0 * b * cube + wanted) / (4.0 * cube - neck);
      if (!(next < b)) break;
      b = next;
    }
    return b;
  }

  /// The Hertz load whose contact area is that of this load [M L/T^2].
  double apparent_load(double load) const {
    const double pull = 1.5 * std::numbers::pi * surface_energy() * radius;
    return load + 2.0 * pull + std::sqrt(4.0 * pull * (load + pull));
  }
  /// The overlap at rest under this load; a load of 0 or more.
  double overlap_under(double load) const {
    const double cube = 0.75 * radius * apparent_load(load) / modulus;
    return overlap(std::sqrt(reproducible::pow(cube, 1.0 / 3.0)));
  }
  double surface_energy() const { return 0.5 * neck * neck * modulus / std::numbers::pi; }
};

inline JkrContact at_radius(const Jkr& law, double effective_radius) {
  const double modulus = law.modulus > 0.0 ? law.modulus : 0.75 * law.stiffness / std::sqrt(effective_radius);
  return {effective_radius, modulus, std::sqrt(2.0 * std::numbers::pi * law.surface_energy / modulus)};
}

/// The attraction of a contact that is `bonded`, or becomes so because it overlaps; a bond that is stretched beyond
/// pull-off ends.
inline double attraction(const Jkr& law, const Touch<double>& touch, bool& bonded) {
  const bool overlaps = touch.overlap > 0.0;
  if (!overlaps && !bonded) return 0.0;
  const auto contact = at_radius(law, touch.effective_radius);
  bonded = overlaps || touch.overlap >= contact.overlap_at_pull_off();
  if (!bonded) return 0.0;
  const double pressed = positive_part(touch.overlap);
  const double hertz = (4.0 / 3.0) * contact.modulus * std::sqrt(contact.radius * pressed) * pressed;
  return hertz - contact.force(contact.root_of(touch.overlap));
}

/// The energy [M L^2/T^2] of a bond less that of Hertz's contact; 0 where a contact begins.
inline double cohesion_energy(const Jkr& law, const Touch<double>& touch, bool bonded) {
  if (!bonded) return 0.0;
  const auto contact = at_radius(law, touch.effective_radius);
  const double pressed = positive_part(touch.overlap);
  const double hertz = (8.0 / 15.0) * contact.modulus * std::sqrt(contact.radius * pressed) * pressed * pressed;
  return contact.energy(contact.root_of(touch.overlap)) - hertz;
}

/// The energy [M L^2/T^2] that is lost where a bond ends: 3.503 (w^5 R*^4/E*^2)^(1/3).
inline double energy_of_break(const Jkr& law, const Touch<double>& touch) {
  const auto contact = at_radius(law, touch.effective_radius);
  return contact.energy(contact.root_at(0.75));
}

/// The distance, in diameters of the smallest grain, up to which bonds of grains that are no smaller last: that of a
/// grain on a wall, the longest.
inline double reach_of_bonds(const Jkr& law, double smallest_diameter) {
  return 1.0 - at_radius(law, 0.5 * smallest_diameter).overlap_at_pull_off() / smallest_diameter;
}

/// Stiffness [M/T^2] at the overlap where the contact has stored `energy` >= 0.
inline double stiffness_at(const JkrContact& contact, double energy) {
  double low = contact.root_at(1.5);
  double high = 2.0 * low;
  while (contact.energy(high) < energy) high *= 2.0;
  for (int n = 0; n < 100; ++n) {
    const double middle = 0.5 * (low + high);
    (contact.energy(middle) < energy ? low : high) = middle;
  }
  return contact.stiffness(high);
}

}  // namespace repose
