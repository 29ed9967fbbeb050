// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/toml_file.hpp"

#include <string>
#include <utility>
#include <vector>

namespace repose {

/// A value as it would stand in a file, on one line; numbers as short as they read back the same.
std::string toml_text(const toml::node& node);

/// The values below a table with their dotted keys, in the order of the file; an inline table is a value.
std::vector<std::pair<std::string, const toml::node*>> values_below(const toml::table& table,
                                                                    const std::string& prefix = "");

}  // namespace repose
