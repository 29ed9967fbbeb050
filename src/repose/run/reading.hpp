// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_profile.hpp"
#include "repose/analysis/force_network.hpp"
#include "repose/analysis/heap.hpp"
#include "repose/run/simulation.hpp"

#include <optional>

namespace repose {

/// Everything that the analysis says of the present state of a simulation.
struct Reading {
  HeapShape heap;
  ForceNetwork network;
  BaseProfile base;
  std::optional<BaseDip> dip;
  double base_height = 0.0;            ///< [L]
  std::optional<double> weight_error;  ///< vertical force on the supports over the weight they carry, less 1
};

Reading read(const Simulation& simulation, const Contacts<2>& contacts);

}  // namespace repose
