// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/simulation/sources/drop.hpp"

namespace repose {

/// Pours grains from an opening, each at its own time.
class Pour final : public Drop {
 public:
  using Drop::Drop;
};

}  // namespace repose
