// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

// The library is used as headers only, inside this folder.
#include <toml++/toml.h>

namespace repose {

/// The content of a file; InputError with the system's reason if it cannot be read.
std::string text_of_file(const std::string& path);

/// TOML text as a table; InputError "name:line: what" if it is not TOML.
toml::table parsed_toml(const std::string& text, const std::string& name);

}  // namespace repose
