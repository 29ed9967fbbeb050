// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/ordered_grains.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"

#include <string>

namespace repose {

/// Writes the group `grains`. Layout: docs/reference/run-folder.md.
template <int D>
void write_grains(Hdf5File& file, const OrderedGrains<D>& grains);

/// Writes the group `contacts`.
template <int D>
void write_contacts(Hdf5File& file, const Contacts<D>& contacts);

/// XXH3-128 of the exact bits of the motion and the contacts, in their order in `grains` and `contacts` (D = 2).
std::string state_hash(const Grains<2>& grains, const Contacts<2>& contacts);

/// The grains of a file, in order of id (D = 2). Throws InputError where the group is not as write_grains makes it.
template <int D>
Grains<D> read_grains(const Hdf5Reader& file);

/// The contacts of a file, as write_contacts wrote them (D = 2).
template <int D>
Contacts<D> read_contacts(const Hdf5Reader& file);

template <>
Grains<2> read_grains(const Hdf5Reader& file);
template <>
Contacts<2> read_contacts(const Hdf5Reader& file);

}  // namespace repose
