// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed.hpp"
#include "measured.hpp"
#include "repose/methods/contact_dynamics/contact_dynamics.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

// Visits of contacts by whole steps of contact dynamics in copies of a settled bed side by side: search, sweeps and
// motion. Prints one line of JSON; the driver of ./dev bench runs it once for each measurement.

namespace repose::bench {
namespace {

std::unique_ptr<Method<2>> method_of(const Box<2>& box) {
  ContactDynamicsSettings<2> settings;
  settings.time_step = 0.05;
  settings.gravity = {{0.0, -1.0}};
  settings.box = box;
  settings.solver.tolerance = 1e-3;
  settings.solver.most_sweeps = 100;
  ImpulseLaw law;
  law.friction = 0.5;
  return make_contact_dynamics<2>(ImpulseLaws(law), settings);
}

int carry_out(const std::string& path, int copies, int threads, double seconds) {
  auto bed = read_bed<2>(path, copies);
  auto& grains = bed.grains;
  const auto method = method_of(bed.box);
  Team team(threads);
  method->grains_added(grains);
  const auto step = [&] {
    const auto until = method->time_steps().later(method->time(), method->time_steps().after(1));
    if (method->advance(grains, until, team).trouble) throw std::runtime_error("the bed has exploded");
    return static_cast<double>(method->take_solver_account().contact_iterations);
  };
  for (int k = 0; k < 3; ++k) step();  // the overlaps of soft grains begin to go
  const auto cost = measure(seconds, step);
  const auto contacts = method->contacts(grains).list.size();
  print_cost(cost, fmt::format(R"("contacts": {})", contacts));
  return 0;
}

}  // namespace
}  // namespace repose::bench

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: repose_rigid_bench BED COPIES THREADS SECONDS\n");
    return 2;
  }
  try {
    return repose::bench::carry_out(argv[1], std::stoi(argv[2]), std::stoi(argv[3]), std::stod(argv[4]));
  } catch (const std::exception& failure) {
    fmt::print(stderr, "repose_rigid_bench: {}\n", failure.what());
    return 1;
  }
}
