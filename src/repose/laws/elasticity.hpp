// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// The elastic constants of an isotropic material.
struct Elasticity {
  double young_modulus = 1.0;  ///< E [M/(L T^2)] > 0
  double poisson_ratio = 0.0;  ///< nu, > -1 and <= 1/2
};

/// The effective modulus E* [M/(L T^2)] of two bodies in contact: 1/E* is the sum of (1 - nu^2)/E.
/// Source: Johnson, Contact Mechanics (1985), eq. (4.20). Validated by tests/unit/elasticity_test.cpp.
inline double effective_modulus(const Elasticity& a, const Elasticity& b) {
  const auto compliance = [](const Elasticity& one) {
    return (1.0 - one.poisson_ratio * one.poisson_ratio) / one.young_modulus;
  };
  return 1.0 / (compliance(a) + compliance(b));
}

/// The effective shear modulus G* [M/(L T^2)] against sliding: 1/G* is the sum of (2 - nu)/G with G = E/(2 (1 + nu)).
/// Source: Johnson (1985), eq. (7.43). Validated by tests/unit/elasticity_test.cpp.
inline double effective_shear_modulus(const Elasticity& a, const Elasticity& b) {
  const auto compliance = [](const Elasticity& one) {
    return 2.0 * (2.0 - one.poisson_ratio) * (1.0 + one.poisson_ratio) / one.young_modulus;
  };
  return 1.0 / (compliance(a) + compliance(b));
}

/// Tangential over normal stiffness of a contact of radius a, 8 G* a over 2 E* a; 2 (1 - nu)/(2 - nu) for two bodies of
/// one material.
inline double stiffness_ratio(const Elasticity& a, const Elasticity& b) {
  return 4.0 * effective_shear_modulus(a, b) / effective_modulus(a, b);
}

}  // namespace repose
