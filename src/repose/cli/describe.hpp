// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"
#include "repose/results/results.hpp"
#include "repose/scene/scene.hpp"

#include <string>

namespace repose {

/// What a scene would run, for a reader: grains, laws, time step and why, expected end.
std::string describe(const Scene& scene);

/// Each pair of materials in a contact: restitution, contact time, overlaps at rest, steps per contact.
std::string describe_contacts(const Scene& scene);

/// What came out, in a few lines.
std::string describe_result(const Record& record, const Results& results);

}  // namespace repose
