// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

#include <string>

namespace repose {

/// Forces on base grains and walls, with stress models over them: `api/base` of docs/reference/view.md. Throws
/// InputError where the run has no base profile.
std::string base_arrays(const std::string& folder, const Scene& scene);

}  // namespace repose
