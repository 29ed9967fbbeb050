// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/stability/stiffness_matrix.hpp"

#include <string>
#include <vector>

namespace repose {

/// Why the contacts of a record are no springs of normal forces alone; empty where they are.
std::string reason_without_springs(const Record<2>& record);

/// The contacts of a record that carry force on grains that can move, by the laws of its scene. Grains are numbered by
/// their places in the record. A wall with friction on which a grain does not slide holds it along the wall.
std::vector<ContactSpring> springs_of(const Record<2>& record);

}  // namespace repose
