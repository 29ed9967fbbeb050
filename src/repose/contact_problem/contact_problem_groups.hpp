// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"
#include "repose/io/groups.hpp"
#include "repose/io/reference_table.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace repose {

/// A body of a contact problem as its file has it.
struct BodyRow {
  std::int64_t id = 0;
  double mass = 0.0;
  double inertia = 0.0;
  double radius = 0.0;
  Vec<2> position{};
  std::array<double, 3> free_velocity{};
};

/// A contact of a contact problem as its file has it.
struct ContactRow {
  std::int64_t first = 0;
  std::int64_t second = 0;
  Vec<2> normal{};
  std::array<double, 2> arms{};
  double roll_radius = 0.0;
  double normal_bias = 0.0;
  double tangential_bias = 0.0;
  double friction = 0.0;
  double rolling_friction = 0.0;
  std::array<double, 3> impulse{};
};

const Group<std::vector<BodyRow>>& body_group();
const Group<std::vector<ContactRow>>& contact_group();

/// The tables of docs/reference/contact-problem.md.
std::vector<ReferenceTable> contact_problem_reference();

}  // namespace repose
