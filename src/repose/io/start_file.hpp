// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/io/grains_file.hpp"

#include <string>
#include <vector>

namespace repose {

/// What a run can start from: the grains of a file, or the end of another run.
struct StartState {
  std::vector<GrainRow> grains;    ///< of a run by ascending id, which they keep
  Contacts<2> contacts;            ///< of a run
  std::vector<std::string> walls;  ///< names of the walls of a run, by number
  std::string scene;               ///< of a run, its text
};

/// The file that `from` means: run.h5 of a run folder, or itself.
std::string start_file(const std::string& from);

/// Reads a run.h5, or a file of grains, by the ending of its name. Throws InputError, one line for each problem.
StartState read_start(const std::string& file);

}  // namespace repose
