// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/start_file.hpp"
#include "repose/scene/scene.hpp"

namespace repose {

/// Reads what the scene starts from and puts it into the scene: units, plane, scale, flip, shift, fixed types, names of
/// materials, and x wrapped into a periodic box. Throws InputError: lines of the file that cannot be used.
StartState state_at_start(const Scene& scene);

/// Whether contacts keep what they remember when the grains are put into the scene.
bool keeps_contacts(const StartFrom& start);

}  // namespace repose
