// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/simulation/simulation.hpp"

#include <string>

namespace repose {

/// The profile of a run as a table for the terminal.
template <int D>
std::string describe_profile(const Simulation<D>& simulation);

/// The text of profile.json. Times of the clock stay out of the other files, which a repeated run writes to the same
/// bits.
template <int D>
std::string profile_text(const Simulation<D>& simulation);

}  // namespace repose
