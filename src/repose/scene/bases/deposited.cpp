// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/bases/deposited.hpp"

#include <fmt/format.h>

namespace repose {

void DepositedBase::check(const Scene& scene, Problems& problems) const {
  const double smallest = scene.smallest_drawn();
  const double largest = scene.largest_drawn();
  const bool periodic = scene.box.periodic();
  const double whole = 2.0 * (periodic ? scene.box.half_width : half_width);
  const std::string key = periodic ? "box.half_width" : "base.half_width";
  if (problems.sound("base.roughness") && roughness > 0.5 * smallest) {
    problems.problem("base.roughness",
                     fmt::format(" = {}: must be at most {}, half the smallest diameter, or neighbours would lie on "
                                 "each other [L]",
                                 roughness, 0.5 * smallest));
  }
  if (!problems.sound(key)) return;
  if (whole / smallest > most_base_grains) {
    problems.problem(key, fmt::format(" = {}: the base could have {:.3g} grains; at most {:g}", 0.5 * whole,
                                      whole / smallest, most_base_grains));
  }
  // What is left over of the width, less than a disc, is shared out among all gaps: none may let a grain through.
  if (largest * largest > 0.5 * smallest * whole) {
    problems.problem(key, fmt::format(" = {}: too narrow for a deposited base of these sizes, at least {:.4g} [L]",
                                      0.5 * whole, largest * largest / smallest));
  }
}

std::string DepositedBase::describe() const {
  return fmt::format("deposited, roughness {:g}, half-width {:g}", roughness, half_width);
}

}  // namespace repose
