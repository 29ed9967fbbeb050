// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/io/start_file.hpp"
#include "repose/scene/scene.hpp"

namespace repose {

/// Reads what the scene, which is of dimension D, starts from and puts it into the scene: units, plane, scale, flip,
/// shift, fixed types, names of materials, and the level axes wrapped into a periodic box. Throws InputError: lines of
/// the file that cannot be used, a run of another dimension.
template <int D>
StartState<D> state_at_start(const Scene& scene);

/// The periodic axes of the scene's box as far as their sizes are sound, for places that nothing has checked yet.
template <int D>
Box<D> wrapping_box(const Scene& scene);

/// Whether contacts keep what they remember when the grains are put into the scene.
bool keeps_contacts(const StartFrom& start);

}  // namespace repose
