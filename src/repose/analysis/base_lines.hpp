// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/flat_wall.hpp"
#include "repose/core/box.hpp"
#include "repose/core/ordered_grains.hpp"

#include <vector>

namespace repose {

/// The lines between the centres of fixed grains that stand so close that the smallest moving grain cannot pass between
/// them, as finite walls. Lines that continue each other are one wall. A row of base grains is a wall, one with wide
/// gaps is none. Validated by tests/unit/fields_walls_test.cpp.
std::vector<FlatWall> base_lines(const OrderedGrains<2>& grains, const Box<2>& box);

}  // namespace repose
