// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run_folder/export.hpp"

#include <cstddef>
#include <string>

namespace repose {

/// A run as one page that opens from disk, and how many moments it holds.
struct ExportedPage {
  std::string text;
  std::size_t moments = 0;
};

/// The page of a run folder with all saved frames and the last state, or with the last state alone. Numbers of frames
/// have 16 bits. Throws InputError.
ExportedPage exported_page(const std::string& folder, bool frames);

/// Writes that page as `run.html`, for export_run. Throws InputError, RunError.
void export_page(const ExportOrder& order, const std::string& folder, Exported& done);

}  // namespace repose
