// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/read.hpp"
#include "repose/simulation/methods.hpp"
#include "repose/simulation/sources/initial.hpp"
#include "repose/simulation/sources/source.hpp"

#include <fmt/format.h>

#include <limits>

// Prints the grains of a scene as a table for other programs: `fixed` ones of the base, and for each grain of the
// source the step of its release. Columns: step, x, y, radius; fixed grains have the step -1.

namespace repose::bench {
namespace {

void print(long step, const Grain<2>& grain) {
  fmt::print("{} {} {} {}\n", step, grain.position[0], grain.position[1], grain.radius);
}

/// Each grain finds the room empty: the list is right for sources whose grains do not hinder each other.
int carry_out(const std::string& path) {
  const auto scene = read_scene(path, {});
  const auto steps = make_method(scene)->time_steps();
  auto grains = initial_grains(scene);
  for (const auto& grain : grains.line) print(-1, grain);
  const auto source = make_source(scene, steps, 0);
  const SourceView view{[] { return 0.0; }, {}};
  while (source->due() < std::numeric_limits<double>::infinity()) {
    const double time = source->due();
    grains = {};
    if (!source->release(grains, time, view)) throw std::runtime_error("a grain finds no room");
    for (const auto& grain : grains.line) print(steps.count(time), grain);
  }
  return 0;
}

}  // namespace
}  // namespace repose::bench

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: repose_pour_list SCENE\n");
    return 2;
  }
  try {
    return repose::bench::carry_out(argv[1]);
  } catch (const std::exception& failure) {
    fmt::print(stderr, "repose_pour_list: {}\n", failure.what());
    return 1;
  }
}
