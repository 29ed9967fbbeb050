// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/groups.hpp"
#include "repose/io/reference_table.hpp"
#include "repose/sweep/table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

/// A point of a sweep with the number of its members.
struct PointRow {
  std::string name;
  std::size_t finished = 0;
  std::size_t failed = 0;
};

// The groups of sweep.h5; those of measures and profiles repeat under other names.

const Group<std::vector<PointRow>>& point_group();
const Group<std::vector<MemberRow>>& member_group();
Group<std::vector<EnsembleEstimate>> estimate_group(const std::string& name, const std::string& unit);
Group<EnsembleProfile> profile_group(const std::string& name);
/// Units are those of so many dimensions.
Group<EnsembleColumn> column_group(const std::string& name, std::int64_t dimension);
Group<BinnedProfile> binned_group(const std::string& name);

/// The columns of claims.csv.
ReferenceTable claims_reference();

/// The tables of docs/reference/sweep.md.
std::vector<ReferenceTable> sweep_reference();

}  // namespace repose
