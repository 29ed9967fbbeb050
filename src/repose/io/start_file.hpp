// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/io/grains_file.hpp"

#include <string>
#include <vector>

namespace repose {

/// The state at the start of a run: the grains of a file, or the last state of another run.
template <int D>
struct StartState : GrainsFile<D> {  // grains of a run are by ascending id, and they keep their ids
  Contacts<D> contacts;              ///< of a run only
  std::vector<std::string> walls;    ///< of a run only: names of its walls, by number
  std::string scene;                 ///< of a run only: the text of its scene
};

/// The file for `from`: run.h5 if it is a run folder, otherwise itself.
std::string start_file(const std::string& from);

/// Reads a run (a name that ends in .h5) or a file of grains. Throws InputError, one line per problem; also for a run
/// of another dimension.
template <int D>
StartState<D> read_start(const std::string& file, const GrainsFileOptions& options);

}  // namespace repose
