// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The kinds that come with the library: a new one is its header and one entry here.
#include "repose/scene/bases/bare.hpp"
#include "repose/scene/bases/bed.hpp"
#include "repose/scene/bases/counted.hpp"
#include "repose/scene/bases/deposited.hpp"
#include "repose/scene/bases/deposited_bed.hpp"
#include "repose/scene/bases/row.hpp"
#include "repose/scene/methods/contact_dynamics.hpp"
#include "repose/scene/methods/deposition.hpp"
#include "repose/scene/methods/hybrid.hpp"
#include "repose/scene/methods/soft.hpp"
#include "repose/scene/sources/at_start.hpp"
#include "repose/scene/sources/crystal.hpp"
#include "repose/scene/sources/drop.hpp"
#include "repose/scene/sources/lattice.hpp"
#include "repose/scene/sources/sequential.hpp"

namespace repose {

Kinds<MethodKind>& method_kinds() {
  static Kinds<MethodKind> kinds{{SoftMethod{}, ContactDynamicsMethod{}, DepositionMethod{}, HybridMethod{}}};
  return kinds;
}

Kinds<SourceKind>& source_kinds() {
  static Kinds<SourceKind> kinds{{PourSource{}, RainSource{}, SequentialSource{}, LatticeSource{}, CrystalSource{},
                                  NoSource{}, DepositedDiscs{}, DepositedSpheres{}}};
  return kinds;
}

Kinds<BaseKind>& base_kinds() {
  static Kinds<BaseKind> kinds{{RowBase{}, DepositedBase{}, ContiguousBase{}, BedBase{}, DepositedBed{}, PlaneBase{},
                                NoBase{}, FlatBase{}, FloorBase{}, DisorderedBase{}}};
  return kinds;
}

}  // namespace repose
