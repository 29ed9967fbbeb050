// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed_scene.hpp"

#include <fmt/format.h>

#include <string>

// Runs the bed for a number of steps and prints the numbers that benchmarks/run.py compares with LAMMPS: kinetic
// energy, height of the centre of mass, vertical force on the fixed row, weight of the moving grains.

int main(int argc, char** argv) {
  using namespace repose;
  if (argc != 2) {
    fmt::print(stderr, "usage: repose_bed_physics STEPS\n");
    return 2;
  }
  auto bed = bench::read_bed(REPOSE_BED, 1);
  const auto method = make_kernel<2>(MaterialTable(bench::hooke_linear()), bench::settings_of(bed));
  Team team(1);
  method->grains_added(bed.grains);
  method->advance(bed.grains, method->time_steps().after(std::stol(argv[1])), team);
  double mass = 0.0;
  double height = 0.0;
  for (const auto& grain : bed.grains.line) {
    if (grain.fixed()) continue;
    mass += grain.mass;
    height += grain.mass * grain.position[1];
  }
  double force = 0.0;
  const auto fixed = [](std::int64_t id) { return id < 200; };  // ids of the row come first in the file
  for (const auto& contact : method->contacts(bed.grains).list) {
    if (fixed(contact.first)) force -= force_of(contact)[1];
    if (fixed(contact.second)) force += force_of(contact)[1];
  }
  fmt::print("{} {} {} {}\n", kinetic_energy(bed.grains), height / mass, force, mass);
  return 0;
}
