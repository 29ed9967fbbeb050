// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/problems.hpp"

#include <fmt/format.h>

namespace repose {

std::string title_problem(const std::string& title) {
  constexpr std::size_t longest = 60'000;
  if (title.size() <= longest) return "";
  return fmt::format(": has {} bytes; must have at most {}", title.size(), longest);
}

}  // namespace repose
