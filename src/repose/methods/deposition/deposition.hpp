// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/deposition/settings.hpp"
#include "repose/methods/method.hpp"

#include <memory>

namespace repose {

/// The method `deposition`, which is geometry alone. One step deposits one disc by the critical-angle rule (roller.hpp)
/// onto the discs deposited before; time counts discs. It is sequential and uses one thread. Contacts are those at
/// which each disc came to rest, without forces. Source: Bratberg (2003), paper one, section II A.
std::unique_ptr<Method<2>> make_deposition(const DepositionSettings& settings);

/// The same method with a search over every disc: slow, the reference for tests.
std::unique_ptr<Method<2>> make_deposition_by_brute_force(const DepositionSettings& settings);

}  // namespace repose
