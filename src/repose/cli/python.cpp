// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/python.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace repose {

namespace {

/// The Python package, seen from the folder of the program: in a build folder, then in an installation.
constexpr const char* package_folders[] = {"python", "../lib/python3/dist-packages"};

/// Runs the module named first with the package folder named second in front of all others. The folder that the user
/// happens to be in is not searched: its files could hide modules.
constexpr const char* start_module =
    "import runpy, sys\n"
    "module, package = sys.argv[1:3]\n"
    "del sys.argv[1:3]\n"
    "if sys.path[0] == '': del sys.path[0]\n"
    "sys.path.insert(0, package)\n"
    "runpy.run_module(module, run_name='__main__', alter_sys=True)\n";

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

}  // namespace

void hand_over_to_python(const std::string& module, const std::vector<std::string>& arguments) {
  const auto python = from_environment("REPOSE_PYTHON", "/usr/bin/python3");
  const auto named = from_environment("REPOSE_PYTHON_PATH", "");
  const auto package = named.empty() ? package_folder() : named;
  std::vector<std::string> words = {python, "-c", start_module, module, package};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(python.c_str(), pointers.data());
  throw RunError(
      fmt::format("{}: cannot start Python: {} (REPOSE_PYTHON names another)", python, std::strerror(errno)));
}

}  // namespace repose
