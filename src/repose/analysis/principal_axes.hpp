// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <array>
#include <cmath>

namespace repose {

/// A symmetric tensor in three dimensions.
struct SymmetricTensor {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double xy = 0.0;
  double xz = 0.0;
  double yz = 0.0;

  double trace() const { return xx + yy + zz; }
  /// Adds a a.
  void add_square(const Vec<3>& a) {
    xx += a[0] * a[0];
    yy += a[1] * a[1];
    zz += a[2] * a[2];
    xy += a[0] * a[1];
    xz += a[0] * a[2];
    yz += a[1] * a[2];
  }
  SymmetricTensor& operator*=(double scale) {
    for (double* part : {&xx, &yy, &zz, &xy, &xz, &yz}) *part *= scale;
    return *this;
  }
};

/// The deviator sqrt(3/2 t':t') with t' the traceless part: l1 - l3 for an axisymmetric tensor, and in general
/// sqrt{[(l1 - l2)^2 + (l2 - l3)^2 + (l3 - l1)^2]/2}. It is a linear measure, like the second invariant of the stress.
inline double deviator(const SymmetricTensor& t) {
  const double mean = t.trace() / 3.0;
  return std::sqrt(1.5 * (squared(t.xx - mean) + squared(t.yy - mean) + squared(t.zz - mean) +
                          2.0 * (squared(t.xy) + squared(t.xz) + squared(t.yz))));
}

/// Eigenvalues in descending order with their unit axes. An axis has no sign: it points upwards; a level one to
/// positive x, or to positive y along y.
struct PrincipalAxes {
  std::array<double, 3> value{};
  std::array<Vec<3>, 3> axis{};
};

/// By Jacobi rotations, to a few roundings of the largest eigenvalue. Axes of equal eigenvalues are any orthogonal
/// ones. Validated by tests/unit/contact_fabric_test.cpp.
PrincipalAxes principal_axes(const SymmetricTensor& tensor);

/// The angle of an axis above the horizontal [deg], in [0, 90].
double inclination_deg(const Vec<3>& axis);

}  // namespace repose
