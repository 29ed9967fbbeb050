// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/principal_axes.hpp"
#include "repose/core/contacts.hpp"

#include <cstddef>
#include <optional>

namespace repose {

/// The fabric tensor <n n> of contact normals in space; its trace is 1, and each eigenvalue is 1/3 if it is isotropic.
struct SpaceFabric {
  std::size_t contacts = 0;
  SymmetricTensor tensor;
  PrincipalAxes principal;
  /// In [0, 1]: 0 isotropic, 1 all parallel. Where the density of directions is (1 + n.a.n)/(4 pi) with a traceless,
  /// the deviator of a is 15/2 of this one.
  double deviator = 0.0;
  double inclination_deg = 0.0;  ///< of the major axis above the horizontal, in [0, 90]
};

/// The fabric of all contacts that count, and of the two parts that the mean normal force divides them into.
struct ContactFabric {
  double mean_force = 0.0;  ///< [M L/T^2]
  SpaceFabric all;
  std::optional<SpaceFabric> strong;  ///< above the mean force
  std::optional<SpaceFabric> weak;    ///< at most the mean force
};

/// Measures the fabric over contacts with a finite normal force above `threshold` [M L/T^2]; those with walls count
/// only if asked for, since their normals are imposed. None without such a contact. Strong and weak parts after Radjai
/// et al., Phys. Rev. Lett. 80, 61 (1998); the deviator as in Imole et al., KONA 30, 84 (2013). Validated by
/// tests/unit/contact_fabric_test.cpp.
std::optional<ContactFabric> measure_contact_fabric(const Contacts<3>& contacts, double threshold,
                                                    bool with_walls = false);

}  // namespace repose
