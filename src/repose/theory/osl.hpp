// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace repose::theory {

/// Stress in a wedge-shaped pile under oriented stress linearity, sigma_xx = eta sigma_zz + mu sign(x) sigma_xz, and
/// at incipient failure. Unit of stress: rho g h, h the height of the pile; lengths in h, or along the base in B.
/// Source: Bratberg (2003), section 3.1.5, eqs (41)-(47); Wittmer, Cates and Claudin (1997).
/// Validated by tests/theory/osl_test.cpp and incipient_failure_test.cpp.
struct Osl {
  std::string model = "fpa";                       ///< closure: fpa | bcc | ife | custom
  double angle_deg = 30.0;                         ///< of friction, in (0, 90)
  std::optional<double> slope_deg = std::nullopt;  ///< of the surface, if not the friction angle
  std::optional<double> mu = std::nullopt;         ///< custom only, and required there
  std::optional<double> eta = std::nullopt;        ///< custom only; else from yield of a surface at the friction angle
  std::string output = "base";                     ///< base | field
  std::int64_t points = 201;                       ///< along the base, both feet included
  std::int64_t grid = 40;                          ///< depths of the field

  static constexpr ModelText text{
      .name = "osl",
      .about = "Stress in a pile by oriented stress linearity (FPA, BCC, any closure) or at incipient failure (IFE)",
      .source = "Bratberg 2003, eqs (15) and (41)-(47); Wittmer, Cates and Claudin 1997"};
};

void parameters(Osl& model, Parameters& to);
std::vector<std::string> relations(const Osl& model);

/// output = base: columns x_over_b, normal, shear, horizontal, yield_margin on the base; shear is positive to the
/// right. output = field: columns x_over_h, z_over_h, normal, shear, horizontal, yield_margin at depths z = i/grid
/// below the apex and x = k cot(slope)/grid, |k| <= i: every ray of it meets the surface or lies inside. Numbers:
/// closure, kink, weight, dip and where the Coulomb limit is exceeded.
Table evaluate(const Osl& model);

}  // namespace repose::theory
