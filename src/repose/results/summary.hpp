// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/results/results.hpp"
#include "repose/results/sphere_results.hpp"

#include <string>
#include <string_view>

namespace repose {

/// summary.json: numbers by name, null where not defined; see docs/reference/summary.md.
template <int D>
std::string summary_text(const Record<D>& record, const Results<D>& results);

/// "status" of the text of a summary; "" if it is none, or not as it was written.
std::string summary_status(const std::string& text);

/// The text of a summary, which must be whole, with the entry "theory" (JSON; "": none) in the place of the one that it
/// has, as the last before the checksum; all else stays as it is, to the byte.
std::string with_theory(const std::string& text, const std::string& theory);

/// The text of a JSON object closed by its checksum, as summaries are.
std::string with_checksum(std::string json);

/// Whether a text ends with its own checksum.
bool is_whole_summary(std::string_view text);

}  // namespace repose
