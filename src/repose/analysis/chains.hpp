// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// A connected part of the network of strong contacts.
struct Chain {
  std::size_t contacts = 0;
  std::size_t grains = 0;      ///< base and other fixed grains included
  double direction_deg = 0.0;  ///< axis of the largest eigenvalue of <n n> over its contacts, in (-90, 90]
  double width = 0.0;          ///< [L] of the box around the centres of its grains
  double height = 0.0;         ///< [L]
};

struct Chains {
  std::vector<Chain> list;                     ///< most contacts first; of equals, the one with the first contact
  std::vector<std::int64_t> chain_of_contact;  ///< number in `list` for every contact; -1: not a strong one
};

/// Force chains: contacts above the mean normal force of those above `threshold` [M L/T^2], linked by the moving grains
/// that they share (fixed grains and planes, which everything stands on, do not link); forces that are not finite do
/// not count. Their extent is measured along the contacts, so that a chain across the side of a periodic box is not as
/// wide as the box.
Chains find_chains(const Grains<2>& grains, const Contacts<2>& contacts, double threshold, const Box<2>& box);

}  // namespace repose
