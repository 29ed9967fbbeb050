// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"
#include "repose/io/hdf5_file.hpp"

#include <string>

namespace repose {

/// Writes the group `grains` in order of id. Layout: docs/reference/run-folder.md.
template <int D>
void write_grains(Hdf5File& file, const Grains<D>& grains);

/// Writes the group `contacts`.
template <int D>
void write_contacts(Hdf5File& file, const Contacts<D>& contacts);

}  // namespace repose
