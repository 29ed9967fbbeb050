// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace repose {

/// Bad input, found before anything is written. Lists every problem, one line each. Exit status 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<std::string> problems);
  explicit InputError(const std::string& problem) : InputError(std::vector<std::string>{problem}) {}
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  std::vector<std::string> problems_;
};

/// Trouble in a run whose input was good (disk full, exploding grains). Exit status 1.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void assertion_failed(const char* what, const char* file, int line);

}  // namespace repose

/// States an assumption of the code. A failure is a bug of Repose, never bad input. On in debug builds and in CI.
#ifdef REPOSE_ASSERTS
#define REPOSE_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::repose::assertion_failed(#condition, __FILE__, __LINE__))
#else
#define REPOSE_ASSERT(condition) static_cast<void>(0)
#endif
