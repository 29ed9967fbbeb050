// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Feeds the readers of scenes and sweeps with inputs from libFuzzer (./dev validate). The input is the text of a scene.
// Lines after a line "#set" are settings like those of --set; the text after a line "#sweep" is a sweep file. Half of
// the mutations replace a value by an odd one, because mutations of bytes alone hardly ever make one.
#include "repose/core/errors.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/write.hpp"
#include "repose/sweep/plan.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace repose;

[[noreturn]] void complain(const char* what, const std::string& text) {
  std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
  std::abort();
}

/// Every problem must be one line that names its place: a file or folder, an absolute path, or a setting.
void check_problems(const InputError& error, const std::string& name) {
  if (error.problems().empty()) complain("a refusal without a reason", "");
  for (const auto& line : error.problems()) {
    const bool placed = line.starts_with(name) || line.starts_with("/") || line.starts_with("--set");
    if (!placed || line.find('\n') != std::string::npos) complain("a problem that is not one line with a place", line);
  }
}

/// An accepted scene can be written and read again, and is then the same.
void check_scene(const std::string& text, const Overrides& overrides) {
  std::string written;
  try {
    written = scene_text(scene_from_text(text, "fuzz", overrides));
  } catch (const InputError& error) {
    check_problems(error, "fuzz");
    return;
  }
  try {
    const auto again = scene_text(scene_from_text(written, "fuzz"));
    if (again != written) complain("a scene changes when it is written and read", written + "\n-----\n" + again);
  } catch (const InputError& error) {
    complain(error.what(), written);
  }
}

void check_sweep(const std::string& text) {
  const char* given = std::getenv("TMPDIR");
  const std::string folder = given != nullptr ? given : "/tmp";
  const std::string path = folder + "/fuzz-sweep.toml";
  std::ofstream(path, std::ios::binary) << text;
  try {
    read_sweep(path);
  } catch (const InputError& error) {
    check_problems(error, folder);
  }
}

constexpr std::array odd_values = {"0",
                                   "-1",
                                   "-0.0",
                                   "1e-3",
                                   "5e-324",
                                   "1e-320",
                                   "1e-200",
                                   "1e200",
                                   "1e306",
                                   "1e308",
                                   "-1e308",
                                   "inf",
                                   "-inf",
                                   "nan",
                                   "1000001",
                                   "4000",
                                   "1e6",
                                   "true",
                                   "false",
                                   "9007199254740993",
                                   "9223372036854775807",
                                   "\"\"",
                                   "\"none\"",
                                   "\"auto\"",
                                   "\"row\"",
                                   "\"lattice\"",
                                   "\"hooke\"",
                                   "\"linear\"",
                                   "[]",
                                   "{}",
                                   "[0.01]",
                                   "[1, 2]",
                                   "{ a = 1 }",
                                   "2026-01-01",
                                   "-9223372036854775808"};

/// The text with another value after one of its equals signs.
std::string with_odd_value(const std::string& text, std::minstd_rand& random) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '=') places.push_back(k + 1);
  }
  if (places.empty()) return text;
  const auto begin = places[random() % places.size()];
  const auto value = text.find_first_not_of(' ', begin);
  // The value ends with a word, a number or a short text. In a list or table only the first part is replaced, so that
  // broken ones occur too.
  const auto end = std::min(text.find_first_of(" ,}]\n", value), text.size());
  return text.substr(0, begin) + " " + odd_values[random() % odd_values.size()] + text.substr(end);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  std::minstd_rand random(seed);
  if (random() % 2 == 0) return LLVMFuzzerMutate(data, size, most);
  const auto text = with_odd_value(std::string(reinterpret_cast<const char*>(data), size), random);
  if (text.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}

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
