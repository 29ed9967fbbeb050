// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

// toml++ takes for granted that a key begins like one; a header such as [?] breaks that, and the program with it. Its
// assumptions are therefore checked in every build, and one that does not hold ends the reading. The library is used as
// headers only, inside this folder, and always through this file.
namespace repose {
struct TomlAssumptionError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
constexpr void check_toml_assumption(bool holds) {
  if (!holds) throw TomlAssumptionError("not TOML");
}
}  // namespace repose
#define TOML_ASSERT(expression) ::repose::check_toml_assumption(static_cast<bool>(expression))
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace repose {

/// The content of a file; InputError with the system's reason if it cannot be read.
std::string text_of_file(const std::string& path);

/// TOML text as a table; InputError "name:line: what" if it is not TOML.
toml::table parsed_toml(const std::string& text, const std::string& name);

}  // namespace repose
