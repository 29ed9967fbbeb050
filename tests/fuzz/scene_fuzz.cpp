// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Feeds the readers of scenes and sweeps with whatever libFuzzer thinks of (./dev validate). The input is the text of a
// scene; lines after a line "#set" are settings as of --set; what follows "#sweep" instead is a sweep file.
#include "repose/core/errors.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/sweep_plan.hpp"
#include "repose/scene/write.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace {

using namespace repose;

[[noreturn]] void complain(const char* what, const std::string& text) {
  std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
  std::abort();
}

/// Every problem is one line that says where.
void check_problems(const InputError& error) {
  if (error.problems().empty()) complain("a refusal without a reason", "");
  for (const auto& line : error.problems()) {
    const bool placed = line.starts_with("fuzz") || line.starts_with("--set") || line.starts_with("/");
    if (!placed || line.find('\n') != std::string::npos) complain("a problem that is not one line with a place", line);
  }
}

/// What is accepted can be written, read again and is then the same.
void check_scene(const std::string& text, const Overrides& overrides) {
  std::string written;
  try {
    written = scene_text(read_scene_text(text, "fuzz", overrides));
  } catch (const InputError& error) {
    check_problems(error);
    return;
  }
  try {
    const auto again = scene_text(read_scene_text(written, "fuzz"));
    if (again != written) complain("a scene changes when it is written and read", written + "\n-----\n" + again);
  } catch (const InputError& error) {
    complain(error.what(), written);
  }
}

void check_sweep(const std::string& text) {
  const char* folder = std::getenv("TMPDIR");
  const std::string path = std::string(folder != nullptr ? folder : "/tmp") + "/fuzz-sweep.toml";
  std::ofstream(path, std::ios::binary) << text;
  try {
    read_sweep(path);
  } catch (const InputError& error) {
    check_problems(error);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(data), size);
  if (const auto sweep = input.find("#sweep\n"); sweep != std::string::npos) {
    check_sweep(input.substr(sweep));
    return 0;
  }
  const auto settings = input.find("#set\n");
  Overrides overrides;
  if (settings != std::string::npos) {
    std::istringstream lines(input.substr(settings + 5));
    for (std::string line; std::getline(lines, line);) overrides.set.push_back(line);
  }
  check_scene(input.substr(0, settings), overrides);
  return 0;
}
