// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/voronoi.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/ordered_grains.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace repose {

/// The mean stress in the part of the plane that belongs to one grain.
struct GrainStress {
  std::int64_t id = 0;
  double area = 0.0;               ///< [L^2] of its Voronoi cell where that is closed, else of its disc
  bool in_cell = false;            ///< whether that is the cell
  std::array<double, 4> stress{};  ///< [M/T^2] xx, xy, yx, yy; compression positive; first index: force
};

/// The stress of each grain, by ascending id: 1/area times the sum over its contacts of the force on the grain and the
/// branch from the contact point to its centre. Fixed grains have one too, over their disc.
///
/// The sum over grains of area times stress is the sum over contacts of the force on the first partner and the branch
/// from the centre of the second, or the point of the wall, to that of the
/// first. Without fixed grains it is the integral of the field of stress (analysis/fields.hpp).
/// Source: Goldhirsch and Goldenberg, Eur. Phys. J. E 9, 245 (2002), eq. 1. Validated by
/// tests/unit/grain_stress_test.cpp.
std::vector<GrainStress> grain_stresses(const OrderedGrains<2>& grains, const Contacts<2>& contacts,
                                        const std::vector<VoronoiCell>& cells, const Box<2>& box);

}  // namespace repose
