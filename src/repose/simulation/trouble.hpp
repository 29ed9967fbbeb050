// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace repose {

template <int D>
class Simulation;

/// Relative overlap beyond which a run fails: the centres are closer than a quarter of the mean diameter, for which no
/// law is meant.
inline constexpr double largest_overlap = 0.75;

/// Why the present state of a simulation cannot be trusted: the message of a run that fails.
template <int D>
std::string describe_trouble(const Simulation<D>& simulation);

}  // namespace repose
