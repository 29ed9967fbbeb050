// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cstddef>
#include <type_traits>

namespace repose::contact_dynamics {

// The text of a sweep is a template on T, the numbers of one contact (double) or of several side by side (a vector type
// of the compiler). No branch depends on values: a condition chooses number by number. All of it is inlined, so that no
// copy with instructions that a machine lacks is shared between sources.

/// Number by number a where the condition holds, else b.
template <class Condition, class T>
REPOSE_FN T choose(const Condition& condition, const T& a, const T& b) {
  return condition ? a : b;
}

/// The same as std::max and std::min, also if both arguments are zero.
template <class T>
REPOSE_FN T larger(const T& a, const T& b) {
  return choose(a < b, b, a);
}
template <class T>
REPOSE_FN T smaller(const T& a, const T& b) {
  return choose(b < a, b, a);
}

/// A vector in the plane for each of several contacts.
template <class T>
struct LanesVec {
  T x{}, y{};

  REPOSE_FN LanesVec& operator+=(const LanesVec& b) {
    x += b.x;
    y += b.y;
    return *this;
  }
  REPOSE_FN LanesVec& operator-=(const LanesVec& b) {
    x -= b.x;
    y -= b.y;
    return *this;
  }
  REPOSE_FN friend LanesVec operator+(const LanesVec& a, const LanesVec& b) { return {a.x + b.x, a.y + b.y}; }
  REPOSE_FN friend LanesVec operator-(const LanesVec& a, const LanesVec& b) { return {a.x - b.x, a.y - b.y}; }
  REPOSE_FN friend LanesVec operator*(const LanesVec& a, const T& s) { return {a.x * s, a.y * s}; }
};

/// The types of vectors, spins and tangents made of T.
template <int D, class T>
using VecOf = std::conditional_t<std::is_same_v<T, double>, Vec<D>, LanesVec<T>>;
template <int D, class T>
using SpinOf = std::conditional_t<D == 2, T, Vec<D>>;
template <int D, class T>
using TangentOf = SpinOf<D, T>;

/// The alignment of a struct of T that needs at least this one.
template <class T>
constexpr std::size_t at_least(std::size_t alignment) {
  return alignment < alignof(T) ? alignof(T) : alignment;
}

// The functions of core/vec.hpp.
template <class T>
REPOSE_FN T dot(const LanesVec<T>& a, const LanesVec<T>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class T>
REPOSE_FN T inner(const T& a, const T& b) {
  return a * b;
}
template <class T>
REPOSE_FN T tangential(const LanesVec<T>& a, const LanesVec<T>& n) {
  return a.y * n.x - a.x * n.y;
}
template <class T>
REPOSE_FN T spin_cross(const T& spin, const LanesVec<T>&) {
  return spin;
}
template <class T>
REPOSE_FN T normal_cross(const LanesVec<T>&, const T& force) {
  return force;
}
template <class T>
REPOSE_FN LanesVec<T> in_space(const T& tangent, const LanesVec<T>& n) {
  return {-n.y * tangent, n.x * tangent};
}

}  // namespace repose::contact_dynamics
