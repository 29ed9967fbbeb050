// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace repose {

/// What to export of a run folder, and where to.
struct ExportOrder {
  std::string folder;
  std::string to;  ///< "vtk", "ovito" or "csv"
  std::string out;
  bool frames = true;  ///< the saved frames too, not the last state alone; not for "csv"
};

/// Writes it; returns the names of the files, those of a series by the file that opens it. Throws InputError, RunError.
std::vector<std::string> export_run(const ExportOrder& order);

}  // namespace repose
