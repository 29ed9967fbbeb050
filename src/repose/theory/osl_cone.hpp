// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose::theory {

/// The stress under a conical pile with oriented stress linearity, sigma_rr = eta sigma_zz + mu sigma_rz, and a closure
/// for the hoop stress. Stresses are in rho g h, h the height of the pile. Source: Wittmer, Cates and Claudin (1997);
/// derived in docs/theory/osl-cone.md. Validated by tests/theory/osl_cone_test.cpp.
struct OslCone {
  std::string model = "fpa";                       ///< closure: fpa | bcc | custom
  std::string hoop = "radial";                     ///< hoop stress: radial | minor | mean
  double angle_deg = 30.0;                         ///< friction angle, in [1, 80]
  std::optional<double> slope_deg = std::nullopt;  ///< slope of the surface; by default the friction angle
  std::optional<double> mu = std::nullopt;         ///< only with custom, and required there
  std::optional<double> eta = std::nullopt;  ///< only with custom; default: yield of a surface at the friction angle
  std::int64_t points = 201;                 ///< positions along a radius of the base, centre and foot included

  static constexpr ModelText text{
      .name = "osl-cone",
      .about = "Stress under a conical pile by oriented stress linearity (FPA, BCC, any closure) and a hoop stress",
      .source = "Wittmer, Cates and Claudin 1997; docs/theory/osl-cone.md"};
};

void parameters(OslCone& model, Parameters& to);
std::vector<std::string> relations(const OslCone& model);

/// A table with the columns r_over_R, normal, shear (positive outward), radial, hoop and yield_margin on the base. Its
/// numbers are the closure, the characteristic, the weight, the peak, the dip, and the errors of two integral balances.
Table evaluate(const OslCone& model);

}  // namespace repose::theory
