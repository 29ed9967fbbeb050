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
  std::size_t grains = 0;  ///< including base grains and other fixed grains
  /// Axis of the largest eigenvalue of <n n> over its contacts, from the horizontal, in (-90, 90]; in 3D above it, in
  /// [0, 90].
  double direction_deg = 0.0;
  double width = 0.0;   ///< [L] largest horizontal distance between the centres of its grains
  double height = 0.0;  ///< [L] largest vertical distance
};

struct Chains {
  std::vector<Chain> list;                     ///< most contacts first; ties in order of their first contact
  std::vector<std::int64_t> chain_of_contact;  ///< for every contact, the index in `list`; -1 if it is not strong
};

/// Force chains. The mean normal force is taken over contacts above `threshold` [M L/T^2] with a finite force. Contacts
/// above this mean are strong. Strong contacts that share a moving grain belong to one chain; fixed grains and walls
/// do not link chains, since they support everything. The extent of a chain is measured along its contacts, so a chain
/// that crosses the side of a periodic box is not as wide as the box.
/// Validated by tests/unit/chains_test.cpp and, in 3D, tests/unit/sphere_forces_test.cpp.
template <int D>
Chains find_chains(const Grains<D>& grains, const Contacts<D>& contacts, double threshold, const Box<D>& box);

}  // namespace repose
