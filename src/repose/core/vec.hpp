// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/choose.hpp"
#include "repose/core/inline.hpp"

#include <array>
#include <type_traits>

namespace repose {

/// A vector of D numbers, or of D packs of numbers.
template <int D, class T = double>
struct Vec {
  T c[D]{};  // NOLINT: std::array has functions of its own, which need not be inlined

  REPOSE_FN constexpr T& operator[](int k) { return c[k]; }
  REPOSE_FN constexpr const T& operator[](int k) const { return c[k]; }
  REPOSE_FN constexpr Vec& operator+=(const Vec& b) {
    for (int k = 0; k < D; ++k) (*this)[k] += b[k];
    return *this;
  }
  REPOSE_FN constexpr Vec& operator-=(const Vec& b) {
    for (int k = 0; k < D; ++k) (*this)[k] -= b[k];
    return *this;
  }
  REPOSE_FN constexpr Vec& operator*=(const T& s) {
    for (int k = 0; k < D; ++k) (*this)[k] *= s;
    return *this;
  }
  friend constexpr bool operator==(const Vec&, const Vec&) = default;
};

/// Two numbers in one vector register: the pair kernel is faster than with two scalar registers (./dev bench).
template <>
struct Vec<2, double> {
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

template <int D, class T>
REPOSE_FN constexpr Vec<D, T> operator+(Vec<D, T> a, const Vec<D, T>& b) {
  return a += b;
}
template <int D, class T>
REPOSE_FN constexpr Vec<D, T> operator-(Vec<D, T> a, const Vec<D, T>& b) {
  return a -= b;
}
template <int D, class T>
REPOSE_FN constexpr Vec<D, T> operator-(Vec<D, T> a) {
  return a *= T(-1.0);
}
template <int D, class T>
REPOSE_FN constexpr Vec<D, T> operator*(Vec<D, T> a, const std::type_identity_t<T>& s) {
  return a *= s;
}
template <int D, class T>
REPOSE_FN constexpr Vec<D, T> operator*(const std::type_identity_t<T>& s, Vec<D, T> a) {
  return a *= s;
}
template <int D, class T, class Condition>
REPOSE_FN Vec<D, T> choose(const Condition& condition, const Vec<D, T>& yes, const Vec<D, T>& no) {
  Vec<D, T> chosen;
  for (int k = 0; k < D; ++k) chosen[k] = choose(condition, T(yes[k]), T(no[k]));
  return chosen;
}

template <int D, class T>
REPOSE_FN constexpr T dot(const Vec<D, T>& a, const Vec<D, T>& b) {
  T sum = a[0] * b[0];
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
template <int D, class T = double>
using Spin = std::conditional_t<D == 2, T, Vec<D, T>>;

/// A quantity in the contact's tangent plane: component along t = z x n in 2D, vector in 3D.
template <int D, class T = double>
using Tangent = std::conditional_t<D == 2, T, Vec<D, T>>;

template <int D, class T>
REPOSE_FN T magnitude(const Vec<D, T>& a) {
  return root(dot(a, a));
}

REPOSE_FN double squared(double a) { return a * a; }
template <int D, class T>
REPOSE_FN T squared(const Vec<D, T>& a) {
  return dot(a, a);
}

/// The part of a that is perpendicular to the unit normal n.
template <class T>
REPOSE_FN T tangential(const Vec<2, T>& a, const Vec<2, T>& n) {
  return a[1] * n[0] - a[0] * n[1];
}
template <class T>
REPOSE_FN Vec<3, T> tangential(const Vec<3, T>& a, const Vec<3, T>& n) {
  return a - n * dot(a, n);
}

template <class T>
REPOSE_FN constexpr Vec<3, T> cross(const Vec<3, T>& a, const Vec<3, T>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// Surface velocity per unit lever of a spinning grain: spin x n, as a tangent.
template <class T>
REPOSE_FN T spin_cross(const T& spin, const Vec<2, T>&) {
  return spin;
}
template <class T>
REPOSE_FN Vec<3, T> spin_cross(const Vec<3, T>& spin, const Vec<3, T>& n) {
  return cross(spin, n);
}

/// Torque per unit lever of a tangential force: n x force.
template <class T>
REPOSE_FN T normal_cross(const Vec<2, T>&, const T& force) {
  return force;
}
template <class T>
REPOSE_FN Vec<3, T> normal_cross(const Vec<3, T>& n, const Vec<3, T>& force) {
  return cross(n, force);
}

/// The tangent as a vector in space.
template <class T>
REPOSE_FN Vec<2, T> in_space(const T& tangent, const Vec<2, T>& n) {
  return {{-n[1] * tangent, n[0] * tangent}};
}
template <class T>
REPOSE_FN Vec<3, T> in_space(const Vec<3, T>& tangent, const Vec<3, T>&) {
  return tangent;
}

/// A tangential displacement stored for contact (i, j), converted to contact (j, i). n and t both reverse, so the
/// component in 2D keeps its sign and the vector in 3D changes sign.
REPOSE_FN double swapped(double tangent) { return tangent; }
REPOSE_FN Vec<3> swapped(const Vec<3>& tangent) { return -tangent; }

/// Rotates a stored tangent with the contact: projects it on the tangent plane of the new normal and keeps its length.
template <class T>
REPOSE_FN T turned(const T& tangent, const Vec<2, T>&) {
  return tangent;
}
template <class T>
REPOSE_FN Vec<3, T> turned(const Vec<3, T>& tangent, const Vec<3, T>& n) {
  const Vec<3, T> flat = tangential(tangent, n);
  const T before = dot(tangent, tangent);
  const T after = dot(flat, flat);
  return flat * choose(after > T(0.0), root(before / after), T(0.0));
}

}  // namespace repose
