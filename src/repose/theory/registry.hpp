// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/osl.hpp"
#include "repose/theory/pile_continuum.hpp"
#include "repose/theory/pile_lattice.hpp"
#include "repose/theory/pile_tent.hpp"

#include <variant>

namespace repose::theory {

/// Every model: a new one is its header and one entry here.
using Model = std::variant<PileContinuum, PileLattice, PileTent, Osl>;

}  // namespace repose::theory
