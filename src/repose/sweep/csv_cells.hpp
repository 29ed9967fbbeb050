// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace repose {

/// A text as a cell of a CSV file, in quotation marks where that is needed.
inline std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

/// A number as a cell; empty where there is none.
inline std::string csv_number(double x) { return std::isnan(x) ? "" : fmt::format("{}", x); }

}  // namespace repose
