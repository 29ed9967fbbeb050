// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/tables/file_problems.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>

namespace repose {

void FileProblems::add(std::size_t line, const std::string& what) {
  constexpr std::size_t most = 20;
  if (++count_ <= most) lines_.push_back(fmt::format("{}:{}: {}", path_, line, what));
}

void FileProblems::stop() const {
  auto lines = lines_;
  if (count_ > lines.size()) lines.push_back(fmt::format("{}: and {} more problems", path_, count_ - lines.size()));
  throw InputError(lines);
}

void FileProblems::stop_without_line(const std::string& what) const {
  throw InputError(fmt::format("{}: {}", path_, what));
}

}  // namespace repose
