// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/ordered_grains.hpp"
#include "repose/io/columns.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"

#include <cstdint>
#include <string>

namespace repose {

/// A grain as files have it.
template <int D>
struct GrainState {
  std::int64_t id = 0;
  Vec<D> position{};
  Vec<D> velocity{};
  Spin<D> spin{};
  double radius = 0.0;
  double mass = 0.0;
  bool fixed = false;
  bool base = false;
  std::uint16_t material = 0;
};

/// The datasets of the groups `grains` and `contacts`.
template <int D>
const Columns<std::vector<GrainState<D>>>& grain_state_columns();
template <int D>
const Columns<std::vector<Contact<D>>>& contact_columns();

template <int D>
void write_grains(Hdf5File& file, const OrderedGrains<D>& grains);
/// Without `forces` the columns of forces and what belongs to them are left out. `grains` holds the partners.
template <int D>
void write_contacts(Hdf5File& file, const ContactBlocks<D>& contacts, const OrderedGrains<D>& grains, bool forces);

/// The grains of a file in its order. Throws InputError where the group is not as write_grains makes it.
template <int D>
Grains<D> read_grains(const Hdf5Reader& file);
template <int D>
Contacts<D> read_contacts(const Hdf5Reader& file);

/// 2 or 3: the dimension of the grains of a file. Throws InputError where it has none.
std::int64_t dimension_of_state(const Hdf5Reader& file);

/// XXH3-128 of the exact bits of the motion and the contacts, in their order in `grains` and `contacts`.
template <int D>
std::string state_hash(const Grains<D>& grains, const ContactBlocks<D>& contacts);

}  // namespace repose
