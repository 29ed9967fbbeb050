// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/methods/method.hpp"
#include "repose/methods/soft/settings.hpp"
#include "repose/scene/scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace repose {

/// A grain of this diameter and material ("": the first) at rest at the origin.
Grain<2> make_grain(const Scene& scene, double diameter, const std::string& material = "");

/// The grains that are there at the start: the base first, by ascending x, then what the scene starts from, then a
/// lattice, row by row, then the placed ones. Ids ascend.
Grains<2> initial_grains(const Scene& scene);

/// The walls of the scene: a base plane first, then planes, then segments.
std::vector<Wall<2>> make_walls(const Scene& scene);

/// Their names, in the same order.
std::vector<std::string> wall_names(const Scene& scene);

Box<2> make_box(const Scene& scene);

/// The method of the scene, ready to run.
std::unique_ptr<Method<2>> make_method(const Scene& scene);

}  // namespace repose
