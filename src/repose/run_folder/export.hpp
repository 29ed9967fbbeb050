// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace repose {

/// What to export of a run folder, and where to.
struct ExportOrder {
  std::string folder;
  std::string to;          ///< "vtk", "ovito", "csv" or "contact-problem"
  std::string out;         ///< "": export/`to` in the run folder, which is replaced without asking
  bool frames = true;      ///< the saved frames too, not the last state alone; for "vtk" and "ovito"
  bool overwrite = false;  ///< `out` may hold other files already
};

/// What an export wrote.
struct Exported {
  std::string folder;
  std::vector<std::string> files;  ///< those to open: of a series the file that names its parts
  std::size_t moments = 0;         ///< states of the run that they hold
};

/// Writes the files of an export into a folder, and notes what they are.
using ExportWriter = std::function<void(const ExportOrder& order, const std::string& folder, Exported& done)>;

/// Writes it, or nothing if anything fails. Throws InputError, RunError.
Exported export_run(const ExportOrder& order);

/// The same by a writer for another format.
Exported export_run(const ExportOrder& order, const ExportWriter& writer);

}  // namespace repose
