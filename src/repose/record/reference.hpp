// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/reference_table.hpp"

#include <vector>

namespace repose {

/// The tables of docs/reference/run-folder.md.
std::vector<ReferenceTable> run_folder_reference();

}  // namespace repose
