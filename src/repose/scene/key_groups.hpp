// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/keys.hpp"

namespace repose {

// The keys of a scene by subject, one source file each; `go_through` calls them in this order.

/// contact.*: the force laws (law_keys.cpp).
void law_keys(Scene& scene, Keys& keys);
/// base, box and planes (boundary_keys.cpp).
void boundary_keys(Scene& scene, Keys& keys);
/// Placed grains and the source (source_keys.cpp).
void source_keys(Scene& scene, Keys& keys);
/// stop, output and analysis (run_keys.cpp).
void run_keys(Scene& scene, Keys& keys);

}  // namespace repose
