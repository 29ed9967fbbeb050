// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/python.hpp"

#include "repose/cli/say.hpp"
#include "repose/core/errors.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace repose {

namespace {

/// The Python package, seen from the folder of the program: in a build folder, then in an installation.
constexpr const char* package_folders[] = {"python", "../lib/python3/dist-packages"};

/// The file of the package that runs its modules.
constexpr const char* start_file = "/repose/start.py";

std::string from_environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : otherwise;
}

std::string package_folder() {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto here = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* folder : package_folders) {
    const auto found = fs::canonical(here / folder, error);
    if (!error && fs::exists(found / "repose", error)) return found.string();
  }
  throw RunError(
      fmt::format("{}: the Python package is neither in {} nor in {} beside it (REPOSE_PYTHON_PATH names it)",
                  here.string(), package_folders[0], package_folders[1]));
}

/// PYTHONPATH without the entries that stand for the folder that the user happens to be in: an empty one is often left
/// by a variable that is not set.
std::string python_path() {
  std::string kept;
  std::istringstream entries(from_environment("PYTHONPATH", ""));
  for (std::string entry; std::getline(entries, entry, ':');) {
    if (entry.empty() || entry == "." || entry == "./") continue;
    kept += (kept.empty() ? "" : ":") + entry;
  }
  return kept;
}

/// Python imports nothing from the present folder, whose files could hide its modules, and Matplotlib opens no window.
void set_environment() {
  ::setenv("PYTHONSAFEPATH", "1", 1);
  ::setenv("MPLBACKEND", "agg", 1);
  if (const auto path = python_path(); !path.empty()) {
    ::setenv("PYTHONPATH", path.c_str(), 1);
  } else {
    ::unsetenv("PYTHONPATH");
  }
}

}  // namespace

void hand_over_to_python(const std::string& module, const std::vector<std::string>& arguments) {
  const auto python = from_environment("REPOSE_PYTHON", "/usr/bin/python3");
  const auto named = from_environment("REPOSE_PYTHON_PATH", "");
  const auto package = named.empty() ? package_folder() : named;
  std::vector<std::string> words = {python, package + start_file, module, package};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  if (const int status = status_after_output(0); status != 0) std::exit(status);
  set_environment();
  ::execv(python.c_str(), pointers.data());
  throw RunError(
      fmt::format("{}: cannot start Python: {} (REPOSE_PYTHON names another)", python, std::strerror(errno)));
}

}  // namespace repose
