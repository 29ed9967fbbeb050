// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/model_parameters.hpp"

#include <fmt/format.h>

namespace repose::theory {

std::string WholeBounds::text() const {
  if (high == std::numeric_limits<std::int64_t>::max()) return fmt::format("must be >= {}", low);
  return fmt::format("must be from {} to {}", low, high);
}

}  // namespace repose::theory
