// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/linear_wedge.hpp"
#include "repose/theory/wedge_stress.hpp"

#include <boost/math/interpolators/cubic_hermite.hpp>

#include <vector>

namespace repose::theory {

/// The hoop stress of a cone: the radial stress, or the minor principal stress or the mean of both principal stresses
/// in a vertical plane through the axis.
enum class Hoop { radial, minor, mean };

/// The two equations that close equilibrium in a cone: sigma_rr = eta sigma_zz + mu sigma_rz, and the hoop stress.
struct ConeClosure {
  LinearClosure radial;
  Hoop hoop = Hoop::radial;
};

/// sigma_rr - sigma_phiphi, homogeneous of degree 1 in both stresses.
double hoop_difference(const ConeClosure& closure, double normal, double shear);

/// Whether sigma_phiphi = sigma_rr on the axis, where the shear vanishes. Without this no solution has a finite and
/// positive stress on the axis.
bool is_regular_on_axis(const ConeClosure& closure);

/// The stress in a cone with a stress-free surface. All stresses are z times a function of S = r tan(slope)/z.
///
/// Equilibrium is singular on the axis and on the characteristic S = s_inner. The outer solution starts on the surface.
/// The inner ones start on the axis with a pressure there, which is chosen so that both meet on the characteristic.
///
/// Source: Wittmer, Cates and Claudin (1997); derived in docs/theory/osl-cone.md. The error is below 1e-8 for friction
/// angles from 1 to 80 degrees. Validated by tests/theory/osl_cone_test.cpp.
class ConeStress {
 public:
  /// Requires eta > 0, kink_margin > 0 and is_regular_on_axis. Throws InputError if there is no solution.
  ConeStress(const ConeClosure& closure, double tan_slope);

  /// The stress over rho g z on a ray; `horizontal` is sigma_rr.
  WedgeStress stress_on(const Ray& ray) const;
  double hoop_on(const Ray& ray) const;
  /// The yield margin; on the surface, where the stress vanishes, its limit there. The hoop stress lies between the
  /// principal stresses of a vertical plane through the axis, so it does not enter.
  double margin_on(const Ray& ray, double sin_friction) const;

  /// The largest normal stress at a depth, and its S.
  struct Peak {
    double normal = 0.0;
    double s = 0.0;
  };
  Peak peak() const;

  double smallest_margin(double sin_friction) const;
  double normal_force() const;  ///< integral of sigma_zz S over S in [0, 1]; 1/6 if the base carries the weight
  /// Horizontal balance of half a cone: tan(slope) times the integral of sigma_phiphi, over 3 times that of sigma_rz S.
  double half_cone_ratio() const;
  double shear_jump() const { return shear_jump_; }  ///< jump of sigma_rz on the characteristic, an error of the solver

  const LinearWedge& wedge() const { return wedge_; }  ///< characteristics of the same closure, as in a wedge

 private:
  struct Profile {
    std::vector<double> s, normal, normal_slope, shear, shear_slope;  ///< ascending S
  };
  struct Solution {
    Profile inner, outer;
  };
  static Solution solve(const ConeClosure& closure, double tan_slope, const LinearWedge& wedge);
  ConeStress(const ConeClosure& closure, double tan_slope, const LinearWedge& wedge, Solution solution);

  template <class F>
  double integral(const F& f) const;

  using Interpolant = boost::math::interpolators::cubic_hermite<std::vector<double>>;
  struct Curves {
    explicit Curves(Profile profile);
    Interpolant normal, shear;
  };

  ConeClosure closure_;
  double tan_slope_;
  LinearWedge wedge_;
  std::vector<double> s_;     ///< all S of the solution, ascending
  WedgeStress near_surface_;  ///< stress over 1 - S on the surface
  double shear_jump_;
  Curves inner_, outer_;
};

}  // namespace repose::theory
