// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"

#include <array>
#include <cmath>
#include <type_traits>

namespace repose {

/// A vector of D numbers.
template <int D>
struct Vec {
  std::array<double, D> c{};

  REPOSE_FN constexpr double& operator[](int k) { return c[static_cast<std::size_t>(k)]; }
  REPOSE_FN constexpr double operator[](int k) const { return c[static_cast<std::size_t>(k)]; }
  REPOSE_FN constexpr Vec& operator+=(const Vec& b) {
    for (int k = 0; k < D; ++k) (*this)[k] += b[k];
    return *this;
  }
  REPOSE_FN constexpr Vec& operator-=(const Vec& b) {
    for (int k = 0; k < D; ++k) (*this)[k] -= b[k];
    return *this;
  }
  REPOSE_FN constexpr Vec& operator*=(double s) {
    for (int k = 0; k < D; ++k) (*this)[k] *= s;
    return *this;
  }
  friend constexpr bool operator==(const Vec&, const Vec&) = default;
};

/// Two numbers in one vector register: the pair kernel is faster than with two scalar registers (./dev bench).
template <>
struct Vec<2> {
  using Both = double __attribute__((vector_size(16)));
  Both c{};

  Vec() = default;
  REPOSE_FN Vec(const std::array<double, 2>& both) : c{both[0], both[1]} {}  // NOLINT: {{x, y}} as for any D
  REPOSE_FN double& operator[](int k) { return reinterpret_cast<double*>(&c)[k]; }
  REPOSE_FN double operator[](int k) const { return c[k]; }
  REPOSE_FN Vec& operator+=(const Vec& b) {
    c += b.c;
    return *this;
  }
  REPOSE_FN Vec& operator-=(const Vec& b) {
    c -= b.c;
    return *this;
  }
  REPOSE_FN Vec& operator*=(double s) {
    c *= s;
    return *this;
  }
  friend bool operator==(const Vec& a, const Vec& b) { return a[0] == b[0] && a[1] == b[1]; }
};

template <int D>
REPOSE_FN constexpr Vec<D> operator+(Vec<D> a, const Vec<D>& b) {
  return a += b;
}
template <int D>
REPOSE_FN constexpr Vec<D> operator-(Vec<D> a, const Vec<D>& b) {
  return a -= b;
}
template <int D>
REPOSE_FN constexpr Vec<D> operator-(Vec<D> a) {
  return a *= -1.0;
}
template <int D>
REPOSE_FN constexpr Vec<D> operator*(Vec<D> a, double s) {
  return a *= s;
}
template <int D>
REPOSE_FN constexpr Vec<D> operator*(double s, Vec<D> a) {
  return a *= s;
}

template <int D>
REPOSE_FN constexpr double dot(const Vec<D>& a, const Vec<D>& b) {
  double sum = a[0] * b[0];
  for (int k = 1; k < D; ++k) sum += a[k] * b[k];
  return sum;
}

/// Inner product of two spins or tangents, which are numbers in 2D.
REPOSE_FN double inner(double a, double b) { return a * b; }
template <int D>
REPOSE_FN double inner(const Vec<D>& a, const Vec<D>& b) {
  return dot(a, b);
}

/// The vertical axis: the last. Memory order runs fastest along it.
template <int D>
inline constexpr int up = D - 1;

/// An angular velocity: counter-clockwise rate in 2D, axial vector in 3D.
template <int D>
using Spin = std::conditional_t<D == 2, double, Vec<D>>;

/// A quantity in the contact's tangent plane: component along t = z x n in 2D, vector in 3D.
template <int D>
using Tangent = std::conditional_t<D == 2, double, Vec<D>>;

REPOSE_FN double magnitude(double a) { return std::fabs(a); }
template <int D>
REPOSE_FN double magnitude(const Vec<D>& a) {
  return std::sqrt(dot(a, a));
}

REPOSE_FN double squared(double a) { return a * a; }
template <int D>
REPOSE_FN double squared(const Vec<D>& a) {
  return dot(a, a);
}

/// The part of a that is perpendicular to the unit normal n.
REPOSE_FN double tangential(const Vec<2>& a, const Vec<2>& n) { return a[1] * n[0] - a[0] * n[1]; }
REPOSE_FN Vec<3> tangential(const Vec<3>& a, const Vec<3>& n) { return a - n * dot(a, n); }

REPOSE_FN constexpr Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// Surface velocity per unit lever of a spinning grain: spin x n, as a tangent.
REPOSE_FN double spin_cross(double spin, const Vec<2>&) { return spin; }
REPOSE_FN Vec<3> spin_cross(const Vec<3>& spin, const Vec<3>& n) { return cross(spin, n); }

/// Torque per unit lever of a tangential force: n x force.
REPOSE_FN double normal_cross(const Vec<2>&, double force) { return force; }
REPOSE_FN Vec<3> normal_cross(const Vec<3>& n, const Vec<3>& force) { return cross(n, force); }

/// The tangent as a vector in space.
REPOSE_FN Vec<2> in_space(double tangent, const Vec<2>& n) { return {{-n[1] * tangent, n[0] * tangent}}; }
REPOSE_FN Vec<3> in_space(const Vec<3>& tangent, const Vec<3>&) { return tangent; }

/// A tangential displacement stored for contact (i, j), converted to contact (j, i). n and t both reverse, so the
/// component in 2D keeps its sign and the vector in 3D changes sign.
REPOSE_FN double swapped(double tangent) { return tangent; }
REPOSE_FN Vec<3> swapped(const Vec<3>& tangent) { return -tangent; }

/// Rotates a stored tangent with the contact: projects it on the tangent plane of the new normal and keeps its length.
REPOSE_FN double turned(double tangent, const Vec<2>&) { return tangent; }
REPOSE_FN Vec<3> turned(const Vec<3>& tangent, const Vec<3>& n) {
  const double before = dot(tangent, tangent);
  if (before == 0.0) return tangent;
  const Vec<3> flat = tangential(tangent, n);
  const double after = dot(flat, flat);
  return after > 0.0 ? flat * std::sqrt(before / after) : Vec<3>{};
}

}  // namespace repose
