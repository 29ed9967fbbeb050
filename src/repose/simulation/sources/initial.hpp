// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>
#include <string>

namespace repose {

/// A grain of this diameter and material ("": the first) at rest at the origin.
template <int D = 2>
Grain<D> make_grain(const Scene& scene, double diameter, const std::string& material = "");

/// The grains that exist at the start: the base first, by ascending x, then what the scene starts from, then a
/// lattice, row by row, then the placed ones. Ids ascend.
template <int D = 2>
Grains<D> initial_grains(const Scene& scene);

// The parts of these by origin, one source file each. `id` is that of the next grain to be added.

/// What the scene starts from (start.cpp): grains of a run keep their ids, those of a file are numbered in its order.
/// Throws InputError if it cannot be read any more.
template <int D>
void add_start(const Scene& scene, Grains<D>& grains, std::int64_t& id);

/// The contacts of the run that the scene starts from, between the walls of the present scene with the same names;
/// empty where they mean nothing to the present law (start.cpp).
template <int D>
Contacts<D> contacts_at_start(const Scene& scene);

}  // namespace repose
