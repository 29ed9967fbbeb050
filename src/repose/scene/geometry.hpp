// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/box.hpp"
#include "repose/scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// The walls of the scene at the start: a base plane first, then planes, walls and drums.
template <int D = 2>
std::vector<Wall<D>> make_walls(const Scene& scene);

/// The walls at a time [T]. `states` has an entry for each, or none where all stand still.
template <int D>
std::vector<WallNow<D>> walls_at(const std::vector<Wall<D>>& walls, const std::vector<WallState>& states, double time);

/// The first wall that a grain of a radius [L] at `centre` would touch, by its number: two bodies touch that are nearer
/// than `reach` times the sum of their radii.
template <int D>
std::optional<std::size_t> overlapping_wall(const std::vector<Wall<D>>& walls, const std::vector<WallNow<D>>& now,
                                            const Box<D>& box, const Vec<D>& centre, double radius, double reach);

/// The number of the wall that keeps the smallest grain from the first of these places [L], where walls keep it from
/// all of them; none if there is room somewhere. Walls that move or open may give way and do not count.
template <int D>
std::optional<std::size_t> wall_that_blocks(const Scene& scene, const std::vector<Vec<D>>& places);

/// Their names, in the same order.
std::vector<std::string> wall_names(const Scene& scene);

/// A partner of a contact in a message: "grain 7", or "wall floor" by its name.
std::string partner_name(const Scene& scene, std::int64_t partner);

template <int D = 2>
Box<D> make_box(const Scene& scene);

/// The sides [L] between which grains lie along x at the start: those of the box, or upright planes nearer by.
struct UprightSides {
  double left = 0.0, right = 0.0;
};
UprightSides upright_sides(const Scene& scene);

}  // namespace repose
