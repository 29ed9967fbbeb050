// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/contact_law.hpp"
#include "repose/theory/equivalent_spring.hpp"
#include "repose/theory/janssen.hpp"
#include "repose/theory/janssen_discrete.hpp"
#include "repose/theory/janssen_fit.hpp"
#include "repose/theory/mohr.hpp"
#include "repose/theory/osl.hpp"
#include "repose/theory/osl_cone.hpp"
#include "repose/theory/packing.hpp"
#include "repose/theory/pile_continuum.hpp"
#include "repose/theory/pile_lattice.hpp"
#include "repose/theory/pile_tent.hpp"
#include "repose/theory/point_load.hpp"
#include "repose/theory/point_load_3d.hpp"
#include "repose/theory/q_model.hpp"
#include "repose/theory/quasi_elastic.hpp"

#include <variant>

namespace repose::theory {

/// Every model. A new model needs its header and one entry here.
using Model = std::variant<PileLattice, PileContinuum, PileTent, Osl, OslCone, Janssen, JanssenDiscrete, JanssenFit,
                           Mohr, QuasiElastic, QModel, Packing, PointLoad, PointLoad3d, EquivalentSpring, ContactLaw>;

}  // namespace repose::theory
