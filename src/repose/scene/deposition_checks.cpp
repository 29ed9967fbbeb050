// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

namespace repose {

void check_deposition(const Scene& scene, Reader& reader) {
  constexpr std::int64_t most = 2'000'000'000;
  if (scene.source.count > most && reader.sound("source.count")) {
    reader.problem("source.count", fmt::format(" = {}: must be at most {}", scene.source.count, most));
  }
  if (scene.base.count > 10'000'000 && reader.sound("base.count")) {
    reader.problem("base.count", fmt::format(" = {}: must be at most 10000000", scene.base.count));
  }
  if (!reader.problems().empty()) return;
  if (scene.smallest_drawn() < 1e-3 * scene.largest_drawn()) {
    reader.problem("grains", fmt::format(": diameters from {:.3g} to {:.3g}: the ratio must be at most 1000",
                                         scene.smallest_drawn(), scene.largest_drawn()));
  }
  const double width = 2.0 * scene.box.half_width;
  if (width < 2.0 * scene.largest_drawn() * (1.0 - 1e-9)) {
    reader.problem("base.count",
                   fmt::format(" = {}: the width {:.4g} must be at least two of the largest diameters, {:.4g} [L]",
                               scene.base.count, width, 2.0 * scene.largest_drawn()));
  }
}

void check_packing(const Scene& scene, Reader& reader) {
  if (!scene.analysis.packing || !reader.sound("analysis.slab")) return;
  const auto [low, high] = scene.analysis.slab;
  // Where grains lie evenly up to the top, that is at twice their mean height.
  if (low < 0.0 || high <= low || low >= 2.0) {
    reader.problem("analysis.slab", fmt::format(" = [{}, {}]: an empty slab; must be 0 <= low < high, low < 2, in mean "
                                                "heights of the grains",
                                                low, high));
  }
}

}  // namespace repose
