// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/results/results.hpp"
#include "repose/results/sphere_results.hpp"
#include "repose/scene/scene.hpp"

#include <string>

namespace repose {

/// Describes the run of a scene: grains, laws, time step with its reason, expected end.
std::string describe(const Scene& scene);

/// Describes the contacts of each pair of materials: restitution, contact time, overlaps at rest, steps per contact.
std::string describe_contacts(const Scene& scene);

/// Describes the result of a run in a few lines.
std::string describe_result(const Record<2>& record, const Results<2>& results);
std::string describe_result(const Record<3>& record, const Results<3>& results);

/// What the floor of a column carries, and what Janssen's law says with the measured K and friction.
std::string describe_column(const ColumnState& column);

/// The part of it that does not depend on the dimension: how the run ended, and its warnings.
template <int D>
std::string describe_end(const Record<D>& record);

}  // namespace repose
