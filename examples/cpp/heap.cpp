// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Pours a heap of discs on a row of fixed ones and prints its angle of repose as it grows.
#include <repose/api/repose.hpp>

#include <cstdio>

using namespace repose::api;

int main() {
  try {
    const auto scene = SceneDraft()
                           .set("method.kind", "soft")
                           .set("contact.friction", 0.5)
                           .set("base.kind", "row")
                           .set("base.half_width", 20.0)
                           .set("source.kind", "pour")
                           .set("source.count", 100)
                           .set("source.rate", 2.0)
                           .set("source.height", 15.0)
                           .set("source.half_width", 1.0)
                           .set("stop.time", 70.0)
                           .checked();
    Simulation simulation(scene);
    simulation.observe_every(10.0, [](const Simulation& now) {
      std::printf("time %5.1f: %3zu grains, %3zu contacts\n", now.time(), now.grains().size(), now.contacts().size());
    });
    simulation.run();
    std::printf("angle of repose %.1f degrees\n", value_of(simulation.measures(), "angle_of_repose_deg.mean"));
  } catch (const repose::InputError& error) {
    for (const auto& problem : error.problems()) std::fprintf(stderr, "%s\n", problem.c_str());
    return 2;
  }
}
