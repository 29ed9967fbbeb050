// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run/reading.hpp"

#include <string>

namespace repose {

/// summary.json of a simulation: keys as in docs/reference/summary.md, null where a number is not defined.
std::string summary_text(const Simulation& simulation, const Contacts<2>& contacts, const Reading& reading);

}  // namespace repose
