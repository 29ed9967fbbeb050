// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

#include <string>

namespace repose {

/// The scene as a TOML file with every key, defaults filled in, units and meaning beside each.
std::string scene_text(const Scene& scene);

/// A scene that may be filled in by hand as a TOML file with what it gives, without what it leaves to the defaults.
std::string given_text(const Scene& scene);

}  // namespace repose
