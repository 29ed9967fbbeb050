// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/parameters.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

std::string Bounds::text() const {
  const bool low_given = std::isfinite(low);
  const bool high_given = std::isfinite(high);
  if (low_given && high_given) {
    return fmt::format("must be {} {} and {} {}", low_allowed ? ">=" : ">", low, high_allowed ? "<=" : "<", high);
  }
  const auto* also = infinite_allowed ? ", or inf" : "";
  if (low_given) return fmt::format("must be {} {}{}", low_allowed ? ">=" : ">", low, also);
  if (high_given) return fmt::format("must be {} {}", high_allowed ? "<=" : "<", high);
  return "must be a finite number";
}

}  // namespace repose
