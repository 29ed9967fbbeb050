// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Feeds the readers of tables, dumps and files of other programs with inputs from libFuzzer (./dev validate): a scene
// that starts from such a file, and a table of numbers.
#include "repose/core/errors.hpp"
#include "repose/io/start_file.hpp"
#include "repose/scene/read.hpp"
#include "repose/tables/number_table.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>

namespace {

using namespace repose;

/// A refusal is an InputError with reasons of one line each.
void attempt(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
    for (const auto& line : error.problems()) {
      if (!line.empty() && line.find('\n') == std::string::npos) continue;
      std::fprintf(stderr, "a problem that is not one line:\n%s\n", line.c_str());
      std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const char* given = std::getenv("TMPDIR");
  const std::string path = std::string(given != nullptr ? given : "/tmp") + "/fuzz-table";
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  for (const auto plane : {Plane::xy, Plane::xz}) {
    attempt([&] { read_start<2>(path, {size % 3 == 0 ? 0 : last_snapshot, plane}); });
  }
  attempt([&] { read_start<3>(path, {size % 3 == 0 ? 0 : last_snapshot, Plane::xy}); });
  attempt([&] { scene_from_text("dimension = 3\n[start]\nfrom = '" + path + "'\n[stop]\ntime = 1\n", "scene"); });
  attempt([&] { scene_from_text("[start]\nfrom = '" + path + "'\n[stop]\ntime = 1\n", "scene"); });
  attempt([&] {
    const NumberTable table(path, {"z"});
    for (std::size_t k = 0; k < table.columns(); ++k) attempt([&] { table.numbers(k); });
  });
  return 0;
}
