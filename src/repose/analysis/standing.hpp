// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <vector>

namespace repose {

/// One flag per grain, in memory order: whether it moves and hangs together, through contacts, with a fixed grain or a
/// wall. Grains that collide in the air do not.
template <int D>
std::vector<bool> standing(const Grains<D>& grains, const Contacts<D>& contacts);

}  // namespace repose
