// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace repose {

/// What a number may be.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_allowed = true;
  bool high_allowed = true;
  bool infinite_allowed = false;

  bool holds(double x) const { return (low_allowed ? x >= low : x > low) && (high_allowed ? x <= high : x < high); }
  std::string text() const;
};
inline constexpr Bounds any{};
inline constexpr Bounds positive{.low = 0.0, .low_allowed = false};
inline constexpr Bounds not_negative{.low = 0.0};
inline constexpr Bounds not_negative_or_infinite{.low = 0.0, .infinite_allowed = true};
inline constexpr Bounds at_least_one{.low = 1.0};
inline constexpr Bounds fraction{.low = 0.0, .high = 1.0, .high_allowed = false};

/// A default that is none: the key must be given.
inline constexpr double required = std::numeric_limits<double>::quiet_NaN();

/// Goes through the parameters of a law, in order: the scene's reader fills them in, its writer writes them out, a
/// description prints them. Names are those of the scene; units in M, L, T; `about` is one line for the user.
class Parameters {
 public:
  virtual ~Parameters() = default;
  virtual void number(std::string_view name, double& value, double fallback, const Bounds& bounds,
                      std::string_view unit, std::string_view about) = 0;
  virtual void flag(std::string_view name, bool& value, bool fallback, std::string_view about) = 0;

  /// One number that may be given in one of several ways.
  struct Way {
    std::string_view name;
    Bounds bounds;
    std::string_view unit;
    std::string_view about;
  };
  virtual void one_of(const std::vector<Way>& ways, std::size_t& way, double& value, double fallback) = 0;
};

}  // namespace repose
