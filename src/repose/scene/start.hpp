// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/start_file.hpp"
#include "repose/scene/reader.hpp"
#include "repose/scene/scene.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace repose {

/// Looks at what the scene, which is of dimension D, starts from, whose path is relative to `folder`: fills in what the
/// scene must know of it, and adds what is wrong with it to the problems. Returns the grains in their places; nothing
/// if they are unsound or the scene starts from nothing.
template <int D>
std::optional<StartState<D>> look_at_start(Scene& scene, Reader& reader, const std::string& folder);

/// The same for the end of a run of `earlier` that is yet to come, as far as that scene tells.
void expect_start(Scene& scene, const Scene& earlier, Reader& reader);

/// The name of the file of wall number `piece` in a run folder.
std::string surface_file(std::size_t piece);

/// The scene as a run keeps it: its start, and the surfaces of its walls, are the copies that lie beside it in the run
/// folder.
Scene with_own_start(Scene scene);

}  // namespace repose
