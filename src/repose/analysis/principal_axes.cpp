// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/principal_axes.hpp"

#include "repose/core/numbers.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace repose {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr int most_sweeps = 50;

double off_diagonal(const Matrix& a) { return squared(a[0][1]) + squared(a[0][2]) + squared(a[1][2]); }

/// Rotates axes p and q such that a[p][q] becomes 0.
void rotate(Matrix& a, Matrix& axes, std::size_t p, std::size_t q) {
  if (a[p][q] == 0.0) return;
  const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const double t = std::copysign(1.0, theta) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0);
  const double s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double kp = a[k][p];
    const double kq = a[k][q];
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double pk = a[p][k];
    const double qk = a[q][k];
    a[p][k] = c * pk - s * qk;
    a[q][k] = s * pk + c * qk;
  }
  a[p][q] = a[q][p] = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double kp = axes[k][p];
    const double kq = axes[k][q];
    axes[k][p] = c * kp - s * kq;
    axes[k][q] = s * kp + c * kq;
  }
}

Vec<3> with_sign(const Vec<3>& axis) {
  constexpr double level = 1e-12;
  for (const int k : {2, 0, 1}) {
    if (std::fabs(axis[k]) > level) return axis[k] > 0.0 ? axis : -axis;
  }
  return axis;
}

}  // namespace

PrincipalAxes principal_axes(const SymmetricTensor& t) {
  Matrix a{{{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}}};
  Matrix axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  double size = 0.0;
  for (const auto& row : a) {
    for (const double part : row) size = std::max(size, std::fabs(part));
  }
  const double rounding = squared(std::numeric_limits<double>::epsilon() * size);
  for (int sweep = 0; sweep < most_sweeps && off_diagonal(a) > 1e-6 * rounding; ++sweep) {
    rotate(a, axes, 0, 1);
    rotate(a, axes, 0, 2);
    rotate(a, axes, 1, 2);
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](auto p, auto q) { return a[p][p] > a[q][q]; });
  PrincipalAxes result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto from = order[k];
    result.value[k] = a[from][from];
    result.axis[k] = with_sign({{axes[0][from], axes[1][from], axes[2][from]}});
  }
  return result;
}

double inclination_deg(const Vec<3>& axis) {
  return std::atan2(std::fabs(axis[2]), std::hypot(axis[0], axis[1])) * degrees_per_radian;
}

}  // namespace repose
