// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/packing_regime.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

std::string_view name_of(PackingRegime regime) {
  switch (regime) {
    case PackingRegime::loose_random:
      return "loose random";
    case PackingRegime::moderate_random:
      return "moderate random";
    case PackingRegime::dense_close:
      return "dense close";
    case PackingRegime::dense_ordered:
      break;
  }
  return "dense ordered";
}

std::optional<PackingRegime> regime_of(double solid_fraction) {
  if (std::isnan(solid_fraction)) return std::nullopt;
  if (solid_fraction < 0.6) return PackingRegime::loose_random;
  if (solid_fraction < 0.7) return PackingRegime::moderate_random;
  if (solid_fraction < 0.8) return PackingRegime::dense_close;
  return PackingRegime::dense_ordered;
}

std::optional<PackingRegime> regime_of(const std::array<double, 7>& connectivity, double coordination) {
  if (!(coordination > 0.0)) return std::nullopt;
  if (coordination > 4.0) return PackingRegime::dense_ordered;
  const auto most = std::max_element(connectivity.begin() + 1, connectivity.end()) - connectivity.begin();
  if (most <= 2) return PackingRegime::loose_random;
  return most == 3 ? PackingRegime::moderate_random : PackingRegime::dense_close;
}

}  // namespace repose
