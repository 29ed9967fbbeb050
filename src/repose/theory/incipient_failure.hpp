// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/wedge_stress.hpp"

#include <boost/math/interpolators/cubic_hermite.hpp>

#include <array>
#include <vector>

namespace repose::theory {

/// A wedge at the friction angle phi that is at the Coulomb limit everywhere: sigma_zz = z P (1 + s cos 2psi),
/// sigma_xx = z P (1 - s cos 2psi), sigma_xz = z P s sin 2psi, s = sin(phi), with psi = 0 on the axis and P = 0 on the
/// surface.
///
/// P and psi are functions of d = 1 - S alone. The surface is a characteristic, so the equations of equilibrium for P
/// and psi are singular there. Written for pi = P/d and u = psi - psi_surface they are regular (incipient_failure.cpp).
/// P on the axis is chosen so that pi is 1 on the surface. Then P/d and u/d are smooth there, to third order in d.
///
/// Source: Bratberg (2003), section 3.1.5, eq. (15) with equality. The relative accuracy is better than 1e-9 for
/// friction angles from 1 to 80 degrees. Validated by tests/theory/incipient_failure_test.cpp.
class IncipientFailure {
 public:
  explicit IncipientFailure(double friction_angle);  ///< rad, in (0, pi/2)

  WedgeStress stress_on(const Ray& ray) const;
  double peak_normal() const;  ///< largest sigma_zz at a depth z, divided by rho g z

 private:
  /// The solution on rays from the axis outward, and its expansion about the surface.
  struct Profile {
    std::vector<double> s, pi, pi_slope, u, u_slope;  ///< values at these S; slopes are derivatives with respect to S
    std::array<double, 3> pi_series;                  ///< pi = 1 + d (p0 + p1 d + p2 d^2)
    std::array<double, 3> u_series;                   ///< u = d (w0 + w1 d + w2 d^2)
  };
  static Profile solve(double friction_angle);
  IncipientFailure(double friction_angle, Profile profile);

  using Interpolant = boost::math::interpolators::cubic_hermite<std::vector<double>>;
  double sin_friction_;
  double psi_surface_;
  std::array<double, 3> pi_series_, u_series_;
  std::vector<double> s_;
  Interpolant pi_, u_;
};

inline WedgeStress stress_on(const IncipientFailure& wedge, const Ray& ray) { return wedge.stress_on(ray); }

}  // namespace repose::theory
