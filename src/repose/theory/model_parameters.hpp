// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace repose::theory {

/// What a whole number may be.
struct WholeBounds {
  std::int64_t low = 0;
  std::int64_t high = std::numeric_limits<std::int64_t>::max();
  std::string text() const;
};

/// Goes through the parameters of a model, in order: settings are read into them, `--list` and tables print them. The
/// value that a parameter has before is its default; not-a-number (or an empty text): it must be given. Names are those
/// of the command line and of Python; `about` is one line for the user.
class ModelParameters {
 public:
  virtual ~ModelParameters() = default;
  virtual void number(std::string_view name, double& value, const Bounds& bounds, std::string_view unit,
                      std::string_view about) = 0;
  /// A number that need not be given; `otherwise` says what holds without it.
  virtual void optional_number(std::string_view name, std::optional<double>& value, std::string_view otherwise,
                               const Bounds& bounds, std::string_view unit, std::string_view about) = 0;
  virtual void integer(std::string_view name, std::int64_t& value, const WholeBounds& bounds,
                       std::string_view about) = 0;
  virtual void choice(std::string_view name, std::string& value, const std::vector<std::string>& words,
                      std::string_view about) = 0;
  virtual void text(std::string_view name, std::string& value, std::string_view about) = 0;
};

/// How a model is listed.
struct ModelText {
  std::string_view name;    ///< as on the command line
  std::string_view about;   ///< one line
  std::string_view source;  ///< paper and equations
};

}  // namespace repose::theory
