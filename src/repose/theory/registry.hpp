// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/janssen.hpp"
#include "repose/theory/janssen_discrete.hpp"
#include "repose/theory/janssen_fit.hpp"
#include "repose/theory/mohr.hpp"
#include "repose/theory/packing.hpp"
#include "repose/theory/pile_continuum.hpp"
#include "repose/theory/quasi_elastic.hpp"

#include <variant>

namespace repose::theory {

/// Every model: a new one is its header and one entry here.
using Model = std::variant<PileContinuum, Janssen, JanssenDiscrete, JanssenFit, Mohr, QuasiElastic, Packing>;

}  // namespace repose::theory
