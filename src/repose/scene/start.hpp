// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/reader.hpp"
#include "repose/scene/scene.hpp"

#include <string>

namespace repose {

/// Looks at what the scene starts from, whose path is relative to `folder`: fills in what the scene must know of it,
/// and adds what is wrong with it to the problems.
void look_at_start(Scene& scene, Reader& reader, const std::string& folder);

}  // namespace repose
