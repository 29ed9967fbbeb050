// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/api/analysis.hpp"
#include "repose/record/record.hpp"

#include <vector>

namespace repose::api {

/// The measures that the analysis finds in a record.
template <int D>
std::vector<Measure> measures_of_record(const Record<D>& record);

}  // namespace repose::api
