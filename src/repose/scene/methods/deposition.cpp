// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/methods/deposition.hpp"

#include <fmt/format.h>

namespace repose {

void DepositionMethod::check(const Scene& scene, Problems& problems) const {
  if (!problems.none()) return;
  const double smallest = scene.smallest_drawn();
  const double largest = scene.largest_drawn();
  if (smallest < 1e-3 * largest) {
    problems.problem(
        "grains", fmt::format(": diameters from {:.3g} to {:.3g}: the ratio must be at most 1000", smallest, largest));
  }
}

std::string DepositionMethod::describe(const Scene& scene) const {
  return fmt::format("sides            {}\ncritical angle   {:g} deg{}\n",
                     scene.box.periodic() ? "periodic"
                     : scene.box.open()   ? "open"
                                          : "between walls",
                     critical_angle, snaps() ? ", places snapped to 2^-40 radii" : "");
}

}  // namespace repose
