// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/results/results.hpp"
#include "repose/scene/scene.hpp"

#include <string>

namespace repose {

/// Describes the run of a scene: grains, laws, time step with its reason, expected end.
std::string describe(const Scene& scene);

/// Describes the contacts of each pair of materials: restitution, contact time, overlaps at rest, steps per contact.
std::string describe_contacts(const Scene& scene);

/// Describes the result of a run in a few lines.
std::string describe_result(const Record& record, const Results& results);

}  // namespace repose
