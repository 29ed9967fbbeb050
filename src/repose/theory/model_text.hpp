// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <string_view>

namespace repose::theory {

/// How a model is listed.
struct ModelText {
  std::string_view name;    ///< as on the command line
  std::string_view about;   ///< one line
  std::string_view source;  ///< paper and equations
};

}  // namespace repose::theory
