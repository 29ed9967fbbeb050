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

/// The stress in a wedge-shaped pile with oriented stress linearity, sigma_xx = eta sigma_zz + mu sign(x) sigma_xz, or
/// at incipient failure. Stresses are in rho g h, h the height of the pile; lengths in h, or along the base in its
/// length B. Source: Bratberg (2003), section 3.1.5, eqs (41)-(47); Wittmer, Cates and Claudin (1997).
/// Validated by tests/theory/osl_test.cpp and tests/theory/incipient_failure_test.cpp.
struct Osl {
  std::string model = "fpa";                       ///< closure: fpa | bcc | ife | custom
  double angle_deg = 30.0;                         ///< friction angle, in (0, 90)
  std::optional<double> slope_deg = std::nullopt;  ///< slope of the surface; by default the friction angle
  std::optional<double> mu = std::nullopt;         ///< only with custom, and required there
  std::optional<double> eta = std::nullopt;  ///< only with custom; default: yield of a surface at the friction angle
  std::string output = "base";               ///< base | field
  std::int64_t points = 201;                 ///< positions along the base, both feet included
  std::int64_t grid = 40;                    ///< depths of the field

  static constexpr ModelText text{
      .name = "osl",
      .about = "Stress in a pile by oriented stress linearity (FPA, BCC, any closure) or at incipient failure (IFE)",
      .source = "Bratberg 2003, eqs (15) and (41)-(47); Wittmer, Cates and Claudin 1997"};
};

void parameters(Osl& model, Parameters& to);
std::vector<std::string> relations(const Osl& model);

/// A table of stresses. With output = base, its columns are x_over_b, normal, shear (positive to the right), horizontal
/// and yield_margin on the base. With output = field, they are x_over_h, z_over_h, normal, shear, horizontal and
/// yield_margin at the depths z = i/grid below the apex and x = k cot(slope)/grid, |k| <= i, inside the pile and on its
/// surface. Its numbers are the closure, the kink, the weight, the dip, and where the Coulomb limit is exceeded.
Table evaluate(const Osl& model);

}  // namespace repose::theory
