// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/hdf5_file.hpp"
#include "repose/results/results.hpp"

namespace repose {

/// The group /packing of analysis.h5 (docs/reference/analysis.md). To be called where there is a packing.
void write_packing(Hdf5File& file, const Record& record, const Results& results);

}  // namespace repose
