// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace repose {

/// The four packing regimes of paper one (Bratberg, Radjai, Hansen, PRE 66, 031303, 2002, section IV).
enum class PackingRegime {
  loose_random,     ///< solid fraction below 0.6: chains, screening; most discs have two contacts
  moderate_random,  ///< 0.6 to 0.7: branching; most discs have three contacts
  dense_close,      ///< 0.7 to 0.8: piling; most discs have four contacts
  dense_ordered     ///< above 0.8: more than four contacts on average
};

/// For reports: "loose random" and so on.
std::string_view name_of(PackingRegime regime);

/// The regime by solid fraction, the paper's own variable. The paper calls its boundaries 0.6, 0.7 and 0.8 approximate
/// and does not state to which side they belong; here they belong to the denser. They hold for equal discs deposited at
/// random in 2D. None if the solid fraction is NaN.
std::optional<PackingRegime> regime_of(double solid_fraction);

/// The regime by structure, after the same section: z > 4 is dense ordered; otherwise the most frequent number of
/// contacts decides (1 or 2: loose random, 3: moderate random, 4 and more: dense close; the smaller number in a tie).
/// It is independent of the solid fraction and need not agree with it near the boundaries. None without contacts.
std::optional<PackingRegime> regime_of(const std::array<double, 7>& connectivity, double coordination);

}  // namespace repose
