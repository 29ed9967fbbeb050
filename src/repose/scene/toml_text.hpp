// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace repose {

/// Text as TOML writes it, in quotation marks.
std::string toml_quoted(std::string_view text);

/// The shortest text that reads back as the same double, always with a point or an exponent.
std::string toml_number(double value);

}  // namespace repose
