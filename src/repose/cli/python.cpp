// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/python.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace repose {

namespace {

std::string from_environment(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : otherwise;
}

}  // namespace

void hand_over_to_python(const std::string& module, const std::vector<std::string>& arguments) {
  const auto python = from_environment("REPOSE_PYTHON", "/usr/bin/python3");
  const auto package = from_environment("REPOSE_PYTHON_PATH", REPOSE_PYTHON_PATH);
  const auto old_path = from_environment("PYTHONPATH", "");
  ::setenv("PYTHONPATH", (old_path.empty() ? package : package + ":" + old_path).c_str(), 1);
  std::vector<std::string> words = {python, "-m", module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(python.c_str(), pointers.data());
  throw RunError(
      fmt::format("{}: cannot start Python: {} (REPOSE_PYTHON names another)", python, std::strerror(errno)));
}

}  // namespace repose
