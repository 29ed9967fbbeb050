// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/start_file.hpp"
#include "repose/scene/reader.hpp"
#include "repose/scene/scene.hpp"

#include <optional>
#include <string>

namespace repose {

/// Looks at what the scene starts from, whose path is relative to `folder`: fills in what the scene must know of it,
/// and adds what is wrong with it to the problems. Returns the grains in their places; nothing if they are unsound or
/// the scene starts from nothing.
std::optional<StartState> look_at_start(Scene& scene, Reader& reader, const std::string& folder);

/// The same for the end of a run of `earlier` that is yet to come, as far as that scene tells.
void expect_start(Scene& scene, const Scene& earlier, Reader& reader);

/// The scene as a run keeps it: its start is the copy that lies beside it in the run folder.
Scene with_own_start(Scene scene);

}  // namespace repose
