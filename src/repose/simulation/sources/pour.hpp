// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/simulation/sources/drop.hpp"

namespace repose {

/// Pours grains from an opening, each at its own time.
template <int D>
class Pour final : public Drop<D> {
 public:
  using Drop<D>::Drop;
};

}  // namespace repose
