// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run/reading.hpp"
#include "repose/run/record.hpp"

#include <string>

namespace repose {

/// summary.json: numbers by name, null where not defined; see docs/reference/summary.md.
std::string summary_text(const Record& record, const Reading& reading);

/// "status" of the text of a summary; "" if it is none, or not as it was written.
std::string summary_status(const std::string& text);

}  // namespace repose
