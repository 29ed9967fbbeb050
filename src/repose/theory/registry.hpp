// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/pile_continuum.hpp"

#include <variant>

namespace repose::theory {

/// Every model: a new one is its header and one entry here.
using Model = std::variant<PileContinuum>;

}  // namespace repose::theory
