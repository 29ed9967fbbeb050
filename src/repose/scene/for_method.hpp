// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/toml_file.hpp"

#include <string>
#include <vector>

namespace repose {

// Methods differ in their keys: a soft contact has a stiffness, a rigid one none. So that one scene is one
// `--set method.kind=...` away from another method, its tables [for.KIND] hold what it says for that method alone.

/// Moves the keys of [for.KIND], KIND being the method of the scene, to their places in `root`, where they replace
/// those of the same name, and removes the table `for`. Adds a problem for a KIND that is no method; `name` is the
/// file.
void apply_keys_for_method(toml::table& root, const std::string& name, std::vector<std::string>& problems);

}  // namespace repose
