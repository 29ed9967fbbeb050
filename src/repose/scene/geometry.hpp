// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/box.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

/// The walls of the scene at the start: a base plane first, then planes, then segments.
std::vector<Wall<2>> make_walls(const Scene& scene);

/// Their names, in the same order.
std::vector<std::string> wall_names(const Scene& scene);

/// A partner of a contact in a message: "grain 7", or "wall floor" by its name.
std::string partner_name(const Scene& scene, std::int64_t partner);

Box<2> make_box(const Scene& scene);

}  // namespace repose
